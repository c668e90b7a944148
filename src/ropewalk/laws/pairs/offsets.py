"""By how much contacts count as pressed more than their points say, from step to step.

What points that were found anew have brought fades where a pair slides. Where it lies still the offset e
follows what is missing to the depth of ropes as hard as contacts are beyond their skin, with a time T,
    e' = (depth - R / hard - SHALLOW d) / T,    |e'| <= QUICKEST d,    T = max(FOLLOWS, OVER m / c),
and not at all from no depth to ENOUGH d + R / hard: contacts that share a load would hand it to each other.
So ropes at rest lie on each other, not in the soft skins that steps need. For a mass m on a contact of damper
c that is an integral term: m s^3 + c s^2 + k s + k / T = 0 decays where T > m / c. Of loads that hang on it
straight m is no more than all of its heap, see `heaps`. There is room for e of WRONG d and of what the plane
hides of the depth, none where R presses a contact LOADED d beyond its skin. Rest that statics found stays.
"""

from __future__ import annotations

import math

from ropewalk.core.jit import kernel, small
from ropewalk.laws.pairs.distance import nearest
from ropewalk.laws.pairs.force import depth_at, squeeze
from ropewalk.laws.pairs.heaps import heavy_of, weigh_heaps
from ropewalk.laws.pairs.pair_hits import swings
from ropewalk.laws.pairs.table import (
    CONTACTS,
    EXTRA,
    LAYER,
    LEFT,
    LIFTED,
    MORE,
    OTHER,
    OWN,
    PUSH,
    SETTLES,
    WAS,
    WRONG,
    between,
    spring_of,
    throws_back,
)

FADES = 0.03  # [s]
FOLLOWS = 0.03  # [s]
OVER = 2.0  # [1]
QUICKEST = 0.03  # [1/s] of the radii's sum
STILL = 0.2  # [1/s] of the same: so fast what counts as still moves, at most
KEEPS = 1e-3  # [1/s] of the same: so fast what comes to rest moves at most
SHALLOW, ENOUGH = 0.0025, 0.005  # [1] depths over the same
LOADED = 0.01  # [1] the same of what is as stiff as contacts are beyond their skin


@small
def touches_still(memory, row, most):
    """Tell whether both segments went at most `most` [m] against each other in the step, where they touch."""
    i, j, grip = memory.pair[row, 0], memory.pair[row, 1], memory.grip
    u = between(memory.way, i, j, grip[row, OWN], grip[row, OTHER])
    return u[0] * u[0] + u[1] * u[1] + u[2] * u[2] <= most * most


@small
def lies_still(memory, i, j, most):
    """Tell whether no two ends of segments moved against each other by more than `most` [m] in the step."""
    way = memory.way
    for p in range(2):
        for q in range(2):
            square = 0.0
            for k in range(3):
                square += (way[k, i + p] - way[k, j + q]) ** 2
            if square > most * most:
                return False
    return True


@small
def misses(x, dt, memory, row, size, distance):
    """Tell whether a contact of what lies still is open by its plane alone, and its segments overlap.

    Nothing would press them apart. What carries nothing cannot slip: it may have its points anew.
    """
    i, j, grip = memory.pair[row, 0], memory.pair[row, 1], memory.grip
    if grip[row, PUSH] > 0.0 or distance >= (1.0 - ENOUGH) * size or memory.tally[SETTLES] != 0:
        return False
    opened = depth_at(x, memory, row, i, j, size) <= 0.0
    return opened and lies_still(memory, i, j, KEEPS * size * dt)


@kernel
def follow(x, dt, table, memory, row, faded, heavy):
    """Let the offset of a contact that lies still follow what is missing, `faded` [m] at least, and book it.

    `heavy` [kg] is what may be on it.
    One that counts as less deep than it is comes back as it does elsewhere, and goes on from there.
    """
    i, j, grip = memory.pair[row, 0], memory.pair[row, 1], memory.grip
    soft, hard, stop, damping, size = spring_of(table, grip, row, i, j)
    grip[row, MORE] = max(grip[row, MORE], faded)
    seen = depth_at(x, memory, row, i, j, size)
    force, _, stored = squeeze(max(seen, 0.0), soft, hard, stop, LAYER * size)
    depth, firm, left = size - nearest(x, x, 0.0, i, j)[2], force / hard, grip[row, LEFT]
    missing = 0.0
    if depth < 0.0 or depth > max(ENOUGH * size + firm, left):
        missing = depth - max(SHALLOW * size + firm, left)
    change = -math.expm1(-dt / max(FOLLOWS, OVER * heavy / damping)) * missing
    change = min(max(change, -QUICKEST * size * dt), QUICKEST * size * dt)
    hidden = max(depth - seen + grip[row, MORE], 0.0)  # from the plane of the contact
    room = (WRONG * size + hidden) * max(1.0 - force / (LOADED * size * hard), 0.0)
    grip[row, MORE] = max(min(grip[row, MORE] + change, room), faded)
    counted = max(depth_at(x, memory, row, i, j, size), 0.0)
    memory.books[LIFTED] += squeeze(counted, soft, hard, stop, LAYER * size)[2] - stored


@kernel
def lead_offsets(x, dt, table, memory):
    """Let all contacts count as deep as they are to, after a step of `dt` [s] to places (3, n) [m].

    `memory.place` is room, which is written anew after it.
    """
    grip, share = memory.grip, math.exp(-dt / FADES)
    weigh_heaps(table, memory, memory.place)
    for row in range(memory.tally[CONTACTS]):
        i, j = memory.pair[row, 0], memory.pair[row, 1]
        size, faded = table.radius[i] + table.radius[j], share * grip[row, MORE]
        grip[row, EXTRA], grip[row, WAS] = 0.0, grip[row, MORE]
        if memory.tally[SETTLES] == 1:
            grip[row, LEFT] = max(size - nearest(x, x, 0.0, i, j)[2], 0.0)
        elif not grip[row, PUSH] > 0.0:
            grip[row, LEFT] = 0.0
        elif swings(table, memory, row):  # its energy hangs on how deep it counts
            continue
        elif dt > 0.0 and touches_still(memory, row, STILL * size * dt):
            if not throws_back(table) and lies_still(memory, i, j, STILL * size * dt):
                follow(x, dt, table, memory, row, faded, heavy_of(table, memory.place, i))
            else:  # as of a lever that is being pressed up: were it to fade then, it would do so for ever
                grip[row, MORE] = max(grip[row, MORE], faded)
            continue
        grip[row, MORE] = faded


@kernel
def swap_offsets(memory):
    """Let contacts count as deep as they did in the step that has led here, or as they do now again."""
    grip = memory.grip
    for row in range(memory.tally[CONTACTS]):
        grip[row, MORE], grip[row, WAS] = grip[row, WAS], grip[row, MORE]
