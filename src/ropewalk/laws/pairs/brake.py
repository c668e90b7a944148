"""What stops ropes that strike each other in explicit steps, in the skin of their contact.

A contact of ropes begins close by, unlike one with an obstacle: on so short a way its damper takes little of
a fast hit, and the stiffness below would give it back. So what closes at u meets a drag m u^2 / S besides,
m the mass that the contact's points move as, S a length of SOFT of the radii's sum: u falls by exp(-1) in S,
and what is left stores next to nothing. What closes slowly, under u of 2 S sqrt(k / m), does not see it.
The drag is linear within a step, with the u at its start, and begins with the depth, without a jump. It takes
u no quicker than the damper of a contact of ropes alone at its stiffest, for which explicit steps have room,
and all contacts of a segment together take no more than AT_ONCE of it in a step. Steps that are solved for
have none: ropes that were thrown at each other at random then came so near that one run of 200 found no
solution.
"""

from __future__ import annotations

import math

from ropewalk.core.jit import kernel
from ropewalk.laws.pairs.table import (
    BRAKE,
    CONTACTS,
    HARD,
    NORMAL,
    OTHER,
    OWN,
    between,
    share_of,
)

SOFT = 0.005  # [1] S over the sum of the radii
AT_ONCE = 0.5  # [1] of the closing speed that a step may take
LEAST = 1e-300  # [s] not nothing, before the first step


@kernel
def brake_hits(v, inverse_mass, table, memory, dt):
    """Keep with what drag [N s/m] each contact meets what comes closer in the next step.

    It is as long as the last, `dt` [s]; inf where steps are solved for: then there is none.
    """
    grip, mass, box = memory.grip, table.mass, memory.box
    for i in range(box.shape[0]):  # in which the search has no more to do
        box[i, 0] = 0.0
    for row in range(memory.tally[CONTACTS]):
        i, j = memory.pair[row, 0], memory.pair[row, 1]
        w = between(v, i, j, grip[row, OWN], grip[row, OTHER])
        closes, moves = 0.0, 0.0
        for k in range(3):
            closes -= grip[row, NORMAL + k] * w[k]
        for a in range(4):
            node = i + a if a < 2 else j + a - 2
            moves += share_of(grip, row, a) ** 2 * inverse_mass[node]
        grip[row, BRAKE] = 0.0
        if dt < math.inf and closes > 0.0 and moves > 0.0:
            stop = 1.0 / (table.stop[i] + table.stop[j])
            most = 2.0 * HARD * (stop * (1.0 / mass[i] + 1.0 / mass[j])) ** 0.5
            most = min(most, AT_ONCE / max(dt, LEAST))
            size = table.radius[i] + table.radius[j]
            rate = min(closes / (SOFT * size), most)
            grip[row, BRAKE] = rate / moves
            box[i, 0], box[j, 0] = box[i, 0] + dt * rate, box[j, 0] + dt * rate
    for row in range(memory.tally[CONTACTS]):
        i, j = memory.pair[row, 0], memory.pair[row, 1]
        grip[row, BRAKE] *= AT_ONCE / max(AT_ONCE, box[i, 0], box[j, 0])
