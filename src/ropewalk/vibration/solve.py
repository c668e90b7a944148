"""Eigenvalues and shapes of M u'' + C u' + K u = 0, the slowest first.

Without friction K u = w^2 M u, symmetric: small models by a dense eigenproblem of the flexibility
M^1/2 K^-1 M^1/2, whose largest eigenvalues are the slow modes, to rounding however stiff the rope is;
large ones by iterating a subspace under the same K^-1, sparse, which finds equal frequencies as often as
they are there (a Krylov method from one vector does not). With friction, or where K is not symmetric,
(l^2 M + l C + K) u = 0 as the eigenproblem of the inverse of its companion matrix, in the same two ways.
Source: Bathe, Finite Element Procedures, sec. 11.6; Tisseur and Meerbergen, SIAM Review 43 (2001) 235.
"""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import numpy as np
from numpy.typing import NDArray

from ropewalk.core.arrays import Floats
from ropewalk.vibration.linear import Linear

Complex = NDArray[np.complex128]

DENSE = 900  # unknowns up to which a dense eigenproblem is solved
_DENSE_DAMPED = 400  # the same with friction, where the problem has twice as many
_SINGULAR = (
    1e14  # flexibility, in units of the model's own, beyond which something moves freely [1]
)
_SHIFT = 1e-6  # shift that is then taken, in units of the model's rate [1]
_ROUNDS = 300  # of a subspace's iteration at most
_SETTLED = 1e-13  # relative change of an eigenvalue in one round that ends it [1]
_ALIKE = 1e-7  # relative difference of eigenvalues that are one [1]


def solve(linear: Linear, count: int) -> tuple[Complex, Complex]:
    """Return the eigenvalues l [1/s] (m,) and shapes (m, 3 f) of the slowest modes, m <= count.

    l = -d + i w of modes that ring, of which only those with w >= 0 are given, and real ones of modes
    that creep or, when they are positive, grow.
    """
    if linear.nodes.size == 0:
        return np.zeros(0, complex), np.zeros((0, 0), complex)
    if linear.symmetric and not linear.has_friction:
        squares, shapes = undamped(linear, count)
        values = np.where(squares >= 0.0, 1j, 1.0) * np.sqrt(np.abs(squares))
        return values.astype(complex), shapes.astype(complex)
    return _damped(linear, count)


def undamped(linear: Linear, count: int) -> tuple[Floats, Floats]:
    """Return w^2 [1/s^2] (m,), slowest first, and real shapes (m, 3 f) of M u'' + K u = 0."""
    size = linear.mass.size
    modes = size - int((linear.soft == 0.0).sum())
    count = min(count, modes)
    if size <= DENSE or count > size // 3:
        squares, shapes = _dense(linear, modes)
    else:
        squares, shapes = _subspace(linear, count)
    order = np.argsort(squares, kind="stable")[:count]
    return squares[order], shapes[order]


def highest(linear: Linear) -> float:
    """Return the highest frequency of M u'' + K u = 0 [rad/s]; inf with rigid links."""
    if linear.rigid:
        return float("inf")
    from scipy.sparse import diags_array
    from scipy.sparse.linalg import eigsh

    over = diags_array(1.0 / np.sqrt(linear.mass))
    K = over @ (0.5 * (linear.stiffness + linear.stiffness.T)) @ over
    size = linear.mass.size
    if size <= DENSE:
        return float(np.sqrt(max(np.linalg.eigvalsh(K.toarray())[-1], 0.0)))
    value = eigsh(K, k=1, which="LA", v0=_start(size), return_eigenvectors=False)
    return float(np.sqrt(max(value[0], 0.0)))


