"""What contacts of segments keep from an accepted step to the next.

The friction spring's part P (R' - k_t D), cut to mu R_n: a force, so that what sticks does not creep. One
keeps its points and its normal as long as they say where the segments are to WRONG of the radii's sum, and
it counts as less deep by no more, with its offset: the nearest points of almost parallel segments jump from
step to step, and contacts would slip a little in each.
One that has wandered on to the next segment passes on what it holds. Those that slip get theirs in every
step, as they will be at its end. Those that throw back get them as they are while they are open, or swing.
"""

from __future__ import annotations

import math

from ropewalk.core.jit import deferred, kernel, small
from ropewalk.laws.pairs.distance import (
    NEVER,
    comes_to,
    less,
    nearest,
    on_way,
    product,
    relative_way,
)
from ropewalk.laws.pairs.easing import convex, ease, slow
from ropewalk.laws.pairs.force import depth_at, pressed, pull_of, squeeze
from ropewalk.laws.pairs.offsets import KEEPS, lead_offsets, lies_still, misses
from ropewalk.laws.pairs.pair_hits import swings
from ropewalk.laws.pairs.search import find_near, freeze, new_row, normal_at, owns, row_of
from ropewalk.laws.pairs.swept import sweep
from ropewalk.laws.pairs.table import (
    APART,
    CONTACTS,
    FAULT,
    FIRST,
    FOUND,
    FULL,
    GONE,
    LAYER,
    LEFT,
    MORE,
    NEAR,
    NORMAL,
    OTHER,
    OWN,
    PASSED,
    PUSH,
    REACH,
    REFUSED,
    ROUNDS,
    SECOND,
    SEEN,
    SETTLES,
    SPRING,
    STIFF,
    WIDTH,
    WRONG,
    apart,
    between,
    depth_of,
    friction_of,
    spring_of,
    throws_back,
)
from ropewalk.laws.pairs.way import HALF, begin_contact, fits

TURNED = 5e-5  # [1] less than the cosine of a hundredth: so little no plane is led
RESTS = 1e-8  # [1/s] of the same: rounding
JUST_OVER = 1.0 + 1e-6  # [1] of what a contact may hide, for what was found anew with all of that
EVEN = 1e-3  # [1] weight of the speeds along segments, over that of what they do not explain
AT_LIMIT = 1.0 - 1e-9  # [1] of what friction can carry counts as all of it


@kernel
def look_for_passes(x, y, memory, table):
    """Note a fault where a pair comes nearer on the way from x to y than a step may let it."""
    count = memory.tally
    for k in range(count[NEAR]):
        i, j = memory.near[k, 0], memory.near[k, 1]
        size = table.radius[i] + table.radius[j]
        start, way = nearest(x, y, 0.0, i, j)[2], relative_way(x, y, i, j)
        limit = HALF * min(size, start)
        if start - way < limit and comes_to(x, y, i, j, limit, start, way) < NEVER:
            count[FAULT], count[FIRST], count[SECOND] = PASSED, i, j


@small
def is_right(y, memory, row, size, distance):
    """Tell whether points and normal of a contact say how far apart its segments are.

    Nor may it count as less deep than they are by more than it may when it is found anew, or it would jump.
    """
    grip, i, j = memory.grip, memory.pair[row, 0], memory.pair[row, 1]
    u = between(y, i, j, grip[row, OWN], grip[row, OTHER])
    along, square = 0.0, 0.0
    for k in range(3):
        along += grip[row, NORMAL + k] * u[k]
        square += u[k] * u[k]
    aside = math.sqrt(max(square - along * along, 0.0))
    counted = max(size + grip[row, MORE] - along, 0.0)
    if size - distance - counted > JUST_OVER * WRONG * size:
        return False
    return abs(distance - along) <= WRONG * size and aside <= WRONG * size


