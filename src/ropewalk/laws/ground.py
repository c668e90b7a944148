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
from typing import TYPE_CHECKING, Any, NamedTuple

import numpy as np

from ropewalk.core.arrays import Floats
from ropewalk.core.jit import deferred, kernel, part, small
from ropewalk.core.ranges import ALL, rows
from ropewalk.laws.events import end_of_crossing, end_of_pressing
from ropewalk.laws.node_law import NodeLaw, Rest, always

if TYPE_CHECKING:
    from ropewalk.methods.bound import Chain
    from ropewalk.scene import Ground as GroundInScene


class Ground(NamedTuple):
    """Ground as NeHe's lesson 40 has it, per node."""

    active: int
    up: Floats  # (3,) unit vector
    height: float  # [m] along `up`
    repulsion: float  # [N/m]
    friction: float  # [N s/m]
    absorption: float  # [N s/m]
    damping_ratio: float  # [1] of every node on its own, both ways; 0 without


def lower(ground: GroundInScene | None, upward: tuple[float, float, float]) -> Ground:
    """Return the table of a scene's ground."""
    up = np.array(upward)
    if ground is None:
        return Ground(0, up, 0.0, 0.0, 0.0, 0.0, 0.0)
    numbers = ground.height, ground.repulsion, ground.friction, ground.absorption
    return Ground(1, up, *numbers, ground.damping_ratio)


def acts(ground: Ground) -> bool:
    """Tell whether there is any ground."""
    return ground.active == 1


@part
def force(ground, state, x, v, force, lo, hi):
    """Write the force of the ground on every node [N], (3, n)."""
    ground_forces(x, v, ground, force, lo, hi)
    if ground.damping_ratio > 0.0:
        damp_ground(x, v, state.mass, ground, force, lo, hi)


@part
def marked_force(ground, state, x, v, marks, frozen, force):
    """Write the force of the ground on every node [N], (3, n), for the nodes that are marked."""
    marked_ground_forces(x, v, ground, marks, frozen, force)
    if ground.damping_ratio > 0.0:
        damp_marked_ground(x, v, state.mass, ground, marks, force)


@part
def mark(ground, x, marks):
    """Mark the nodes below the ground's height; return how many marks changed."""
    return mark_touching(x, ground, marks)


@part
def tangent(ground, state, x, v, weight_x, weight_v, marks, band):
    """Add the derivatives of the force on the nodes that are marked."""
    ground_tangent(x, v, state.mass, ground, marks, weight_x, weight_v, band)


@part
def crossings(ground, before, after, dt, tolerance):
    """Return where a step is to end [s], inf: where it does, and how many nodes have changed sides."""
    end, changes = ground_crossings(
        before.x, before.v, after.x, after.v, after.inverse_mass, ground, dt, tolerance
    )
    if ground.damping_ratio > 0.0:
        leaving = ground_leaving(before, after, ground, dt, tolerance)
        changes += 1 if leaving < math.inf else 0
        end = min(end, leaving)
    return end, changes


@part
def hold_up(ground, x, v):
    """Put a point below the ground's height on it, (3,) each; it no longer sinks."""
    up = ground.up
    depth = ground.height - (x[0] * up[0] + x[1] * up[1] + x[2] * up[2])
    if depth > 0.0:
        rise = v[0] * up[0] + v[1] * up[1] + v[2] * up[2]
        for k in range(3):
            x[k] += depth * up[k]
            v[k] -= rise * up[k]


@part
def energy(ground, state, x):
    """Return the energy of the ground's springs [J]."""
    return ground_energy(x, ground)


@deferred()
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


@deferred()
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


@deferred()
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


@deferred()
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


@deferred("float64")
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


@deferred()
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


