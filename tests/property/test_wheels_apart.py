"""Ropes that do not come within reach of a wheel move to the bits that they have without it."""

from __future__ import annotations

import itertools
import math
import os
from pathlib import Path

import numpy as np
import pytest

from meeting_scenes import check_same, groups, whole
from ropewalk.core.arrays import flatten
from ropewalk.laws.contact_frame import PUSH
from ropewalk.laws.wheel_rows import RECORDED, TRIAL
from ropewalk.methods.recording import remembering, work_names
from ropewalk.record import checkpoint
from ropewalk.record.result import Result
from ropewalk.record.resume import resume_run
from ropewalk.record.run import record_run
from ropewalk.record.simulate import simulate_in_memory
from ropewalk.scene import (
    Anchor,
    Contact,
    Kick,
    Load,
    Material,
    Points,
    Rope,
    RunSettings,
    Scene,
    Straight,
)
from ropewalk.simulation import Simulation
from ropewalk.simulation.block import join

METHODS = ("implicit-euler", "sdirk2", "bdf2", "esdirk3", "adaptive", "semi-implicit-euler")
FRAME, RADIUS, THICK = 1.0 / 60.0, 0.2, 0.02
STUFF = Material(EA=1e4, mass_per_length=0.2, axial_damping=5.0)


def line(name: str, y: float, kick: float = 0.0) -> Rope:
    """A cord of 3 m along x, a node of which is kicked across."""
    kicks = [Kick(node=3, velocity=(0.0, kick, 0.0))] if kick else []
    shape = Straight(start=(0.0, y, 0.0))
    return Rope(name=name, segments=6, length=3.0, diameter=THICK, made_of=STUFF, shape=shape,
                kicks=kicks)  # fmt: skip


def over(name: str, x: float) -> Rope:
    """A cord that hangs over a wheel at `x`; its legs are 0.9 and 0.5 m long."""
    round_it = RADIUS + 0.5 * THICK
    angles = np.linspace(math.pi, 0.0, 7)
    arc = [(x + round_it * math.cos(a), 0.0, round_it * math.sin(a)) for a in angles]
    left = [(x - round_it, 0.0, -z) for z in (0.9, 0.6, 0.3)]
    right = [(x + round_it, 0.0, -z) for z in (0.25, 0.5)]
    points = [*left, *arc, *right]
    length = sum(math.dist(*two) for two in itertools.pairwise(points))
    return Rope(name=name, segments=len(points) - 1, length=length, diameter=THICK, made_of=STUFF,
                shape=Points(points=points))  # fmt: skip


def wheel(name: str, x: float, rate: float = 0.0) -> dict[str, object]:
    return {
        "kind": "cylinder",
        "name": name,
        "start": (x, -0.1, 0.0),
        "end": (x, 0.1, 0.0),
        "radius": RADIUS,
        "friction": 0.4,
        "spin": {"free": True, "inertia": 2e-3, "bearing": 1e-3, "rate": rate},
    }


def scene(
    ropes: list[Rope],
    wheels: list[dict[str, object]],
    method: str,
    touching: bool,
    duration: float = 6 * FRAME,
) -> Scene:
    """All cords along x are held by both ends; steps of a frame, or 1/200 of it."""
    explicit = method == "semi-implicit-euler"
    run = RunSettings(method=method, duration=duration, frame_rate=60.0,
                      time_step=FRAME / 200 if explicit else FRAME)  # fmt: skip
    if method == "adaptive":
        run = run.replace(tolerance=1e-4, time_step="auto")
    held = [one.name for one in ropes if isinstance(one.shape, Straight)]
    anchors = [Anchor(name=f"{name}{k}", rope=name, node=k) for name in held for k in (0, -1)]
    contact = Contact(friction=0.2) if touching else None
    return Scene(ropes=ropes, anchors=anchors, obstacles=wheels, contact=contact, run=run)


@pytest.mark.parametrize("touching", [True, False])
@pytest.mark.parametrize("method", METHODS)
def test_a_rope_has_its_bits_with_and_without_a_pulley_far_off(method: str, touching: bool) -> None:
    """And the rope on that pulley those that it has without the other one, with the wheel's."""
    a, b, w = line("a", 0.0, kick=0.5), over("b", 50.0), wheel("w", 50.0)
    alone = Simulation(scene([a], [], method, touching))
    hung = Simulation(scene([b], [w], method, touching))
    both = Simulation(scene([b, a], [w], method, touching))
    single, pulled, found = whole(alone), whole(hung), whole(both)
    assert found.frames == 7
    assert single.frames == pulled.frames == found.frames
    check_same(alone, single, both, found, "a")
    check_same(hung, pulled, both, found, "b")
    assert np.array_equal(pulled.recording.wheel, found.recording.wheel)
    turned = found.recording.wheel[-1, 0, RECORDED.index("angle")]
    assert abs(turned) > 1e-3
    assert np.array_equal(pulled.recording.books[:, 0], found.recording.books[:, 0])
    apart = touching or method != "semi-implicit-euler"
    assert groups(both) == ([("b",), ("a",)] if apart else [("b", "a")])


