"""Clamps: anchors that hold the direction of the rope at their node, too.

The direction d is that of the rope from its start towards its end. On either side of the node a half
cell of length L/2 bends between d and the segment: U = B |kb - k0|^2 / 2 with B = 2 EI / L, which takes
the place of the node's own bend. The half cell makes it second order in L: a whole one, as a first
segment held at both ends has it, is too soft by half a segment (first order).
It turns by the angle rate (t - start), held to [0, rate (stop - start)], about an axis.

The moment of a clamp on the rope is M = - sum of e x F over its half cells, F the force that the
segment's first node gets. Where the rope has a curvature k0 of its own, whose axis stays fixed in space,
turning all does change U, and the elastic part is M = d x dU/dd, which is the same without k0. Turning it
by an angle p does the work integral of M . dp, the elastic part of which goes into the energy of bending;
it is summed by the trapezoidal rule, exact to second order.
"""

from __future__ import annotations

import math

from ropewalk.core.jit import deferred, kernel, part
from ropewalk.laws.bending import across, bending_energy, drags, pulls, stored, tangent
from ropewalk.laws.rare import has_clamps


@part
def clamp_angle(turn, row, t):
    """Return the angle by which a clamp has turned at time `t` [rad]."""
    return turn[row, 0] * min(max(t - turn[row, 1], 0.0), turn[row, 2] - turn[row, 1])


@deferred()
def point_clamps(held, clamped, first, axis, turn, t, direction, spin):
    """Write the direction [1] and the angular velocity [rad/s] of every clamp at time `t`, (a, 3)."""
    for row in range(clamped.shape[0]):
        if clamped[row] == 0 or held[row] == 0:
            continue
        angle = clamp_angle(turn, row, t)
        c, s = math.cos(angle), math.sin(angle)
        ex, ey, ez = axis[row, 0], axis[row, 1], axis[row, 2]
        dx, dy, dz = first[row, 0], first[row, 1], first[row, 2]
        along = (ex * dx + ey * dy + ez * dz) * (1.0 - c)
        direction[row, 0] = c * dx + s * (ey * dz - ez * dy) + along * ex
        direction[row, 1] = c * dy + s * (ez * dx - ex * dz) + along * ey
        direction[row, 2] = c * dz + s * (ex * dy - ey * dx) + along * ez
        rate = clamp_rate(turn, row, t)
        for k in range(3):
            spin[row, k] = rate * axis[row, k]


@part
def clamp_rate(turn, row, t):
    """Return the rate at which a clamp turns just after time `t` [rad/s]."""
    return turn[row, 0] if turn[row, 1] <= t < turn[row, 2] else 0.0


@deferred("int64")
def spins_jump(held, clamped, axis, turn, t, spin):
    """Return how many numbers of `spin`, (a, 3), are not those just after time `t` [s]."""
    jumps = 0
    for row in range(clamped.shape[0]):
        if clamped[row] == 1 and held[row] == 1:
            rate = clamp_rate(turn, row, t)
            for k in range(3):
                jumps += 0 if spin[row, k] == rate * axis[row, k] else 1
    return jumps


@part
def clamps_turn(system, state):
    """Tell whether any clamp turns."""
    if has_clamps(system, state):
        spin = state.clamp_spin
        for row in range(spin.shape[0]):
            for k in range(3):
                if spin[row, k] != 0.0:
                    return True
    return False


