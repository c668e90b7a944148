"""What lies inside the line that a node slides along: rope next to that node does not touch it there.

Each segment near the node leaves out an interval of the line's segments about the node's place, which goes
along with it: in a step it reaches to where the node is at the step's end. One that the interval would leave
behind stays in it until the two are clear of each other, so that no contact begins pressed: what has run off,
or is pulled out of a fold, touches from then on.
"""

from __future__ import annotations

import math

from ropewalk.core.jit import deferred, kernel, small
from ropewalk.laws.pairs.distance import nearest
from ropewalk.laws.pairs.pair_memory import drop_gone
from ropewalk.laws.pairs.search import NOWHERE, are_neighbours
from ropewalk.laws.pairs.table import (
    CONTACTS,
    FROM,
    GONE,
    NODE,
    SEGMENT,
    SLIDE,
    START,
    TO,
    WITHIN,
)
from ropewalk.laws.slides.rail import nearest_place
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
    inside = table.inside[row]
    low = inside[START] + math.floor(place - inside[WITHIN])
    return min(max(low, inside[FROM]), inside[TO])


@small
def last_of(table, row, place):
    """Return the last segment of the line that a row lies in, with its node at a place [1]."""
    inside = table.inside[row]
    high = inside[START] + math.ceil(place + inside[WITHIN]) - 1
    return min(max(high, inside[FROM]), inside[TO])


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
        place = at - table.inside[row, START]  # the nearest node is half a segment off at most
        low, high = first_of(table, row, place - 0.5), last_of(table, row, place + 0.5)
        while low > first and not is_clear(x, table, memory, i, low - 1):
            low -= 1
        while high < last and not is_clear(x, table, memory, i, high + 1):
            high += 1
        memory.inside[row, 0], memory.inside[row, 1] = low, high


@small
def about_node(x, table, slide, row):
    """Return the interval about a row's node at places (3, n) [m]; an empty one where it has run off."""
    inside = table.inside[row]
    one = inside[SLIDE]
    if slide.off[one] < math.inf:
        return 0, -1
    place = nearest_place(x, inside[NODE], inside[START], slide.ends[one], slide.grip[one, PLACE])
    return first_of(table, row, place), last_of(table, row, place)


@kernel
def let_in(table, memory, tied):
    """Give up the contacts of what lies in its line now; tell whether there were any."""
    memory.origin[0, 0] = NOWHERE
    pair, gone = memory.pair, False
    for row in range(memory.tally[CONTACTS]):
        if are_neighbours(table, memory, tied, pair[row, 0], pair[row, 1]):
            memory.grip[row, GONE], gone = 1.0, True
    if gone:
        drop_gone(memory)
    return gone


@deferred()
def follow_slides(x, table, memory, slide, tied):
    """Let the intervals follow the slides, whose memory is `slide`, to places (3, n) [m]."""
    changed = False
    for row in range(table.inside.shape[0]):
        low, high = about_node(x, table, slide, row)
        if leave_behind(x, table, memory, row, low, high):
            changed = True
    if changed:
        let_in(table, memory, tied)


@deferred("boolean")
def reach_ahead(y, table, memory, slide, tied):
    """Let the intervals reach to where a step ends, y (3, n) [m]; tell whether contacts are given up.

    In a step of many segments what slides would touch the line between, and be braked by its own rope.
    """
    changed, inside = False, memory.inside
    for row in range(table.inside.shape[0]):
        low, high = about_node(y, table, slide, row)
        if low <= high and (low < inside[row, 0] or high > inside[row, 1]):
            inside[row, 0], inside[row, 1] = min(inside[row, 0], low), max(inside[row, 1], high)
            changed = True
    return changed and let_in(table, memory, tied)
