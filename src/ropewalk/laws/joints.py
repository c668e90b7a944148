"""Joints: nodes that are tied at one point share place, velocity and acceleration.

A joint has no mass of its own: its nodes move as one of their masses' sum under the sum of their forces,
    a = sum(m_i a_i) / sum(m_i) ,
and what it does to node i is R_i = m_i a - F_i, which adds up to nothing over the joint, or to the force of
the anchor that holds one of its nodes. As all nodes of a joint then go through the same arithmetic, they
stay at one place to the last bit, and the joint does no work.
"""

from __future__ import annotations

from ropewalk.core.jit import deferred, kernel, part
from ropewalk.laws.rare import are_tied


@part
def tied_to(system, state, row):
    """Return where in `joints.member` those begin and end that anchor `row` holds; 0, 0: one node alone."""
    if not are_tied(system) or system.joints.of_anchor[row] < 0:
        return 0, 0
    j = system.joints.of_anchor[row]
    if state.tied[j] == 0:
        return 0, 0
    return system.joints.first[j], system.joints.first[j + 1]


@part
def is_tied(system, state, node):
    """Tell whether a joint ties a node to others now."""
    found = False
    if are_tied(system):
        joints = system.joints
        for j in range(state.tied.shape[0]):
            for p in range(joints.first[j], joints.first[j + 1]):
                found = found or (state.tied[j] == 1 and joints.member[p] == node)
    return found


@part
def tie(system, state, a):
    """Give the nodes of every joint one acceleration, (3, n); held ones have none already."""
    if are_tied(system):
        share_motion(system.joints, state.tied, state.mass, state.inverse_mass, a)


@deferred()
def share_motion(joints, tied, mass, inverse_mass, a):
    """Write the mean acceleration of every joint, by mass, to its free nodes, (3, n)."""
    member = joints.member
    for j in range(tied.shape[0]):
        first, last = joints.first[j], joints.first[j + 1]
        if tied[j] == 0 or inverse_mass[member[first]] == 0.0:
            continue
        total, p0, p1, p2 = 0.0, 0.0, 0.0, 0.0
        for p in range(first, last):
            i = member[p]
            total += mass[i]
            p0, p1, p2 = p0 + mass[i] * a[0, i], p1 + mass[i] * a[1, i], p2 + mass[i] * a[2, i]
        p0, p1, p2 = p0 / total, p1 / total, p2 / total
        for p in range(first, last):
            i = member[p]
            a[0, i], a[1, i], a[2, i] = p0, p1, p2


@kernel
def follow(member, first, last, i, values):
    """Give the nodes of a joint what its node `i` has, (3, n)."""
    for p in range(first, last):
        for k in range(3):
            values[k, member[p]] = values[k, i]
