"""Whether a rope is strung out, so that it touches nothing of itself: no pair that comes near is missed."""

from __future__ import annotations

import numpy as np
import pytest

from ropewalk.core.arrays import Floats, State, System
from ropewalk.laws.pairs.distance import NEVER, comes_to, nearest, relative_way
from ropewalk.laws.pairs.search import find_near
from ropewalk.laws.pairs.strung_out import is_strung_out
from ropewalk.laws.pairs.table import NEAR, REACH
from ropewalk.lowering import build
from ropewalk.scene import Contact, Material, Points, Rope, RunSettings, Scene

DIAMETER = 0.01


def of_points(points: Floats) -> tuple[System, State]:
    """Return a rope through points (n, 3) [m], as tables and state."""
    length = float(np.linalg.norm(np.diff(points, axis=0), axis=1).sum())
    rope = Rope(
        segments=len(points) - 1,
        length=length,
        diameter=DIAMETER,
        made_of=Material(EA=100.0, mass_per_length=0.1),
        shape=Points(points=points.tolist()),
    )
    run = RunSettings(method="implicit-euler", time_step=0.01)
    model = build(Scene(ropes=rope, contact=Contact(), run=run), drawn=False)
    return model.system, model.state


def wander(rng: np.random.Generator, piece: float, turn: float) -> Floats:
    """Return the nodes of a rope that wanders along an axis, (13, 3) [m]."""
    steps = rng.normal(size=3) + turn * rng.normal(size=(12, 3))
    steps *= piece / np.linalg.norm(steps, axis=1)[:, None]
    return np.vstack([np.zeros(3), np.cumsum(steps, axis=0)])


def nearest_on_way(x: Floats, y: Floats, skip: int) -> float:
    """Return how near segments that are no neighbours come on the way, over the diameter [1]."""
    least = np.inf
    for i in range(x.shape[1] - 1):
        for j in range(i + skip + 1, x.shape[1] - 1):
            start, way = nearest(x, y, 0.0, i, j)[2], relative_way(x, y, i, j)
            least = min(least, start, nearest(x, y, 1.0, i, j)[2])
            if comes_to(x, y, i, j, REACH * DIAMETER, start, way) < NEVER:
                least = min(least, REACH * DIAMETER)
    return least / DIAMETER


@pytest.mark.parametrize("piece", [0.004, 0.012, 0.03])
def test_what_is_strung_out_has_nothing_near_on_its_way(piece: float) -> None:
    """By all pairs, on the way between two random shapes; some shapes are, some are not."""
    rng, said = np.random.default_rng(3), [0, 0]
    for turn in (0.2, 0.5, 1.0):
        for _ in range(60):
            one, other = wander(rng, piece, turn), wander(rng, piece, turn)
            system, state = of_points(one)
            table, memory = system.node.contact, state.memory.contact
            x = np.ascontiguousarray(one.T)
            y = np.ascontiguousarray((one + 0.3 * (other - one)).T)
            strung = bool(is_strung_out(x, y, table, memory))
            said[strung] += 1
            if strung:
                assert nearest_on_way(x, y, int(table.skip[0])) > REACH
                assert find_near(x, y, table, memory, state.tied)
                assert memory.tally[NEAR] == 0
    assert min(said) > 5


def test_a_rope_that_comes_back_or_has_parted_is_not_strung_out() -> None:
    """A hairpin at either end of the way, a lost segment, a node that is no number."""
    line = np.outer(np.arange(9), (0.03, 0.0, 0.0))
    system, state = of_points(line)
    table, memory = system.node.contact, state.memory.contact
    x, pin = np.ascontiguousarray(line.T), line.copy()
    pin[5:, 0], pin[5:, 1] = line[4, 0] - 0.03 * np.arange(1, 5), 0.012
    y = np.ascontiguousarray(pin.T)
    lost = x.copy()
    lost[1, 3] = np.nan
    assert is_strung_out(x, x, table, memory)
    assert not is_strung_out(x, y, table, memory)
    assert not is_strung_out(y, x, table, memory)
    assert not is_strung_out(x, lost, table, memory)
    assert find_near(x, y, table, memory, state.tied)
    assert memory.tally[NEAR] > 0
    assert find_near(x, x, table, memory, state.tied)
    assert memory.tally[NEAR] == 0
    memory.rope[3] = -1
    assert not is_strung_out(x, x, table, memory)
