"""The largest stable time step of a chain of point masses, for every method.

A chain is reduced to one unknown per node. The stiffness of a segment, as a matrix, lies between
-k I and k I for any shape in which no segment is pressed below half its length (k along it,
k (1 - L/r) across it), so the chain with k everywhere bounds every shape from above and is exact
along a straight one. Bends become springs between neighbours (`lowering.bends`). An eigenvector of

    M x'' + C x' + K x = 0

sees the stiffness kappa = x*Kx / x*Mx and the friction gamma = x*Cx / x*Mx. All such pairs lie in
the joint numerical range of M^-1/2 K M^-1/2 and M^-1/2 C M^-1/2, a convex set (Hausdorff; Horn and
Johnson, Topics in Matrix Analysis, ch. 1), which `modes` encloses in a polygon; where friction is
proportional to stiffness and mass it is a segment, and exact. The step is stable when every pair
(kappa dt^2, gamma dt) lies in the method's region (`characteristic.py`). Across a stretched segment
the stiffness is anything between 0 and k while axial friction does nothing: those are the
"sideways" pairs. Semi-implicit Euler and Verlet need no polygon, only that

    4 M - 2 dt C - dt^2 K      (Verlet: 4 M - 4 dt C - dt^2 K)

is positive definite, which is exact for any chain; the same holds for explicit Euler with
C - dt K and 4 M - 2 dt C + dt^2 K. Cost O(n).
"""

from __future__ import annotations

import math
from collections.abc import Callable
from itertools import pairwise
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from ropewalk.methods.characteristic import MARGINS, UNCONDITIONAL, growth, is_stable
from ropewalk.methods.tridiagonal import (
    is_positive_definite,
    largest_eigenvalue,
    largest_eigenvector,
    smallest_eigenvalue,
)

Floats = NDArray[np.float64]

# Friction in the pencil 4 M - f dt C - dt^2 K of the methods that it decides.
_PENCIL = {"semi-implicit-euler": 2.0, "verlet": 4.0}
# A bound below this, in units of 1/omega_max, is rounding: nothing damps some mode.
_FORMALLY_ZERO = 5e-6
_DIRECTIONS = 48
_DIRECTIONS_LONG = 16  # above this many nodes the polygon's corners would take too long
_LONG = 50_000
_NOTHING = 1e-280  # a spring or friction this small is none: a quotient with it overflows


class Chain(NamedTuple):
    """n nodes with one unknown each and the n - 1 segments between them, all arrays float64."""

    mass: Floats  # (n,) [kg]
    stiffness: Floats  # (n - 1,) [N/m]
    damping_vector: Floats  # (n - 1,) [N s/m]
    damping_axial: Floats  # (n - 1,) [N s/m]
    node_stiffness: Floats  # (n,) [N/m], e.g. of the ground
    node_damping: Floats  # (n,) [N s/m], e.g. of the air
    free: NDArray[np.bool_]  # (n,) False where the node is held
    sideways: bool = True  # whether anything can push the chain sideways
    bending: Floats | float = 0.0  # (n - 1,) [N/m] springs no softer than the bends
    damping_bending: Floats | float = 0.0  # (n - 1,) [N s/m]


class Matrix(NamedTuple):
    """A symmetric tridiagonal matrix over the free nodes."""

    diagonal: Floats
    beside: Floats


class Modes(NamedTuple):
    """Pairs (kappa, gamma) that enclose those of every mode."""

    kappa: Floats  # [1/s^2]
    gamma: Floats  # [1/s]
    sideways_kappa: Floats
    sideways_gamma: Floats


def assemble(chain: Chain, segments: Floats, nodes: Floats) -> Matrix:
    """Return the matrix of segments and nodes over the free nodes, scaled by 1/sqrt(m_i m_j)."""
    diagonal = nodes.astype(np.float64, copy=True)
    diagonal[:-1] += segments
    diagonal[1:] += segments
    where = np.flatnonzero(chain.free)
    mass = chain.mass[where]
    adjacent = np.diff(where) == 1
    beside = np.zeros(max(where.size - 1, 0))
    beside[adjacent] = -segments[where[:-1][adjacent]]
    beside /= np.sqrt(mass[:-1] * mass[1:])
    return Matrix(diagonal[where] / mass, beside)


def stiffness_matrix(chain: Chain, factor: float = 1.0) -> Matrix:
    """Return M^-1/2 K M^-1/2 [1/s^2], the springs multiplied by `factor`."""
    return assemble(chain, factor * chain.stiffness + chain.bending, chain.node_stiffness)


