"""When a run is called broken: what was there to turn over, and what nothing gave."""

from __future__ import annotations

import math

import numpy as np
import pytest

from ropewalk.core.status import BROKEN, HONEST, OK, ZERO
from ropewalk.scene import (
    Anchor,
    Force,
    Kick,
    Limiter,
    Load,
    Material,
    Rope,
    RunSettings,
    Scene,
    Shake,
    Springs,
    Straight,
)
from ropewalk.simulation import Broken, Simulation


def rope(segments: int, k: float, mass: float, length: float, **more: object) -> Rope:
    made_of = Springs(spring_constant=k, node_mass=mass, segment_length=length, **more)
    shape = Straight(start=(0, 0, 0), end=(segments * length, 0, 0))
    return Rope(segments=segments, made_of=made_of, shape=shape)


def ends(scene: Scene, *, ledger: bool = True) -> tuple[int, Simulation]:
    """The status at a run's end and the simulation that stands there."""
    simulation = Simulation(scene, ledger=ledger)
    status = OK
    for block in simulation.frames():
        status = block.status
    return status, simulation


def go_on(simulation: Simulation, steps: int, duration: float | None = None) -> None:
    """Step so often, as a caller who owns the loop does."""
    for _ in range(steps):
        simulation.step(duration)


def shaken(method: str, **more: object) -> Scene:
    """Three weightless springs shaken along themselves by 1 mm, two whole periods every second."""
    motion = Shake(axis=(1, 0, 0), amplitude=1e-3, frequency=2.0)
    run = RunSettings(method=method, **({"duration": 5.0} | more))
    return Scene(
        ropes=[rope(3, 500.0, 0.01, 0.5)],
        gravity=(0, 0, 0),
        anchors=[Anchor(node=0, motion=motion)],
        run=run,
    )


@pytest.mark.parametrize("rate", [60.0, 2.0])
@pytest.mark.parametrize("method", ["semi-implicit-euler", "verlet"])
def test_a_sound_run_is_sound(method: str, rate: float) -> None:
    """What the anchor has given is zero again after every period, and at 2 frames a second in every frame."""
    for ledger in (True, False):
        status, simulation = ends(shaken(method, frame_rate=rate), ledger=ledger)
        assert status == OK
        assert simulation.time == pytest.approx(5.0)
        assert simulation.arrays.most[0] > 0.0


def limited(**more: object) -> Scene:
    """A rope between bounds, one end shaken along it against the other, which is held."""
    motion = Shake(axis=(1, 0, 0), amplitude=0.2, frequency=1.7)
    run = RunSettings(method="verlet", duration=3.0)
    made = Scene(
        ropes=[rope(20, 1000.0, 0.02, 0.1)],
        limiter=Limiter(min_stretch=0.9, max_stretch=1.01),
        anchors=[Anchor(name="a", node=0, motion=motion), Anchor(name="b", node=20)],
        run=run,
    )
    return made.replace(**more)


def torn(longest: float | None, method: str) -> Scene:
    """A cord of 0.52 m whose ends are drawn 0.55 m apart, at most `longest` times its length long."""
    cord = Rope(
        segments=6,
        length=0.521,
        made_of=Material(EA=38767.0, mass_per_length=0.111, axial_damping=2.5),
        loads=[Load(node=6, mass=0.419)],
        shape=Straight(start=(0, 0, 0.2), end=(0.52, 0, 0.2)),
    )
    motion = Shake(axis=(1, 0, 0), amplitude=0.03, frequency=0.95)
    return Scene(
        ropes=[cord],
        limiter=None if longest is None else Limiter(max_stretch=longest, passes=3),
        anchors=[Anchor(node=0), Anchor(node=6, motion=motion)],
        run=RunSettings(duration=1.1, frame_rate=240.0, method=method),
    )


@pytest.mark.parametrize("method", ["semi-implicit-euler", "verlet"])
def test_what_a_limiter_takes_and_puts_in_counts(method: str) -> None:
    """What it makes an explicit method make up it takes, or friction does, so that the ropes never have it:
    such a run went on to its end and told of 50 MN. The twins: bounds that hold nothing back, and none.
    """
    for ledger in (True, False):
        status, simulation = ends(torn(1.0, method), ledger=ledger)
        assert status == BROKEN
        assert simulation.time < 1.0
        assert "the limiter has" in simulation.reason
    assert ends(torn(1.08, method))[0] == ends(torn(None, method))[0] == OK


def test_constant_forces_turn_over_without_weight() -> None:
    """A force that draws a straight rope towards itself has potential below zero, and turns over its pull
    times the rope's length: a rope thrown against it is no broken one. The twin: with what nothing gave.
    """
    cord = rope(10, 200.0, 0.01, 0.1).replace(
        kicks=[Kick(node=10, velocity=(0, 2.0, 0))], forces=[Force(node=10, force=(5.0, 0, 0))]
    )
    scene = Scene(
        ropes=[cord],
        gravity=(0, 0, 0),
        anchors=[Anchor(node=0)],
        run=RunSettings(method="verlet", duration=1.0),
    )
    status, simulation = ends(scene)
    assert status == OK
    assert simulation.arrays.balance[HONEST] > 5.0
    twin = Simulation(scene)
    twin.arrays.balance[ZERO] -= 100.0
    assert twin.advance_frames(1).status == BROKEN


def test_what_a_limiter_does_is_no_excuse() -> None:
    """It moves nodes after the step and puts energy in, which counts as made up, with a ledger or without."""
    found = [ends(limited(), ledger=ledger) for ledger in (True, False)]
    assert [status for status, _ in found] == [BROKEN, BROKEN]
    assert found[0][1].time == found[1][1].time
    for _, simulation in found:
        assert "J more than at the start" in simulation.reason
    assert ends(limited(limiter=None))[0] == OK  # the twin


def test_the_reason_is_there() -> None:
    """An anchor that moves away pulls a segment to eleven lengths, with all energy accounted for."""
    scene = shaken("verlet", time_step=1e-4)
    simulation = Simulation(scene)
    simulation.take_in_hand(0)
    simulation.anchors["anchor0"].velocity = (-3000.0, 0.0, 0.0)
    with pytest.raises(
        Broken, match=r"segment 0 .* times its rest length; .* accounted for.*check"
    ):
        go_on(simulation, 100, 1e-4)


def test_what_hands_give_counts() -> None:
    """A kick of a thousand times the energy at the start, and a force that pulls for long, are no break."""
    simulation = Simulation(shaken("semi-implicit-euler"))
    simulation.advance_frames(10)
    simulation.velocities[3] = (0.0, 1.0, 0.0)
    assert simulation.advance_frames(60).status == OK
    simulation.apply_force(3, (0.0, 0.0, 0.5))
    assert simulation.advance_frames(120).status == OK
    twin = Simulation(shaken("semi-implicit-euler"))
    twin.advance_frames(10)
    twin.arrays.balance[0] -= 1.0  # a joule that nothing gave
    assert twin.advance_frames(60).status == BROKEN


def test_the_same_verdict_however_it_is_cut() -> None:
    """Frames at once, one by one, and in single steps."""
    whole = ends(limited())[1].time
    simulation = Simulation(limited())
    frames = 0
    while simulation.advance_frames(1).status == OK:
        frames += 1
    assert frames * simulation.plan.frame_interval == pytest.approx(whole)
    stepped = Simulation(limited())
    with pytest.raises(Broken):
        go_on(stepped, math.ceil(2.0 * whole / stepped.plan.frame_interval))
    assert stepped.time == pytest.approx(whole + stepped.plan.frame_interval)
    assert np.isfinite(stepped.positions).all()
