"""Motions as rows of numbers for the kernels; what is in a row its kind says."""

from __future__ import annotations

import math
from collections.abc import Sequence
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from ropewalk.motions.kind import ORIGIN, Floats, Motion
from ropewalk.motions.registry import CODES, FIXED, MOTIONS

Ints = NDArray[np.int64]
PARAMETERS = 16


class Motions(NamedTuple):
    """How things move, one row each; m of them."""

    kind: Ints  # (m,) code of the motion
    params: Floats  # (m, 16) parameters of the motion
    table_start: Ints  # (m,) first row of the motion's own table
    table_rows: Ints  # (m,)
    table: Floats  # (rows, 13) time, then cubic coefficients of x, y, z


def motion_rows(motions: Sequence[Any], origins: Floats) -> Motions:
    """Return the rows of motions as `ropewalk.scene.motions` has them; None stays where it is.

    `origins` are the places at time zero (m, 3) [m], where a motion has none of its own.
    """
    count = len(motions)
    kind, params = np.zeros(count, np.int64), np.zeros((count, PARAMETERS))
    start, rows = np.zeros(count, np.int64), np.zeros(count, np.int64)
    tables, done = [np.zeros((0, 13))], 0
    for row, motion in enumerate(motions):
        params[row, ORIGIN] = origins[row]
        kind[row] = FIXED if motion is None else CODES[motion.kind]
        table = MOTIONS[kind[row]].fill(motion, params[row])
        if table is not None:
            tables.append(table)
            start[row], rows[row] = done, len(table)
            done += len(table)
    return Motions(kind, params, start, rows, np.ascontiguousarray(np.concatenate(tables)))


def kind_of(motions: Any, row: int) -> Motion:
    """Return how a row moves; `motions` has the columns of `Motions`, here and below."""
    return MOTIONS[motions.kind[row]]


def own_table(motions: Any, row: int) -> Floats:
    """Return the rows of a motion's own table."""
    first = int(motions.table_start[row])
    found: Floats = motions.table[first : first + int(motions.table_rows[row])]
    return found


def own_jumps(motions: Any, row: int) -> Floats:
    """Return the times at which the velocity of one motion jumps [s]: starts and stops, corners of tables."""
    return kind_of(motions, row).jumps(motions.params[row], own_table(motions, row))


def jumps(motions: Any) -> Floats:
    """Return the times at which any velocity jumps [s]."""
    rows = range(len(motions.kind))
    return np.concatenate([np.zeros(0), *(own_jumps(motions, row) for row in rows)])


def largest_speed(motions: Any, row: int, until: float = math.inf) -> float:
    """Return the largest speed of a motion before a time [s] [m/s]."""
    return kind_of(motions, row).speed(motions.params[row], own_table(motions, row), until)


def fastest_turn(motions: Any) -> float:
    """Return the largest angular frequency of what shakes or goes round [rad/s]."""
    rows = range(len(motions.kind))
    turns = (kind_of(motions, row).turns(motions.params[row]) for row in rows)
    return max(turns, default=0.0)