def friction_matrix(chain: Chain, axial: bool = True) -> Matrix:
    """Return M^-1/2 C M^-1/2 [1/s]; for sideways motion only the friction that surely acts there."""
    more = chain.damping_axial + chain.damping_bending if axial else 0.0
    segments = chain.damping_vector + more
    return assemble(chain, segments, chain.node_damping)


def _combine(a: Matrix, b: Matrix, p: float, q: float) -> Matrix:
    return Matrix(p * a.diagonal + q * b.diagonal, p * a.beside + q * b.beside)


def _largest(matrix: Matrix) -> float:
    return float(largest_eigenvalue(*matrix))


def _proportional(K: Matrix, C: Matrix) -> tuple[float, float] | None:
    """Return (alpha, beta) of C = alpha I + beta K, or None where friction is not of that form."""
    joined = np.abs(K.beside) > _NOTHING
    if np.any(C.beside[~joined] != 0.0):
        return None
    ratios = C.beside[joined] / K.beside[joined]
    beta = float(ratios[0]) if ratios.size else 0.0
    if np.any(np.abs(ratios - beta) > 1e-12 * abs(beta)):
        return None
    rest = C.diagonal - beta * K.diagonal
    scale = float(np.abs(C.diagonal).max()) + abs(beta) * float(np.abs(K.diagonal).max())
    if np.ptp(rest) > 1e-12 * scale:
        return None
    return float(rest[0]), beta


def _directions(K: Matrix, C: Matrix, count: int, slope: float) -> Floats:
    """Return the angles of the polygon's edges, more of them where little friction decides.

    Evenly spread ones, a fan around "least friction", and those along which the friction of a
    single segment is proportional to its stiffness. `slope` scales friction over stiffness.
    """
    even = 2.0 * np.pi * np.arange(count) / count
    fan = np.arctan(2.0 ** -np.arange(1.0, 13.0))
    joined = np.abs(K.beside) > _NOTHING
    ratios = np.unique(np.abs(C.beside[joined] / K.beside[joined]))
    if ratios.size > 8:
        ratios = np.quantile(ratios, np.linspace(0.0, 1.0, 8))
    along = np.arctan2(-1.0, ratios * slope)
    angles = np.concatenate([even, 1.5 * np.pi + fan, 1.5 * np.pi - fan, along, along + np.pi])
    angles = np.sort(np.mod(angles, 2.0 * np.pi))
    return angles[np.concatenate([[True], np.diff(angles) > 1e-7])]


def _polygon(K: Matrix, C: Matrix, directions: int) -> tuple[Floats, Floats]:
    """Return the corners of a polygon around the joint numerical range of K and C."""
    k_size, c_size = (size if size > _NOTHING else 1.0 for size in (_largest(K), _largest(C)))
    angle = _directions(K, C, directions, k_size / c_size)
    cosine, sine = np.cos(angle), np.sin(angle)
    reach = np.array(
        [
            _largest(_combine(K, C, p / k_size, q / c_size))
            for p, q in zip(cosine, sine, strict=True)
        ]
    )
    following = np.roll(reach, -1)
    turn = np.sin(np.roll(angle, -1) - angle)
    x = (reach * np.roll(sine, -1) - following * sine) / turn
    y = (following * cosine - reach * np.roll(cosine, -1)) / turn
    return np.maximum(x, 0.0) * k_size, np.maximum(y, 0.0) * c_size


def _parts(K: Matrix, C: Matrix, side: Matrix) -> list[tuple[Matrix, Matrix, Matrix]]:
    """Split into stretches between held nodes, which move on their own; equal ones once."""
    cut = np.flatnonzero((K.beside == 0.0) & (C.beside == 0.0)) + 1
    edges = [0, *cut.tolist(), K.diagonal.size]
    found: dict[bytes, tuple[Matrix, Matrix, Matrix]] = {}
    for first, last in pairwise(edges):
        part = tuple(
            Matrix(matrix.diagonal[first:last], matrix.beside[first : last - 1])
            for matrix in (K, C, side)
        )
        key = b"".join(array.tobytes() for matrix in part for array in matrix)
        found.setdefault(key, part)  # type: ignore[arg-type]
    return list(found.values())


def _corners(K: Matrix, C: Matrix, directions: int) -> tuple[Floats, Floats]:
    form = _proportional(K, C)
    if form is None:
        return _polygon(K, C, directions)
    alpha, beta = form
    kappa = np.array([max(smallest_eigenvalue(*K), 0.0), max(_largest(K), 0.0)])
    return kappa, np.maximum(alpha + beta * kappa, 0.0)


