"""Obstacles as they stand while rest is looked for: at time zero, free ones turned by what is remembered."""

from __future__ import annotations

from typing import Any

import numpy as np

from ropewalk.core.arrays import System
from ropewalk.laws.acting import relaxed
from ropewalk.laws.contact_frame import surface_at
from ropewalk.laws.obstacle_places import standing as still
from ropewalk.laws.wheel_rows import ANGLE
from ropewalk.motions.rows import motion_rows


def standing_obstacles(table: Any, memory: Any) -> Any:
    """Return obstacles that stay where they start, those that turn freely at the angles of their memory."""
    found = still(table)
    if not memory.wheel[:, ANGLE].any():
        return found
    angles = np.zeros_like(table.center)
    for row, w in enumerate(table.wheel):
        angles[row, 0] = surface_at(found, row, 0.0)[6] + (
            memory.wheel[w, ANGLE] if w >= 0 else 0.0
        )
    return found._replace(turns=motion_rows([None] * len(angles), angles))


def standing(system: System, memory: Any) -> System:
    """Return a system whose obstacles stand, see above, and whose laws remember nothing that fades.

    `memory` is `State.memory`.
    """
    system = relaxed(system)
    table = system.node.obstacle
    if not table.spin.size:
        return system
    found = standing_obstacles(table, memory.obstacle)
    return system._replace(node=system.node._replace(obstacle=found))
