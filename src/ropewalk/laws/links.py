"""Rigid links (stiffness inf) at one instant: the tensions that keep them from changing their length.

A segment at a bound of its stretch (see `bounds`) is one as well, as long as it presses on the bound.

A constant length r demands of the ends' accelerations a and their relative velocity u
    t . (a_(j+1) - a_j) = -|u_across|^2 / r,
which makes the tensions T of neighbouring links the solution of, with w = 1 / m, i = j - 1 and k = j + 1,
    (w_j + w_k) T_j - w_j (t_j . t_i) T_i - w_k (t_j . t_k) T_k = t . (a'_k - a'_j) + |u_across|^2 / r,
a' the accelerations from all other forces. A tension-only link that is slack, or that would have to
push, carries nothing.

What a step needs to begin with, and a recording for its first frame; in a step links are part of the
stage's own equations (`methods.stage`).
Source: Hairer & Wanner, Solving Ordinary Differential Equations II, VII.1 (index reduction).
"""

from __future__ import annotations

import math

import numpy as np

from ropewalk.core.band import clear_band
from ropewalk.core.jit import deferred, kernel, part
from ropewalk.core.network import SOFTEST, solve_network
from ropewalk.core.ordering import begin_groups, order_groups
from ropewalk.laws.anchors import anchor_target
from ropewalk.laws.bounds import SLACK
from ropewalk.laws.elastic import tensions
from ropewalk.laws.joint_forces import note_joint_forces
from ropewalk.laws.joints import follow, tied_to
from ropewalk.laws.rare import are_tied, limits
from ropewalk.laws.table import accelerate, force_on_node

INSTANT = 1e-6  # [s] over which an anchor's acceleration is taken
LINK, LONGEST, SHORTEST, BETWEEN = (
    1.0,
    2.0,
    3.0,
    4.0,
)  # what is held to its length; BETWEEN equal bounds
ROUNDS = 4  # of multipliers, see `core.network`
ATTEMPTS = 8  # solves at most; each but the last lets go of what would push


@part
def hold_links(system, state, t, saddle):
    """Write tensions and forces of all rigid links at time `t` [s], and the accelerations with them.

    All other forces are in `state.forces` already; `saddle` lends its arrays. Returns the number of links.
    """
    links = mark_links(state.x, state.rest_length, state.stiffness, system.slack_floor, saddle)
    if limits(system):
        links += mark_bounds(state.rest_length, state.stiffness, system.limiter, saddle)
    if links == 0:
        return links
    if limits(system):
        tensions(system, state, state.tension)
        clear_bounds(state.forces.limiter)
    clear_links(state.stiffness, state.tension, state.forces.elastic)
    accelerate(system, state, state.forces, state.acceleration)
    sway_anchors(system, state, t, saddle.factor[0], saddle.factor[1])
    for _ in range(ATTEMPTS):
        gather_links(state.v, state.acceleration, 1.0, state.inverse_mass, saddle)
        if are_tied(system):
            solve_tied_links(state.mass, state.inverse_mass, saddle)
        else:
            solve_links(saddle.across, saddle.along, saddle.misfit)
        if drop_pushing(saddle.misfit, system.slack_floor, saddle.carries) == 0:
            break
    found, carries, direction = saddle.misfit, saddle.carries, saddle.direction
    pull_links(found, carries, direction, state.tension, state.forces.elastic)
    if limits(system):
        pull_bounds(found, carries, direction, state.tension, state.forces.limiter)
    accelerate(system, state, state.forces, state.acceleration)
    return links