@kernel
def hold(x, v, table, memory, row):
    """Keep what a contact carries at `x` and `v`; return 1 where it has closed, else 0."""
    i, j, grip = memory.pair[row, 0], memory.pair[row, 1], memory.grip
    soft, hard, stop, damping, size = spring_of(table, grip, row, i, j)
    u, w = apart(x, grip, row, i, j), apart(v, grip, row, i, j)
    push, _, _ = pressed(grip, row, u, w, soft, hard, stop, table.ratio[0] * damping, size)
    closed = 1.0 if push > 0.0 and grip[row, PUSH] == 0.0 else 0.0
    push = max(push, 0.0)
    q = pull_of(grip, row, u, w, 0.0)
    total = math.sqrt(q[0] * q[0] + q[1] * q[1] + q[2] * q[2])
    bound = friction_of(table, i, j) * push
    share = bound / total if total > bound else 1.0
    depth = depth_of(grip, row, u, size)
    grip[row, PUSH] = push
    rigid = squeeze(depth, soft, hard, stop, LAYER * size)[0] / depth if depth > 0.0 else soft
    grip[row, STIFF] = min(max(soft, rigid), max(soft, hard))
    for k in range(3):
        grip[row, SPRING + k] = share * q[k]
        grip[row, APART + k] = u[k]
    return closed


@small
def slips(memory, row, friction):
    """Tell whether a contact that presses is at the limit of friction, or has none."""
    grip, square = memory.grip, 0.0
    for k in range(3):
        square += grip[row, SPRING + k] ** 2
    return grip[row, PUSH] > 0.0 and math.sqrt(square) >= AT_LIMIT * friction * grip[row, PUSH]


@small
def point_of(x, i, s):
    """Return x (3, n) at a point of segment i."""
    return (
        (1.0 - s) * x[0, i] + s * x[0, i + 1],
        (1.0 - s) * x[1, i] + s * x[1, i + 1],
        (1.0 - s) * x[2, i] + s * x[2, i + 1],
    )


@kernel
def frame_of(x, v, memory, row):
    """Return the velocity [m/s] of the frame in which both segments of a contact go along themselves.

    u - w = s e - t f by least squares, u and w the velocities of its points, e and f the segments' vectors:
    it is the mean of u - s e and w - t f. EVEN keeps s and t small where e and f are almost parallel.
    """
    i, j = memory.pair[row, 0], memory.pair[row, 1]
    u, w = point_of(v, i, memory.grip[row, OWN]), point_of(v, j, memory.grip[row, OTHER])
    e = less(on_way(x, x, 0.0, i + 1), on_way(x, x, 0.0, i))
    f = less(on_way(x, x, 0.0, j + 1), on_way(x, x, 0.0, j))
    ee, ff, ef = (1.0 + EVEN) * product(e, e), (1.0 + EVEN) * product(f, f), product(e, f)
    p, q, wide, s, t = product(less(u, w), e), product(less(u, w), f), ee * ff - ef * ef, 0.0, 0.0
    if wide > 0.0:
        s, t = (p * ff - q * ef) / wide, (p * ef - q * ee) / wide
    return (
        0.5 * (u[0] + w[0] - s * e[0] - t * f[0]),
        0.5 * (u[1] + w[1] - s * e[1] - t * f[1]),
        0.5 * (u[2] + w[2] - s * e[2] - t * f[2]),
    )


@kernel
def run_on(x, v, dt, memory, row, y):
    """Write where a contact's nodes and the next ones will be that go on along their rope for a step, [m].

    It is seen from `frame_of`, so that friction is the same however fast all moves. How fast nodes go across
    their rope says little of where they will be: what is pressed rocks.
    """
    c, rope, last = frame_of(x, v, memory, row), memory.rope, x.shape[1] - 1
    for side in range(2):
        first = memory.pair[row, side]
        for i in range(first, min(first + 2, last) + 1):
            a = i - 1 if i > 0 and rope[i - 1] >= 0 else i
            b = i + 1 if i < last and rope[i] >= 0 else i
            square, along = 0.0, 0.0
            for k in range(3):
                square += (x[k, b] - x[k, a]) ** 2
                along += (v[k, i] - c[k]) * (x[k, b] - x[k, a])
            way = dt * along / square if square > 0.0 else 0.0
            for k in range(3):
                y[k, i] = x[k, i] + way * (x[k, b] - x[k, a])


