"""Derivatives of the forces of bending and its friction; see `bending` and `clamps` for the laws.

At a node let a, b be the unit vectors before and after it, D_a = da/de_a (symmetric), p = D_a b,
q = D_b a and chi = 1 + a . b. A force that follows from a function F(chi) has on the segments before and
after the node the derivatives
    F'' p p^T + F' T_a(b)    F'' p q^T + F' D_a D_b
    F'' q p^T + F' D_b D_a   F'' q q^T + F' T_b(a)        T_a(u) = d(D_a u)/de_a
Elastic: F = B |kb|^2 / 2. Friction D s' ds/dt with s = |kb|: its rate adds to F' and F'', and how its rate
changes with the places makes the matrix unsymmetric. Below s = STRAIGHT, where it acts on the whole rate of
kb too, 1 - s^2 / STRAIGHT^2 of it, how that share changes does so as well; of that part the derivatives with
the places are left out, which only turn it. Natural curvature adds those of -B kb . k0.

`definite` gives -F' D_a D_a in place of F' T_a(b), so that the part with F' < 0 becomes that of
-F' |a - b|^2 / 2 without its second derivatives, which has no negative eigenvalue, however folded the rope.
"""

from __future__ import annotations

import math

from ropewalk.core.blocks import (
    ZERO9,
    add,
    dot3,
    less_product,
    minus3,
    scale3,
    scale9,
    store9,
    subtract,
    transpose,
)
from ropewalk.core.jit import deferred, part, small
from ropewalk.laws.bending import (
    FOLD,
    STRAIGHT,
    across,
    bend,
    rate_of,
    slope_of,
    tangent,
    value_of,
)


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


@small
def turns(c, u, t, over, own):
    """Return c T_t(u), which is symmetric."""
    near = c * own * over * over
    tu = dot3(t, u)
    far = 0.5 * c * (3.0 if own == 1.0 else 2.0 * own * own) * over * over * tu
    g0, g1, g2 = far * t[0] - near * u[0], far * t[1] - near * u[1], far * t[2] - near * u[2]
    d = near * tu
    m1, m2, m5 = g0 * t[1] + t[0] * g1, g0 * t[2] + t[0] * g2, g1 * t[2] + t[1] * g2
    return (
        2.0 * g0 * t[0] - d, m1, m2,
        m1, 2.0 * g1 * t[1] - d, m5,
        m2, m5, 2.0 * g2 * t[2] - d,
    )  # fmt: skip


@small
def plainly(c, t, over, own):
    """Return -c D_t D_t."""
    d = -c * over * over
    return less_product(
        (d, 0.0, 0.0, 0.0, d, 0.0, 0.0, 0.0, d), scale3(d * own * (2.0 - own), t), t
    )


@part
def curve_of(chi):
    """Return q''(chi) of q = 1 / chi, 0 beyond a turn of 120 degrees."""
    return 2.0 / (chi * chi * chi) if chi > FOLD else 0.0


@small
def mixes(c, a, own_a, b, own_b):
    """Return c (I - a a^T) (I - b b^T), each with the share of its own part that is to be taken out."""
    f, g = c * own_a, c * own_b
    h = f * own_b * dot3(a, b)
    w = (f * a[0] - h * b[0], f * a[1] - h * b[1], f * a[2] - h * b[2])
    return less_product(
        less_product((c, 0.0, 0.0, 0.0, c, 0.0, 0.0, 0.0, c), a, w), scale3(g, b), b
    )


@small
def smooth_blocks(c1, c2, a, over_a, own_a, b, over_b, own_b, p, q, definite):
    """Return the derivatives of one node's bend before, up (row a, column b) and after, of F(chi)."""
    if definite:
        before, after = plainly(c1, a, over_a, own_a), plainly(c1, b, over_b, own_b)
    else:
        before, after = turns(c1, b, a, over_a, own_a), turns(c1, a, b, over_b, own_b)
    before = less_product(before, scale3(-c2, p), p)
    after = less_product(after, scale3(-c2, q), q)
    up = less_product(mixes(c1 * over_a * over_b, a, own_a, b, own_b), scale3(-c2, p), q)
    return before, up, after


