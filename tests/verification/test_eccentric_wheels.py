"""Round bodies that turn freely about their own axis, with a mass off it: their weight turns them."""

from __future__ import annotations

import math

import numpy as np
import pytest

import ropewalk as rw
from ropewalk.scene import Cylinder, Spin, Straight
from verification.test_modes_of_pulleys import ARM, atwood

g, MASS, OFF, INERTIA = 9.81, 1.0, 0.02, 1e-3


def period(result: rw.Result, name: str, middle: float) -> float:
    """Twice the mean time between the moments at which a body goes through an angle [s]."""
    time, off = result.time, result.pulley(name).angle - middle
    through = np.flatnonzero((off[:-1] > 0.0) != (off[1:] > 0.0))
    share = off[through] / (off[through] - off[through + 1])
    times = time[through] + share * (time[through + 1] - time[through])
    assert len(times) > 2
    return float(2.0 * (times[-1] - times[0]) / (len(times) - 1))


def aside(swing: float) -> tuple[float, float, float]:
    """Where the mass is as it starts, turned by an angle back from hanging straight down [m]."""
    return (-OFF * math.sin(swing), 0.0, -OFF * math.cos(swing))


@pytest.mark.parametrize("method", ["semi-implicit-euler", "rk4", "sdirk2", "esdirk3"])
def test_a_disc_with_a_mass_off_its_axis_swings(method: str) -> None:
    """By 0.5 rad each way, T = 2 pi sqrt(I / m g d) (1 + a^2 / 16 + 11 a^4 / 3072); it stood still."""
    swing = 0.5
    disc = Cylinder(
        name="disc",
        start=(0, -0.02, 0),
        end=(0, 0.02, 0),
        radius=0.05,
        spin=Spin(free=True, inertia=INERTIA, mass=MASS, center_of_mass=aside(swing)),
    )
    rope = rw.Rope(
        segments=1,
        length=1.0,
        made_of=rw.Material(EA=2e3, mass_per_length=0.02),
        shape=Straight(start=(5, -0.5, 0), end=(5, 0.5, 0)),
    )
    run = {"method": method, "duration": 1.25, "time_step": 5e-4, "frame_rate": 400.0}
    anchors = [rw.Anchor(node=0), rw.Anchor(node=-1)]
    result = rw.simulate(rw.Scene(ropes=[rope], anchors=anchors, obstacles=[disc], run=run))
    wanted = 2.0 * math.pi * math.sqrt(INERTIA / (MASS * g * OFF))
    wanted *= 1.0 + swing**2 / 16.0 + 11.0 * swing**4 / 3072.0
    assert period(result, "disc", -swing) == pytest.approx(wanted, rel=5e-3)
    assert np.abs(result.pulley("disc").angle).max() == pytest.approx(2.0 * swing, rel=1e-2)


def test_it_takes_the_loads_along_that_hang_over_it() -> None:
    """Equal loads on a line that sticks to it: T = 2 pi sqrt((I + 2 m R^2) / m g d), but for the line."""
    scene, swing = atwood(inertia=INERTIA), 0.2
    wheel = scene.obstacles[0]
    spin = Spin(free=True, inertia=INERTIA, mass=MASS, center_of_mass=aside(swing))
    run = {"method": "sdirk2", "duration": 2.5, "time_step": 1e-3, "frame_rate": 200.0}
    result = rw.simulate(scene.replace(obstacles=[wheel.replace(spin=spin)], run=run))
    wanted = 2.0 * math.pi * math.sqrt((INERTIA + 2.0 * ARM**2) / (MASS * g * OFF))
    wanted *= 1.0 + swing**2 / 16.0
    assert period(result, "wheel", -swing) == pytest.approx(wanted, rel=0.01)
    loads = result.positions[:, [0, -1], 2]
    assert np.ptp(loads[:, 1]) == pytest.approx(2.0 * swing * ARM, rel=0.1)
    assert np.ptp(loads.mean(axis=1)) < 0.1 * np.ptp(loads[:, 1])
