"""Derivatives of the forces of bending and its friction; see `bending` and `clamps` for the laws.

At a node let a, b be the unit vectors before and after it, D_a = da/de_a (symmetric), p = D_a b,
q = D_b a and chi = 1 + a . b. A force that follows from a function F(chi) has on the segments before and
after the node the derivatives
    F'' p p^T + F' T_a(b)    F'' p q^T + F' D_a D_b
    F'' q p^T + F' D_b D_a   F'' q q^T + F' T_b(a)        T_a(u) = d(D_a u)/de_a
Elastic: F = B |kb|^2 / 2. Friction D s' ds/dt with s = |kb|: its rate adds to F' and F'', and how its rate
changes with the places makes the matrix unsymmetric. At a straight node, where the plane of bending jumps,
only the derivatives of friction with the velocities are given. Natural curvature adds those of -B kb . k0.
"""

from __future__ import annotations

import math

from ropewalk.core.jit import kernel, part
from ropewalk.laws.bending import FOLD, STRAIGHT, across, bend, slope_of, tangent, value_of


@part
def turn_of(ux, uy, uz, tx, ty, tz, over, own, wx, wy, wz):
    """Return T_t(u) w, the change of D_t u along w."""
    tu = tx * ux + ty * uy + tz * uz
    tw = tx * wx + ty * wy + tz * wz
    uw = ux * wx + uy * wy + uz * wz
    near = own * over * over
    far = (3.0 if own == 1.0 else 2.0 * own * own) * over * over * tu * tw
    along = far - near * uw
    return (
        along * tx - near * (tw * ux + tu * wx),
        along * ty - near * (tw * uy + tu * wy),
        along * tz - near * (tw * uz + tu * wz),
    )


@part
def twice(u, t, over, own, same, k, m):
    """Return entry (k, m) of T_t(u); `u` and `t` are triples."""
    tu = t[0] * u[0] + t[1] * u[1] + t[2] * u[2]
    near = own * over * over
    far = (3.0 if own == 1.0 else 2.0 * own * own) * over * over * tu
    return far * t[k] * t[m] - near * (u[k] * t[m] + t[k] * u[m] + tu * same)


@part
def curve_of(chi):
    """Return q''(chi) of q = 1 / chi, 0 beyond a turn of 120 degrees."""
    return 2.0 / (chi * chi * chi) if chi > FOLD else 0.0


@part
def add_node(band, i, c1, c2, a, over_a, own_a, b, over_b, own_b, p, q, y, z):
    """Add the derivatives of one node's bend: c1 F', c2 F'', p y^T and so on."""
    c = a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
    both = c1 * over_a * over_b
    for k in range(3):
        for m in range(3):
            at = 3 * k + m
            same = 1.0 if k == m else 0.0
            before = c2 * p[k] * p[m] + c1 * twice(b, a, over_a, own_a, same, k, m) + p[k] * y[m]
            after = c2 * q[k] * q[m] + c1 * twice(a, b, over_b, own_b, same, k, m) + q[k] * z[m]
            plain = same - own_a * a[k] * a[m] - own_b * b[k] * b[m]
            mixed = own_a * own_b * c
            up = c2 * p[k] * q[m] + both * (plain + mixed * a[k] * b[m]) + p[k] * z[m]
            low = c2 * q[k] * p[m] + both * (plain + mixed * b[k] * a[m]) + q[k] * y[m]
            add_entry(band, i, at, before, up, low, after)


@part
def add_entry(band, i, at, before, up, low, after):
    """Add one entry of the derivatives on both segments of node `i` to the rows of its three nodes."""
    band.diagonal[i - 1, at] += before
    band.upper1[i - 1, at] += up - before
    band.upper2[i - 1, at] -= up
    band.lower1[i - 1, at] += low - before
    band.diagonal[i, at] += before - up - low + after
    band.upper1[i, at] += up - after
    band.lower2[i - 1, at] -= low
    band.lower1[i, at] += low - after
    band.diagonal[i + 1, at] += after


