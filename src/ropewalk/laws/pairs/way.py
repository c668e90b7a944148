"""The way of a step: nothing passes through anything.

A step may stand where all pairs that come near on its way are contacts that were solved for, none came
nearer than half the radii's sum, or half as near as it was, and none ends pressed by more than a tenth of
that sum, but for those that were already. Pairs that touch on the way become contacts, with points and
normal as they are then, and the step is solved again; if that does not help, it is to be halved. No centre
line moves through another in a step that stands, whatever the solver did.
"""

from __future__ import annotations

from ropewalk.core.jit import deferred, kernel, small
from ropewalk.laws.pairs.distance import NEVER, comes_to, nearest, relative_way
from ropewalk.laws.pairs.search import find_near, freeze, new_row, normal_at, owns, row_of
from ropewalk.laws.pairs.table import (
    APART,
    BRAKE,
    CONTACTS,
    DEEPEST,
    EXTRA,
    FAULT,
    FIRST,
    FOUND,
    FULL,
    LAYER,
    MORE,
    NEAR,
    NEW,
    NORMAL,
    OTHER,
    OWN,
    REFUSED,
    ROUNDS,
    SECOND,
    SEEN,
    STIFF,
    WAS,
    WRONG,
    apart,
    between,
    depth_of,
    spring_of,
)

FINE, AGAIN, HALVE = range(3)  # see `laws.couplings`
MOST_ROUNDS = 6  # solutions of one step
WARY_ROUNDS = 3  # of which so many for the sake of normals alone
GIVES = 1.0 - 1e-9  # [1] to which the distance of a pair pressed deeper may shrink: rounding
HALF = 0.5
SHORT = 5e-5  # [s] steps so short are not halved for what their contacts have not seen
MORE_AT_ONCE = (
    0.005  # [1] by so much of the radii's sum a contact presses more that counted too little
)


@kernel
def begin_contact(x, table, memory, row, before):
    """Let a contact whose points were found anew remember from the places at hand on.

    It was pressed by `before` [m] and counts as pressed so still: its force does not jump. One that was open
    begins with none. The difference is held to WRONG: what counts as open for long would be pressed through.
    """
    i, j, grip = memory.pair[row, 0], memory.pair[row, 1], memory.grip
    u = apart(x, grip, row, i, j)
    grip[row, APART], grip[row, APART + 1], grip[row, APART + 2] = u
    soft, _, _, _, size = spring_of(table, grip, row, i, j)
    grip[row, STIFF] = max(grip[row, STIFF], soft)
    grip[row, MORE] = 0.0
    more = max(before, 0.0) - max(depth_of(grip, row, u, size), 0.0)
    grip[row, MORE] = min(max(more, -WRONG * size), WRONG * size)
    grip[row, WAS] = grip[row, MORE]


@kernel
def fits(x, y, share, memory, row, s, t, size, before):
    """Tell whether a contact pressed by `before` [m] at x is pressed about so with a plane of the way, too.

    A plane that has turned far from the start, on a way that may not even stand, would press there what does
    not touch: force and energy from nothing.
    """
    i, j = memory.pair[row, 0], memory.pair[row, 1]
    n = normal_at(x, y, share, memory, row, s, t)
    u = between(x, i, j, s, t)
    depth = size - (n[0] * u[0] + n[1] * u[1] + n[2] * u[2])
    return abs(max(depth, 0.0) - max(before, 0.0)) <= WRONG * size


@kernel
def add_contact(x, y, share, table, memory, tied, i, j):
    """Make a contact of a pair that touches at a share of the way from x to y; return how many."""
    s, t, _ = nearest(x, y, share, i, j)
    if not owns(x, y, share, table, memory, tied, i, j, s, t):
        return 0
    row = -1 - row_of(memory, i, j)
    if not new_row(memory, i, j, row):
        memory.tally[FAULT] = FULL
        return 0
    if not fits(x, y, share, memory, row, s, t, table.radius[i] + table.radius[j], 0.0):
        share = 0.0
        s, t, _ = nearest(x, y, share, i, j)
    freeze(x, y, share, table, memory, row, s, t)
    begin_contact(x, table, memory, row, 0.0)
    memory.grip[row, FOUND] = 1.0
    return 1


@kernel
def plane_gap(y, memory, row, size):
    """Return how far apart a contact holds its pair to be [m]."""
    grip, i, j = memory.grip, memory.pair[row, 0], memory.pair[row, 1]
    u = between(y, i, j, grip[row, OWN], grip[row, OTHER])
    n0, n1, n2 = grip[row, NORMAL], grip[row, NORMAL + 1], grip[row, NORMAL + 2]
    return n0 * u[0] + n1 * u[1] + n2 * u[2] - size


