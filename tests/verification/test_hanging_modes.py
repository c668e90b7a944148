"""Small swings of a hanging chain: Laguerre's zeros for masses, Bessel's for a rope.

Runs in time, by Verlet from a mode of 1e-7 m: sideways forces are then linear (the springs stretch by
1e-14 / l), and the scheme's own frequency is exact, sin(w~ dt / 2) = w dt / 2 (closed forms 1.4).
Springs in place of rigid links shift w by a part of the order of m g N / (k l) = strain, linear in 1/k
for small strains: of two runs with k and 2 k the combination 2 w(2 k) - w(k) leaves its square.
"""

from __future__ import annotations

import math
from itertools import pairwise

import numpy as np
import pytest
from numpy.polynomial import laguerre

from ropewalk.scene import Material, Points, Rope
from verification.setups import DOWN, chain, g, hold, run, scene, springs

SIZE = 1e-7  # m
J0 = (2.404825557695773, 5.520078110286311, 8.653727912911013)  # zeros of J_0 (Watson, table VII)


def frequency(
    rope: Rope, weights: np.ndarray, near: float, dt: float, method: str = "verlet"
) -> float:
    """Angular frequency [rad/s] of a mode, given the weights of its projection, over three periods.

    From the recurrence q_(i+1) + q_(i-1) = 2 cos(w tau) q_i by least squares.
    """
    every = max(1, int(2 * math.pi / near / 40 / dt))
    made = scene(rope, hold(0), dt=dt, steps=120 * every, every=every, gravity=DOWN, method=method)
    q = run(made).x[:, :, 0] @ weights
    cosine = 0.5 * float((q[2:] + q[:-2]) @ q[1:-1]) / float(q[1:-1] @ q[1:-1])
    own = math.acos(cosine) / (every * dt)
    return 2 / dt * math.sin(0.5 * own * dt)


def hung(spring_lengths: np.ndarray, shape: np.ndarray) -> np.ndarray:
    """Nodes hanging below the origin, displaced along x by `shape` (0 at the anchor)."""
    points = np.zeros((len(shape), 3))
    points[1:, 1] = -np.cumsum(spring_lengths)
    points[:, 0] = SIZE * shape / np.abs(shape).max()
    return points


def of_masses(n: int, mode: int, k: float, *, m: float = 0.1, length: float = 1.0) -> float:
    """Frequency of n equal masses on springs of k [N/m], hanging stretched at rest, 1 m in all."""
    link = length / n
    x = laguerre.lagroots([0] * n + [1])[mode]
    shape = np.array([laguerre.lagval(x, [0] * i + [1]) for i in range(n + 1)])[::-1].copy()
    shape[0] = 0.0  # L_n(x) = 0: the anchor
    tension = (n - np.arange(n)) * m * g
    rope = chain(hung(link + tension / k, shape), springs(k, m, link))
    return frequency(rope, shape, math.sqrt(g / link * x), 0.9 * math.sqrt(m / k))


PUBLISHED = {1: 3.132091953, 2: 3.3901519, 3: 3.498034478, 5: 3.595501868, 10: 3.676620658,
             20: 3.72020515}  # fmt: skip


@pytest.mark.parametrize(
    ("n", "mode"), [(n, mode) for n in PUBLISHED for mode in range(3) if mode < n]
)
def test_masses_swing_at_laguerres_zeros(n: int, mode: int) -> None:
    """w_j^2 = (g / l) x_j, x_j the zeros of L_n: exact at every n (closed forms 3.3; Lamb, Higher
    Mechanics). Left over: the square of the strain at the top, (m g n / (k l))^2, plus 1e-10.
    """
    k, m = 1e6, 0.1
    exact = math.sqrt(g * n * laguerre.lagroots([0] * n + [1])[mode])
    if mode == 0:
        assert exact == pytest.approx(PUBLISHED[n], rel=1e-9)
    one, two = of_masses(n, mode, k), of_masses(n, mode, 2 * k)
    strain = m * g * n / (k / n)
    assert 2 * two - one == pytest.approx(exact, rel=strain**2 + 1e-10)
    assert one / exact - 1 == pytest.approx(2 * (two / exact - 1), rel=1e-2)  # linear in 1/k
    assert abs(one / exact - 1) < strain
    # twins: a mass more or less on the same length; the rope's Bessel zero
    for wrong in (n + 1, n - 1):
        if wrong > mode:
            other = math.sqrt(g * wrong * laguerre.lagroots([0] * wrong + [1])[mode])
            assert abs((2 * two - one) / other - 1) > 2e-4
    assert abs(one / (0.5 * J0[mode] * math.sqrt(g)) - 1) > 1e-3


