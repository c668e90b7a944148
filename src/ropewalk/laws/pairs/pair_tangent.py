"""How the forces of contacts of segments change: 3 x 3 blocks between the four nodes of each.

With b = mu R_n, q before it is cut, s = q/|q| and z the change of the vector between the surfaces,
    -dR_n = (R' n + c n) . dz                           of a contact that presses
    -dR   = n (-dR_n) + (k_t + c_t) P dz                                      where it sticks
            n (-dR_n) + (b/|q|) (k_t + c_t) (P - s s^T) dz + mu s (-dR_n)     where it slips
where s s^T counts less while a contact turns in a solve, see `laws.slip_course`,
and what c_t grows by with the depth, times (P - s s^T) D', less, where it is that of a drag.
A node whose part of that vector is M = w I + l n^T, w its share and l its lever, gets M^T dR.
In a solve's first iteration R' is R over the depth beyond the skin: a guess lets ropes go on into each other,
where R is steep, and by R' each iteration would only halve that depth.
The last term makes it unsymmetric; without it Newton's method takes two to three times the iterations.
"""

from __future__ import annotations

import math

from ropewalk.core.blocks import ZERO9, apply, apply_left, dot3, less_product, scale3, scale9
from ropewalk.core.jit import deferred, kernel, small
from ropewalk.core.network import add_block, put_pair
from ropewalk.laws.pairs.force import drag_of, pressed, pull_of, squeeze
from ropewalk.laws.pairs.table import (
    AGO,
    ASKED,
    CONTACTS,
    COURSE,
    FIRST_LOOK,
    FOLLOW,
    LATER,
    LAYER,
    NO_SOLVE,
    NORMAL,
    STIFF,
    apart,
    depth_of,
    lever_of,
    rubs_by,
    share_of,
    spring_of,
)


@small
def chord_less_slope(depth, soft, hard, stop, layer):
    """Return by how much more R is over the depth than R' beyond the skin [N/m]."""
    if not depth > layer:
        return 0.0
    force, slope, _ = squeeze(depth, soft, hard, stop, layer)
    return force / depth - slope


@small
def tangent_of(table, memory, row, x, v, weight_x, weight_v):
    """Return the matrix, row by row, that takes a change of `apart` to that of the force, with weights."""
    grip, i, j = memory.grip, memory.pair[row, 0], memory.pair[row, 1]
    soft, hard, stop, damping, size = spring_of(table, grip, row, i, j)
    u, w = apart(x, grip, row, i, j), apart(v, grip, row, i, j)
    ratio = table.ratio[0]
    push, slope, drag = pressed(grip, row, u, w, soft, hard, stop, ratio * damping, size)
    if not push > 0.0:
        return ZERO9
    if grip[row, COURSE] == FIRST_LOOK:
        slope += chord_less_slope(depth_of(grip, row, u, size), soft, hard, stop, LAYER * size)
    n = (grip[row, NORMAL], grip[row, NORMAL + 1], grip[row, NORMAL + 2])
    drop = weight_x * slope + weight_v * drag
    across, steep = drag_of(grip, row, depth_of(grip, row, u, size), damping, size)
    own = weight_x * grip[row, STIFF] + weight_v * across
    if grip[row, FOLLOW] > 0.0:
        own, steep = weight_x * grip[row, FOLLOW], 0.0
    q = pull_of(grip, row, u, w, across)
    total = math.sqrt(q[0] * q[0] + q[1] * q[1] + q[2] * q[2])
    friction = rubs_by(table, grip, row, i, j)
    bound = friction * push
    share, more, over = 1.0, 0.0, 0.0
    if total > bound:
        share, more, over = bound / total, friction * drop, 1.0 / total
    s0, s1, s2 = over * q[0], over * q[1], over * q[2]
    side, ahead = share * own, -share * own
    if total > bound and grip[row, COURSE] == LATER:
        before = (grip[row, AGO], grip[row, AGO + 1], grip[row, AGO + 2])
        ahead *= 0.5 * (1.0 + s0 * before[0] + s1 * before[1] + s2 * before[2])
    rise, slide = dot3(n, w), s0 * w[0] + s1 * w[1] + s2 * w[2]
    steep *= share * weight_x
    a0, a1, a2 = (
        (drop - side) * n[0] + more * s0 - steep * (w[0] - rise * n[0] - slide * s0),
        (drop - side) * n[1] + more * s1 - steep * (w[1] - rise * n[1] - slide * s1),
        (drop - side) * n[2] + more * s2 - steep * (w[2] - rise * n[2] - slide * s2),
    )
    return (
        a0 * n[0] + ahead * s0 * s0 + side,
        a0 * n[1] + ahead * s0 * s1,
        a0 * n[2] + ahead * s0 * s2,
        a1 * n[0] + ahead * s1 * s0,
        a1 * n[1] + ahead * s1 * s1 + side,
        a1 * n[2] + ahead * s1 * s2,
        a2 * n[0] + ahead * s2 * s0,
        a2 * n[1] + ahead * s2 * s1,
        a2 * n[2] + ahead * s2 * s2 + side,
    )