@part
def half_cell(x, v, rest_length, j, side, row, bending, direction, spin):
    """Return what the first node of segment `j` gets, elastically and by friction [N], and dU/dd [N m]."""
    share = bending.clamp_length[row] / rest_length[j]  # a winch changes lengths
    B, D = share * bending.clamp_stiffness[row, side], share * bending.clamp_damping[row, side]
    dx, dy, dz = direction[row, 0], direction[row, 1], direction[row, 2]
    sx, sy, sz = spin[row, 0], spin[row, 1], spin[row, 2]
    rx, ry, rz = sy * dz - sz * dy, sz * dx - sx * dz, sx * dy - sy * dx
    kx = bending.clamp_natural[row, 3 * side]
    ky = bending.clamp_natural[row, 3 * side + 1]
    kz = bending.clamp_natural[row, 3 * side + 2]
    tx, ty, tz, over, own = tangent(
        x[0, j + 1] - x[0, j], x[1, j + 1] - x[1, j], x[2, j + 1] - x[2, j], rest_length[j]
    )
    ux, uy, uz = v[0, j + 1] - v[0, j], v[1, j + 1] - v[1, j], v[2, j + 1] - v[2, j]
    ux, uy, uz = across(ux, uy, uz, tx, ty, tz, over, own)
    if side == 0:
        px, py, pz, gx, gy, gz = pulls(B, tx, ty, tz, dx, dy, dz, kx, ky, kz)
        fx, fy, fz, _, _, _ = drags(D, tx, ty, tz, own, dx, dy, dz, 1.0, ux, uy, uz, rx, ry, rz)
    else:
        gx, gy, gz, px, py, pz = pulls(B, dx, dy, dz, tx, ty, tz, kx, ky, kz)
        _, _, _, fx, fy, fz = drags(D, dx, dy, dz, 1.0, tx, ty, tz, own, rx, ry, rz, ux, uy, uz)
    px, py, pz = across(px, py, pz, tx, ty, tz, over, own)
    fx, fy, fz = across(fx, fy, fz, tx, ty, tz, over, own)
    return px, py, pz, fx, fy, fz, gx, gy, gz


@deferred()
def clamp_forces(x, v, rest_length, held, node, bending, direction, spin, elastic, friction):
    """Add the forces of all half cells to the segments' elastic bending and friction [N], (3, n + 1)."""
    for row in range(held.shape[0]):
        if bending.clamped[row] == 0 or held[row] == 0:
            continue
        for side in range(2):
            j = node[row] - 1 + side
            if bending.clamp_stiffness[row, side] == 0.0 or rest_length[j] == 0.0:  # it has parted
                continue
            px, py, pz, fx, fy, fz, _, _, _ = half_cell(
                x, v, rest_length, j, side, row, bending, direction, spin
            )
            elastic[0, j + 1] += px
            elastic[1, j + 1] += py
            elastic[2, j + 1] += pz
            friction[0, j + 1] += fx
            friction[1, j + 1] += fy
            friction[2, j + 1] += fz


@kernel
def clamp_energy(x, rest_length, held, node, bending, direction):
    """Return the energy of all half cells [J]."""
    total = 0.0
    for row in range(held.shape[0]):
        if bending.clamped[row] == 0 or held[row] == 0:
            continue
        dx, dy, dz = direction[row, 0], direction[row, 1], direction[row, 2]
        for side in range(2):
            j = node[row] - 1 + side
            if bending.clamp_stiffness[row, side] == 0.0 or rest_length[j] == 0.0:  # it has parted
                continue
            tx, ty, tz, _, own = tangent(
                x[0, j + 1] - x[0, j], x[1, j + 1] - x[1, j], x[2, j + 1] - x[2, j], rest_length[j]
            )
            B = bending.clamp_stiffness[row, side] * bending.clamp_length[row] / rest_length[j]
            kx = bending.clamp_natural[row, 3 * side]
            ky = bending.clamp_natural[row, 3 * side + 1]
            kz = bending.clamp_natural[row, 3 * side + 2]
            if side == 0:
                total += stored(B, tx, ty, tz, own, dx, dy, dz, 1.0, kx, ky, kz)
            else:
                total += stored(B, dx, dy, dz, 1.0, tx, ty, tz, own, kx, ky, kz)
    return total


@part
def is_curled(natural, row, side):
    """Tell whether a half cell has a curvature of its own."""
    return (
        natural[row, 3 * side] != 0.0
        or natural[row, 3 * side + 1] != 0.0
        or natural[row, 3 * side + 2] != 0.0
    )