@small
def may_stay(v, dt, memory, row, size):
    """Tell whether a contact without friction may keep a plane that has hardly turned.

    Where it comes to rest and its way is a concave one: there it would look for the next node, about which
    a rope of straight segments is lowest, and a real one is not. Where the way is convex, what keeps its
    plane has nothing that leads it back. What is at rest but for rounding goes no way.
    """
    i, j = memory.pair[row, 0], memory.pair[row, 1]
    if lies_still(memory, i, j, RESTS * size * dt):
        return True
    return lies_still(memory, i, j, KEEPS * size * dt) and convex(v, memory, row) == 0.0


@kernel
def lead(x, v, dt, y, table, memory, row, tied):
    """Give a contact points and normal as they will be after another step; tell whether that could be.

    One that slips round a bend turns as it goes. With the plane of where it was it would lag behind, and hold
    as much more as it has turned. One without friction that goes slowly has those of now, see `easing`.
    """
    i, j = memory.pair[row, 0], memory.pair[row, 1]
    size = table.radius[i] + table.radius[j]
    smooth = friction_of(table, i, j) == 0.0 and memory.tally[SETTLES] == 0
    ahead = dt * (1.0 - slow(v, memory, row, size)) if smooth else dt
    run_on(x, v, ahead, memory, row, y)
    s, t, distance = nearest(x, y, 1.0, i, j)
    before = depth_at(x, memory, row, i, j, size)
    if not (0.0 < distance < REACH * size and owns(x, y, 1.0, table, memory, tied, i, j, s, t)):
        return False
    n, along = normal_at(x, y, 1.0, memory, row, s, t), 0.0
    for k in range(3):
        along += n[k] * memory.grip[row, NORMAL + k]
    if 1.0 - along < TURNED and (not smooth or may_stay(v, dt, memory, row, size)):
        return False
    if not fits(x, y, 1.0, memory, row, s, t, size, before):
        return False
    freeze(x, y, 1.0, table, memory, row, s, t)
    begin_contact(x, table, memory, row, before)
    return True


@kernel
def refresh(x, v, dt, y, table, memory, row, tied):
    """Keep points and normal of a contact, find them anew, or mark it as gone.

    y (3, n) is room for where nodes will be after another step of `dt` [s] at the speed they have.
    """
    i, j, grip = memory.pair[row, 0], memory.pair[row, 1], memory.grip
    size = table.radius[i] + table.radius[j]
    s, t, distance = nearest(x, x, 0.0, i, j)
    if distance >= REACH * size or memory.rope[i] < 0 or memory.rope[j] < 0:
        grip[row, GONE] = 1.0
        return
    anew = throws_back(table) and not grip[row, PUSH] > 0.0  # to 3 % would be too little
    anew = anew or swings(table, memory, row) or misses(x, dt, memory, row, size, distance)
    friction = friction_of(table, i, j)
    if not anew and slips(memory, row, friction) and lead(x, v, dt, y, table, memory, row, tied):
        return
    if anew or not is_right(x, memory, row, size, distance):
        if owns(x, x, 0.0, table, memory, tied, i, j, s, t):
            before = depth_at(x, memory, row, i, j, size)
            freeze(x, x, 0.0, table, memory, row, s, t)
            begin_contact(x, table, memory, row, before)
        else:
            grip[row, GONE] = 1.0


@kernel
def is_covered(x, memory, i, j, s, t, size):
    """Tell whether a contact of segments beside these is at the same place already."""
    pair, grip = memory.pair, memory.grip
    for a in range(i - 1, i + 2):
        for b in range(j - 1, j + 2):
            row = row_of(memory, a, b)
            if row < 0 or grip[row, GONE] == 1.0:
                continue
            far = 0.0
            for side in range(2):
                own, point = (i, s) if side == 0 else (j, t)
                other, place = pair[row, side], grip[row, OWN + side]
                square = 0.0
                for k in range(3):
                    here = (1.0 - point) * x[k, own] + point * x[k, own + 1]
                    there = (1.0 - place) * x[k, other] + place * x[k, other + 1]
                    square += (here - there) ** 2
                far = max(far, square)
            if far < (2.0 * WRONG * size) ** 2:
                return True
    return False


