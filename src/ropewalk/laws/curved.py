"""Stretch of ropes whose tension is no straight line of the strain: the kernels of `stretch` for curves.

    T = EA g(e),   e = (r - L) / L,   k = EA / L,   U = EA L G(e),   G' = g

EA is the largest slope of the curve, so that k bounds every slope, and g' is at most 1. The pieces of g are
those of `theory.curve` over EA. Segments without a curve obey Hooke's law with the arithmetic of `stretch`.
"""

from __future__ import annotations

import math

import numpy as np

from ropewalk.core.jit import kernel, part, small
from ropewalk.core.peaks import greater, lesser
from ropewalk.core.ranges import ALL
from ropewalk.laws.rare import has_curves
from ropewalk.laws.stretch import elastic_energy, segment_tension
from ropewalk.laws.stretch_tangent import add_line

START, TENSION, SLOPE, BEND, ENERGY = range(5)  # columns of `Curves.piece`
# Rows of `State.arm`, see `relaxing`: strain of the damper, its change in the last step, the rate that a
# method keeps [1/s], and what a step begins with.
DAMPER, CHANGE, RATE, FIRST = range(4)


@small
def find(piece, first, last, strain):
    """Return the last of the rows `first` to `last - 1` that begins at `strain` or before; else the first."""
    low, high = first, last - 1
    while low < high:
        middle = (low + high + 1) // 2
        if piece[middle, START] <= strain:
            low = middle
        else:
            high = middle - 1
    return low


@small
def at_strain(curves, which, strain):
    """Return tension, slope and energy per length, over EA [1]."""
    piece = curves.piece
    row = find(piece, curves.first[which], curves.first[which + 1], strain)
    d, T, s, q = (
        strain - piece[row, START],
        piece[row, TENSION],
        piece[row, SLOPE],
        piece[row, BEND],
    )
    return (
        T + d * (s + q * d),
        s + 2.0 * q * d,
        piece[row, ENERGY] + d * (T + d * (0.5 * s + d * q / 3.0)),
    )


@small
def at_tension(curves, which, tension, beside):
    """Return strain and slope of a tension over EA [1], of the curve and a straight line `beside` it."""
    piece, low, high = curves.piece, curves.first[which], curves.first[which + 1] - 1
    while low < high:
        middle = (low + high + 1) // 2
        if piece[middle, TENSION] + beside * piece[middle, START] <= tension:
            low = middle
        else:
            high = middle - 1
    row = low
    rise = tension - (piece[row, TENSION] + beside * piece[row, START])
    s = piece[row, SLOPE] + beside
    root = math.sqrt(max(s * s + 4.0 * piece[row, BEND] * rise, 0.0))
    return piece[row, START] + 2.0 * rise / (s + root), root


@small
def stretched(x, j):
    """Return the length of segment `j` [m]."""
    dx, dy, dz = x[0, j + 1] - x[0, j], x[1, j + 1] - x[1, j], x[2, j + 1] - x[2, j]
    return math.sqrt(dx * dx + dy * dy + dz * dz)


@kernel
def curved_forces(x, rest_length, stiffness, floor, curves, arm, elastic, lo=0, hi=ALL):
    """Write the elastic force of every segment with a curve [N], (3, n + 1)."""
    for j in range(lo, min(hi, rest_length.shape[0])):
        if curves.of[j] < 0 or stiffness[j] == 0.0:
            continue
        r = stretched(x, j)
        pull = max(elastic_pull(curves, arm, j, rest_length[j], stiffness[j], r), floor[j])
        over = pull / r if r > 0.0 else 0.0
        for k in range(3):
            elastic[k, j + 1] = over * (x[k, j + 1] - x[k, j])


@kernel
def curved_tension(x, rest_length, stiffness, floor, curves, arm, tension):
    """Write the elastic tension of every segment with a curve [N], (s,)."""
    for j in range(rest_length.shape[0]):
        if curves.of[j] >= 0 and stiffness[j] > 0.0:
            pull = elastic_pull(curves, arm, j, rest_length[j], stiffness[j], stretched(x, j))
            tension[j] = max(pull, floor[j])


@kernel
def curved_energy(x, rest_length, stiffness, floor, curves, arm):
    """Return the elastic energy of all segments [J], with a curve or without; see `elastic_energy`."""
    total = 0.0
    for j in range(rest_length.shape[0]):
        length, k = rest_length[j], stiffness[j]
        e = stretched(x, j) - length
        if curves.of[j] >= 0 and k > 0.0:
            total += stored_by(curves, arm, j, length, k, floor[j], e / length)
        elif k < np.inf and not (floor[j] == 0.0 and e < 0.0):
            total += 0.5 * k * e * e
    return total


@kernel
def hold_secants(tension, rest_length, stiffness, curves, work):
    """Write what a segment with a curve gives over its tension [m/N], (s,), beyond its length without."""
    soft, relaxed = work.soft, work.arm.shape[0] > 0
    for j in range(tension.shape[0]):
        if curves.of[j] >= 0 and stiffness[j] > 0.0:
            product = stiffness[j] * rest_length[j]
            own = work.arm[j] if relaxed else 0.0
            held = own * work.known[j] if relaxed else 0.0
            strain, slope = at_tension(curves, curves.of[j], tension[j] / product + held, own)
            if relaxed:
                strain -= work.free[j]
                work.stretch[j] -= rest_length[j] * work.free[j]
            given = strain * rest_length[j] / tension[j] if tension[j] != 0.0 else 0.0
            soft[j] = given if tension[j] != 0.0 else 1.0 / (stiffness[j] * slope)


