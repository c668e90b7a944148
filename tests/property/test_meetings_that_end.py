"""Ropes that can touch each other: who ends with whom, and that none passes unseen before."""

from __future__ import annotations

import numpy as np
import pytest

from meeting_scenes import FRAME, crossing, groups, rope, scene, whole
from ropewalk.engine import burst
from ropewalk.engine.engine import Engine
from ropewalk.engine.partition import MOST_APART
from ropewalk.record.simulate import simulate_in_memory
from ropewalk.scene import (
    Anchor,
    Contact,
    Kick,
    Material,
    Rope,
    RunSettings,
    Scene,
    Straight,
    Table,
)
from ropewalk.simulation import Simulation


def test_a_rope_that_breaks_ends_its_own_island_where_ropes_can_touch() -> None:
    a, b = rope("a", 0.0, kick=0.5), rope("b", 100.0, kick=5e6)
    single = simulate_in_memory(scene([a], "sdirk2"))
    both = simulate_in_memory(scene([b, a], "sdirk2"))
    (end,) = both.ends
    assert (both.status, end.ropes) == ("broke", ("b",))
    assert both.frames == single.frames
    assert np.array_equal(both.rope("a").positions, single.rope("a").positions)
    assert np.isnan(both.rope("b").tension[-1]).all()


def test_ropes_that_break_where_they_met_end_together() -> None:
    """In the very frame in which they meet, the third one goes on."""
    ropes = [rope("a", 0.0, kick=0.5), rope("c", 50.0), rope("b", 0.35, kick=-5e5)]
    found = simulate_in_memory(scene(ropes, "implicit-euler"))
    alone = simulate_in_memory(scene(ropes[1:2], "implicit-euler"))
    (end,) = found.ends
    assert set(end.ropes) <= {"a", "b"}
    assert "b" in end.ropes
    assert np.array_equal(found.rope("c").positions, alone.rope("c").positions)


@pytest.mark.parametrize(
    ("method", "parts"), [("implicit-euler", 1), ("sdirk2", 6), ("adaptive", 1)]
)
def test_what_comes_within_reach_of_a_rope_that_has_ended_ends_too(method: str, parts: int) -> None:
    """It went through where that one lies. Others go on, as alone; so does what stays away from it."""
    torn, thrown, away = (
        rope("b", -0.3, kicks=[Kick(node=3, velocity=(0.0, 0.0, -5e6))]),  # past no other rope
        rope("c", 0.3, kick=-9.0),
        rope("d", 50.0, kick=0.5),
    )
    drawn = scene([torn, thrown, away, rope("e", 100.0, kick=-9.0)], method, 10 * FRAME)
    if parts > 1:
        drawn = drawn.replace(run=drawn.run.replace(time_step=FRAME / parts))
    found = simulate_in_memory(drawn)
    alone = simulate_in_memory(drawn.replace(ropes=[away], anchors=drawn.anchors[2:]))
    first, second = found.ends
    assert (first.ropes, second.ropes) == (("b",), ("c",))
    assert (found.frames, found.status) == (11, "broke")
    assert "'c' came within reach of rope 'b'" in second.why
    assert 0.04 < second.time < 0.0645  # it is 0.58 m off, radii and reach taken off
    lowest = np.nanmin(found.rope("c").positions[..., 1])
    assert -0.28 < lowest < -0.12
    assert np.isnan(found.rope("c").tension[second.frames :]).all()
    assert np.array_equal(found.rope("d").positions, alone.rope("d").positions)
    assert found.rope("e").positions[-1, 3, 1] < 99.0
    assert found.diagnosis.endswith("it ends, too. The other 2 ropes went on.")
    assert "..." not in found.diagnosis


def test_ropes_that_touch_where_they_are_drawn_are_one_from_the_start() -> None:
    """The twin: a hair farther apart they are two."""
    near, apart = (
        scene([rope("a", 0.0, kick=0.5), rope("b", y)], "sdirk2") for y in (0.0219, 0.0221)
    )
    assert isinstance(Simulation(near)._engine, Engine)
    assert groups(Simulation(apart)) == [("a",), ("b",)]


def test_a_force_on_one_reaches_it_and_no_other() -> None:
    drawn = scene([rope("a", 0.0, kick=0.5), rope("b", 9.0)], "sdirk2")
    pushed, still = Simulation(drawn), Simulation(drawn)
    for one in (pushed, still):
        one.step()
    pushed.apply_force(3, (0.0, 0.0, 30.0), "a")
    for one in (pushed, still):
        one.step()
    assert np.abs(pushed.positions[3] - still.positions[3]).max() > 1e-3
    assert np.array_equal(pushed.positions[7:], still.positions[7:])


@pytest.mark.parametrize("method", ["implicit-euler", "adaptive", "semi-implicit-euler"])
def test_nothing_passes_unseen(method: str) -> None:
    """A rope thrown across another one, at 50 m/s: 0.8 m in a frame. It never comes out behind it."""
    kicks = [Kick(node=k, velocity=(0.0, -50.0, 0.0)) for k in range(7)]
    thrown = rope("b", 0.0, length=1.5).replace(shape=crossing(1.1), kicks=kicks)
    drawn = scene([rope("a", 0.0, kick=0.5), thrown], method)
    drawn = drawn.replace(
        anchors=[one for one in drawn.anchors if one.rope == "a"], gravity=(0, 0, 0)
    )
    simulation = Simulation(drawn)
    assert len(groups(simulation)) == 2
    span = simulation.layout.span("b")
    for _ in range(6):
        assert simulation.advance_frames(1).status == 0
        nodes = simulation.positions[[2, 3, 4]]
        middle = simulation.positions[span.first + 2 : span.first + 5]
        assert middle[:, 1].max() > nodes[:, 1].min() - 0.02
    assert len(groups(simulation)) == 1


