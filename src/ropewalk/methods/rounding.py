"""What rounding leaves of large forces that cancel: with less left a stage counts as solved."""

from __future__ import annotations

from ropewalk.core.jit import kernel, part
from ropewalk.laws.nodes import node_rounding
from ropewalk.laws.rare import has_bending, limits

EPSILON = 2.220446049250313e-16


@kernel
def bending_rounding(x, rest_length, stiffness, clamp_stiffness, node):
    """Return what rounding of the places does to the forces of bending [N]: about eps EI |x| / l^3.

    `stiffness` (n,) is that of the bends, `clamp_stiffness` (a, 2) that of the half cells at `node` (a,).
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
                    largest = max(largest, clamp_stiffness[row, side] / (length * length))
    return 16.0 * EPSILON * largest * size


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
        clamps, node = system.bending.clamp_stiffness, state.anchor_node
        stiffness = state.bending_stiffness
        left += bending_rounding(stage.x, state.rest_length, stiffness, clamps, node)
    if limits(system):
        left += bound_rounding(stage.forces.limiter)
    return left


@kernel
def motion_rounding(v, known, mass, free, damping, c2):
    """Return what rounding of the speeds leaves of inertia and vector friction that cancel [N].

    It is all that is left of a rope that coasts: the report's scale is then next to nothing.
    """
    left, rubs = 0.0, 0.0
    for k in range(3):
        vk, known_k = v[k], known[k]
        for i in range(mass.shape[0]):
            left = max(left, free[i] * mass[i] * max(abs(vk[i]), abs(known_k[i])))
        for j in range(damping.shape[0]):
            rubs = max(rubs, damping[j] * max(abs(vk[j]), abs(vk[j + 1])))
    return 16.0 * EPSILON * (left / c2 + rubs)
