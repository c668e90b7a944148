"""Stretch limiter after Habrador's rope, with the velocities corrected too.

After a step, segment by segment from the anchors outward, the outer node is moved so that the stretch r/L
stays between two bounds. In the original only positions move, so that a rope at rest keeps large velocities.
Here every segment at a bound also loses the part of its velocity that would drive it on: impulses along the
segments, all solved for together,
    (w_j + w_i) p_j - w_i (t_j . t_i) p_i - w_j (t_j . t_h) p_h = (v_i - v_j) . t_j,   i = j + 1, h = j - 1
with w = 1 / m, t the unit vectors: a projection in the metric of the masses, which conserves momentum and
never adds kinetic energy (Moreau 1988, inelastic impact). What a held
node would take of it is a reaction of its anchor. Where a drum winds, bounds move (`drawn_bounds`).
"""

from __future__ import annotations

import math

from ropewalk.core.jit import deferred, kernel, part
from ropewalk.core.status import TAKEN
from ropewalk.laws.clamps import bent_energy
from ropewalk.laws.drawn_bounds import begin_rates, give_to_drums
from ropewalk.laws.elastic import stored_energy
from ropewalk.laws.fresh import working_segment
from ropewalk.laws.joints import tied_to
from ropewalk.laws.ledger import gravity_energy, kinetic_energy
from ropewalk.laws.rare import are_tied, has_bending, winds
from ropewalk.laws.tied_limiter import (
    IMPULSE,
    MOTION,
    add_joint_forces,
    carry,
    inertness,
    move_tied,
    solve_tied,
)

AT_BOUND = 1e-9  # [1] a stretch this close to its bound counts as at it
ATTEMPTS = 8  # solves for the impulses at most; each but the last lets go of what would be pulled
SINGULAR = 1e-10  # [1] a pivot this small, over its diagonal, is none
BOTH = 2.0  # marks a segment of one length only


@deferred()
def limit_stretch(system, state, work, dt, ledger):
    """Bring every segment's stretch within bounds, stop it there, and book what that costs.

    `work` is (11, n): unit vectors, diagonal, upper diagonal, right side of the segments' equations, bound,
    and what `tied_limiter` needs.
    """
    if not reaches_bound(system.limiter, state):
        clear_pulls(state.limited)
        return
    kinetic, potential = kinetic_energy(state.v, state.mass), _potential(system, state)
    for _ in range(system.limiter.passes):
        sweep(system, state)
    stop_segments(system, state, work)
    note_pulls(work, dt, state.limited)
    if are_tied(system):
        add_joint_forces(system.joints, state, work, dt)
    kinetic = (
        kinetic_energy(state.v, state.mass) - kinetic - give_to_anchors(system, state, work, dt)
    )
    if winds(system, state):
        kinetic -= give_to_drums(system, state, work[6], work[5])
    potential = _potential(system, state) - potential
    state.balance[TAKEN] -= kinetic + potential
    if ledger:
        state.work.limiter[0] += kinetic
        state.work.limiter[1] += potential


@kernel
def reaches_bound(limiter, state):
    """Tell whether any segment is at a bound of its stretch or beyond."""
    x, lengths = state.x, state.rest_length
    for j in range(lengths.shape[0]):
        dx, dy, dz = x[0, j + 1] - x[0, j], x[1, j + 1] - x[1, j], x[2, j + 1] - x[2, j]
        r = math.sqrt(dx * dx + dy * dy + dz * dz)
        long = r >= limiter.longest * lengths[j] * (1.0 - AT_BOUND)
        if long or r <= limiter.shortest * lengths[j] * (1.0 + AT_BOUND):
            return True
    return False


@kernel
def clear_pulls(limited):
    """Write that no bound acts, (s,)."""
    for j in range(limited.shape[0]):
        limited[j] = 0.0


