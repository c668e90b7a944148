"""Obstacles and joints of a scene, as the `layout` message has them."""

from __future__ import annotations

import math
from typing import Any

import numpy as np

from ropewalk.core.arrays import Floats
from ropewalk.engine.engine import Bodies
from ropewalk.laws.obstacle import Obstacles
from ropewalk.laws.obstacle_places import moves
from ropewalk.laws.obstacle_rows import corners_of
from ropewalk.laws.obstacle_shapes import BOX, MESH
from ropewalk.lowering import Layout
from ropewalk.motions.kind import ORIGIN
from ropewalk.motions.rows import kind_of, own_table
from ropewalk.motions.velocity import INTERVAL, WAY
from ropewalk.record.obstacle_table import obstacle_table
from ropewalk.scene import Obstacle, Scene
from ropewalk.scene.obstacles import has_mass, is_free

_NEVER = 1e9  # [s]


def obstacle_list(
    scene: Scene, where: Layout, bodies: Bodies | None = None
) -> list[dict[str, Any]]:
    """Return the obstacles of a layout message; `bodies` is how they move by hand."""
    table = obstacle_table(scene, where)
    if table is None:
        return []
    if bodies is not None:
        motion = table.motion._replace(kind=bodies.kind, params=bodies.params)
        turns = table.turns._replace(kind=bodies.turning, params=bodies.angles)
        table = table._replace(motion=motion, turns=turns, spin=bodies.spin)
    return [
        {
            "name": body.name or f"obstacle{row}",
            "kind": body.kind,
            "center": _numbers(table.center[row]),
            "axis": _numbers(table.axis[row]),
            "size": _numbers(_size(table, row)),
            "friction": body.friction,
            "spin": _numbers(table.spin[row]) if table.spin[row][0] else None,
            "turnable": not is_free(body),
            "movable": not has_mass(body),
            **_moving(table, row),
            **_turned(table, row),
            **_surface(body),
        }
        for row, body in enumerate(scene.obstacles)
    ]


def _moving(table: Obstacles, row: int) -> dict[str, Any]:
    """Return how an obstacle moves, the angles of one that turns by a table, the number of one that turns
    freely; nothing of one at rest.
    """
    motion, turns = table.motion, table.turns
    found: dict[str, Any] = {}
    if (wheel := int(table.wheel[row])) >= 0:
        found["wheel"] = wheel
    if kind_of(turns, row).name == "table":
        found["turns"] = own_table(turns, row).tolist()
    elif kind_of(turns, row).name == "velocity":  # by hand
        found["turns"] = _two_angles(turns.params[row])
    if moves(table, row):
        rows = own_table(motion, row).tolist()
        found["motion"] = {
            "kind": kind_of(motion, row).name,
            "params": _numbers(motion.params[row]),
            "table": rows,
        }
    return found


def _size(table: Obstacles, row: int) -> Any:
    """Return the size of an obstacle, of a mesh how much it is rounded."""
    size = table.size[row]
    return size[:1] if table.kind[row] == MESH else size[:4]


def _turned(table: Obstacles, row: int) -> dict[str, Any]:
    """Return about what a body turns that is not round, and the direction of a box's first edge."""
    axle = {"axle": _numbers(table.axle[row])} if table.sweeps[row] else {}
    if not np.array_equal(table.hub[row], table.center[row]):
        axle["hub"] = _numbers(table.hub[row])
    return axle | ({"first": _numbers(table.size[row][4:7])} if table.kind[row] == BOX else {})


def _surface(body: Obstacle) -> dict[str, Any]:
    """Return the triangles of a mesh, of others nothing."""
    if body.kind not in ("mesh", "sdf"):
        return {}
    return {
        "vertices": np.round(corners_of(body), 6).ravel().tolist(),
        "faces": [corner for face in body.faces for corner in face],
    }


def _two_angles(params: Floats) -> list[list[float]]:
    """Return what turns evenly for a while as the rows of a table."""
    angle, rate = float(params[ORIGIN][0]), float(params[WAY][0])
    start, stop = float(params[INTERVAL][0]), min(float(params[INTERVAL][1]), _NEVER)
    rest = [0.0] * 10
    return [[start, angle, rate, *rest], [stop, angle + rate * (stop - start), 0.0, *rest]]


def _numbers(values: Any) -> list[float | None]:
    """Return numbers for JSON; what has no end is null."""
    return [float(value) if math.isfinite(value) else None for value in values]


def joint_list(scene: Scene, where: Layout) -> list[dict[str, Any]]:
    """Return the joints of a layout message: which nodes each ties."""
    return [
        {
            "name": joint.name,
            "nodes": [
                where.node(scene.rope_named(tie.rope).node_index(tie.node), tie.rope)
                for tie in joint.points
            ],
        }
        for joint in scene.joints
    ]
