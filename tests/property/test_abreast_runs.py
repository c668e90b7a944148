"""Whatever happens to ropes side by side, all that is told and kept is as of ropes by themselves."""

from __future__ import annotations

import copy
import threading
from collections.abc import Callable, Iterable
from typing import Any
from unittest import mock

import numpy as np
import pytest

from property.test_abreast import each_by_itself, ropes_of, starts
from ropewalk.cli import progress
from ropewalk.core.jit import PLAIN
from ropewalk.core.status import UNSOLVED
from ropewalk.engine import crews, islands
from ropewalk.engine.frames import Frames
from ropewalk.engine.islands import Islands
from ropewalk.lowering import build, with_all_laws
from ropewalk.methods.recording import Recording
from ropewalk.methods.registry import METHODS
from ropewalk.scene import Limiter, Rope, Scene
from ropewalk.simulation import Simulation
from ropewalk.simulation.block import Block, join

compiled = pytest.mark.skipif(PLAIN, reason="without the compiler ropes move by themselves")
Told = list[Any]


def numbers(simulation: Simulation) -> bytes:
    """Return all that the islands keep, balances and extremes included."""
    return bytes(simulation._engine.inner.tobytes())


def told(block: Block) -> Told:
    """Return all that a block says."""
    return [block.status, block.frames, *(part.tobytes() for part in block.recording)]


def check(play: Callable[[Simulation], Told], *scenes: Scene, used: float = 1.0) -> Told:
    """Compare what a play tells, and what is left, abreast and one by one; return it.

    So many starts at least were of use: else nothing would have been compared.
    """
    found: Told = []
    for scene in scenes:
        simulation = Simulation(scene)
        here = [*play(simulation), numbers(simulation), simulation.clock]
        with each_by_itself():
            twin = Simulation(scene)
            there = [*play(twin), numbers(twin), twin.clock]
        assert here == there
        assert starts(simulation) >= used > starts(twin) == 0.0
        found += here
    return found


def thrown(simulation: Simulation, rope: int, speed: float) -> None:
    """Give the second node of a rope a speed [m/s]."""
    span = simulation.layout.ropes[rope]
    simulation.velocities[span.first + 1] = (0.0, speed, 0.0)


# -- who goes abreast ----------------------------------------------------------------------


@compiled
@pytest.mark.parametrize("method", [name for name in METHODS if name != "adaptive"])
def test_five_ropes_move_by_every_method(method: str) -> None:
    """Those without a table of coefficients, too. Twin: some do go abreast, and four never do."""
    scene = ropes_of(3, 5, 3, method, steps=3)
    steps = 64 if method in ("euler", "semi-implicit-euler", "verlet", "heun", "rk4") else 1
    scene = scene.replace(run=scene.run.model_copy(update={"time_step": 1.0 / 60.0 / steps}))
    simulation = Simulation(scene, apart=True)
    engine = simulation._engine
    assert isinstance(engine, Islands)
    found = [crew.abreast for crew in engine._crews.now(engine._ended)]
    goes = method in ("implicit-euler", "implicit-midpoint", "sdirk2", "esdirk3")
    assert found == ([True] if goes else 5 * [False])
    four = Simulation(scene.replace(ropes=scene.ropes[:4], anchors=()), apart=True)._engine
    assert isinstance(four, Islands)
    assert not any(crew.abreast for crew in four._crews.now(four._ended))


