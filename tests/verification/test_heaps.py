"""A handful of the random heaps (`heaps` runs as many as one likes), and the yardstick they are judged by."""

from __future__ import annotations

import numpy as np
import pytest

from ropewalk.scene import Contact
from ropewalk.simulation import Simulation
from verification.heaps import STEP, Heap, knot_of_pile, links_of, passes, pile, run, watch
from verification.tangles import tangle

ONE = np.array([[-1.0, 1.0, 0.0, 0.0], [0.0, 0.0, -1.0, 1.0], [0.0, 0.0, 0.5, 0.5]])
TWO = np.array([[0, 1], [2, 3]])


def moved(shift: tuple[float, float, float]) -> np.ndarray:
    """The first of two crossed bars stays, the other is shifted."""
    after = ONE.copy()
    after[:, 2:] += np.array(shift)[:, None]
    return after


def test_a_bar_through_another_is_seen() -> None:
    """And not one that goes beside it, stops short of it or goes past its end."""
    assert passes(ONE, moved((0.0, 0.0, -1.0)), TWO) == 1
    assert passes(ONE, moved((0.0, 0.0, -0.4)), TWO) == 0
    assert passes(ONE, moved((3.0, 0.0, -1.0)), TWO) == 0
    assert passes(ONE, moved((0.5, 0.0, 0.0)), TWO) == 0
    turned = moved((0.0, 0.0, 0.0))
    turned[:, 2:] = [[-0.5, 0.5], [0.0, 0.1], [-0.5, -0.5]]
    assert passes(ONE, turned, TWO) == 1


@pytest.mark.slow
@pytest.mark.parametrize("seed", [0, 1, 6, 9])
def test_a_pile_comes_to_rest_and_none_passes(seed: int) -> None:
    """All steps solved, unknotted as ever, no energy made up, no deeper than a tenth; it lies still."""
    heap = run("pile", seed, seed % 2 == 1)
    assert heap.unsolved == 0
    assert heap.passed == 0
    assert heap.changed == 0
    assert heap.energy < 1.02
    assert heap.contacts > 5
    assert heap.deepest < 0.1
    assert heap.rest < 0.01
    assert heap.middle < 1e-6
    assert heap.lying < 1e-6
    assert heap.creep < 0.04  # of what hangs from the hand and still swings


@pytest.mark.slow
@pytest.mark.parametrize(("kind", "seed"), [("pile", 4), ("tangle", 16), ("tangle", 20)])
def test_a_heap_without_friction_comes_to_rest(kind: str, seed: int) -> None:
    """A node or two of these rocked at 7 to 20 mm/s for ever."""
    scene = pile(seed, False) if kind == "pile" else tangle(seed, 1 + seed % 3, False)
    scene = scene.replace(contact=Contact(friction=0.0))
    heap = watch(scene, Heap(kind, seed, False), None if kind == "pile" else 12.0)
    assert heap.unsolved == 0
    assert heap.passed == 0
    assert heap.deepest < 0.1
    assert heap.rest < 0.006
    assert heap.lying < 1e-4


@pytest.mark.slow
def test_the_twin_without_contact_passes() -> None:
    """Else the count above would show nothing."""
    scene = pile(0, False).replace(contact=None)
    simulation, links, passed = Simulation(scene), links_of(scene), 0
    assert knot_of_pile(simulation.arrays.x) == 1
    for _ in range(150):
        before = simulation.arrays.x.copy()
        simulation.step(STEP)
        passed += passes(before, simulation.arrays.x, links)
    assert passed > 0
