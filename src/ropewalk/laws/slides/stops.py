"""Stops at drums: how far from there they stand, NEAREST segments as these are stretched.

One that nothing presses on follows the stretch, but comes no nearer to what slides than it is. One that is
pressed on stays, unless segments are stretched so much that it would be nearer than CLEAR of them: then it is
moved out, and what that gives is kept.
"""

from __future__ import annotations

import math

from ropewalk.core.jit import kernel, small
from ropewalk.laws.slides.table import CLEAR, DRUM, GIVEN, NEAREST


@small
def to_drum(x, table, memory, row, side):
    """Return the stop's drum, how far a slide is pressed into it, and the way from there (3,) [m].

    -1 where there is no drum on this side, or where it is farther away.
    """
    drum, node = memory.ends[row, DRUM + side], table.node[row]
    if drum < 0:
        return -1, 0.0, 0.0, 0.0, 0.0, 1.0
    a, b, c = x[0, node] - x[0, drum], x[1, node] - x[1, drum], x[2, node] - x[2, drum]
    apart = math.sqrt(a * a + b * b + c * c)
    deep = memory.stops[row, side] - apart
    if deep <= 0.0 or apart == 0.0:
        return -1, 0.0, 0.0, 0.0, 0.0, 1.0
    return drum, deep, a / apart, b / apart, c / apart, apart


@small
def stretch_at(x, table, memory, row, side):
    """Return how long the two whole segments next to a drum are over their own length, 1 at least."""
    step, drum, most = 1 - 2 * side, memory.ends[row, DRUM + side], 1.0
    for n in range(1, 3):
        a, b = drum + n * step, drum + (n + 1) * step
        if table.lowest[row] <= b <= table.highest[row]:
            square = 0.0
            for k in range(3):
                square += (x[k, b] - x[k, a]) ** 2
            most = max(most, math.sqrt(square) / table.length[row])
    return most


@kernel
def move_stops(x, table, memory, row):
    """Let a slide's stops follow the stretch at places (3, n) [m]."""
    stops, node = memory.stops, table.node[row]
    for side in range(2):
        drum = memory.ends[row, DRUM + side]
        if drum < 0:
            continue
        square = 0.0
        for k in range(3):
            square += (x[k, node] - x[k, drum]) ** 2
        apart, before = math.sqrt(square), stops[row, side]
        segment = table.length[row] * stretch_at(x, table, memory, row, side)
        if apart >= before:
            stops[row, side] = min(NEAREST * segment, apart)
        elif before < CLEAR * segment:
            stops[row, side] = CLEAR * segment
            more = (CLEAR * segment - apart) ** 2 - (before - apart) ** 2
            stops[row, GIVEN] += 0.5 * table.stiffness[row] * more
