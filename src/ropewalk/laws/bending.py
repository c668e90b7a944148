"""Bending stiffness: the discrete elastic rod without twist.

At a node the unit vectors a, b along the segments before and after it make the curvature binormal
    kb = 2 a x b / (1 + a . b),   |kb| = 2 tan(turn / 2),
and the energy is U = B |kb - k0|^2 / 2 with B = EI / l, l half the sum of the two rest lengths, k0 that
of the unloaded rope.
Source: Bergou, Wardetzky, Robinson, Audoly & Grinspun 2008, ACM TOG 27(3):63, eqs 1 and 2.

A force per segment: what node j gets from segment j, and node j + 1 with the opposite sign, is dU/de_j,
e_j the vector along the segment, so that it adds no force and (with k0 = 0) no torque to the rope.
    dU/da = 4 B q' b,  q(chi) = 1 / chi,  chi = 1 + a . b    (|kb|^2 = 8 q - 4)
Friction (Kelvin-Voigt): R = D |kb|'^2 / 2, D = damping / l: it acts on the rate at which the bend grows,
not on a bend whose plane turns, so that it leaves rigid rotation alone. A straight node has no plane: there
it acts on the whole rate of kb. Below |kb| = s = STRAIGHT, where rounding turns the plane, it acts on both,
kb^2 / s^2 of the one and the rest of the other.

Two departures keep it finite. Beyond a turn of 120 degrees q goes on along its tangent, so that a fold
stores 14 B instead of infinity. A segment of length r shorter than half its rest length, b, has
a = e / rho with rho = (r^2 + b^2) / 2b in place of r: coincident nodes have a = 0, which stores 2 B and
pushes them apart along their neighbours. Both go on with a continuous force.
"""

from __future__ import annotations

import math

from ropewalk.core.jit import deferred, kernel, part

FOLD = 0.5  # [1] 1 + cos(120 degrees)
PRESSED = 0.5  # [1] of the rest length
SMALL = 1e-3  # [1] |kb| below which its rate is found by the difference of the unit vectors
STRAIGHT = 1e-5  # [1] |kb| below which a node has less of a plane of bending the straighter it is


@part
def tangent(dx, dy, dz, rest):
    """Return a segment's unit vector, 1 / its length [1/m] and the share of its own part to take out.

    The derivative of the unit vector t is (I - share t t^T) / length.
    """
    square = dx * dx + dy * dy + dz * dz
    r = math.sqrt(square)
    half = PRESSED * rest
    if r >= half:
        over = 1.0 / r if r > 0.0 else 0.0
        return dx * over, dy * over, dz * over, over, 1.0
    over = 2.0 * half / (square + half * half)
    return dx * over, dy * over, dz * over, over, 1.0 / (over * half)


@part
def across(ux, uy, uz, tx, ty, tz, over, own):
    """Return the derivative of a segment's unit vector, which is symmetric, times a vector u."""
    along = own * (tx * ux + ty * uy + tz * uz)
    return over * (ux - along * tx), over * (uy - along * ty), over * (uz - along * tz)


@part
def slope_of(chi):
    """Return q'(chi) of q = 1 / chi, constant beyond a turn of 120 degrees."""
    bounded = max(chi, FOLD)
    return -1.0 / (bounded * bounded)


@part
def value_of(chi):
    """Return q(chi)."""
    return 1.0 / chi if chi > FOLD else (2.0 - chi / FOLD) / FOLD


@part
def pulls(B, ax, ay, az, bx, by, bz, kx, ky, kz):
    """Return dU/da and dU/db of one node [N m], neither projected."""
    chi = 1.0 + (ax * bx + ay * by + az * bz)
    slope = slope_of(chi)
    w = 4.0 * B * slope
    if kx == 0.0 and ky == 0.0 and kz == 0.0:
        return w * bx, w * by, w * bz, w * ax, w * ay, w * az
    twist = kx * (ay * bz - az * by) + ky * (az * bx - ax * bz) + kz * (ax * by - ay * bx)
    w -= 2.0 * B * slope * twist
    q = 2.0 * B * value_of(chi)
    return (
        w * bx - q * (by * kz - bz * ky),
        w * by - q * (bz * kx - bx * kz),
        w * bz - q * (bx * ky - by * kx),
        w * ax - q * (ky * az - kz * ay),
        w * ay - q * (kz * ax - kx * az),
        w * az - q * (kx * ay - ky * ax),
    )


