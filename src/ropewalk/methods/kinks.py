"""Kinks: the times at which an anchor's velocity or a clamp's rate jumps, or an anchor lets go.

Nothing of an order above one survives a kink inside a step, nor a step that takes the rate from the wrong
side of one. So steps are cut at kinks; a step that ends at one sees the rate before it, and one that begins
at one the rate after it. What the jump of a held node does to the kinetic energy is its anchor's work.
Hands change a rate between two calls: the first step of a call begins with the new one.
"""

from __future__ import annotations

import numpy as np

from ropewalk.core.arrays import Anchors, Bending, Floats
from ropewalk.core.jit import kernel, part
from ropewalk.laws.anchors import anchor_target
from ropewalk.laws.clamps import spins_jump, turn_clamps
from ropewalk.laws.joints import follow, tied_to
from ropewalk.laws.nodes import whether
from ropewalk.laws.rare import has_clamps
from ropewalk.motions.registry import HAND
from ropewalk.motions.rows import jumps

JUST_BELOW = 1.0 - 2.3e-16
AT = 1e-6  # [1] a kink this near to an end of a step, over its length, is at that end ...
ROUNDING = 1e-15  # [1] ... or by this share of the time

_laws_have = whether("kinks")


def kink_times(anchors: Anchors, bending: Bending, *laws: Floats) -> Floats:
    """Return the times of all kinks after time zero [s], sorted.

    Starts and stops of motions and of turning clamps, corners of tables, releases, and what `laws` of nodes
    add.
    """
    turns = bending.turn[bending.clamped == 1, 1:].ravel()
    return in_order([jumps(anchors), anchors.release, turns, *laws])


def in_order(times: list[Floats]) -> Floats:
    """Return the finite ones of these times after zero [s], sorted."""
    found = np.unique(np.concatenate(times))
    return np.ascontiguousarray(found[np.isfinite(found) & (found > 0.0)])


@kernel
def next_break(times, t):
    """Return the first of the sorted `times` after `t`, inf when there is none [s]."""
    low, high = 0, times.shape[0]
    while low < high:
        middle = (low + high) // 2
        if times[middle] <= t:
            low = middle + 1
        else:
            high = middle
    return times[low] if low < times.shape[0] else np.inf


@part
def near(t, dt):
    """Return how near to an end of a step of `dt` a kink at about `t` is at that end [s]."""
    return max(AT * dt, ROUNDING * abs(t))


@kernel
def next_kink(kinks, begin, after, dt):
    """Return the last kink at the step's begin (-inf: none) and the next in it or at its end, or inf [s]."""
    little, here = near(begin, dt), -np.inf
    later = next_break(kinks, begin - little)
    while later <= begin + little:
        here, later = later, next_break(kinks, later)
    return here, later if later <= after + near(after, dt) else np.inf


@part
def take_up_rates(system, state, t, point, speed):
    """Give held nodes and clamps their rates just after time `t` [s]; return how many numbers jumped.

    The jump of a node's kinetic energy is booked as its anchor's work.
    """
    jumps = 0
    for row in range(state.held.shape[0]):
        if state.held[row] == 1:
            jumps += _take_up(system, state, row, t, point, speed)
    if has_clamps(system, state):
        bending = system.bending
        jumps += spins_jump(
            state.held, bending.clamped, bending.axis, bending.turn, t, state.clamp_spin
        )
        turn_clamps(system, state, t)
    return jumps


@part
def take_up_laws(system, state, t):
    """Let laws of nodes that have kinks go on with what holds just after one at time `t` [s]; return 1 or 0.

    Their forces may have jumped, and what they remember of the time just before is that of the kink.
    """
    has = _laws_have(system)
    if has:
        state.now[0], state.now[1] = t, t
    return 1 if has else 0


@part
def take_up_hands(system, state, t, point, speed):
    """Give the nodes in hands their new rates at time `t` [s]; return how many numbers jumped."""
    jumps = 0
    for row in range(state.held.shape[0]):
        if state.held[row] == 1 and system.anchors.kind[row] == HAND:
            jumps += _take_up(system, state, row, t, point, speed)
    return jumps


@part
def _take_up(system, state, row, t, point, speed):
    """Give the node that an anchor holds its rate just after time `t` [s]; book the jump as work."""
    anchor_target(system, state, row, t, 0.0, point, speed)
    jumps, i = 0, state.anchor_node[row]
    first, last = tied_to(system, state, row)
    mass = state.mass[i]
    for p in range(first, last):
        mass += state.mass[system.joints.member[p]] if system.joints.member[p] != i else 0.0
    for k in range(3):
        old, new = state.v[k, i], speed[k]
        if old != new:
            jumps += 1
            state.work.anchors[row] += 0.5 * mass * (new * new - old * old)
            state.most[row] = max(state.most[row], abs(state.work.anchors[row]))
            state.anchor_v[row, k] = new
            state.v[k, i] = new
    follow(system.joints.member, first, last, i, state.v)
    return jumps


@part
def next_piece(system, state, t, begin, after, dt, point, speed):
    """Begin a piece of the step from `t` to `after` [s] at `begin`, with the rates after a kink there.

    Returns its length, the time just before which it ends where there is a kink, its end, and how many
    numbers jumped at its begin. Without a kink it is the whole step.
    """
    h, end, stop, jumps = dt, after, after, 0
    if system.kinks.shape[0] > 0:
        here, kink = next_kink(system.kinks, begin, after, dt)
        if here > -np.inf:
            jumps = take_up_rates(system, state, max(begin, here), point, speed)
            jumps += take_up_laws(system, state, max(begin, here))
        if kink < np.inf:
            stop = kink if kink < after - near(after, dt) else after
            end = min(after, kink * JUST_BELOW)
        if stop < after or begin > t:
            h = stop - begin
    return h, end, stop, jumps
