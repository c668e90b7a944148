"""Along a table of times and places: a cubic between rows, linear ones with two coefficients zero.

Constant before the first row and after the last.
"""

from __future__ import annotations

from typing import Any

import numpy as np

from ropewalk.core.jit import kernel, part
from ropewalk.motions.kind import Floats, Motion


def fill(motion: Any, row: Floats) -> Floats:
    """Return the motion's own table."""
    return cubic_rows(motion)


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


def corners(row: Floats, rows: Floats) -> Floats:
    """Return the times of a table at which its velocity jumps: both ends, and corners between."""
    time, slope = rows[:, 0], rows[:, 2::4]
    width = np.diff(time)[:, None]
    arriving = rows[:-1, 2::4] + width * (2.0 * rows[:-1, 3::4] + width * 3.0 * rows[:-1, 4::4])
    jump = np.abs(slope[1:-1] - arriving[:-1]).max(axis=1, initial=0.0)
    corner = np.ones(len(time), dtype=bool)
    corner[1:-1] = jump > 1e-9 * np.abs(slope).max(initial=0.0)
    found: Floats = time[corner]
    return found


def speed(row: Floats, rows: Floats, until: float) -> float:
    """Return the largest speed along a table before a time [m/s], to a millionth.

    Sampled, and where v . a = 0, a cubic. Between two samples v is off the chord by at most h^2 |v''| / 8,
    which says where more may be.
    """
    rows = rows[: max(2, np.searchsorted(rows[:, 0], until) + 1)]
    width = np.clip(until - rows[:-1, 0], 0.0, np.diff(rows[:, 0]))[:, None]
    if not width.any():
        return 0.0
    c1, c2, c3 = (rows[:-1, i::4] for i in (2, 3, 4))
    s = (width * np.linspace(0.0, 1.0, 9))[:, :, None]
    sampled = np.linalg.norm(c1[:, None] + s * (2.0 * c2[:, None] + 3.0 * s * c3[:, None]), axis=2)
    largest = float(sampled.max())
    reach = sampled.max(axis=1) + 0.75 * (width[:, 0] / 8.0) ** 2 * np.linalg.norm(c3, axis=1)
    for i in np.flatnonzero(reach > largest * (1.0 + 1e-6)):
        one, two, three = c1[i], c2[i], c3[i]
        linear = 4.0 * two @ two + 6.0 * one @ three
        tops = np.roots([18.0 * three @ three, 18.0 * two @ three, linear, 2.0 * one @ two])
        at = np.clip(tops.real, 0.0, width[i, 0])[:, None]
        found = np.linalg.norm(one + at * (2.0 * two + 3.0 * at * three), axis=1)
        largest = max(largest, float(found.max(initial=0.0)))
    return largest


@kernel
def table_row(table, first, rows, t):
    """Return the row of a table in which time `t` lies, and 1 where the point moves then, else 0."""
    low, high = first, first + rows - 1
    if t >= table[high, 0]:
        return high, 0.0
    while high - low > 1:
        middle = (low + high) // 2
        if table[middle, 0] <= t:
            low = middle
        else:
            high = middle
    return low, 1.0 if table[first, 0] <= t else 0.0


@kernel
def along_row(table, low, c, s, moving):
    """Return a coordinate `s` after the time of a row, whose c0 is in column `c`, and its rate."""
    c1, c2, c3 = table[low, c + 1], table[low, c + 2], table[low, c + 3]
    found = table[low, c] + s * (c1 + s * (c2 + s * c3))
    return found, moving * (c1 + s * (2.0 * c2 + s * 3.0 * c3))


@kernel
def place_table(table, first, rows, t):
    """Return place and velocity on a table: row = time, then c0..c3 of x, y, z in the time since the row."""
    low, moving = table_row(table, first, rows, t)
    s = max(t - table[low, 0], 0.0) if low < first + rows - 1 else 0.0
    x, vx = along_row(table, low, 1, s, moving)
    y, vy = along_row(table, low, 5, s, moving)
    z, vz = along_row(table, low, 9, s, moving)
    return x, y, z, vx, vy, vz


@part
def place(motions, row, t):
    """Return place and velocity."""
    return place_table(motions.table, motions.table_start[row], motions.table_rows[row], t)


TABLE = Motion(name="table", place=place, fill=fill, speed=speed, jumps=corners)
