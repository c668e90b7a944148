"""Generalized-alpha's step: what is known of its stage, and its end with filtered forces."""

from __future__ import annotations

from ropewalk.core.jit import kernel, part
from ropewalk.core.ranges import ALL
from ropewalk.laws.elastic import RATE
from ropewalk.laws.inner import know_past, write_end
from ropewalk.laws.nodes import on_channels
from ropewalk.laws.rare import has_bending
from ropewalk.laws.table import accelerate
from ropewalk.methods.scratch import add, add_forces, axpy, put


@part
def prepare_alpha(state, scratch, numbers, dt):
    """Write what is known of generalized-alpha's stage, at t + (1 - alpha_f) h.

    With a' at the step's start and a at its end, both filtered, and q = (1 - alpha_f) h
        X = x + q v + q h ((1/2 - beta) a' + beta a),   V = v + q ((1 - gamma) a' + gamma a)
        (1 - alpha_m) a + alpha_m a' = F / m .
    """
    stage, before = scratch.stage, state.acceleration
    am, af, beta, gamma = numbers[0], numbers[1], numbers[2], numbers[3]
    ahead = (1.0 - af) * dt
    c1, c2 = beta / gamma * dt, ahead * gamma / (1.0 - am)
    axpy(state.v, ahead * (1.0 - gamma) - c2 * am, before, stage.v_known)
    axpy(state.x, ahead - c1, state.v, stage.x_known)
    add(before, ahead * dt * (0.5 - beta) - c1 * ahead * (1.0 - gamma), stage.x_known)
    put(before, stage.a)
    know_past(state, ahead * (1.0 - gamma) - c2 * am, RATE, stage.segments.known)
    return c1, c2


@kernel
def blend(values, weight, others, other_weight):
    """Write weight * values + other_weight * others into `values`, arrays (3, m)."""
    for k in range(3):
        row, more = values[k], others[k]
        for i in range(row.shape[0]):
            row[i] = weight * row[i] + other_weight * more[i]


@part
def _blend_channel(values, others, weight, other_weight, lo, hi):
    blend(values, weight, others, other_weight)


_blend_nodes = on_channels(_blend_channel)


@part
def _filter(system, state, forces, am):
    """Put (F - am G) / (1 - am) in place of every filtered force G."""
    old, new = -am / (1.0 - am), 1.0 / (1.0 - am)
    blend(state.forces.elastic, old, forces.elastic, new)
    blend(state.forces.friction, old, forces.friction, new)
    if has_bending(system):
        blend(state.forces.bending, old, forces.bending, new)
    _blend_nodes(system, state.forces.node, forces.node, old, new, 0, ALL)


@part
def end_alpha(system, state, scratch, numbers, dt):
    """Write the end of generalized-alpha's step, its mean forces and its filtered ones."""
    stage, mean, before = scratch.stage, scratch.mean, scratch.k[0]
    am, beta, gamma = numbers[0], numbers[2], numbers[3]
    add_forces(system, state.forces, (1.0 - gamma) - gamma * am / (1.0 - am), mean)
    add_forces(system, stage.forces, gamma / (1.0 - am), mean)
    put(state.acceleration, before)
    _filter(system, state, stage.forces, am)
    accelerate(system, state, state.forces, state.acceleration)
    axpy(state.x, dt, state.v, stage.x)
    add(before, dt * dt * (0.5 - beta), stage.x)
    add(state.acceleration, dt * dt * beta, stage.x)
    axpy(state.v, dt * (1.0 - gamma), before, stage.v)
    add(state.acceleration, dt * gamma, stage.v)
    write_end(state, scratch.ends, dt * (1.0 - gamma), RATE, dt * gamma, scratch.rates[0], am)
