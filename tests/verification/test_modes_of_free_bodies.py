"""Small motions of free bodies that are not round: a pendulum, and a plank that lies on a rope."""

from __future__ import annotations

import math

import numpy as np
import pytest

import ropewalk as rw
from ropewalk.scene import Box, SceneError
from verification.test_rest_of_free_bodies import MASS, OFF, g, hanging, plank, scene

INERTIA = 0.02


def ringing(body: Box) -> float:
    """The frequency at which it rings in a run from rest, by the times at which it turns back [Hz]."""
    struck = body.replace(spin=body.spin.replace(rate=2e-3))
    run = {"start": "at-rest", "duration": 2.0, "time_step": 5e-4, "frame_rate": 1000.0}
    result = rw.simulate(scene(struck, run=run))
    speed, time = result.pulley("plank").speed, result.time
    back = np.flatnonzero((speed[:-1] > 0.0) != (speed[1:] > 0.0))
    share = speed[back] / (speed[back] - speed[back + 1])
    times = time[back] + share * (time[back + 1] - time[back])
    assert len(times) > 4
    return float(0.5 * (len(times) - 1) / (times[-1] - times[0]))


def test_a_pendulum_swings_by_its_own_law() -> None:
    """omega^2 = m g d / I about the place where it hangs, not about that in which it is drawn."""
    found = rw.modes(hanging(), count=2)
    wanted = math.sqrt(MASS * g * OFF / INERTIA) / (2.0 * math.pi)
    assert np.abs(found.frequencies - wanted).min() < 1e-6 * wanted


def test_a_bearing_holds_it_in_small_motions() -> None:
    wanted = math.sqrt(MASS * g * OFF / INERTIA) / (2.0 * math.pi)
    found = rw.modes(hanging(bearing=0.01), count=3)
    assert np.abs(found.frequencies - wanted).min() > 1e-2 * wanted


@pytest.mark.parametrize("friction", [0.0, 0.5])
def test_a_plank_on_a_rope_rings_as_it_does_in_a_run(friction: float) -> None:
    """The twin, without how its contact turns along and falls with the angle, would be the rope's own."""
    body = plank((OFF, 0.0, 0.0)).replace(friction=friction)
    found = float(rw.modes(scene(body), count=3).frequencies[0])
    assert found == pytest.approx(ringing(body), rel=0.01)


def test_modes_are_about_the_angle_of_rest() -> None:
    """Without a rope to lie on and with its mass straight above: hanging below, at the same frequency."""
    above = plank((1e-3, 0.0, OFF))
    found = rw.modes(scene(above, place=5.0), count=3)
    wanted = math.sqrt(MASS * g * math.hypot(1e-3, OFF) / INERTIA) / (2.0 * math.pi)
    assert np.abs(found.frequencies - wanted).min() < 1e-6 * wanted


def test_what_is_drawn_is_no_rest_for_it() -> None:
    with pytest.raises(SceneError, match="about the equilibrium"):
        rw.modes(hanging(), about="start")
