"""Carrying the books of contacts with obstacles over into another scene: works go on from where they are."""

from __future__ import annotations

import numpy as np

from ropewalk.core.arrays import Floats, State
from ropewalk.laws.contact_books import GAP, METHOD, MOTOR, PRESS, PRESSED, RUB, RUBBED
from ropewalk.laws.contact_frame import STIFF, find_gaps
from ropewalk.laws.hardening import stored_under
from ropewalk.laws.obstacle import Obstacles
from ropewalk.laws.wheel_rows import ANGLE
from ropewalk.simulation import Simulation

_WORKS, _STORED = [MOTOR, PRESS, RUB, METHOD], [PRESSED, RUBBED]


def carry_books(old: Simulation, made: Simulation, state: State) -> None:
    """Let the works of obstacles go on: node by node where there are as many, else in one place.

    `state` is that of `made`, with the places, springs of friction and held nodes with which it goes on. What
    contacts store more now, as stiffer ones do, an edit has given: the motor has, as in `laws.held_nodes`.
    """
    was, table = old.arrays.memory.obstacle.books, made.system.node.obstacle
    memory = state.memory.obstacle
    now, free = memory.books, memory.held == 0
    now[:, GAP] = _gaps(old, state.x)
    now[:, PRESSED] = stored_under(table, table.thickness - now[:, GAP]) * free
    square, stiff = (memory.grip[:, :3] ** 2).sum(axis=1), memory.grip[:, STIFF]
    now[:, RUBBED] = (
        np.divide(0.5 * square, stiff, out=np.zeros_like(stiff), where=stiff > 0.0) * free
    )
    if was.shape == now.shape:
        now[:, _WORKS] = was[:, _WORKS]
    else:
        now[:, _WORKS] = 0.0
        now[:, _WORKS, 0] = was[:, _WORKS].sum(axis=2)
    more = now[:, _STORED].sum(axis=2) - was[:, _STORED].sum(axis=2)
    now[:, MOTOR, 0] += more.sum(axis=1)
    now[:, [PRESS, RUB], 0] -= more


def _gaps(old: Simulation, x: Floats) -> Floats:
    """Return the distances of places (3, n) to all obstacles as these lie now, (k, n) [m]."""
    table: Obstacles = old.system.node.obstacle
    params, free = table.turns.params.copy(), table.wheel >= 0
    params[free, 0] += old.arrays.memory.obstacle.wheel[table.wheel[free], ANGLE]
    found = np.empty((len(table.kind), x.shape[1]))
    turned = table._replace(turns=table.turns._replace(params=params))
    find_gaps(np.ascontiguousarray(x), turned, old.time, found)
    return found
