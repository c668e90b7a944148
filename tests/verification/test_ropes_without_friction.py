"""Contacts without friction: what keeps them from rocking drags on next to nothing, and its tangent is right.

That heaps of such ropes come to rest is asked in `test_heaps`.
"""

from __future__ import annotations

import math

import numpy as np
import pytest

from ropewalk.core.arrays import Floats
from ropewalk.laws.pairs.force import add_pair_forces
from ropewalk.laws.pairs.pair_tangent import along_pairs
from ropewalk.laws.pairs.table import CONTACTS, EASE
from ropewalk.simulation import Simulation
from verification.test_rope_on_rope import g, rails


@pytest.mark.parametrize("method", ["implicit-euler", "sdirk2"])
@pytest.mark.parametrize("degrees", [1.0, 20.0])
def test_a_bar_slides_as_if_nothing_held_it(method: str, degrees: float) -> None:
    """From rest, so that it is slow at first. With a spring for all that moves: 0.13 at a degree."""
    scene, down = rails(degrees, method, friction=0.0)
    simulation = Simulation(scene)
    for _ in range(30):
        simulation.step(1.0 / 60.0)
    speed = simulation.arrays.v[:, -1] @ down
    assert speed == pytest.approx(g * math.sin(math.radians(degrees)) * 0.5, rel=1e-3)


def test_the_tangent_is_that_of_the_force() -> None:
    """Where the springs are stretched; what they pull on one rope they pull back on others."""
    scene, _ = rails(1.0, "implicit-euler", friction=0.0)
    simulation = Simulation(scene)
    for _ in range(6):
        simulation.step(1.0 / 60.0)
    state, table = simulation.arrays, simulation.system.node.contact
    memory, rng = state.memory.contact, np.random.default_rng(0)
    memory.grip[: memory.tally[CONTACTS], EASE] = 20.0  # of a bar that turns
    x = state.x + 1e-5 * rng.normal(size=state.x.shape)

    def force(places: Floats) -> Floats:
        found = np.zeros((6, x.shape[1]))
        add_pair_forces(places, state.v, table, memory, found)
        return found[:3]

    assert np.abs(force(x).sum(axis=1)).max() < 1e-12
    for _ in range(3):
        d = rng.normal(size=x.shape)
        change = (force(x + 1e-8 * d) - force(x - 1e-8 * d)) / 2e-8
        along = along_pairs(x, state.v, d, table, memory, 1.0, 0.0)
        assert along == pytest.approx(-(d * change).sum(), rel=1e-6)
