"""A closed surface of triangles as the row of numbers that `triangles` searches."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from ropewalk.core.arrays import Floats, Ints
from ropewalk.laws.triangles import BOX_WIDTH, HEAD, NORMAL_WIDTH, TRIANGLE_WIDTH

_LEAF = 4  # triangles that need no smaller boxes
_SLIVER = 1e-7  # of the mesh's size: lower triangles have no direction of their own [1]
_CHAIN = 8  # slivers side by side


def mesh_row(vertices: Floats, faces: Ints, rounding: float) -> Floats:
    """Return the row of a mesh of vertices (v, 3) [m] and faces (f, 3), counter-clockwise from outside."""
    corners = vertices[faces]  # (f, 3, 3)
    order, boxes = _boxes(corners)
    normals = _normals(vertices, faces)
    begin = HEAD + boxes.size
    after = begin + TRIANGLE_WIDTH * len(faces)
    head = [rounding, len(boxes), begin, after]
    row: Floats = np.concatenate(
        [head, boxes.ravel(), corners[order].ravel(), normals[order].ravel()]
    )
    assert len(row) == after + NORMAL_WIDTH * len(faces)
    return row


def _boxes(corners: Floats) -> tuple[Ints, Floats]:
    """Return the order of the triangles and their boxes, (b, 9): each is followed by those in it.

    Triangles of a box are halved at the median of their middles along its longest side.
    """
    middles, order = corners.mean(axis=1), np.arange(len(corners))
    rows: list[list[float]] = []
    waiting = [(0, len(corners), -1)]  # first triangle, one past the last, -1 or whose end this is
    while waiting:
        first, last, ends = waiting.pop()
        if ends >= 0:
            rows[ends][6] = len(rows)
            continue
        own = corners[order[first:last]].reshape(-1, 3)
        low, high = own.min(axis=0), own.max(axis=0)
        leaf = last - first <= _LEAF
        rows.append([*low, *high, 0, first, last - first if leaf else 0])
        waiting.append((0, 0, len(rows) - 1))
        if not leaf:
            side, half = int(np.argmax(high - low)), (last - first) // 2
            part = np.argpartition(middles[order[first:last], side], half)
            order[first:last] = order[first:last][part]
            waiting += [(first + half, last, -1), (first, first + half, -1)]
    return order, np.array(rows, dtype=np.float64).reshape(-1, BOX_WIDTH)


def _normals(vertices: Floats, faces: Ints) -> Floats:
    """Return the normals of faces, edges (both faces') and corners (weighted by angles), (f, 7, 3)."""
    corners = vertices[faces]
    along = np.roll(corners, -1, axis=1) - corners  # ab, bc, ca
    pairs = np.sort(np.stack([faces, np.roll(faces, -1, axis=1)], axis=2).reshape(-1, 2), axis=1)
    _, which = np.unique(pairs, axis=0, return_inverse=True)
    face = _face_normals(along, which.reshape(-1, 3))
    edges = _summed(which, np.repeat(face, 3, axis=0)).reshape(-1, 3, 3)
    toward, back = _unit(along), _unit(-np.roll(along, 1, axis=1))
    angle = np.arccos(np.clip((toward * back).sum(axis=2), -1.0, 1.0))
    weighted = (angle[:, :, None] * face[:, None]).reshape(-1, 3)
    at_corners = _summed(faces.ravel(), weighted).reshape(-1, 3, 3)
    return np.concatenate([face[:, None], _unit(edges), _unit(at_corners)], axis=1)


def _face_normals(along: Floats, edges: Ints) -> Floats:
    """Return the normals of faces with sides (f, 3, 3) and the numbers of their edges, (f, 3).

    That of a sliver would be rounding, and would turn the sides of its edges over: it has that of the
    neighbour at its longest side.
    """
    across = np.cross(along[:, 0], -along[:, 2])
    sides = np.linalg.norm(along, axis=2)
    area, size = np.linalg.norm(across, axis=1), sides.max()
    rows = np.arange(len(along))
    both = np.zeros(int(edges.max()) + 1, dtype=np.int64)
    np.add.at(both, edges, rows[:, None])  # the two faces of an edge, added up
    beside = both[edges[rows, sides.argmax(axis=1)]] - rows
    slivers = area < _SLIVER * size * sides.max(axis=1)
    face = _unit(across)
    for _ in range(_CHAIN):
        face[slivers] = face[beside[slivers]]
    return face


def _summed(which: NDArray[np.int64], vectors: Floats) -> Floats:
    """Return, for each row, the sum of the vectors of all rows of its number, (n, 3)."""
    total = np.zeros((int(which.max()) + 1, 3))
    np.add.at(total, which.ravel(), vectors)
    return total[which.ravel()]


def _unit(vectors: Floats) -> Floats:
    size = np.linalg.norm(vectors, axis=-1, keepdims=True)
    found: Floats = vectors / np.where(size > 0.0, size, 1.0)
    return found
