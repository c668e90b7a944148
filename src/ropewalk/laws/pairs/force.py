"""The force of contacts of segments: as that of obstacles, between two points of ropes.

With u the vector from a point of segment j to one of segment i, both frozen like the normal n, d the sum
of the radii, g = n.u - d - e (e see `offsets`), P = I - n n^T, D what the vector between the
surfaces (`table.apart`) has changed by since the last accepted step, D' its rate, and R' the friction
spring's force then,
    R_n = max(0, R(-g) - z c n.u')                     it presses
    q   = P (R' - k_t D) - c_t P D'
    R_t = q            where |q| <= mu R_n             it sticks
          mu R_n q/|q| elsewhere                       it slips
on segment i, and the opposite on j, shared among their nodes as the points and `apart` have it. R is k
times the depth in a skin of LAYER d, gets as stiff as the rope is across from 2 LAYER d on, and STOP times
that from 3 to 5 LAYER d: what is thrown against it stops. The damper grows with k_t, so that an impact does
not bounce back whole. Where what closes meets the drag of `brake` and that is more, it is c, and c_t as long
as it lasts: else c. In `adaptive` the drag follows how fast it closes within the step; c_t does not. z is 1,
and less where contacts throw back, see `laws.rebound`; those have no drag.
Sources: Cundall & Strack 1979, Geotechnique 29:47 (friction with memory); Simo & Hughes, Computational
Inelasticity, 1998, ch. 2 (return mapping).
"""

from __future__ import annotations

import math

from ropewalk.core.jit import deferred, small
from ropewalk.laws.hardening import beyond
from ropewalk.laws.pairs.table import (
    APART,
    BRAKE,
    CLOSES,
    CONTACTS,
    FOLLOW,
    LAYER,
    NORMAL,
    OTHER,
    OWN,
    SPRING,
    STIFF,
    apart,
    between,
    depth_of,
    lever_of,
    rubs_by,
    share_of,
    spring_of,
)


@small
def squeeze(depth, soft, hard, stop, layer):
    """Return force [N], its slope [N/m] and energy [J] of a contact that is pressed by `depth` [m]."""
    e = min(depth, layer)
    force, slope, energy = soft * e, soft, 0.5 * soft * e * max(e, 0.0)
    force, slope, energy = beyond(
        min(depth - layer, layer), (hard - soft) / layer, force, slope, energy
    )
    force, slope, energy = beyond(min(depth - 2.0 * layer, layer), 0.0, force, slope, energy)
    rate = 0.5 * (stop - hard) / layer
    force, slope, energy = beyond(min(depth - 3.0 * layer, 2.0 * layer), rate, force, slope, energy)
    return beyond(depth - 5.0 * layer, 0.0, force, slope, energy)


@small
def pull_of(grip, row, u, w, damping):
    """Return P (R' - k_t D) - c_t P D' [N], see above."""
    n0, n1, n2 = grip[row, NORMAL], grip[row, NORMAL + 1], grip[row, NORMAL + 2]
    k = grip[row, STIFF]
    if grip[row, FOLLOW] > 0.0:
        k, damping = grip[row, FOLLOW], 0.0
    q0 = grip[row, SPRING] - k * (u[0] - grip[row, APART]) - damping * w[0]
    q1 = grip[row, SPRING + 1] - k * (u[1] - grip[row, APART + 1]) - damping * w[1]
    q2 = grip[row, SPRING + 2] - k * (u[2] - grip[row, APART + 2]) - damping * w[2]
    along = n0 * q0 + n1 * q1 + n2 * q2
    return (q0 - along * n0, q1 - along * n1, q2 - along * n2)


@small
def drag_of(grip, row, depth, damping, size):
    """Return a contact's drag at a `depth` [N s/m], its damper at least, and the slope of it [N s/m^2]."""
    share = min(depth / (LAYER * size), 1.0)
    drag = grip[row, BRAKE] * share
    if not drag > damping:
        return damping, 0.0
    return drag, grip[row, BRAKE] / (LAYER * size) if share < 1.0 else 0.0


@small
def following(grip, row, depth, rate, damping, size):
    """Return the drag of what closes at `-rate` [m/s] where it goes with that, and what `drag_of` does.

    The second is what its force grows by with the rate [N s/m].
    """
    share, full = min(depth / (LAYER * size), 1.0), -grip[row, BRAKE] * rate / grip[row, CLOSES]
    drag = full * share
    if not drag > damping:
        return damping, damping, 0.0
    return drag, 2.0 * drag, full / (LAYER * size) if share < 1.0 else 0.0


