"""Block-banded matrices of 3 x 3 blocks, one row of blocks per node.

The blocks of a node lie together in memory, so that a sweep from node to node, as a factorisation makes it,
reads memory in order. The second off-diagonals are there for laws that join next-but-one nodes
(bending); without such a law they have no rows. With the blocks go the marks of what acts at all:
some laws begin and end abruptly, and a matrix belongs to one side of the jump.
"""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

from ropewalk.core.arrays import Floats, Ints
from ropewalk.core.jit import kernel


class Band(NamedTuple):
    """Blocks, (n, 9) each, row by row: entry 3 k + l of a block is its row k, column l."""

    diagonal: Floats  # row i, column i
    upper1: Floats  # row i, column i + 1
    lower1: Floats  # row i + 1, column i
    upper2: Floats  # row i, column i + 2; (n, 9) or (0, 9)
    lower2: Floats  # row i + 2, column i; (n, 9) or (0, 9)
    rubs: Floats  # (n - 1,) 1 for segments with friction, 0 for slack tension-only ones
    marks: Floats  # (m, n) those of the laws of nodes: a row each, 1 where it acts
    slips: Floats  # (k, 7, n) or (0, 0, n) slip on obstacles in a solve, see `laws.slip_course`
    frozen: Ints  # (1,) 1 where all marks stay during a step, and forces go on smoothly across
    definite: Ints  # (1,) 1 where what is round gives no contact's tangent a negative eigenvalue


def make_band(nodes: int, second: bool = False, marks: int = 0) -> Band:
    """Return a band of zeros; with `second` it has second off-diagonals, and so many rows of `marks`."""
    far = nodes if second else 0
    near, beyond = (nodes, 9), (far, 9)
    shapes = (near, near, near, beyond, beyond)
    blocks = tuple(np.zeros(shape) for shape in shapes)
    rubs, rows = np.ones(max(nodes - 1, 0)), np.zeros((marks, nodes))
    flags = np.zeros(1, np.int64), np.zeros(1, np.int64)
    return Band._make((*blocks, rubs, rows, np.zeros((0, 0, nodes)), *flags))


@kernel
def clear_diagonal(band):
    """Set the blocks on the diagonal to zero."""
    for i in range(band.diagonal.shape[0]):
        for k in range(9):
            band.diagonal[i, k] = 0.0


@kernel
def clear_band(band):
    """Set all blocks to zero."""
    for i in range(band.diagonal.shape[0]):
        for k in range(9):
            band.diagonal[i, k] = 0.0
            band.upper1[i, k] = 0.0
            band.lower1[i, k] = 0.0
    for i in range(band.upper2.shape[0]):
        for k in range(9):
            band.upper2[i, k] = 0.0
            band.lower2[i, k] = 0.0


def triplets(band: Band) -> tuple[Ints, Ints, Floats]:
    """Return rows, columns and values of all blocks' entries; unknown 3 i + k is component k of node i.

    `scipy.sparse.coo_matrix((values, (rows, columns)), shape=(3 n, 3 n))` makes a sparse matrix of it.
    """
    n = len(band.diagonal)
    parts = []
    shifts = ((0, 0), (0, 1), (1, 0), (0, 2), (2, 0))
    for blocks, (down, right) in zip(band[:5], shifts, strict=True):
        count = max(min(len(blocks), n - max(down, right)), 0)
        node = np.arange(count)[:, None, None]
        k, m = np.arange(3)[None, :, None], np.arange(3)[None, None, :]
        rows = np.broadcast_to(3 * (node + down) + k, (count, 3, 3))
        columns = np.broadcast_to(3 * (node + right) + m, (count, 3, 3))
        parts.append((rows.ravel(), columns.ravel(), blocks[:count].ravel()))
    rows, columns, values = (np.concatenate(part) for part in zip(*parts, strict=True))
    return rows, columns, values


def dense(band: Band) -> Floats:
    """Return the matrix in full, (3 n, 3 n); for small n."""
    size = 3 * len(band.diagonal)
    matrix = np.zeros((size, size))
    rows, columns, values = triplets(band)
    matrix[rows, columns] = values
    return matrix