@kernel
def hold_tangents(tension, rest_length, stiffness, curves, work, carries, compliance):
    """Write the tangent compliance [m/N], (s,), of the segments with a curve that carry."""
    relaxed = work.arm.shape[0] > 0
    for j in range(tension.shape[0]):
        if curves.of[j] >= 0 and stiffness[j] > 0.0 and carries[j] != 0.0:
            product = stiffness[j] * rest_length[j]
            own = work.arm[j] if relaxed else 0.0
            held = own * work.known[j] if relaxed else 0.0
            _, slope = at_tension(curves, curves.of[j], tension[j] / product + held, own)
            compliance[j] = 1.0 / (stiffness[j] * slope)


@kernel
def curved_tangent(x, rest_length, stiffness, floor, curves, weight, clamp, band):
    """Add `weight` times the stiffness of all springs, with a curve or without; see `elastic_tangent`."""
    for j in range(rest_length.shape[0]):
        length, along = rest_length[j], stiffness[j]
        r = stretched(x, j)
        if r == 0.0:
            if length == 0.0:
                add_line(band, j, 0.0, 0.0, 0.0, weight * along, weight * along)
            continue
        tension = along * (r - length)
        if curves.of[j] >= 0 and along > 0.0:
            pull, slope, _ = at_strain(curves, curves.of[j], (r - length) / length)
            tension, along = along * length * pull, along * slope
        if tension < floor[j]:
            continue
        across = tension / r
        if clamp and across < 0.0:
            across = 0.0
        tx, ty, tz = (
            (x[0, j + 1] - x[0, j]) / r,
            (x[1, j + 1] - x[1, j]) / r,
            (x[2, j + 1] - x[2, j]) / r,
        )
        add_line(band, j, tx, ty, tz, weight * across, weight * along)


@small
def elastic_pull(curves, arm, j, length, k, r):
    """Return the elastic tension of segment `j` at length `r` [N], before it is slack; its arm's with it."""
    if curves.of[j] < 0 or k == 0.0:
        return k * (r - length)
    strain = (r - length) / length
    pull, _, _ = at_strain(curves, curves.of[j], strain)
    if arm.shape[1] > 0:
        pull += curves.arm[curves.of[j]] * (strain - arm[DAMPER, j])
    return k * length * pull


@small
def held_strain(curves, which, floor, strain, damper):
    """Return the strain of what the rope is made of [1]: that without tension where it is slack."""
    if floor == 0.0 and curves.arm[which] > 0.0:
        own = curves.arm[which]
        free, _ = at_tension(curves, which, own * damper, own)
        strain = max(strain, free)
    return strain


@small
def stored_by(curves, arm, j, length, k, floor, strain):
    """Return what a segment with a curve stores [J]; one that relaxes does so while it is slack, too."""
    which, shift = curves.of[j], 0.0
    if arm.shape[1] > 0:
        strain = held_strain(curves, which, floor, strain, arm[DAMPER, j])
        shift = strain - arm[DAMPER, j]
    elif floor == 0.0 and strain < 0.0:
        return 0.0
    _, _, energy = at_strain(curves, which, strain)
    return k * length * length * (energy + 0.5 * curves.arm[which] * shift * shift)


@kernel
def keep_curved(state, floor, curves, high, low, lo, hi):
    """As `methods.peaks.keep_tension`, of segments with a curve or without."""
    x, v = state.x, state.v
    for j in range(lo, min(hi, high.shape[0])):
        r, length = stretched(x, j), state.rest_length[j]
        rubs, rate = state.damping_vector[j] + state.damping_axial[j], 0.0
        for k in range(3):
            rate += (v[k, j + 1] - v[k, j]) * (x[k, j + 1] - x[k, j])
        rubs = rubs * rate / r if r > 0.0 and (floor[j] != 0.0 or r >= length) else 0.0
        pull = elastic_pull(curves, state.arm, j, length, state.stiffness[j], r)
        new = max(pull, floor[j]) + rubs
        high[j], low[j] = greater(new, high[j]), lesser(new, low[j])


@kernel
def settle_curved(peaks, rest_length, stiffness, floor, vector, axial, curves, arm):
    """As `methods.peaks.settle`, of segments with a curve or without; those that relax are looked at."""
    for j in range(rest_length.shape[0]):
        if peaks.square_high[j] < 0.0:
            continue
        length, k = rest_length[j], stiffness[j]
        longest, shortest = math.sqrt(peaks.square_high[j]), math.sqrt(peaks.square_low[j])
        if length > 0.0:
            peaks.stretch[j] = max(peaks.stretch[j], longest / length)
        if vector[j] + axial[j] == 0.0 and arm.shape[1] == 0:
            high = max(elastic_pull(curves, arm, j, length, k, longest), floor[j])
            low = max(elastic_pull(curves, arm, j, length, k, shortest), floor[j])
            peaks.tension_high[j] = max(peaks.tension_high[j], high)
            peaks.tension_low[j] = min(peaks.tension_low[j], low)


@part
def stored_energy(system, state, x, arm):
    """Return the elastic energy of all segments at places `x`, (3, n), with the `arm` of then [J]."""
    lengths, k, floor = state.rest_length, state.stiffness, system.slack_floor
    if has_curves(system):
        energy = curved_energy(x, lengths, k, floor, system.curves, arm)
    else:
        energy = elastic_energy(x, lengths, k, floor)
    return energy


@part
def tensions(system, state, tension):
    """Write the elastic tension of every segment [N], (s,); negative where it is compressed."""
    lengths, k, floor = state.rest_length, state.stiffness, system.slack_floor
    segment_tension(state.x, lengths, k, floor, tension)
    if has_curves(system):
        curved_tension(state.x, lengths, k, floor, system.curves, state.arm, tension)