def of_rope(n: int, mode: int, EA: float, load: float = 0.0, mu: float = 0.2) -> float:
    """Frequency of a rope of 1 m, a load of `load` times its mass at the end; half masses at the ends.

    The mode to start in comes from the same masses on rigid links.
    """
    link = 1.0 / n
    mass = np.full(n, mu * link)
    mass[-1] = 0.5 * mu * link + load * mu
    tension = np.cumsum(mass[::-1])[::-1] * g
    pull = np.append(tension / link, 0.0)
    matrix = np.diag(pull[:-1] + pull[1:]) - np.diag(pull[1:-1], 1) - np.diag(pull[1:-1], -1)
    root = np.sqrt(mass)
    values, vectors = np.linalg.eigh(matrix / np.outer(root, root))
    shape = np.concatenate([[0.0], vectors[:, mode] / root])
    points = hung(link + tension * link / EA, shape)
    rope = Rope(
        segments=n,
        length=1.0,
        made_of=Material(EA=EA, mass_per_length=mu),
        shape=Points(points=[tuple(map(float, point)) for point in points]),
        loads=[{"node": n, "mass": load * mu}] if load else [],
    )
    weights = np.concatenate([[0.0], mass]) * shape
    return frequency(rope, weights, math.sqrt(values[mode]), 0.9 * link * math.sqrt(mu / EA / 2))


def stiff(n: int, mode: int, load: float = 0.0) -> float:
    """The frequency for EA without bound: the square of the strain, 11 mu g / EA = 2e-4, is left."""
    one, two = (of_rope(n, mode, EA, load) for EA in (1e5, 2e5))
    return 2 * two - one


@pytest.mark.parametrize("mode", [0, 1, 2])
def test_a_rope_swings_at_bessels_zeros(mode: int) -> None:
    """w_n = (j_(0,n) / 2) sqrt(g / L) (D. Bernoulli 1733; closed forms 3.3). With half a mass at the
    free end the error falls as N^-2; with a whole one (the twin) only as 1/N.
    """
    rod = 0.5 * J0[mode] * math.sqrt(g)
    sizes = (20, 40, 80)
    error = [abs(stiff(n, mode) / rod - 1) for n in sizes]
    orders = [math.log2(a / b) for a, b in pairwise(error)]
    assert orders[-1] == pytest.approx(2.0, abs=0.06)
    assert error[-1] < (0.02, 0.06, 0.2)[mode] / 20  # N^-2 from 2, 6 and 20 % at 18 masses
    masses = [abs(of_masses(n, mode, 1e6) / rod - 1) for n in (20, 40)]
    assert math.log2(masses[0] / masses[1]) == pytest.approx(1.0, abs=0.25)


LOADED = {  # M / (mu L): w_1, w_2 [rad/s] (closed forms 3.4)
    0.1: (3.625063669, 8.820116509),
    0.5: (3.403524092, 10.71142596),
    2.0: (3.236944663, 16.14668971),
    10.0: (3.156941066, 32.18671212),
}


@pytest.mark.parametrize("mode", [0, 1])
@pytest.mark.parametrize("load", LOADED)
def test_a_loaded_rope(load: float, mode: int) -> None:
    """z = 2 w sqrt((s + M/mu) / g), y = A J_0(z) + B Y_0(z) (closed forms 3.4; Armstrong 1976, Am. J.
    Phys. 44:564): pendulum and string in one. 0.1 % at N = 50, as N^-2. Twins: the neighbouring loads.
    """
    expected = LOADED[load][mode]
    coarse, fine = stiff(25, mode, load), stiff(50, mode, load)
    assert fine == pytest.approx(expected, rel=1e-3)
    assert (coarse / expected - 1) / (fine / expected - 1) == pytest.approx(4.0, rel=0.05)
    for other, values in LOADED.items():
        if other != load:
            assert abs(fine / values[mode] - 1) > 1e-3
