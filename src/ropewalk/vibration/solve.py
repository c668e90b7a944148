"""Eigenvalues and shapes of M u'' + C u' + K u = 0, the slowest first.

Without friction K u = w^2 M u, symmetric: small models by a dense eigenproblem of the flexibility
M^1/2 K^-1 M^1/2, whose largest eigenvalues are the slow modes, to rounding however stiff the rope is;
large ones by iterating a subspace under the same K^-1, sparse, which finds equal frequencies as often as
they are there (a Krylov method from one vector does not). With friction, or where K is not symmetric,
(l^2 M + l C + K) u = 0 as the eigenproblem of the inverse of its companion matrix: dense, or for large
models from a block Krylov space (quadratic.py).
Source: Bathe, Finite Element Procedures, sec. 11.6; Tisseur and Meerbergen, SIAM Review 43 (2001) 235.
"""

from __future__ import annotations

from collections.abc import Callable
from itertools import pairwise
from typing import Any

import numpy as np
from numpy.typing import NDArray

from ropewalk.core.arrays import Floats
from ropewalk.vibration.flexibility import NoModes, find_inverse, rate, start
from ropewalk.vibration.linear import Linear
from ropewalk.vibration.quadratic import Shifted, noise, slowest

Complex = NDArray[np.complex128]

DENSE = 900  # unknowns up to which a dense eigenproblem is solved
_DENSE_DAMPED = 400  # the same with friction, where the problem has twice as many
_MOST = 8  # unknowns for each mode that is wanted, with friction: for fewer, all are found
_ROUNDS = 300  # of a subspace's iteration at most
_SETTLED = 1e-13  # relative change of an eigenvalue in one round that ends it [1]
_NEUTRAL = 1e-13  # of the rate squared: a w^2 that is negative by less is rounding [1]
_GROWS = 1e-9  # of an eigenvalue's size: a positive real part below is rounding [1]
_ENOUGH = 1e-6  # change that is accepted after all rounds: of more nothing is known [1]
_ALIKE = 1e-7  # relative difference of eigenvalues that are one [1]
_SAME_SIDE = 1e-6  # difference of shares out of the plane that are one [1]
_DISTINCT = 1e-6  # shapes of one eigenvalue nearer to each other than this are one shape [1]


def solve(linear: Linear, count: int) -> tuple[Complex, Floats | Complex]:
    """Return the eigenvalues l [1/s] (m,) and shapes (m, 3 f) of the slowest modes, m <= count.

    Shapes are real without friction.
    l = -d + i w of modes that ring, of which only those with w >= 0 are given, and real ones of modes
    that creep or, when they are positive, grow.
    """
    if linear.nodes.size == 0:
        return np.zeros(0, complex), np.zeros((0, 0), complex)
    if linear.symmetric and not linear.has_friction:
        squares, shapes = undamped(linear, count)
        rounding = _NEUTRAL * rate(linear) ** 2
        squares = np.where((squares < 0.0) & (squares > -rounding), 0.0, squares)
        values = np.where(squares >= 0.0, 1j, 1.0) * np.sqrt(np.abs(squares))
        return values.astype(complex), shapes
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
    value = eigsh(K, k=1, which="LA", v0=start(size), return_eigenvectors=False)
    return float(np.sqrt(max(value[0], 0.0)))


def _need_settled(change: Any, values: Any) -> None:
    """Raise NoModes when eigenvalues still change after all rounds."""
    left = float((change / np.maximum(np.abs(values), 1e-300)).max(initial=0.0))
    if not left <= _ENOUGH:
        raise NoModes(
            f"the modes did not settle in {_ROUNDS} rounds: they still change by {left:.1g} of "
            "themselves; ask for more or fewer modes, or take fewer segments"
        )


def _without(shift: float, values: Floats) -> Floats:
    """Return w^2 from the shifted flexibility; rounding of what moves freely is 0."""
    squares = 1.0 / values - shift**2
    return np.where(np.abs(squares) < 0.01 * shift**2, 0.0, squares)


def _dense(linear: Linear, modes: int) -> tuple[Floats, Floats]:
    """Return all modes: the slow half from the flexibility, the fast half from the stiffness."""
    inverse, shift = find_inverse(linear)
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


def _subspace(linear: Linear, count: int, *, rough: bool = False) -> tuple[Floats, Floats]:
    """Iterate a subspace under the flexibility: equal frequencies are all found.

    Raises NoModes when they do not settle, unless `rough` ones will do.
    """
    inverse, shift = find_inverse(linear)
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
        change, before = np.abs(values - before), values
        if np.all(change <= _SETTLED * np.abs(values)):
            break
    else:
        moves = (_without(shift, values) != 0.0) & (not rough)  # what moves freely is rounding
        _need_settled(change[moves], values[moves])
    vectors = basis @ turn[:, order]
    return _without(shift, values), (vectors / root[:, None]).T


