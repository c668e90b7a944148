"""Matrices that the solvers never form, in full."""

from __future__ import annotations

import numpy as np

from ropewalk.core.arrays import BENDING, Floats, State, System
from ropewalk.core.band import Band, dense
from ropewalk.core.saddle import Saddle
from ropewalk.laws.tangent import assemble_tangent, law_band


def dense_saddle(saddle: Saddle) -> tuple[Floats, Floats]:
    """Return matrix and right side in full, unknowns all z node by node, then all T'."""
    n = len(saddle.free)
    size = 3 * n
    matrix, right = np.zeros((size + n - 1, size + n - 1)), np.zeros(size + n - 1)
    matrix[:size, :size] = dense(saddle.band) + np.diag(np.repeat(saddle.inertia, 3))
    right[:size], right[size:] = saddle.force.T.ravel(), -saddle.misfit
    for j in range(n - 1):
        t, row = saddle.direction[:, j], size + j
        low, high = slice(3 * j, 3 * j + 3), slice(3 * j + 3, 3 * j + 6)
        line = np.outer(t, t)
        block = saddle.across[j] * (np.eye(3) - line) + saddle.along[j] * line
        block += np.outer(t, saddle.lean[:, j])
        for p, q, sign in (
            (low, low, 1.0),
            (high, high, 1.0),
            (low, high, -1.0),
            (high, low, -1.0),
        ):
            matrix[p, q] += sign * block
        matrix[low, row], matrix[high, row] = -t, t
        matrix[row, low] = -saddle.carries[j] * t
        matrix[row, high] = saddle.carries[j] * t
        matrix[row, row] = -saddle.compliance[j]
    for i in np.flatnonzero(saddle.free == 0.0):
        rows = slice(3 * i, 3 * i + 3)
        matrix[rows], right[rows] = 0.0, 0.0
        matrix[rows, rows] = np.eye(3)
    return matrix, right


def stiffness_and_friction(
    system: System, state: State, x: Floats | None = None, v: Floats | None = None
) -> tuple[Band, Band]:
    """Return -dF/dx [N/m] and -dF/dv [N s/m] at `x` and `v`, (3, n); by default at the state's own."""
    x, v = (state.x if x is None else x), (state.v if v is None else v)
    found = []
    for weights in ((1.0, 0.0), (0.0, 1.0)):
        band = law_band(x.shape[1], second=bool(system.flags[BENDING]))
        assemble_tangent(system, state, x, v, *weights, band)
        found.append(band)
    return found[0], found[1]
