"""Which contacts of segments a step hits, or swings in, and how quickly: `adaptive` shortens steps for them.

A contact that throws back is followed on its way in and out, as that of a node with an obstacle is
(`contact.quickest_impact`).
"""

from __future__ import annotations

from ropewalk.core.jit import deferred, small
from ropewalk.laws.contact_frame import MOVES, OFTENER, STOPS
from ropewalk.laws.pairs.brake import closing, stopping
from ropewalk.laws.pairs.force import pressed
from ropewalk.laws.pairs.table import (
    CONTACTS,
    NORMAL,
    OTHER,
    OWN,
    PUSH,
    between,
    spring_of,
    throws_back,
)


@small
def is_pushed(force, i):
    """Tell whether forces (3, n) push on a node of a segment."""
    for k in range(3):
        if force[k, i] != 0.0 or force[k, i + 1] != 0.0:
            return True
    return False


@small
def swings(table, memory, row):
    """Tell whether a contact throws back, and its points moved across it by more than MOVES in the step."""
    if not throws_back(table):
        return False
    i, j, grip = memory.pair[row, 0], memory.pair[row, 1], memory.grip
    u, across = between(memory.way, i, j, grip[row, OWN], grip[row, OTHER]), 0.0
    for k in range(3):
        across += grip[row, NORMAL + k] * u[k]
    return abs(across) > MOVES * (table.radius[i] + table.radius[j])


@small
def swinging(v0, v, force, dt, table, memory, row):
    """Return how quickly a contact swings that throws back, in a step too long for it [1/s]; else 0.

    One that was pressed and goes in or out, or that was not, closes at `v0`, opens at `v`, and had a force on
    the way, mean forces are (3, n) [N].
    """
    i, j, grip = memory.pair[row, 0], memory.pair[row, 1], memory.grip
    soft, _, _, damping, size = spring_of(table, grip, row, i, j)
    quick, closes = OFTENER * soft / damping, closing(v0, grip, row, i, j)
    if grip[row, PUSH] > 0.0:
        return quick if abs(closes) * dt > MOVES * size and quick * dt > STOPS else 0.0
    back = closes > 0.0 > closing(v, grip, row, i, j)
    return quick if back and is_pushed(force, i) and is_pushed(force, j) else 0.0


@deferred("float64")
def quickest_closing(v0, x, v, force, dt, table, memory):
    """Return how quickly contacts stop what they hit in a step of `dt` [s] [1/s]; 0: none does.

    Those that were open and are pressed at its end, `x` and `v`, and those that `v0` at its start closes so
    fast that their drag stops it at once, under mean forces (3, n) [N]. Of those that throw back see
    `swinging`.
    """
    grip, quickest = memory.grip, 0.0
    for row in range(memory.tally[CONTACTS]):
        i, j = memory.pair[row, 0], memory.pair[row, 1]
        soft, hard, stop, damping, size = spring_of(table, grip, row, i, j)
        quickest = max(quickest, stopping(v0, force, dt, memory, row, i, j, size))
        if throws_back(table):
            quickest = max(quickest, swinging(v0, v, force, dt, table, memory, row))
        if not grip[row, PUSH] > 0.0:
            s, t = grip[row, OWN], grip[row, OTHER]
            u, w = between(x, i, j, s, t), between(v, i, j, s, t)
            push = pressed(grip, row, u, w, soft, hard, stop, table.ratio[0] * damping, size)[0]
            quick = OFTENER * soft / damping if throws_back(table) else soft / damping
            quickest = max(quickest, quick) if push > 0.0 else quickest
    return quickest
