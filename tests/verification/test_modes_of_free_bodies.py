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


def test_its_turning_is_told_as_its_own() -> None:
    """Where no rope is near none moves; on a rope it takes that along. The twins are the rope's own modes."""
    found = rw.modes(hanging(), count=4)
    wanted = math.sqrt(MASS * g * OFF / INERTIA) / (2.0 * math.pi)
    own = int(np.abs(found.frequencies - wanted).argmin())
    motion = found.motions[own]
    assert (motion.name, motion.rope) == ("turns", "plank")
    assert motion.turning == pytest.approx(1.0, abs=1e-9)
    assert np.abs(found.shapes[own]).max() < 1e-6
    for i in set(range(4)) - {own}:
        assert found.motions[i].name != "turns"
        assert np.linalg.norm(found.shapes[i], axis=1).max() == pytest.approx(1.0)
        assert found.motions[i].turning < 1e-9
    lies = rw.modes(scene(plank((OFF, 0.0, 0.0))), count=1)
    parts = lies.motions[0]
    assert parts.name == "turns"
    assert 0.5 < np.linalg.norm(lies.shapes[0], axis=1).max() <= 1.0
    assert parts.along + parts.in_plane + parts.out_of_plane + parts.turning == pytest.approx(1.0)


def test_of_an_unstable_rest_it_grows() -> None:
    found = rw.modes(scene(plank((0.0, 0.0, OFF)), place=5.0), count=1)
    rate = math.sqrt(MASS * g * OFF / INERTIA)
    assert found.decay_rates[0] == pytest.approx(-rate, rel=1e-6)
    assert found.motions[0].name == "turns"
