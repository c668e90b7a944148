"""Bounds of chains against closed forms and against the eigenvalues of the whole step matrix."""

from __future__ import annotations

import math
from collections.abc import Sequence

import numpy as np
import pytest

from ropewalk.methods.bound import (
    Chain,
    friction_matrix,
    growth_per_step,
    highest_frequency,
    largest_step,
    largest_stiffness_factor,
    meter,
    stiffness_matrix,
    worst_mode,
)
from ropewalk.methods.characteristic import CHARACTERISTIC, UNCONDITIONAL
from ropewalk.methods.tridiagonal import (
    largest_eigenvalue,
    largest_eigenvector,
    smallest_eigenvalue,
)

METHODS = tuple(name for name in CHARACTERISTIC if name not in UNCONDITIONAL)


def chain(
    nodes: int,
    k: float,
    m: float = 0.05,
    c: float = 0.05,
    held: Sequence[int] = (0,),
    axial: float = 0.0,
    drag: float = 0.0,
) -> Chain:
    free = np.ones(nodes, dtype=bool)
    free[list(held)] = False
    s = nodes - 1
    return Chain(
        np.full(nodes, m),
        np.full(s, k),
        np.full(s, c),
        np.full(s, axial),
        np.zeros(nodes),
        np.full(nodes, drag),
        free,
    )


def fixed_fixed(n: int) -> float:
    """Return mu_max of n free masses between two pins."""
    return 4.0 * math.sin(n * math.pi / (2 * (n + 1))) ** 2


def fixed_free(n: int) -> float:
    return 4.0 * math.sin((2 * n - 1) * math.pi / (2 * (2 * n + 1))) ** 2


def dense(matrix: tuple[np.ndarray, np.ndarray]) -> np.ndarray:
    diagonal, beside = matrix
    return np.diag(diagonal) + np.diag(beside, 1) + np.diag(beside, -1)


def step_matrix(method: str, K: np.ndarray, C: np.ndarray, dt: float) -> np.ndarray:
    """The matrix of one step for the whole chain, from the definition of the method."""
    n = K.shape[0]
    one, zero = np.eye(n), np.zeros((n, n))
    if method == "semi-implicit-euler":
        v = np.hstack([-dt * K, one - dt * C])
        return np.vstack([np.hstack([one, zero]) + dt * v, v])
    if method == "verlet":
        x = np.hstack([one, dt * one, 0.5 * dt * dt * one])
        f = -K @ x - C @ np.hstack([zero, one, dt * one])
        v = np.hstack([zero, one, 0.5 * dt * one]) + 0.5 * dt * f
        return np.vstack([x, v, f])
    z = dt * np.block([[zero, one], [-K, -C]])
    order = {"euler": 1, "heun": 2, "rk4": 4}[method]
    return sum(np.linalg.matrix_power(z, p) / math.factorial(p) for p in range(order + 1))


def radius(method: str, found: Chain, dt: float, axial: bool = True) -> float:
    K = dense(stiffness_matrix(found))
    C = dense(friction_matrix(found, axial))
    return float(np.abs(np.linalg.eigvals(step_matrix(method, K, C, dt))).max())


def random_chain(rng: np.random.Generator, nodes: int) -> Chain:
    free = rng.random(nodes) > 0.15
    free[1] = True
    return Chain(
        rng.uniform(0.02, 0.3, nodes),
        rng.uniform(50.0, 900.0, nodes - 1),
        rng.uniform(0.05, 0.6, nodes - 1),
        np.zeros(nodes - 1),
        rng.uniform(0.0, 300.0, nodes) * (rng.random(nodes) > 0.5),
        rng.uniform(0.0, 0.5, nodes),
        free,
    )


def test_eigenvalues_agree_with_lapack() -> None:
    rng = np.random.default_rng(3)
    for n in (1, 2, 3, 10, 77):
        diagonal, beside = rng.normal(size=n), rng.normal(size=n - 1)
        full = dense((diagonal, beside))
        values, vectors = np.linalg.eigh(full)
        assert largest_eigenvalue(diagonal, beside) == pytest.approx(values[-1], abs=1e-14 * n)
        assert smallest_eigenvalue(diagonal, beside) == pytest.approx(values[0], abs=1e-14 * n)
        vector = np.empty(n)
        largest_eigenvector(diagonal, beside, values[-1], vector, np.empty(n))
        expected = vectors[:, -1] / vectors[np.abs(vectors[:, -1]).argmax(), -1]
        np.testing.assert_allclose(vector, expected, atol=1e-9)