def _outline(kappa: Floats, gamma: Floats) -> tuple[Floats, Floats]:
    """Sample the edges of a polygon, more densely towards both ends of each edge."""
    t = 0.5 - 0.5 * np.cos(np.pi * np.arange(33) / 33.0)
    t = np.union1d(t, [1e-6, 1e-4, 1e-3])
    x = kappa[:, None] * (1.0 - t) + np.roll(kappa, -1)[:, None] * t
    y = gamma[:, None] * (1.0 - t) + np.roll(gamma, -1)[:, None] * t
    return x.ravel(), y.ravel()


def modes(chain: Chain, factor: float = 1.0, directions: int | None = None) -> Modes:
    """Enclose the pairs (kappa, gamma) of every mode, the springs multiplied by `factor`."""
    if directions is None:
        directions = _DIRECTIONS if chain.mass.size < _LONG else _DIRECTIONS_LONG
    K, C = stiffness_matrix(chain, factor), friction_matrix(chain)
    side = friction_matrix(chain, axial=False)
    along, across = [], []
    for k, c, d in _parts(K, C, side):
        corners = _corners(k, c, directions)
        along.append(_outline(*corners))
        if chain.sideways:
            alike = np.array_equal(c.diagonal, d.diagonal)
            across.append(_shadow(*(corners if alike else _corners(k, d, directions))))
    if not across:
        across.append((np.zeros(1), np.zeros(1)))
    return Modes(
        *(np.concatenate(values) for values in zip(*along, strict=True)),
        *(np.concatenate(values) for values in zip(*across, strict=True)),
    )


def _shadow(kappa: Floats, gamma: Floats) -> tuple[Floats, Floats]:
    """Sample the pairs of sideways motion: stiffness from that of the springs down to 0."""
    x, y = _outline(kappa, gamma)
    fade = np.linspace(float(gamma.min()), float(gamma.max()), 65)
    return (
        np.concatenate([x, np.zeros(65), 1e-3 * x, 0.3 * x]),
        np.concatenate([y, fade, y, y]),
    )


def _all_stable(method: str, found: Modes, dt: float) -> bool:
    along = is_stable(method, found.kappa * dt * dt, found.gamma * dt)
    if not along.all():
        return False
    return bool(is_stable(method, found.sideways_kappa * dt * dt, found.sideways_gamma * dt).all())


def _definite(K: Matrix, C: Matrix, dt: float, friction: float, stiff: float = 1.0) -> bool:
    """Whether 4 M - friction dt C - stiff dt^2 K is positive definite."""
    both = _combine(C, K, -friction * dt, -stiff * dt * dt)
    return bool(is_positive_definite(4.0 + both.diagonal, both.beside))


def _euler_stable(chain: Chain, K: Matrix, C: Matrix, dt: float) -> bool:
    """Whether C - dt K and 4 M - 2 dt C + dt^2 K are positive, sideways too."""
    if not (_at_least_zero(C, K, -dt) and _at_least_zero(K, C, -2.0 / dt, 4.0 / (dt * dt))):
        return False
    if not chain.sideways:
        return True
    side = friction_matrix(chain, axial=False)
    return _at_least_zero(side, K, -dt) and _definite(K, side, dt, 2.0, stiff=0.0)


def _at_least_zero(A: Matrix, B: Matrix, factor: float, shift: float = 0.0) -> bool:
    """Whether A + factor B + shift has no eigenvalue below 0, to rounding."""
    both = _combine(A, B, 1.0, factor)
    size = float(np.abs(A.diagonal).max() + abs(factor) * np.abs(B.diagonal).max()) + shift
    return bool(is_positive_definite(both.diagonal + shift + 1e-13 * size, both.beside))


def _bisect(is_good: Callable[[float], bool], low: float, high: float) -> float:
    """Return the largest good number between a good and a bad one, to rounding."""
    for _ in range(200):
        middle = math.sqrt(low * high) if low > 0.0 and high > 4.0 * low else 0.5 * (low + high)
        if not low < middle < high:
            break
        if is_good(middle):
            low = middle
        else:
            high = middle
    return low


def largest_step(method: str, chain: Chain) -> float:
    """Return the largest stable time step [s]; inf where nothing limits it, 0 if all steps grow.

    Raises KeyError for an unknown method.
    """
    MARGINS[method]
    if method in UNCONDITIONAL or not chain.free.any():
        return math.inf
    K, C = stiffness_matrix(chain), friction_matrix(chain)
    kappa, gamma = max(_largest(K), 0.0), max(_largest(C), 0.0)
    if kappa == 0.0 and gamma == 0.0:
        return math.inf
    # Beyond this step no method is stable: rk4 ends at a = 8 and b = 2.8, with a little to spare.
    high = min(4.0 / math.sqrt(kappa) if kappa else math.inf, 16.0 / gamma if gamma else math.inf)
    if method in _PENCIL:
        return _bisect(lambda dt: _definite(K, C, dt, _PENCIL[method]), 0.0, high)
    if method == "euler":
        return _descending(lambda dt: _euler_stable(chain, K, C, dt), high, kappa)
    found = modes(chain)
    return _descending(lambda dt: _all_stable(method, found, dt), high, kappa)