@pytest.mark.parametrize("method", ["sdirk2", "adaptive"])
def test_two_wheels_are_independent(method: str) -> None:
    """Each turns as it does alone."""
    one, two = over("b", 50.0), over("c", -50.0).replace(kicks=[Kick(node=0, velocity=(0, 0, -1))])
    runs = [
        Simulation(scene(ropes, wheels, method, False))
        for ropes, wheels in (
            ([one], [wheel("v", 50.0)]),
            ([two], [wheel("w", -50.0, 2.0)]),
            ([one, two], [wheel("w", -50.0, 2.0), wheel("v", 50.0)]),
        )
    ]
    first, second, both = map(whole, runs)
    assert groups(runs[2]) == [("b",), ("c",)]
    assert first.frames == second.frames == both.frames
    check_same(runs[0], first, runs[2], both, "b")
    check_same(runs[1], second, runs[2], both, "c")
    assert np.array_equal(both.recording.wheel[:, 1], first.recording.wheel[:, 0])
    assert np.array_equal(both.recording.wheel[:, 0], second.recording.wheel[:, 0])
    assert np.array_equal(both.recording.books[:, 1], first.recording.books[:, 0])


def falling(method: str, touching: bool = False) -> Scene:
    """A cord that falls on a wheel that another one is nearer to, a third far off; two balls far off."""
    near, far = line("n", -40.0, kick=0.5), line("f", 50.0, kick=2.0)
    near = near.replace(shape=Straight(start=(-0.23, -1.5, 0.0), direction=(0.0, 1.0, 0.0)))
    shape = Points(points=[(0.15 * k - 0.5, 0.0, 0.25) for k in range(9)])
    kicks = [Kick(node=k, velocity=(0.5, 0.0, 0.0)) for k in range(9)]
    b = far.replace(name="b", segments=8, length=1.2, shape=shape, kicks=kicks)
    ball = {"kind": "sphere", "name": "ball", "center": (0.0, 9.0, -9.0), "radius": 0.5}
    given = scene([far, b, near], [], method, touching, 15 * FRAME)
    return given.replace(obstacles=[ball, wheel("w", 0.0, 2.0), ball | {"name": "other"}])


@pytest.mark.parametrize("method", ["implicit-euler", "sdirk2", "bdf2", "adaptive"])
def test_a_rope_that_falls_on_a_wheel_moves_as_if_it_were_one_with_it_from_the_start(
    method: str,
) -> None:
    """To rounding, `adaptive` to its tolerance; its books are those of the ledger. A third one is far off."""
    drawn = falling(method)
    anchors = [one for one in drawn.anchors if one.rope != "f"]
    apart, together = (
        Simulation(drawn),
        Simulation(drawn.replace(ropes=drawn.ropes[1:], anchors=anchors)),
    )
    together.restore(together.state._replace(inner=np.zeros(0)))
    assert groups(apart) == [("f",), ("b",), ("n",)]
    assert groups(together) == [("b", "n")]
    first, second = whole(apart), whole(together)
    assert groups(apart) == [("f",), ("b", "n")]
    assert first.recording.contact.any()
    close, kept = (1e-3, 1) if method == "adaptive" else (1e-10, 7)  # of a wheel: its angle, or all
    for name in "bn":
        a, b = apart.layout.span(name), together.layout.span(name)
        here = first.recording.x[..., a.first : a.last + 1]
        assert np.abs(here - second.recording.x[..., b.first : b.last + 1]).max() < close
    turns, others = (block.recording.wheel[..., :kept] for block in (first, second))
    assert np.abs(turns - others).max() < 10 * close
    assert first.recording.wheel[3, 0, 0] == pytest.approx(
        6 * FRAME, rel=0.2
    )  # untouched, it turns
    assert np.abs(first.recording.books - second.recording.books).max() < 10 * close
    ledger = first.recording.work[:, work_names(False, remembering(apart.arrays)).index("obstacle")]
    assert np.abs(ledger).max() > 1e-2
    assert np.abs(first.recording.books[:, 1].sum(axis=1) - ledger).max() < 1e-9