@pytest.mark.parametrize("n", [1, 2, 3, 4, 5, 8, 10, 20, 40])
def test_stiffness_limit_of_short_chains_at_60_hz(n: int) -> None:
    # k mu dt^2/m + 2 c mu dt/m = 4 (seed systems 3.3), mu of n masses between two pins.
    dt = 1.0 / 60.0
    expected = 4.0 / fixed_fixed(n) * 0.05 / dt**2 - 2.0 * 0.05 / dt
    found = chain(n + 2, 100.0, held=(0, n + 1))
    factor = largest_stiffness_factor("semi-implicit-euler", found, dt)
    assert 100.0 * factor == pytest.approx(expected, rel=1e-9)
    table = {1: 354, 2: 234, 3: 205, 4: 193, 5: 187, 8: 179.6, 10: 177.7, 20: 175.0, 40: 174.3}
    assert 100.0 * factor == pytest.approx(table[n], abs=0.51 if table[n] > 180 else 0.051)


def test_three_pins_are_two_chains_between_pins() -> None:
    # 19 free masses in each section: 175.1 N/m; a chain of 39 free masses would give 174.3.
    dt = 1.0 / 60.0
    found = chain(41, 100.0, held=(0, 20, 40))
    expected = 4.0 / fixed_fixed(19) * 180.0 - 6.0
    factor = largest_stiffness_factor("semi-implicit-euler", found, dt)
    assert 100.0 * factor == pytest.approx(expected, rel=1e-9)
    without = largest_stiffness_factor("semi-implicit-euler", chain(41, 100.0, held=(0, 40)), dt)
    assert abs(100.0 * without - expected) > 0.5


RATES = {30: 42, 50: 120, 60: 174, 75: 274, 90: 396, 120: 708, 144: 1022, 500: 12450}


@pytest.mark.parametrize("rate", RATES)
def test_long_chain_limits(rate: int) -> None:
    # k_max = m f^2 - 2 c f (seed systems 3.3); at 60 Hz 120 with c = 0.5, and none from c = 1.5 on.
    factor = largest_stiffness_factor("semi-implicit-euler", chain(20001, 100.0), 1.0 / rate)
    assert 100.0 * factor == pytest.approx(0.05 * rate**2 - 2 * 0.05 * rate, rel=1e-6)
    assert 100.0 * factor == pytest.approx(RATES[rate], abs=0.51)
    if rate == 60:
        for c, limit in ((0.5, 120.0), (1.4, 12.0)):
            damped = chain(20001, 100.0, 0.05, c)
            factor = largest_stiffness_factor("semi-implicit-euler", damped, 1.0 / 60.0)
            assert 100.0 * factor == pytest.approx(limit, rel=1e-5)
        damped = chain(20001, 1e-6, 0.05, 1.5001)
        assert largest_step("semi-implicit-euler", damped) < 1.0 / 60.0


@pytest.mark.parametrize(
    ("k", "method", "limit"),
    [
        (10000.0, "euler", 0.005),
        (10000.0, "heun", 0.296),
        (10000.0, "semi-implicit-euler", 2.231),
        (10000.0, "rk4", 3.168),
        (200.0, "euler", 0.25),
        (200.0, "heun", 4.13),
        (200.0, "semi-implicit-euler", 15.56),
        (200.0, "rk4", 22.6),
        (100.0, "euler", 0.5),
        (100.0, "heun", 6.62),
        (100.0, "semi-implicit-euler", 21.87),
        (100.0, "rk4", 32.1),
    ],
)
def test_table_of_integrators(k: float, method: str, limit: float) -> None:
    # Long chain, m 0.05, c 0.05; the table has three or four digits [ms].
    found = 1e3 * largest_step(method, chain(3001, k))
    digits = len(str(limit).split(".")[1])
    assert found == pytest.approx(limit, abs=0.51 * 10.0**-digits)


def test_step_of_the_report_to_rounding() -> None:
    n, m, k, c = 39, 0.05, 1e4, 0.05
    mu = fixed_free(n)
    expected = (-c + math.sqrt(c * c + 4.0 * k * m / mu)) / k
    got = largest_step("semi-implicit-euler", chain(n + 1, k, m, c))
    assert got == pytest.approx(expected, rel=1e-12)
    assert largest_step("euler", chain(n + 1, k, m, c)) == pytest.approx(c / k, rel=1e-9)


