"""Cuts of ropes that winches wind: of slack ones, of what came off the drum, beside copies that parted."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest

from live.drive import do, refused
from live.test_wound_ropes import CORD, hung, out, strong, wound
from ropewalk.live.gaps import gaps
from ropewalk.live.keeper import Keeper
from ropewalk.live.replay import ReplayBroadcast
from ropewalk.live.session import Session
from ropewalk.methods.partings import part_segment
from ropewalk.scene import Anchor, Material, Rope, RunSettings, Scene, Straight, Winch


def slack() -> Scene:
    """Return a rope that its winch has not drawn straight yet, and that carries nothing."""
    rope = Rope(
        name="line",
        segments=6,
        length=0.6,
        made_of=Material(**CORD, tension_only=True),
        shape=Straight(start=(0, 0, 0), end=(0.55, 0, 0)),
    )
    ends = [Anchor(name="drum", node=0, rope="line"), Anchor(name="far", node=-1, rope="line")]
    return Scene(
        ropes=[rope],
        anchors=ends,
        winches=[Winch(rope="line", end="start", speed=0.1, on_drum=0.3, start=1)],
        run=RunSettings(method="implicit-euler", time_step=0.01, duration=2.0),
    )


def test_of_two_cuts_at_one_moment_both_are_told() -> None:
    session = Session(strong(slack()))
    session.advance(1)
    start = session.main.simulation.layout.span("line").start
    for count, segment in enumerate((1, 3), start=1):
        do(session, "cut", segment=start + segment)
        session.look()
        assert len(session.main.parted) == count
    assert {one.parting.tension for one in session.main.parted} == {0.0}
    assert [one.parting.segment for one in session.main.parted] == [1, 3]
    session.advance(20)
    session.look()
    assert len(session.main.parted) == len(gaps(session.main.simulation)) == 2


@pytest.mark.parametrize("end", ["start", "end"])
def test_what_came_off_the_drum_since_the_start_can_be_cut(end: str) -> None:
    """In copies at the same place; what is on the drum still cannot."""
    session = wound(strong(hung(0.5, end)))
    do(session, "compare", variants=[{"label": "other", "changes": {"mass": 0.1}}])
    simulation = session.main.simulation
    span, state = simulation.layout.span("line"), simulation.arrays
    off = span.start - 1 if end == "start" else span.end
    on = span.first if end == "start" else span.last - 1
    assert state.stiffness[off] > 0.0 == state.stiffness[on]
    assert "is on a winch's drum" in refused(session, "cut", segment=on)
    assert "stands" in do(session, "cut", segment=off)
    begun = out(session)
    for track in session.tracks:
        assert list(gaps(track.simulation)) == [off]
    session.advance(20)
    assert out(session) == begun


def test_a_copy_that_has_parted_there_already_refuses_nothing_for_the_others() -> None:
    session = Session(strong(hung(-0.5)))
    session.advance(5)
    do(session, "compare", variants=[{"label": "weak", "changes": {"mass": 0.01}}])
    weak = session.tracks[1].simulation
    cut = weak.layout.span("line").last - 2
    part_segment(weak.system, weak.arrays, cut, float(weak.tension[cut]), weak.time)
    weak.push({})
    session.look()
    told = session.tracks[1].parted
    assert "stands" in do(session, "cut", segment=cut)
    session.look()
    assert [len(track.parted) for track in session.tracks] == [1, 1]
    assert session.tracks[1].parted == told
    said = refused(session, "cut", segment=cut)  # for the first alone
    assert "has parted: nothing is to be cut" in said


@pytest.mark.parametrize("end", ["start", "end"])
@pytest.mark.parametrize("speed", [0.5, -0.5])
def test_where_a_wound_rope_parted_is_told_along_what_is_off_the_drum(
    speed: float, end: str, tmp_path: Path
) -> None:
    """Of what came off since the start a place of -0.05 m was told, "-0.05 m from its start"."""
    session = wound(strong(hung(speed, end)))
    keeper = Keeper(session, tmp_path / "run")
    session.advance(1)
    simulation, length = session.main.simulation, out(session)
    span, rest = simulation.layout.span("line"), simulation.arrays.rest_length
    off = span.first + np.flatnonzero(rest[span.first : span.last])
    cut = int(off[1] if end == "start" else off[-2])
    drawn = slice(off[0], cut) if end == "start" else slice(cut + 1, off[-1] + 1)
    from_drum = float(rest[drawn].sum() + 0.5 * rest[cut])
    do(session, "cut", segment=cut)
    session.look()
    session.advance(2 * session.frame_steps)
    keeper.close()
    (live,) = session.main.parted
    broadcast = ReplayBroadcast(tmp_path / "run", playing=False)
    (again,) = broadcast.layout(len(broadcast.parts) - 1)["variants"][0]["parted"]
    for place, whole in ((live.place, live.length), (again["place"], again["length"])):
        assert whole == pytest.approx(length, abs=0.02)
        assert (place if end == "start" else whole - place) == pytest.approx(from_drum, abs=0.02)
