"""Random tangles and piles of closed ropes: every step is solved, and none passes through another.

What tells is how they are knotted and linked (`topology`), which knows nothing of contacts.
"""

from __future__ import annotations

import pytest

from ropewalk.laws.pairs.distance import nearest
from ropewalk.laws.pairs.table import FAULT, NEAR
from ropewalk.methods.verdict import energy_now
from ropewalk.simulation import Simulation
from verification.tangles import kind_of, tangle


def least_distance(simulation: Simulation) -> float:
    """The least distance of two segments over their diameter, 1 at most."""
    table, state = simulation.system.node.contact, simulation.arrays
    memory, least = state.memory.contact, 1.0
    for i, j in memory.near[: memory.tally[NEAR]]:
        size = table.radius[i] + table.radius[j]
        least = min(least, nearest(state.x, state.x, 0.0, int(i), int(j))[2] / size)
    return least


@pytest.mark.slow
@pytest.mark.parametrize("bends", [False, True])
@pytest.mark.parametrize("first", [0, 20, 40])
def test_random_tangles_fall_in_a_heap_and_none_passes(first: int, bends: bool) -> None:
    """Of twenty each: all steps solved, same knots and links, no deeper than a tenth, no energy made up."""
    for seed in range(first, first + 20):
        scene = tangle(seed, 1 + seed % 3, bends)
        simulation = Simulation(scene)
        before = kind_of(scene, simulation.arrays.x)
        first_energy = energy_now(simulation.system, simulation.arrays)
        for frame in range(45):
            simulation.step(1.0 / 60.0)  # a step without solution would raise
            state = simulation.arrays
            assert state.memory.contact.tally[FAULT] == 0
            assert least_distance(simulation) > 0.9 - 1e-9, seed
            assert energy_now(simulation.system, state) < 1.02 * first_energy, seed
            if frame % 9 == 8:
                assert kind_of(scene, state.x) == before, (seed, frame)
