"""Contacts of ropes at rest: with points and normals as they are, no depth but that of the points."""

from __future__ import annotations

from ropewalk.core.jit import kernel
from ropewalk.laws.pairs.distance import nearest
from ropewalk.laws.pairs.force import depth_at
from ropewalk.laws.pairs.search import freeze, owns
from ropewalk.laws.pairs.table import CONTACTS, REACH
from ropewalk.laws.pairs.way import begin_contact


@kernel
def straighten(x, table, memory, tied):
    """Give all contacts points and normals as they are at places (3, n) [m].

    A step of a run leaves those that are right to 3 % of a diameter as they are.
    """
    for row in range(memory.tally[CONTACTS]):
        i, j = memory.pair[row, 0], memory.pair[row, 1]
        size = table.radius[i] + table.radius[j]
        s, t, distance = nearest(x, x, 0.0, i, j)
        if 0.0 < distance < REACH * size and owns(x, x, 0.0, table, memory, tied, i, j, s, t):
            freeze(x, x, 0.0, table, memory, row, s, t)
            begin_contact(x, table, memory, row, depth_at(x, memory, row, i, j, size))
