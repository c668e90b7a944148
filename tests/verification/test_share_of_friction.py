"""How much of its friction a rope at rest takes: the least share of it that would hold the rope.

Of a rope without weight on a drum that is ln(ratio of tensions) / (mu angle).
"""

from __future__ import annotations

import math

import numpy as np
import pytest

import ropewalk as rw
from ropewalk.statics import static_shape
from verification.test_rest_on_obstacles import drum, table, weighted


@pytest.mark.parametrize("ratio", [1.0, 1.2, 1.5, 2.0, 1.0 / 1.5])
def test_the_share_of_friction_is_that_of_logarithms(ratio: float) -> None:
    """As pages tell it of runs; a half of what held 2.566 to 1 was told where 1.283 pulled, which is 26 %."""
    (wrap,) = static_shape(weighted(ratio, drum(0.3))).wraps
    assert wrap.share == pytest.approx(abs(math.log(ratio)) / (0.3 * math.pi), abs=0.003)


def needed(hangs: float, edge: float) -> float:
    """Return the friction that holds a rope of 1 m of which so much hangs over a rounded edge [1].

    dT = (mu (T + w R cos a) - w R sin a) da from the table on, for w = 1.
    """

    def holds(mu: float) -> float:
        pull, count = mu * (1.0 - hangs - 0.5 * math.pi * edge), 1000
        for a in (np.arange(count) + 0.5) * 0.5 * math.pi / count:
            rate = mu * (pull + edge * math.cos(a)) - edge * math.sin(a)
            pull += rate * 0.5 * math.pi / count
        return pull

    tried = np.linspace(0.0, 0.4, 401)
    return float(np.interp(hangs, [holds(mu) for mu in tried], tried))


@pytest.mark.parametrize("hangs", [0.1, 0.2])
def test_the_share_of_friction_is_that_which_would_do(hangs: float) -> None:
    """The end of a tail that lies pulls nothing, so that no logarithm is known: 14 and 58 % for 47 and 78."""
    (wrap,) = static_shape(table(hangs)).wraps
    assert min(wrap.before, wrap.after) == 0.0
    assert wrap.share == pytest.approx(needed(hangs, 0.05) / 0.3, rel=0.03)


def groove(tilt: float, friction: tuple[float, float], **more: object) -> rw.Scene:
    """A rope that lies along a groove, its sides at 30 degrees to its middle, on a slope [rad]."""
    half = math.radians(30.0)
    rope = rw.Rope(
        segments=10,
        length=0.5,
        diameter=0.01,
        made_of=rw.Material(EA=1e4, mass_per_length=0.1, axial_damping=5.0),
        shape={"kind": "straight", "start": (0, 0, 0.01), "end": (0.5, 0, 0.01)},
    )
    normals = [(0, side * math.cos(half), math.sin(half)) for side in (1, -1)]
    sides = [rw.Plane(normal=one, friction=mu) for one, mu in zip(normals, friction, strict=True)]
    down = (9.81 * math.sin(tilt), 0, -9.81 * math.cos(tilt))
    return rw.Scene(gravity=down, ropes=[rope], obstacles=sides, **more)


@pytest.mark.parametrize("friction", [(0.3, 0.3), (0.1, 0.5)])
@pytest.mark.parametrize("short", [15.0, 5.0, 0.3])
def test_what_wedges_a_rope_in_a_groove_is_not_what_holds_it_along(
    friction: tuple[float, float], short: float
) -> None:
    """It slides from tan(slope) = mu / sin(30 degrees) on; 100 % was told from 5 degrees below that on."""
    slides = sum(friction)
    tilt = math.atan(slides) - math.radians(short)
    found = static_shape(groove(tilt, friction)).wraps
    assert [wrap.beside for wrap in found] == [("obstacle1",), ("obstacle0",)]
    for wrap in found:
        assert wrap.taken == pytest.approx(math.tan(tilt) / slides, rel=1e-3)
        assert "along 'obstacle" in wrap.words


def test_a_groove_holds_a_rope_by_the_friction_of_both_sides() -> None:
    """One that hangs down in it from an anchor; nothing was told of what friction holds."""
    tilt, weight = (
        math.radians(46.0),
        0.475 * 0.1 * 9.81,
    )  # half of the first segment is the anchor's
    scene = groove(tilt, (0.1, 0.5), anchors=[rw.Anchor(node=0)])
    for wrap in static_shape(scene).wraps:
        least, most = (
            weight * (math.sin(tilt) + sign * 0.6 * math.cos(tilt)) for sign in (-1.0, 1.0)
        )
        assert (wrap.least, wrap.most) == pytest.approx((least, most), rel=1e-3)
        assert "friction with that of 'obstacle" in wrap.words


@pytest.mark.parametrize("aside", [0.0, 0.2])
def test_what_friction_holds_is_of_the_shape_as_it_lies(aside: float) -> None:
    """Led to a side by 0.2 rad, half a turn held up to 18.2 N as told; 23.1 N stood, 24.9 N of 25.7 slid."""
    radius, count, pull, mu = 0.014, 24, 10.0, 0.3
    step = 2.0 * radius * math.sin(0.5 * math.pi / count)
    turn = np.linspace(math.pi, 0.0, count + 1)
    arc = np.stack([0.0 * turn, radius * np.cos(turn), radius * np.sin(turn)], axis=1)
    down = np.array([math.sin(aside), 0.0, -math.cos(aside)])
    way = step * np.arange(1, 61)[:, None] * down
    points = np.concatenate([arc[0] + way[::-1], arc, arc[-1] + way])
    forces = [{"node": 0, "force": pull * down}, {"node": -1, "force": 1.5 * pull * down}]
    rope = rw.Rope(
        segments=len(points) - 1,
        length=step * (len(points) - 1),
        diameter=0.008,
        made_of=rw.Material(EA=1e5, mass_per_length=0.02, axial_damping=10.0),
        shape={"kind": "points", "points": points.tolist()},
        forces=forces,
    )
    bar = rw.Cylinder(start=(-1, 0, 0), end=(1, 0, 0), radius=0.01, friction=mu)
    (wrap,) = static_shape(rw.Scene(gravity=(0, 0, 0), ropes=[rope], obstacles=[bar])).wraps
    capstan = pull * math.exp(mu * math.pi)
    assert wrap.wider * wrap.most == pytest.approx(capstan, rel=0.01)
    if aside:
        assert wrap.most < 0.8 * capstan
        assert "in this shape" in wrap.words
        assert "that may widen towards 3.9 N to 25." in wrap.words
    else:
        assert wrap.most == pytest.approx(capstan, rel=0.01)
        assert "in this shape" not in wrap.words
