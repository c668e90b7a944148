"""Bending in motion: energy, momentum, friction, buckling, vibration, and the bound of the time step."""

from __future__ import annotations

import math

import numpy as np
import pytest

from ropewalk.analysis.stability import stability
from ropewalk.api import simulate
from ropewalk.lowering.steps import predicted_step
from ropewalk.record.result import Result
from ropewalk.scene import Air, Anchor, Clamp, Points, RunSettings, Straight, Velocity
from ropewalk.simulation import Broken, Simulation
from verification.rods import Rod, clamped, order, rod
from verification.setups import off


def run_for(duration: float, dt: float, method: str = "verlet", rate: float = 100.0) -> RunSettings:
    return RunSettings(
        duration=duration, frame_rate=rate, time_step=dt, steps="exact", method=method
    )


def turned(dt: float, method: str) -> Result:
    """A rope that falls from a clamp, which is lifted and turned for a while, with friction."""
    clamp = Clamp(direction=(1, 0, 0), turn_axis=(0, 1, 0), turn_rate=2.0, start=0.05, stop=0.25)
    scene = rod(
        10,
        EI=0.05,
        EA=1e3,
        mass=0.2,
        bending_damping=1e-3,
        gravity=(0.0, 0.0, -9.81),
        anchors=[Anchor(node=0, clamp=clamp, motion=Velocity(velocity=(0, 0, 0.3)))],
        run=run_for(0.3, dt, method, 20.0),
    )
    return simulate(scene)


def test_the_ledger_closes_with_bending_and_a_turning_clamp() -> None:
    """Change of kinetic energy = works, to round-off; total energy = works without a potential, to the
    method's order. Twin: without the work of the turning clamp a tenth of a joule is missing.
    """
    found = [turned(dt, "verlet") for dt in (2e-4, 1e-4)]
    for result in found:
        assert np.abs(result.balance_residual).max() < 1e-13
    errors = [float(np.abs(result.energy_error).max()) for result in found]
    assert errors[-1] < 1e-5
    assert order(errors) == pytest.approx(2.0, abs=0.3)
    clamps = found[-1].work["clamps"]
    assert np.abs(found[-1].energy_error + clamps - clamps[0]).max() > 0.03
    assert found[-1].work["friction"][-1] < -1e-3
    assert {"bending"} <= set(found[-1].energy)
    assert found[-1].moments.shape == (7, 1, 3)
    assert np.abs(found[-1].moments[:, 0, 1]).max() > 0.1


def test_a_released_clamp_lets_go_of_the_direction() -> None:
    """Within a rope, with its anchor: from then on nothing holds the rope, which keeps its
    momentum, and the node bends as any other. What was stored against the clamp is lost: its work.
    Twin: before the release the momentum changes.
    """
    held = [clamped(3, (1, 0, 0.5), release_time=0.1)]
    scene = rod(10, EI=0.05, EA=1e3, mass=0.2, anchors=held, run=run_for(0.3, 2e-4))
    simulation = Simulation(scene)
    assert simulation.arrays.bending_stiffness[3] == 0.0
    result = simulate(scene)
    after = result.time > 0.1005
    assert np.ptp(result.momentum[after], axis=0).max() < 1e-13
    assert np.ptp(result.momentum[~after], axis=0).max() > 1e-3
    assert np.abs(result.energy_error).max() < 1e-4
    assert not result.moments[after].any()
    simulation.step(0.2)
    assert simulation.arrays.bending_stiffness[3] == simulation.arrays.bending_stiffness[4]


def test_bending_keeps_momentum_and_angular_momentum() -> None:
    """A bent, damped, free rope, thrown: both stay to round-off while its energy falls. Twin: without
    damping the energy stays.
    """
    rng = np.random.default_rng(2)
    angle = np.linspace(0.0, 3.0, 11)
    points = np.array([np.sin(angle), 0.2 * angle**2, np.cos(angle)]).T / 3.0
    for damping in (2e-3, 0.0):
        kicks = [{"node": i, "velocity": tuple(rng.normal(size=3))} for i in range(11)]
        scene = rod(
            10, EI=0.05, EA=1e3, mass=0.2, anchors=[], bending_damping=damping,
            shape=Points(points=points), run=run_for(0.3, 1e-4),
        )  # fmt: skip
        scene = scene.replace(ropes=[scene.ropes[0].replace(kicks=kicks)])
        result = simulate(scene)
        assert np.abs(result.balance_residual).max() < 1e-13
        for kept in (result.momentum, result.angular_momentum):
            assert np.ptp(kept, axis=0).max() < 1e-12
        total = result.energy["total"]
        lost = 1.0 - total[-1] / total[0]
        assert (lost > 0.5) if damping else (abs(lost) < 2e-3)