@part
def natural_blocks(before, up, after, ct, cct, a, over_a, own_a, b, over_b, own_b, p, q, n):
    """Add what natural curvature n has besides its parts of F' and F''; ct = dU/dtau, cct = dct/dchi.

    U holds ct tau with tau = n . (a x b).
    """
    g = (b[1] * n[2] - b[2] * n[1], b[2] * n[0] - b[0] * n[2], b[0] * n[1] - b[1] * n[0])
    h = (n[1] * a[2] - n[2] * a[1], n[2] * a[0] - n[0] * a[2], n[0] * a[1] - n[1] * a[0])
    r = across(g[0], g[1], g[2], a[0], a[1], a[2], over_a, own_a)
    s = across(h[0], h[1], h[2], b[0], b[1], b[2], over_b, own_b)
    c = -ct * over_a * over_b
    turn = (0.0, -c * n[2], c * n[1], c * n[2], 0.0, -c * n[0], -c * n[1], c * n[0], 0.0)
    mixed = own_a * own_b * dot3(a, g)
    w = (own_a * h[0] - mixed * b[0], own_a * h[1] - mixed * b[1], own_a * h[2] - mixed * b[2])
    turn = less_product(less_product(turn, scale3(-c, a), w), scale3(-c * own_b, g), b)
    less_p, less_q = scale3(-cct, p), scale3(-cct, q)
    before = less_product(less_product(before, less_p, r), r, less_p)
    after = less_product(less_product(after, less_q, s), s, less_q)
    up = add(less_product(less_product(up, less_p, s), r, less_q), turn)
    before = add(before, turns(ct, g, a, over_a, own_a))
    after = add(after, turns(ct, h, b, over_b, own_b))
    return before, up, after


@small
def put_on(blocks, i, m):
    """Add a block to block `i` of an array (n, 9)."""
    for k in range(9):
        blocks[i, k] += m[k]


@deferred()
def bending_tangent(
    x, v, rest_length, stiffness, damping, natural, weight_x, weight_v, definite, band
):
    """Overwrite the band with -(weight_x dF/dx + weight_v dF/dv) of all bends and their friction.

    `here`, `beyond`, `right` and `below` are what the nodes so far have in the present two nodes' blocks:
    every block is written once, and none needs to be cleared before.
    """
    x0, x1, x2 = x[0], x[1], x[2]
    last = stiffness.shape[0] - 1
    ax, ay, az, over_a, own_a = tangent(x0[1] - x0[0], x1[1] - x1[0], x2[1] - x2[0], rest_length[0])
    here, beyond, right, below = ZERO9, ZERO9, ZERO9, ZERO9
    for i in range(1, last):
        bx, by, bz, over_b, own_b = tangent(
            x0[i + 1] - x0[i], x1[i + 1] - x1[i], x2[i + 1] - x2[i], rest_length[i]
        )
        before, up, low, after = ZERO9, ZERO9, ZERO9, ZERO9
        if stiffness[i] > 0.0:
            a, b = (ax, ay, az), (bx, by, bz)
            p = across(bx, by, bz, ax, ay, az, over_a, own_a)
            q = across(ax, ay, az, bx, by, bz, over_b, own_b)
            chi, square = bend(ax, ay, az, own_a, bx, by, bz, own_b)
            B = weight_x * stiffness[i]
            n = (natural[0, i], natural[1, i], natural[2, i])
            slope, c1, c2 = slopes(B, chi, a, b, n)
            f1, f2, first, second, change = 0.0, 0.0, 0.0, 0.0, 0.0
            rubs = damping[i] > 0.0
            if rubs:
                u, w = difference(v, i - 1), difference(v, i)
                da = across(u[0], u[1], u[2], ax, ay, az, over_a, own_a)
                db = across(w[0], w[1], w[2], bx, by, bz, over_b, own_b)
                change = rate_of(a, own_a, b, own_b, da, db, square)
                f1, f2, first, second = drag_parts(
                    damping[i], weight_x, weight_v, chi, square, change
                )
            before, up, after = smooth_blocks(
                c1 + f1, c2 + f2, a, over_a, own_a, b, over_b, own_b, p, q, definite
            )
            if n[0] != 0.0 or n[1] != 0.0 or n[2] != 0.0:
                ct, cct = -2.0 * B * value_of(chi), -2.0 * B * slope
                before, up, after = natural_blocks(
                    before, up, after, ct, cct, a, over_a, own_a, b, over_b, own_b, p, q, n
                )
            low = transpose(up)
            if rubs:
                scale = -weight_x * damping[i] * first
                y = drag_rate(a, over_a, own_a, b, p, u, db, scale, first, second, change)
                z = drag_rate(b, over_b, own_b, a, q, w, da, scale, first, second, change)
                before, after = less_product(before, p, y), less_product(after, q, z)
                up, low = less_product(up, p, z), less_product(low, q, y)
                fade = fades(weight_x * damping[i], chi, square)
                if fade != 0.0:
                    d = minus3(da, db)
                    y = scale3(fade, across(d[0], d[1], d[2], ax, ay, az, over_a, own_a))
                    z = scale3(-fade, across(d[0], d[1], d[2], bx, by, bz, over_b, own_b))
                    before, after = less_product(before, y, p), less_product(after, z, q)
                    up, low = less_product(up, y, q), less_product(low, z, p)
        store9(band.diagonal, i - 1, add(here, before))
        store9(band.upper1, i - 1, subtract(add(right, up), before))
        store9(band.lower1, i - 1, subtract(add(below, low), before))
        store9(band.upper2, i - 1, scale9(-1.0, up))
        store9(band.lower2, i - 1, scale9(-1.0, low))
        here = subtract(add(beyond, add(before, after)), add(up, low))
        beyond, right, below = after, subtract(up, after), subtract(low, after)
        ax, ay, az, over_a, own_a = bx, by, bz, over_b, own_b
    store9(band.diagonal, last - 1, here)
    store9(band.upper1, last - 1, right)
    store9(band.lower1, last - 1, below)
    store9(band.diagonal, last, beyond)