@deferred()
def clamp_moments(x, v, rest_length, held, node, bending, direction, spin, moment):
    """Write every clamp's moment on the rope [N m], (a, 6): elastic part, then friction's."""
    for row in range(held.shape[0]):
        if bending.clamped[row] == 0 or held[row] == 0:
            continue
        for k in range(6):
            moment[row, k] = 0.0
        for side in range(2):
            j = node[row] - 1 + side
            if bending.clamp_stiffness[row, side] == 0.0 or rest_length[j] == 0.0:  # it has parted
                continue
            px, py, pz, fx, fy, fz, gx, gy, gz = half_cell(
                x, v, rest_length, j, side, row, bending, direction, spin
            )
            ex, ey, ez = x[0, j + 1] - x[0, j], x[1, j + 1] - x[1, j], x[2, j + 1] - x[2, j]
            if is_curled(bending.clamp_natural, row, side):
                dx, dy, dz = direction[row, 0], direction[row, 1], direction[row, 2]
                moment[row, 0] += dy * gz - dz * gy
                moment[row, 1] += dz * gx - dx * gz
                moment[row, 2] += dx * gy - dy * gx
            else:
                moment[row, 0] += py * ez - pz * ey
                moment[row, 1] += pz * ex - px * ez
                moment[row, 2] += px * ey - py * ex
            moment[row, 3] += fy * ez - fz * ey
            moment[row, 4] += fz * ex - fx * ez
            moment[row, 5] += fx * ey - fy * ex


@part
def turn_clamps(system, state, t):
    """Turn all clamps to where they are at time `t`."""
    if has_clamps(system, state):
        bending = system.bending
        point_clamps(
            state.held,
            bending.clamped,
            bending.direction,
            bending.axis,
            bending.turn,
            t,
            state.clamp_direction,
            state.clamp_spin,
        )


@part
def measure_clamps(system, state):
    """Write the moments of all clamps at the state itself."""
    if has_clamps(system, state):
        clamp_moments(
            state.x,
            state.v,
            state.rest_length,
            state.held,
            state.anchor_node,
            system.bending,
            state.clamp_direction,
            state.clamp_spin,
            state.moment,
        )


@part
def close_clamps(system, state, t, dt):
    """Turn all clamps to the end of the step at time `t`; write their moments, book their work."""
    if has_clamps(system, state):
        book_turns(system.bending, state.moment, state.held, t, dt, state.work.clamps)
        turn_clamps(system, state, t)
        measure_clamps(system, state)
        book_turns(system.bending, state.moment, state.held, t, dt, state.work.clamps)
        for row in range(state.held.shape[0]):
            done = abs(state.work.anchors[row]) + abs(state.work.clamps[row])
            state.most[row] = max(state.most[row], done)


@deferred()
def book_turns(bending, moment, held, t, dt, work):
    """Add half of what the present moments do during the turn of the step that ends at `t` [J]."""
    for row in range(held.shape[0]):
        if bending.clamped[row] == 1 and held[row] == 1:
            turned = clamp_angle(bending.turn, row, t) - clamp_angle(bending.turn, row, t - dt)
            for k in range(3):
                work[row] += 0.5 * turned * bending.axis[row, k] * moment[row, k]


@deferred("float64")
def bent_energy(system, state, x):
    """Return the energy of all bends and half cells at places `x` (3, n) [J], clamps as they are now."""
    total = bending_energy(x, state.rest_length, state.bending_stiffness, system.bending.natural)
    if has_clamps(system, state):
        total += clamp_energy(
            x,
            state.rest_length,
            state.held,
            state.anchor_node,
            system.bending,
            state.clamp_direction,
        )
    return total


@kernel
def start_clamps(system, state):
    """Point all clamps as at time zero and write their moments (for the host)."""
    measure_clamps(system, state)


@deferred()
def let_bend(system, state, row):
    """Turn the half cells of a clamp that is let go into a bend; what they stored more is its work."""
    i = state.anchor_node[row]
    before = bent_energy(system, state, state.x)
    state.held[row] = 0
    if (
        system.bending.stiffness[i] > 0.0
        and min(state.rest_length[i - 1], state.rest_length[i]) > 0.0
    ):
        state.bending_stiffness[i] = system.bending.stiffness[i]
        state.bending_damping[i] = system.bending.damping[i]
    for k in range(6):
        state.moment[row, k] = 0.0
    state.work.clamps[row] += bent_energy(system, state, state.x) - before
