"""Which way contacts slip from iteration to iteration of a solve, and what friction's tangent makes of it.

What friction can hold, b s with s = q/|q|, is the same however far a contact slips. So its derivative,
b/|q| (P - s s^T), holds nothing along s, and where the solution lies the other way, or nowhere far, Newton's
method leaps back and forth across it; a line search that bears with no leap stops at each contact that turns.
In a solve of ropes that rub on each other the tangent is b/|q| (P - h s s^T) instead, with
    h = (1 + s . p) / 2,   p = q / max(|q|, b) an iteration before:
what slips as it did has the derivative, what has turned is held as by the chord from no slip (lagged
diffusivity), and what is new, or stuck, by the half of that at most. Forces are what they are. Ropes without
friction on each other keep the derivative: some of their heaps would lie still later.
Sources: Vogel & Oman 1996, SIAM J. Sci. Comput. 17:227 (lagged diffusivity); Chan, Golub & Mulet 1999, SIAM
J. Sci. Comput. 20:1964 (between that and Newton's method, as here).
"""

from __future__ import annotations

import math

from ropewalk.core.blocks import dot3
from ropewalk.core.jit import part, small
from ropewalk.laws.pairs.table import AGO, CONTACTS, COURSE, LATER

# Rows of `Band.slips`: p at hand, p of the iteration before, and as COURSE of contacts of ropes.
NOW, BEFORE, WHEN = 0, 3, 6
ROWS = 7


@small
def settled(p, before, course):
    """Return h [1] of a contact: 1 where no iteration has gone before."""
    return 0.5 * (1.0 + dot3(p, before)) if course == LATER else 1.0


@small
def follow_slip(slips, o, i, n, pull, bound):
    """Return h of node i on obstacle o, and note its p; `pull` is q, with what lies along the normal n."""
    if slips.shape[0] == 0:
        return 1.0
    along = dot3(n, pull)
    q = (pull[0] - along * n[0], pull[1] - along * n[1], pull[2] - along * n[2])
    over = 1.0 / max(math.sqrt(dot3(q, q)), bound)
    p = (over * q[0], over * q[1], over * q[2])
    before = (slips[o, BEFORE, i], slips[o, BEFORE + 1, i], slips[o, BEFORE + 2, i])
    for k in range(3):
        slips[o, NOW + k, i] = p[k]
    return settled(p, before, slips[o, WHEN, i])


@part
def keep_slips(slips, course):
    """Go on to the next iteration on obstacles, or to the first or none."""
    for o in range(slips.shape[0]):
        for i in range(slips.shape[2]):
            slips[o, WHEN, i] = course
            for k in range(3):
                slips[o, BEFORE + k, i] = slips[o, NOW + k, i]
                slips[o, NOW + k, i] = 0.0


@part
def set_course(state, slips, course):
    """Begin a solve with FIRST_LOOK, or end it with NO_SOLVE, where ropes rub on ropes."""
    if slips.shape[1] == 0:
        return
    keep_slips(slips, course)
    grip = state.memory.contact.grip
    for row in range(state.memory.contact.tally[CONTACTS]):
        grip[row, COURSE] = course
        for k in range(3):
            grip[row, AGO + k] = 0.0