@deferred()
def bending_forces(x, rest_length, stiffness, natural, force):
    """Write the bending force of every segment [N], (3, n + 1)."""
    x0, x1, x2 = x[0], x[1], x[2]
    f0, f1, f2 = force[0], force[1], force[2]
    k0, k1, k2 = natural[0], natural[1], natural[2]
    n = stiffness.shape[0]
    ax, ay, az, over_a, own_a = tangent(x0[1] - x0[0], x1[1] - x1[0], x2[1] - x2[0], rest_length[0])
    cx, cy, cz = 0.0, 0.0, 0.0
    for i in range(1, n - 1):
        bx, by, bz, over_b, own_b = tangent(
            x0[i + 1] - x0[i], x1[i + 1] - x1[i], x2[i + 1] - x2[i], rest_length[i]
        )
        px, py, pz, qx, qy, qz = 0.0, 0.0, 0.0, 0.0, 0.0, 0.0
        if stiffness[i] > 0.0:
            px, py, pz, qx, qy, qz = pulls(
                stiffness[i], ax, ay, az, bx, by, bz, k0[i], k1[i], k2[i]
            )
            px, py, pz = across(px, py, pz, ax, ay, az, over_a, own_a)
            qx, qy, qz = across(qx, qy, qz, bx, by, bz, over_b, own_b)
        f0[i], f1[i], f2[i] = cx + px, cy + py, cz + pz
        cx, cy, cz = qx, qy, qz
        ax, ay, az, over_a, own_a = bx, by, bz, over_b, own_b
    f0[n - 1], f1[n - 1], f2[n - 1] = cx, cy, cz


@part
def bend(ax, ay, az, own_a, bx, by, bz, own_b):
    """Return 1 + a . b and |kb|^2 of one node [1], accurate for small bends too."""
    dx, dy, dz = ax - bx, ay - by, az - bz
    fall = dx * dx + dy * dy + dz * dz  # 2 (1 - a . b) of unit vectors
    if own_a != 1.0:
        fall += 1.0 - (ax * ax + ay * ay + az * az)
    if own_b != 1.0:
        fall += 1.0 - (bx * bx + by * by + bz * bz)
    chi = 2.0 - 0.5 * fall
    return chi, (2.0 * fall / chi if chi > FOLD else 8.0 * value_of(chi) - 4.0)


@part
def stored(B, ax, ay, az, own_a, bx, by, bz, own_b, kx, ky, kz):
    """Return the energy of one node [J]."""
    chi, square = bend(ax, ay, az, own_a, bx, by, bz, own_b)
    twist = kx * (ay * bz - az * by) + ky * (az * bx - ax * bz) + kz * (ax * by - ay * bx)
    return 0.5 * B * (square - 4.0 * value_of(chi) * twist + kx * kx + ky * ky + kz * kz)


@kernel
def bending_energy(x, rest_length, stiffness, natural):
    """Return the energy of all bends [J], clamps excluded."""
    total = 0.0
    ax, ay, az, _, own_a = tangent(
        x[0, 1] - x[0, 0], x[1, 1] - x[1, 0], x[2, 1] - x[2, 0], rest_length[0]
    )
    for i in range(1, stiffness.shape[0] - 1):
        bx, by, bz, _, own_b = tangent(
            x[0, i + 1] - x[0, i], x[1, i + 1] - x[1, i], x[2, i + 1] - x[2, i], rest_length[i]
        )
        if stiffness[i] > 0.0:
            kx, ky, kz = natural[0, i], natural[1, i], natural[2, i]
            total += stored(stiffness[i], ax, ay, az, own_a, bx, by, bz, own_b, kx, ky, kz)
        ax, ay, az, own_a = bx, by, bz, own_b
    return total


