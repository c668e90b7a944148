"""What joints do to their nodes: R = m a - F, the force of a joint on each of the nodes that it ties.

Mean over a step, as an anchor's reaction is. Over a joint they add up to nothing, or to the force of the
anchor that holds it.
"""

from __future__ import annotations

from ropewalk.core.jit import part
from ropewalk.laws.rare import are_tied
from ropewalk.laws.table import force_on_node


@part
def write_joint_forces(system, state, forces, middle, dt):
    """Write the mean force of every joint on its nodes in a step of `dt` [s], (p, 3) [N].

    `forces` are means over the step, `middle` the mean velocities; the state is that at its end.
    """
    if not are_tied(system):
        return
    member = system.joints.member
    for j in range(state.tied.shape[0]):
        first, last = system.joints.first[j], system.joints.first[j + 1]
        held = state.inverse_mass[member[first]] == 0.0
        for k in range(3):
            i = member[first]
            total, push = 0.0, 0.0
            for p in range(first, last):
                total += state.mass[member[p]]
                push += force_on_node(system, state, forces, member[p], k)
            a = 2.0 * (state.v[k, i] - middle[k, i]) / dt if held else push / total
            for p in range(first, last):
                force = force_on_node(system, state, forces, member[p], k)
                state.joint_force[p, k] = state.tied[j] * (state.mass[member[p]] * a - force)


@part
def note_joint_forces(system, state):
    """Write those of this instant, from the forces and accelerations of the state."""
    if not are_tied(system):
        return
    member = system.joints.member
    for j in range(state.tied.shape[0]):
        for p in range(system.joints.first[j], system.joints.first[j + 1]):
            i = member[p]
            for k in range(3):
                force = force_on_node(system, state, state.forces, i, k)
                push = state.mass[i] * state.acceleration[k, i] - force
                state.joint_force[p, k] = state.tied[j] * push
