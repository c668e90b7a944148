"""Anchors in the step: release, motion, reaction.

The reaction is the force the anchor puts on its node, mean over the step:
    R = m (v1 - v0) / h - F,   so that the anchor's work is h R . (v0 + v1) / 2 (see `ledger`).
A sudden start of a motion is an impulse: in semi-implicit Euler it shows in R for one step, elsewhere it is
booked as work only (`methods.kinks`).
"""

from __future__ import annotations

import math

from ropewalk.core.jit import kernel, part, seldom
from ropewalk.core.ranges import ALL
from ropewalk.laws.clamps import close_clamps, let_bend, turn_clamps
from ropewalk.laws.joint_forces import write_joint_forces
from ropewalk.laws.joints import follow, tie, tied_to
from ropewalk.laws.nodes import hold_up, remember_step
from ropewalk.laws.obstacle_lead import ROUNDED
from ropewalk.laws.pairs.swept import HELD_WIDTH, sweep_held
from ropewalk.laws.rare import has_clamps, limits
from ropewalk.laws.table import force_on_node
from ropewalk.motions.registry import HAND
from ropewalk.motions.whereabouts import place


@part
def first_index(order, state, lo):
    """Return the first index into `order` with a node not before `lo`."""
    return count_before(order, state.anchor_node, lo) if lo > 0 else 0


@part
def last_index(order, state, hi):
    """Return the index into `order` after the last one with a node before `hi`."""
    whole = hi >= state.mass.shape[0]
    return order.shape[0] if whole else count_before(order, state.anchor_node, hi)


@kernel
def count_before(order, nodes, node):
    """Return how many anchors hold nodes before `node`; `order` sorts them (unless a winch turned)."""
    low, high = 0, order.shape[0]
    while low < high:
        middle = (low + high) // 2
        if nodes[order[middle]] < node:
            low = middle + 1
        else:
            high = middle
    return low


@part
def anchor_target(system, state, row, t, ahead, x, v):
    """Write where anchor `row` is at time `t`, `ahead` seconds after the state's own time."""
    for k in range(3):
        x[k] = state.anchor_x[row, k]
        v[k] = state.anchor_v[row, k]
    if system.anchors.kind[row] == HAND:
        for k in range(3):
            x[k] += v[k] * ahead
    else:
        place(system.anchors, row, t, x, v)
    if system.anchors.above_ground[row] == 1:
        hold_up(system, x, v)


@part
def stage_target(system, state, row, t, ahead, end, h, x, v):
    """Write what a stage at time `t` has of anchor `row`: `anchor_target`, but in the first of two of a step
    to `end` of `h` [s], 0: it is none.

    There it has the place P and the velocity U that its method would give what goes with the anchor, see
    `obstacle_lead`: from its own ones nodes would come to the end with 3.4 times its acceleration. Not where
    others hold the same ropes and go another way: what is between them would be stretched by P.
    """
    if h > 0.0 and system.anchors.alike[row] == 1:
        off, size, g = 0.0, 0.0, ahead / h
        anchor_target(system, state, row, end, h, x, v)
        for k in range(3):
            way = x[k] - state.anchor_x[row, k]
            off += abs(way - h * v[k])
            size += abs(x[k]) + abs(way)
        if off > ROUNDED * size:
            for k in range(3):
                before = state.anchor_x[row, k]
                v[k] = ((x[k] - before) / h - g * v[k]) / (1.0 - g)
                x[k] = before + ahead * v[k]
            return
    anchor_target(system, state, row, t, ahead, x, v)


@seldom
def anchor_places(system, state, row, times, x, v, places):
    """Write where anchor `row` is at these times [s], (t, 3) [m], and its last place and velocity."""
    for index in range(times.shape[0]):
        anchor_target(system, state, row, times[index], 0.0, x, v)
        for k in range(3):
            places[index, k] = x[k]