@part
def rate_of(a, own_a, b, own_b, u, w, square):
    """Return the rate of a . b [1/s] of a node with |kb|^2 = `square`; (u, w) = (a', b').

    The sum is of no use where a small bend turns quickly: it is next to nothing of its parts.
    """
    if square >= SMALL * SMALL:
        return (u[0] * b[0] + u[1] * b[1] + u[2] * b[2]) + (a[0] * w[0] + a[1] * w[1] + a[2] * w[2])
    rate = (a[0] - b[0]) * (w[0] - u[0]) + (a[1] - b[1]) * (w[1] - u[1])
    rate += (a[2] - b[2]) * (w[2] - u[2])
    rate += a[0] * u[0] + a[1] * u[1] + a[2] * u[2] if own_a != 1.0 else 0.0
    return rate + (b[0] * w[0] + b[1] * w[1] + b[2] * w[2] if own_b != 1.0 else 0.0)


@part
def drags(D, ax, ay, az, own_a, bx, by, bz, own_b, ux, uy, uz, wx, wy, wz):
    """Return dR/da' and dR/db' of one node [N m], neither projected; (u, w) = (a', b') [1/s]."""
    chi, square = bend(ax, ay, az, own_a, bx, by, bz, own_b)
    rate = rate_of((ax, ay, az), own_a, (bx, by, bz), own_b, (ux, uy, uz), (wx, wy, wz), square)
    slope = 4.0 * slope_of(chi)
    pull = D * slope * slope * rate / max(square, STRAIGHT * STRAIGHT)
    px, py, pz, qx, qy, qz = pull * bx, pull * by, pull * bz, pull * ax, pull * ay, pull * az
    if square >= STRAIGHT * STRAIGHT:
        return px, py, pz, qx, qy, qz
    D *= 1.0 - square / (STRAIGHT * STRAIGHT)
    dx, dy, dz = D * (wx - ux), D * (wy - uy), D * (wz - uz)
    return px - dx, py - dy, pz - dz, qx + dx, qy + dy, qz + dz


@deferred()
def bending_friction(x, v, rest_length, damping, friction):
    """Add the friction of every bend to the segments' friction [N], (3, n + 1)."""
    f0, f1, f2 = friction[0], friction[1], friction[2]
    ax, ay, az, over_a, own_a = tangent(
        x[0, 1] - x[0, 0], x[1, 1] - x[1, 0], x[2, 1] - x[2, 0], rest_length[0]
    )
    for i in range(1, damping.shape[0] - 1):
        bx, by, bz, over_b, own_b = tangent(
            x[0, i + 1] - x[0, i], x[1, i + 1] - x[1, i], x[2, i + 1] - x[2, i], rest_length[i]
        )
        if damping[i] > 0.0:
            ux, uy, uz = v[0, i] - v[0, i - 1], v[1, i] - v[1, i - 1], v[2, i] - v[2, i - 1]
            ux, uy, uz = across(ux, uy, uz, ax, ay, az, over_a, own_a)
            wx, wy, wz = v[0, i + 1] - v[0, i], v[1, i + 1] - v[1, i], v[2, i + 1] - v[2, i]
            wx, wy, wz = across(wx, wy, wz, bx, by, bz, over_b, own_b)
            px, py, pz, qx, qy, qz = drags(
                damping[i], ax, ay, az, own_a, bx, by, bz, own_b, ux, uy, uz, wx, wy, wz
            )
            px, py, pz = across(px, py, pz, ax, ay, az, over_a, own_a)
            qx, qy, qz = across(qx, qy, qz, bx, by, bz, over_b, own_b)
            f0[i], f1[i], f2[i] = f0[i] + px, f1[i] + py, f2[i] + pz
            f0[i + 1], f1[i + 1], f2[i + 1] = f0[i + 1] + qx, f1[i + 1] + qy, f2[i + 1] + qz
        ax, ay, az, over_a, own_a = bx, by, bz, over_b, own_b