@kernel
def _potential(system, state):
    bending = bent_energy(system, state, state.x) if has_bending(system) else 0.0
    return (
        gravity_energy(state.x, state.mass, system.gravity)
        + stored_energy(system, state, state.x, state.inner)
        + bending
    )


@kernel
def sweep(system, state):
    """Correct the length of every segment once, in the order of the table; what is tied moves along."""
    limiter, joints = system.limiter, system.joints
    x = state.x
    for row in range(limiter.order.shape[0]):
        j = limiter.order[row]
        first, second = state.inverse_mass[j], state.inverse_mass[j + 1]
        if are_tied(system):
            first = inertness(joints, state, limiter.joint[0, row], j)
            second = inertness(joints, state, limiter.joint[1, row], j + 1)
        both = first + second
        if both == 0.0:
            continue
        share, anchor = limiter.share[row], limiter.anchor[row]
        free = anchor < 0 or state.held[anchor] == 0  # what it was near to has let go
        if free or share == 0.5 or both in (first, second):
            share = first / both
        dx = x[0, j + 1] - x[0, j]
        dy = x[1, j + 1] - x[1, j]
        dz = x[2, j + 1] - x[2, j]
        r = math.sqrt(dx * dx + dy * dy + dz * dz)
        length = state.rest_length[j]
        if r == 0.0 or state.stiffness[j] == 0.0:  # it has parted
            continue
        wanted = min(max(r, limiter.shortest * length), limiter.longest * length)
        if wanted == r:
            continue
        low = share * (r - wanted) / r
        high = (1.0 - share) * (r - wanted) / r
        x[0, j] += low * dx
        x[1, j] += low * dy
        x[2, j] += low * dz
        x[0, j + 1] -= high * dx
        x[1, j + 1] -= high * dy
        x[2, j + 1] -= high * dz
        if are_tied(system):
            carry(joints, state.tied, limiter.joint[0, row], j, x)
            carry(joints, state.tied, limiter.joint[1, row], j + 1, x)


@kernel
def stop_segments(system, state, work):
    """Find the impulses of the segments at a bound and apply them to the free nodes.

    A bound only pushes back: a segment whose impulse would pull it to the bound is let go, and the rest
    solved for again. Leaves the impulses [N s] in row 5 of `work`, their directions in rows 0 to 2.
    """
    segments = state.rest_length.shape[0]
    for j in range(segments):
        _find_bound(system.limiter, state, work, j)
    for _ in range(ATTEMPTS):
        _solve_for_impulses(system, state, work)
        pulling = 0
        for j in range(segments):
            if work[6, j] * work[5, j] < 0.0 and work[6, j] != BOTH:
                work[6, j] = 0.0
                pulling += 1
        if pulling == 0:
            break
    if pulling > 0:
        _solve_for_impulses(system, state, work)
    if are_tied(system):
        move_tied(system.joints, state, work, IMPULSE)
        for k in range(3):
            for i in range(segments + 1):
                state.v[k, i] += work[MOTION + k, i]
        return
    for j in range(segments):
        for k in range(3):
            state.v[k, j] += state.inverse_mass[j] * work[5, j] * work[k, j]
            state.v[k, j + 1] -= state.inverse_mass[j + 1] * work[5, j] * work[k, j]


@part
def _solve_for_impulses(system, state, work):
    """Write the impulses of the segments at a bound."""
    if are_tied(system):
        solve_tied(system, state, work)
    else:
        _solve(system, state, work)


