"""The stretch limiter where joints tie ropes: impulses that are solved for together, nodes that move as one.

With G the rates of length of the segments at a bound, M the masses, those of a joint's nodes as one, the
impulses p of `limiter` are
    G M^-1 G^T p = G v,
a sparse positive semidefinite system without a band: solved by conjugate gradients, for which its product
with a vector is enough.
Source: Hestenes & Stiefel 1952, J. Res. Natl. Bur. Stand. 49:409.
"""

from __future__ import annotations

from ropewalk.core.jit import deferred, kernel, small
from ropewalk.laws.drawn_bounds import begin_rates
from ropewalk.laws.joints import follow, share_motion

# Rows of `work` besides those of `limiter`: residual, search direction, its product; motion of the nodes.
LEFT, SEARCH, IMPULSE, BOUND, PRODUCT, MOTION = 3, 4, 5, 6, 7, 8
CLOSE = 1e-24  # [1] of the squares of the rates: what is left of them
MORE = 20  # iterations beyond as many as there are segments at bounds


@deferred()
def solve_tied(system, state, work):
    """Write the impulses [N s] that stop the segments at a bound, row 5 of `work`; the others get none."""
    joints, v, count, left = system.joints, state.v, 0, 0.0
    begin_rates(system, state, work[BOUND], work[LEFT])
    for j in range(state.rest_length.shape[0]):
        work[IMPULSE, j], rate = 0.0, work[LEFT, j]
        if work[BOUND, j] != 0.0:
            count += 1
            for k in range(3):
                rate += (v[k, j + 1] - v[k, j]) * work[k, j]
        work[LEFT, j], work[SEARCH, j] = rate, rate
        left += rate * rate
    enough = CLOSE * left
    for _ in range(count + MORE):
        if left <= enough:
            break
        curved = _multiply(joints, state, work)
        if not curved > 0.0:
            break  # taut between anchors: one impulse follows from the others
        step, before = left / curved, left
        left = 0.0
        for j in range(state.rest_length.shape[0]):
            work[IMPULSE, j] += step * work[SEARCH, j]
            work[LEFT, j] -= step * work[PRODUCT, j]
            left += work[LEFT, j] * work[LEFT, j]
        for j in range(state.rest_length.shape[0]):
            work[SEARCH, j] = work[LEFT, j] + left / before * work[SEARCH, j]


@kernel
def _multiply(joints, state, work):
    """Write the change of the rates by impulses along the search; return its product with the search."""
    move_tied(joints, state, work, SEARCH)
    total = 0.0
    for j in range(state.rest_length.shape[0]):
        rate = 0.0
        if work[BOUND, j] != 0.0:
            for k in range(3):
                rate -= (work[MOTION + k, j + 1] - work[MOTION + k, j]) * work[k, j]
        work[PRODUCT, j] = rate
        total += rate * work[SEARCH, j]
    return total


@deferred()
def move_tied(joints, state, work, row):
    """Write the changes of velocity by the impulses in a row of `work`, (3, n) from its row MOTION on."""
    inverse_mass, segments = state.inverse_mass, state.rest_length.shape[0]
    motion = work[MOTION:]
    for k in range(3):
        for i in range(segments + 1):
            impulse = work[row, i] * work[k, i] if i < segments else 0.0
            if i > 0:
                impulse -= work[row, i - 1] * work[k, i - 1]
            motion[k, i] = impulse * inverse_mass[i]
    share_motion(joints, state.tied, state.mass, inverse_mass, motion)


@deferred()
def add_joint_forces(joints, state, work, dt):
    """Add what joints do to their nodes, for these go on as one, to their mean forces, (p, 3) [N].

    After `move_tied`, for the impulses.
    """
    for j in range(state.tied.shape[0]):
        if state.tied[j] == 0:
            continue
        for p in range(joints.first[j], joints.first[j + 1]):
            i = joints.member[p]
            for k in range(3):
                push = state.mass[i] * work[MOTION + k, i]
                if i < state.rest_length.shape[0]:
                    push -= work[IMPULSE, i] * work[k, i]
                if i > 0:
                    push += work[IMPULSE, i - 1] * work[k, i - 1]
                state.joint_force[p, k] += push / dt


@small
def inertness(joints, state, joint, i):
    """Return one over the mass that moves with node `i`, of a joint or of none (-1) [1/kg]."""
    if joint < 0 or state.tied[joint] == 0 or state.inverse_mass[i] == 0.0:
        return state.inverse_mass[i]
    total = 0.0
    for p in range(joints.first[joint], joints.first[joint + 1]):
        total += state.mass[joints.member[p]]
    return 1.0 / total


@small
def carry(joints, tied, joint, i, x):
    """Bring all nodes of a joint to where node `i` of it is, (3, n)."""
    if joint >= 0 and tied[joint] == 1:
        follow(joints.member, joints.first[joint], joints.first[joint + 1], i, x)
