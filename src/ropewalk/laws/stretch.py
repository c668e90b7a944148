"""Stretch (Hooke) and internal friction of the segments.

Elastic:   F = k (r - L) t, t the unit vector along the segment; with tension-only, F = 0 when r < L.
Friction:  vector form  F = c (v2 - v1)            (student report; NeHe lesson 40)
           axial form   F = c ((v2 - v1) . t) t    (Kelvin-Voigt; conserves angular momentum)
F is the force on the first node; the second gets -F. A slack tension-only segment has no friction either.
Energy:    U = k (r - L)^2 / 2.
"""

from __future__ import annotations

import math

import numpy as np

from ropewalk.core.jit import apart, kernel, part, small
from ropewalk.core.peaks import greater, lesser
from ropewalk.core.ranges import ALL, rows


@small
def stretched(x, j):
    """Return the length of segment `j` [m]."""
    dx, dy, dz = x[0, j + 1] - x[0, j], x[1, j + 1] - x[1, j], x[2, j + 1] - x[2, j]
    return math.sqrt(dx * dx + dy * dy + dz * dz)


@kernel
def elastic_forces(x, rest_length, stiffness, floor, elastic, lo=0, hi=ALL):
    """Write the elastic force of every segment [N], (3, n + 1).

    Per segment 17 flops, a square root and a division; 6 reads and 3 writes of 8 bytes.
    """
    x0, x1, x2 = rows(x, lo, hi + 1)
    e0, e1, e2 = rows(elastic, lo, hi + 1)
    rest_length, stiffness, floor = rest_length[lo:hi], stiffness[lo:hi], floor[lo:hi]
    for j in range(rest_length.shape[0]):
        dx, dy, dz = x0[j + 1] - x0[j], x1[j + 1] - x1[j], x2[j + 1] - x2[j]
        r = math.sqrt(dx * dx + dy * dy + dz * dz)
        tension = max(stiffness[j] * (r - rest_length[j]), floor[j])
        pull = tension / r if r > 0.0 else 0.0
        e0[j + 1] = pull * dx
        e1[j + 1] = pull * dy
        e2[j + 1] = pull * dz


@kernel
def vector_friction(v, coefficient, friction, lo=0, hi=ALL):
    """Write the vector form's friction of every segment [N], (3, n + 1)."""
    coefficient = coefficient[lo:hi]
    _difference(v[0, lo : hi + 1], coefficient, friction[0, lo : hi + 1])
    _difference(v[1, lo : hi + 1], coefficient, friction[1, lo : hi + 1])
    _difference(v[2, lo : hi + 1], coefficient, friction[2, lo : hi + 1])


@part
def _difference(u, coefficient, row):
    for j in range(coefficient.shape[0]):
        row[j + 1] = coefficient[j] * (u[j + 1] - u[j])


@kernel
def axial_friction(x, v, coefficient, friction, lo=0, hi=ALL):
    """Add the axial form's friction of every segment [N], (3, n + 1)."""
    x0, x1, x2 = rows(x, lo, hi + 1)
    v0, v1, v2 = rows(v, lo, hi + 1)
    c0, c1, c2 = rows(friction, lo, hi + 1)
    coefficient = coefficient[lo:hi]
    for j in range(coefficient.shape[0]):
        dx, dy, dz = x0[j + 1] - x0[j], x1[j + 1] - x1[j], x2[j + 1] - x2[j]
        square = dx * dx + dy * dy + dz * dz
        rate = (v0[j + 1] - v0[j]) * dx + (v1[j + 1] - v1[j]) * dy + (v2[j + 1] - v2[j]) * dz
        along = coefficient[j] * rate / square if square > 0.0 else 0.0
        c0[j + 1] += along * dx
        c1[j + 1] += along * dy
        c2[j + 1] += along * dz


