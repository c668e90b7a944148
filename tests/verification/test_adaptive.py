"""Steps of varying length: error against the tolerance, events, bits, books.

References: `verlet` in steps of 2 us, another method and no events, and `esdirk3` in short ones for a stiff
rope. How far errors of steps add up depends on the motion; 200 tolerances within a second is what the falling
ropes here stay below (about 100 are measured), 2000 where things hit (about 300).
"""

from __future__ import annotations

import math
from functools import cache
from pathlib import Path
from typing import Any

import numpy as np
import pytest

import ropewalk as rw
from ropewalk.core.status import OK, UNSOLVED
from ropewalk.engine.unsolved import describe
from ropewalk.lowering import build
from ropewalk.methods.controller import ERROR, break_times, largest_inner_error
from ropewalk.record.resume import resume_run
from ropewalk.record.run import record_run
from ropewalk.scene import (
    Anchor,
    Clamp,
    Ground,
    Material,
    Rope,
    RunSettings,
    Scene,
    SceneError,
    Shake,
    Table,
    Velocity,
    Winch,
)
from ropewalk.simulation import Broken, Simulation
from ropewalk.simulation.block import Block
from verification.setups import run

RATE = 64.0  # a power of two, so that frames of all rates are at the same times to the last bit
SOFT = Material(EA=200.0, mass_per_length=0.1, axial_damping=0.5)
LIMP = SOFT.replace(tension_only=True)
TIGHT = (1e-4, 1e-5, 1e-6, 1e-7)
ZIGZAG = {"kind": "points", "points": [(0.1 * i, 0.05 * (i % 2), 0.0) for i in range(5)]}


def settings(tolerance: float = 1e-5, duration: float = 0.5, **more: Any) -> RunSettings:
    given = {"frame_rate": RATE, "method": "adaptive"} | more
    return RunSettings(duration=duration, tolerance=tolerance, **given)


def falling(made_of: Material = SOFT, segments: int = 10, **more: Any) -> Scene:
    rope = Rope(segments=segments, length=1.0, made_of=made_of, shape={"kind": "straight"})
    return Scene(ropes=[rope], anchors=[Anchor(node=0)], run=settings(**more))


def landing(**more: Any) -> Scene:
    shape = {"kind": "straight", "start": (0, 0, 0.3), "direction": (1, 0, 0.2)}
    rope = Rope(segments=4, length=1.0, made_of=SOFT, shape=shape)
    return Scene(ropes=[rope], ground=Ground(height=0.0), run=settings(**more))


def jerking(**more: Any) -> Scene:
    rope = Rope(segments=4, length=1.0, made_of=LIMP, shape=ZIGZAG)
    return Scene(ropes=[rope], anchors=[Anchor(node=0)], run=settings(**more))


def pulled(**more: Any) -> Scene:
    shape = {"kind": "straight", "start": (0, 0, 0), "end": (1.02, 0, 0)}
    rope = Rope(segments=10, length=1.0, made_of=SOFT, shape=shape)
    motion = Velocity(velocity=(0, 0.5, 0.5), start=0.1234, stop=0.4321)
    anchors = [Anchor(name="a", node=0, motion=motion), Anchor(name="b", node=-1)]
    return Scene(ropes=[rope], anchors=anchors, run=settings(**more))


def places(scene: Scene) -> tuple[np.ndarray, Simulation]:
    """Positions of all frames (f, n, 3) [m]."""
    film = run(scene)
    return film.x, film.simulation


@cache
def exact(make: Any, duration: float, step: float = 2e-6) -> np.ndarray:
    return places(make(duration=duration, method="verlet", time_step=step))[0]


def errors(make: Any, tolerances: tuple[float, ...], duration: float = 0.5) -> tuple[list, list]:
    """Largest error of any node in any frame [m], and the steps taken, for several tolerances."""
    found, steps = [], []
    for tolerance in tolerances:
        x, simulation = places(make(tolerance=tolerance, duration=duration))
        found.append(float(np.linalg.norm(x - exact(make, duration), axis=2).max()))
        steps.append(simulation.step_counts["accepted"])
    return found, steps


@pytest.mark.parametrize("make", [falling, pulled])
def test_error_goes_with_the_tolerance(make: Any) -> None:
    """Below 200 tolerances, in proportion to it; steps as the inverse cube root of it.

    `pulled` has a motion that starts and stops between frames. Twin: a thousandth of the steps' bound.
    """
    found, steps = errors(make, TIGHT)
    for tolerance, error in zip(TIGHT, found, strict=True):
        assert tolerance < error < 200.0 * tolerance
    slope = np.polyfit(np.log(TIGHT), np.log(found), 1)[0]
    assert 0.8 < slope < 1.15
    assert -0.40 < np.polyfit(np.log(TIGHT), np.log(steps), 1)[0] < -0.28