@deferred()
def still_links(system, state, saddle, dt, ledger):
    """Take out of the velocities what changes the lengths of rigid links, a plastic impact, as a step ends.

    A step of implicit Euler leaves a link that turns a rate of w^2 L h / 2: the next step of another method
    would take it for a motion. The impulses count to the step of `dt` [s]; what they take is friction of
    strings, and of rods an error. Ropes that are tied keep their rates.
    """
    if mark_links(state.x, state.rest_length, state.stiffness, system.slack_floor, saddle) == 0:
        return
    v, w, t, p, rates = state.v, state.inverse_mass, saddle.direction, saddle.misfit, saddle.along
    for _ in range(ATTEMPTS):
        gather_links(v, v, 0.0, w, saddle)
        solve_links(saddle.across, saddle.along, p)
        if drop_pushing(p, system.slack_floor, saddle.carries) == 0:
            break
    for j in range(p.shape[0]):
        rates[j] = 0.0
        if saddle.carries[j] != LINK or p[j] - p[j] != 0.0:
            p[j] = 0.0
        for k in range(3):
            rates[j] += t[k, j] * (v[k, j + 1] - v[k, j])
    for row in range(state.held.shape[0]):
        if state.held[row] == 1:
            give_impulses(state, row, t, p, dt)
    for j in range(p.shape[0]):
        for k in range(3):
            v[k, j] += w[j] * p[j] * t[k, j]
            v[k, j + 1] -= w[j + 1] * p[j] * t[k, j]
        if ledger:
            work = state.work.friction if system.slack_floor[j] == 0.0 else state.work.elastic
            work[j] -= 0.5 * p[j] * rates[j]


@kernel
def give_impulses(state, row, t, p, dt):
    """Give the anchor of `row` what impulses `p` (s,) [N s] of links along `t` (3, s) do to its node."""
    i, done = state.anchor_node[row], 0.0
    for k in range(3):
        push = 0.0
        if i < p.shape[0]:
            push -= p[i] * t[k, i]
        if i > 0:
            push += p[i - 1] * t[k, i - 1]
        state.reaction[row, k] += push / dt
        done += push * state.v[k, i]
    state.work.anchors[row] += done
    state.most[row] = max(state.most[row], abs(state.work.anchors[row]))


@part
def sway_anchors(system, state, t, point, speed):
    """Write the accelerations of the held nodes at time `t` [s], from their anchors' motions.

    Of the differences on both sides the smaller: a motion may begin or end at `t`.
    """
    for row in range(state.held.shape[0]):
        if state.held[row] == 0:
            continue
        i = state.anchor_node[row]
        anchor_target(system, state, row, t, 0.0, point, speed)
        now0, now1, now2 = speed[0], speed[1], speed[2]
        least = np.inf
        for side in (-INSTANT, INSTANT):
            anchor_target(system, state, row, t + side, 0.0, point, speed)
            a0, a1, a2 = speed[0] - now0, speed[1] - now1, speed[2] - now2
            size = abs(a0) + abs(a1) + abs(a2)
            if size < least:
                least = size
                for k in range(3):
                    state.acceleration[k, i] = (speed[k] - (now0, now1, now2)[k]) / side
        first, last = tied_to(system, state, row)
        follow(system.joints.member, first, last, i, state.acceleration)


@part
def note_reactions(system, state, t, saddle):
    """Write the anchors' forces at time `t` [s], no mean of a step."""
    sway_anchors(system, state, t, saddle.factor[0], saddle.factor[1])
    note_joint_forces(system, state)
    for row in range(state.held.shape[0]):
        if state.held[row] == 0:
            continue
        i, member = state.anchor_node[row], system.joints.member
        first, last = tied_to(system, state, row)
        for k in range(3):
            force = force_on_node(system, state, state.forces, i, k)
            state.reaction[row, k] = state.mass[i] * state.acceleration[k, i] - force
            for p in range(first, last):
                if member[p] != i:
                    force = force_on_node(system, state, state.forces, member[p], k)
                    push = state.mass[member[p]] * state.acceleration[k, i] - force
                    state.reaction[row, k] += push
            state.acceleration[k, i] = 0.0
        follow(member, first, last, i, state.acceleration)