def test_a_column_buckles_above_euler_s_load_only() -> None:
    """Clamped below, pressed at its free end by a dead load: pi^2 EI / 4 L^2 (5.1). At 0.95 of it a small
    push dies out in air, at 1.05 it grows. The linear rate is w1 sqrt(|P/Pc - 1|) ~ 0.8 1/s.
    """
    n = 10
    critical = 4.0 * n**2 * math.sin(0.25 * math.pi / n) ** 2
    largest = {}
    for share in (0.95, 1.05):
        scene = rod(n, EA=1e4, run=run_for(8.0, 5e-4, "semi-implicit-euler", 10.0))
        simulation = Simulation(scene.replace(air=Air(node_drag=0.1)))
        simulation.apply_force(-1, (-share * critical, 0.0, 0.0))
        simulation.arrays.v[1] = 1e-4 * np.linspace(0.0, 1.0, n + 1) ** 2
        path = [abs(simulation.positions[-1, 1])]
        for _ in range(80):
            simulation.step()
            path.append(abs(simulation.positions[-1, 1]))
        largest[share] = (max(path[:20]), max(path[-20:]))
    assert largest[0.95][1] < 0.3 * largest[0.95][0]
    assert largest[1.05][1] > 3.0 * largest[1.05][0]


def test_a_cantilever_swings_at_its_first_frequency() -> None:
    """Started in its first mode at 0.1 mm: the period of the run is that of the stiffness matrix, by zero
    crossings over 5 periods. Verlet's own phase error is (w dt)^2 / 24 < 1e-7. Twin: the second mode's.
    """
    n = 10
    about = Rod(rod(n, EA=1e4))
    mass = about.mass[about.free]
    matrix = about.stiffness() / np.sqrt(mass[:, None] * mass)
    squares, modes = np.linalg.eigh(matrix)
    first = np.zeros(3 * (n + 1))
    first[about.free] = modes[:, 0] / np.sqrt(mass)
    first *= 1e-4 / np.abs(first).max()
    frequency = math.sqrt(squares[0])
    simulation = Simulation(rod(n, EA=1e4, run=run_for(9.0, 5e-4, "verlet", 200.0)))
    simulation.arrays.x[...] += first.reshape(-1, 3).T
    direction = first.reshape(-1, 3)[-1]
    heights, times = [], []
    for _ in range(1900):
        simulation.step()
        heights.append(float((simulation.positions[-1] - [1.0, 0.0, 0.0]) @ direction))
        times.append(simulation.time)
    h, t = np.array(heights), np.array(times)
    at = np.flatnonzero(np.sign(h[1:]) != np.sign(h[:-1]))
    zeros = t[at] - h[at] * (t[at + 1] - t[at]) / (h[at + 1] - h[at])
    measured = math.pi / float(np.diff(zeros).mean())
    assert measured == pytest.approx(frequency, rel=1e-4)
    assert abs(math.sqrt(squares[2]) / frequency - 1.0) > 5.0


BEAMS = {
    "clamped": [clamped()],
    "pinned": [Anchor(node=0), Anchor(node=-1)],
    "clamped twice": [clamped(), clamped(-1)],
    "clamped within": [clamped(4)],
}


def soft(n: int) -> float:
    """EA so small that bending alone decides: a thousandth of 4 EI / l^2."""
    return 4.0 * n**2 / 1000.0


