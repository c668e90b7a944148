"""All laws together: springs, bending and limiter by name, all others as `registry` lists them."""

from __future__ import annotations

from ropewalk.core.arrays import APPLIED, AXIAL, TENSION_ONLY
from ropewalk.core.jit import kernel, part
from ropewalk.core.ranges import ALL, rows
from ropewalk.laws.bending import bending_forces, bending_friction
from ropewalk.laws.clamps import clamp_forces
from ropewalk.laws.couplings import any_presses
from ropewalk.laws.elastic import law_forces
from ropewalk.laws.joints import tie
from ropewalk.laws.nodes import add_node_force, node_forces, on_channels, remembers
from ropewalk.laws.rare import (
    are_tied,
    has_bending,
    has_clamps,
    has_elastic_laws,
    has_inner,
    limits,
    winds,
)
from ropewalk.laws.stretch import (
    axial_friction,
    drop_slack_friction,
    elastic_forces,
    growth_friction,
    spring_forces,
    vector_friction,
)


@part
def evaluate(system, state, x, v, forces, lo=0, hi=ALL):
    """Write the forces of all laws at positions `x` and velocities `v`, both (3, n), by channel [N].

    For nodes `lo` to `hi - 1`, when those of the nodes before are written already.
    """
    floor = system.slack_floor
    elastic_forces(x, state.rest_length, state.stiffness, floor, forces.elastic, lo, hi)
    if has_elastic_laws(system):
        lengths, k, elastic = state.rest_length, state.stiffness, system.elastic
        law_forces(x, lengths, k, floor, elastic, state.inner, forces.elastic, lo, hi)
    rub_segments(system, state, x, v, forces, lo, hi)
    if system.flags[TENSION_ONLY] == 1:
        drop_slack_friction(x, state.rest_length, floor, forces.friction, lo, hi)
    if has_bending(system):
        evaluate_bending(system, state, x, v, forces)
    node_forces(system, state, x, v, forces, lo, hi)


@part
def rub_segments(system, state, x, v, forces, lo=0, hi=ALL):
    """Write the internal friction of all segments, slack ones included."""
    vector_friction(v, state.damping_vector, forces.friction, lo, hi)
    if system.flags[AXIAL] == 1:
        axial_friction(x, v, state.damping_axial, forces.friction, lo, hi)
    if winds(system, state):
        growth_friction(x, state, system.winches, forces.friction)


@part
def evaluate_bending(system, state, x, v, forces):
    """Write the elastic forces of bending, clamps included, and add their friction to the segments'."""
    lengths, bending = state.rest_length, system.bending
    bending_forces(x, lengths, state.bending_stiffness, bending.natural, forces.bending)
    bending_friction(x, v, lengths, state.bending_damping, forces.friction)
    if has_clamps(system, state):
        clamp_forces(
            x,
            v,
            lengths,
            state.held,
            state.anchor_node,
            bending,
            state.clamp_direction,
            state.clamp_spin,
            forces.bending,
            forces.friction,
        )


@kernel
def add_over_mass(force, inverse_mass, a, lo, hi):
    """Add force over mass of every node, (3, n)."""
    inverse_mass = inverse_mass[lo:hi]
    f0, f1, f2 = rows(force, lo, hi)
    a0, a1, a2 = rows(a, lo, hi)
    _add_scaled(f0, inverse_mass, a0)
    _add_scaled(f1, inverse_mass, a1)
    _add_scaled(f2, inverse_mass, a2)


@part
def _add_scaled(force, inverse_mass, a):
    for i in range(inverse_mass.shape[0]):
        a[i] += force[i] * inverse_mass[i]


@part
def _over_mass(force, same, inverse_mass, a, lo, hi):
    add_over_mass(force, inverse_mass, a, lo, hi)


_add_nodes_over_mass = on_channels(_over_mass)


@part
def accelerate(system, state, forces, a, lo=0, hi=ALL):
    """Write every node's acceleration [m/s^2], (3, n): total force over mass; zero for held nodes.

    Nodes that are tied to each other share it.
    """
    weigh_segments(forces.elastic, forces.friction, state.inverse_mass, system.gravity, a, lo, hi)
    if has_bending(system):
        add_segments_over_mass(forces.bending, state.inverse_mass, a)
    if limits(system):
        add_segments_over_mass(forces.limiter, state.inverse_mass, a)
    if system.flags[APPLIED] == 1:
        add_over_mass(forces.applied, state.inverse_mass, a, lo, hi)
    _add_nodes_over_mass(system, forces.node, forces.node, state.inverse_mass, a, lo, hi)
    tie(system, state, a)