@part
def add_natural(band, i, ct, cct, a, over_a, own_a, b, over_b, own_b, p, q, n):
    """Add what natural curvature n has besides its parts of F' and F''; ct = dU/dtau, cct = dct/dchi.

    U holds ct tau with tau = n . (a x b).
    """
    g = (b[1] * n[2] - b[2] * n[1], b[2] * n[0] - b[0] * n[2], b[0] * n[1] - b[1] * n[0])
    h = (n[1] * a[2] - n[2] * a[1], n[2] * a[0] - n[0] * a[2], n[0] * a[1] - n[1] * a[0])
    r = across(g[0], g[1], g[2], a[0], a[1], a[2], over_a, own_a)
    s = across(h[0], h[1], h[2], b[0], b[1], b[2], over_b, own_b)
    tau = a[0] * g[0] + a[1] * g[1] + a[2] * g[2]
    turn = (0.0, -n[2], n[1], n[2], 0.0, -n[0], -n[1], n[0], 0.0)
    both = ct * over_a * over_b
    for k in range(3):
        for m in range(3):
            at, back = 3 * k + m, 3 * m + k
            same = 1.0 if k == m else 0.0
            before = cct * (p[k] * r[m] + r[k] * p[m])
            before += ct * twice(g, a, over_a, own_a, same, k, m)
            after = cct * (q[k] * s[m] + s[k] * q[m])
            after += ct * twice(h, b, over_b, own_b, same, k, m)
            up = cct * (p[k] * s[m] + r[k] * q[m]) - both * (
                turn[at]
                + own_a * a[k] * h[m]
                + own_b * g[k] * b[m]
                - own_a * own_b * tau * a[k] * b[m]
            )
            low = cct * (p[m] * s[k] + r[m] * q[k]) - both * (
                turn[back]
                + own_a * a[m] * h[k]
                + own_b * g[m] * b[k]
                - own_a * own_b * tau * a[m] * b[k]
            )
            add_entry(band, i, at, before, up, low, after)


@kernel
def bending_tangent(x, v, rest_length, stiffness, damping, natural, weight_x, weight_v, band):
    """Add -(weight_x dF/dx + weight_v dF/dv) of all bends and their friction to the band."""
    x0, x1, x2 = x[0], x[1], x[2]
    ax, ay, az, over_a, own_a = tangent(x0[1] - x0[0], x1[1] - x1[0], x2[1] - x2[0], rest_length[0])
    for i in range(1, stiffness.shape[0] - 1):
        bx, by, bz, over_b, own_b = tangent(
            x0[i + 1] - x0[i], x1[i + 1] - x1[i], x2[i + 1] - x2[i], rest_length[i]
        )
        if stiffness[i] > 0.0:
            a, b = (ax, ay, az), (bx, by, bz)
            p = across(bx, by, bz, ax, ay, az, over_a, own_a)
            q = across(ax, ay, az, bx, by, bz, over_b, own_b)
            chi, square = bend(ax, ay, az, own_a, bx, by, bz, own_b)
            B = weight_x * stiffness[i]
            slope, curve = slope_of(chi), curve_of(chi)
            kx, ky, kz = natural[0, i], natural[1, i], natural[2, i]
            tau = kx * (ay * bz - az * by) + ky * (az * bx - ax * bz) + kz * (ax * by - ay * bx)
            c1, c2 = B * slope * (4.0 - 2.0 * tau), B * curve * (4.0 - 2.0 * tau)
            if kx != 0.0 or ky != 0.0 or kz != 0.0:
                ct, cct = -2.0 * B * value_of(chi), -2.0 * B * slope
                add_natural(
                    band, i, ct, cct, a, over_a, own_a, b, over_b, own_b, p, q, (kx, ky, kz)
                )
            y, z = (0.0, 0.0, 0.0), (0.0, 0.0, 0.0)
            if damping[i] > 0.0:
                u = (v[0, i] - v[0, i - 1], v[1, i] - v[1, i - 1], v[2, i] - v[2, i - 1])
                w = (v[0, i + 1] - v[0, i], v[1, i + 1] - v[1, i], v[2, i + 1] - v[2, i])
                da = across(u[0], u[1], u[2], ax, ay, az, over_a, own_a)
                db = across(w[0], w[1], w[2], bx, by, bz, over_b, own_b)
                change = da[0] * bx + da[1] * by + da[2] * bz + ax * db[0] + ay * db[1] + az * db[2]
                f1, f2, first, second = drag_parts(
                    damping[i], weight_x, weight_v, chi, square, change
                )
                c1, c2 = c1 + f1, c2 + f2
                scale = weight_x * damping[i] * first
                y = drag_rate(a, over_a, own_a, b, p, u, db, scale, first, second, change)
                z = drag_rate(b, over_b, own_b, a, q, w, da, scale, first, second, change)
            add_node(band, i, c1, c2, a, over_a, own_a, b, over_b, own_b, p, q, y, z)
        ax, ay, az, over_a, own_a = bx, by, bz, over_b, own_b


