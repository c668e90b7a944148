"""Motions as rows of parameters for the kernels; see `motions.table` for what is in them."""

from __future__ import annotations

import math
from collections.abc import Sequence
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from ropewalk.motions.table import CODES, ORBIT, SHAKE, TABLE, VELOCITY

Floats = NDArray[np.float64]
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
        params[row, :3] = origins[row]
        kind[row] = CODES["fixed" if motion is None else motion.kind]
        if kind[row] == VELOCITY:
            params[row, 3:6] = motion.velocity
            params[row, 6:8] = motion.start, motion.stop
        elif kind[row] == SHAKE:
            axis = np.array(motion.axis) / math.hypot(*motion.axis)
            params[row, 3:6] = motion.amplitude * axis
            params[row, 6:8] = motion.frequency, motion.phase
        elif kind[row] == ORBIT:
            params[row, 3:6] = motion.center
            params[row, 6:9] = np.array(motion.axis) / math.hypot(*motion.axis)
            params[row, 9] = motion.frequency
        elif kind[row] == TABLE:
            tables.append(cubic_rows(motion))
            start[row], rows[row] = done, len(tables[-1])
            done += len(tables[-1])
    return Motions(kind, params, start, rows, np.ascontiguousarray(np.concatenate(tables)))


def cubic_rows(motion: Any) -> Floats:
    """Return one row per time: the time, then c0..c3 of x, y, z in the time since it.

    Cubic: the natural spline through all places (second derivative zero at both ends);
    de Boor, A Practical Guide to Splines, ch. IV.
    """
    times = np.array(motion.times, dtype=np.float64)
    places = np.array(motion.positions, dtype=np.float64)
    width = np.diff(times)
    slope = np.diff(places, axis=0) / width[:, None]
    bend = np.zeros_like(places)  # second derivatives
    if motion.interpolation == "cubic" and len(times) > 2:
        bend[1:-1] = _solve_spline(width, 6.0 * np.diff(slope, axis=0))
    rows = np.zeros((len(times), 13))
    rows[:, 0] = times
    h = width[:, None]
    rows[:, 1::4] = places
    rows[:-1, 2::4] = slope - h * (2.0 * bend[:-1] + bend[1:]) / 6.0
    rows[:-1, 3::4] = bend[:-1] / 2.0
    rows[:-1, 4::4] = np.diff(bend, axis=0) / (6.0 * h)
    return rows


def _solve_spline(width: Floats, right: Floats) -> Floats:
    """Solve the spline's tridiagonal equations for the inner second derivatives (Thomas)."""
    diagonal = 2.0 * (width[:-1] + width[1:])
    solution = right.copy()
    for i in range(1, len(diagonal)):
        factor = width[i] / diagonal[i - 1]
        diagonal[i] -= factor * width[i]
        solution[i] -= factor * solution[i - 1]
    solution[-1] /= diagonal[-1]
    for i in range(len(diagonal) - 2, -1, -1):
        solution[i] = (solution[i] - width[i + 1] * solution[i + 1]) / diagonal[i]
    return solution


def jumps(motions: Any) -> Floats:
    """Return the times at which a velocity jumps [s]: starts and stops, corners of tables.

    `motions` has the columns of `Motions`.
    """
    times = [motions.params[motions.kind == VELOCITY, 6:8].ravel()]
    for row in np.flatnonzero(motions.kind == TABLE):
        times.append(_corners(own_table(motions, int(row))))
    return np.concatenate(times)


def _corners(rows: Floats) -> Floats:
    """Return the times of a table at which its velocity jumps: both ends, and corners between."""
    time, slope = rows[:, 0], rows[:, 2::4]
    width = np.diff(time)[:, None]
    arriving = rows[:-1, 2::4] + width * (2.0 * rows[:-1, 3::4] + width * 3.0 * rows[:-1, 4::4])
    jump = np.abs(slope[1:-1] - arriving[:-1]).max(axis=1, initial=0.0)
    corner = np.ones(len(time), dtype=bool)
    corner[1:-1] = jump > 1e-9 * np.abs(slope).max(initial=0.0)
    found: Floats = time[corner]
    return found


def largest_speed(motions: Any, row: int) -> float:
    """Return the largest speed of a motion [m/s]; `motions` has the columns of `Motions`."""
    p, kind = motions.params[row], motions.kind[row]
    if kind == VELOCITY:
        return float(np.linalg.norm(p[3:6]))
    if kind == SHAKE:
        return float(2.0 * math.pi * p[6] * np.linalg.norm(p[3:6]))
    if kind == ORBIT:
        return float(2.0 * math.pi * abs(p[9]) * np.linalg.norm(np.cross(p[6:9], p[:3] - p[3:6])))
    if kind == TABLE:
        return _table_speed(own_table(motions, row))
    return 0.0


def own_table(motions: Any, row: int) -> Floats:
    """Return the rows of a motion's own table."""
    first = int(motions.table_start[row])
    found: Floats = motions.table[first : first + int(motions.table_rows[row])]
    return found


def _table_speed(rows: Floats) -> float:
    """Return the largest speed along a table [m/s], from a quadratic per interval sampled 9 times."""
    share = np.linspace(0.0, 1.0, 9)[None, :, None]
    s = share * np.diff(rows[:, 0])[:, None, None]
    c1, c2, c3 = (rows[:-1, None, i::4] for i in (2, 3, 4))
    return float(np.linalg.norm(c1 + s * (2.0 * c2 + 3.0 * s * c3), axis=2).max())