@part
def place_stage(system, state, t, ahead, x, v, point, speed, end=0.0, h=0.0):
    """Put the held nodes of a stage's arrays where their anchors are at its time, see `stage_target`."""
    state.now[0] = t
    for row in range(state.held.shape[0]):
        if state.held[row] == 1:
            stage_target(system, state, row, t, ahead, end, h, point, speed)
            i = state.anchor_node[row]
            for k in range(3):
                x[k, i] = point[k]
                v[k, i] = speed[k]
            first, last = tied_to(system, state, row)
            follow(system.joints.member, first, last, i, x)
            follow(system.joints.member, first, last, i, v)
    turn_clamps(system, state, t)


@part
def move_anchors(system, state, forces, t, dt, middle, point, speed, lo=0, hi=ALL):
    """Move the held nodes to the end of the step at time `t`; book reaction and work.

    So every method ends a step that it accepts: laws with a memory keep what they need of it.
    """
    order = system.anchors.order
    for index in range(first_index(order, state, lo), last_index(order, state, hi)):
        row = max(order[index], 0)  # never negative: saves numba's checks of every index
        if state.held[row] == 0:
            continue
        i = max(state.anchor_node[row], 0)
        anchor_target(system, state, row, t, dt, point, speed)
        done, member = 0.0, system.joints.member
        first, last = tied_to(system, state, row)
        for k in range(3):
            before = state.v[k, i]
            push = state.mass[i] * (speed[k] - before) / dt - force_on_node(
                system, state, forces, i, k
            )
            for p in range(first, last):  # the others that are tied to it
                if member[p] != i:
                    push += state.mass[member[p]] * (speed[k] - before) / dt
                    push -= force_on_node(system, state, forces, member[p], k)
            mean = 0.5 * (before + speed[k])
            done += dt * push * mean
            middle[k, i] = mean
            state.reaction[row, k] = push
            state.anchor_x[row, k] = point[k]
            state.anchor_v[row, k] = speed[k]
            state.x[k, i] = point[k]
            state.v[k, i] = speed[k]
        follow(member, first, last, i, middle)
        follow(member, first, last, i, state.x)
        follow(member, first, last, i, state.v)
        state.work.anchors[row] += done
        state.most[row] = max(state.most[row], abs(state.work.anchors[row]))
    write_joint_forces(system, state, forces, middle, dt)
    close_clamps(system, state, t, dt)
    remember_step(system, state, t)
    swept = state.memory.contact.swept
    if system.rare is not None and swept.shape[1] == HELD_WIDTH:
        sweep_held(state.x, state.v, swept)


@part
def release_anchors(system, state, t, little, lo=0, hi=ALL):
    """Let go of the anchors whose release time is reached, to `little` [s], at the start of a step.

    Return whether the forces at hand are then no longer those of the state: those of a clamp among them, of
    rigid links, and of a limiter, which pull at once otherwise where an end is free.
    """
    others = False
    if system.anchors.first_release > t + little:
        return others
    order = system.anchors.order
    for index in range(first_index(order, state, lo), last_index(order, state, hi)):
        row = order[index]
        if state.held[row] == 1 and system.anchors.release[row] <= t + little:
            i = state.anchor_node[row]
            if has_clamps(system, state) and system.bending.clamped[row] == 1:
                others = True
                let_bend(system, state, row)
            others = others or limits(system) or any_rigid(state.stiffness)
            state.held[row] = 0
            state.inverse_mass[i] = 1.0 / state.mass[i]
            for k in range(3):
                state.reaction[row, k] = 0.0
                state.acceleration[k, i] = (
                    force_on_node(system, state, state.forces, i, k) / state.mass[i]
                )
            first, last = tied_to(system, state, row)
            for p in range(first, last):
                other = system.joints.member[p]
                state.inverse_mass[other] = 1.0 / state.mass[other]
                for k in range(3):
                    force = force_on_node(system, state, state.forces, other, k)
                    state.acceleration[k, other] = force / state.mass[other]
            if last > first:
                tie(system, state, state.acceleration)
    return others


@kernel
def any_rigid(stiffness):
    """Tell whether any segment is a rigid link."""
    for j in range(stiffness.shape[0]):
        if stiffness[j] == math.inf:
            return True
    return False
