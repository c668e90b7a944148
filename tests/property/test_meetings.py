"""Ropes that can touch each other move to the bits that they have alone until another comes within reach."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest

from meeting_scenes import FRAME, METHODS, check_same, groups, rope, scene, whole
from ropewalk.core.arrays import flatten
from ropewalk.engine import islands
from ropewalk.engine.contact_rows import differ, rows_of
from ropewalk.engine.meetings import Meetings
from ropewalk.laws.slides.table import DRUM
from ropewalk.methods.controller import BEFORE, BEGUN, WISH
from ropewalk.record import checkpoint
from ropewalk.scene import (
    Material,
    Rope,
    Slide,
    Straight,
    Winch,
)
from ropewalk.simulation import Simulation
from ropewalk.simulation.block import join


@pytest.mark.parametrize("method", METHODS)
def test_a_rope_has_its_bits_alone_and_beside_one_that_it_does_not_touch(method: str) -> None:
    """Which was kicked, and set the pace for both."""
    stiff = {"made_of": Material(EA=1e5, mass_per_length=0.2, axial_damping=5.0), "segments": 9}
    far = rope("b", 100.0, kick=20.0, **stiff)
    one, two = (
        Simulation(scene(ropes, method))
        for ropes in ([rope("a", 0.0, kick=0.5)], [far, rope("a", 0.0, kick=0.5)])
    )
    assert groups(two) == [("b",), ("a",)]
    single, both = whole(one), whole(two)
    assert single.frames == both.frames == 7
    check_same(one, single, two, both, "a")
    assert groups(two) == [("b",), ("a",)]


@pytest.mark.parametrize("method", METHODS)
def test_ropes_that_meet_have_the_bits_that_they_have_without_a_third(method: str) -> None:
    """Those that meet, on both sides of another one in the arrays. It moves as it does alone."""
    a, b, c = (
        rope("a", 0.0, kick=0.5),
        rope("b", 50.0, kick=5.0, segments=4),
        rope("c", 0.35, kick=-9.0),
    )
    runs = {}
    for names in ("ac", "abc", "b", "a"):
        simulation = Simulation(scene([one for one in (a, b, c) if one.name in names], method))
        runs[names] = simulation, whole(simulation)
    (two, pair), (three, all_three) = runs["ac"], runs["abc"]
    assert isinstance(three._engine, Meetings)
    assert groups(three) == [("a", "c"), ("b",)]
    assert groups(two) == [("a", "c")]
    check_same(two, pair, three, all_three, "ac")
    check_same(*runs["b"], three, all_three, "b")
    assert pair.recording.contact.any()
    assert pair.pairs is not None
    assert all_three.pairs is not None
    count = np.isfinite(pair.pairs[..., 0]).sum()
    assert count > 0
    assert np.isfinite(all_three.pairs[..., 0]).sum() == count
    forces = [part.pairs[..., 4:][np.isfinite(part.pairs[..., 4:])] for part in (pair, all_three)]
    assert np.array_equal(*forces)
    (lone, alone), first = runs["a"], pair.head(2)
    check_same(lone, alone, two, first, "a")  # until then
    assert not np.array_equal(alone.recording.x[-1], pair.recording.x[-1, :, :7])


@pytest.mark.parametrize("method", ["implicit-euler", "semi-implicit-euler"])
def test_it_does_not_matter_how_calls_are_cut(method: str) -> None:
    """Frames of many steps, of which ropes meet in one: single steps lead to the same bits."""
    drawn = scene([rope("a", 0.0, kick=0.5), rope("b", 0.35, kick=-9.0), rope("c", 9.0)], method)
    drawn = drawn.replace(run=drawn.run.replace(time_step=min(drawn.run.time_step, FRAME / 40)))
    one, other = Simulation(drawn), Simulation(drawn)
    for _ in range(4):
        one.advance_frames(1)
        for steps in (1, 7, 30, one.plan.steps_per_frame - 38):
            other.advance_steps(steps)
        assert groups(one) == groups(other)
    assert groups(one) == [("a", "b"), ("c",)]
    for name, part in flatten(one.state.state).items():
        if not name.startswith(("peaks.", "memory.contact.")):
            assert np.array_equal(part, flatten(other.state.state)[name], equal_nan=True), name
    first, second = (rows_of(run.arrays.memory.contact) for run in (one, other))
    assert first.books.any()
    assert not differ(first, second)
    assert np.array_equal(one.state.inner[:3], other.state.inner[:3])


@pytest.mark.parametrize("ropes", ["abc", "ab"])
@pytest.mark.parametrize("method", ["bdf2", "adaptive", "semi-implicit-euler"])
def test_a_run_goes_back_and_on_across_a_meeting(method: str, ropes: str, tmp_path: Path) -> None:
    """From snapshots and checkpoints of before and after, here and elsewhere, to the same bits."""
    three = [rope("a", 0.0, kick=0.5), rope("c", 9.0), rope("b", 0.35, kick=-9.0)]
    drawn = scene([one for one in three if one.name in ropes], method)
    simulation, other = Simulation(drawn), Simulation(drawn)
    before = simulation.state
    apart = groups(simulation)
    first = join([simulation.advance_frames(1) for _ in range(4)])
    met, middle = groups(simulation), simulation.state
    assert len(met) == len(apart) - 1
    last = join([simulation.advance_frames(1) for _ in range(2)])
    for one in (simulation, other):
        one.restore(middle)
        assert groups(one) == met
        again = join([one.advance_frames(1) for _ in range(2)])
        assert np.array_equal(again.recording.x, last.recording.x)
        assert np.array_equal(again.recording.energy, last.recording.energy)
        one.restore(before)
        assert groups(one) == apart
        again = join([one.advance_frames(1) for _ in range(4)])
        assert np.array_equal(again.recording.x, first.recording.x)
    checkpoint.save(tmp_path, checkpoint.Checkpoint(middle, 5, "", 0.0, ()))
    fresh = Simulation(drawn)
    fresh.restore(checkpoint.load(tmp_path, fresh.state).snapshot)
    again = join([fresh.advance_frames(1) for _ in range(2)])
    assert np.array_equal(again.recording.x, last.recording.x)
    assert np.array_equal(again.recording.tension, last.recording.tension)


@pytest.mark.parametrize("method", ["bdf2", "adaptive"])
def test_what_slides_and_winds_meets_others_with_the_same_bits(method: str) -> None:
    """What lies inside its line, and nodes at drums, count in the arrays of those that have met, too."""
    cord, down = {"made_of": Material(EA=1e4, mass_per_length=0.2, axial_damping=5.0)}, (0, 0, -1)
    short = {"segments": 3, "length": 0.6, "diameter": 0.02, **cord}
    ropes = [
        rope("b", 50.0, kick=3.0),
        Rope(name="d", shape=Straight(start=(1.3, 50.0, 0.0), direction=down), **short),
        rope("t", 0.4, kick=-9.0),
        Rope(name="c", shape=Straight(start=(1.3, 0.0, 0.0), direction=down), **short),
        rope("a", 0.0, kick=0.5, segments=12),
    ]
    drawn = scene(ropes, method, 8 * FRAME).replace(
        slides=[Slide(rope="d", on="b", at=1.3), Slide(rope="c", on="a", at=1.3)],
        winches=[Winch(rope="a", end="end", speed=0.5)],
    )
    anchors = [one for one in drawn.anchors if one.rope not in "cd"]
    drawn = drawn.replace(anchors=anchors)
    part = drawn.replace(
        ropes=ropes[2:],
        slides=drawn.slides[1:],
        anchors=[one for one in anchors if one.rope != "b"],
    )
    one, two = Simulation(part), Simulation(drawn)
    single, both = whole(one), whole(two)
    assert groups(one) == [("t", "c", "a")]
    assert groups(two) == [("b", "d"), ("t", "c", "a")]
    assert both.frames == single.frames == 9
    check_same(one, single, two, both, "tca")
    first, second = (run.arrays.memory.slide for run in (one, two))
    assert np.array_equal(first.grip, second.grip[1:])
    assert second.ends[1, DRUM + 1] == two.arrays.winch_exit[0]
    shift = two.layout.span("t").first
    assert np.array_equal(
        one.arrays.memory.contact.inside + shift,
        two.arrays.memory.contact.inside[-len(one.arrays.memory.contact.inside) :],
    )


def test_those_that_meet_walk_on_with_the_shortest_step_of_any() -> None:
    """They began as a run does, at the time in which the largest acceleration goes through the tolerance."""
    ropes = [rope("a", 0.0, kick=0.5), rope("b", 9.0, kick=9.0)]
    simulation = Simulation(scene(ropes, "adaptive"))
    simulation.advance_frames(1)
    meetings = simulation._engine
    assert isinstance(meetings, Meetings)
    wishes = [(one.walk.control[WISH], one.walk.control[BEFORE]) for one in meetings.engines]
    meetings._regroup([(0, 1)])
    (one,) = meetings.engines
    assert tuple(one.walk.control[[WISH, BEFORE]]) == min(wishes)
    assert 0.0 < min(wishes)[0] < max(wishes)[0]
    assert one.walk.control[BEGUN] == 0.0  # from the state that is shown


def test_threads_change_no_bit(monkeypatch: pytest.MonkeyPatch) -> None:
    found = []
    for threads, least in ((1, islands.LONG), (3, -1.0)):
        monkeypatch.setattr(islands, "threads", threads)
        monkeypatch.setattr(islands, "LONG", least)
        ropes = [rope("a", 0.0, kick=0.5), rope("b", 0.35, kick=-9.0), rope("c", 9.0, kick=1.0)]
        found.append(whole(Simulation(scene(ropes, "sdirk2"))).recording)
    assert np.array_equal(found[0].x, found[1].x)
    assert np.array_equal(found[0].energy, found[1].energy)


def test_a_snapshot_of_an_older_version_has_all_ropes_in_one_island() -> None:
    drawn = scene([rope("a", 0.0, kick=0.5), rope("b", 9.0)], "sdirk2")
    simulation = Simulation(drawn)
    old = simulation.state._replace(inner=np.zeros(0))
    simulation.restore(old)
    assert groups(simulation) == [("a", "b")]
    simulation.step()
    simulation.reset()
    assert groups(simulation) == [("a",), ("b",)]


@pytest.mark.parametrize("method", ["sdirk2", "adaptive"])
def test_one_that_does_not_fit_changes_nothing(method: str) -> None:
    """State and clock were written by then, and what was wrong was told by numpy, if at all."""
    simulation = Simulation(scene([rope("a", 0.0), rope("b", 9.0), rope("c", 20.0)], method))
    simulation.advance_frames(1)
    here = simulation.state
    simulation.advance_frames(1)
    before, at = simulation.state, simulation.clock
    one, many = here.inner.copy(), here.inner.copy()
    one[1], many[3] = 0.0, 0.5
    halves = here.walk._replace(shown=here.walk.shown[:1])
    wrong = {
        "which ropes have met": here._replace(inner=np.full(3, np.nan)),
        "the numbers of its islands": here._replace(inner=one),
        "which ropes have ended": here._replace(inner=many),
        "the steps of its islands": here._replace(walk=halves),
        "the steps of its method": here._replace(
            walk=here.walk._replace(control=np.zeros(9 if method == "sdirk2" else 0))
        ),
    }
    if method == "sdirk2":
        del wrong["the steps of its islands"]  # it has none
    for what, snapshot in wrong.items():
        moved = snapshot.state._replace(x=snapshot.state.x + 1.0)
        rule = f"^snapshot: of another scene - must be of this simulation: {what}$"
        with pytest.raises(ValueError, match=rule):
            simulation.restore(snapshot._replace(state=moved, start=1.0))
        assert simulation.clock == at, what
        assert groups(simulation) == [("a",), ("b",), ("c",)]
        for name, part in flatten(simulation.state).items():
            np.testing.assert_array_equal(part, flatten(before)[name], err_msg=f"{what}: {name}")
    tied = scene([rope("a", 0.0), rope("b", 0.0219), rope("c", 20.0)], method)
    near, apart = Simulation(tied), Simulation(tied)
    snapshot = near.state
    inner = snapshot.inner.copy()
    inner[1] = 1.0  # what is one from the start is not two
    with pytest.raises(ValueError, match="which ropes have met"):
        apart.restore(snapshot._replace(inner=inner))