@kernel
def inherit(x, table, memory, row):
    """Let a new contact take over what one beside it held that is gone; return how deep that one was [m]."""
    pair, grip = memory.pair, memory.grip
    i, j = pair[row, 0], pair[row, 1]
    for a in range(i - 1, i + 2):
        for b in range(j - 1, j + 2):
            other = row_of(memory, a, b)
            if other < 0 or grip[other, GONE] != 1.0 or not grip[other, PUSH] > 0.0:
                continue
            grip[row, PUSH] += grip[other, PUSH]
            grip[row, STIFF] = max(grip[row, STIFF], grip[other, STIFF])
            grip[row, LEFT] = max(grip[row, LEFT], grip[other, LEFT])
            grip[other, PUSH] = 0.0
            for k in range(3):
                grip[row, SPRING + k] += grip[other, SPRING + k]
            size = table.radius[a] + table.radius[b]
            return max(depth_at(x, memory, other, a, b, size), 0.0)
    return 0.0


@kernel
def pass_on(x, table, memory):
    """Let contacts found on the way of the step take over from those that are gone."""
    grip = memory.grip
    for row in range(memory.tally[CONTACTS]):
        if grip[row, FOUND] == 0.0:
            continue
        grip[row, FOUND] = 0.0
        if grip[row, GONE] == 0.0:
            i, j = memory.pair[row, 0], memory.pair[row, 1]
            own = depth_at(x, memory, row, i, j, table.radius[i] + table.radius[j])
            depth = inherit(x, table, memory, row)
            if depth > 0.0:
                begin_contact(x, table, memory, row, max(own, 0.0) + depth)


@kernel
def list_new(x, table, memory, tied):
    """Make contacts of all pairs that are near and not listed yet."""
    count = memory.tally
    for k in range(count[NEAR]):
        i, j = memory.near[k, 0], memory.near[k, 1]
        at = row_of(memory, i, j)
        if at >= 0:
            continue
        size = table.radius[i] + table.radius[j]
        s, t, distance = nearest(x, x, 0.0, i, j)
        if distance >= REACH * size or not owns(x, x, 0.0, table, memory, tied, i, j, s, t):
            continue
        if is_covered(x, memory, i, j, s, t, size):
            continue
        if not new_row(memory, i, j, -1 - at):
            count[FAULT], count[FIRST], count[SECOND] = FULL, i, j
            return
        freeze(x, x, 0.0, table, memory, -1 - at, s, t)
        before = inherit(x, table, memory, -1 - at)
        begin_contact(x, table, memory, -1 - at, before)


@kernel
def drop_gone(memory):
    """Take out the rows that are marked."""
    pair, grip, kept = memory.pair, memory.grip, 0
    for row in range(memory.tally[CONTACTS]):
        if grip[row, GONE] == 1.0:
            continue
        pair[kept, 0], pair[kept, 1] = pair[row, 0], pair[row, 1]
        for k in range(WIDTH):
            grip[kept, k] = grip[row, k]
        kept += 1
    memory.tally[CONTACTS] = kept


@deferred("float64")
def remember_pairs(x, v, dt, table, memory, tied):
    """Keep what contacts carry at `x` and `v`, a time `dt` [s] after the last, and find who touches there.

    Return how many have closed.
    """
    count, place, closed = memory.tally, memory.place, 0.0
    if not find_near(place, x, table, memory, tied):
        count[FAULT] = FULL
    if count[SEEN] == 0:
        look_for_passes(place, x, memory, table)
    count[SEEN], count[ROUNDS], count[REFUSED] = 0, 0, 0
    sweep(place, x, memory)
    for k in range(3):
        for i in range(x.shape[1]):
            memory.way[k, i] = x[k, i] - place[k, i]
    if count[CONTACTS] > 0 or count[NEAR] > 0:
        closed = look_at_all(x, v, dt, table, memory, tied)
    for k in range(3):
        for i in range(x.shape[1]):
            place[k, i] = x[k, i]
    return closed


@deferred("float64")
def look_at_all(x, v, dt, table, memory, tied):
    """Keep what contacts carry, and find who touches, of those that are near; return how many have closed."""
    count, place, closed = memory.tally, memory.place, 0.0
    for row in range(count[CONTACTS]):
        closed += hold(x, v, table, memory, row)
        refresh(x, v, dt, place, table, memory, row, tied)
        ease(v, table, memory, row)
    pass_on(x, table, memory)
    list_new(x, table, memory, tied)
    drop_gone(memory)
    lead_offsets(x, dt, table, memory)
    return closed