@part
def slopes(B, chi, a, b, n):
    """Return F' and what first and second derivatives of a node's energy are of its own chi."""
    slope, curve = slope_of(chi), curve_of(chi)
    cross = (a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0])
    tau = dot3(n, cross)
    return slope, B * slope * (4.0 - 2.0 * tau), B * curve * (4.0 - 2.0 * tau)


@small
def difference(v, j):
    """Return the rate of segment j's vector [m/s]."""
    return v[0, j + 1] - v[0, j], v[1, j + 1] - v[1, j], v[2, j + 1] - v[2, j]


@part
def drag_parts(D, weight_x, weight_v, chi, square, change):
    """Return a node's friction's parts of F' and F'', and s' and s'' of s = |kb|.

    Where it is nearly straight s is STRAIGHT there, and the rest of the friction on the whole rate.
    """
    straight = not square >= STRAIGHT * STRAIGHT
    s = STRAIGHT if straight else math.sqrt(square)
    first = 4.0 * slope_of(chi) / s
    second = 4.0 * curve_of(chi) / s - (0.0 if straight else first * first / s)
    pull = weight_x * D * first * change
    whole = weight_v * D * (1.0 - square / (s * s)) if straight else 0.0
    return pull * first - whole, pull * second + weight_v * D * first * first, first, second


@part
def fades(D, chi, square):
    """Return by how much less friction acts on the whole rate as chi grows, D times; 0 where none does."""
    if square >= STRAIGHT * STRAIGHT:
        return 0.0
    return D * 8.0 * slope_of(chi) / (STRAIGHT * STRAIGHT)


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


@deferred()
def clamp_tangent(x, v, rest_length, state, bending, weight_x, weight_v, definite, band):
    """Add the derivatives of all half cells at clamps."""
    for row in range(state.held.shape[0]):
        if bending.clamped[row] == 0 or state.held[row] == 0:
            continue
        for side in range(2):
            if bending.clamp_stiffness[row, side] > 0.0:
                j = state.anchor_node[row] - 1 + side
                if rest_length[j] == 0.0:  # it has parted
                    continue
                at = j, side, row
                half_cell_tangent(
                    x, v, rest_length, at, state, bending, weight_x, weight_v, definite, band
                )


@part
def half_cell_tangent(x, v, rest_length, at, state, bending, weight_x, weight_v, definite, band):
    """Add the derivatives of one half cell, the direction as a segment that stays; `at` says where."""
    j, side, row = at
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
    change = rate_of(t, own, d, 1.0, dt, turned, square)
    share = bending.clamp_length[row] / rest_length[j]
    B = weight_x * share * bending.clamp_stiffness[row, side]
    D = share * bending.clamp_damping[row, side]
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
    y = drag_rate(t, over, own, d, p, u, turned, -weight_x * D * first, first, second, change)
    block = plainly(c1, t, over, own) if definite else turns(c1, d, t, over, own)
    block = less_product(block, scale3(-c2, p), p)
    block = less_product(add(block, turns(ct, h, t, over, own)), p, y)
    fade = fades(weight_x * D, chi, square)
    if fade != 0.0:
        e = minus3(dt, turned)
        e = scale3(fade, across(e[0], e[1], e[2], tx, ty, tz, over, own))
        block = less_product(block, e, p)
    block = less_product(less_product(block, scale3(-cct, p), r), r, scale3(-cct, p))
    put_on(band.diagonal, j, block)
    put_on(band.diagonal, j + 1, block)
    block = scale9(-1.0, block)
    put_on(band.upper1, j, block)
    put_on(band.lower1, j, block)
