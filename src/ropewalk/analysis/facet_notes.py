"""What `check` says of ropes that turn with friction on a solid of triangles, whose facets are bumps to them.

A node is pressed across the facet it lies on. Where that is tilted by e against the middle of the rope's turn
a there, tensions change by the factor exp(e a) besides friction's exp(mu a), however many nodes there are:
facets that meet at b tilt by b/2 at most, so that friction acts as one of mu - b/2 to mu + b/2. One edge
alone, as a ridge, is no facet of something round: more nodes on its rounding help there, see `coarse_turns`.
"""

from __future__ import annotations

import math

import numpy as np

from ropewalk.core.arrays import Floats, Ints
from ropewalk.laws.obstacle import Obstacles
from ropewalk.laws.obstacle_places import depths
from ropewalk.laws.obstacle_shapes import MESH
from ropewalk.laws.triangles import AB, FACE, NORMAL_WIDTH, NORMALS, TRIANGLES
from ropewalk.lowering import Model
from ropewalk.statics import Statics

_LIES = 0.1  # [1] diameters off a surface within which a node is on it
_DRAWN = 0.5  # [1] the same where there is no rest: drawn ropes are put round the edges, with room
_TURNS = math.radians(20.0)  # by which a rope turns on it in all
_FLAT, _EDGE = 1e-3, math.radians(50.0)  # between which facets stand for something round
_LINE = 1e-6  # [1] of an edge by which another may lie off it
_SMALL = 0.1  # [1] of friction: what bumps add or take that is not told


def facet_warnings(model: Model, statics: Statics) -> list[str]:
    """Return a sentence for every mesh with facets too coarse for the friction of a rope that turns on it."""
    table: Obstacles = model.system.node.obstacle
    x = statics.positions.T if statics.solved else model.state.x
    if not (np.asarray(table.kind) == MESH).any():
        return []
    off = _LIES if statics.solved else _DRAWN
    near = depths(table, np.ascontiguousarray(x)) > -off * table.diameter
    found = []
    for row in np.flatnonzero(table.kind == MESH).tolist():
        for rope, span in zip(model.scene.ropes, model.layout.ropes, strict=True):
            nodes = np.arange(span.start + 1, span.end)
            nodes = nodes[near[row, nodes]]
            friction = float(table.friction[row, span.start])
            if not friction > 0.0 or not _turn(x, nodes) > _TURNS:
                continue
            reach = rope.segment_length + float(table.thickness[span.start])
            angle = _facets_meet(table, row, x[:, nodes].T, reach)
            if 0.5 * angle > _SMALL * friction:
                found.append(
                    f"obstacle {model.scene.obstacles[row].name!r}: its triangles meet at "
                    f"{math.degrees(angle):.2g} degrees where rope {rope.name!r} turns on it, and are bumps: "
                    f"tensions change as with a friction of {friction:.3g} plus or minus up to "
                    f"{0.5 * angle:.2g} there, with any number of nodes; take a cylinder, capsule, sphere, "
                    f"torus or box where one will do, or triangles that meet at "
                    f"{math.degrees(2.0 * _SMALL * friction):.2g} degrees or less"
                )
    return found


def _turn(x: Floats, nodes: Ints) -> float:
    """Return by how much a rope turns at some of its inner nodes in all [rad]."""
    a, b = x[:, nodes] - x[:, nodes - 1], x[:, nodes + 1] - x[:, nodes]
    across = np.linalg.norm(np.cross(a, b, axis=0), axis=0)
    return float(np.arctan2(across, (a * b).sum(axis=0)).sum())


def _facets_meet(table: Obstacles, row: int, places: Floats, reach: float) -> float:
    """Return the mean angle [rad] of edges within `reach` [m] of places (n, 3), by length; 0 without any.

    Of those that are neither flat nor sharp; 0 where all of them are one edge. The normal of an edge is that
    of both its triangles' sum.
    """
    size = table.size[row]
    begin, after = int(size[TRIANGLES]), int(size[NORMALS])
    corners = size[begin:after].reshape(-1, 3, 3) + table.center[row]
    count = len(corners)
    normals = size[after : after + NORMAL_WIDTH * count].reshape(count, -1, 3)
    own, edge = normals[:, FACE, None], normals[:, AB : AB + 3]
    across = np.linalg.norm(np.cross(own, edge), axis=2)
    angle = 2.0 * np.arctan2(across, (own * edge).sum(axis=2))  # (f, 3)
    bends = (angle > _FLAT) & (angle < _EDGE)
    first = corners[bends]
    along = (np.roll(corners, -1, axis=1) - corners)[bends]
    square, close = (along * along).sum(axis=1), np.zeros(len(first), bool)
    for place in places:
        share = np.clip(((place - first) * along).sum(axis=1) / square, 0.0, 1.0)
        close |= np.linalg.norm(place - first - share[:, None] * along, axis=1) < reach
    if not close.any() or _is_one(first[close], along[close]):
        return 0.0
    return float(np.average(angle[bends][close], weights=np.sqrt(square[close])))


def _is_one(begins: Floats, along: Floats) -> bool:
    """Tell whether edges from places (k, 3) [m] along vectors (k, 3) lie on one line."""
    way = along[0] / np.linalg.norm(along[0])
    off = [
        np.linalg.norm(np.cross(ends - begins[0], way), axis=1) for ends in (begins, begins + along)
    ]
    return bool(np.max(off) < _LINE * np.linalg.norm(along, axis=1).max())
