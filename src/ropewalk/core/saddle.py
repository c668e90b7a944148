"""Newton's equations of a chain with the segments' tensions as unknowns of their own; solved in O(n).

Unknowns are the displacement z of every node and the change T' of every segment's tension:
    node i      L z_(i-1) + A z_i + U z_(i+1) - t_i T'_i + t_(i-1) T'_(i-1) = f_i
    segment j   d_j t_j . (z_(j+1) - z_j) - e_j T'_j = -g_j
with t the unit vectors, e the compliance 1/k, g the misfit of the length and d = 0 for a segment that carries
nothing. Where forces along the segments follow the nodes' motion, the nodes have t_j lean_j . (z_(j+1) - z_j)
besides. A, L, U hold inertia, geometric stiffness, friction and all other laws, but no spring constant: no
number in the elimination grows with k, and k = inf (e = 0) is a rigid link.

The matrix is given in two parts: inertia of the nodes and across I + (along - across) t t^T of the segments,
which most ropes need only, and a band of blocks for all else. `sweep` solves the first kind from both ends at
once, `leaning_sweep` that with `lean` and the blocks on the band's diagonal, `band_sweep` any without `lean`;
where joints tie nodes, `network` does.
"""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

from ropewalk.core.arrays import Floats
from ropewalk.core.band import Band, dense, make_band
from ropewalk.core.network import Network, no_network


class Saddle(NamedTuple):
    """Equations, solution and factors; rows of (3, n) arrays are components."""

    band: Band  # what inertia, across and along do not hold
    free: Floats  # (n,) 1 for free nodes, 0 for held ones
    inertia: Floats  # (n,) on the diagonal, positive for held nodes, too [N/m]
    across: Floats  # (s,) [N/m]
    along: Floats  # (s,) [N/m]
    direction: Floats  # (3, s) unit vectors of the segments
    carries: Floats  # (s,) 1 for segments whose tension follows from their length, else 0
    compliance: Floats  # (s,) [m/N]
    force: Floats  # (3, n) right side of the nodes, f [N]
    misfit: Floats  # (s,) g [m]
    lean: Floats  # (3, s), see `leaning` [N/m]
    moved: Floats  # (3, n) solution z [m]
    pulled: Floats  # (s,) solution T' [N]
    factor: Floats  # (n, 16) what the way back needs
    far_factor: Floats  # (n, 12) the same of second off-diagonals; (0, 12) without them
    network: Network  # of nodes that joints tie; an empty one without joints


def make_saddle(nodes: int, second: bool = False, marks: int = 0) -> Saddle:
    """Return equations of zeros; `second` and `marks` are those of the band, see `make_band`."""
    n, s = nodes, nodes - 1
    shapes = (n, n, s, s, (3, s), s, s, (3, n), s, (3, s), (3, n), s, (n, 16), (n * second, 12))
    arrays = [np.zeros(shape) for shape in shapes]
    return Saddle._make((make_band(n, second, marks), *arrays, no_network()))


def dense_saddle(saddle: Saddle) -> tuple[Floats, Floats]:
    """Return matrix and right side in full, unknowns all z node by node, then all T'; for tests."""
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