@part
def drag_parts(D, weight_x, weight_v, chi, square, change):
    """Return a node's friction's parts of F' and F'', and s' and s'' of s = |kb|, 0 where straight."""
    if not square > STRAIGHT * STRAIGHT:
        return -weight_v * D, 0.0, 0.0, 0.0
    s = math.sqrt(square)
    first = 4.0 * slope_of(chi) / s
    second = 4.0 * curve_of(chi) / s - first * first / s
    pull = weight_x * D * first * change
    return pull * first, pull * second + weight_v * D * first * first, first, second


@part
def drag_rate(t, over, own, o, p, u, turned, scale, first, second, change):
    """Return how the rate of s changes with segment t's vector, times `scale`; `o` is the other one.

    `u` is the segment's rate [m/s] and `turned` that of the other's unit vector [1/s].
    """
    ex, ey, ez = turn_of(o[0], o[1], o[2], t[0], t[1], t[2], over, own, u[0], u[1], u[2])
    fx, fy, fz = across(turned[0], turned[1], turned[2], t[0], t[1], t[2], over, own)
    return (
        scale * (second * change * p[0] + first * (ex + fx)),
        scale * (second * change * p[1] + first * (ey + fy)),
        scale * (second * change * p[2] + first * (ez + fz)),
    )


@kernel
def clamp_tangent(x, v, rest_length, state, bending, weight_x, weight_v, band):
    """Add the derivatives of all half cells at clamps."""
    for row in range(state.held.shape[0]):
        if bending.clamped[row] == 0 or state.held[row] == 0:
            continue
        for side in range(2):
            if bending.clamp_stiffness[row, side] > 0.0:
                j = state.anchor_node[row] - 1 + side
                half_cell_tangent(
                    x, v, rest_length, j, side, row, state, bending, weight_x, weight_v, band
                )


@part
def half_cell_tangent(x, v, rest_length, j, side, row, state, bending, weight_x, weight_v, band):
    """Add the derivatives of one half cell on segment `j`, the direction as a segment that stays."""
    direction, spin = state.clamp_direction, state.clamp_spin
    d = (direction[row, 0], direction[row, 1], direction[row, 2])
    sx, sy, sz = spin[row, 0], spin[row, 1], spin[row, 2]
    turned = (sy * d[2] - sz * d[1], sz * d[0] - sx * d[2], sx * d[1] - sy * d[0])
    tx, ty, tz, over, own = tangent(
        x[0, j + 1] - x[0, j], x[1, j + 1] - x[1, j], x[2, j + 1] - x[2, j], rest_length[j]
    )
    t = (tx, ty, tz)
    u = (v[0, j + 1] - v[0, j], v[1, j + 1] - v[1, j], v[2, j + 1] - v[2, j])
    p = across(d[0], d[1], d[2], tx, ty, tz, over, own)
    chi, square = bend(tx, ty, tz, own, d[0], d[1], d[2], 1.0)
    dt = across(u[0], u[1], u[2], tx, ty, tz, over, own)
    change = turned[0] * tx + turned[1] * ty + turned[2] * tz
    change += d[0] * dt[0] + d[1] * dt[1] + d[2] * dt[2]
    B, D = weight_x * bending.clamp_stiffness[row, side], bending.clamp_damping[row, side]
    sign = -1.0 if side == 0 else 1.0  # tau = n . (d x t), or n . (t x d) before the node
    nx = sign * bending.clamp_natural[row, 3 * side]
    ny = sign * bending.clamp_natural[row, 3 * side + 1]
    nz = sign * bending.clamp_natural[row, 3 * side + 2]
    h = (ny * d[2] - nz * d[1], nz * d[0] - nx * d[2], nx * d[1] - ny * d[0])
    r = across(h[0], h[1], h[2], tx, ty, tz, over, own)
    tau = h[0] * tx + h[1] * ty + h[2] * tz
    slope = slope_of(chi)
    c1, c2 = B * slope * (4.0 - 2.0 * tau), B * curve_of(chi) * (4.0 - 2.0 * tau)
    ct, cct = -2.0 * B * value_of(chi), -2.0 * B * slope
    f1, f2, first, second = drag_parts(D, weight_x, weight_v, chi, square, change)
    c1, c2 = c1 + f1, c2 + f2
    y = drag_rate(t, over, own, d, p, u, turned, weight_x * D * first, first, second, change)
    for k in range(3):
        for m in range(3):
            same = 1.0 if k == m else 0.0
            value = c2 * p[k] * p[m] + c1 * twice(d, t, over, own, same, k, m) + p[k] * y[m]
            value += cct * (p[k] * r[m] + r[k] * p[m]) + ct * twice(h, t, over, own, same, k, m)
            at = 3 * k + m
            band.diagonal[j, at] += value
            band.diagonal[j + 1, at] += value
            band.upper1[j, at] -= value
            band.lower1[j, at] -= value
