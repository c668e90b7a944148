"""Which segments may touch: those whose boxes overlap, see `boxes`, and the rows of what does."""

from __future__ import annotations

import math

from ropewalk.core.jit import deferred, kernel, small
from ropewalk.laws.pairs.boxes import begin_of, grow_tree, next_leaf, overlap
from ropewalk.laws.pairs.distance import on_way, product
from ropewalk.laws.pairs.easing import ease_levers
from ropewalk.laws.pairs.strung_out import is_strung_out
from ropewalk.laws.pairs.swept import settle
from ropewalk.laws.pairs.table import (
    CONTACTS,
    LEAN,
    LEVER,
    NEAR,
    NORMAL,
    OTHER,
    OWN,
    REACH,
    WIDTH,
    friction_of,
)

NOWHERE = 1e150  # [m] so far are all nodes from where a list was made that does not count


@small
def are_neighbours(table, memory, tied, i, j):
    """Tell whether segments i < j are so near along a rope, at a joint or a slide, that they always touch."""
    if table.rope[i] == table.rope[j] and j - i <= table.skip[i]:
        return True
    for a in range(2):
        joint = table.joint[i, a]
        if joint >= 0 and tied[joint] == 1:
            if table.joint[j, 0] == joint or table.joint[j, 1] == joint:
                return True
    for a in range(table.slides.shape[1]):
        one, two = table.slides[i, a], table.slides[j, a]
        if one >= 0 and memory.inside[one, 0] <= j <= memory.inside[one, 1]:
            return True
        if two >= 0 and memory.inside[two, 0] <= i <= memory.inside[two, 1]:
            return True
    return False


@kernel
def moved_from(origin, x):
    """Return how far the node has moved that has moved farthest [m]."""
    most = 0.0
    for i in range(x.shape[1]):
        square = 0.0
        for k in range(3):
            square += (x[k, i] - origin[k, i]) ** 2
        most = max(most, square)
    return math.sqrt(most)


@kernel
def box_in(x, y, table, memory):
    """Write the boxes in which segments move from x to y, (s, 6), wide enough that those near overlap.

    What is no rope has one that holds nothing: it makes no other wider, and none meets it.
    """
    box = memory.box
    for j in range(box.shape[0]):
        wide = REACH * table.radius[j] + 0.5 * table.skin[0]
        for k in range(3):
            low = min(min(x[k, j], x[k, j + 1]), min(y[k, j], y[k, j + 1]))
            high = max(max(x[k, j], x[k, j + 1]), max(y[k, j], y[k, j + 1]))
            if memory.rope[j] < 0:
                low, high, wide = NOWHERE, -NOWHERE, 0.0
            box[j, k], box[j, 3 + k] = low - wide, high + wide


@kernel
def list_between(leaves, one, other, table, memory, tied, found):
    """List the pairs whose boxes overlap of two leaves, or within one; return how many there are then.

    -1: there is no room for them.
    """
    box, order, near, rope, tree = memory.box, memory.order, memory.near, memory.rope, memory.tree
    for a in range(begin_of(leaves, order, one), begin_of(leaves, order, one + 1)):
        p = order[a]
        if rope[p] < 0 or not overlap(box, p, tree, other):
            continue
        begin = a + 1 if one == other else begin_of(leaves, order, other)
        for b in range(begin, begin_of(leaves, order, other + 1)):
            q = order[b]
            if rope[q] < 0 or not overlap(box, p, box, q):
                continue
            i, j = min(p, q), max(p, q)
            if are_neighbours(table, memory, tied, i, j):
                continue
            if found == near.shape[0]:
                return -1
            near[found, 0], near[found, 1] = i, j
            found += 1
    return found


@deferred("boolean")
def list_near(x, y, table, memory, tied):
    """List the pairs whose boxes overlap on the way from x to y; return whether there was room for them."""
    box_in(x, y, table, memory)
    leaves, found = grow_tree(memory.box, memory.order, memory.tree), 0
    memory.tally[NEAR] = 0
    for leaf in range(leaves, 2 * leaves):
        other = leaf
        while other > 0:
            found = list_between(leaves, leaf, other, table, memory, tied, found)
            if found < 0:
                memory.origin[0, 0] = NOWHERE  # the list is not whole: it is made anew
                return False
            other = next_leaf(memory.tree, leaves, leaf, other)
    memory.tally[NEAR] = found
    for k in range(3):
        for i in range(y.shape[1]):
            memory.origin[k, i] = y[k, i]
    return True