def heavy(torn: bool, touching: bool, step: float, method: str = "implicit-euler") -> Scene:
    """2 kg on a cord that come at a wheel at 10 m/s, or fall on it as that parts; another hangs beside."""
    stuff = Material(EA=2e3, mass_per_length=0.1, axial_damping=2.0)
    loads, anchors = [Load(node=1, mass=2.0)], [Anchor(name="home", rope="home", node=0)]
    hung = Straight(start=(0.0, 0.35, 0.2), direction=(0, 0, -1))
    home = Rope(name="home", segments=2, length=0.4, diameter=0.01, made_of=stuff, shape=hung)
    if torn:
        down = Straight(start=(0.0, 0.0, 0.9), direction=(0, 0, -1))
        weak = stuff.replace(breaking_load=5.0, parts=True)
        other = home.replace(segments=1, made_of=weak, shape=down)
        anchors.append(Anchor(name="hold", rope="other", node=0))
    else:
        flies = Straight(start=(-0.2, 0.0, 0.9), direction=(1, 0, 0), velocity=(0, 0, -10.0))
        other = home.replace(shape=flies)
    run = RunSettings(method=method, duration=0.3, frame_rate=60.0, time_step=step)
    body = {"kind": "cylinder", "name": "w", "start": (0.02, -0.3, 0.2), "end": (0.02, 0.3, 0.2),
            "radius": 0.1, "friction": 0.3, "spin": {"free": True, "inertia": 1e-3}}  # fmt: skip
    return Scene(ropes=[home, other.replace(name="other", loads=loads)], anchors=anchors,
                 obstacles=[body], contact=Contact(friction=0.2) if touching else None, run=run)  # fmt: skip


@pytest.mark.parametrize(
    ("torn", "method", "rate", "steps"),
    [
        (False, "implicit-euler", 240, 16),
        (False, "implicit-euler", 2400, 160),
        (False, "sdirk2", 240, 16),
        (True, "implicit-euler", 240, 96),
    ],
)
@pytest.mark.parametrize("touching", [True, False])
def test_what_comes_heavy_and_fast_is_one_with_a_wheel_before_that_takes_hold_of_it(
    torn: bool, method: str, rate: int, steps: int, touching: bool
) -> None:
    """Its damper does from 0.2 m on; and of what has parted from all else, too."""
    drawn = heavy(torn, touching, 1.0 / rate, method)
    apart, together = Simulation(drawn), Simulation(drawn)
    together.restore(together.state._replace(inner=np.zeros(0)))
    assert groups(apart) == [("home",), ("other",)]
    assert groups(together) == [("home", "other")]
    node, pushes = 3 + 1, list[float]()
    for _ in range(steps):
        apart.advance_steps(1)
        together.advance_steps(1)
        assert np.abs(apart.positions - together.positions).max() < 1e-9
        pushes.append(float(together.arrays.memory.obstacle.grip[0, PUSH, node]))
        assert apart.arrays.memory.obstacle.grip[0, PUSH, node] == pytest.approx(pushes[-1], 1e-6)
    assert groups(apart) == [("home", "other")]
    assert max(pushes) > 80.0
    turns = [one.arrays.memory.obstacle.wheel[0, :2] for one in (apart, together)]
    assert np.abs(turns[0] - turns[1]).max() < 1e-6


@pytest.mark.parametrize("method", ["bdf2", "adaptive"])
def test_a_run_goes_back_and_on_across_a_meeting_with_a_wheel(method: str, tmp_path: Path) -> None:
    """From snapshots and checkpoints of before and after, here and elsewhere, to the same bits."""
    drawn = falling(method)
    simulation, other = Simulation(drawn), Simulation(drawn)
    before, apart = simulation.state, groups(simulation)
    first = join([simulation.advance_frames(1) for _ in range(2)])
    early = simulation.state
    second = join([simulation.advance_frames(1) for _ in range(9)])
    met, middle = groups(simulation), simulation.state
    assert len(met) == len(apart) - 1
    last = join([simulation.advance_frames(1) for _ in range(2)])
    for one in (simulation, other):
        for start, frames, expected in ((middle, 2, last), (before, 2, first), (early, 9, second)):
            one.restore(start)
            again = join([one.advance_frames(1) for _ in range(frames)])
            assert np.array_equal(again.recording.x, expected.recording.x)
            assert np.array_equal(again.recording.wheel, expected.recording.wheel)
            assert np.array_equal(again.recording.energy, expected.recording.energy)
    for kept, frames, expected in ((early, 9, second), (middle, 2, last)):
        checkpoint.save(tmp_path, checkpoint.Checkpoint(kept, 5, "", 0.0, ()))
        fresh = Simulation(drawn)
        fresh.restore(checkpoint.load(tmp_path, fresh.state).snapshot)
        again = fresh.advance_frames(frames)
        assert np.array_equal(again.recording.x, expected.recording.x)
        assert np.array_equal(again.recording.books, expected.recording.books)


