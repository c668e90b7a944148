"""A line that parts under what slides on it, and one that is wound, in a live session."""

from __future__ import annotations

import math

import numpy as np
import pytest

import ropewalk as rw
from ropewalk.laws.slides.table import HIGH, LOW, PLACE
from ropewalk.live.as_it_stands import Standing
from ropewalk.live.carry import carry_over
from ropewalk.live.commands import Load
from ropewalk.live.edits import same_nodes
from ropewalk.live.session import Session
from ropewalk.scene import Straight
from verification import test_slide_beside_winch as wound
from verification import test_slide_on_parted_rope as torn


def test_a_line_that_parts_stays_one_rope_with_a_gap_and_edits_keep_what_ran_off() -> None:
    session = Session(torn.scene(frame_rate=50.0, duration=2.0))
    session.advance(3000)
    track = session.main
    off = float(track.simulation.arrays.memory.slide.off[0])
    assert math.isfinite(off)
    assert len(track.parted) == 1
    assert [rope.name for rope in track.scene.ropes] == ["line", "rider"]
    session.apply(Load(type="load", node=track.simulation.layout.node(-1, "rider"), mass=7.0))
    assert track.simulation.arrays.memory.slide.off[0] == off
    session.advance(100)
    assert np.isfinite(track.simulation.positions).all()
    assert Standing.of(session).scene().slides == ()  # it was on its line again


def test_a_wound_line_is_carried_over_an_edit() -> None:
    session = Session(wound.scene(frame_rate=50.0))
    session.advance(20000)
    before = session.main.simulation.arrays.memory.slide
    assert before.ends[0, LOW] == 1
    ends, place = before.ends.copy(), before.grip.copy()
    session.apply(
        Load(type="load", node=session.main.simulation.layout.node(-1, "rider"), mass=7.0)
    )
    after = session.main.simulation.arrays.memory.slide
    np.testing.assert_array_equal(after.ends, ends)
    np.testing.assert_allclose(after.grip, place, atol=1e-9)


def crossed(run_off: bool) -> tuple[rw.Simulation, rw.Scene]:
    """What slides on a line, or has run off it, and the scene in which it slides along a shorter one."""
    given = torn.scene() if run_off else torn.scene(speed=0.0)
    start, end = (tuple(5.0 * torn.DOWN + np.array([x, 0.0, 0.0])) for x in (-1.3, 2.7))
    stuff, shape = given.ropes[0].made_of.replace(parts=False), Straight(start=start, end=end)
    other = rw.Rope(name="other", segments=4, length=4.0, made_of=stuff, shape=shape)
    anchors = [*given.anchors, *(rw.Anchor(rope="other", node=node) for node in (0, -1))]
    (slide,) = given.slides
    before, after = (
        given.replace(
            ropes=[*given.ropes, other], anchors=anchors, slides=[slide.replace(on=on, at=at)]
        )
        for on, at in (("line", 5.0), ("other", 1.3))
    )
    simulation = rw.Simulation(before)
    simulation.advance_steps(3000 if run_off else 10)
    return simulation, after


@pytest.mark.parametrize("run_off", [False, True])
def test_what_slides_along_another_line_forgets_the_first_one(run_off: bool) -> None:
    """Its ends and place are of the new line: those of the old one are beyond it."""
    simulation, changed = crossed(run_off)
    assert math.isfinite(simulation.arrays.memory.slide.off[0]) == run_off
    made = carry_over(simulation, changed, same_nodes(simulation.layout))
    memory = made.arrays.memory.slide
    assert memory.off[0] == math.inf
    assert (memory.ends[0, LOW], memory.ends[0, HIGH]) == (0, 4)
    assert 0.0 <= memory.grip[0, PLACE] <= 4.0
    if not run_off:
        assert memory.grip[0, PLACE] == pytest.approx(1.3, abs=0.02)
        made.advance_steps(100)
        assert np.isfinite(made.positions).all()