def _damped(linear: Linear, count: int) -> tuple[Complex, Complex]:
    """Return the slowest eigenvalues of (l^2 M + l C + K) u = 0 and their shapes."""
    size = linear.mass.size
    grows = _GROWS
    if size <= _DENSE_DAMPED or count > size // _MOST:
        found, vectors = _whole(linear)
    else:
        found, vectors, rounding = slowest(linear, count)
        grows = max(_GROWS, rounding)
    found = np.where(np.abs(found) <= noise(linear), 0.0, found)
    sizes = np.abs(found)
    found = np.where(np.abs(found.imag) <= 1e-9 * sizes, found.real, found)
    rounds = (np.abs(found.real) <= 1e-12 * sizes) | (
        (found.real > 0.0) & (found.real <= grows * sizes)
    )
    found = np.where(rounds, 1j * found.imag, found)
    upper = found.imag >= 0.0
    found, vectors = found[upper], vectors[:size, upper]
    sizes = np.abs(found) * (
        1.0 - _ALIKE * np.sign(found.real)
    )  # of two alike what grows comes first
    order = np.argsort(sizes, kind="stable")[:count]
    return found[order], vectors[:, order].T


def _whole(linear: Linear) -> tuple[Complex, Complex]:
    """Return all eigenvalues and vectors, from a dense matrix."""
    inverse, shift = find_inverse(linear)
    if shift > 0.0 and not linear.rigid:
        return _companion(linear)
    found, vectors = _inverted(linear, inverse, shift)
    return np.where(np.abs(found) <= 0.1 * shift, 0.0, found), vectors  # moves freely


def _companion(linear: Linear) -> tuple[Complex, Complex]:
    """Return all eigenvalues and vectors of the companion matrix; for what moves freely."""
    size, over = linear.mass.size, 1.0 / linear.mass[:, None]
    rate = float(np.sqrt(np.median(np.abs(linear.stiffness.diagonal()) / linear.mass))) or 1.0
    below = [-over * linear.stiffness.toarray() / rate, -over * linear.friction.toarray()]
    matrix = np.block([[np.zeros((size, size)), rate * np.eye(size)], below])
    values, vectors = np.linalg.eig(matrix)
    values = np.where(np.abs(values) <= 1e-7 * rate, 0.0, values)  # a double zero splits into these
    return values, vectors


def _inverted(
    linear: Linear, inverse: Callable[[Any], Any], shift: float
) -> tuple[Complex, Complex]:
    """Return eigenvalues and vectors of the inverse of the companion matrix."""
    operator = Shifted(linear, shift, rate(linear), inverse)
    values, vectors = np.linalg.eig(operator.apply(np.eye(2 * linear.mass.size)))
    kept = np.abs(values) > 1e-14 * np.abs(values).max()
    return shift + 1.0 / values[kept], vectors[:, kept]


def untangle(values: Complex, shapes: Any, mass: Floats, aside: Floats) -> Complex:
    """Turn the shapes of equal eigenvalues so that they lie in the plane or out of it, and apart.

    Two spans that are alike swing each by itself: what a solver finds is any mixture of both, which has as
    many half waves as its rounding gives.

    Args:
        values: eigenvalues l (m,), sorted by size.
        shapes: (m, 3 f).
        mass: of the unknowns (3 f,) [kg].
        aside: out-of-plane unit vector, repeated for every node (3 f,).
    """
    from scipy.linalg import eigh

    shapes, first = shapes.copy(), 0
    for last in range(1, len(values) + 1):
        if last < len(values) and abs(values[last] - values[first]) <= _ALIKE * abs(values[last]):
            continue
        if last - first > 1:
            group = shapes[first:last]
            group = group / np.sqrt((np.abs(group) ** 2 * mass).sum(axis=1))[:, None]
            part = (group * aside).reshape(last - first, -1, 3).sum(axis=2)
            whole = (group * mass) @ group.conj().T
            if np.linalg.eigvalsh(whole)[0] > _DISTINCT:
                shares, turn = eigh((part * mass[::3]) @ part.conj().T, whole)
                shapes[first:last] = _one_after_another(shares, turn.conj().T @ group, mass)
        first = last
    return np.asarray(shapes, dtype=complex)


def _one_after_another(shares: Floats, shapes: Complex, mass: Floats) -> Complex:
    """Turn orthonormal shapes with equal shares (m,) out of the plane apart: by which nodes move."""
    shapes, place = shapes.copy(), np.arange(mass.size) // 3 * mass
    bounds = [0, *(1 + np.flatnonzero(np.diff(shares) > _SAME_SIDE)), len(shares)]
    for first, last in pairwise(bounds):
        group = shapes[first:last]
        _, turn = np.linalg.eigh((group * place) @ group.conj().T)
        shapes[first:last] = turn.conj().T @ group
    return shapes