def test_it_does_not_matter_how_calls_are_cut_where_a_wheel_is_met() -> None:
    drawn = falling("implicit-euler")
    drawn = drawn.replace(run=drawn.run.replace(time_step=FRAME / 10))
    one, other = Simulation(drawn), Simulation(drawn)
    for _ in range(11):
        one.advance_frames(1)
        for steps in (1, 3, 6):
            other.advance_steps(steps)
        assert groups(one) == groups(other)
    assert groups(one) == [("f",), ("b", "n")]
    working = ("peaks.", "memory.obstacle.ties", "memory.obstacle.wheel")
    for name, part in flatten(one.state.state).items():
        if not name.startswith(working):
            assert np.array_equal(part, flatten(other.state.state)[name], equal_nan=True), name
    first, second = (run.arrays.memory.obstacle.wheel for run in (one, other))
    assert np.flatnonzero((first != second).any(axis=0)).min(initial=TRIAL) >= TRIAL


def test_a_wheel_that_moves_is_one_with_all() -> None:
    """The twin: one that stands is not; a hand that takes it makes all one."""
    drawn = scene([over("b", 50.0), line("a", 0.0)], [wheel("w", 50.0)], "sdirk2", False)
    moving = wheel("w", 50.0) | {"motion": {"kind": "velocity", "velocity": (0.0, 0.0, 0.1)}}
    assert groups(Simulation(drawn.replace(obstacles=[moving]))) == [("b", "a")]
    simulation = Simulation(drawn)
    assert groups(simulation) == [("b",), ("a",)]
    simulation.step()
    simulation.obstacles["w"].move_to((50.0, 0.0, 0.01), 0.1)
    simulation.step()
    assert groups(simulation) == [("b", "a")]


def test_ropes_on_a_pulley_at_rest_are_solved_for_together_and_then_cut() -> None:
    drawn = scene([line("a", 0.0), line("c", 3.0)], [wheel("w", 50.0)], "sdirk2", False)
    run = drawn.run.replace(start="at-rest")
    simulation = Simulation(drawn.replace(run=run))
    assert groups(simulation) == [("a",), ("c",)]
    found = whole(simulation)
    assert np.abs(found.recording.x[-1] - found.recording.x[0]).max() < 1e-9


def test_a_rope_that_breaks_ends_its_own_island_where_another_has_a_pulley() -> None:
    a, b, w = line("a", 0.0, kick=5e6), over("b", 50.0), wheel("w", 50.0)
    single = simulate_in_memory(scene([b], [w], "sdirk2", False))
    both = simulate_in_memory(scene([b, a], [w], "sdirk2", False))
    (end,) = both.ends
    assert (both.status, end.ropes) == ("broke", ("a",))
    assert np.array_equal(both.rope("b").positions, single.rope("b").positions)


def test_a_rope_that_comes_to_a_wheel_of_one_that_has_ended_ends_too() -> None:
    """It would find the wheel gone. The rope far off goes on to the bits that it has alone."""
    drawn = falling("implicit-euler")
    far, falls, near = drawn.ropes
    torn = near.replace(kicks=[Kick(node=3, velocity=(0.0, 0.0, 5e6))])
    found = simulate_in_memory(drawn.replace(ropes=[far, falls, torn]))
    alone = simulate_in_memory(drawn.replace(
        ropes=[far], obstacles=[drawn.obstacles[0], drawn.obstacles[2]],
        anchors=[one for one in drawn.anchors if one.rope == "f"],
    ))  # fmt: skip
    first, second = found.ends
    assert (first.ropes, second.ropes) == (("n",), ("b",))
    assert "within reach of a wheel that turns with rope 'n'" in second.why
    assert np.array_equal(found.rope("f").positions, alone.rope("f").positions)


@pytest.mark.parametrize("at", [2, 4, 6])
def test_a_run_that_is_killed_goes_on_across_a_meeting_with_a_wheel(
    at: int, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """At the file that gets its name as number `at`, before, in and after the chunk in which they meet."""
    monkeypatch.setattr("ropewalk.record.run.chunk_frames", lambda simulation: 3)
    drawn, whole_run, killed = falling("implicit-euler"), tmp_path / "whole", tmp_path / "killed"
    record_run(drawn, whole_run, commit_seconds=0.0)
    real, seen = os.replace, list[bool]()

    def replace(source: object, target: object) -> None:
        seen.append(str(target).endswith("checkpoint.npz"))
        if sum(seen) == at:
            raise KeyboardInterrupt
        real(source, target)  # type: ignore[call-overload]

    with monkeypatch.context() as patch:
        patch.setattr(os, "replace", replace)
        with pytest.raises(KeyboardInterrupt):
            record_run(drawn, killed, commit_seconds=0.0)
    resume_run(killed, commit_seconds=0.0)
    one, other = Result.open(whole_run), Result.open(killed)
    assert one.frames == other.frames == 16
    for name in one.source.names:
        assert np.array_equal(one.read(name), other.read(name), equal_nan=True), name
