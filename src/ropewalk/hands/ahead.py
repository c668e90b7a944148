"""How fast obstacles will go, from now on: what a hand adds to must leave room for it."""

from __future__ import annotations

import math
from typing import Any

import numpy as np

from ropewalk.laws.obstacle import Obstacles
from ropewalk.motions.rows import kind_of, own_jumps, own_table


def speed_ahead(motions: Any, row: int, time: float) -> float:
    """Return the largest speed of a motion from a time [s] on [m/s]; `motions` as `Motions` has them."""
    jumps = own_jumps(motions, row)
    if jumps.size and time >= jumps.max():
        return 0.0  # a table's end, or the stop of what moves evenly
    table = own_table(motions, row)
    now = max(int(np.searchsorted(table[:, 0], time, side="right")) - 1, 0)
    return kind_of(motions, row).speed(motions.params[row], table[now:], math.inf)


def rate_ahead(obstacles: Obstacles, row: int, time: float) -> float:
    """Return the largest rate from a time [s] on [rad/s], of an obstacle that does not turn freely."""
    rate, _, stop = obstacles.spin[row]
    spinning = abs(float(rate)) if time < stop else 0.0
    return spinning + speed_ahead(obstacles.turns, row, time)
