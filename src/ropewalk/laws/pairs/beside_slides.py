"""What lies inside the line that a node slides along: rope next to that node does not touch it there.

Each segment near the node leaves out an interval of the line's segments about the node's place, which goes
along with it. One that the interval would leave behind stays in it until the two are clear of each other, so
that no contact begins pressed: what has run off, or is pulled out of a fold, touches from then on.
"""

from __future__ import annotations

import math

from ropewalk.core.jit import kernel, small
from ropewalk.laws.pairs.distance import nearest
from ropewalk.laws.pairs.pair_memory import drop_gone
from ropewalk.laws.pairs.search import NOWHERE, are_neighbours
from ropewalk.laws.pairs.table import CONTACTS, FROM, GONE, NODE, SEGMENT, SLIDE, TO, WITHIN
from ropewalk.laws.slides.table import PLACE


@small
def is_clear(x, table, memory, i, j):
    """Tell whether segments are clear of each other, or one of them is no rope."""
    if memory.rope[i] < 0 or memory.rope[j] < 0:
        return True
    return nearest(x, x, 0.0, i, j)[2] >= table.radius[i] + table.radius[j]


@kernel
def leave_behind(x, table, memory, row, low, high):
    """Let the interval end where it is to, `low` to `high`, and beyond that where segments are clear."""
    inside, i = memory.inside, table.inside[row, SEGMENT]
    before = inside[row, 0], inside[row, 1]
    if low <= high:
        inside[row, 0], inside[row, 1] = min(before[0], low), max(before[1], high)
    else:
        low, high = inside[row, 1] + 1, inside[row, 0] - 1
    while inside[row, 0] < low and is_clear(x, table, memory, i, inside[row, 0]):
        inside[row, 0] += 1
    while inside[row, 1] > high and is_clear(x, table, memory, i, inside[row, 1]):
        inside[row, 1] -= 1
    return inside[row, 0] != before[0] or inside[row, 1] != before[1]


@small
def first_of(table, row, place):
    """Return the first segment of the line that a row lies in, with its node at a place [1]."""
    first, within = table.inside[row, FROM], table.inside[row, WITHIN]
    return max(first + math.floor(place - within), first)


@small
def last_of(table, row, place):
    """Return the last segment of the line that a row lies in, with its node at a place [1]."""
    first, within = table.inside[row, FROM], table.inside[row, WITHIN]
    return min(first + math.ceil(place + within) - 1, table.inside[row, TO])


@kernel
def begin_inside(x, table, memory):
    """Let all lie in the line where the node is at places (3, n) [m], and on from there while it touches."""
    for row in range(table.inside.shape[0]):
        i, first, last = table.inside[row, SEGMENT], table.inside[row, FROM], table.inside[row, TO]
        at, least, node = first, math.inf, table.inside[row, NODE]
        for j in range(first, last + 2):
            square = 0.0
            for k in range(3):
                square += (x[k, j] - x[k, node]) ** 2
            if square < least:
                at, least = j, square
        low = first_of(
            table, row, at - first - 0.5
        )  # the nearest node is half a segment off at most
        high = last_of(table, row, at - first + 0.5)
        while low > first and not is_clear(x, table, memory, i, low - 1):
            low -= 1
        while high < last and not is_clear(x, table, memory, i, high + 1):
            high += 1
        memory.inside[row, 0], memory.inside[row, 1] = low, high


@kernel
def follow_slides(x, table, memory, grip, off, tied):
    """Let the intervals follow the slides, whose `grip` and `off` are in `laws.slides.table`."""
    changed = False
    for row in range(table.inside.shape[0]):
        slide, low, high = table.inside[row, SLIDE], 0, -1
        if off[slide] == math.inf:
            place = grip[slide, PLACE]
            low, high = first_of(table, row, place), last_of(table, row, place)
        if leave_behind(x, table, memory, row, low, high):
            changed = True
    if not changed:
        return
    memory.origin[0, 0] = NOWHERE
    pair, gone = memory.pair, False
    for row in range(memory.tally[CONTACTS]):
        if are_neighbours(table, memory, tied, pair[row, 0], pair[row, 1]):
            memory.grip[row, GONE], gone = 1.0, True
    if gone:
        drop_gone(memory)