@pytest.mark.parametrize(("method", "parts"), [("semi-implicit-euler", 400), ("implicit-euler", 8)])
def test_a_rope_that_is_stretched_far_within_a_frame_is_watched(method: str, parts: int) -> None:
    """Its anchor jumps across a cord in 0.1 ms: the run ends there, as it does as one island."""
    stuff = Material(EA=300.0, mass_per_length=0.2, axial_damping=2.0)
    cord = Rope(
        name="a", segments=12, length=3.0, diameter=0.02, made_of=stuff,
        shape=Straight(start=(-1.5, 0, 0), direction=(1, 0, 0)),
    )  # fmt: skip
    other = Rope(
        name="b", segments=10, length=1.0, diameter=0.02, made_of=stuff,
        shape=Straight(start=(0.1, 1, 0), direction=(0, 1, 0)),
    )  # fmt: skip
    jump = Table(
        times=(0.0, 0.03, 0.0301, 1.0),
        positions=((0.1, 1, 0), (0.1, 1, 0), (0.1, -1, 0), (0.1, -1, 0)),
    )
    anchors = [
        Anchor(name="a0", rope="a", node=0),
        Anchor(name="a1", rope="a", node=-1),
        Anchor(name="b0", rope="b", node=0, motion=jump),
    ]
    run = RunSettings(method=method, duration=0.1, frame_rate=60.0, time_step=FRAME / parts)
    simulation = Simulation(
        Scene(
            ropes=[cord, other], anchors=anchors, contact=Contact(friction=0.2), run=run,
            gravity=(0, 0, 0),
        )
    )  # fmt: skip
    assert groups(simulation) == [("a",), ("b",)]
    block = simulation.advance_frames(6)
    assert block.frames == 1  # it was seen a frame later, far behind the cord
    (fall,) = simulation.falls
    assert set(fall.ropes) == {"a", "b"}


def test_very_many_ropes_of_an_explicit_method_move_as_one() -> None:
    """The calls of their islands would show; one rope less, and each has its own."""
    many = [rope(f"r{k}", float(k)) for k in range(MOST_APART + 1)]
    assert isinstance(Simulation(scene(many, "semi-implicit-euler"))._engine, Engine)
    assert len(groups(Simulation(scene(many[:-1], "semi-implicit-euler")))) == MOST_APART


def test_a_numerical_burst_reaches_nobody() -> None:
    """Its steps are too long; its boxes cover the scene within a frame. One 1 km away goes on, as alone."""
    stiff = Material(EA=1e6, mass_per_length=0.2, axial_damping=0.5)
    wild, calm = (
        rope("a", 0.0, kick=0.02, made_of=stiff, segments=8),
        rope("b", 1000.0, kick=0.5, segments=4),
    )
    found, alone = (
        simulate_in_memory(
            drawn.replace(run=drawn.run.replace(time_step=FRAME / 80, duration=3 * FRAME))
        )
        for drawn in (scene(ropes, "semi-implicit-euler") for ropes in ([wild, calm], [calm]))
    )
    (end,) = found.ends
    assert (found.frames, end.ropes, end.frames) == (4, ("a",), 1)
    assert np.array_equal(found.rope("b").positions, alone.rope("b").positions)


def test_what_had_burst_and_came_back_is_watched_after_all(monkeypatch: pytest.MonkeyPatch) -> None:
    """Where energy is made up within a frame, and no more at its end: nothing passes unseen."""
    drawn = scene([rope("a", 0.0, kick=0.5), rope("b", 0.35, kick=-9.0)], "implicit-euler")
    drawn = drawn.replace(run=drawn.run.replace(time_step=FRAME / 4, duration=3 * FRAME))
    first = Simulation(drawn)
    seen = whole(first)
    monkeypatch.setattr(burst, "_made_up", lambda engine, time: True)
    second = Simulation(drawn)
    assert np.array_equal(whole(second).recording.x, seen.recording.x)
    assert groups(first) == groups(second) == [("a", "b")]


@pytest.mark.parametrize("torn", [False, True])
def test_what_stays_in_a_corner_of_its_box_never_meets_a_rope(torn: bool) -> None:
    """It flies by 2 m from a rope across, which has ended or not. The twin: it comes to its line."""
    stuff = Material(EA=1e4, mass_per_length=0.2, axial_damping=5.0)
    kicks = [Kick(node=4, velocity=(5e6, 5e6, 0.0))] if torn else []
    across = rope("a", 0.0, length=32.0**0.5, segments=8, made_of=stuff).replace(
        shape=Straight(start=(-2.0, -2.0, 0.0), end=(2.0, 2.0, 0.0)), kicks=kicks
    )
    for y in (-1.7, 1.3):
        way = Straight(start=(1.5, y, 1.5), end=(1.5, y + 0.4, 1.5), velocity=(0.0, 0.0, -20.0))
        short = rope("b", 0.0, length=0.4, segments=4).replace(shape=way)
        drawn = scene([across, short], "implicit-euler", 9 * FRAME)
        anchors = [one for one in drawn.anchors if one.rope == "a"]
        drawn = drawn.replace(anchors=anchors)
        if torn:
            ends = [end.ropes for end in simulate_in_memory(drawn).ends]
            assert ends == [("a",), ("b",)][: 1 if y < 0.0 else 2]
        else:
            simulation = Simulation(drawn)
            simulation.advance_frames(9)
            assert groups(simulation) == ([("a",), ("b",)] if y < 0.0 else [("a", "b")])