def test_nehe_in_air() -> None:
    # a + 2 b = 4 with b = (c mu + c_air) dt / m; 79 free masses, one end free.
    mu, m, k, c, air = fixed_free(79), 0.05, 1e4, 0.2, 0.02
    p, q = k * mu, 2.0 * (c * mu + air)
    expected = (-q + math.sqrt(q * q + 16.0 * p * m)) / (2.0 * p)
    found = largest_step("semi-implicit-euler", chain(80, k, m, c, drag=air))
    assert found == pytest.approx(expected, rel=1e-12)
    assert 1e3 * found == pytest.approx(2.216, abs=5e-4)
    # Closed forms 1.3, the same chain without air.
    without = largest_step("semi-implicit-euler", chain(80, k, m, c))
    assert without == pytest.approx(0.002216593948, rel=1e-9)
    assert meter(chain(80, k, m, c, drag=air), 0.002) == pytest.approx(3.266, abs=2e-3)


def test_closed_form_of_twenty_masses() -> None:
    # Closed forms 1.3: N 20, m 0.01, k 1000, c 1, one end free.
    found = chain(21, 1000.0, 0.01, 1.0)
    assert largest_step("semi-implicit-euler", found) == pytest.approx(0.002325498951, rel=1e-9)
    assert largest_step("euler", found) == pytest.approx(0.001, rel=1e-9)
    assert largest_step("rk4", found) == pytest.approx(0.004462902574, rel=1e-9)


def test_frequency_and_growth_of_the_report() -> None:
    found = chain(2001, 200.0)
    dt = 1.0 / 60.0
    assert highest_frequency(found) * dt == pytest.approx(2.108, abs=5e-4)
    assert meter(found, dt) == pytest.approx(4.578, abs=5e-4)
    assert growth_per_step("semi-implicit-euler", found, dt) == pytest.approx(2.0575, abs=2e-3)
    assert growth_per_step("semi-implicit-euler", chain(2001, 100.0), dt) == pytest.approx(
        math.sqrt(1.0 - 4.0 / 60.0), rel=1e-4
    )
    stiff = growth_per_step("semi-implicit-euler", chain(2001, 1e4), dt)
    assert stiff == pytest.approx(220.3, abs=0.1)


def test_lumped_loads_and_half_end_masses_change_the_frequency() -> None:
    # Closed forms 1.1: fixed-free, last mass m/2: 2 sqrt(k/m) sin((2N-1) pi / 4N).
    found = chain(21, 1000.0, 0.01)
    found.mass[-1] = 0.005
    assert highest_frequency(found) == pytest.approx(631.9679317, rel=1e-9)
    found.mass[-1] = 0.01
    assert highest_frequency(found) == pytest.approx(630.5997818, rel=1e-9)


@pytest.mark.parametrize("method", METHODS)
def test_random_chains_against_the_whole_step_matrix(method: str) -> None:
    rng = np.random.default_rng(7)
    for nodes in (3, 6, 12, 25):
        for _ in range(4):
            found = random_chain(rng, nodes)
            bound = largest_step(method, found)
            assert 0.0 < bound < math.inf
            for share in (0.2, 0.7, 1.0 - 1e-6):
                assert radius(method, found, share * bound) <= 1.0 + 1e-12
            if method in ("semi-implicit-euler", "verlet"):  # exact for any chain
                assert radius(method, found, bound * (1.0 + 1e-6)) > 1.0
            elif method == "rk4":  # the polygon leaves a few percent at most
                assert radius(method, found, bound * 1.06) > 1.0


@pytest.mark.parametrize("method", METHODS)
def test_proportional_chains_are_exact_from_both_sides(method: str) -> None:
    found = chain(24, 700.0, 0.08, 0.4, held=(3,), drag=0.1)
    bound = largest_step(method, found)
    assert radius(method, found, bound * (1.0 - 1e-8)) <= 1.0 + 1e-13
    assert radius(method, found, bound * (1.0 + 1e-6)) > 1.0


@pytest.mark.parametrize("method", ["euler", "heun"])
def test_nothing_damps_sideways_motion(method: str) -> None:
    assert largest_step(method, chain(20, 1000.0, 0.05, 0.0)) == 0.0
    axial = chain(20, 1000.0, 0.05, 0.0, axial=0.5)
    assert largest_step(method, axial) == 0.0
    along = largest_step(method, axial._replace(sideways=False))
    assert along == pytest.approx(largest_step(method, chain(20, 1000.0, 0.05, 0.5)), rel=1e-9)
    assert along > 0.0


def test_strong_friction_limits_a_slack_chain_sideways() -> None:
    # Sideways, a slack chain has friction and no stiffness: euler needs c mu dt/m <= 2.
    n, m, k, c = 30, 0.01, 100.0, 5.0
    found = chain(n + 1, k, m, c)
    assert largest_step("euler", found) == pytest.approx(2 * m / (c * fixed_free(n)), rel=1e-9)
    # Along the chain alone, closed forms 1.3: the smaller root of 2 b - a = 4.
    p, q = k * fixed_free(n) / m, c * fixed_free(n) / m
    expected = (q - math.sqrt(q * q - 4.0 * p)) / p
    along = largest_step("euler", found._replace(sideways=False))
    assert along == pytest.approx(expected, rel=1e-9)


