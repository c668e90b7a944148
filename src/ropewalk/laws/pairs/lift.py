"""Ropes at rest come out of each other again: an offset of contacts that grows slowly and smoothly.

The soft skin, and planes that are kept while they err, let what lies sink in by 1 to 5 % of the radii's sum
d. Where a contact has rested, its ropes deeper than DEEP d in each other, it counts as pressed more and more,
until they are SHALLOW d deep. How fast is known as a step begins, so that each stage of it has the offset of
its own time, and changes so slowly that what is lifted presses by as much as before: what sticks does not
notice. It rests whose force has stayed for longer than what is carried could swing on it, and which sticks
with something to spare. What does not give way, but presses more, is let down to where it began.
"""

from __future__ import annotations

import math

from ropewalk.core.jit import kernel, small
from ropewalk.laws.pairs.search import row_of
from ropewalk.laws.pairs.table import (
    BASE,
    BEGAN,
    BEGAN_AT,
    BUSY,
    CLIMB,
    CONTACTS,
    DEPTH,
    FLOOR,
    HELD,
    LAYER,
    LIFT,
    LIFTED,
    MODE,
    MORE,
    NORMAL,
    PUSH,
    RESTED,
    SLID,
    SPRING,
    TIGHT,
    VAIN,
    apart,
)

# Over the sum of the radii: all but times, LOSES and those that say so.
DEEP, SHALLOW, TOUCHES = 0.009, 0.007, 0.0005  # [1]
RATE = 0.01  # [1/s]
EASES = 0.3  # [s] in which it comes to that rate
ENDS = 0.2  # [s] time constant of its end
NEAR = 3e-4  # [1] so near its end it stops
STILL = 0.02  # [1/s] what moves more in a step, across or along its normal, is not at rest
WAITS = 0.3  # [s]
SAME = 0.02  # [1] by so much of itself the force of what rests changes at most
MORE_FORCE = 1.1  # [1] what presses so much more than as its lifting began, over that, may be held
GAINS = 0.25  # [1] is, if its ropes have come apart by less, over what its offset rose
MOST_FORCE = 2.0  # [1] or if it presses so much more
LIGHT = 0.25  # [1] or so much more than this part of what its skin bears, where it pressed less
SPARE = 0.97  # [1] share of what friction can carry over which nothing is lifted
MOST = 0.06  # [1] all ways up of a contact
LOSES = 0.5  # [1] of what slides, over way times coefficient of friction
ASIDE = 0.001  # [1] by more of what fades a contact is not at rest
FADES = 0.03  # [s] in which what parts is let down
AT_LIMIT = 1.0 - 1e-9  # [1] of what friction can carry counts as all of it
STANDS, RISES, FALLS = 0.0, 1.0, 2.0  # modes
TRIES = 2.0  # so often in vain


@small
def moves(memory, row):
    """Return how far a contact's points have moved in the last step along its normal, and across [m]."""
    grip = memory.grip
    w = apart(memory.way, grip, row, memory.pair[row, 0], memory.pair[row, 1])
    along = grip[row, NORMAL] * w[0] + grip[row, NORMAL + 1] * w[1] + grip[row, NORMAL + 2] * w[2]
    square = w[0] * w[0] + w[1] * w[1] + w[2] * w[2] - along * along
    return abs(along), math.sqrt(max(square, 0.0))


@small
def slips(memory, row, friction, share=AT_LIMIT):
    """Tell whether a contact that presses is at such a share of the limit of friction, or has none."""
    grip, square = memory.grip, 0.0
    for k in range(3):
        square += grip[row, SPRING + k] ** 2
    return grip[row, PUSH] > 0.0 and math.sqrt(square) >= share * friction * grip[row, PUSH]


@kernel
def raise_pairs(memory, since):
    """Let all offsets be those of `since` [s] after the last step."""
    grip = memory.grip
    for row in range(memory.tally[CONTACTS]):
        if grip[row, CLIMB] != 0.0:
            grip[row, LIFT] = max(grip[row, BASE] + grip[row, CLIMB] * since, 0.0)