@pytest.mark.parametrize("make", [landing, jerking])
def test_events_are_cut(make: Any) -> None:
    """Ground and slack segments: errors in proportion to the tolerance, below 2000 of them.

    Twin: as many steps of the same method, all equal, that step over what happens.
    """
    tolerances = (1e-4, 1e-5, 1e-6)
    found, steps = errors(make, tolerances, 1.0)
    for tolerance, error in zip(tolerances, found, strict=True):
        assert error < 2000.0 * tolerance
    assert found[2] < 0.02 * found[0]
    blind, _ = places(make(duration=1.0, method="esdirk3", time_step=1.0 / steps[2]))
    assert np.linalg.norm(blind - exact(make, 1.0), axis=2).max() > 5.0 * found[2]


def test_steps_end_where_the_scene_changes() -> None:
    """All times that a scene gives to releases, motions, corners, clamps and winches."""
    rope = Rope(segments=10, length=1.0, made_of=Material(EA=1e3, EI=0.1, mass_per_length=0.1))
    corner = Table(times=[0.2, 0.5, 0.9], positions=[(0, 0, 0), (0, 0, 1), (0, 0, 1.5)])
    anchors = [
        Anchor(name="a", node=0, motion=corner),
        Anchor(name="b", node=4, motion=Velocity(velocity=(0, 0, 1), start=0.3, stop=0.6)),
        Anchor(name="c", node=7, release_time=0.7),
        Anchor(
            name="d", node=-1, clamp=Clamp(direction=(1, 0, 0), turn_rate=1.0, start=0.4, stop=0.8)
        ),
    ]
    times = break_times(build(Scene(ropes=[rope], anchors=anchors)).system)
    assert times.tolist() == [0.2, 0.3, 0.4, 0.5, 0.6, 0.7, 0.8, 0.9]
    smooth = corner.replace(interpolation="cubic")
    times = break_times(build(Scene(ropes=[rope], anchors=[Anchor(node=0, motion=smooth)])).system)
    assert times.tolist() == [0.2, 0.9]
    still = rope.replace(made_of=Material(EA=1e3, mass_per_length=0.1))
    winch = Winch(end="start", speed=0.1, start=0.25, stop=0.75)
    system = build(Scene(ropes=[still], anchors=[Anchor(node=0)], winches=[winch])).system
    assert break_times(system).tolist() == [0.25, 0.75]


@pytest.mark.parametrize("tolerance", [1e-7, 1e-8, 1e-9])
def test_no_event_stops_the_walk(tolerance: float) -> None:
    """Two masses fall on the ground and are through in a bounded number of tries, whatever the tolerance.

    A step to an event is cut to EVENT_STEP, which rounding makes a little longer: it was cut again for ever.
    """
    rope = Rope(
        segments=1,
        length=1.0,
        made_of=SOFT,
        shape={"kind": "straight", "start": (0, 0, 0.1), "end": (1, 0, 0.1)},
    )
    run = RunSettings(duration=0.16, frame_rate=50.0, method="adaptive", tolerance=tolerance)
    ground = Ground(height=0.0, repulsion=80.0, friction=0.0, absorption=0.0)
    simulation = Simulation(Scene(ropes=[rope], ground=ground, run=run))
    tries: list[int] = []
    simulation.slices.most = 50
    simulation.slices.note = lambda steps, seconds: tries.append(steps)  # type: ignore[method-assign]
    simulation.slices.asked = lambda: sum(tries) > 3000
    assert simulation.advance_frames(8).frames == 8
    assert simulation.positions[:, 2].max() < 0.0


def test_a_release_has_its_own_time() -> None:
    """A mass let go at an odd time falls freely from then on, to rounding."""
    rope = Rope(segments=1, length=1.0, made_of=SOFT, shape={"kind": "straight"})
    when = 0.1234
    anchors = [Anchor(node=0, release_time=when), Anchor(node=1, release_time=when)]
    x, simulation = places(Scene(ropes=[rope], anchors=anchors, run=settings()))
    fallen = max(0.0, simulation.time - when)
    assert x[-1, :, 2] == pytest.approx(-0.5 * 9.81 * fallen**2, abs=1e-13)


def test_stiff_rope_and_its_tension() -> None:
    """EA 1e7: places, and the tension in every frame, against esdirk3 in steps of 1/61440 s.

    Twin: a cubic through two frames' places and velocities, the usual dense output, whose tension half way is
    off by more than all of it.
    """
    wire = SOFT.replace(EA=1e7)
    scene = falling(wire, segments=20, tolerance=1e-6)
    fine = run(falling(wire, segments=20, method="esdirk3", time_step=1.0 / 61440.0))
    film = run(scene)
    assert np.linalg.norm(film.x - fine.x, axis=2).max() < 200e-6
    own, other = film.block.recording.tension[8:, 0], fine.block.recording.tension[8:, 0]
    scale = float(np.abs(other).mean())
    assert np.abs(own - other).max() < 0.05 * scale
    h, x, v = 1.0 / RATE, fine.x[8:], fine.v[8:]
    middle = 0.5 * (x[:-1] + x[1:]) + h / 8.0 * (v[:-1] - v[1:])
    stretch = np.linalg.norm(middle[:, 1] - middle[:, 0], axis=1) - 0.05
    assert np.abs(1e7 / 0.05 * stretch).max() > scale