@kernel
def _find_bound(limiter, state, work, j):
    """Write a segment's direction, and at which bound it is: 1 longest, -1 shortest, 0 none."""
    x = state.x
    work[6, j] = 0.0
    dx, dy, dz = x[0, j + 1] - x[0, j], x[1, j + 1] - x[1, j], x[2, j + 1] - x[2, j]
    r = math.sqrt(dx * dx + dy * dy + dz * dz)
    length = state.rest_length[j]
    both = state.inverse_mass[j] + state.inverse_mass[j + 1]
    work[0, j], work[1, j], work[2, j] = 0.0, 0.0, 0.0
    if r == 0.0 or length == 0.0 or both == 0.0:
        return
    work[0, j], work[1, j], work[2, j] = dx / r, dy / r, dz / r
    long = r >= limiter.longest * length * (1.0 - AT_BOUND)
    short = r <= limiter.shortest * length * (1.0 + AT_BOUND)
    if long and short:
        work[6, j] = BOTH
    elif long:
        work[6, j] = 1.0
    elif short:
        work[6, j] = -1.0


@kernel
def _solve(system, state, work):
    """Solve the equations of the segments at a bound (Thomas); the others get no impulse."""
    segments = state.rest_length.shape[0]
    v, weights = state.v, state.inverse_mass
    begin_rates(system, state, work[6], work[5])
    for j in range(segments):
        work[3, j], work[4, j] = 1.0, 0.0
        if work[6, j] != 0.0:
            work[3, j] = weights[j] + weights[j + 1]
            for k in range(3):
                work[5, j] += (v[k, j + 1] - v[k, j]) * work[k, j]
        if j > 0 and work[6, j] != 0.0 and work[6, j - 1] != 0.0:
            for k in range(3):
                work[4, j - 1] -= weights[j] * work[k, j] * work[k, j - 1]
    for j in range(1, segments):
        factor = work[4, j - 1] / work[3, j - 1]
        work[3, j] -= factor * work[4, j - 1]
        work[5, j] -= factor * work[5, j - 1]
        if work[6, j] != 0.0 and work[3, j] < SINGULAR * (weights[j] + weights[j + 1]):
            # taut between two anchors: one impulse follows from the others
            work[3, j], work[4, j], work[5, j] = 1.0, 0.0, 0.0
    work[5, segments - 1] /= work[3, segments - 1]
    for back in range(segments - 1):
        j = segments - 2 - back
        work[5, j] = (work[5, j] - work[4, j] * work[5, j + 1]) / work[3, j]


@kernel
def note_pulls(work, dt, limited):
    """Write the impulses as mean tensions of the step [N], (s,)."""
    for j in range(limited.shape[0]):
        limited[j] = work[5, j] / dt


@kernel
def note_bounds(system, state, limiter, tension, changed):
    """Write what the bounds of a step that was solved held, beyond what they hold now [N], (s,).

    `limiter` (3, n + 1) and `tension` (s,) [N] are those of the step's end. Where nodes of winches have
    `changed` since, the segments at their drums are not the same ones.
    """
    for j in range(tension.shape[0]):
        same = limiter[0, j + 1] != 0.0 or limiter[1, j + 1] != 0.0 or limiter[2, j + 1] != 0.0
        if changed:
            for row in range(state.winch_exit.shape[0]):
                beside = abs(j - working_segment(system.winches, state.winch_exit, row)) <= 1
                same = same and not beside
        state.limited[j] = tension[j] - state.tension[j] if same else 0.0


@kernel
def give_to_anchors(system, state, work, dt):
    """Add what the held nodes would have taken to their anchors' reactions; return its work [J]."""
    total = 0.0
    segments = state.rest_length.shape[0]
    for row in range(state.held.shape[0]):
        if state.held[row] == 0:
            continue
        node, done = state.anchor_node[row], 0.0
        first, last = tied_to(system, state, row)
        for p in range(max(last - first, 1)):
            i = system.joints.member[first + p] if last > first else node
            for k in range(3):
                impulse = 0.0
                if i < segments:
                    impulse -= work[5, i] * work[k, i]
                if i > 0:
                    impulse += work[5, i - 1] * work[k, i - 1]
                state.reaction[row, k] += impulse / dt
                done += impulse * state.v[k, i]
        total += done
        state.work.anchors[row] += done
        state.most[row] = max(state.most[row], abs(state.work.anchors[row]))
    return total
