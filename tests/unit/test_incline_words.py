"""What is said of a rope that lies on a slope, by how steep it is against the angle of friction."""

from __future__ import annotations

import math
from dataclasses import replace

import numpy as np
import pytest

import ropewalk as rw
from ropewalk.statics import NoRest, static_shape
from ropewalk.statics.wraps import sliding_words

FRICTION = 0.3  # holds up to 16.7 degrees


def on_a_slope(kind: str, degrees: float) -> rw.Scene:
    """A rope of 1 m along the slope of a body whose surface begins at the origin."""
    angle = math.radians(degrees)
    up = np.array([math.sin(angle), 0.0, math.cos(angle)])
    down = np.array([math.cos(angle), 0.0, -math.sin(angle)])
    side = np.array([0.0, 1.0, 0.0])
    body: dict[str, object] = {"kind": kind, "friction": FRICTION}
    if kind == "plane":
        body |= {"normal": tuple(up)}
    elif kind == "half-pipe":
        axis = [tuple(0.5 * up + end * down) for end in (-20.0, 20.0)]
        body |= {"from": axis[0], "to": axis[1], "radius": 0.5, "open_to": tuple(up)}
    else:
        square = ((-20, -5), (20, -5), (20, 5), (-20, 5))
        body["vertices"] = [tuple(x * down + y * side + z * up) for z in (-1, 0) for x, y in square]
        sides = [
            (0, 1, 5),
            (0, 5, 4),
            (1, 2, 6),
            (1, 6, 5),
            (2, 3, 7),
            (2, 7, 6),
            (3, 0, 4),
            (3, 4, 7),
        ]
        body["faces"] = [(0, 2, 1), (0, 3, 2), (4, 5, 6), (4, 6, 7), *sides]
    ends = [tuple(0.005 * up + end * down) for end in (-0.5, 0.5)]
    rope = rw.Rope(
        segments=20, length=1.0, diameter=0.01,
        made_of=rw.Material(EA=1e4, mass_per_length=0.1, axial_damping=5.0),
        shape={"kind": "straight", "start": ends[0], "end": ends[1]},
    )  # fmt: skip
    return rw.Scene(ropes=[rope], obstacles=[body])


@pytest.mark.parametrize("kind", ["plane", "half-pipe", "mesh"])
def test_how_much_of_friction_is_taken_is_of_all_contacts(kind: str) -> None:
    """It read "take up to 100 %" at 10 degrees of 16.7, of the two ends, which give a little."""
    (wrap,) = static_shape(on_a_slope(kind, 10.0)).wraps
    share = math.tan(math.radians(10.0)) / FRICTION
    assert wrap.taken == pytest.approx(share, rel=1e-6)
    assert f"its contacts take {100 * share:.3g} % of what friction can carry together" in str(wrap)


@pytest.mark.parametrize(
    ("kind", "said"),
    [("plane", "on and on"), ("half-pipe", "still slide"), ("mesh", "still slide")],
)
def test_what_slides_is_said_to_slide(kind: str, said: str) -> None:
    """Steps on bodies were too short to tell: "no shape of rest in 1802 steps: 0.000245 N are left"."""
    with pytest.raises(NoRest, match=rf"{said}.*friction carries all it can.*16.7 degrees"):
        static_shape(on_a_slope(kind, 17.0))


def test_friction_that_carries_nothing_is_not_told() -> None:
    """`check crane-snap` said that a node's contacts take up to 0 % of what friction can carry."""
    (wrap,) = [
        one for one in rw.check("crane-snap", measure=False).statics.wraps if one.first == 20
    ]
    assert wrap.friction > 0.0
    assert wrap.words == "node 20 lies on 'ground'"


def test_no_slope_is_told_of_what_is_level_or_without_friction() -> None:
    """Of a level floor it was "on slopes of up to 16.7 degrees", of smooth drums "of up to 0 degrees"."""

    def slid(slope: float, friction: float) -> str:
        up = np.array([math.sin(slope), 0.0, math.cos(slope)])
        down = np.array([math.cos(slope), 0.0, -math.sin(slope)])
        rope = rw.Rope(
            segments=4, length=0.4, diameter=0.01, made_of=rw.Material(EA=1e4, mass_per_length=0.1),
            shape={"kind": "straight", "start": tuple(0.005 * up), "end": tuple(0.005 * up + 0.4 * down)},
        )  # fmt: skip
        floor = {"kind": "plane", "name": "floor", "normal": tuple(up), "friction": friction}
        scene = rw.Scene(ropes=[rope], anchors=[rw.Anchor(node=0)], obstacles=[floor])
        (wrap, *_) = static_shape(scene, strict=False).wraps
        assert wrap.slope == pytest.approx(slope, abs=1e-6)
        return sliding_words((replace(wrap, use=1.0 if friction else 0.0),))

    level = slid(0.0, 0.3)
    assert "On 'floor' (friction 0.3) friction carries all it can: it is level there" in level
    assert "slope" not in level
    assert level.endswith(". Give more friction, or an anchor")
    assert "slopes of up to atan(friction) = 16.7 degrees" in slid(0.1, 0.3)
    smooth = slid(0.0, 0.0)
    assert "'floor' has no friction" in smooth
    assert "slope" not in smooth
    assert smooth.endswith(". Give friction, or an anchor")