BETWEEN = (  # what is of the interval since the frame before
    *("tension_low", "tension_high", "stretch_high", "speed_high", "lowest", "highest"),
    *("extremes", "extreme_places", "extreme_since", "extreme_until"),
    *("reaction_high", "moment_high", "error_range", "error_times"),
)


def same(a: Block, b: Block, every: int = 1) -> bool:
    """Compare what two blocks hold; what lies between two frames only where their intervals are the same."""
    for name, p, q in zip(a.recording._fields, a.recording, b.recording, strict=True):
        if every > 1 and name in BETWEEN:
            continue
        if not np.array_equal(p[every - 1 :: every], q, equal_nan=True):
            return False
    return True


@pytest.mark.parametrize("make", [falling, landing, pulled])
def test_the_recording_changes_no_bit(make: Any) -> None:
    """Other rates, blocks, a snapshot, no ledger. Twin: a tolerance 1 % off."""
    whole = Simulation(make()).advance_frames(32)
    seldom = Simulation(make(frame_rate=RATE / 4))
    assert same(whole, seldom.advance_frames(8), 4)
    assert not same(whole, Simulation(make(tolerance=0.99e-5)).advance_frames(32))
    simulation = Simulation(make())
    for _ in range(20):
        simulation.step()
    snapshot, before = simulation.state, simulation.step_counts
    simulation.advance_frames(5)
    simulation.restore(snapshot)
    assert simulation.step_counts == before
    simulation.advance_frames(12)
    assert np.array_equal(whole.recording.x[-1], simulation.arrays.x)
    bare = Simulation(make(), ledger=False).advance_frames(32)
    assert np.array_equal(whole.recording.x, bare.recording.x)


@pytest.mark.slow
def test_a_winch_turns_after_each_step() -> None:
    """First order, as stated: errors fall with the steps, whatever is recorded; no bit changes."""

    def winding(**more: Any) -> Scene:
        shape = {"kind": "straight", "start": (0, 0, 0), "end": (1.02, 0, 0)}
        rope = Rope(segments=10, length=1.0, made_of=SOFT, shape=shape)
        winch = Winch(end="start", speed=0.3, start=0.2, stop=0.55)
        anchors = [Anchor(node=0), Anchor(node=-1)]
        return Scene(ropes=[rope], anchors=anchors, winches=[winch], run=settings(**more))

    fine = run(winding(method="verlet", time_step=1e-5)).x
    errors, steps = [], []
    for tolerance in (1e-4, 1e-6):
        film = run(winding(tolerance=tolerance))
        errors.append(float(np.linalg.norm(film.x - fine, axis=2).max()))
        steps.append(film.simulation.step_counts["accepted"])
    assert errors[1] < 2.0 * errors[0] * steps[0] / steps[1]
    assert errors[1] < 3e-3
    whole = Simulation(winding()).advance_frames(32)
    assert same(whole, Simulation(winding(frame_rate=RATE / 4)).advance_frames(8), 4)


def test_what_hands_do_is_seen() -> None:
    """A kick, a force, an anchor taken in hand: the walk begins anew from what is shown."""
    free = Rope(segments=1, length=1.0, made_of=SOFT, shape={"kind": "straight"})
    scene = Scene(ropes=[free], gravity=(0, 0, 0), run=settings())
    simulation = Simulation(scene)
    simulation.advance_frames(4)
    simulation.velocities[:] = (0, 0, 1.0)
    simulation.step(16 / RATE)
    assert simulation.positions[:, 2] == pytest.approx(16 / RATE, rel=1e-12)
    simulation.apply_force(0, (0, 0, 0.1))
    simulation.apply_force(1, (0, 0, 0.1))
    simulation.step(16 / RATE)
    assert simulation.velocities[:, 2] == pytest.approx(1.0 + 0.1 / 0.05 * 16 / RATE, rel=1e-9)
    held = Simulation(pulled())
    held.advance_frames(4)
    held.anchors["b"].velocity = (0, 0, 2.0)
    held.advance_frames(8)
    assert held.anchors["b"].position[2] == pytest.approx(2.0 * 8 / RATE, rel=1e-12)


