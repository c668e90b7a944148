"""Motions of anchors as rows of parameters for the kernels."""

from __future__ import annotations

import math

import numpy as np

from ropewalk.core.arrays import Anchors, Floats, Ints
from ropewalk.motions.table import CODES
from ropewalk.scene import Anchor, Orbit, Shake, Table, Velocity

PARAMETERS = 16


def anchor_tables(anchors: tuple[Anchor, ...], origins: Floats, nodes: Ints) -> Anchors:
    """Return the anchors' tables; `origins` are the held nodes' initial places (a, 3) [m]."""
    count = len(anchors)
    params = np.zeros((count, PARAMETERS))
    start, rows = np.zeros(count, np.int64), np.zeros(count, np.int64)
    tables = [np.zeros((0, 13))]
    for row, anchor in enumerate(anchors):
        params[row, :3] = origins[row]
        match anchor.motion:
            case Velocity() as motion:
                params[row, 3:6] = motion.velocity
                params[row, 6:8] = motion.start, motion.stop
            case Shake() as motion:
                axis = np.array(motion.axis) / math.hypot(*motion.axis)
                params[row, 3:6] = motion.amplitude * axis
                params[row, 6:8] = motion.frequency, motion.phase
            case Orbit() as motion:
                params[row, 3:6] = motion.center
                params[row, 6:9] = np.array(motion.axis) / math.hypot(*motion.axis)
                params[row, 9] = motion.frequency
            case Table() as motion:
                start[row] = sum(len(table) for table in tables)
                tables.append(cubic_rows(motion))
                rows[row] = len(tables[-1])
    release = [math.inf if a.release_time is None else a.release_time for a in anchors]
    return Anchors(
        release=np.array(release, dtype=np.float64),
        first_release=min(release, default=math.inf),
        above_ground=np.array([a.above_ground for a in anchors], dtype=np.int64),
        kind=np.array([CODES[a.motion.kind] for a in anchors], dtype=np.int64),
        params=params,
        table_start=start,
        table_rows=rows,
        table=np.ascontiguousarray(np.concatenate(tables)),
        order=np.argsort(nodes, kind="stable"),
    )


def cubic_rows(motion: Table) -> Floats:
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