def scenes_of_all_kinds() -> list[Scene]:
    """Return scenes of few and many, equal and other ropes, with and without what does not go abreast."""
    five, nine = ropes_of(1, 5, 4, "sdirk2"), ropes_of(2, 9, 4, "esdirk3")

    def changed(scene: Scene, change: Callable[[int, Rope], Rope]) -> Scene:
        return scene.replace(ropes=[change(k, rope) for k, rope in enumerate(scene.ropes)])

    def made(**more: Any) -> Callable[[int, Rope], Rope]:
        return lambda k, rope: rope.replace(
            made_of=rope.made_of.model_copy(update=more if k == 2 else {})
        )

    return [
        five,
        nine,
        ropes_of(3, 5, 4, "bdf2"),
        ropes_of(3, 5, 4, "adaptive"),
        ropes_of(3, 5, 4, "verlet"),
        ropes_of(3, 5, 1, "sdirk2"),
        ropes_of(3, 4, 4, "sdirk2"),
        nine.replace(limiter=Limiter(min_stretch=0.01, max_stretch=50.0)),
        changed(five, lambda k, rope: rope.replace(segments=4 + k % 2)),
        changed(nine, lambda k, rope: rope.replace(segments=4 + k % 2)),
        changed(nine, lambda k, rope: rope.replace(segments=4 + (k > 6))),
        changed(five, made(tension_only=True)),
        changed(nine, made(friction="axial", spring_friction=1.0)),
        changed(nine, made(friction="axial", spring_friction=0.0)),
        changed(
            nine,
            lambda k, rope: (
                rope.replace(forces=[{"node": 1, "force": (0, 0, 1)}]) if k < 5 else rope
            ),
        ),
    ]


@compiled
@pytest.mark.parametrize("scene", scenes_of_all_kinds())
def test_what_is_said_to_be_compiled_is_what_is_called(scene: Scene) -> None:
    """Twin: no kernel is there where those are not that are asked for."""
    method, model = METHODS[scene.run.method], build(scene)
    simulation = Simulation(model, apart=True)
    engine = simulation._engine
    assert isinstance(engine, Islands)
    found = engine._crews.now(engine._ended)
    called = {True: crews.advance_beside, False: method.advance}
    needed = {called[crew.abreast] for crew in found}
    asked: set[Any] = set()

    def ask(kernel: Any, rare: int | None) -> bool:
        assert rare == model.system.rare
        asked.add(kernel)
        return kernel in needed

    with mock.patch.object(crews, "is_compiled", ask):
        assert progress.is_compiled(scene.run.method, model.system.rare, scene)
        assert asked == needed
        needed.clear()
        assert not progress.is_compiled(scene.run.method, model.system.rare, scene)


@pytest.mark.slow
@compiled
def test_a_run_of_ropes_abreast_leaves_what_was_asked_for() -> None:
    scene = ropes_of(4, 5, 3, "sdirk2", steps=3)
    Simulation(scene).advance_frames(1)
    assert progress.is_compiled("sdirk2", None, scene)


@compiled
def test_no_rope_of_the_live_view_goes_abreast() -> None:
    """It may get any law while it runs."""
    engine = Simulation(with_all_laws(build(ropes_of(4, 6, 3, "sdirk2"))))._engine
    assert isinstance(engine, Islands)
    assert not any(crew.abreast for crew in engine._crews.now(engine._ended))


@compiled
def test_those_that_are_left_of_five_go_on_abreast() -> None:
    """Else the kernel of a lonely rope would be compiled in the middle of a run."""

    def play(simulation: Simulation) -> Told:
        simulation.step()
        assert simulation._engine.end([0, 2])
        engine = simulation._engine
        assert isinstance(engine, Islands)
        return told(simulation.advance_frames(4))

    check(play, ropes_of(7, 5, 4, "sdirk2"), ropes_of(8, 10, 4, "implicit-euler"))


# -- what is told --------------------------------------------------------------------------


