"""What rounding leaves of large forces that cancel: with less left a stage counts as solved."""

from __future__ import annotations

import math

from ropewalk.core.jit import deferred, kernel, part, small
from ropewalk.laws.bending import STRAIGHT, across, bend, tangent
from ropewalk.laws.nodes import node_rounding
from ropewalk.laws.rare import has_bending, limits

EPSILON = 2.220446049250313e-16


@kernel
def bending_rounding(x, rest_length, stiffness, clamp_stiffness, clamp_length, node):
    """Return what rounding of the places does to the forces of bending [N]: about eps EI |x| / l^3.

    `stiffness` (n,) is that of the bends, `clamp_stiffness` (a, 2) that of the half cells at `node` (a,) of
    segments of `clamp_length` (a,).
    """
    largest, size = 0.0, 0.0
    for i in range(x.shape[1]):
        size = max(size, abs(x[0, i]), abs(x[1, i]), abs(x[2, i]))
    for i in range(1, stiffness.shape[0] - 1):
        if stiffness[i] > 0.0:
            length = min(rest_length[i - 1], rest_length[i])
            largest = max(largest, stiffness[i] / (length * length))
    for row in range(clamp_stiffness.shape[0]):
        for side in range(2):
            if clamp_stiffness[row, side] > 0.0:
                length = rest_length[node[row] - 1 + side]
                if length > 0.0:
                    own = clamp_stiffness[row, side] * clamp_length[row] / length
                    largest = max(largest, own / (length * length))
    return 16.0 * EPSILON * largest * size


@deferred("float64")
def bending_friction_rounding(x, v, rest_length, damping):
    """Return what rounding of the places does to the friction of bends [N], `damping` (n,) that of bends.

    It turns the plane of a bend |kb| by about eps |x| / l |kb|, and with it friction that acts along it.
    """
    largest, size = 0.0, 0.0
    for k in range(3):
        for i in range(x.shape[1]):
            size = max(size, abs(x[k, i]))
    for i in range(1, damping.shape[0] - 1):
        if damping[i] > 0.0:
            ax, ay, az, over_a, own_a = unit(x, rest_length, i - 1)
            bx, by, bz, over_b, own_b = unit(x, rest_length, i)
            ux, uy, uz = v[0, i] - v[0, i - 1], v[1, i] - v[1, i - 1], v[2, i] - v[2, i - 1]
            ux, uy, uz = across(ux, uy, uz, ax, ay, az, over_a, own_a)
            wx, wy, wz = v[0, i + 1] - v[0, i], v[1, i + 1] - v[1, i], v[2, i + 1] - v[2, i]
            wx, wy, wz = across(wx, wy, wz, bx, by, bz, over_b, own_b)
            _, square = bend(ax, ay, az, own_a, bx, by, bz, own_b)
            rate = math.sqrt((wx - ux) ** 2 + (wy - uy) ** 2 + (wz - uz) ** 2)
            over = max(over_a, over_b)
            largest = max(
                largest, damping[i] * rate * over * over / max(math.sqrt(square), STRAIGHT)
            )
    return 16.0 * EPSILON * size * largest


@small
def unit(x, rest_length, j):
    """Return segment `j` as `tangent` does."""
    return tangent(
        x[0, j + 1] - x[0, j], x[1, j + 1] - x[1, j], x[2, j + 1] - x[2, j], rest_length[j]
    )


@kernel
def bound_rounding(limiter):
    """Return what rounding leaves of spring and bound, which cancel where a bound is far from L [N]."""
    largest = 0.0
    for k in range(3):
        for j in range(limiter.shape[1]):
            largest = max(largest, abs(limiter[k, j]))
    return 8.0 * EPSILON * largest


@part
def rounding(system, state, stage):
    """Return the residual that rounding leaves of forces much larger than those of the report's scale [N]."""
    left = node_rounding(system, state, stage.x)
    if has_bending(system):
        clamps, of = system.bending.clamp_stiffness, system.bending.clamp_length
        stiffness, node = state.bending_stiffness, state.anchor_node
        left += bending_rounding(stage.x, state.rest_length, stiffness, clamps, of, node)
    if limits(system):
        left += bound_rounding(stage.forces.limiter)
    return left


@part
def rounding_at_last(system, state, stage, c2):
    """Return what rounding besides leaves, which is asked for where a solution does not come [N]."""
    free, vector, axial = stage.saddle.free, state.damping_vector, state.damping_axial
    left = motion_rounding(stage.v, stage.v_known, state.mass, free, vector, axial, c2)
    if has_bending(system):
        left += bending_friction_rounding(
            stage.x, stage.v, state.rest_length, state.bending_damping
        )
    return left


@kernel
def motion_rounding(v, known, mass, free, vector, axial, c2):
    """Return what rounding of the speeds leaves of inertia and friction that cancel [N].

    It is all that is left of a rope that coasts: the report's scale is then next to nothing.
    """
    left, rubs = 0.0, 0.0
    for k in range(3):
        vk, known_k = v[k], known[k]
        for i in range(mass.shape[0]):
            left = max(left, free[i] * mass[i] * max(abs(vk[i]), abs(known_k[i])))
        for j in range(vector.shape[0]):
            rubs = max(rubs, (vector[j] + axial[j]) * max(abs(vk[j]), abs(vk[j + 1])))
    return 16.0 * EPSILON * (left / c2 + rubs)