def _descending(is_good: Callable[[float], bool], high: float, kappa: float) -> float:
    """Return the first bad step above 0, looking down from one that is too long."""
    floor = _FORMALLY_ZERO / math.sqrt(kappa) if kappa else 0.0
    while not is_good(high):
        high *= 0.5
        if high < floor:
            return 0.0
    # The region of heun and rk4 has a wavy edge; look for a gap below the first good step.
    for dt in np.linspace(1.0 / 16.0, 1.0, 15, endpoint=False) * high:
        if not is_good(float(dt)):
            return _bisect(is_good, float(dt) - high / 16.0, float(dt))
    return _bisect(is_good, high, 2.0 * high)


def largest_stiffness_factor(method: str, chain: Chain, dt: float) -> float:
    """Return the largest factor on all springs [1] stable at dt; 0 where none is, or inf."""
    if method in UNCONDITIONAL or not chain.free.any() or not np.any(chain.stiffness > 0.0):
        return math.inf
    C = friction_matrix(chain)
    directions = _DIRECTIONS if chain.mass.size < 2000 else _DIRECTIONS_LONG

    def is_good(factor: float) -> bool:
        if method in _PENCIL:
            return _definite(stiffness_matrix(chain, factor), C, dt, _PENCIL[method])
        if method == "euler":
            return _euler_stable(chain, stiffness_matrix(chain, factor), C, dt)
        return _all_stable(method, modes(chain, factor, directions), dt)

    fastest = _largest(assemble(chain, chain.stiffness, np.zeros(chain.mass.size)))
    if fastest <= 0.0:
        return math.inf
    high = 16.0 / (fastest * dt * dt)
    if is_good(high):
        return math.inf
    low = high
    while not is_good(low):
        low *= 0.25
        if low < 1e-12 * high:
            return 0.0
    if low == high:
        return math.inf
    return _bisect_loosely(is_good, low, 4.0 * low)


def _bisect_loosely(is_good: Callable[[float], bool], low: float, high: float) -> float:
    for _ in range(34):
        middle = 0.5 * (low + high)
        if is_good(middle):
            low = middle
        else:
            high = middle
    return low


def growth_per_step(method: str, chain: Chain, dt: float, sideways: float = 1.0) -> float:
    """Return the factor by which the worst mode grows per step at dt [1].

    For a stable chain it is the factor of the fastest mode, below or at 1. `sideways` is the share
    of a spring's stiffness that acts across it, 1 - L/r.
    """
    if not chain.free.any():
        return 1.0
    found = modes(chain)
    if _all_stable(method, found, dt):
        top = int(np.argmax(found.kappa * dt * dt + 2.0 * found.gamma * dt))
        return float(growth(method, found.kappa[top] * dt * dt, found.gamma[top] * dt))
    worst = float(growth(method, found.kappa * dt * dt, found.gamma * dt).max())
    across = growth(method, sideways * found.sideways_kappa * dt * dt, found.sideways_gamma * dt)
    return max(worst, float(across.max()), 1.0)


def meter(chain: Chain, dt: float, friction: float = 2.0) -> float:
    """Return the largest a + 2 b of all modes at dt [1]; semi-implicit Euler is stable below 4.

    `friction` is the factor before b: 2, or 4 for Verlet.
    """
    if not chain.free.any():
        return 0.0
    K, C = stiffness_matrix(chain), friction_matrix(chain)
    return _largest(_combine(K, C, dt * dt, friction * dt))


def highest_frequency(chain: Chain) -> float:
    """Return the highest angular frequency of the undamped chain [rad/s]."""
    if not chain.free.any():
        return 0.0
    return math.sqrt(max(_largest(stiffness_matrix(chain)), 0.0))


def worst_mode(chain: Chain, dt: float) -> Floats:
    """Return the shape of the mode with the largest a + 2 b, (n,), largest entry 1 [1]."""
    shape = np.zeros(chain.mass.size)
    if not chain.free.any():
        return shape
    matrix = _combine(stiffness_matrix(chain), friction_matrix(chain), dt * dt, 2.0 * dt)
    vector = np.empty(matrix.diagonal.size)
    value = _largest(matrix)
    largest_eigenvector(*matrix, value, vector, np.empty_like(vector))
    shape[chain.free] = vector / np.sqrt(chain.mass[chain.free])
    largest = np.abs(shape).max()
    return shape / largest if largest > 0.0 else shape