@compiled
@pytest.mark.parametrize("speed", [np.nan, 1e200])
@pytest.mark.parametrize("steps", [1, 3])
def test_a_step_without_solution_is_told_as_of_one_by_one(speed: float, steps: int) -> None:
    """By its number and time, in a frame's middle and in a later frame of a call."""

    def play(simulation: Simulation) -> Told:
        said: Told = []
        simulation.step()
        before = simulation.state
        thrown(simulation, 3, speed)
        said += [simulation.advance_steps(2 * steps), simulation.failure, simulation.time]
        simulation.restore(before)
        simulation.advance_frames(1)
        thrown(simulation, 3, speed)
        said += [*told(simulation.advance_frames(3)), simulation.failure, simulation.falls]
        said += [simulation.time, simulation.leave_behind()]
        return said + told(simulation.advance_frames(2))

    scene = ropes_of(5, 6, 3, "sdirk2")
    run = scene.run.model_copy(update={"time_step": 1.0 / 60.0 / steps, "frame_rate": 60.0})
    found = check(play, scene.replace(run=run))
    assert found[0] == UNSOLVED
    assert f"no solution of step {steps + 1} " in found[1]


@compiled
def test_one_that_breaks_is_told_as_of_one_by_one() -> None:
    """With others beside it that go on; to stop there, and to go on into the break."""

    def play(simulation: Simulation) -> Told:
        thrown(simulation, 2, 1e5)
        said = told(simulation.advance_frames(4, keep_going=True))
        said += told(simulation.advance_frames(3))
        said += [simulation.reason, simulation.falls, simulation.time, simulation.leave_behind()]
        return said + told(simulation.advance_frames(3))

    scene = ropes_of(6, 9, 4, "sdirk2")
    check(play, scene, scene.replace(run=scene.run.model_copy(update={"time_step": 1.0 / 180.0})))


@compiled
def test_calls_without_frames_note_what_has_changed() -> None:
    """Twin: it is noted once. Balances are among the numbers compared."""

    def play(simulation: Simulation) -> Told:
        simulation.step()
        before = numbers(simulation)
        simulation.velocities[4] += 0.3
        simulation.advance_frames(0)
        noted = numbers(simulation)
        simulation.velocities[4] -= 0.3
        simulation._prepare()
        assert numbers(simulation) != before
        return [noted]

    check(play, ropes_of(9, 6, 3, "sdirk2"))


# -- hands ---------------------------------------------------------------------------------


@compiled
def test_a_copy_of_ropes_abreast_goes_its_own_way() -> None:
    """Addresses of the original's arrays are not the copy's. Twin: the copy does move."""
    simulation = Simulation(ropes_of(11, 6, 4, "sdirk2"))
    simulation.step()
    stood = numbers(simulation)
    for other in (copy.copy(simulation), copy.deepcopy(simulation)):
        assert numbers(other) == stood
        other.step()
        assert numbers(simulation) == stood != numbers(other)
    engine = copy.deepcopy(simulation._engine._crews.mates[0])
    assert (
        engine.kept()[1].value.x
        is engine.engine.state.x
        is not simulation._engine.engines[0].state.x
    )
    simulation.step()
    assert numbers(simulation) == numbers(other)


@compiled
def test_a_force_by_hand_has_no_kernel_compiled() -> None:
    """A rope that is pushed stays with the others, and begins its stages where it always does."""

    def play(simulation: Simulation) -> Told:
        simulation.step()
        engine = simulation._engine
        assert isinstance(engine, Islands)
        simulation.apply_force(1, (0.0, 0.4, 0.2), "rope2")
        used = starts(simulation)
        simulation.step()
        more = starts(simulation) - used
        simulation.apply_force(1, (0.0, 0.0, 0.0), "rope2")
        simulation.step()
        assert more in (0.0, 2.0 * 4)  # two stages of all but the pushed one
        return [simulation.applied_forces.tobytes()]

    scene = ropes_of(12, 5, 4, "sdirk2")
    anchors = [one for one in scene.anchors if one.node == 0]
    run = scene.run.model_copy(update={"frame_rate": 60.0})
    check(play, scene.replace(anchors=anchors, run=run))