@kernel
def turn_contact(x, y, table, memory, row, hit, end):
    """Give a contact that is wrong at y points and normal that are right there, or where it touched."""
    i, j, grip = memory.pair[row, 0], memory.pair[row, 1], memory.grip
    share = 1.0
    if end[2] > 0.0:
        u = between(y, i, j, end[0], end[1])
        n0, n1, n2 = grip[row, NORMAL], grip[row, NORMAL + 1], grip[row, NORMAL + 2]
        if n0 * u[0] + n1 * u[1] + n2 * u[2] < 0.5 * end[2]:
            share = hit
    if share > 1.0:
        return 0
    size = table.radius[i] + table.radius[j]
    before = depth_of(grip, row, between(x, i, j, grip[row, OWN], grip[row, OTHER]), size)
    s, t, _ = nearest(x, y, share, i, j)
    if not fits(x, y, share, memory, row, s, t, size, before):
        return 0
    freeze(x, y, share, table, memory, row, s, t)
    begin_contact(x, table, memory, row, before)
    grip[row, BRAKE] = NEW  # it closes otherwise than it did
    return 1


@kernel
def leaps(y, table, memory, tied, row, end, way, size):
    """Tell whether a contact would count as pressed far deeper, once its points are found anew at y.

    Its plane has seen nothing of it, and what it would have stored nobody has given.
    """
    i, j, grip = memory.pair[row, 0], memory.pair[row, 1], memory.grip
    deep = size - end[2] - WRONG * size
    if not (way > WRONG * size and deep > LAYER * size):
        return False
    counted = depth_of(grip, row, between(y, i, j, grip[row, OWN], grip[row, OTHER]), size)
    return deep > counted and owns(y, y, 0.0, table, memory, tied, i, j, end[0], end[1])


@kernel
def press_more(memory, row, size):
    """Let a contact count as deeper that is as deep as may be, but counts as less; return whether it did."""
    grip = memory.grip
    more = min(MORE_AT_ONCE * size, -grip[row, MORE])
    if more <= 0.0:
        return 0
    grip[row, MORE] += more
    grip[row, EXTRA] += more
    return 1


@kernel
def press_less(memory):
    """Take back by how much more contacts press than at the beginning of a step that cannot stand."""
    grip = memory.grip
    for row in range(memory.tally[CONTACTS]):
        grip[row, MORE] -= grip[row, EXTRA]
        grip[row, EXTRA] = 0.0


@small
def refuse(memory, i, j):
    """Note which pair is why a step cannot stand."""
    memory.tally[REFUSED] = 1
    memory.tally[FIRST], memory.tally[SECOND] = i, j


@deferred("int64")
def meet_pairs(x, y, table, memory, tied, dt):
    """Look at the way from x to y, in `dt` [s]: return FINE, AGAIN where contacts have changed, or HALVE."""
    count = memory.tally
    if not find_near(x, y, table, memory, tied):
        return HALVE
    more, bad = 0, 0
    for k in range(count[NEAR]):
        i, j = memory.near[k, 0], memory.near[k, 1]
        size = table.radius[i] + table.radius[j]
        end = nearest(x, y, 1.0, i, j)
        start, way = nearest(x, y, 0.0, i, j)[2], relative_way(x, y, i, j)
        row, least = row_of(memory, i, j), HALF * (start + end[2] - way)
        if row < 0 and least >= size:
            continue
        limit = HALF * min(size, start)
        through = least < limit and comes_to(x, y, i, j, limit, start, way) < NEVER
        too_deep = end[2] < DEEPEST * size and end[2] < GIVES * start
        hit = NEVER
        if least < size and (row < 0 or through or too_deep):
            hit = comes_to(x, y, i, j, size, start, way)
        changed = 0
        if row < 0:
            if hit < NEVER:
                changed = add_contact(x, y, hit, table, memory, tied, i, j)
            if changed == 0 and end[2] < size:  # it touches elsewhere than where it began to
                changed = add_contact(x, y, 1.0, table, memory, tied, i, j)
        else:
            gap = plane_gap(y, memory, row, size)
            off = abs(end[2] - size - gap) > WRONG * size and (end[2] < size or gap < 0.0)
            # past a node the next segment has the contact: its normal is not to lean towards the node
            own = count[ROUNDS] < WARY_ROUNDS and owns(
                y, y, 0.0, table, memory, tied, i, j, end[0], end[1]
            )
            if off and (through or too_deep or own):
                hit = comes_to(x, y, i, j, size, start, way) if hit == NEVER else hit
                changed = turn_contact(x, y, table, memory, row, hit, end)
        if too_deep and changed == 0 and row >= 0:
            changed = press_more(memory, row, size)
        leap = dt > SHORT and changed == 0 and row >= 0
        leap = leap and leaps(y, table, memory, tied, row, end, way, size)
        more += changed
        if through or too_deep or leap:
            bad += 1
            refuse(memory, i, j)
    if count[FAULT] == FULL or (bad > 0 and more == 0) or count[ROUNDS] >= MOST_ROUNDS:
        count[ROUNDS] = 0
        press_less(memory)
        return HALVE
    if more > 0:
        count[ROUNDS] += 1
        return AGAIN
    count[ROUNDS], count[SEEN] = 0, 1
    return FINE
