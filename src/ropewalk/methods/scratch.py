"""Working arrays of the methods, allocated once per call of `advance`."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

from ropewalk.core.arrays import APPLIED, Floats, Forces, State, blank
from ropewalk.core.jit import kernel, part
from ropewalk.core.ranges import ALL, rows
from ropewalk.laws.nodes import on_channels
from ropewalk.laws.rare import has_bending, limits
from ropewalk.laws.winch import REACH

LANES = 64  # of a sum: so many nodes or segments are added side by side
SUMS = 8  # that are made at once


class Look(NamedTuple):
    """What a look at a state needs, and what the last one saw, see `watch`."""

    segments: Floats  # (3, s) elastic tension, all that is carried [N], and stretch [1]
    sums: Floats  # (SUMS * LANES,) of sums in lanes, see `recording.add_up`
    known: (
        Floats  # (3,) 1 where all this is of the state as it is; elastic energy, energy error [J]
    )


SEEN, ENERGY, ERROR = range(3)  # of `known`


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
    limiter: Floats  # (11, n) rows of the limiter's equations
    turning: Floats  # (w, 7) what winches wind in a step, see `laws.winch`
    look: Look
    over: Floats  # (s,) 1 / (k L), see `spring_forces`
    # (3,) whether any segment has friction, whether `over` will do, see `look_ahead`, and whether no law of
    # nodes has a force, see `semi_implicit_euler.step`
    about: Floats


def make_scratch(state: State) -> Scratch:
    """Return working arrays that fit `state`."""
    middle, x, v, dx, dv = (np.zeros_like(state.x) for _ in range(5))
    mean = blank(state.forces)
    limiter = np.zeros((11, state.x.shape[1]))
    ends = np.zeros(3), np.zeros(3)
    turning = make_turning(state)
    over = np.zeros(state.rest_length.shape[0])
    look, about = make_look(state), np.zeros(3)
    return Scratch(middle, x, v, dx, dv, *ends, mean, limiter, turning, look, over, about)


def make_turning(state: State) -> Floats:
    """Return what a step needs for its winches, (w, 7), see `laws.winch`."""
    return np.zeros((state.winch_exit.shape[0], REACH + 1))


def make_look(state: State) -> Look:
    """Return what looks at `state` need; nothing was seen yet."""
    return Look(np.zeros((3, state.rest_length.shape[0])), np.zeros(SUMS * LANES), np.zeros(3))


@kernel
def add(values, weight, total):
    """Add weight * values to `total`, arrays of equal shape (3, m)."""
    for k in range(3):
        row, more = total[k], values[k]
        for i in range(row.shape[0]):
            row[i] += weight * more[i]


@kernel
def put_times(values, weight, total):
    """Write weight * values to `total`, arrays (3, m): the bits of `clear` and `add`, so never -0."""
    for k in range(3):
        row, more = total[k], values[k]
        for i in range(row.shape[0]):
            row[i] = 0.0 + weight * more[i]


@kernel
def clear(values):
    """Set an array (3, m) to zero."""
    for k in range(3):
        row = values[k]
        for i in range(row.shape[0]):
            row[i] = 0.0


@kernel
def clear_row(row):
    """Set an array (m,) to zero."""
    for i in range(row.shape[0]):
        row[i] = 0.0


@kernel
def clear_lanes(sums, count):
    """Set the lanes of the first `count` sums to zero."""
    clear_row(sums[: count * LANES])


@kernel
def add_up(values, sums):
    """Sum an array in LANES lanes: the loop vectorises, and the order is the same at every call."""
    clear_lanes(sums, 1)
    for lo in range(0, values.shape[0], LANES):
        _add_lanes(values, lo, min(lo + LANES, values.shape[0]), sums)
    return total_of(sums, 0)


@part
def _add_lanes(values, lo, hi, sums):
    values = values[lo:hi]
    for i in range(values.shape[0]):
        sums[i] += values[i]


@kernel
def total_of(sums, which):
    """Return the total of the lanes of sum `which`, adding halves to halves."""
    lanes = sums[which * LANES : (which + 1) * LANES]
    half = LANES // 2
    while half > 0:
        _add_lanes(lanes, half, 2 * half, lanes)
        half //= 2
    return lanes[0]


@kernel
def put_row(source, result):
    """Copy one array (m,) into another."""
    for j in range(result.shape[0]):
        result[j] = source[j]


@kernel
def put(source, result):
    """Copy an array (3, m) into another."""
    _put(source[0], result[0])
    _put(source[1], result[1])
    _put(source[2], result[2])


@part
def _put(source, result):
    for i in range(result.shape[0]):
        result[i] = source[i]


@kernel
def add_rows(values, weight, total):
    """Add weight * values to `total`, arrays of equal shape."""
    for k in range(values.shape[0]):
        row, more = total[k], values[k]
        for i in range(row.shape[0]):
            row[i] += weight * more[i]


@part
def _add_channel(values, total, weight, same, lo, hi):
    add_rows(values, weight, total)


@part
def _clear_channel(values, same, p, q, lo, hi):
    for k in range(values.shape[0]):
        clear_row(values[k])


@part
def _put_channel(source, result, p, q, lo, hi):
    for k in range(source.shape[0]):
        put_row(source[k], result[k])


_add_nodes, clear_nodes = on_channels(_add_channel), on_channels(_clear_channel)
_put_nodes = on_channels(_put_channel)


@part
def put_forces(system, source, result):
    """Copy every acting channel but the applied forces, which are the host's."""
    put(source.elastic, result.elastic)
    put(source.friction, result.friction)
    if has_bending(system):
        put(source.bending, result.bending)
    if limits(system):
        put(source.limiter, result.limiter)
    _put_nodes(system, source.node, result.node, 0.0, 0.0, 0, ALL)