def test_the_books_close() -> None:
    """Kinetic energy less all works is rounding; what the method loses is small, and smaller to a tighter
    tolerance. The motion's jumps of velocity are the anchor's work."""
    for make in (landing, pulled):
        losses = []
        for tolerance in (1e-4, 1e-6):
            film = run(make(tolerance=tolerance))
            size = float(film.block.recording.energy[:, 0].max())
            assert np.abs(film.residual()).max() < 1e-11 * size
            losses.append(float(np.abs(film.energy_error()).max()))
        assert losses[1] < 0.1 * losses[0]


def test_a_run_reports_and_resumes(tmp_path: Path) -> None:
    """Counts in table, repr, dataset and folder; killed and resumed it is the same run, counts and all."""

    class Killed(BaseException):
        pass

    def kill(done: int, planned: int, block: Block) -> None:
        if done > 10:
            raise Killed

    scene = landing(duration=1.0)
    whole = rw.simulate(scene)
    counts = whole.facts.step_counts
    assert counts["accepted"] > 50
    assert counts["rejected"] > 5
    assert whole.table["rejected steps"] == counts["rejected"]
    assert f"{counts['accepted']} steps to a tolerance of 0.01 mm" in repr(whole)
    assert whole.dataset.attrs["accepted_steps"] == counts["accepted"]
    assert whole.dataset.attrs["tolerance"] == 1e-5
    with pytest.MonkeyPatch.context() as patch:
        patch.setattr("ropewalk.record.run.chunk_frames", lambda simulation: 8)
        with pytest.raises(Killed):
            record_run(scene, tmp_path / "run", progress=kill, commit_seconds=0.0)
        resumed = resume_run(tmp_path / "run", commit_seconds=0.0)
    assert resumed.facts.step_counts == counts
    assert resumed.dataset.attrs["rejected_steps"] == counts["rejected"]
    for name in whole.source.names:
        assert np.array_equal(whole.read(name), resumed.read(name), equal_nan=True), name


def test_a_violent_start_is_taken_in_small_steps() -> None:
    """Steel stretched to five times its length: a fixed step has no solution, shorter ones do."""
    shape = {"kind": "straight", "start": (0, 0, 0), "end": (5.0, 0, 0)}
    wire = SOFT.replace(EA=1e9, axial_damping=0.0)
    rope = Rope(segments=10, length=1.0, made_of=wire, shape=shape)
    scene = Scene(ropes=[rope], anchors=[Anchor(node=0)], run=settings(1e-3, 1.0 / RATE))
    simulation = Simulation(scene)
    assert simulation.advance_frames(1).status == OK
    assert simulation.step_counts["rejected"] > 0
    assert simulation.step_counts["shortest"] < 1e-4


def test_the_shortest_step_ends_the_run_with_words() -> None:
    """An anchor that shakes two hundred million times a second: stopped before the first frame."""
    shake = Shake(axis=(0, 0, 1), amplitude=1.0, frequency=2e8)
    rope = Rope(segments=4, length=1.0, made_of=SOFT, shape={"kind": "straight"})
    anchors = [Anchor(node=0, motion=shake)]
    simulation = Simulation(Scene(ropes=[rope], anchors=anchors, run=settings(1e-9)))
    block = simulation.advance_frames(2)
    assert (block.status, block.frames) == (UNSOLVED, 0)
    assert "adaptive needs steps below 1e-09 s at t = " in simulation.failure
    assert "of rope 'rope'" in simulation.failure
    assert "larger tolerance" in simulation.failure
    assert np.array_equal(simulation.positions, Simulation(simulation.scene).positions)
    with pytest.raises(Broken, match="adaptive needs steps below"):
        simulation.step()
    assert simulation.time < 1e-9  # that of the last accepted step, not of the frame
    z = math.sin(2.0 * math.pi * 2e8 * simulation.time)
    assert simulation.positions[0, 2] == pytest.approx(z, abs=1e-9)


def test_a_segment_that_errs_is_told_as_a_segment() -> None:
    """Of what segments remember the error is a segment's; its number stood there as a node's."""
    stuff = SOFT.replace(relaxing_EA=100.0, relaxation_time=0.1)
    simulation = Simulation(falling(stuff, 4))
    scratch = simulation._engine.scratch
    lengths, rates = np.full(4, 0.25), np.zeros((2, 4))
    rates[1, 2] = 1.0
    scratch.walk.control[ERROR] = 0.0
    largest_inner_error(
        rates, np.array([0.5, 0.5]), np.array([1.0, 0.0]), 1e-2, lengths, scratch.walk.control
    )
    told = describe(simulation.model, simulation.state.state, (0.0, 1.0, 0), scratch)
    assert "at segment 2 of rope 'rope' its estimated error is 0.00125 m" in told


def test_what_is_refused() -> None:
    for value in (0.0, 1e-10, math.nan):
        with pytest.raises(SceneError, match="tolerance"):
            RunSettings(tolerance=value)