@apart
def spring_forces(
    x, v, rest_length, stiffness, floor, vector, axial, total, over, height, peaks, lo, hi
):
    """Write the sum of elastic force and friction of every segment [N], (3, n + 1).

    The arithmetic of the three kernels above, for who needs no shares of the work; `axial` may be None.
    Unless `peaks` is None what the step begins with is held against them, nodes at their `height` (n,) too,
    all but the last one: the root and the division keep the processor waiting meanwhile. Segments without
    friction keep the square of their length; with `over`, 1 / (k L), what they carry: friction along the
    segment takes no division, for 1 / r = (k - T / r) / (k L).
    """
    x0, x1, x2 = rows(x, lo, hi + 1)
    v0, v1, v2 = rows(v, lo, hi + 1)
    f0, f1, f2 = rows(total, lo, hi + 1)
    rest_length, stiffness, floor = rest_length[lo:hi], stiffness[lo:hi], floor[lo:hi]
    vector = vector[lo:hi]
    along = vector if axial is None else axial[lo:hi]
    inverse = vector if over is None else over[lo:hi]
    if peaks is not None:
        longest, shortest = peaks.square_high[lo:hi], peaks.square_low[lo:hi]
        most, least = peaks.tension_high[lo:hi], peaks.tension_low[lo:hi]
        fastest, top, bottom = peaks.speed[lo:hi], peaks.high[lo:hi], peaks.low[lo:hi]
        height = height[lo:hi]
    for j in range(rest_length.shape[0]):
        dx, dy, dz = x0[j + 1] - x0[j], x1[j + 1] - x1[j], x2[j + 1] - x2[j]
        ux, uy, uz = v0[j + 1] - v0[j], v1[j + 1] - v1[j], v2[j + 1] - v2[j]
        square = dx * dx + dy * dy + dz * dz
        r = math.sqrt(square)
        tension = max(stiffness[j] * (r - rest_length[j]), floor[j])
        pull = tension / r if r > 0.0 else 0.0
        cx, cy, cz = vector[j] * ux, vector[j] * uy, vector[j] * uz
        if axial is not None:
            rate = along[j] * (ux * dx + uy * dy + uz * dz)
            share = rate / square if square > 0.0 else 0.0
            cx, cy, cz = cx + share * dx, cy + share * dy, cz + share * dz
        f0[j + 1] = pull * dx + cx
        f1[j + 1] = pull * dy + cy
        f2[j + 1] = pull * dz + cz
        if peaks is not None:
            longest[j] = greater(square, longest[j])
            shortest[j] = lesser(square, shortest[j])
            fastest[j] = greater(v0[j] * v0[j] + v1[j] * v1[j] + v2[j] * v2[j], fastest[j])
            top[j] = greater(height[j], top[j])
            bottom[j] = lesser(height[j], bottom[j])
        if over is not None:
            rubs = cx * dx + cy * dy + cz * dz
            carried = tension + rubs * ((stiffness[j] - pull) * inverse[j])
            most[j] = greater(carried, most[j])
            least[j] = lesser(carried, least[j])


@kernel
def growth_friction(x, state, winches, friction):
    """Take the growth of the winches' working segments out of their friction, (3, n + 1).

    Friction follows the rate of strain, d(r/L)/dt = (r' - r L'/L) / L: rope that is paid out unstrained
    meets none.
    """
    for row in range(state.winch_exit.shape[0]):
        drum = state.winch_exit[row]
        j = drum if winches.step[row] > 0 else drum - 1
        if state.rest_length[j] == 0.0:  # it has parted
            continue
        c = state.damping_vector[j] + state.damping_axial[j]
        growth = c * state.winch_rate[row] / state.rest_length[j]
        for k in range(3):
            friction[k, j + 1] -= growth * (x[k, j + 1] - x[k, j])


@kernel
def drop_slack_friction(x, rest_length, floor, friction, lo=0, hi=ALL):
    """Set the friction of slack tension-only segments to zero."""
    x0, x1, x2 = rows(x, lo, hi + 1)
    c0, c1, c2 = rows(friction, lo, hi + 1)
    rest_length, floor = rest_length[lo:hi], floor[lo:hi]
    for j in range(rest_length.shape[0]):
        if floor[j] == 0.0:
            dx, dy, dz = x0[j + 1] - x0[j], x1[j + 1] - x1[j], x2[j + 1] - x2[j]
            if math.sqrt(dx * dx + dy * dy + dz * dz) < rest_length[j]:
                c0[j + 1], c1[j + 1], c2[j + 1] = 0.0, 0.0, 0.0


@kernel
def drop_marked_friction(rubs, friction):
    """Set the friction of the segments that are not marked as rubbing to zero."""
    for j in range(rubs.shape[0]):
        if rubs[j] == 0.0:
            friction[0, j + 1] = 0.0
            friction[1, j + 1] = 0.0
            friction[2, j + 1] = 0.0


@kernel
def segment_tension(x, rest_length, stiffness, floor, tension):
    """Write the elastic tension of every segment [N], (s,); negative where it is compressed."""
    for j in range(rest_length.shape[0]):
        dx = x[0, j + 1] - x[0, j]
        dy = x[1, j + 1] - x[1, j]
        dz = x[2, j + 1] - x[2, j]
        r = math.sqrt(dx * dx + dy * dy + dz * dz)
        tension[j] = max(stiffness[j] * (r - rest_length[j]), floor[j])


@kernel
def elastic_energy(x, rest_length, stiffness, floor):
    """Return the elastic energy of all segments [J]; slack and rigid ones store none."""
    total = 0.0
    for j in range(rest_length.shape[0]):
        dx = x[0, j + 1] - x[0, j]
        dy = x[1, j + 1] - x[1, j]
        dz = x[2, j + 1] - x[2, j]
        e = math.sqrt(dx * dx + dy * dy + dz * dz) - rest_length[j]
        if stiffness[j] < np.inf and stiffness[j] * e >= floor[j]:
            total += 0.5 * stiffness[j] * e * e
    return total
