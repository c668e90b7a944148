"""Ropes' numbers side by side: each lane is rounded as its number would be alone, in operations and sweep."""

from __future__ import annotations

import numpy as np
import pytest

from ropewalk.core import lane_rows as rows
from ropewalk.core.arrays import Floats
from ropewalk.core.jit import kernel
from ropewalk.core.lane_sweep import lane_sweep
from ropewalk.core.lanes import WIDTH, greater, load, pick, room, root, size, spread, store
from ropewalk.core.saddle import Saddle
from ropewalk.core.sweep import sweep
from unit.test_saddle import random_saddle


@kernel
def each(a, b, c, found):  # type: ignore[no-untyped-def]
    """Use every operation, of lanes and of lanes with a number."""
    for k in range(0, a.shape[0], WIDTH):
        x, y, z = load(a, k), load(b, k), load(c, k)
        value = -(x * y + z) / (x - 2.0 * y) * (1.0 / z) - (1.0 - y) * 3.0 + z / 7.0
        value = pick(x, y, value, root(size(z)))
        store(found, k, value + pick(spread(0.0), x, greater(size(y), size(z)), spread(0.25)))


def test_lanes_have_the_bits_of_numbers() -> None:
    rng = np.random.default_rng(5)
    a, b, c = rng.normal(size=(3, 50 * WIDTH)) * 10.0 ** rng.integers(-9, 9, (3, 50 * WIDTH))
    c[3], b[9], a[12] = np.inf, 0.0, 0.0
    found = np.zeros_like(a)
    with np.errstate(all="ignore"):
        each(a, b, c, found)
        value = -(a * b + c) / (a - 2.0 * b) * (1.0 / c) - (1.0 - b) * 3.0 + c / 7.0
        value = np.where(a < b, value, np.sqrt(abs(c)))
        expected = value + np.where(a > 0.0, np.maximum(abs(b), abs(c)), 0.25)
    np.testing.assert_array_equal(found, expected)
    assert len(np.unique(found)) > 0.9 * len(a)  # the lanes are not mixed up


def put_side_by_side(saddles: list[Saddle], work: Floats, inertia: float) -> None:
    """Write equations into lanes, one each; masses are inertia over what is the same of all."""
    lanes = work.reshape(rows.FIELDS, -1, WIDTH)
    for w, saddle in enumerate(saddles):
        n = len(saddle.free)
        for field, values in (
            (rows.FREE, saddle.free),
            (rows.MASS, saddle.inertia / inertia),
            (rows.ACROSS, saddle.across),
            (rows.BEND, saddle.along - saddle.across),
            (rows.ON, saddle.carries),
            (rows.COMPLIANCE, saddle.compliance),
            (rows.MISFIT, saddle.misfit),
        ):
            lanes[field, : len(values), w] = values
        lanes[rows.FORCE : rows.FORCE + 3, :n, w] = saddle.force
        lanes[rows.DIRECTION : rows.DIRECTION + 3, : n - 1, w] = saddle.direction


@pytest.mark.parametrize("nodes", [3, 4, 5, 8, 13, 50, 51, rows.MOST_NODES])
def test_the_sweep_of_many_ropes_has_the_bits_of_each(nodes: int) -> None:
    """Twin: a rope's solution is not that of the next one."""
    saddles = [random_saddle(nodes, seed) for seed in range(WIDTH)]
    inertia = 4.0  # a power of two: what is divided by it comes back
    for saddle in saddles:
        saddle.inertia[saddle.free == 0.0] = 1.0
    work = room(rows.FIELDS * rows.SPAN)
    put_side_by_side(saddles, work, inertia)
    lane_sweep(work, nodes, inertia)
    lanes = work.reshape(rows.FIELDS, -1, WIDTH)
    for w, saddle in enumerate(saddles):
        sweep(saddle)
        np.testing.assert_array_equal(lanes[rows.MOVED : rows.MOVED + 3, :nodes, w], saddle.moved)
        np.testing.assert_array_equal(lanes[rows.PULLED, : nodes - 1, w], saddle.pulled)
    assert not np.array_equal(saddles[0].moved, saddles[1].moved)