@kernel
def find_near(x, y, table, memory, tied):
    """Have all pairs listed that come near on the way from x to y; return whether there was room."""
    if is_strung_out(x, y, table, memory):
        memory.tally[NEAR], memory.origin[0, 0] = 0, NOWHERE
        return True
    half = 0.5 * table.skin[0]
    if moved_from(memory.origin, x) <= half and moved_from(memory.origin, y) <= half:
        return True
    return list_near(x, y, table, memory, tied)


@deferred()
def note_ropes(table, memory, stiffness):
    """Note which segments are rope, and have not parted; where that has changed lists are made anew."""
    changed, rope, own = 0, memory.rope, table.rope
    for j in range(rope.shape[0]):
        there = own[j] if stiffness[j] > 0.0 else -1
        changed += 1 if there != rope[j] else 0
    if changed > 0:
        settle(table, memory)  # what has parted has been where it was
        for j in range(rope.shape[0]):
            rope[j] = own[j] if stiffness[j] > 0.0 else -1
        memory.origin[0, 0] = NOWHERE


@kernel
def row_of(memory, i, j):
    """Return the row of a contact, or -1 less the row before which it belongs."""
    pair, low, high = memory.pair, 0, memory.tally[CONTACTS]
    while low < high:
        middle = (low + high) // 2
        a, b = pair[middle, 0], pair[middle, 1]
        if a < i or (a == i and b < j):
            low = middle + 1
        else:
            high = middle
    if low < memory.tally[CONTACTS] and pair[low, 0] == i and pair[low, 1] == j:
        return low
    return -1 - low


@kernel
def new_row(memory, i, j, at):
    """Make room for a contact as row `at`, all zero; return whether there was any."""
    pair, grip, count = memory.pair, memory.grip, memory.tally
    last = count[CONTACTS]
    if last == pair.shape[0]:
        return False
    for back in range(last - at):
        row = last - back
        pair[row, 0], pair[row, 1] = pair[row - 1, 0], pair[row - 1, 1]
        for k in range(WIDTH):
            grip[row, k] = grip[row - 1, k]
    pair[at, 0], pair[at, 1] = i, j
    for k in range(WIDTH):
        grip[at, k] = 0.0
    count[CONTACTS] = last + 1
    return True


@kernel
def is_next(x, y, share, i, s, p):
    """Tell whether a point beyond segment i's end is nearer to the inside of segment i + 1, or to both alike.

    `p` is a point of the other segment.
    """
    if s < 1.0:
        return False
    a, b = on_way(x, y, share, i + 1), on_way(x, y, share, i + 2)
    along = (b[0] - a[0], b[1] - a[1], b[2] - a[2])
    away = (p[0] - a[0], p[1] - a[1], p[2] - a[2])
    return product(along, away) > 0.0


@kernel
def owns(x, y, share, table, memory, tied, i, j, s, t):
    """Tell whether the nearest points of segments i < j are theirs, and not those of segments beside them.

    A contact at a node is that of the segment before it, where that one may touch at all.
    """
    rope = memory.rope
    if s <= 0.0 and i > 0 and rope[i - 1] == rope[i]:
        if not are_neighbours(table, memory, tied, i - 1, j):
            return False
    if t <= 0.0 and rope[j - 1] == rope[j] and j - 1 > i:
        if not are_neighbours(table, memory, tied, i, j - 1):
            return False
    if s >= 1.0 and i + 1 < j and rope[i + 1] == rope[i]:
        c, e = on_way(x, y, share, j), on_way(x, y, share, j + 1)
        p = ((1.0 - t) * c[0] + t * e[0], (1.0 - t) * c[1] + t * e[1], (1.0 - t) * c[2] + t * e[2])
        if is_next(x, y, share, i, s, p) and not are_neighbours(table, memory, tied, i + 1, j):
            return False
    if t >= 1.0 and j + 1 < rope.shape[0] and rope[j + 1] == rope[j]:
        c, e = on_way(x, y, share, i), on_way(x, y, share, i + 1)
        p = ((1.0 - s) * c[0] + s * e[0], (1.0 - s) * c[1] + s * e[1], (1.0 - s) * c[2] + s * e[2])
        if is_next(x, y, share, j, t, p) and not are_neighbours(table, memory, tied, i, j + 1):
            return False
    return True