def _inverse(linear: Linear) -> tuple[Callable[[Any], Any], float]:
    """Return the solution of (K + s C + s^2 M) u = f, and the shift s that was needed [1/s]."""
    from scipy.sparse.linalg import splu

    size = linear.mass.size
    shift = 0.0
    for _ in range(2):
        try:
            factors = splu(linear.saddle(shift))
            probe = factors.solve(np.append(_start(size), np.zeros(linear.soft.size)))[:size]
            sound = bool(np.abs(probe).max() * linear.mass.max() * _rate(linear) ** 2 < _SINGULAR)
        except RuntimeError:  # exactly singular
            sound = False
        if sound:
            break
        shift = _SHIFT * _rate(linear)
    if not sound:
        raise ArithmeticError("the stiffness of this shape is singular: its modes cannot be found")

    def inverse(force: Any) -> Any:
        right = np.zeros((factors.shape[0], *force.shape[1:]))
        right[:size] = force
        return factors.solve(right)[:size]

    return inverse, shift


def _rate(linear: Linear) -> float:
    """Return a middle frequency of the model, from its diagonals [1/s]."""
    with np.errstate(divide="ignore"):
        along = (linear.lengths.multiply(linear.lengths)).T @ np.minimum(1.0 / linear.soft, 1e15)
    diagonal = np.abs(linear.other.diagonal()) + along
    return float(np.sqrt(np.median((diagonal / linear.mass)[diagonal > 0.0])) or 1.0)


def _start(size: int) -> Floats:
    """A vector to begin with, the same at every call."""
    return np.random.default_rng(1).normal(size=size)


def _without(shift: float, values: Floats) -> Floats:
    """Return w^2 from the shifted flexibility; rounding of what moves freely is 0."""
    squares = 1.0 / values - shift**2
    return np.where(np.abs(squares) < 0.01 * shift**2, 0.0, squares)


def _dense(linear: Linear, modes: int) -> tuple[Floats, Floats]:
    """Return all modes: the slow half from the flexibility, the fast half from the stiffness."""
    inverse, shift = _inverse(linear)
    root = np.sqrt(linear.mass)
    flexible = root[:, None] * inverse(np.diag(root))
    values, vectors = np.linalg.eigh(0.5 * (flexible + flexible.T))
    order = np.argsort(-np.abs(values))[:modes]
    values, vectors = values[order], vectors[:, order]
    squares = _without(shift, values)
    if not linear.rigid:
        K = linear.stiffness.toarray() / root[:, None] / root
        direct, direct_vectors = np.linalg.eigh(0.5 * (K + K.T))
        by_size = np.argsort(np.abs(direct), kind="stable")
        direct, direct_vectors = direct[by_size], direct_vectors[:, by_size]
        # Each is accurate where its own eigenvalues are large; they meet at the geometric mean.
        middle = np.sqrt(np.abs(squares[0]) + shift**2) * np.sqrt(np.abs(direct[-1]))
        fast = int(np.searchsorted(np.abs(direct), max(middle, 0.0)))
        squares = np.concatenate([squares[:fast], direct[fast:]])
        vectors = np.concatenate([vectors[:, :fast], direct_vectors[:, fast:]], axis=1)
    return squares, (vectors / root[:, None]).T


def _subspace(linear: Linear, count: int) -> tuple[Floats, Floats]:
    """Iterate a subspace under the flexibility: equal frequencies are all found."""
    inverse, shift = _inverse(linear)
    root = np.sqrt(linear.mass)
    block = np.random.default_rng(1).normal(size=(root.size, 2 * count + 8))
    before = np.zeros(count)
    for _ in range(_ROUNDS):
        basis, _ = np.linalg.qr(block)
        block = root[:, None] * inverse(root[:, None] * basis)
        small = basis.T @ block
        values, turn = np.linalg.eigh(0.5 * (small + small.T))
        order = np.argsort(-np.abs(values))[:count]
        values = values[order]
        if np.all(np.abs(values - before) <= _SETTLED * np.abs(values)):
            break
        before = values
    vectors = basis @ turn[:, order]
    return _without(shift, values), (vectors / root[:, None]).T


def _damped(linear: Linear, count: int) -> tuple[Complex, Complex]:
    """Return the slowest eigenvalues of (l^2 M + l C + K) u = 0 and their shapes."""
    inverse, shift = _inverse(linear)
    if linear.mass.size <= _DENSE_DAMPED and shift > 0.0 and not linear.rigid:
        found, vectors = _companion(linear)
    else:
        found, vectors = _inverted(linear, inverse, shift, count)
    size = np.abs(found)
    found = np.where(np.abs(found.imag) <= 1e-9 * size, found.real, found)
    found = np.where(np.abs(found.real) <= 1e-12 * size, 1j * found.imag, found)
    upper = found.imag >= 0.0
    found, vectors = found[upper], vectors[: linear.mass.size, upper]
    order = np.argsort(np.abs(found), kind="stable")[:count]
    return found[order], vectors[:, order].T


