"""The banded solvers against numpy's dense one."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np
import pytest

from matrices import dense_saddle
from ropewalk.core.band_sweep import band_sweep
from ropewalk.core.saddle import Saddle, make_saddle
from ropewalk.core.sweep import leaning_sweep, sweep

SIZES = (2, 3, 4, 5, 8, 13)


def random_saddle(nodes: int, seed: int, *, blocks: bool = False, second: bool = False) -> Saddle:
    """Return random equations: definite nodes, rigid and elastic segments, some slack, some held."""
    rng = np.random.default_rng(seed)
    saddle = make_saddle(nodes, second)
    saddle.free[:] = 1.0
    saddle.inertia[:] = rng.uniform(3.0, 5.0, nodes)
    saddle.across[:] = rng.uniform(-0.5, 2.0, nodes - 1)
    saddle.along[:] = rng.uniform(0.0, 2.0, nodes - 1)
    t = rng.normal(size=(3, nodes - 1))
    saddle.direction[:] = t / np.linalg.norm(t, axis=0)
    saddle.carries[:] = rng.uniform(size=nodes - 1) < 0.8
    saddle.compliance[:] = 10.0 ** rng.uniform(-16.0, 1.0, nodes - 1)
    saddle.compliance[saddle.carries == 0.0] = 0.5
    saddle.compliance[::3] *= saddle.carries[::3] == 0.0  # rigid ones
    saddle.force[:] = rng.normal(size=(3, nodes))
    saddle.misfit[:] = 0.1 * rng.normal(size=nodes - 1)
    if nodes > 3:
        saddle.free[[0, nodes // 2 + 1]] = 0.0
    if blocks:
        band = saddle.band
        for part in band[:5]:
            part[:] = 0.3 * rng.normal(size=part.shape)
    return saddle


def error(solver: Callable[[Saddle], None], saddle: Saddle) -> float:
    """Largest difference to the dense solution, over the largest unknown [1]."""
    solver(saddle)
    matrix, right = dense_saddle(saddle)
    exact = np.linalg.solve(matrix, right)
    found = np.concatenate([saddle.moved.T.ravel(), saddle.pulled])
    return float(np.abs(found - exact).max() / np.abs(exact).max())


def leaning_saddle(nodes: int, seed: int) -> Saddle:
    """Return random equations whose forces along the segments follow the nodes' motion."""
    saddle = random_saddle(nodes, seed)
    rng = np.random.default_rng(100 + seed)
    saddle.lean[:] = rng.normal(size=(3, nodes - 1))
    saddle.band.diagonal[:] = 0.3 * rng.normal(size=(nodes, 9))
    return saddle


@pytest.mark.parametrize("nodes", [*SIZES, 101, 300])
def test_rows_that_lean(nodes: int) -> None:
    """What numpy solves, to rounding; without a lean what `sweep` does. The twin leaves the lean out."""
    for seed in range(8):
        saddle = leaning_saddle(nodes, seed)
        assert error(leaning_sweep, saddle) < 1e-10
        assert error(sweep, saddle) > 1e-3
        straight = random_saddle(nodes, seed)
        sweep(straight)
        expected = straight.moved.copy(), straight.pulled.copy()
        leaning_sweep(straight)
        assert np.abs(straight.moved - expected[0]).max() < 1e-11 * np.abs(expected[0]).max()
        assert np.abs(straight.pulled - expected[1]).max() < 1e-10 * np.abs(expected[1]).max()


@pytest.mark.parametrize("nodes", SIZES)
def test_both_sweeps_solve_what_numpy_solves(nodes: int) -> None:
    """Rounding times the condition (some 1e3) only; the twin has one number of the matrix changed."""
    for seed in range(8):
        assert error(sweep, random_saddle(nodes, seed)) < 1e-11
        assert error(band_sweep, random_saddle(nodes, seed)) < 1e-11
        assert error(band_sweep, random_saddle(nodes, seed, blocks=True)) < 1e-11
        far = random_saddle(nodes, seed, blocks=True, second=True)
        assert error(band_sweep, far) < 1e-11
        matrix, right = dense_saddle(far)
        far.inertia[1] += 0.5
        other = np.linalg.solve(dense_saddle(far)[0], right)
        assert np.abs(other - np.linalg.solve(matrix, right)).max() > 1e-6


def test_stiffness_does_not_spoil_the_solution() -> None:
    """Compliance 1e-16 m/N and rigid links give the same numbers; nothing grows with 1 / e."""
    stiff, rigid = random_saddle(40, 3), random_saddle(40, 3)
    for saddle, e in ((stiff, 1e-16), (rigid, 0.0)):
        saddle.carries[:], saddle.compliance[:] = 1.0, e
        saddle.free[:] = 1.0
        sweep(saddle)
    assert np.abs(stiff.pulled - rigid.pulled).max() < 1e-12 * np.abs(rigid.pulled).max()
    lengths = (rigid.direction * np.diff(rigid.moved, axis=1)).sum(axis=0)
    assert np.abs(lengths + rigid.misfit).max() < 1e-13  # what was asked for


def test_a_taut_rigid_chain_between_two_held_nodes_has_no_solution() -> None:
    """Straight, rigid, both ends held: the tensions are undetermined, and that shows."""
    saddle = random_saddle(3, 0)
    saddle.free[:] = (0.0, 1.0, 0.0)
    saddle.carries[:], saddle.compliance[:] = 1.0, 0.0
    saddle.across[:], saddle.along[:] = 0.0, 0.0
    saddle.direction[:] = np.array([[1.0], [0.0], [0.0]])
    sweep(saddle)
    assert not np.isfinite(saddle.pulled).all()
    saddle.compliance[:] = 1e-12
    sweep(saddle)
    assert np.isfinite(saddle.pulled).all()
