"""All laws together: the one place that knows which laws there are.

A new law is a file of its own in this folder, a channel in `core.arrays.Forces` and `Work`, a line in
`evaluate` and `accelerate` and one in `ledger.account`.
"""

from __future__ import annotations

from ropewalk.core.arrays import APPLIED, AXIAL, TENSION_ONLY
from ropewalk.core.jit import kernel, part
from ropewalk.laws.air_drag import linear_drag, quadratic_line_drag, quadratic_node_drag
from ropewalk.laws.ground import ground_forces
from ropewalk.laws.stretch import (
    axial_friction,
    drop_slack_friction,
    elastic_forces,
    growth_friction,
    vector_friction,
)


@part
def evaluate(system, state, x, v, forces):
    """Write the forces of all laws at positions `x` and velocities `v`, both (3, n), by channel [N]."""
    floor = system.slack_floor
    elastic_forces(x, state.rest_length, state.stiffness, floor, forces.elastic)
    vector_friction(v, state.damping_vector, forces.friction)
    if system.flags[AXIAL] == 1:
        axial_friction(x, v, state.damping_axial, forces.friction)
    if state.winch_exit.shape[0] > 0:
        growth_friction(x, state, system.winches, forces.friction)
    if system.flags[TENSION_ONLY] == 1:
        drop_slack_friction(x, state.rest_length, floor, forces.friction)
    air = system.air
    if air.linear == 1 or air.quadratic == 1:
        linear_drag(v, air.node_drag, air.wind, forces.air)
    if air.quadratic == 1:
        quadratic_node_drag(v, air.node_drag_quadratic, air.wind, forces.air)
        quadratic_line_drag(x, v, air.normal, air.tangential, air.wind, forces.air)
    if system.ground.active == 1:
        ground_forces(x, v, system.ground, forces.ground)


@part
def accelerate(system, state, forces, a):
    """Write every node's acceleration [m/s^2], (3, n): total force over mass; zero for held nodes."""
    weigh_segments(forces.elastic, forces.friction, state.inverse_mass, system.gravity, a)
    if system.flags[APPLIED] == 1:
        add_over_mass(forces.applied, state.inverse_mass, a)
    if system.air.linear == 1 or system.air.quadratic == 1:
        add_over_mass(forces.air, state.inverse_mass, a)
    if system.ground.active == 1:
        add_over_mass(forces.ground, state.inverse_mass, a)


@kernel
def weigh_segments(elastic, friction, inverse_mass, gravity, a):
    """Write gravity plus the segments' forces over mass, (3, n)."""
    for k in range(3):
        g, row = gravity[k], a[k]
        e, c = elastic[k], friction[k]
        for i in range(inverse_mass.shape[0]):
            free = g if inverse_mass[i] > 0.0 else 0.0
            row[i] = (e[i + 1] - e[i] + (c[i + 1] - c[i])) * inverse_mass[i] + free


@kernel
def add_over_mass(force, inverse_mass, a):
    """Add force over mass of every node, (3, n)."""
    for k in range(3):
        row, f = a[k], force[k]
        for i in range(inverse_mass.shape[0]):
            row[i] += f[i] * inverse_mass[i]


@part
def force_on_node(system, state, forces, i, k):
    """Return component `k` of the total force on node `i` [N], weight included, anchors excluded."""
    force = (
        forces.elastic[k, i + 1]
        - forces.elastic[k, i]
        + forces.friction[k, i + 1]
        - forces.friction[k, i]
        + forces.applied[k, i]
        + state.mass[i] * system.gravity[k]
    )
    if system.air.linear == 1 or system.air.quadratic == 1:
        force += forces.air[k, i]
    if system.ground.active == 1:
        force += forces.ground[k, i]
    return force
