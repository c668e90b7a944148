"""Ropes at rest come out of each other again: an offset of contacts that stands still, as a ratchet.

The soft skin, and planes that are kept while they err, let what lies sink in by 1 to 5 % of the radii's sum
d. Where a contact has rested for WAITS, its ropes deeper than DEEP d in each other, it counts as pressed more
by RATE d in a second, until they are SHALLOW d deep: slower than what counts as rest, so that it goes on. In
between the offset stands. It is no controller, which would make what is heavy swing for ever. It only rises,
by MOST d in all, and by what it has lost as it slid, which is half of what friction took meanwhile over R_n;
and where the surfaces part it is let down, which only takes energy.
"""

from __future__ import annotations

import math

from ropewalk.core.jit import kernel, small
from ropewalk.laws.pairs.force import squeezed
from ropewalk.laws.pairs.table import (
    CONTACTS,
    DEPTH,
    GIVEN,
    LAYER,
    LIFT,
    LIFTED,
    MORE,
    NORMAL,
    PUSH,
    RESTED,
    RISES,
    SPRING,
    apart,
    spring_of,
)

# All but times, LOSES and HEAVY over the sum of the radii.
DEEP, SHALLOW, TOUCHES = 0.009, 0.007, 0.0005  # [1]
RATE = 0.01  # [1/s]
STILL = 0.02  # [1/s] what moves more in a step, across or along its normal, is not at rest
WAITS = 0.3  # [s]
MOST = 0.06  # [1] all ways up of a contact
LOSES = 0.5  # [1] of what slides, over way times coefficient of friction
ASIDE = 0.001  # [1] by more of what fades a contact is not at rest
HEAVY = 4.0  # [1] force over that of the skin from which on ropes are as deep as they are stiff
AT_LIMIT = 1.0 - 1e-9  # [1] of what friction can carry counts as all of it


@small
def moves(memory, row):
    """Return how far a contact's points have moved in the last step along its normal, and across [m]."""
    grip = memory.grip
    w = apart(memory.way, grip, row, memory.pair[row, 0], memory.pair[row, 1])
    along = grip[row, NORMAL] * w[0] + grip[row, NORMAL + 1] * w[1] + grip[row, NORMAL + 2] * w[2]
    square = w[0] * w[0] + w[1] * w[1] + w[2] * w[2] - along * along
    return abs(along), math.sqrt(max(square, 0.0))


@small
def slips(memory, row, friction):
    """Tell whether a contact that presses is at the limit of friction, or has none."""
    grip, square = memory.grip, 0.0
    for k in range(3):
        square += grip[row, SPRING + k] ** 2
    return grip[row, PUSH] > 0.0 and math.sqrt(square) >= AT_LIMIT * friction * grip[row, PUSH]


@small
def bears_much(table, memory, row):
    """Tell whether a contact bears so much that its ropes are as deep in each other as they are stiff."""
    soft, _, _, _, size = spring_of(
        table, memory.grip, row, memory.pair[row, 0], memory.pair[row, 1]
    )
    return memory.grip[row, PUSH] > HEAVY * soft * LAYER * size


@kernel
def lift(dt, table, memory, row, size):
    """Let the offset of a contact, its radii `size` in all [m], rise or fall after a step of `dt` [s]."""
    grip = memory.grip
    along, across = moves(memory, row)
    if grip[row, LIFT] > 0.0 and slips(memory, row, table.friction[0]):
        lost = min(grip[row, LIFT], LOSES * table.friction[0] * across)
        grip[row, LIFT] -= lost
        grip[row, LIFTED] -= lost
    rests = max(along, across) <= STILL * size * dt and abs(grip[row, MORE]) <= ASIDE * size
    grip[row, RESTED] = grip[row, RESTED] + dt if rests else 0.0
    depth = grip[row, DEPTH]
    grip[row, LIFT] -= min(grip[row, LIFT], max(TOUCHES * size - depth, 0.0))
    deep = SHALLOW if grip[row, RISES] == 1.0 else DEEP
    due = min(depth - SHALLOW * size, MOST * size - grip[row, LIFTED])
    grip[row, RISES] = 0.0
    if depth > deep * size and due > 0.0 and grip[row, RESTED] > WAITS:
        if not bears_much(table, memory, row):
            due = min(due, RATE * size * dt)
            grip[row, LIFT] += due
            grip[row, LIFTED] += due
            grip[row, RISES] = 1.0


@kernel
def lift_pairs(x, dt, table, memory):
    """Let all offsets rise or fall after a step of `dt` [s] that has ended at x, and book what that gives.

    Not without friction, where ropes do not come to rest, nor with a compliance of the user's, who means
    the depth that it gives.
    """
    if not table.friction[0] > 0.0:
        return
    for row in range(memory.tally[CONTACTS]):
        i, j = memory.pair[row, 0], memory.pair[row, 1]
        if table.hard[i] + table.hard[j] == table.soft[i] + table.soft[j]:
            continue
        before = memory.grip[row, LIFT]
        lift(dt, table, memory, row, table.radius[i] + table.radius[j])
        after = memory.grip[row, LIFT]
        if after != before:
            stored = squeezed(x, table, memory, row)
            memory.grip[row, LIFT] = before
            memory.books[GIVEN] += stored - squeezed(x, table, memory, row)
            memory.grip[row, LIFT] = after