def test_ground_springs_and_friction_lower_the_bound() -> None:
    free = chain(10, 50.0)
    ground = free._replace(node_stiffness=np.full(10, 100.0), node_damping=np.full(10, 2.0))
    mu = fixed_free(9)
    p, q = (50.0 * mu + 100.0) / 0.05, (0.05 * mu + 2.0) / 0.05
    expected = (-q + math.sqrt(q * q + 4.0 * p)) / p
    assert largest_step("semi-implicit-euler", ground) == pytest.approx(expected, rel=1e-10)
    assert expected < 0.7 * largest_step("semi-implicit-euler", free)


def test_worst_node_lies_where_the_light_nodes_are() -> None:
    found = chain(60, 1000.0)
    found.mass[40:45] = 0.01
    shape = worst_mode(found, 1e-4)
    assert np.abs(shape).max() == pytest.approx(1.0)
    assert np.abs(shape).argmax() in range(40, 45)
    assert shape[0] == 0.0
    strong = np.abs(shape) > 0.3
    assert np.all(np.diff(np.sign(shape[strong])) != 0.0)  # a zigzag


def test_held_and_massless_chains_have_no_bound() -> None:
    found = chain(3, 1000.0, held=(0, 1, 2))
    for method in METHODS:
        assert largest_step(method, found) == math.inf
        assert largest_step(method, chain(3, 0.0, c=0.0)) == math.inf
    with pytest.raises(KeyError):
        largest_step("leapfrog", found)


def test_bound_scales_to_long_ropes() -> None:
    found = chain(200_001, 1e4)
    expected = (-0.05 + math.sqrt(0.05**2 + 500.0)) / 1e4  # long chain
    assert largest_step("semi-implicit-euler", found) == pytest.approx(expected, rel=1e-9)


def test_ropes_of_different_friction_keep_their_own_bounds() -> None:
    # Joined by dead segments; the friction of one does not help the other: euler dt = min c/k.
    parts = [chain(12, 1e4, c=c, held=(0, 11)) for c in (0.01, 0.05, 1.0)]
    fields = []
    for name in Chain._fields[:7]:
        arrays = [getattr(part, name) for part in parts]
        if arrays[0].size == 11:
            arrays = [part for array in arrays for part in (array, np.zeros(1))][:-1]
        fields.append(np.concatenate(arrays))
    together = Chain(*fields)
    for method in METHODS:
        alone = min(largest_step(method, part) for part in parts)
        assert largest_step(method, together) == pytest.approx(alone, rel=1e-9)
    assert largest_step("euler", together) == pytest.approx(1e-6, rel=1e-9)


@pytest.mark.parametrize("method", METHODS)
def test_a_load_and_air_on_a_uniform_rope_are_nearly_exact(method: str) -> None:
    found = chain(15, 500.0, 0.05, 0.2, drag=0.03)
    found.mass[7] += 0.4
    bound = largest_step(method, found)
    assert radius(method, found, bound * (1.0 - 1e-6)) <= 1.0 + 1e-12
    along = largest_step(method, found._replace(sideways=False))
    assert radius(method, found, along * 1.02) > 1.0


@pytest.mark.parametrize("method", sorted(UNCONDITIONAL))
def test_implicit_methods_have_no_bound(method: str) -> None:
    found = chain(24, 700.0, 0.08, 0.4, held=(3,), drag=0.1)
    assert largest_step(method, found) == math.inf
    assert largest_stiffness_factor(method, found, 1e3) == math.inf
    assert 0.0 <= growth_per_step(method, found, 1e3) <= 1.0 + 1e-12
    assert growth_per_step("verlet", found, 1e3) > 2.0  # the twin


@pytest.mark.parametrize("method", ["euler", "heun", "rk4"])
@pytest.mark.filterwarnings("error")
def test_springs_weak_beyond_all_numbers_are_none(method: str) -> None:
    """No quotient with them overflows, and the bound is that without them."""
    rng = np.random.default_rng(3)
    usual = random_chain(rng, 9)
    for weak in (1e-310, 5e-324):
        steps = []
        for value in (weak, 0.0):
            stiffness = np.where(np.arange(8) % 3 == 0, value, usual.stiffness)
            steps.append(largest_step(method, usual._replace(stiffness=stiffness)))
        assert steps[0] == pytest.approx(steps[1], rel=1e-12)
        all_weak = usual._replace(stiffness=np.full(8, weak), node_stiffness=np.zeros(9))
        assert not math.isnan(largest_step(method, all_weak))
