"""Where ropes have been: a box about each segment, grown with every step that is accepted.

Ropes that move apart from each other, in arrays of their own, are watched by these: where no two boxes
overlap no segments have come as near as contacts begin; see `engine.meetings`.
"""

from __future__ import annotations

import math

import numpy as np

from ropewalk.core.arrays import Floats, Ints
from ropewalk.core.jit import kernel, seldom, small
from ropewalk.core.peaks import greater, lesser
from ropewalk.laws.pairs.table import REACH

RUN = 1  # most segments of a run: boxes of long ones meet where no segment comes near
# Columns: low corner, high corner [m], first and last segment.
LOW, HIGH, FROM, TO, WIDTH = 0, 3, 6, 7, 8
# Where there are wheels, too: corners of the box that obstacles reach its nodes from, parted ones, too [m],
# and for how long on they take hold of what comes, see `laws.closing` [s].
HELD_LOW, HELD_HIGH, AHEAD, HELD_WIDTH = 8, 11, 14, 15
STAGES = 1.5  # [1] how much faster than at both ends of a step a stage may be


def runs_of(rope: Ints) -> Floats:
    """Return the runs of segments (k, WIDTH), none of two ropes; `rope` (s,) is -1 between ropes."""
    ends = np.flatnonzero(np.diff(rope, append=-2) != 0) + 1
    starts = np.concatenate([[0], ends])[:-1]
    found = [
        (first, min(first + RUN, end) - 1)
        for start, end in zip(starts.tolist(), ends.tolist(), strict=True)
        for first in range(start, end, RUN)
        if rope[start] >= 0
    ]
    swept = np.zeros((len(found), WIDTH))
    swept[:, LOW:HIGH], swept[:, HIGH:FROM] = np.inf, -np.inf
    swept[:, FROM:] = np.array(found, np.float64).reshape(-1, 2)
    return swept


@kernel
def sweep(x, y, memory):
    """Widen the hulls of nodes by the ways from x to y, (3, n) [m]: boxes follow, see `settle`."""
    hull = memory.hull
    _widen(x[0], y[0], hull[0], hull[3])
    _widen(x[1], y[1], hull[1], hull[4])
    _widen(x[2], y[2], hull[2], hull[5])


@small
def _widen(x, y, low, high):
    for i in range(low.shape[0]):
        low[i] = lesser(y[i], lesser(x[i], low[i]))
        high[i] = greater(y[i], greater(x[i], high[i]))


@kernel
def settle(table, memory):
    """Widen the boxes by the hulls of their nodes, and let these begin anew."""
    swept, hull = memory.swept, memory.hull
    for run in range(swept.shape[0]):
        for j in range(int(swept[run, FROM]), int(swept[run, TO]) + 1):
            if memory.rope[j] < 0:
                continue
            wide = REACH * table.radius[j]
            for k in range(3):
                low = min(hull[k, j], hull[k, j + 1]) - wide
                high = max(hull[3 + k, j], hull[3 + k, j + 1]) + wide
                swept[run, LOW + k] = min(swept[run, LOW + k], low)
                swept[run, HIGH + k] = max(swept[run, HIGH + k], high)
    clear_hull(hull)


@kernel
def clear_hull(hull):
    """Let the hulls of nodes begin anew."""
    for k in range(3):
        for i in range(hull.shape[1]):
            hull[k, i], hull[3 + k, i] = np.inf, -np.inf


@kernel
def sweep_held(x, v, swept):
    """Widen the boxes of what obstacles reach by all nodes at x and v (3, n), however fast they come.

    A surface whose nearest point is at d from a node takes hold of it where |d| < T v . d / |d|, T = AHEAD:
    in the ball that has T v for a diameter.
    """
    for run in range(swept.shape[0]):
        half = 0.5 * STAGES * swept[run, AHEAD]
        for i in range(int(swept[run, FROM]), int(swept[run, TO]) + 2):
            wide = half * math.sqrt(v[0, i] ** 2 + v[1, i] ** 2 + v[2, i] ** 2)
            for k in range(3):
                low, high, middle = HELD_LOW + k, HELD_HIGH + k, x[k, i] + half * v[k, i]
                swept[run, low] = min(swept[run, low], x[k, i], middle - wide)
                swept[run, high] = max(swept[run, high], x[k, i], middle + wide)


@seldom
def place_held(x, v, y, w, swept):
    """Let the boxes of what obstacles reach begin at x and v, and at y and w, (3, n)."""
    for run in range(swept.shape[0]):
        for k in range(3):
            swept[run, HELD_LOW + k], swept[run, HELD_HIGH + k] = np.inf, -np.inf
    sweep_held(x, v, swept)
    sweep_held(y, w, swept)


def with_held(swept: Floats, ahead: Floats) -> Floats:
    """Return runs with the box of what obstacles reach; `ahead` (n,) is for how long on at every node [s]."""
    found = np.zeros((len(swept), HELD_WIDTH))
    found[:, :WIDTH] = swept[:, :WIDTH]
    found[:, HELD_LOW:HELD_HIGH], found[:, HELD_HIGH:AHEAD] = np.inf, -np.inf
    for run, (first, last) in enumerate(swept[:, FROM:WIDTH].astype(np.int64)):
        found[run, AHEAD] = ahead[first : last + 2].max()
    return found


@seldom
def place_boxes(x, y, stiffness, radius, swept, hull):
    """Let boxes begin about all that stands at x, and the straight ways from there to y, (3, n) [m].

    What is no finite number is told on, and so meets nobody.
    """
    clear_hull(hull)
    for run in range(swept.shape[0]):
        for k in range(3):
            lowest, highest, lost = np.inf, -np.inf, False
            for j in range(int(swept[run, FROM]), int(swept[run, TO]) + 1):
                if not stiffness[j] > 0.0:
                    continue
                wide = REACH * radius[j]
                low = min(min(x[k, j], x[k, j + 1]), min(y[k, j], y[k, j + 1])) - wide
                high = max(max(x[k, j], x[k, j + 1]), max(y[k, j], y[k, j + 1])) + wide
                for i in range(j, j + 2):
                    lost = lost or x[k, i] != x[k, i] or y[k, i] != y[k, i]
                lowest, highest = min(lowest, low), max(highest, high)
            swept[run, LOW + k] = np.nan if lost else lowest
            swept[run, HIGH + k] = np.nan if lost else highest
