"""Derivatives of the forces of stretch and internal friction; see `stretch` for the laws.

With d the vector from node j to j + 1, r its length, t = d / r, P = I - t t^T and u = v_(j+1) - v_j,
the force f on node j (and -f on node j + 1) has the derivatives
    elastic            df/dd = k t t^T + T/r P           T = k (r - L), 0 where slack
    vector friction    df/du = c I
    axial friction     df/du = c t t^T,   df/dd = c/r (t (P u)^T + (u . t) P)
    growth of a winch  df/dd = -c L'/L I
"""

from __future__ import annotations

import math

from ropewalk.core.arrays import AXIAL
from ropewalk.core.jit import kernel, part
from ropewalk.laws.rare import winds


@kernel
def add_pair(band, j, k, m, value):
    """Add to entry (k, m) what a force between nodes j and j + 1 with df_k/dd_m = value has.

    The matrix is -dF/dx, so the diagonal blocks get +value.
    """
    at = 3 * k + m
    band.diagonal[j, at] += value
    band.diagonal[j + 1, at] += value
    band.upper1[j, at] -= value
    band.lower1[j, at] -= value


@kernel
def add_line(band, j, tx, ty, tz, across, along):
    """Add df/dd = across I + (along - across) t t^T of segment j; t is a unit vector or zero."""
    q = along - across
    add_pair(band, j, 0, 0, across + q * tx * tx)
    add_pair(band, j, 0, 1, q * tx * ty)
    add_pair(band, j, 0, 2, q * tx * tz)
    add_pair(band, j, 1, 0, q * tx * ty)
    add_pair(band, j, 1, 1, across + q * ty * ty)
    add_pair(band, j, 1, 2, q * ty * tz)
    add_pair(band, j, 2, 0, q * tx * tz)
    add_pair(band, j, 2, 1, q * ty * tz)
    add_pair(band, j, 2, 2, across + q * tz * tz)


@kernel
def add_turn(band, j, tx, ty, tz, px, py, pz):
    """Add df/dd = t p^T of segment j: of a force along the unit vector t that follows a rate."""
    add_pair(band, j, 0, 0, tx * px)
    add_pair(band, j, 0, 1, tx * py)
    add_pair(band, j, 0, 2, tx * pz)
    add_pair(band, j, 1, 0, ty * px)
    add_pair(band, j, 1, 1, ty * py)
    add_pair(band, j, 1, 2, ty * pz)
    add_pair(band, j, 2, 0, tz * px)
    add_pair(band, j, 2, 1, tz * py)
    add_pair(band, j, 2, 2, tz * pz)


@kernel
def elastic_tangent(x, rest_length, stiffness, floor, weight, clamp, band):
    """Add `weight` times the stiffness of all springs; with `clamp` no compression softens it."""
    x0, x1, x2 = x[0], x[1], x[2]
    for j in range(rest_length.shape[0]):
        k = stiffness[j]
        dx, dy, dz = x0[j + 1] - x0[j], x1[j + 1] - x1[j], x2[j + 1] - x2[j]
        r = math.sqrt(dx * dx + dy * dy + dz * dz)
        if r == 0.0:
            if rest_length[j] == 0.0:
                add_line(band, j, 0.0, 0.0, 0.0, weight * k, weight * k)
            continue
        tension = k * (r - rest_length[j])
        if tension < floor[j]:
            continue
        across = tension / r
        if clamp and across < 0.0:
            across = 0.0
        add_line(band, j, dx / r, dy / r, dz / r, weight * across, weight * k)


@kernel
def is_rubbing(x, rest_length, floor, j):
    """Tell whether segment j has friction: a slack tension-only segment has none."""
    if floor[j] != 0.0:
        return True
    dx, dy, dz = x[0, j + 1] - x[0, j], x[1, j + 1] - x[1, j], x[2, j + 1] - x[2, j]
    return math.sqrt(dx * dx + dy * dy + dz * dz) >= rest_length[j]


