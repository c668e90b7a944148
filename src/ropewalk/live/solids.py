"""Obstacles and joints of a scene, as the `layout` message has them."""

from __future__ import annotations

import math
from typing import Any

from ropewalk.lowering import Layout
from ropewalk.record.obstacle_table import obstacle_table
from ropewalk.scene import Scene


def obstacle_list(scene: Scene, where: Layout) -> list[dict[str, Any]]:
    """Return the obstacles of a layout message."""
    table = obstacle_table(scene, where)
    if table is None:
        return []
    return [
        {
            "name": body.name or f"obstacle{row}",
            "kind": body.kind,
            "center": _numbers(table.center[row]),
            "axis": _numbers(table.axis[row]),
            "size": _numbers(table.size[row]),
            "friction": body.friction,
            "spin": _numbers(table.spin[row]) if table.spin[row][0] else None,
        }
        for row, body in enumerate(scene.obstacles)
    ]


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