@part
def add_forces(system, forces, weight, total):
    """Add every acting channel of `forces`, times `weight`, to those of `total`."""
    add(forces.elastic, weight, total.elastic)
    add(forces.friction, weight, total.friction)
    if has_bending(system):
        add(forces.bending, weight, total.bending)
    if limits(system):
        add(forces.limiter, weight, total.limiter)
    _add_nodes(system, forces.node, total.node, weight, weight, 0, ALL)
    if system.flags[APPLIED] == 1:
        add(forces.applied, weight, total.applied)


@part
def begin_forces(system, forces, weight, total):
    """As `clear_forces` and `add_forces`, of which springs and friction take one sweep."""
    put_times(forces.elastic, weight, total.elastic)
    put_times(forces.friction, weight, total.friction)
    if has_bending(system):
        put_times(forces.bending, weight, total.bending)
    if limits(system):
        put_times(forces.limiter, weight, total.limiter)
    clear_nodes(system, total.node, total.node, 0.0, 0.0, 0, ALL)
    _add_nodes(system, forces.node, total.node, weight, weight, 0, ALL)
    clear(total.applied)
    if system.flags[APPLIED] == 1:
        add(forces.applied, weight, total.applied)


@part
def clear_forces(system, forces):
    """Set every acting channel to zero."""
    clear(forces.elastic)
    clear(forces.friction)
    if has_bending(system):
        clear(forces.bending)
    if limits(system):
        clear(forces.limiter)
    clear_nodes(system, forces.node, forces.node, 0.0, 0.0, 0, ALL)
    clear(forces.applied)


@kernel
def push(x, v, a, dt, lo, hi):
    """Kick, then drift: v += dt a, x += dt v."""
    x0, x1, x2 = rows(x, lo, hi)
    v0, v1, v2 = rows(v, lo, hi)
    a0, a1, a2 = rows(a, lo, hi)
    _push(x0, v0, a0, dt)
    _push(x1, v1, a1, dt)
    _push(x2, v2, a2, dt)


@part
def _push(x, v, a, dt):
    for i in range(x.shape[0]):
        new = v[i] + dt * a[i]
        v[i] = new
        x[i] += dt * new


@kernel
def axpy(base, factor, values, result, lo=0, hi=ALL):
    """Write base + factor * values, arrays (3, n)."""
    b0, b1, b2 = rows(base, lo, hi)
    u0, u1, u2 = rows(values, lo, hi)
    r0, r1, r2 = rows(result, lo, hi)
    _axpy(b0, factor, u0, r0)
    _axpy(b1, factor, u1, r1)
    _axpy(b2, factor, u2, r2)


@part
def _axpy(base, factor, values, result):
    for i in range(result.shape[0]):
        result[i] = base[i] + factor * values[i]


@kernel
def half_way(x0, v0, x1, v1, inverse_mass, middle, drift):
    """Write mean velocity and displacement of the step; copy its end to the free nodes."""
    for k in range(3):
        xa, va, xb, vb, mid, moved = x0[k], v0[k], x1[k], v1[k], middle[k], drift[k]
        for i in range(inverse_mass.shape[0]):
            mid[i] = 0.5 * (va[i] + vb[i])
            moved[i] = xb[i] - xa[i]
            if inverse_mass[i] > 0.0:
                xa[i] = xb[i]
                va[i] = vb[i]


@kernel
def gather(reaction, share, total):
    """Add a part's mean forces, (a, 3), times its share of the step."""
    for row in range(total.shape[0]):
        for k in range(3):
            total[row, k] += share * reaction[row, k]


@kernel
def settle_reaction(total, reaction):
    """Write the mean forces of a step taken in parts, and clear the sum."""
    for row in range(total.shape[0]):
        for k in range(3):
            reaction[row, k] = total[row, k]
    clear_parts(total)


@kernel
def clear_parts(total):
    """Forget the forces of the parts of a step."""
    for row in range(total.shape[0]):
        for k in range(3):
            total[row, k] = 0.0
