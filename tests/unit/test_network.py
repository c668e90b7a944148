"""The sparse blocks of ropes that joints tie, against numpy's dense solver."""

from __future__ import annotations

import numpy as np
import pytest

from matrices import dense_saddle
from ropewalk.core.arrays import Joints
from ropewalk.core.elimination import least_degree, points_of, tied_network
from ropewalk.core.network import soften, solve_network
from ropewalk.core.saddle import Saddle
from unit.test_saddle import random_saddle

CASES = {
    "loop": (8, [], [[1, 7]]),
    "end to end": (9, [4], [[4, 5]]),
    "Y": (12, [3, 7], [[3, 7, 11]]),
    "cross": (14, [6], [[3, 10]]),
    "eight": (11, [], [[0, 5, 10]]),
    "next but one": (7, [], [[2, 4]]),
    "two loops through each other": (16, [7], [[0, 7], [8, 15], [3, 11]]),
}


def tied(case: str, seed: int, **more: bool) -> tuple[Saddle, np.ndarray]:
    """Random equations of ropes that are tied as in a case, and the number of every node's point."""
    nodes, ends, joints = CASES[case]
    saddle = random_saddle(nodes, seed, **more)
    alive = np.ones(nodes - 1, bool)
    alive[ends] = False
    member = np.array([node for joint in joints for node in joint])
    first = np.cumsum([0] + [len(joint) for joint in joints])
    table = Joints(first, member, np.zeros(0, np.int64))
    ties = np.ones(len(joints), np.int64)
    saddle.across[~alive], saddle.along[~alive], saddle.carries[~alive] = 0.0, 0.0, 0.0
    saddle.misfit[~alive], saddle.compliance[~alive] = 0.0, 1.0
    for band in saddle.band[1:3]:
        band[:-1][~alive] = 0.0
    for band in saddle.band[3:5] if len(saddle.band.upper2) else ():
        band[:-2][~(alive[:-1] & alive[1:])] = 0.0
    saddle.compliance[:] = np.maximum(saddle.compliance, 1e-6)
    number = points_of(table, ties, nodes)
    for joint in joints:
        saddle.free[joint] = saddle.free[joint].min()
    network = tied_network(table, ties, alive, len(saddle.band.upper2) > 0)
    return saddle._replace(network=network), number


def exact(saddle: Saddle, number: np.ndarray) -> np.ndarray:
    """The solution with the places of tied nodes as one unknown, (3 n + s,)."""
    n, points = number.size, int(number.max()) + 1
    free = saddle.free.copy()
    saddle.free[:] = 1.0
    matrix, right = dense_saddle(saddle)
    saddle.free[:] = free
    spread = np.zeros((4 * n - 1, 3 * points + n - 1))
    for i in range(n):
        spread[3 * i : 3 * i + 3, 3 * number[i] : 3 * number[i] + 3] = np.eye(3)
    spread[3 * n :, 3 * points :] = np.eye(n - 1)
    whole, forces = spread.T @ matrix @ spread, spread.T @ right
    for p in set(number[free == 0.0]):
        rows = slice(3 * p, 3 * p + 3)
        whole[rows], forces[rows] = 0.0, 0.0
        whole[rows, rows] = np.eye(3)
    return np.asarray(spread @ np.linalg.solve(whole, forces))


@pytest.mark.parametrize("case", CASES)
def test_a_network_solves_what_numpy_solves(case: str) -> None:
    """Simple equations, those with blocks that are not symmetric, and with second off-diagonals."""
    for seed in range(4):
        for more in ({}, {"blocks": True}, {"blocks": True, "second": True}):
            saddle, number = tied(case, seed, **more)
            solve_network(saddle)
            found = np.concatenate([saddle.moved.T.ravel(), saddle.pulled])
            answer = exact(saddle, number)
            assert np.abs(found - answer).max() < 1e-8 * np.abs(answer).max(), (case, seed, more)
            if all(saddle.free[joint].all() for joint in CASES[case][2]):
                number = np.arange(number.size)  # the twin: nothing is tied
                assert np.abs(found - exact(saddle, number)).max() > 1e-3 * np.abs(answer).max()


def test_a_rigid_link_is_softened_and_a_slack_one_is_not() -> None:
    """Only what carries needs an inverse of its compliance that is finite."""
    compliance = np.array([0.0, 1e-3, 0.0])
    soften(np.array([2.0, 2.0, 2.0]), np.array([1.0, 1.0, 0.0]), compliance)
    assert compliance.tolist() == [0.5e-9, 1e-3, 0.0]


def test_chains_fill_in_nothing_and_a_net_little() -> None:
    """A loop of m points has m + 1 to 2 m blocks; of a net nested squares would be some m log m."""
    m = 40
    ring = np.array([(i, (i + 1) % m) for i in range(m)])
    _, later = least_degree(m, ring)
    assert sum(map(len, later)) <= 2 * m
    k = 20
    pairs = [(i * k + j, i * k + j + 1) for i in range(k) for j in range(k - 1)]
    pairs += [(i * k + j, (i + 1) * k + j) for i in range(k - 1) for j in range(k)]
    order, later = least_degree(k * k, np.array(pairs))
    assert sorted(order) == list(range(k * k))
    assert sum(map(len, later)) < 12 * k * k  # row by row it would be 20 each
