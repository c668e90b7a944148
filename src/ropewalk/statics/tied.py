"""The equations of rest of ropes that joints tie: nodes that are tied are one unknown place."""

from __future__ import annotations

import numpy as np

from ropewalk.core.arrays import Floats, Ints
from ropewalk.core.elimination import points_of
from ropewalk.lowering import Model, Span
from ropewalk.scene.joint import tied_ropes
from ropewalk.theory.borrowed import load_scipy


def points(model: Model) -> Ints | None:
    """Return the number of every node's point, (n,); None where nothing is tied."""
    joints = model.system.joints
    if not joints.member.size:
        return None
    return points_of(joints, model.state.tied, model.layout.nodes)


def together(number: Ints, force: Floats) -> Floats:
    """Return for every node the force on all nodes of its point, (3, n)."""
    sums = np.stack([np.bincount(number, row) for row in force])
    return np.asarray(sums[:, number])


def solve_tied(
    matrix: Floats,
    right: Floats,
    reach: int,
    number: Ints,
    more: tuple[Ints, Ints, Floats] | None = None,
) -> float:
    """As `core.band_lu.solve_band` for the nodes' places and the segments' tensions, of points.

    `matrix` (4 n, 3 reach + 1) and `right` (4 n,) are those of the nodes by themselves: three places and the
    tension of the segment after it for each. `more` are rows, columns and values beyond the band. The
    solution is in `right`.
    """
    load_scipy()
    from scipy import sparse
    from scipy.sparse.linalg import splu

    n = number.size
    rows = np.repeat(np.arange(4 * n), 2 * reach + 1)
    columns = rows + np.tile(np.arange(-reach, reach + 1), 4 * n)
    values = matrix[:, : 2 * reach + 1].ravel()
    there = (columns >= 0) & (columns < 4 * n) & (values != 0.0)
    count = int(number.max()) + 1
    unknown = np.empty(4 * n, np.int64)
    for k in range(3):
        unknown[k::4] = 3 * number + k
    unknown[3::4] = 3 * count + np.arange(n)
    size = 3 * count + n
    rows, columns, values = rows[there], columns[there], values[there]
    if more is not None:
        pairs = zip((rows, columns, values), more, strict=True)
        rows, columns, values = (np.concatenate(both) for both in pairs)
    entries = values, (unknown[rows], unknown[columns])
    whole = sparse.coo_array(entries, shape=(size, size)).tocsc()
    forces = np.bincount(unknown, right, size)
    try:
        factors = splu(whole)
    except RuntimeError:  # exactly singular
        return 0.0
    right[:] = factors.solve(forces)[unknown]
    pivots = np.abs(factors.U.diagonal())
    return float(pivots.min() / pivots.max()) if np.isfinite(right).all() else 0.0


def partners(model: Model, rope: Span) -> list[Span]:
    """Return the ropes that a rope is tied to, directly or by others, itself included."""
    number = model.scene.rope_index(rope.name)
    for group in tied_ropes(model.scene.ropes, model.scene.joints):
        if number in group:
            return [model.layout.ropes[i] for i in group]
    return [rope]


def tied_nodes(model: Model, rope: Span) -> set[int]:
    """Return the nodes of a rope that joints tie, as indices of the arrays."""
    return {int(i) for i in model.system.joints.member if rope.start <= i <= rope.end}
