"""Between which nodes of its rope a slide runs: off the drums, on the part of a broken one that it is on."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING

import numpy as np

from ropewalk.core.arrays import Floats, Ints
from ropewalk.core.jit import deferred, kernel
from ropewalk.laws.slides.rail import nearest_place
from ropewalk.laws.slides.table import DRUM, ENDS, HIGH, HIGHEST, LOOSE, LOW, LOWEST, PLACE

if TYPE_CHECKING:
    from numpy.typing import NDArray

    from ropewalk.laws.slides.table import Slides


def whole(count: int) -> Ints:
    """Return the ends of a whole rope of so many segments without drums, see `table`."""
    found = np.zeros(ENDS, np.int64)
    found[HIGH] = found[HIGHEST] = count
    found[DRUM:] = -1
    return found


def place_near(table: Slides, row: int, x: Floats, ends: Ints) -> float:
    """Return the place on its rope that is nearest to a node, of all places (3, n) [m] between `ends`."""
    node, first = int(table.node[row]), int(table.first[row])
    low, high = int(ends[LOW]), int(ends[HIGH])
    away = np.square(x[:, first + low : first + high + 1] - x[:, [node]]).sum(axis=0)
    return float(nearest_place(x, node, first, ends, float(low + np.argmin(away))))


def live_ends(
    table: Slides, row: int, x: Floats, live: NDArray[np.bool_], start: float = math.nan
) -> Ints:
    """Return the ends of the piece of rope about place `start` [1], NaN: of that nearest to the node.

    `live` (s,) tells where there is rope. What is not, and goes on to an end with a drum, is on that; else it
    has parted.
    """
    first, lowest, highest = int(table.first[row]), int(table.lowest[row]), int(table.highest[row])
    away = np.square(x[:, lowest : highest + 1] - x[:, [int(table.node[row])]]).sum(axis=0)
    there = np.flatnonzero(live[lowest:highest])
    far = away[there] + away[there + 1]
    if start == start:
        far = np.abs(there + lowest - first + 0.5 - start)
    low = high = lowest + int(there[np.argmin(far)])
    while low > lowest and live[low - 1]:
        low -= 1
    while high < highest and live[high]:
        high += 1
    found = whole(0)
    found[[LOW, HIGH, LOWEST, HIGHEST]] = np.array([low, high, lowest, highest]) - first
    sides = ((low, live[lowest:low]), (high, live[high:highest]))
    for side, (end, beyond) in enumerate(sides):
        at_drum = table.winch[row, side] >= 0 and not beyond.any()
        found[DRUM + side] = end if at_drum else -1
        found[LOOSE + side] = beyond.size > 0 and not at_drum
    return found


@kernel
def follow_drums(table, memory, exits, held, anchors):
    """Let slides run as far as there is rope off the drums; a drum that was let go is none."""
    for row in range(memory.off.shape[0]):
        for side in range(2):
            winch = table.winch[row, side]
            if winch >= 0 and memory.ends[row, LOOSE + side] == 0:
                memory.ends[row, LOW + side] = exits[winch] - table.first[row]
                memory.ends[row, DRUM + side] = exits[winch] if held[anchors[winch]] == 1 else -1


@deferred()
def part_line(table, memory, segment, time):
    """Leave every slide the part of its rope that it is on, where `segment` (its first node) has parted.

    Within a segment of there the curve leads across what has parted: such a slide is off at once.
    """
    for row in range(memory.off.shape[0]):
        gone, place = segment - table.first[row], memory.grip[row, PLACE]
        ends = memory.ends[row]
        if not ends[LOW] <= gone < ends[HIGH] or memory.off[row] < math.inf:
            continue
        if abs(place - gone - 0.5) < 1.0:
            memory.off[row] = time
            continue
        side = 1 if place < gone else 0
        ends[LOW + side] = gone + 1 - side
        ends[LOOSE + side], ends[DRUM + side] = 1, -1