@kernel
def ground_crossings(x0, v0, x1, v1, inverse_mass, ground, dt, tolerance):
    """Return where the step is to end for the ground [s], inf: where it does, and the changes of sides."""
    ux, uy, uz = ground.up[0], ground.up[1], ground.up[2]
    end, changes = math.inf, 0
    for i in range(inverse_mass.shape[0]):
        before = ground.height - (x0[0, i] * ux + x0[1, i] * uy + x0[2, i] * uz)
        after = ground.height - (x1[0, i] * ux + x1[1, i] * uy + x1[2, i] * uz)
        if inverse_mass[i] == 0.0 or (before > 0.0) == (after > 0.0):
            continue
        changes += 1
        rate0 = -(v0[0, i] * ux + v0[1, i] * uy + v0[2, i] * uz)
        rate1 = -(v1[0, i] * ux + v1[1, i] * uy + v1[2, i] * uz)
        end = min(end, end_of_crossing(before, rate0, after, rate1, dt, tolerance))
    return end, changes


@deferred("float64")
def ground_leaving(before, after, ground, dt, tolerance):
    """Return where the step is to end [s] in which the damper begins, or ceases, to take all that pushes."""
    end, k, up = math.inf, ground.repulsion, ground.up
    for i in range(after.inverse_mass.shape[0]):
        if after.inverse_mass[i] == 0.0:
            continue
        lag = 2.0 * ground.damping_ratio * math.sqrt(before.mass[i] / k)  # c / k [s]
        depth, rise = seen_upward(ground, before, i)
        deep, fast = seen_upward(ground, after, i)
        e, e1 = depth - lag * rise, deep - lag * fast
        if not depth > 0.0 or (e > 0.0) == (e1 > 0.0):
            continue
        a = before.acceleration
        pull = a[0, i] * up[0] + a[1, i] * up[1] + a[2, i] * up[2]
        quick = math.sqrt(k * after.inverse_mass[i])
        rate = -rise - lag * pull
        end = min(end, end_of_pressing(e, rate, math.inf, e1, dt, quick, tolerance))
    return end


@kernel
def seen_upward(ground, state, i):
    """Return how deep a node is in the ground [m], and how fast it rises [m/s]."""
    x, v, up = state.x, state.v, ground.up
    depth = ground.height - (x[0, i] * up[0] + x[1, i] * up[1] + x[2, i] * up[2])
    return depth, v[0, i] * up[0] + v[1, i] * up[1] + v[2, i] * up[2]


@deferred("float64")
def ground_energy(x, ground):
    """Return the energy of the ground's springs [J]."""
    ux, uy, uz = ground.up[0], ground.up[1], ground.up[2]
    total = 0.0
    for i in range(x.shape[1]):
        depth = ground.height - (x[0, i] * ux + x[1, i] * uy + x[2, i] * uz)
        if depth > 0.0:
            total += 0.5 * ground.repulsion * depth * depth
    return total


def at_rest(ground: Ground) -> Rest:
    """It bears what lies on it."""
    return Rest.BEARS


def below(ground: Ground, x: Floats) -> Any:
    """Return which nodes are below the ground's height, (n,)."""
    return ground.up @ x < ground.height


def cases(ground: Ground, chain: Chain) -> dict[str, Chain]:
    """Return a chain with all its nodes on the ground, pressed to it and sliding."""
    twice = 2.0 * ground.damping_ratio
    damping = chain.node_damping
    pressed = chain._replace(
        node_stiffness=chain.node_stiffness + ground.repulsion,
        node_damping=damping + ground.absorption + twice * np.sqrt(ground.repulsion * chain.mass),
    )
    sliding = chain._replace(node_damping=damping + ground.friction)
    return {"pressed to the ground": pressed, "sliding on the ground": sliding}


GROUND = NodeLaw(
    name="ground",
    section="ground",
    lower=lower,
    inputs=("up",),
    acts=acts,
    force=force,
    tangent=tangent,
    is_local=always,
    mark=mark,
    marked_force=marked_force,
    crossings=crossings,
    hold_up=hold_up,
    energy=energy,
    at_rest=at_rest,
    bears=below,
    cases=cases,
)