@kernel
def vector_tangent(coefficient, weight, rubs, band):
    """Add `weight` times the vector friction of all segments that rub."""
    for j in range(coefficient.shape[0]):
        c = weight * coefficient[j] * rubs[j]
        if c != 0.0:
            add_line(band, j, 0.0, 0.0, 0.0, c, c)


@kernel
def axial_tangent(x, v, coefficient, weight_x, weight_v, rubs, band):
    """Add the derivatives of the axial friction of all segments that rub."""
    for j in range(coefficient.shape[0]):
        c = coefficient[j] * rubs[j]
        dx, dy, dz = x[0, j + 1] - x[0, j], x[1, j + 1] - x[1, j], x[2, j + 1] - x[2, j]
        r = math.sqrt(dx * dx + dy * dy + dz * dz)
        if c == 0.0 or r == 0.0:
            continue
        tx, ty, tz = dx / r, dy / r, dz / r
        ux, uy, uz = v[0, j + 1] - v[0, j], v[1, j + 1] - v[1, j], v[2, j + 1] - v[2, j]
        rate = ux * tx + uy * ty + uz * tz
        q = weight_x * c / r
        add_line(band, j, tx, ty, tz, q * rate, weight_v * c)
        px, py, pz = q * (ux - rate * tx), q * (uy - rate * ty), q * (uz - rate * tz)
        add_turn(band, j, tx, ty, tz, px, py, pz)


@kernel
def axial_lean(x, v, coefficient, weight_v, rubs, over, saddle):
    """Put the same into a saddle: add c/r (u . t) to across, write the rest as lean.

    `over` is 1 / r, (s,), 0 where the ends of a segment coincide.
    """
    x0, x1, x2, v0, v1, v2 = x[0], x[1], x[2], v[0], v[1], v[2]
    across, lean0, lean1, lean2 = saddle.across, saddle.lean[0], saddle.lean[1], saddle.lean[2]
    for j in range(coefficient.shape[0]):
        c = coefficient[j] * rubs[j]
        tx, ty, tz = (
            over[j] * (x0[j + 1] - x0[j]),
            over[j] * (x1[j + 1] - x1[j]),
            over[j] * (x2[j + 1] - x2[j]),
        )
        ux, uy, uz = v0[j + 1] - v0[j], v1[j + 1] - v1[j], v2[j + 1] - v2[j]
        rate, q = ux * tx + uy * ty + uz * tz, c * over[j]
        along = weight_v * c - q * rate
        across[j] += q * rate
        lean0[j] = along * tx + q * ux
        lean1[j] = along * ty + q * uy
        lean2[j] = along * tz + q * uz


@kernel
def growth_tangent(state, winches, weight_x, rubs, band):
    """Add the derivatives of what the growth of the winches' segments takes out of their friction."""
    for row in range(state.winch_exit.shape[0]):
        drum = state.winch_exit[row]
        j = drum if winches.step[row] > 0 else drum - 1
        if state.rest_length[j] == 0.0:  # it has parted
            continue
        c = (state.damping_vector[j] + state.damping_axial[j]) * rubs[j]
        q = -weight_x * c * state.winch_rate[row] / state.rest_length[j]
        add_line(band, j, 0.0, 0.0, 0.0, q, q)


@kernel
def mark_rubbing(x, rest_length, floor, rubs):
    """Write 1 for every segment that has friction, 0 for slack tension-only ones, (s,)."""
    for j in range(rest_length.shape[0]):
        rubs[j] = 1.0 if is_rubbing(x, rest_length, floor, j) else 0.0


@part
def friction_tangent(system, state, x, v, weight_x, weight_v, rubs, band):
    """Add the derivatives of all internal friction of the segments marked in `rubs`, (s,)."""
    vector_tangent(state.damping_vector, weight_v, rubs, band)
    if system.flags[AXIAL] == 1:
        axial_tangent(x, v, state.damping_axial, weight_x, weight_v, rubs, band)
    if winds(system, state):
        growth_tangent(state, system.winches, weight_x, rubs, band)