@kernel
def weigh_segments(elastic, friction, inverse_mass, gravity, a, lo, hi):
    """Write gravity plus the segments' forces over mass, (3, n)."""
    inverse_mass = inverse_mass[lo:hi]
    e0, e1, e2 = rows(elastic, lo, hi + 1)
    c0, c1, c2 = rows(friction, lo, hi + 1)
    a0, a1, a2 = rows(a, lo, hi)
    _weigh(e0, c0, inverse_mass, gravity[0], a0)
    _weigh(e1, c1, inverse_mass, gravity[1], a1)
    _weigh(e2, c2, inverse_mass, gravity[2], a2)


@part
def _weigh(e, c, inverse_mass, g, a):
    for i in range(inverse_mass.shape[0]):
        free = g if inverse_mass[i] > 0.0 else 0.0
        a[i] = (e[i + 1] + c[i + 1] - (e[i] + c[i])) * inverse_mass[i] + free


@kernel
def add_segments_over_mass(force, inverse_mass, a):
    """Add the force of the segments over mass of every node, (3, n); `force` is (3, n + 1)."""
    for k in range(3):
        row, f = a[k], force[k]
        for i in range(inverse_mass.shape[0]):
            row[i] += (f[i + 1] - f[i]) * inverse_mass[i]


@part
def has_plain_forces(system, state):
    """Tell whether nothing acts now but springs, their friction and weight, and no nodes are tied."""
    flags = has_bending(system) or system.flags[APPLIED] == 1
    return not (flags or any_presses(system, state) or are_tied(system))


@part
def has_plain_springs(system, state):
    """Tell whether, besides, no segment goes slack or grows, and all obey Hooke's law."""
    more = winds(system, state) or has_elastic_laws(system)
    return system.flags[TENSION_ONLY] == 0 and not more


@part
def add_up_springs(system, state, x, v, total, lo, hi):
    """Write elastic force and friction of every segment in one sum, (3, n + 1) [N]."""
    length, k, floor, c = (
        state.rest_length,
        state.stiffness,
        system.slack_floor,
        state.damping_vector,
    )
    if system.flags[AXIAL] == 1:
        axial = state.damping_axial
        spring_forces(x, v, length, k, floor, c, axial, total, None, None, None, lo, hi)
    else:
        spring_forces(x, v, length, k, floor, c, None, total, None, None, None, lo, hi)


@part
def add_up_and_look(system, state, x, v, total, rubs, over, height, lo, hi):
    """As `add_up_springs`, and look at what the step begins with, see `spring_forces`.

    `rubs` tells whether any segment has friction; `over` (s,) and `height` (n,).
    """
    length, k, floor, c = (
        state.rest_length,
        state.stiffness,
        system.slack_floor,
        state.damping_vector,
    )
    peaks = state.peaks
    if system.flags[AXIAL] == 1:
        axial = state.damping_axial
        spring_forces(x, v, length, k, floor, c, axial, total, over, height, peaks, lo, hi)
    elif rubs:
        spring_forces(x, v, length, k, floor, c, None, total, over, height, peaks, lo, hi)
    else:
        spring_forces(x, v, length, k, floor, c, None, total, None, height, peaks, lo, hi)


@part
def reaches_neighbours_only(system, state):
    """Tell whether a node's acceleration depends on itself and the nodes next to it alone.

    A law with a memory keeps it of whole steps, and so of all nodes at once; so does a segment.
    """
    keeps = remembers(system) or has_inner(system, state)
    return not has_bending(system) and not are_tied(system) and not keeps


@part
def force_on_node(system, state, forces, i, k):
    """Return component `k` of the total force on node `i` [N], weight included, anchors excluded."""
    force = (
        forces.elastic[k, i + 1]
        + forces.friction[k, i + 1]
        - (forces.elastic[k, i] + forces.friction[k, i])
        + forces.applied[k, i]
        + state.mass[i] * system.gravity[k]
    )
    if has_bending(system):
        force += forces.bending[k, i + 1] - forces.bending[k, i]
    if limits(system):
        force += forces.limiter[k, i + 1] - forces.limiter[k, i]
    return add_node_force(system, forces.node, i, k, force)
