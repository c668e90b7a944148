"""Working arrays of the methods, allocated once per call of `advance`."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

from ropewalk.core.arrays import APPLIED, Floats, Forces, State
from ropewalk.core.jit import kernel, part


class Scratch(NamedTuple):
    """Arrays (3, n) for stages and increments, and mean forces over the stages."""

    middle: Floats
    x: Floats
    v: Floats
    dx: Floats
    dv: Floats
    point: Floats  # (3,)
    speed: Floats  # (3,)
    mean: Forces
    limiter: Floats  # (7, n) rows of the limiter's equations


def make_scratch(state: State) -> Scratch:
    """Return working arrays that fit `state`."""
    middle, x, v, dx, dv = (np.zeros_like(state.x) for _ in range(5))
    mean = Forces(*(np.zeros_like(channel) for channel in state.forces))
    return Scratch(
        middle, x, v, dx, dv, np.zeros(3), np.zeros(3), mean, np.zeros((7, state.x.shape[1]))
    )


@kernel
def add(values, weight, total):
    """Add weight * values to `total`, arrays of equal shape (3, m)."""
    for k in range(3):
        row, more = total[k], values[k]
        for i in range(row.shape[0]):
            row[i] += weight * more[i]


@kernel
def clear(values):
    """Set an array (3, m) to zero."""
    for k in range(3):
        row = values[k]
        for i in range(row.shape[0]):
            row[i] = 0.0


@kernel
def put(source, result):
    """Copy an array (3, m) into another."""
    for k in range(3):
        to, row = result[k], source[k]
        for i in range(to.shape[0]):
            to[i] = row[i]


@part
def add_forces(system, forces, weight, total):
    """Add every acting channel of `forces`, times `weight`, to those of `total`."""
    add(forces.elastic, weight, total.elastic)
    add(forces.friction, weight, total.friction)
    if system.air.linear == 1 or system.air.quadratic == 1:
        add(forces.air, weight, total.air)
    if system.ground.active == 1:
        add(forces.ground, weight, total.ground)
    if system.flags[APPLIED] == 1:
        add(forces.applied, weight, total.applied)


@part
def clear_forces(system, forces):
    """Set every acting channel to zero."""
    clear(forces.elastic)
    clear(forces.friction)
    if system.air.linear == 1 or system.air.quadratic == 1:
        clear(forces.air)
    if system.ground.active == 1:
        clear(forces.ground)
    clear(forces.applied)


@kernel
def push(x, v, a, dt):
    """Kick, then drift: v += dt a, x += dt v."""
    for k in range(3):
        xk, vk, ak = x[k], v[k], a[k]
        for i in range(xk.shape[0]):
            new = vk[i] + dt * ak[i]
            vk[i] = new
            xk[i] += dt * new


@kernel
def axpy(base, factor, values, result):
    """Write base + factor * values, arrays (3, n)."""
    for k in range(3):
        to, b, u = result[k], base[k], values[k]
        for i in range(to.shape[0]):
            to[i] = b[i] + factor * u[i]
