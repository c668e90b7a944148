"""Bending stiffness at drums: bends next to segments whose lengths winches change.

A bend is EI over the length l that it stands for. Without a clamp the moment vanishes at the drum: where it
grows linearly from there, over segments of L and h, the turn is M / EI times
    l = (2 L + h) (L + h) / (6 L),
which is h where L is. With one it is (L + h) / 2, and the half cell at the drum stands for L / 2. A node that
comes off the drum is put on the beam that its segment was,
    w = c_d (s (L - s) / 2 - q) + c_o q,   q = s (L^2 - s^2) / (6 L),
c_d and c_o the curvatures at the drum and at the node ahead, s the way from the drum: so moments stay at a
hinge, and jump by about the segment times their slope at a clamp, whose half cell takes them for constant.
Where a node goes on to the drum they do so by themselves.
"""

from __future__ import annotations

import math

from ropewalk.core.jit import deferred, kernel, small

_MOST = 0.25  # [1] of the way from the drum: a node comes off no farther aside


@small
def holds_direction(system, state, node):
    """Tell whether an anchor holds the direction of the rope at a node."""
    holds = False
    for row in range(state.moment.shape[0]):
        if state.anchor_node[row] == node and state.held[row] == 1:
            holds = holds or system.bending.clamped[row] == 1
    return holds


@small
def is_hinge(system, state, node):
    """Tell whether a node is on a drum that lets the rope turn."""
    drum = False
    for row in range(state.winch_exit.shape[0]):
        drum = drum or state.winch_exit[row] == node
    return drum and not holds_direction(system, state, node)


@small
def stood_for(length, other):
    """Return what a bend between `length`, whose other end is hinged, and `other` stands for [m]."""
    return (2.0 * length + other) * (length + other) / (6.0 * length)


@kernel
def set_bend(system, state, nominal, i):
    """Give the bend at node `i` the stiffness that goes with the lengths beside it, once `nominal` [m]."""
    full = system.bending.stiffness[i]
    state.bending_stiffness[i] = 0.0
    state.bending_damping[i] = 0.0
    if full == 0.0 or holds_direction(system, state, i):
        return
    before, after = state.rest_length[i - 1], state.rest_length[i]
    if min(before, after) <= 0.0:  # on the drum, or parted
        return
    one, other = is_hinge(system, state, i - 1), is_hinge(system, state, i + 1)
    length = 0.5 * (before + after)
    if one and other:
        length = 0.5 * (stood_for(before, after) + stood_for(after, before))
    elif one:
        length = stood_for(before, after)
    elif other:
        length = stood_for(after, before)
    state.bending_stiffness[i] = full * nominal / length
    state.bending_damping[i] = system.bending.damping[i] * nominal / length


@deferred()
def set_bends(system, state, row):
    """Give the bends at the drum of a winch the stiffness that goes with the lengths that are there now."""
    winches = system.winches
    drum, side = state.winch_exit[row], winches.step[row]
    nominal, last, first = winches.segment[row], winches.last[row], winches.first[row]
    for i in (drum, drum + side, drum + 2 * side):
        if min(first, last) < i < max(first, last):
            set_bend(system, state, nominal, i)


@kernel
def set_all_bends(system, state):
    """As `set_bends`, of all winches, and all that their ropes have off drums. For the host."""
    for row in range(state.winch_exit.shape[0]):
        first, last = system.winches.first[row], system.winches.last[row]
        for i in range(min(first, last) + 1, max(first, last)):
            before, after = state.rest_length[i - 1], state.rest_length[i]
            gone = min(before, after) <= 0.0  # on a drum, or parted
            bends = not gone and not holds_direction(system, state, i)
            state.bending_stiffness[i] = system.bending.stiffness[i] if bends else 0.0
            state.bending_damping[i] = system.bending.damping[i] if bends else 0.0
    for row in range(state.winch_exit.shape[0]):
        set_bends(system, state, row)


@small
def bulge(system, state, row, length):
    """Return how far aside of the chord a node comes off the drum of winch `row` [m], see `put_on_beam`."""
    winches = system.winches
    drum, side = state.winch_exit[row], winches.step[row]
    outer, nominal = drum + side, winches.segment[row]
    s = length - nominal
    ax, ay, az, r = toward(state.x, drum - side, outer)
    if r < 0.5 * length:  # a heap
        return 0.0, 0.0, 0.0
    q = s * (length * length - s * s) / (6.0 * length)
    ux, uy, uz = 0.0, 0.0, 0.0
    if outer != winches.last[row] and state.bending_stiffness[outer] > 0.0:
        bx, by, bz, _ = toward(state.x, outer, outer + side)
        c = q * state.bending_stiffness[outer] / (system.bending.stiffness[outer] * nominal)
        ux, uy, uz = c * (ax - bx), c * (ay - by), c * (az - bz)
    for other in range(state.moment.shape[0]):
        clamped = state.held[other] == 1 and system.bending.clamped[other] == 1
        if clamped and state.anchor_node[other] == drum:
            c, d = 2.0 / length * (0.5 * s * (length - s) - q), state.clamp_direction
            ux -= c * (ax - side * d[other, 0])
            uy -= c * (ay - side * d[other, 1])
            uz -= c * (az - side * d[other, 2])
    along = ux * ax + uy * ay + uz * az
    ux, uy, uz = ux - along * ax, uy - along * ay, uz - along * az
    size, most = math.sqrt(ux * ux + uy * uy + uz * uz), _MOST * min(s, length - s)
    share = most / size if size > most else 1.0
    return share * ux, share * uy, share * uz


@deferred("float64")
def put_on_beam(system, state, row, length):
    """Move a node that has come off a drum on the chord on to the beam; return the near part's length [m].

    It is the exit still, its place on the drum that of the next one. `length` [m] is that of both parts, the
    far one keeps its own. Both keep the strain that they have.
    """
    winches, x, v = system.winches, state.x, state.v
    drum, side, nominal = state.winch_exit[row], winches.step[row], winches.segment[row]
    inner, outer = drum - side, drum + side
    ux, uy, uz = bulge(system, state, row, length)
    square = ux * ux + uy * uy + uz * uz
    if square == 0.0:
        return length - nominal
    ax, ay, az, r = toward(x, inner, outer)
    far = nominal / length * r
    back = math.sqrt(far * far - square)
    swing = ux * (v[0, outer] - v[0, inner])
    swing += uy * (v[1, outer] - v[1, inner]) + uz * (v[2, outer] - v[2, inner])
    x[0, drum] = x[0, outer] - back * ax + ux
    x[1, drum] = x[1, outer] - back * ay + uy
    x[2, drum] = x[2, outer] - back * az + uz
    v[0, drum] -= swing / r * ax
    v[1, drum] -= swing / r * ay
    v[2, drum] -= swing / r * az
    _, _, _, near = toward(x, inner, drum)
    return near * length / r


@small
def toward(x, i, k):
    """Return the unit vector from node `i` to node `k`, and how far that is [m]."""
    dx, dy, dz = x[0, k] - x[0, i], x[1, k] - x[1, i], x[2, k] - x[2, i]
    r = math.sqrt(dx * dx + dy * dy + dz * dz)
    over = 1.0 / r if r > 0.0 else 0.0
    return over * dx, over * dy, over * dz, r
