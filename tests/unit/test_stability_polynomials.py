"""The polynomials of one step against steps really taken, and the Jury margins against roots."""

from __future__ import annotations

import numpy as np
import pytest

from ropewalk.methods.characteristic import CHARACTERISTIC, UNCONDITIONAL, growth, is_stable
from verification.setups import implicit_step_matrix


def step(method: str, state: np.ndarray, a: float, b: float) -> np.ndarray:
    """One step of x'' + b x' + a x = 0 with dt = 1, written out from each method's definition."""

    def rate(y: np.ndarray) -> np.ndarray:
        return np.array([y[1], -a * y[0] - b * y[1]])

    x, v = state[0], state[1]
    if method == "euler":
        return state + rate(state)
    if method == "semi-implicit-euler":
        v = v - a * x - b * v
        return np.array([x + v, v])
    if method == "verlet":
        old = state[2]
        x = x + v + 0.5 * old
        new = -a * x - b * (v + old)
        return np.array([x, v + 0.5 * (old + new), new])
    if method in UNCONDITIONAL:
        Z = np.array([[0.0, 1.0], [-a, -b]])
        return implicit_step_matrix(method, Z) @ state
    if method == "heun":
        k1 = rate(state)
        k2 = rate(state + k1)
        return state + 0.5 * (k1 + k2)
    k1 = rate(state)
    k2 = rate(state + 0.5 * k1)
    k3 = rate(state + 0.5 * k2)
    k4 = rate(state + k3)
    return state + (k1 + 2 * k2 + 2 * k3 + k4) / 6


def step_matrix(method: str, a: float, b: float) -> np.ndarray:
    size = {"verlet": 3, "generalized-alpha": 3, "bdf2": 4}.get(method, 2)
    return np.column_stack([step(method, e, a, b) for e in np.eye(size)])


@pytest.mark.parametrize("method", CHARACTERISTIC)
def test_polynomial_is_that_of_the_step(method: str) -> None:
    rng = np.random.default_rng(1)
    for a, b in rng.uniform(0.0, 5.0, (200, 2)):
        expected = np.poly(step_matrix(method, a, b))
        np.testing.assert_allclose(CHARACTERISTIC[method](a, b), expected, atol=2e-12, rtol=1e-11)


@pytest.mark.parametrize("method", CHARACTERISTIC)
def test_a_wrong_polynomial_would_be_seen(method: str) -> None:
    expected = np.poly(step_matrix(method, 1.0, 0.3))
    wrong = CHARACTERISTIC[method](1.0, 0.3 * 1.0001)
    assert np.abs(wrong - expected).max() > 1e-6


@pytest.mark.parametrize("method", CHARACTERISTIC)
def test_margins_agree_with_the_spectral_radius(method: str) -> None:
    rng = np.random.default_rng(2)
    a, b = rng.uniform(0.0, 9.0, 4000), rng.uniform(0.0, 3.5, 4000)
    radius = growth(method, a, b)
    clear = np.abs(radius - 1.0) > 1e-9
    assert clear.mean() > 0.99
    np.testing.assert_array_equal(is_stable(method, a, b)[clear], (radius < 1.0)[clear])
    assert is_stable(method, a, b).any()
    assert is_stable(method, a, b).all() == (method in UNCONDITIONAL)


@pytest.mark.parametrize(
    ("method", "limit"),
    [("semi-implicit-euler", 2.0), ("verlet", 2.0), ("rk4", 2.0 * np.sqrt(2.0))],
)
def test_undamped_limits(method: str, limit: float) -> None:
    # Hairer, Norsett, Wanner: w dt <= 2, 2 and 2 sqrt 2.
    assert is_stable(method, (limit * (1 - 1e-9)) ** 2, 0.0)
    assert not is_stable(method, (limit * (1 + 1e-9)) ** 2, 0.0)


@pytest.mark.parametrize(
    ("method", "limit"),
    [
        ("euler", 0.2),
        ("semi-implicit-euler", 1.809975124),
        ("heun", 1.049754596),
        ("rk4", 2.950852958),
    ],
)
def test_limits_of_a_mode_with_a_tenth_of_critical_damping(method: str, limit: float) -> None:
    # closed forms, 1.2: a = y^2, b = 2 zeta y, zeta = 0.1.
    for factor, stable in ((1 - 1e-8, True), (1 + 1e-8, False)):
        y = limit * factor
        assert bool(is_stable(method, y * y, 0.2 * y)) is stable


def test_weak_growth_without_friction() -> None:
    # euler (1 + y^2)^(1/2), heun (1 + y^4/4)^(1/2) per step; Geometric Numerical Integration I.5.
    y = 0.3
    assert growth("euler", y * y, 0.0) == pytest.approx(np.sqrt(1 + y**2), rel=1e-13)
    assert growth("heun", y * y, 0.0) == pytest.approx(np.sqrt(1 + y**4 / 4), rel=1e-13)
    assert growth("rk4", y * y, 0.0) < 1.0