@compiled
def test_changes_between_frames_change_what_is_solved() -> None:
    """Stiffness, friction, masses, lengths, weight, a cut, anchors taken in hand, snapshots gone back to."""

    def play(simulation: Simulation) -> Told:
        state, said = simulation.arrays, told(simulation.advance_frames(2))
        begun = simulation.state
        for k, array in enumerate((state.stiffness, state.damping_vector, state.rest_length)):
            array[3 * k : 3 * k + 9] *= 0.7 + 0.2 * k
        said += told(simulation.advance_frames(1))
        state.mass[4] *= 1.5
        state.inverse_mass[4] = 1.0 / state.mass[4] if state.inverse_mass[4] > 0.0 else 0.0
        simulation.system.gravity[:] *= 0.5
        simulation._prepare()
        said += told(simulation.advance_frames(1))
        for array in (state.stiffness, state.damping_vector, state.rest_length):
            array[7] = 0.0  # cut
        simulation._prepare()
        said += told(simulation.advance_frames(2))
        for name in list(simulation.anchors)[:2]:
            if simulation.anchors[name].holds:
                simulation.anchors[name].move_to(simulation.anchors[name].position + 0.01)
        simulation.step()
        said += told(simulation.advance_frames(1))
        simulation.restore(begun)
        return said + told(simulation.advance_frames(2))

    check(play, ropes_of(13, 7, 5, "sdirk2"), ropes_of(14, 9, 4, "esdirk3"))


@compiled
def test_two_groups_and_lonely_ropes_go_on_from_a_snapshot() -> None:
    scene = ropes_of(15, 17, 4, "sdirk2")
    sizes = [4, 6, 4, 6, 4, 6, 4, 6, 4, 6, 4, 6, 4, 4, 4, 4, 9]
    scene = scene.replace(
        ropes=[rope.replace(segments=n) for rope, n in zip(scene.ropes, sizes, strict=True)]
    )

    def play(simulation: Simulation) -> Told:
        simulation.advance_frames(3)
        middle = simulation.state
        straight = told(simulation.advance_frames(3))
        resumed = Simulation(scene)
        resumed.restore(middle)
        assert told(resumed.advance_frames(3)) == straight
        assert numbers(resumed) == numbers(simulation)
        return straight

    check(play, scene)
    engine = Simulation(scene)._engine
    assert isinstance(engine, Islands)
    groups = [len(crew.numbers) for crew in engine._crews.now(engine._ended) if crew.abreast]
    assert sorted(groups) == [2, 6, 8]


@compiled
@pytest.mark.parametrize("ledger", [True, False])
def test_threads_change_no_bit(ledger: bool, monkeypatch: pytest.MonkeyPatch) -> None:
    scene = ropes_of(16, 33, 4, "sdirk2", steps=6)

    def moved() -> Told:
        simulation = Simulation(scene, ledger=ledger)
        return [*told(join(list(simulation.frames()))), numbers(simulation)]

    monkeypatch.setattr(islands, "threads", 1)
    first = moved()
    monkeypatch.setattr(islands, "threads", 3)
    monkeypatch.setattr(islands, "LONG", -1.0)
    for _ in range(5):
        assert moved() == first


@compiled
def test_each_thread_collects_what_its_ropes_have_recorded(monkeypatch: pytest.MonkeyPatch) -> None:
    """Where one thread did that for all, two were 1.4 times as fast as one."""
    seen = set[str]()
    collect = Frames.collect_lines

    def noted(frames: Frames, out: Recording, rows: int, numbers: Iterable[int]) -> None:
        seen.add(threading.current_thread().name)
        collect(frames, out, rows, numbers)

    monkeypatch.setattr(Frames, "collect_lines", noted)
    monkeypatch.setattr(islands, "threads", 2)
    monkeypatch.setattr(islands, "LONG", -1.0)
    Simulation(ropes_of(16, 33, 4, "sdirk2")).advance_frames(islands.FEW + 1)
    assert seen
    assert all(name.startswith("islands") for name in seen)