@kernel
def between_on_way(x, y, share, i, j, s, t):
    """Return the vector from a point of segment j to one of segment i at a share of the way."""
    a, b = on_way(x, y, share, i), on_way(x, y, share, i + 1)
    c, e = on_way(x, y, share, j), on_way(x, y, share, j + 1)
    return (
        (1.0 - s) * a[0] + s * b[0] - ((1.0 - t) * c[0] + t * e[0]),
        (1.0 - s) * a[1] + s * b[1] - ((1.0 - t) * c[1] + t * e[1]),
        (1.0 - s) * a[2] + s * b[2] - ((1.0 - t) * c[2] + t * e[2]),
    )


@kernel
def normal_at(x, y, share, memory, row, s, t):
    """Return the normal of a contact as it is at a share of the way; without one, that it has."""
    i, j, grip = memory.pair[row, 0], memory.pair[row, 1], memory.grip
    u0, u1, u2 = between_on_way(x, y, share, i, j, s, t)
    size = math.sqrt(u0 * u0 + u1 * u1 + u2 * u2)
    if size > 0.0:
        return (u0 / size, u1 / size, u2 / size)
    return (grip[row, NORMAL], grip[row, NORMAL + 1], grip[row, NORMAL + 2])


@kernel
def across(x, y, share, i, n):
    """Return the part of the vector along segment i across n at a share of the way, and its size squared.

    The size is no smaller than LEAN of the segment's: at a node the normal may lean towards it.
    """
    a, b = on_way(x, y, share, i), on_way(x, y, share, i + 1)
    e0, e1, e2 = b[0] - a[0], b[1] - a[1], b[2] - a[2]
    en = e0 * n[0] + e1 * n[1] + e2 * n[2]
    p = (e0 - en * n[0], e1 - en * n[1], e2 - en * n[2])
    return p, max(product(p, p), LEAN * (e0 * e0 + e1 * e1 + e2 * e2))


@kernel
def freeze(x, y, share, table, memory, row, s, t):
    """Give a contact points, normal and levers as they are at a share of the way.

    Where the points are one it keeps the normal that it has. The levers are those of strands that are within
    30 degrees of parallel, and none from 60 degrees on: what turns round a strand across it rubs. Without
    friction they are those of `easing`.
    """
    n, grip = normal_at(x, y, share, memory, row, s, t), memory.grip
    grip[row, OWN], grip[row, OTHER] = s, t
    grip[row, NORMAL], grip[row, NORMAL + 1], grip[row, NORMAL + 2] = n
    i, j = memory.pair[row, 0], memory.pair[row, 1]
    e, ee = across(x, y, share, i, n)
    f, ff = across(x, y, share, j, n)
    parallel, own, other = 0.0, 0.0, 0.0
    if ee > 0.0 and ff > 0.0:
        parallel = min(max(2.0 * product(e, f) ** 2 / (ee * ff) - 0.5, 0.0), 1.0)
    if parallel > 0.0:
        gap = product(between_on_way(x, y, share, i, j, s, t), n)
        part = parallel * gap / (table.radius[i] + table.radius[j])
        own = part * min(table.radius[i] / math.sqrt(ee), table.lever[i]) / math.sqrt(ee)
        other = part * min(table.radius[j] / math.sqrt(ff), table.lever[j]) / math.sqrt(ff)
    if friction_of(table, i, j) == 0.0:
        ease_levers(memory, row, e, f, s, t, table.radius[i] + table.radius[j])
        return
    for k in range(3):
        grip[row, LEVER + k], grip[row, LEVER + 3 + k] = own * e[k], other * f[k]
