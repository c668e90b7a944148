"""With which length of its parts a step begins: where ropes heap up, with that of the last one.

In a pile the whole step, its half and its quarter fail again and again, each after all its iterations. So
there the parts of one step go on in the next as if both were one: `need` of them are solved for before one of
twice their length is tried, at the beginning of a step, too. A whole step that is solved ends that.

It is a pile where many ropes touch. With bending few ever do, and most tries fail where a rope lands: there
it is one while a node goes fast, and what lies comes to rest in whole steps. So it is where a rope comes down
on obstacles that are no planes: slow ones that slip take whole steps.
"""

from __future__ import annotations

import math

import numpy as np

from ropewalk.core.jit import kernel, part, small
from ropewalk.laws.contact import is_round
from ropewalk.laws.couplings import couples, may_couple
from ropewalk.laws.pairs.table import CONTACTS
from ropewalk.laws.rare import has_bending

MOST_HALVINGS = 12
SMALLEST_PART = 0.5**MOST_HALVINGS  # [1] of a step
FEWEST_PARTS, MOST_PARTS = 2, 16  # that are solved before one of twice their length is tried
MANY = 64  # contacts from which on parts go on in the next step, without bending
FAST = 0.25  # [1] of a diameter that a node has to go in a step for it with bending
LENGTH, SOLVED, NEED = 3, 4, 5  # places in `State.past`


@part
def carries_parts(system, state, dt, soft, struck):
    """Tell whether the parts of the last step go on in the next of `dt` [s].

    It is by implicit Euler: `soft`, or as the last one has `struck` something.
    """
    beside = (soft or struck) and not couples(system, state)
    if beside and carries_beside(system, state, dt):
        return True
    tally = state.memory.contact.tally
    if not soft or not may_couple(system) or tally.shape[0] == 0:
        return False
    if has_bending(system):
        return is_fast(state.v, dt, system.node.contact)
    return tally[CONTACTS] >= MANY


@part
def keeps_parts(system, state, dt, soft):
    """Tell whether a step that began otherwise leaves parts to the next, as it ended by implicit Euler."""
    return soft and not couples(system, state) and carries_beside(system, state, dt)


@part
def carries_beside(system, state, dt):
    """Tell whether the parts of the last step go on beside obstacles, one of which is no plane."""
    if state.memory.obstacle.grip.shape[0] == 0 or not is_round(system.node.obstacle):
        return False
    return goes_far(state.v, dt, thinnest(system.node.obstacle))


@kernel
def thinnest(obstacles):
    """Return half the least diameter of what may touch an obstacle [m]."""
    thin = np.inf
    for i in range(obstacles.diameter.shape[0]):
        thin = min(thin, obstacles.diameter[i])
    return 0.5 * thin


@kernel
def is_fast(v, dt, table):
    """Tell whether a node goes by more than FAST of the thinnest rope's diameter in `dt` [s]; v is (3, n)."""
    thin = np.inf
    for j in range(table.radius.shape[0]):
        thin = min(thin, table.radius[j]) if table.rope[j] >= 0 else thin
    return goes_far(v, dt, thin)


@small
def goes_far(v, dt, thin):
    """Tell whether a node goes by more than FAST of twice `thin` [m] in `dt` [s]; v is (3, n)."""
    most = 0.0
    for i in range(v.shape[1]):
        most = max(most, v[0, i] * v[0, i] + v[1, i] * v[1, i] + v[2, i] * v[2, i])
    return dt * math.sqrt(most) > 2.0 * FAST * thin


@kernel
def begin_parts(past, dt, carried):
    """Return with which of 2^level parts of `dt` [s] a step begins.

    That level, how many were solved of this length, how many are to be, and whether it is tried anew.
    """
    if not carried or past[LENGTH] == 0.0:
        return 0, 0, FEWEST_PARTS, False
    level, h = 0, dt
    while h > 1.5 * past[LENGTH] and level < MOST_HALVINGS:  # but for rounding
        level, h = level + 1, 0.5 * h
    return level, int(past[SOLVED]), int(past[NEED]), past[SOLVED] == 0.0


@kernel
def keep_parts(past, dt, carried, level, run, need):
    """Note with which parts the next step begins; `run` of 2^level were solved, `need` are to be."""
    grown = run >= need
    past[LENGTH] = dt / 2.0 ** (level - 1 if grown else level) if carried and level > 0 else 0.0
    past[SOLVED], past[NEED] = 0.0 if grown else run, need
