"""What stops ropes that strike each other, in the skin of their contact.

A contact of ropes begins close by, unlike one with an obstacle: on so short a way its damper takes little of
a fast hit, and the stiffness below would give it back. So what closes at u meets a drag m u^2 / S besides, m
the mass that the contact's points move as, S a length of SOFT of the radii's sum, or OF_ROOM of what it may
still be pressed: u falls by exp(-1) in S, and what is left stores next to nothing. What closes slowly, under
u of 2 S sqrt(k / m), does not see it. The drag is linear within a step, with the u at its start, and begins
with the depth, without a jump. In explicit steps it takes u no quicker than the damper of a contact of ropes
alone at its stiffest, for which they have room, and all contacts of a segment together take no more than
AT_ONCE of it in a step. Steps that are solved for have room for any; there it leaves 1 / (1 + ALL_BUT) of u
in a step as long as the last, so that in the first part of one that is halved it weakens. A contact that is
found on the way of a step has none in it; one that turns has its drag anew, as all have in a first step that
is solved for.
Where the method shortens steps for what they hit, ALL_BUT is over that very step, and each contact has its
drag from the points that it has by then; it follows u within the step, so that what is left does not hang on
how long steps are, and S is less by SHARPER: as little comes back as with the drag of a step's start, and its
rate is that much more at most. A step too long to follow how it stops something counts as a hit.
What slides as it hits meets the same drag across, up to mu times what presses: friction takes mu times the
impulse, or all. Contacts that throw back have no drag.
"""

from __future__ import annotations

from ropewalk.core.jit import deferred, small
from ropewalk.laws.pairs.distance import nearest
from ropewalk.laws.pairs.table import (
    APART,
    BRAKE,
    CLOSES,
    CONTACTS,
    DEEPEST,
    EASE,
    HARD,
    NEW,
    NORMAL,
    OTHER,
    OWN,
    WRONG,
    between,
    share_of,
    throws_back,
)

SOFT = 0.005  # [1] S over the sum of the radii
AT_ONCE = 0.5  # [1] of the closing speed that a step may take
ALL_BUT = 20.0  # [1] the drag's rate times a step that is solved for, at most
OF_ROOM = 0.2  # [1] S over what a contact may still be pressed, at most
CLOSEST = 1e-4  # [1] S over the sum of the radii, at least
SLOW = 2.0 * SOFT  # [1] of the radii's sum: what closes by less in a step is followed
SHARPER = 1.5  # [1] S over that of a drag that follows u within the step
LEAST = 1e-300  # [s] not nothing, before the first step


@small
def closing(v, grip, row, i, j):
    """Return how fast the points of a contact come closer [m/s]."""
    w = between(v, i, j, grip[row, OWN], grip[row, OTHER])
    n0, n1, n2 = grip[row, NORMAL], grip[row, NORMAL + 1], grip[row, NORMAL + 2]
    return -(n0 * w[0] + n1 * w[1] + n2 * w[2])


@small
def stopping(v, force, dt, memory, row, i, j, size):
    """Return how quickly a contact's drag stops what closes at v [1/s]; 0 where a step can follow.

    The step is `dt` [s] long, `force` (3, n) [N] that of all contacts in it: where there is none at the
    segment's ends it has not been hit yet.
    """
    grip = memory.grip
    closes = closing(v, grip, row, i, j)
    if not (grip[row, BRAKE] > 0.0 and dt * closes > SLOW * size):
        return 0.0
    for k in range(3):
        if force[k, i] != 0.0 or force[k, i + 1] != 0.0:
            return closes / (SOFT * size)
    return 0.0


@small
def stop_within(x, grip, row, i, j, size):
    """Return the length S for a contact [m]: a part of what it may still be pressed, where that is less.

    How near its segments are its plane knows to WRONG.
    """
    near = 0.0
    for k in range(3):
        near += grip[row, NORMAL + k] * grip[row, APART + k]
    if near < (DEEPEST + WRONG + SOFT / OF_ROOM) * size:
        near = min(near, nearest(x, x, 0.0, i, j)[2])
    return min(SOFT * size, max(OF_ROOM * (near - DEEPEST * size), CLOSEST * size))


@small
def ease(inverse_mass, behind, grip, row, i, j):
    """Return one over the mass that a contact's points move as, with so much behind nodes (n,) [1/kg]."""
    moves = 0.0
    for a in range(4):
        node = i + a if a < 2 else j + a - 2
        light = inverse_mass[node]
        if behind[node] > 0.0:
            light /= 1.0 + light * behind[node]
        moves += share_of(grip, row, a) ** 2 * light
    return moves


@small
def brake_contact(x, v, inverse_mass, table, memory, row, most):
    """Keep what drag [N s/m] a contact has for what comes closer; return its rate, `most` at most [1/s]."""
    i, j, grip = memory.pair[row, 0], memory.pair[row, 1], memory.grip
    grip[row, BRAKE], grip[row, CLOSES] = 0.0, 0.0
    if throws_back(table):
        grip[row, EASE] = ease(inverse_mass, table.joined, grip, row, i, j)
        return 0.0
    closes = closing(v, grip, row, i, j)
    moves = ease(inverse_mass, table.behind, grip, row, i, j)
    if not (closes > 0.0 and moves > 0.0):
        return 0.0
    rate = min(closes / stop_within(x, grip, row, i, j, table.radius[i] + table.radius[j]), most)
    grip[row, BRAKE] = rate / moves
    return rate


@deferred()
def brake_again(x, v, inverse_mass, table, memory, dt, all_anew):
    """Keep the same for a step of `dt` [s], which is solved for, of contacts as they are now.

    Of those that are NEW to it, at the start of a run or turned on the way; of all where `all_anew` is set.
    """
    for row in range(memory.tally[CONTACTS]):
        if all_anew or memory.grip[row, BRAKE] == NEW:
            brake_contact(x, v, inverse_mass, table, memory, row, ALL_BUT / dt)
            if all_anew:
                i, j = memory.pair[row, 0], memory.pair[row, 1]
                memory.grip[row, CLOSES] = max(closing(v, memory.grip, row, i, j), 0.0)
                memory.grip[row, BRAKE] *= SHARPER


@deferred()
def brake_hits(x, v, inverse_mass, table, memory, dt, solved):
    """Keep with what drag [N s/m] each contact meets what comes closer in the next step.

    It is as long as the last, `dt` [s]; `solved` where it is solved for.
    """
    grip, mass, box = memory.grip, table.mass, memory.box
    if solved:
        for row in range(memory.tally[CONTACTS]):
            brake_contact(x, v, inverse_mass, table, memory, row, ALL_BUT / max(dt, LEAST))
        return
    for i in range(box.shape[0]):  # in which the search has no more to do
        box[i, 0] = 0.0
    for row in range(memory.tally[CONTACTS]):
        i, j = memory.pair[row, 0], memory.pair[row, 1]
        stop = 1.0 / (table.stop[i] + table.stop[j])
        most = 2.0 * HARD * (stop * (1.0 / mass[i] + 1.0 / mass[j])) ** 0.5
        most = min(most, AT_ONCE / max(dt, LEAST))
        rate = brake_contact(x, v, inverse_mass, table, memory, row, most)
        box[i, 0], box[j, 0] = box[i, 0] + dt * rate, box[j, 0] + dt * rate
    for row in range(memory.tally[CONTACTS]):
        i, j = memory.pair[row, 0], memory.pair[row, 1]
        grip[row, BRAKE] *= AT_ONCE / max(AT_ONCE, box[i, 0], box[j, 0])
