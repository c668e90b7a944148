"""Ground as in NeHe's lesson 40, for any direction of up.

Only for nodes strictly below the height: slide friction -c_s v_t (viscous, whatever the load), absorption
-c_a v_n only while sinking, repulsion k_g times the depth upward. Conservative part: U = k_g depth^2 / 2,
counted in the work of the ground, not in the elastic energy.

With a damping ratio z a damper acts, too, both ways, but never pulls:
    -min(c v_n, k_g depth),   c = 2 z sqrt(k_g m)
A node that hits such ground on its own leaves it with exp(-2) = 0.135 of its speed at z = 1, and with
exp(-z (pi - atan(2 z w / (1 - 2 z^2))) / w), w = sqrt(1 - z^2), below z = 1 / sqrt(2).
Source: Schwager & Poeschel 2007, Granular Matter 9:465.
"""

from __future__ import annotations

import math

from ropewalk.core.jit import kernel, small
from ropewalk.core.ranges import ALL, rows


@kernel
def ground_forces(x, v, ground, force, lo=0, hi=ALL):
    """Write the force of the ground on every node [N], (3, n)."""
    ux, uy, uz = ground.up[0], ground.up[1], ground.up[2]
    x0, x1, x2 = rows(x, lo, hi)
    v0, v1, v2 = rows(v, lo, hi)
    f0, f1, f2 = rows(force, lo, hi)
    for i in range(x0.shape[0]):
        depth = ground.height - (x0[i] * ux + x1[i] * uy + x2[i] * uz)
        touching = 1.0 if depth > 0.0 else 0.0
        rise = v0[i] * ux + v1[i] * uy + v2[i] * uz
        sinking = rise if rise < 0.0 else 0.0
        slide = touching * ground.friction
        push = touching * (ground.repulsion * depth - ground.absorption * sinking)
        f0[i] = push * ux - slide * (v0[i] - rise * ux)
        f1[i] = push * uy - slide * (v1[i] - rise * uy)
        f2[i] = push * uz - slide * (v2[i] - rise * uz)


@kernel
def damp_ground(x, v, mass, ground, force, lo=0, hi=ALL):
    """Add the damper's force on every node below the ground's height [N], (3, n)."""
    ux, uy, uz = ground.up[0], ground.up[1], ground.up[2]
    x0, x1, x2 = rows(x, lo, hi)
    v0, v1, v2 = rows(v, lo, hi)
    f0, f1, f2 = rows(force, lo, hi)
    mass = mass[lo:hi]
    for i in range(x0.shape[0]):
        depth = ground.height - (x0[i] * ux + x1[i] * uy + x2[i] * uz)
        if depth > 0.0:
            rise = v0[i] * ux + v1[i] * uy + v2[i] * uz
            push = damper(ground, mass[i], depth, rise)
            f0[i] += push * ux
            f1[i] += push * uy
            f2[i] += push * uz


@kernel
def damp_marked_ground(x, v, mass, ground, touches, force):
    """Add the damper's force on the nodes that are marked [N], (3, n)."""
    ux, uy, uz = ground.up[0], ground.up[1], ground.up[2]
    for i in range(x.shape[1]):
        if touches[i] == 1.0:
            depth = ground.height - (x[0, i] * ux + x[1, i] * uy + x[2, i] * uz)
            rise = v[0, i] * ux + v[1, i] * uy + v[2, i] * uz
            push = damper(ground, mass[i], max(depth, 0.0), rise)
            force[0, i] += push * ux
            force[1, i] += push * uy
            force[2, i] += push * uz


@small
def damper(ground, mass, depth, rise):
    """Return the damper's force upward on a node [N]; it takes away at most what the ground pushes."""
    c = 2.0 * ground.damping_ratio * math.sqrt(ground.repulsion * mass)
    return -min(c * rise, ground.repulsion * depth)


@kernel
def marked_ground_forces(x, v, ground, touches, frozen, force):
    """Write the force of the ground on every node [N], (3, n), friction on those marked only.

    With `frozen` marks the repulsion, too, acts on those marked, beyond the surface as well.
    """
    ux, uy, uz = ground.up[0], ground.up[1], ground.up[2]
    for i in range(x.shape[1]):
        depth = ground.height - (x[0, i] * ux + x[1, i] * uy + x[2, i] * uz)
        rise = v[0, i] * ux + v[1, i] * uy + v[2, i] * uz
        sinking = rise if rise < 0.0 else 0.0
        slide = touches[i] * ground.friction
        pressed = touches[i] * depth if frozen == 1 else max(depth, 0.0)
        push = ground.repulsion * pressed - touches[i] * ground.absorption * sinking
        force[0, i] = push * ux - slide * (v[0, i] - rise * ux)
        force[1, i] = push * uy - slide * (v[1, i] - rise * uy)
        force[2, i] = push * uz - slide * (v[2, i] - rise * uz)


@kernel
def mark_touching(x, ground, touches):
    """Write 1 for every node below the ground's height, else 0, (n,); return how many changed."""
    ux, uy, uz = ground.up[0], ground.up[1], ground.up[2]
    changed = 0.0
    for i in range(x.shape[1]):
        depth = ground.height - (x[0, i] * ux + x[1, i] * uy + x[2, i] * uz)
        touching = 1.0 if depth > 0.0 else 0.0
        changed += abs(touching - touches[i])
        touches[i] = touching
    return changed


@kernel
def ground_tangent(x, v, mass, ground, touches, weight_x, weight_v, band):
    """Add the derivatives of the ground's force on the nodes marked in `touches`, (n,).

    -dF/dx = k_g u u^T,   -dF/dv = c_a u u^T while sinking + c_s (I - u u^T),   u upward;
    with a damper besides -dF/dv = c u u^T, or -dF/dx = 0 where it takes away all that the ground pushes.
    """
    up = ground.up
    for i in range(v.shape[1]):
        if touches[i] == 0.0:
            continue
        rise = v[0, i] * up[0] + v[1, i] * up[1] + v[2, i] * up[2]
        slide = weight_v * ground.friction
        across = weight_x * ground.repulsion - slide
        if rise < 0.0:
            across += weight_v * ground.absorption
        if ground.damping_ratio > 0.0:
            depth = ground.height - (x[0, i] * up[0] + x[1, i] * up[1] + x[2, i] * up[2])
            c = 2.0 * ground.damping_ratio * math.sqrt(ground.repulsion * mass[i])
            if c * rise < ground.repulsion * max(depth, 0.0):
                across += weight_v * c
            elif depth > 0.0:
                across -= weight_x * ground.repulsion
        for k in range(3):
            band.diagonal[i, 4 * k] += slide
            for m in range(3):
                band.diagonal[i, 3 * k + m] += across * up[k] * up[m]
