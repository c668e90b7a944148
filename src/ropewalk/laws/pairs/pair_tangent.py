"""How the forces of contacts of segments change: 3 x 3 blocks between the four nodes of each.

With b = mu R_n, q before it is cut, s = q/|q| and z the change of u,
    -dR_n = (R' n + c n) . dz                           of a contact that presses
    -dR   = n (-dR_n) + (k_t + c) P dz                                      where it sticks
            n (-dR_n) + (b/|q|) (k_t + c) (P - s s^T) dz + mu s (-dR_n)     where it slips
The last term makes it unsymmetric; without it Newton's method takes two to three times the iterations.
"""

from __future__ import annotations

import math

from ropewalk.core.blocks import ZERO9, scale9
from ropewalk.core.jit import kernel, small
from ropewalk.core.network import add_block, put_pair
from ropewalk.laws.pairs.force import pressed, pull_of
from ropewalk.laws.pairs.table import (
    CONTACTS,
    NORMAL,
    OTHER,
    OWN,
    STIFF,
    between,
    spring_of,
)


@small
def tangent_of(table, memory, row, x, v, weight_x, weight_v):
    """Return the matrix, row by row, that takes a change of u to that of the force, with weights."""
    grip, i, j = memory.grip, memory.pair[row, 0], memory.pair[row, 1]
    soft, hard, stop, damping, size = spring_of(table, grip, row, i, j)
    s, t = grip[row, OWN], grip[row, OTHER]
    u, w = between(x, i, j, s, t), between(v, i, j, s, t)
    push, slope = pressed(grip, row, u, w, soft, hard, stop, damping, size)
    if not push > 0.0:
        return ZERO9
    n = (grip[row, NORMAL], grip[row, NORMAL + 1], grip[row, NORMAL + 2])
    drop = weight_x * slope + weight_v * damping
    own = weight_x * grip[row, STIFF] + weight_v * damping
    q = pull_of(grip, row, u, w, damping)
    total = math.sqrt(q[0] * q[0] + q[1] * q[1] + q[2] * q[2])
    bound = table.friction[0] * push
    share, more, over = 1.0, 0.0, 0.0
    if total > bound:
        share, more, over = bound / total, table.friction[0] * drop, 1.0 / total
    s0, s1, s2 = over * q[0], over * q[1], over * q[2]
    side, ahead = share * own, -share * own
    a0, a1, a2 = (
        (drop - side) * n[0] + more * s0,
        (drop - side) * n[1] + more * s1,
        (drop - side) * n[2] + more * s2,
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


@kernel
def couple_pairs(x, v, table, memory, weight_x, weight_v, network):
    """Add -(weight_x dR/dx + weight_v dR/dv) of all contacts to the network's blocks."""
    number = network.number
    for row in range(memory.tally[CONTACTS]):
        block = tangent_of(table, memory, row, x, v, weight_x, weight_v)
        i, j = memory.pair[row, 0], memory.pair[row, 1]
        s, t = memory.grip[row, OWN], memory.grip[row, OTHER]
        at = 0
        for a in range(4):
            p = number[i + a] if a < 2 else number[j + a - 2]
            wa = share_of(a, s, t)
            add_block(network.diagonal, p, scale9(wa * wa, block))
            for b in range(a + 1, 4):
                q = number[i + b] if b < 2 else number[j + b - 2]
                beside = scale9(wa * share_of(b, s, t), block)
                put_pair(network, p, q, network.room.spots[row, at], beside, beside)
                at += 1


@kernel
def along_pairs(x, v, d, table, memory, weight_x, weight_v):
    """Return d . K d of the same matrix [N m], for a direction (3, n) [m]."""
    total = 0.0
    for row in range(memory.tally[CONTACTS]):
        m = tangent_of(table, memory, row, x, v, weight_x, weight_v)
        i, j = memory.pair[row, 0], memory.pair[row, 1]
        a, b, c = between(d, i, j, memory.grip[row, OWN], memory.grip[row, OTHER])
        total += a * (m[0] * a + m[1] * b + m[2] * c)
        total += b * (m[3] * a + m[4] * b + m[5] * c)
        total += c * (m[6] * a + m[7] * b + m[8] * c)
    return total


@small
def share_of(a, s, t):
    """Return what node a of the four has in u [1]."""
    if a == 0:
        return 1.0 - s
    if a == 1:
        return s
    if a == 2:
        return t - 1.0
    return -t
