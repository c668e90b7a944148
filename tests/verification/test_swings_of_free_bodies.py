"""A boom on a pivot that swings through half a turn and back, and touches no rope, against its pendulum."""

from __future__ import annotations

import math
from functools import cache
from typing import Any

import numpy as np
import pytest
from scipy.integrate import solve_ivp

import ropewalk as rw
from ropewalk.core.arrays import Floats
from ropewalk.engine.unsolved import describe
from ropewalk.laws.wheel_rows import RATES
from ropewalk.methods.controller import ERROR, largest_turning_error
from ropewalk.scene import Anchor, Box, Material, Rope, RunSettings, Scene, Spin, Straight
from ropewalk.simulation import Simulation

g, MASS, OFF, TIP, LASTS = 9.81, 2.0, 0.3, 0.6, 1.5
INERTIA = MASS * OFF**2 + MASS * (0.6**2 + 0.04**2) / 12.0


def boom(method: Any, **more: Any) -> Scene:
    """A boom that lies flat and is let go; a short rope hangs beside it, at rest."""
    spin = Spin(free=True, inertia=INERTIA, mass=MASS, pivot=(0, 0, 0))
    body = Box(
        name="boom", center=(OFF, 0, 0), half_sizes=(0.3, 0.02, 0.02), edge_radius=0.005,
        axis=(0, 1, 0), spin=spin,
    )  # fmt: skip
    rope = Rope(
        segments=4, length=0.4, diameter=0.01,
        made_of=Material(EA=1e4, mass_per_length=0.1, axial_damping=5.0),
        shape=Straight(start=(3, 0, 0), direction=(0, 0, -1)),
    )  # fmt: skip
    run = RunSettings(**({"duration": LASTS, "frame_rate": 60.0, "method": method} | more))
    return Scene(ropes=[rope], anchors=[Anchor(node=0)], obstacles=[body], run=run)


@cache
def pendulum() -> Any:
    """I w' = m g d cos(angle), from rest at 0: angle and rate over time."""
    torque = MASS * g * OFF
    found = solve_ivp(
        lambda t, y: [y[1], torque * math.cos(y[0]) / INERTIA],
        (0.0, LASTS + 0.01), [0.0, 0.0], rtol=1e-11, atol=1e-12, dense_output=True,
    )  # fmt: skip
    return found.sol


def off(result: rw.Result) -> float:
    """By how much the boom's tip is off at most [m]."""
    angle: Floats = result.pulley("boom").angle
    return float(TIP * np.abs(angle - pendulum()(result.time)[0]).max())


def test_adaptive_swings_a_body_to_its_tolerance() -> None:
    """It was 5 cm off at any: the error of nodes alone was looked at."""
    for tolerance in (1e-4, 1e-5, 1e-6):
        assert off(rw.simulate(boom("adaptive", tolerance=tolerance))) < 200.0 * tolerance


@pytest.mark.parametrize(
    ("method", "order"), [("implicit-euler", 1), ("sdirk2", 2), ("bdf2", 2), ("esdirk3", 3)]
)
def test_a_body_swings_in_the_order_of_the_method(method: str, order: int) -> None:
    coarse, fine = (off(rw.simulate(boom(method, time_step=1.0 / n))) for n in (480, 960))
    assert math.log2(coarse / fine) == pytest.approx(order, abs=0.2)


@pytest.mark.parametrize(
    ("method", "step"),
    [("implicit-euler", 1 / 60), ("sdirk2", 1 / 120), ("bdf2", 1 / 120), ("rk4", None),
     ("semi-implicit-euler", 2e-5)],
)  # fmt: skip
def test_what_a_method_loses_of_a_swing_is_its_energy_error(method: str, step: Any) -> None:
    """It was in the work of the body's weight, and none was told."""
    chosen = {"time_step": step} if step else {}
    result = rw.simulate(boom(method, **chosen))
    body, alone = result.pulley("boom"), rw.simulate(boom(method, **chosen).replace(obstacles=()))
    gained = MASS * g * OFF * np.sin(body.angle)
    np.testing.assert_allclose(body.weight_work, gained, atol=1e-9)
    assert (body.rope_work == 0.0).all()
    assert (body.bearing_work == 0.0).all()
    lost = body.energy - gained
    error = result.energy_error
    np.testing.assert_allclose(error, alone.energy_error + lost, atol=1e-7)
    steps = result.energy_errors
    assert (steps[1:, 0] <= error[1:] + 1e-7).all()
    assert (steps[1:, 1] >= error[1:] - 1e-7).all()
    table = result.table
    assert ("of the energy turned over" in table.get("about the energy", "")) is (step == 1 / 60)
    share = table["largest energy error, share of the energy turned over [%]"]
    assert share == pytest.approx(100.0 * np.abs(steps).max() / np.ptp(gained), rel=0.05)


def test_a_run_whose_steps_get_too_short_for_a_body_names_it() -> None:
    simulation = Simulation(boom("adaptive"))
    state, scratch = simulation.state.state, simulation._engine.scratch
    b, other, wheel = np.array([0.5, 0.5]), np.array([1.0, 0.0]), state.memory.obstacle.wheel
    control = scratch.walk.control
    control[ERROR] = 1e-3
    for rate, error in ((0.2, 1e-3), (0.5, 0.5 * 0.5 * 1e-2 * scratch.reach[0])):
        wheel[0, RATES + 1] = rate
        largest_turning_error(wheel, b, other, 1e-2, scratch.reach, 4, control)
        assert control[ERROR] == pytest.approx(error)
    assert TIP <= scratch.reach[0] < 1.1 * TIP
    told = describe(simulation.model, state, (0.0, 1.0, 0), scratch)
    assert f"at pulley 'boom' its estimated error is {error:.3g} m" in told