@pytest.mark.parametrize("name", BEAMS)
def test_the_bound_from_both_sides(name: str) -> None:
    """1 % below the predicted step a straight beam's noise stays as small, 5 % above it breaks."""
    n = 12
    anchors = BEAMS[name]
    scene = rod(n, EA=soft(n), anchors=anchors)
    bound = stability(scene).bound
    # the infinite chain has w = 4 sqrt(EI / (mu l^4)); 0.1 % of stretch comes on top
    assert bound == pytest.approx(2.0 / (4.0 * n**2), rel=0.06)
    largest = []
    for share in (0.99, 1.05):
        run = run_for(2000 * share * bound, share * bound, "semi-implicit-euler", 1e-3)
        run = run.replace(frame_rate=1.0 / (100 * share * bound))
        simulation = Simulation(scene.replace(run=run))
        start = 1e-9 * np.random.default_rng(1).normal(size=(2, n + 1))
        simulation.arrays.x[1:] += start * (simulation.arrays.inverse_mass > 0.0)
        try:
            for _ in range(4):
                simulation.step(500 * share * bound)
            largest.append(float(np.abs(simulation.positions[:, 1:]).max()))
        except Broken:
            largest.append(math.inf)
    assert largest[0] < 1e-7
    assert largest[1] > 1e-4


def test_the_bound_holds_for_bent_shapes() -> None:
    """2 / w_max of the exact tangent is never below the predicted step, for random bends up to 40 degrees
    a node, with and without natural curvature. Twin: the bound of the straight rope is too long for some.
    """
    rng = np.random.default_rng(7)
    n, straight_fails = 8, 0
    for trial in range(40):
        angles = np.cumsum(rng.uniform(-0.7, 0.7, n))
        tilt = np.cumsum(rng.uniform(-0.3, 0.3, n)) * (trial % 2)
        steps = np.array(
            [np.cos(angles) * np.cos(tilt), np.sin(tilt), np.sin(angles) * np.cos(tilt)]
        ).T
        points = np.concatenate([[np.zeros(3)], np.cumsum(steps, axis=0)]) / n
        curled = (0.0, 3.0 * (trial % 3), 0.0)
        scene = rod(n, EA=soft(n), shape=Points(points=points), anchors=[], curvature=curled)
        about = Rod(scene)
        true = 2.0 / about.frequencies()[-1]
        found = predicted_step(about.system, about.state, "semi-implicit-euler")
        assert found <= true
        straight = Rod(rod(n, EA=soft(n), anchors=[]))
        plain = predicted_step(straight.system, straight.state, "semi-implicit-euler")
        straight_fails += plain > true
    assert straight_fails > 5


def test_the_largest_EI_is_that_of_the_step() -> None:
    """At the EI that `check` gives for a step, that step is the bound. Twin: at twice that it breaks."""
    n = 12
    scene = rod(n, EA=soft(n), run=run_for(0.1, 1e-3, "semi-implicit-euler"))
    found = stability(scene)
    assert found.largest_bending_stiffness is not None
    for factor, holds in ((0.999, True), (2.0, False)):
        made_of = scene.ropes[0].made_of.replace(EI=factor * found.largest_bending_stiffness)
        again = stability(scene.replace(ropes=[scene.ropes[0].replace(made_of=made_of)]))
        assert again.stable is holds
    assert any("EI <=" in remedy for remedy in again.remedies)
    assert off(again.largest_bending_stiffness, found.largest_bending_stiffness) < 1e-6


@pytest.mark.parametrize("method", ["implicit-euler", "sdirk2", "bdf2", "esdirk3"])
@pytest.mark.parametrize("sags", [True, False])
def test_rods_with_much_friction_of_bending_find_solutions(method: str, sags: bool) -> None:
    """Nearly straight, where the plane of bends is next to nothing, they sag off the axes or swing round.

    Both ended without a solution: steps of Newton's method were too short for what turns the plane, and the
    rate of bends was lost in that of the rod's own turning.
    """
    direction = (0.8, 0.6, 0.0) if sags else (0.6, 0.0, 0.8)
    scene = rod(
        20,
        EI=20.0 if sags else 200.0,
        EA=1e4,
        length=1.0 if sags else 0.5,
        bending_damping=20.0 if sags else 2.0,
        anchors=[clamped(direction=direction)],
        gravity=(0.0, 0.0, -9.81),
        shape=Straight(end=direction) if sags else None,
        run=run_for(0.5 if sags else 0.12, 1.0 / 240.0 if sags else 1e-3, method, 240.0),
    )
    result = simulate(scene)
    assert np.abs(result.balance_residual).max() < 1e-6
