"""The force of slides: a spring across, friction along.

With u the place on the curve that is nearest to the node, r from there to the node, r' its derivative and g'
that of r.r' (`rail`), all others by their gradients so that momentum and angular momentum are kept:
    V = k r.r / 2                                   it stays on the rope; nothing along it, as r is across
    q = R' - k w (u - u') - c w du/dt               a friction spring between place and rope
    R = q            where |q| <= mu k |r| + b      it sticks
        (mu k |r| + b) q/|q|      elsewhere         it slips
    f = -grad V + R w grad u,    w = g' / |r'|
w du/dt is how fast the node goes along the rope past the point that it is at, so that R is the force along
the rope however that is stretched, and where it folds: w grad u = -(a r' + a' r) / |r'| has no g' below.
In a cusp, where the curve turns round and |r'| is nothing, FOLDED of a segment takes its place (`rail`): that
force had no bound there.
b is the brake's force, from its place on, in full after one segment; R' and u' are of the last accepted
step. At an end of the rope u stays and V holds the node there: a stop.

u counts the rope's own nodes: of a rope on a winch it stays what it was while rope goes on to the drum.
Nearer to the drum than z there is a stop that stands there, k (z - d)^2 / 2 with d the distance between node
and drum: there no node comes on to the drum, or off it, that carries a part of F. The segment at the drum is
0.4 to 1.6 as long as the others, X is 1.5 of them wide, so that z has to be 2.1 of them, as they are
stretched: see `stops`.
At a broken end u goes on, and what is there at the end of a step is off: no force from then on.
Sources: Cundall & Strack 1979, Geotechnique 29:47 (friction with memory); Lanczos, The Variational Principles
of Mechanics, ch. 3 and 4 (generalised forces).
"""

from __future__ import annotations

import math

from ropewalk.core.jit import deferred, kernel, small
from ropewalk.laws.slides.rail import look
from ropewalk.laws.slides.stops import move_stops, to_drum
from ropewalk.laws.slides.table import (
    APART,
    AT,
    GRADIENT,
    HIGH,
    INSIDE,
    LOOSE,
    LOW,
    PER_PLACE,
    PLACE,
    SHARE,
    SPRING,
    R,
)


@small
def bound_of(table, sight, row):
    """Return the most that friction and brake can carry at the place in sight [N]."""
    way = (sight[row, AT] * table.length[row] - table.brake_from[row]) / table.length[row]
    share = min(max(way, 0.0), 1.0) if table.brake_from[row] > 0.0 else 1.0
    push = table.stiffness[row] * sight[row, APART]
    return table.friction[row] * push + share * table.brake[row]


@small
def spring_of(table, memory, row):
    """Return the friction spring's force at the place in sight, not yet cut [N]."""
    way = memory.sight[row, AT] - memory.grip[row, PLACE]
    return memory.grip[row, SPRING] - table.hold[row] * memory.sight[row, PER_PLACE] * way


@small
def rate_of(v, memory, row):
    """Return how fast the place in sight changes where nodes move with v, (3, n) [1/s]."""
    total = 0.0
    for m in range(4):
        i = memory.group[row, m]
        for k in range(3):
            total += memory.sight[row, GRADIENT + 3 * m + k] * v[k, i]
    return total


@small
def cut(force, bound):
    """Return a force cut to a bound."""
    return min(max(force, -bound), bound)


@small
def rubbing(v, table, memory, row):
    """Return R before it is cut, and its bound [N]; 0 at an end."""
    if memory.sight[row, INSIDE] == 0.0:
        return 0.0, 0.0
    bound = bound_of(table, memory.sight, row)
    if bound == 0.0:
        return 0.0, 0.0
    q = spring_of(table, memory, row)
    q -= table.damping[row] * memory.sight[row, PER_PLACE] * rate_of(v, memory, row)
    return q, bound


@small
def on_rope(memory, row):
    """Tell whether a slide is on its rope still."""
    return memory.off[row] == math.inf


@small
def stop_forces(x, table, memory, row, force):
    """Add the forces of the stops at drums, on what slides and on the drums."""
    for side in range(2):
        drum, deep, a, b, c, _ = to_drum(x, table, memory, row, side)
        if drum >= 0:
            push, node = table.stiffness[row] * deep, table.node[row]
            force[0, node] += push * a
            force[1, node] += push * b
            force[2, node] += push * c
            force[0, drum] -= push * a
            force[1, drum] -= push * b
            force[2, drum] -= push * c


@deferred()
def slide_forces(x, v, table, memory, force, lo, hi):
    """Write the force of all slides on every node [N], (3, n)."""
    for i in range(lo, min(hi, x.shape[1])):
        force[0, i], force[1, i], force[2, i] = 0.0, 0.0, 0.0
    add_slide_forces(x, v, table, memory, force)


@kernel
def add_slide_forces(x, v, table, memory, force):
    """Add the force of all slides on every node [N], (3, n)."""
    sight = memory.sight
    for row in range(table.node.shape[0]):
        if not on_rope(memory, row):
            continue
        look(x, table, memory, row)
        stop_forces(x, table, memory, row, force)
        q, bound = rubbing(v, table, memory, row)
        along = cut(q, bound) * sight[row, PER_PLACE]
        for m in range(4):
            i, push = memory.group[row, m], -table.stiffness[row] * sight[row, SHARE + m]
            for k in range(3):
                force[k, i] += push * sight[row, R + k] + along * sight[row, GRADIENT + 3 * m + k]


@deferred("float64")
def slide_energy(x, table, memory):
    """Return what slides have stored, their friction springs included [J]."""
    total = 0.0
    for row in range(table.node.shape[0]):
        if not on_rope(memory, row):
            continue
        look(x, table, memory, row)
        square = memory.sight[row, APART] ** 2
        for side in range(2):
            square += to_drum(x, table, memory, row, side)[1] ** 2
        total += 0.5 * table.stiffness[row] * square
        if memory.sight[row, INSIDE] == 1.0:
            held = cut(spring_of(table, memory, row), bound_of(table, memory.sight, row))
            total += 0.5 * held * held / table.hold[row]
    return total


@deferred("int64")
def remember_slides(x, table, memory):
    """Keep where slides are and what their friction carries; return the first that is off its rope, or -1."""
    lost = -1
    for row in range(table.node.shape[0]):
        if not on_rope(memory, row):
            continue
        look(x, table, memory, row)
        held = 0.0
        if memory.sight[row, INSIDE] == 1.0:
            held = cut(spring_of(table, memory, row), bound_of(table, memory.sight, row))
        memory.grip[row, SPRING], memory.grip[row, PLACE] = held, memory.sight[row, AT]
        move_stops(x, table, memory, row)
        if lost < 0 and not memory.sight[row, APART] <= 0.5 * table.length[row]:
            lost = row
    return lost


@deferred("boolean")
def let_run_off(memory, time):
    """Let go what is beyond a broken end at `time` [s]; tell whether anything is."""
    found = False
    for row in range(memory.off.shape[0]):
        ends, place = memory.ends[row], memory.grip[row, PLACE]
        beyond = (ends[LOOSE] == 1 and place < ends[LOW]) or (
            ends[LOOSE + 1] == 1 and place > ends[HIGH]
        )
        if beyond and on_rope(memory, row):
            memory.off[row], found = time, True
    return found