@small
def climb_to(memory, row, dt):
    """Let the offset of a contact stand where it is after a step of `dt` [s]; return how far it rose [m]."""
    grip, before = memory.grip, memory.grip[row, BASE]
    if grip[row, CLIMB] == 0.0 or dt == math.inf:
        return 0.0
    grip[row, BASE] = max(before + grip[row, CLIMB] * dt, 0.0)
    grip[row, LIFT] = grip[row, BASE]
    rose = grip[row, BASE] - before
    grip[row, LIFTED] += max(rose, 0.0)
    return rose


@small
def take_over(grip, row, other):
    """Let a new contact be lifted as one was that is gone."""
    for k in range(LIFT, DEPTH + 1):
        grip[row, k] = grip[other, k]


@small
def period_of(table, i, j):
    """Return how long what is carried may swing on the skin of a contact [s]."""
    whole = max(table.whole[i], table.whole[j])
    return 2.0 * math.pi * math.sqrt(whole * (table.soft[i] + table.soft[j]))


@small
def note_rest(memory, row, size, dt):
    """Note for how long a contact has rested, and how far it slid in the last step [m]."""
    grip, push = memory.grip, memory.grip[row, PUSH]
    along, across = moves(memory, row)
    grip[row, SLID] = across
    still = max(along, across) <= STILL * size * dt and abs(grip[row, MORE]) <= ASIDE * size
    if not still or abs(push - grip[row, HELD]) > SAME * grip[row, HELD]:
        grip[row, HELD], grip[row, RESTED] = push, 0.0
    grip[row, RESTED] += dt
    return still


@small
def has_rested(table, memory, row):
    """Tell whether a contact has rested for as long as what is carried may swing on it."""
    wait = period_of(table, memory.pair[row, 0], memory.pair[row, 1])
    return memory.grip[row, RESTED] > max(WAITS, wait)


@kernel
def mark(dt, table, memory):
    """Mark the contacts that are near the limit of friction, and that do not rest, and their segments."""
    grip, box = memory.grip, memory.box
    for i in range(box.shape[0]):  # in which the search has no more to do
        box[i, 0], box[i, 1] = 0.0, 0.0
    for row in range(memory.tally[CONTACTS]):
        i, j = memory.pair[row, 0], memory.pair[row, 1]
        still = note_rest(memory, row, table.radius[i] + table.radius[j], dt)
        grip[row, TIGHT], grip[row, BUSY] = 0.0, 0.0
        if not (grip[row, PUSH] > 0.0 or grip[row, DEPTH] > 0.0):
            continue
        begins = grip[row, MODE] == STANDS and not has_rested(table, memory, row)
        if not still or slips(memory, row, table.friction[0], SPARE):
            grip[row, TIGHT], box[i, 0], box[j, 0] = 1.0, 1.0, 1.0
        if begins or grip[row, MODE] == FALLS:
            grip[row, BUSY], box[i, 1], box[j, 1] = 1.0, 1.0, 1.0


@kernel
def is_beside(memory, row, which):
    """Tell whether a contact is, or shares a segment with, or is next to one that is TIGHT or BUSY."""
    i, j, grip = memory.pair[row, 0], memory.pair[row, 1], memory.grip
    if memory.box[i, which - TIGHT] == 1.0 or memory.box[j, which - TIGHT] == 1.0:
        return True
    for a in range(i - 1, i + 2):
        for b in range(j - 1, j + 2):
            other = row_of(memory, a, b)
            if other >= 0 and grip[other, which] == 1.0:
                return True
    return False


@small
def fall(grip, row, to, dt, size):
    """Return how fast an offset goes down that is to come down to `to` [m/s]."""
    left = grip[row, BASE] - to
    return -min(RATE * size, left / max(ENDS if left > NEAR * size else 0.0, dt))


