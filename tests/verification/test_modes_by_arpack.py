"""Why damped modes have a solver of their own: where shift-invert by scipy (ARPACK) fails; decision 34."""

from __future__ import annotations

import numpy as np
import pytest

import ropewalk as rw
from ropewalk import theory
from ropewalk.lowering import build
from ropewalk.scene import Straight
from ropewalk.vibration import quadratic
from ropewalk.vibration.linear import Linear, linearise

M, K, LENGTH = 0.01, 1000.0, 0.05  # [kg, N/m, m]


def taut(ropes: int, segments: int, chord: float, c: float) -> tuple[Linear, float, np.ndarray]:
    """Return straight ropes side by side with friction c [N s/m], their T/r [N/m], the factors of waves."""
    stuff = rw.Springs(
        spring_constant=K, node_mass=M, segment_length=LENGTH, spring_friction=c, friction="vector"
    )
    made = tuple(
        rw.Rope(
            name=f"r{i}",
            segments=segments,
            made_of=stuff,
            shape=Straight(start=(0, 0, i), end=(segments * chord, 0, i)),
        )
        for i in range(ropes)
    )
    anchors = tuple(rw.Anchor(rope=rope.name, node=node) for rope in made for node in (0, -1))
    model = build(rw.Scene(gravity=(0, 0, 0), ropes=made, anchors=anchors))
    push = K * (chord - LENGTH)
    tension = np.where(model.state.stiffness > 0.0, push, 0.0)
    linear = linearise(model, model.state.x, tension)
    return linear, push / chord, theory.chain_factors(segments - 1)


def arpack(linear: Linear, count: int, seed: int, **options: object) -> np.ndarray:
    """Return the `count` slowest eigenvalues by scipy, from one random vector, the slowest first."""
    from scipy.sparse.linalg import LinearOperator, eigs

    inverse = quadratic.shifted(linear, 0.0)
    size = 2 * linear.mass.size
    operator = LinearOperator((size, size), matvec=lambda both: inverse.apply(both.reshape(-1, 1)))
    start = np.random.default_rng(seed).normal(size=size)
    found = 1.0 / eigs(operator, k=count, v0=start, return_eigenvectors=False, **options)
    return found[np.argsort(np.abs(found))]


def off(found: np.ndarray, exact: np.ndarray) -> float:
    """Return the largest relative error of the slowest modes, one of each pair."""
    upper = found[found.imag > 0.0]
    upper = upper[np.argsort(np.abs(upper), kind="stable")][: len(exact)]
    return float(np.abs(upper / exact[: len(upper)] - 1.0).max()) if len(upper) else np.inf


def test_of_equal_ropes_modes_are_missed_and_nothing_says_so() -> None:
    """Twelve equal ropes: every frequency is there 24 times; a space from one vector has it once."""
    linear, push, mu = taut(12, 30, 0.06, 0.01)
    rate = 0.5 * 0.01 * mu / M
    exact = np.repeat(-rate + 1j * np.sqrt(push * mu / M - rate**2), 24)[:24]
    for seed in range(3):
        assert off(arpack(linear, 52, seed, tol=1e-9), exact) > 0.1
    values, _, _ = quadratic.slowest(linear, 24)
    assert off(values, exact) < 1e-9


def test_a_crowd_of_creeping_waves_does_not_part() -> None:
    """Strong friction: the slow roots of all short waves lie within 1e-10 of each other, each twice."""
    from scipy.sparse.linalg import ArpackNoConvergence

    c = 2000.0
    linear, push, mu = taut(1, 301, 0.06, c)
    mu = np.sort(mu)[::-1][:10]
    slow = 2.0 * push * mu / (c * mu + np.sqrt((c * mu) ** 2 - 4.0 * M * push * mu))
    with pytest.raises(ArpackNoConvergence):
        arpack(linear, 48, 0, ncv=96, maxiter=30)
    values, _, _ = quadratic.slowest(linear, 20)
    found = np.sort(np.abs(values))[:20]
    np.testing.assert_allclose(found, np.repeat(slow, 2), rtol=1e-10)
