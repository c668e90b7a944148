"""Stretch limiter after Habrador's rope, with the velocities corrected too.

After a step, segment by segment from the anchors outward, the outer node is moved so that the stretch r/L
stays between two bounds. In the original only positions move, so that a rope at rest keeps large velocities.
Here the part of the relative velocity that would drive the segment further out of bounds is removed as well
(an inelastic stop: momentum is taken up by the same nodes that are moved, energy never grows).
"""

from __future__ import annotations

import math

from ropewalk.core.jit import kernel
from ropewalk.laws.ledger import gravity_energy, kinetic_energy
from ropewalk.laws.stretch import elastic_energy


@kernel
def limit_stretch(system, state, ledger):
    """Bring every segment's stretch within bounds, and book what that costs."""
    if system.limiter.active == 0:
        return
    kinetic, potential = 0.0, 0.0
    if ledger:
        kinetic = kinetic_energy(state.v, state.mass)
        potential = _potential(system, state)
    for _ in range(system.limiter.passes):
        sweep(system, state)
    if ledger:
        state.work.limiter[0] += kinetic_energy(state.v, state.mass) - kinetic
        state.work.limiter[1] += _potential(system, state) - potential


@kernel
def _potential(system, state):
    return gravity_energy(state.x, state.mass, system.gravity) + elastic_energy(
        state.x, state.rest_length, state.stiffness, system.slack_floor
    )


@kernel
def sweep(system, state):
    """Correct every segment once, in the order of the table."""
    limiter = system.limiter
    x, v = state.x, state.v
    for row in range(limiter.order.shape[0]):
        j = limiter.order[row]
        share = limiter.share[row]
        if state.inverse_mass[j] == 0.0:
            share = 0.0
        elif state.inverse_mass[j + 1] == 0.0:
            share = 1.0
        if state.inverse_mass[j] == 0.0 and state.inverse_mass[j + 1] == 0.0:
            continue
        dx = x[0, j + 1] - x[0, j]
        dy = x[1, j + 1] - x[1, j]
        dz = x[2, j + 1] - x[2, j]
        r = math.sqrt(dx * dx + dy * dy + dz * dz)
        if r == 0.0:
            continue
        length = state.rest_length[j]
        wanted = min(max(r, limiter.shortest * length), limiter.longest * length)
        if wanted == r:
            continue
        dx, dy, dz = dx / r, dy / r, dz / r
        shift = wanted - r
        speed = (
            (v[0, j + 1] - v[0, j]) * dx
            + (v[1, j + 1] - v[1, j]) * dy
            + (v[2, j + 1] - v[2, j]) * dz
        )
        stop = -speed if speed * shift < 0.0 else 0.0
        low, high = share, 1.0 - share
        x[0, j] -= low * shift * dx
        x[1, j] -= low * shift * dy
        x[2, j] -= low * shift * dz
        x[0, j + 1] += high * shift * dx
        x[1, j + 1] += high * shift * dy
        x[2, j + 1] += high * shift * dz
        v[0, j] -= low * stop * dx
        v[1, j] -= low * stop * dy
        v[2, j] -= low * stop * dz
        v[0, j + 1] += high * stop * dx
        v[1, j + 1] += high * stop * dy
        v[2, j + 1] += high * stop * dz
