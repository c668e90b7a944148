"""Where what slides begins: on its rope, however that is drawn, or it is refused."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest

import ropewalk as rw
from ropewalk.laws.slides.rail import point_at
from ropewalk.laws.slides.reach import whole
from ropewalk.laws.slides.table import AT
from ropewalk.lowering import build
from ropewalk.scene import SceneError, Straight
from verification.test_slide import LINE, SPAN, scene


def test_it_begins_on_its_rope() -> None:
    for at in (0.3, 2.0, 3.7, SPAN / 1.01):
        simulation = rw.Simulation(scene(slide={"at": at}))
        memory = simulation.arrays.memory.slide
        u = at / (SPAN / 1.01) * (LINE - 1)
        assert memory.sight[0, AT] == pytest.approx(u, abs=1e-9)
        place = point_at(simulation.arrays.x, 0, whole(LINE - 1), u)
        assert simulation.arrays.x[:, LINE] == pytest.approx(place, abs=1e-12)
        assert np.diff(simulation.arrays.x[2, LINE:]) == pytest.approx([-0.5], abs=1e-12)


@pytest.mark.parametrize(
    ("change", "words"),
    [
        ({"slide.on": "wire"}, 'slide[0].on: "wire" - is no rope'),
        ({"slide.on": "rider"}, "is the rope of the node itself"),
        ({"slide.node": 7}, "slide[0].node: 7"),
        ({"slide.at": 9.0}, "must be on rope 'line'"),
        ({"slide.brake_from": 1.0}, "slide[0].brake: missing"),
        ({"rope.line.segments": 1}, "has one segment"),
    ],
)
def test_what_cannot_be_is_refused_in_words(change: dict[str, Any], words: str) -> None:
    with pytest.raises(SceneError) as refused:
        scene().replace(**change)
    assert words in str(refused.value)


def test_what_is_drawn_elsewhere_has_to_be_told_where_it_slides() -> None:
    with pytest.raises(SceneError, match="off its place on rope 'line' at the start"):
        rw.Simulation(
            scene(slide={"at": None, "node": -1}).replace(
                **{
                    "rope.rider.shape.start": (0.0, 5.0, 0.0),
                    "rope.rider.shape.end": (0.0, 5.0, 0.5),
                }
            )
        )


def chained(turn: bool, **more: Any) -> rw.Scene:
    """A hook that slides along a strap, which slides along the line, drawn 0.2 m below it."""
    light = rw.Material(EA=1e4, mass_per_length=0.1)
    strap = rw.Rope(
        name="strap", segments=4, length=2.0, made_of=light, shape=Straight(start=(2.0, 0.0, -0.7))
    )
    hook = rw.Rope(
        name="hook", segments=2, length=3.0, made_of=light, shape=Straight(start=(3.0, 0.0, -0.7))
    )
    slides = [
        rw.Slide(name="lower", rope="hook", on="strap", at=1.0),
        rw.Slide(name="upper", rope="strap", on="line", at=2.0),
    ]
    plain = scene()
    ropes = [plain.ropes[0], strap, hook]
    return plain.replace(ropes=ropes, slides=slides[::-1] if turn else slides, **more)


def test_lines_are_placed_before_what_slides_along_them() -> None:
    """In the order of tables a line was moved away from what was on it, and the run began with that gap."""
    one, other = (build(chained(turn)).state.x for turn in (False, True))
    assert np.array_equal(one, other)
    hook, strap = one[:, -3], one[:, LINE : LINE + 5]
    assert np.linalg.norm(hook - strap[:, 2]) < 1e-9
    ring = chained(False).slides[1].replace(on="hook")
    with pytest.raises(SceneError, match="slide along each other in a ring"):
        build(chained(False).replace(slides=[chained(False).slides[0], ring]))


def test_no_anchor_is_moved_with_what_slides() -> None:
    plain = scene()
    held = [*plain.anchors, rw.Anchor(rope="rider", node=-1)]
    with pytest.raises(SceneError, match="draw it there, as an anchor has its rope's place"):
        build(plain.replace(anchors=held, slides=[plain.slides[0].replace(at=3.7)]))