@deferred("int64")
def mark_links(x, rest_length, stiffness, floor, saddle):
    """Write directions (3, s), 1 / r and what carries (s,); return the number of rigid links."""
    direction, over, carries, count = saddle.direction, saddle.compliance, saddle.carries, 0
    for j in range(stiffness.shape[0]):
        dx, dy, dz = x[0, j + 1] - x[0, j], x[1, j + 1] - x[1, j], x[2, j + 1] - x[2, j]
        r = math.sqrt(dx * dx + dy * dy + dz * dz)
        over[j] = 1.0 / r if r > 0.0 else 0.0
        direction[0, j], direction[1, j], direction[2, j] = over[j] * dx, over[j] * dy, over[j] * dz
        rigid = stiffness[j] == np.inf
        count += 1 if rigid else 0
        slack = floor[j] == 0.0 and r < (1.0 - SLACK) * rest_length[j]
        carries[j] = LINK if rigid and not slack else 0.0
    return count


@deferred("int64")
def mark_bounds(rest_length, stiffness, limiter, saddle):
    """Mark the segments that are at a bound; return how many. Those that leave it are beyond it at once.

    Rigid links have none.
    """
    over, carries, count = saddle.compliance, saddle.carries, 0
    for j in range(rest_length.shape[0]):
        if over[j] == 0.0 or rest_length[j] == 0.0 or stiffness[j] == np.inf:
            continue
        stretch = 1.0 / (over[j] * rest_length[j])
        long = stretch >= limiter.longest * (1.0 - SLACK)
        short = stretch <= limiter.shortest * (1.0 + SLACK)
        if long and short:
            carries[j] = BETWEEN
        elif long:
            carries[j] = LONGEST
        elif short:
            carries[j] = SHORTEST
        count += 1 if carries[j] != 0.0 else 0
    return count


@deferred()
def clear_links(stiffness, tension, elastic):
    """Set tension and force of all rigid links to zero."""
    for j in range(stiffness.shape[0]):
        if stiffness[j] == np.inf:
            tension[j] = 0.0
            elastic[0, j + 1], elastic[1, j + 1], elastic[2, j + 1] = 0.0, 0.0, 0.0


@deferred()
def gather_links(v, a, swing, inverse_mass, saddle):
    """Write diagonal, off-diagonal and right side (s,) of the equations of the links that carry.

    With a `swing` of 1 they are those of accelerations `a`; of 0, and velocities in their place, of impulses.
    """
    t, over, carries = saddle.direction, saddle.compliance, saddle.carries
    diagonal, upper, right = saddle.across, saddle.along, saddle.misfit
    for j in range(carries.shape[0]):
        diagonal[j], upper[j], right[j] = 1.0, 0.0, 0.0
        both = inverse_mass[j] + inverse_mass[j + 1]
        if carries[j] == 0.0 or both == 0.0:
            continue
        diagonal[j] = both
        along, square = 0.0, 0.0
        for k in range(3):
            u = v[k, j + 1] - v[k, j]
            along += u * t[k, j]
            square += u * u
            right[j] += (a[k, j + 1] - a[k, j]) * t[k, j]
        right[j] += swing * (square - along * along) * over[j]
        if j + 1 < carries.shape[0] and carries[j + 1] != 0.0:
            turn = t[0, j] * t[0, j + 1] + t[1, j] * t[1, j + 1] + t[2, j] * t[2, j + 1]
            upper[j] = -inverse_mass[j + 1] * turn


@deferred()
def solve_links(diagonal, upper, right):
    """Solve the symmetric tridiagonal equations in place (Thomas); the solution is in `right`."""
    last = right.shape[0] - 1
    for j in range(last):
        factor = upper[j] / diagonal[j]
        diagonal[j + 1] -= factor * upper[j]
        right[j + 1] -= factor * right[j]
    right[last] /= diagonal[last]
    for back in range(last):
        j = last - 1 - back
        right[j] = (right[j] - upper[j] * right[j + 1]) / diagonal[j]