@kernel
def plan(dt, table, memory, row, size, light, may):
    """Decide how fast the offset of a contact changes in the next step, after one of `dt` [s].

    What presses by less than `light` [N] counts as pressed by that as its lifting began.
    """
    grip, was, friction = memory.grip, memory.grip[row, CLIMB], table.friction[0]
    grip[row, CLIMB] = 0.0
    push, depth = grip[row, PUSH], grip[row, DEPTH]
    if not push > 0.0 and depth < TOUCHES * size:  # no force changes
        grip[row, BASE] -= min(grip[row, BASE], TOUCHES * size - depth)
        grip[row, LIFT], grip[row, MODE], grip[row, VAIN] = grip[row, BASE], STANDS, 0.0
    lifted = grip[row, BASE] > 0.0
    if lifted and (depth < TOUCHES * size or not may):
        grip[row, MODE] = STANDS
        lower = fall(grip, row, 0.0, dt, size)
        grip[row, CLIMB] = lower if not may else -(TOUCHES * size - depth) / max(FADES, dt)
        return
    if lifted and slips(memory, row, friction):
        grip[row, MODE] = STANDS
        grip[row, CLIMB] = -LOSES * friction * grip[row, SLID] / dt
        return
    if not may:
        return
    ready = grip[row, MODE] == STANDS and depth > DEEP * size and grip[row, VAIN] < TRIES
    near = (ready or grip[row, MODE] == RISES) and is_beside(memory, row, TIGHT)
    if ready and not near:
        if not is_beside(memory, row, BUSY):
            grip[row, MODE], grip[row, BEGAN], grip[row, FLOOR] = RISES, push, grip[row, BASE]
            grip[row, BEGAN_AT] = depth
    if grip[row, MODE] == RISES:
        if not push > 0.0:  # by a plane that errs
            grip[row, FLOOR], grip[row, BEGAN_AT] = grip[row, BASE], depth
        due = min(depth - (SHALLOW + NEAR) * size, MOST * size - grip[row, LIFTED])
        begun = max(grip[row, BEGAN], light)
        gained, rose = grip[row, BEGAN_AT] - depth, grip[row, BASE] - grip[row, FLOOR]
        harder = push > MORE_FORCE * begun and gained < GAINS * rose
        if harder or push > MOST_FORCE * begun:
            grip[row, MODE] = FALLS
            grip[row, VAIN] += 1.0
        elif not due > 0.0 or near or MOST_FORCE * push < grip[row, BEGAN]:
            grip[row, MODE], grip[row, RESTED] = STANDS, 0.0
        else:
            aim = min(RATE * size, (due + NEAR * size) / max(ENDS, dt))
            grip[row, CLIMB] = min(aim, max(was, 0.0) + RATE * size * dt / EASES)
    elif grip[row, MODE] == FALLS:
        grip[row, CLIMB] = fall(grip, row, grip[row, FLOOR], dt, size)
        if grip[row, BASE] <= grip[row, FLOOR] + 1e-6 * size:
            grip[row, MODE], grip[row, RESTED] = STANDS, 0.0


@kernel
def lift_pairs(dt, table, memory):
    """Decide how fast all offsets change in the next step, after one of `dt` [s].

    None rises without friction, where ropes do not come to rest, nor with a compliance of the user's, who
    means the depth that it gives.
    """
    if not 0.0 < dt < math.inf:
        return
    mark(dt, table, memory)
    for row in range(memory.tally[CONTACTS]):
        i, j = memory.pair[row, 0], memory.pair[row, 1]
        may = table.friction[0] > 0.0
        may = may and table.hard[i] + table.hard[j] != table.soft[i] + table.soft[j]
        size = table.radius[i] + table.radius[j]
        light = LIGHT * LAYER * size / (table.soft[i] + table.soft[j])
        plan(dt, table, memory, row, size, light, may)