@small
def pressed(grip, row, u, w, soft, hard, stop, damping, size):
    """Return R_n before it is cut [N], its slope [N/m], and what it loses with the gap's rate [N s/m]."""
    n0, n1, n2 = grip[row, NORMAL], grip[row, NORMAL + 1], grip[row, NORMAL + 2]
    depth, rate = depth_of(grip, row, u, size), n0 * w[0] + n1 * w[1] + n2 * w[2]
    force, slope, _ = squeeze(depth, soft, hard, stop, LAYER * size)
    drag, steep = drag_of(grip, row, depth, damping, size)
    if rate < 0.0:
        if grip[row, CLOSES] > 0.0:
            drag, loses, steep = following(grip, row, depth, rate, damping, size)
            return force - drag * rate, slope - steep * rate, loses
        return force - drag * rate, slope - steep * rate, drag
    return force - damping * rate, slope, damping


@small
def pair_forces(x, v, table, memory, force, lo, hi):
    """Write the force of all contacts on every node [N], (3, n), and what of it rubs, the next 3 rows."""
    for k in range(force.shape[0]):
        row = force[k]
        for i in range(lo, min(hi, row.shape[0])):
            row[i] = 0.0
    if memory.tally[CONTACTS] > 0:
        add_pair_forces(x, v, table, memory, force)


@deferred()
def add_pair_forces(x, v, table, memory, force):
    """Add the force of all contacts on every node [N], (3, n), and what of it rubs where there are rows."""
    pair, grip, rubs = memory.pair, memory.grip, force.shape[0] > 3
    for row in range(memory.tally[CONTACTS]):
        i, j = pair[row, 0], pair[row, 1]
        soft, hard, stop, damping, size = spring_of(table, memory.grip, row, i, j)
        u, w = apart(x, grip, row, i, j), apart(v, grip, row, i, j)
        ratio = table.ratio[0]
        push, _, _ = pressed(grip, row, u, w, soft, hard, stop, ratio * damping, size)
        if not push > 0.0:
            continue
        drag, _ = drag_of(grip, row, depth_of(grip, row, u, size), damping, size)
        q = pull_of(grip, row, u, w, drag)
        total = math.sqrt(q[0] * q[0] + q[1] * q[1] + q[2] * q[2])
        bound = rubs_by(table, grip, row, i, j) * push
        share = bound / total if total > bound else 1.0
        rub = (share * q[0], share * q[1], share * q[2])
        for a in range(4):
            node, part = i + a if a < 2 else j + a - 2, share_of(grip, row, a)
            lever = lever_of(grip, row, a)
            turn = lever[0] * rub[0] + lever[1] * rub[1] + lever[2] * rub[2]
            for k in range(3):
                n = grip[row, NORMAL + k]
                r = part * rub[k] + turn * n
                force[k, node] += part * push * n + r
                if rubs:
                    force[3 + k, node] += r


@small
def depth_at(x, memory, row, i, j, size):
    """Return how deep a contact counts as pressed at places (3, n) [m]; negative where it is open."""
    grip = memory.grip
    return depth_of(grip, row, between(x, i, j, grip[row, OWN], grip[row, OTHER]), size)


@deferred("float64")
def pair_energy(x, table, memory):
    """Return what contacts have stored where they are pressed in [J]."""
    total = 0.0
    for row in range(memory.tally[CONTACTS]):
        i, j = memory.pair[row, 0], memory.pair[row, 1]
        soft, hard, stop, _, size = spring_of(table, memory.grip, row, i, j)
        depth = depth_at(x, memory, row, i, j, size)
        total += squeeze(depth, soft, hard, stop, LAYER * size)[2] if depth > 0.0 else 0.0
    return total


@deferred("float64")
def pair_rounding(x, table, memory):
    """Return what rounding of the places does to the forces of contacts [N]."""
    size, most = 0.0, 0.0
    for k in range(3):
        for i in range(x.shape[1]):
            size = max(size, abs(x[k, i]))
    for row in range(memory.tally[CONTACTS]):
        i, j = memory.pair[row, 0], memory.pair[row, 1]
        soft, hard, stop, _, wide = spring_of(table, memory.grip, row, i, j)
        depth = depth_at(x, memory, row, i, j, wide)
        most = max(most, squeeze(depth, soft, hard, stop, LAYER * wide)[1])
    return 16.0 * 2.220446049250313e-16 * most * size