def _companion(linear: Linear) -> tuple[Complex, Complex]:
    """Return all eigenvalues and vectors of the companion matrix; for what moves freely."""
    size, rate = linear.mass.size, _rate(linear)
    over = 1.0 / linear.mass[:, None]
    below = [-over * linear.stiffness.toarray() / rate, -over * linear.friction.toarray()]
    matrix = np.block([[np.zeros((size, size)), rate * np.eye(size)], below])
    values, vectors = np.linalg.eig(matrix)
    values = np.where(np.abs(values) <= 1e-7 * rate, 0.0, values)  # a double zero splits into these
    return values, vectors


def _inverted(
    linear: Linear, inverse: Callable[[Any], Any], shift: float, count: int
) -> tuple[Complex, Complex]:
    """Return eigenvalues and vectors of the inverse of the companion matrix, the slowest ones."""
    size, rate, mass = linear.mass.size, _rate(linear), linear.mass[:, None]
    friction = linear.friction.copy()
    friction.setdiag(friction.diagonal() + 2.0 * shift * linear.mass)

    def apply(both: Any) -> Any:
        """The inverse, for l - shift; velocities in units of the rate."""
        u, v = both[:size], both[size:] * rate
        return np.concatenate([-inverse(mass * v + friction @ u), u / rate])

    if size <= _DENSE_DAMPED:
        values, vectors = np.linalg.eig(apply(np.eye(2 * size)))
    else:
        values, vectors = _iterate(linear, apply, rate, count)
    kept = np.abs(values) > 1e-14 * np.abs(values).max()
    return shift + 1.0 / values[kept], vectors[:, kept]


def _iterate(
    linear: Linear, apply: Callable[[Any], Any], rate: float, count: int
) -> tuple[Complex, Complex]:
    """Iterate a subspace that begins with the undamped modes."""
    size = linear.mass.size
    _, shapes = _subspace(linear, count + 4)
    zero = np.zeros_like(shapes.T)
    noise = np.random.default_rng(2).normal(size=(2 * size, 8))
    top, bottom = np.concatenate([shapes.T, zero]), np.concatenate([zero, shapes.T])
    block = np.concatenate([top, bottom, noise], axis=1)
    before = np.zeros(2 * count)
    for _ in range(_ROUNDS):
        basis, _ = np.linalg.qr(block)
        block = apply(basis)
        values, turn = np.linalg.eig(basis.T @ block)
        order = np.argsort(-np.abs(values), kind="stable")[: 2 * count]
        values = values[order]
        if np.all(np.abs(np.abs(values) - before) <= _SETTLED * np.abs(values)):
            break
        before = np.abs(values)
    return values, basis @ turn[:, order]


def untangle(squares: Floats, shapes: Floats, mass: Floats, aside: Floats) -> Floats:
    """Turn the shapes of equal frequencies so that they lie in the plane or out of it.

    Args:
        squares: w^2 (m,), sorted.
        shapes: (m, 3 f).
        mass: of the unknowns (3 f,) [kg].
        aside: out-of-plane unit vector, repeated for every node (3 f,).
    """
    shapes = shapes.copy()
    first = 0
    scale = np.abs(squares)
    for last in range(1, len(squares) + 1):
        if last < len(squares) and scale[last] - scale[first] <= _ALIKE * scale[last]:
            continue
        if last - first > 1:
            group = shapes[first:last]
            group = group / np.sqrt((group**2 * mass).sum(axis=1))[:, None]
            part = (group * aside).reshape(last - first, -1, 3).sum(axis=2)
            weight = part * mass[::3]
            _, turn = np.linalg.eigh(weight @ part.T)
            shapes[first:last] = turn.T @ group
        first = last
    return shapes
