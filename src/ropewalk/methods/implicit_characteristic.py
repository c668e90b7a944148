"""What one step of the implicit methods does to one mode; see `characteristic` for what a and b are.

With y = (x, v dt) a mode is y' = Z y, Z = ((0, 1), (-a, -b)) for dt = 1, and
    DIRK               y1 = R(Z) y0, stage by stage
    BDF2               3/2 y2 - 2 y1 + 1/2 y0 = Z y2
    generalized-alpha  a step of (x, v dt, a dt^2)
Source: Hairer & Wanner, Solving Ordinary Differential Equations II, IV.3 and V.1; Chung & Hulbert 1993.
"""

from __future__ import annotations

from collections.abc import Callable
from functools import partial

import numpy as np
from numpy.typing import ArrayLike, NDArray

from ropewalk.methods.implicit_methods import IMPLICIT
from ropewalk.methods.tableaus import BDF2, DIRK, Tableau

Array = NDArray[np.float64]
Characteristic = Callable[[ArrayLike, ArrayLike], Array]


def dirk(tableau: Tableau, a: ArrayLike, b: ArrayLike) -> Array:
    """Return the polynomial of a DIRK method's step, monic, highest power first."""
    a, b = np.broadcast_arrays(np.asarray(a, float), np.asarray(b, float))
    Z = np.zeros((*a.shape, 2, 2))
    Z[..., 0, 1], Z[..., 1, 0], Z[..., 1, 1] = 1.0, -a, -b
    one = np.broadcast_to(np.eye(2), Z.shape)
    slopes: list[Array] = []
    for row, weights in enumerate(tableau.A):
        known = one + sum((weights[r] * slope for r, slope in enumerate(slopes)), np.zeros_like(Z))
        stage = np.linalg.solve(one - weights[row] * Z, known)
        slopes.append(Z @ stage)
    if tableau.c[-1] == 1.0:  # the last stage itself: no difference of large numbers
        step = stage
    else:
        step = one + sum((w * s for w, s in zip(tableau.b, slopes, strict=True)), np.zeros_like(Z))
    trace = step[..., 0, 0] + step[..., 1, 1]
    return np.stack([np.ones_like(trace), -trace, np.linalg.det(step)], axis=-1)


def bdf2(a: ArrayLike, b: ArrayLike) -> Array:
    """Return the polynomial of BDF2: p^2 + b p s^2 + a s^4, p = 3/2 s^2 - 2 s + 1/2."""
    a, b = np.broadcast_arrays(np.asarray(a, float), np.asarray(b, float))
    lead = 2.25 + 1.5 * b + a
    rest = (-6.0 - 2.0 * b, 5.5 + 0.5 * b, np.full_like(a, -2.0), np.full_like(a, 0.25))
    return np.stack([np.ones_like(a), *(part / lead for part in rest)], axis=-1)


def generalized_alpha(tableau: Tableau, a: ArrayLike, b: ArrayLike) -> Array:
    """Return the polynomial of generalized-alpha's step, a cubic."""
    a, b = np.broadcast_arrays(np.asarray(a, float), np.asarray(b, float))
    am, af, beta, gamma = tableau.numbers
    # balance: (1-am) w + am w0 + b ((1-af) v + af v0) + a ((1-af) x + af x0) = 0, w the acceleration
    lead = (1.0 - am) + (1.0 - af) * (b * gamma + a * beta)
    row = np.stack(
        [-a, -b - (1.0 - af) * a,
         -am - (1.0 - af) * (b * (1.0 - gamma) + a * (0.5 - beta))], axis=-1
    ) / lead[..., None]  # fmt: skip
    step = np.zeros((*a.shape, 3, 3))
    step[..., 2, :] = row
    step[..., 1, :] = gamma * row + np.array([0.0, 1.0, 1.0 - gamma])
    step[..., 0, :] = beta * row + np.array([1.0, 1.0, 0.5 - beta])
    trace = np.trace(step, axis1=-2, axis2=-1)
    square = np.trace(step @ step, axis1=-2, axis2=-1)
    minors = 0.5 * (trace * trace - square)
    return np.stack([np.ones_like(trace), -trace, minors, -np.linalg.det(step)], axis=-1)


def polynomial_of(tableau: Tableau) -> Characteristic:
    """Return the polynomial of the method of a table."""
    if tableau.kind == BDF2:
        return bdf2
    return partial(dirk if tableau.kind == DIRK else generalized_alpha, tableau)


def implicit_characteristics() -> dict[str, Characteristic]:
    """Return the polynomials by the methods' names."""
    return {method.name: polynomial_of(method.tableau) for method in IMPLICIT}
