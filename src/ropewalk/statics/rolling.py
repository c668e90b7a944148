"""What slides far before it comes to rest: it is held at one place of its rope after another.

Where a slide is held, rest is some Newton steps away, and friction would have to carry what holds it there,
R. It goes on in the direction of what drives it, -R, in ways that grow, half as far where it would go beyond
the place at which it is driven no more, and so to within a segment of it. The rest is for what creeps, see
`creep`, which alone would take some ten Newton steps for every segment.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator
from contextlib import contextmanager

import numpy as np

from ropewalk.core.arrays import Floats
from ropewalk.laws.slides.rail import look, point_at
from ropewalk.laws.slides.table import INSIDE, PLACE, SPRING, Slides
from ropewalk.statics.balance import Balance
from ropewalk.statics.coupled import bound_there
from ropewalk.statics.newton import Found
from ropewalk.statics.searching import search

_FIRST, _INNER = 600, 40  # Newton steps for the first place, and for one of the others
_SHARE = 1.0 / 8.0  # of a rope: the longest way between two looks at what drives [1]
_LEAST = 1e-3  # of a segment: the shortest [1]
_FIRM = 25.0  # how much stiffer what holds it along the rope is [1]
_NEAR = 1e-8  # of a segment: a shorter way is none [1]


def roll(balance: Balance, found: Found, see: Callable[[Floats], None]) -> Found:
    """Return places a segment or so before what slides stops, from others.

    The same where there is nothing that slides far, and where obstacles or ropes that touch have a say, too.
    """
    table = balance.coupled.slide
    if not table.node.size or balance.coupled.touch or balance.system.node.obstacle.kind.size:
        return found
    before = balance.kept()
    with _held(balance, table):
        first = last = search(balance, found.x, found.tension, _FIRST)
        steps = last.steps
        if last.at_rest:
            balance.remember(last.x)
            for row in range(table.node.size):
                last, more = _go(balance, table, row, last, see)
                steps += more
    if not last.at_rest or last is first:
        balance.restore(before)
        return found._replace(steps=steps)
    balance.remember(last.x)
    return last._replace(steps=steps)


@contextmanager
def _held(balance: Balance, table: Slides) -> Iterator[None]:
    """Hold all slides where they are."""
    none = np.zeros(table.node.size)
    held = table._replace(
        hold=_FIRM * table.hold, friction=none, brake=none + math.inf, brake_from=none
    )
    balance.put_slides(held)
    try:
        yield
    finally:
        balance.put_slides(table)


def _go(
    balance: Balance, table: Slides, row: int, last: Found, see: Callable[[Floats], None]
) -> tuple[Found, int]:
    """Return where one slide is driven to from a rest in which all are held, and its Newton steps."""
    grip, side, steps = _grip(balance, row), _driven(balance, table, row, last.x), 0
    way, longest = 1.0, _SHARE * float(table.last[row] - table.first[row])
    bars = _bars(balance, table, row)
    while side != 0 and way >= _LEAST:
        kept, here = balance.kept(), float(grip[PLACE])
        free = (side * (bars - here))[side * (bars - here) > 0.0].min(initial=math.inf) - 1.0
        if free < _LEAST:
            break
        there = here + side * min(way, free)
        after = _moved(balance, table, row, last, there)
        steps += after.steps
        if after.at_rest:
            balance.remember(after.x)
        if after.at_rest and _driven(balance, table, row, after.x) == side:
            last, way = after, min(2.0 * way, longest)
            see(last.x)
            continue
        balance.restore(kept)
        if abs(there - here) <= _NEAR:
            break
        way = longest = 0.5 * abs(there - here)
    return last, steps


def _bars(balance: Balance, table: Slides, row: int) -> Floats:
    """Return places of a slide's rope at which the force along it may turn again: none is passed unseen [1].

    Its ends, what is held, tied, loaded or pushed, and other slides.
    """
    state, memory = balance.state, balance.coupled.state.memory.slide
    first, last = int(table.first[row]), int(table.last[row])
    mass, line = state.mass[first : last + 1], slice(first, last + 1)
    bar = (
        ~balance.free[line]
        | (mass > 2.0 * np.median(mass))
        | state.forces.applied[:, line].any(axis=0)
    )
    if balance.number is not None:
        bar |= np.bincount(balance.number)[balance.number[line]] > 1
    bar[[0, -1]] = True
    others = [one for one in np.flatnonzero(table.first == first) if one != row]
    return np.concatenate([np.flatnonzero(bar), memory.grip[others, PLACE]])


def _grip(balance: Balance, row: int) -> Floats:
    """Return what a slide remembers, (2,)."""
    grip: Floats = balance.coupled.state.memory.slide.grip[row]
    return grip


def _driven(balance: Balance, table: Slides, row: int, x: Floats) -> int:
    """Return in which direction along its rope what is held at places (3, n) [m] is driven; 0: in none."""
    memory = balance.coupled.state.memory.slide
    look(x, table, memory, row)
    holds = float(memory.grip[row, SPRING])
    if memory.sight[row, INSIDE] == 0.0 or abs(holds) <= float(
        bound_there(table, memory.sight, row)
    ):
        return 0
    return -1 if holds > 0.0 else 1


def _moved(balance: Balance, table: Slides, row: int, last: Found, there: float) -> Found:
    """Return the rest of what is held at another place of its rope, with all that hangs on it."""
    grip, first, count = (
        _grip(balance, row),
        int(table.first[row]),
        int(table.last[row] - table.first[row]),
    )
    here, there = float(grip[PLACE]), min(max(there, 0.5), count - 0.5)
    x, node = last.x.copy(), int(table.node[row])
    low, high = node, node
    while low > 0 and balance.live[low - 1]:
        low -= 1
    while high < balance.live.size and balance.live[high]:
        high += 1
    ends = balance.coupled.state.memory.slide.ends[row]
    places = (np.array(point_at(last.x, first, ends, place)) for place in (there, here))
    shift = np.subtract(*places)
    x[:, low : high + 1] += np.where(balance.free[low : high + 1], shift[:, None], 0.0)
    grip[PLACE] = there
    return search(balance, x, last.tension, _INNER)