@deferred()
def solve_tied_links(mass, inverse_mass, saddle):
    """Solve those of ropes that are tied, from the right sides in `misfit`; the solution is there, too.

    As equations of a network that nodes move by accelerations, in a few rounds: it softens links, and what
    is left of the equations is solved for again.
    """
    network_of_links(mass, inverse_mass, saddle)
    network = saddle.network
    if network.room.point.shape[0] > 0:  # the order of what touched last is in no snapshot
        begin_groups(network)
        order_groups(network)
    misfit, keep, t = saddle.misfit, saddle.factor, saddle.direction
    for _ in range(ROUNDS):
        solve_network(saddle)
        for i in range(mass.shape[0]):
            for k in range(3):
                keep[i, 8 + k] += saddle.moved[k, i]
                saddle.force[k, i] = -mass[i] * keep[i, 8 + k]
        for j in range(misfit.shape[0]):
            keep[j, 11] += saddle.pulled[j]
            misfit[j] = keep[j, 12]
            for k in range(3):
                pull = keep[j, 11] * t[k, j]
                saddle.force[k, j] += pull
                saddle.force[k, j + 1] -= pull
                misfit[j] += saddle.carries[j] * t[k, j] * (keep[j + 1, 8 + k] - keep[j, 8 + k])
    for j in range(misfit.shape[0]):
        saddle.compliance[j], misfit[j] = keep[j, 13], keep[j, 11]
        saddle.carries[j] = keep[j, 14]


@kernel
def network_of_links(mass, inverse_mass, saddle):
    """Begin to solve: inertia alone, and what is put by: accelerations, tensions, right side, 1 / r, marks.

    Marks are factors in a network's equations, of links and of bounds alike.
    """
    misfit, keep = saddle.misfit, saddle.factor
    clear_band(saddle.band)
    for i in range(mass.shape[0]):
        saddle.inertia[i], saddle.free[i] = mass[i], 1.0 if inverse_mass[i] > 0.0 else 0.0
        keep[i, 11] = 0.0
        for k in range(3):
            saddle.force[k, i], keep[i, 8 + k] = 0.0, 0.0
    for j in range(misfit.shape[0]):
        saddle.across[j], saddle.along[j] = 0.0, 0.0
        if saddle.carries[j] == 0.0 or saddle.free[j] + saddle.free[j + 1] == 0.0:
            misfit[j] = 0.0
        keep[j, 12], keep[j, 13], keep[j, 14] = misfit[j], saddle.compliance[j], saddle.carries[j]
        saddle.carries[j] = 1.0 if saddle.carries[j] != 0.0 else 0.0
        saddle.compliance[j] = SOFTEST / min(mass[j], mass[j + 1])


@deferred("int64")
def drop_pushing(tension, floor, carries):
    """Let go of tension-only links that would push, and of bounds that would pull; return how many."""
    dropped = 0
    for j in range(tension.shape[0]):
        one_way = carries[j] == LONGEST or (carries[j] == LINK and floor[j] == 0.0)
        if (one_way and tension[j] < 0.0) or (carries[j] == SHORTEST and tension[j] > 0.0):
            carries[j] = 0.0
            dropped += 1
    return dropped


@deferred()
def clear_bounds(limiter):
    """Set the forces of all bounds to zero, (3, n + 1)."""
    for k in range(3):
        for j in range(limiter.shape[1]):
            limiter[k, j] = 0.0


@deferred()
def pull_bounds(found, carries, direction, tension, limiter):
    """Put what the bounds hold into the limiter's channel (3, n + 1) [N], and add it to the tensions."""
    for j in range(found.shape[0]):
        at_bound = carries[j] > LINK and found[j] - found[j] == 0.0
        extra = found[j] if at_bound else 0.0
        tension[j] += extra
        for k in range(3):
            limiter[k, j + 1] = extra * direction[k, j]


@deferred()
def pull_links(found, carries, direction, tension, elastic):
    """Put the tensions of the links that carry into the state and its forces."""
    for j in range(found.shape[0]):
        if carries[j] == LINK and found[j] - found[j] == 0.0:
            tension[j] = found[j]
            for k in range(3):
                elastic[k, j + 1] = found[j] * direction[k, j]
