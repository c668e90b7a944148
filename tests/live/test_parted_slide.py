"""A line that parts under what slides on it, and one that is wound, in a live session."""

from __future__ import annotations

import math

import numpy as np

from ropewalk.laws.slides.table import LOW
from ropewalk.live.commands import Load
from ropewalk.live.session import Session
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