@small
def between_nodes(m, grip, row, a, b):
    """Return M_a^T m M_b of two of the four nodes."""
    wa, wb = share_of(grip, row, a), share_of(grip, row, b)
    la, lb = lever_of(grip, row, a), lever_of(grip, row, b)
    n = (grip[row, NORMAL], grip[row, NORMAL + 1], grip[row, NORMAL + 2])
    left, right = apply_left(la, m), apply(m, lb)
    both = dot3(la, right)
    column = (
        -wa * right[0] - both * n[0],
        -wa * right[1] - both * n[1],
        -wa * right[2] - both * n[2],
    )
    return less_product(less_product(scale9(wa * wb, m), column, n), scale3(-wb, n), left)


@deferred()
def couple_pairs(x, v, table, memory, weight_x, weight_v, network):
    """Add -(weight_x dR/dx + weight_v dR/dv) of all contacts to the network's blocks."""
    number, grip, first = network.number, memory.grip, memory.tally[ASKED]
    for row in range(memory.tally[CONTACTS]):
        block = tangent_of(table, memory, row, x, v, weight_x, weight_v)
        if block == ZERO9:  # it does not press
            continue
        i, j = memory.pair[row, 0], memory.pair[row, 1]
        at = 0
        for a in range(4):
            p = number[i + a] if a < 2 else number[j + a - 2]
            add_block(network.diagonal, p, between_nodes(block, grip, row, a, a))
            for b in range(a + 1, 4):
                q = number[i + b] if b < 2 else number[j + b - 2]
                up = between_nodes(block, grip, row, a, b)
                low = between_nodes(block, grip, row, b, a)
                put_pair(network, p, q, network.room.spots[first + row, at], up, low)
                at += 1


@kernel
def note_slip(x, v, table, memory, row):
    """Keep what a contact holds of what friction can, for the tangent of the next iteration."""
    grip, i, j = memory.grip, memory.pair[row, 0], memory.pair[row, 1]
    soft, hard, stop, damping, size = spring_of(table, grip, row, i, j)
    u, w = apart(x, grip, row, i, j), apart(v, grip, row, i, j)
    push, _, _ = pressed(grip, row, u, w, soft, hard, stop, table.ratio[0] * damping, size)
    across, _ = drag_of(grip, row, depth_of(grip, row, u, size), damping, size)
    q, over = pull_of(grip, row, u, w, across), 0.0
    if push > 0.0:
        over = 1.0 / max(rubs_by(table, grip, row, i, j) * push, math.sqrt(dot3(q, q)), 1e-300)
    grip[row, COURSE] = LATER
    for k in range(3):
        grip[row, AGO + k] = over * q[k]


@deferred("float64")
def along_pairs(x, v, d, table, memory, weight_x, weight_v):
    """Return d . K d of the same matrix [N m], for a direction (3, n) [m]; last in an iteration."""
    total = 0.0
    for row in range(memory.tally[CONTACTS]):
        m = tangent_of(table, memory, row, x, v, weight_x, weight_v)
        z = apart(d, memory.grip, row, memory.pair[row, 0], memory.pair[row, 1])
        total += dot3(z, apply(m, z))
        if memory.grip[row, COURSE] != NO_SOLVE:
            note_slip(x, v, table, memory, row)
    return total
