"""What is on a contact at most: the mass of all ropes that lie on each other, or are bound to each other.

Ropes elsewhere are on none of them: a pair that touches moves as if it were alone.
"""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from ropewalk.core.arrays import Ints
from ropewalk.core.jit import deferred, small
from ropewalk.laws.pairs.table import CONTACTS

LEAD, HEAVY = 0, 1  # rows of the room: a rope that stands for all of a heap, and what these weigh


def leads(count: int, bound: Sequence[Sequence[int]]) -> Ints:
    """Return for every rope the first of those that are bound to each other, (count,); `bound` are groups."""
    found = np.arange(count)
    for group in bound:
        found[list(group)] = min(group)
    return found


@small
def lead_of(room, r):
    """Return the rope that stands for all that are in a heap with one."""
    while int(room[LEAD, r]) != r:
        r = int(room[LEAD, r])
    return r


@deferred()
def weigh_heaps(table, memory, room):
    """Write what the heap of every rope weighs [kg], see `heavy_of`; `room` has two rows of ropes at least.

    A heap is what contacts, pressed or nearly so, and all that binds hang together.
    """
    ropes = table.total.shape[0]
    for r in range(ropes):
        room[LEAD, r], room[HEAVY, r] = table.lead[r], 0.0
    for row in range(memory.tally[CONTACTS]):
        one = lead_of(room, table.rope[memory.pair[row, 0]])
        other = lead_of(room, table.rope[memory.pair[row, 1]])
        room[LEAD, max(one, other)] = min(one, other)
    for r in range(ropes):  # a rope that stands for others is before them
        room[LEAD, r] = room[LEAD, int(room[LEAD, r])]
        room[HEAVY, int(room[LEAD, r])] += table.total[r]


@small
def heavy_of(table, room, i):
    """Return what all weighs that is in a heap with segment i [kg]."""
    return room[HEAVY, int(room[LEAD, table.rope[i]])]
