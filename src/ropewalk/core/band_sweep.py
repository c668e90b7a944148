"""The solution of any saddle-point system of `saddle`, block-tridiagonal or with second off-diagonals.

Node by node the tension T' of the segment before it and its displacement z are eliminated at once. With p,
q and s column, row and pivot of T', p2 and q2 their entries at the next node, and a load (alpha; v) on them,
    z = M v + u alpha / d,   T' = w . v - alpha / d,
    d = s + q . A^-1 p,  u = A^-1 p,  w = q^T A^-1 / d,  M = A^-1 - u w^T .
A held node has A^-1 = 0. All else is the Schur complement of the columns of T'_i, z_(i+1) and z_(i+2).
"""

from __future__ import annotations

from ropewalk.core.blocks import (
    ZERO3,
    ZERO9,
    apply,
    apply_left,
    dot3,
    inverse,
    less_product,
    load9,
    minus3,
    multiply,
    plus_line,
    scale3,
    subtract,
)
from ropewalk.core.jit import deferred, kernel, small


@small
def node_block(saddle, i):
    """Return A of node `i`: inertia, its segments' parts and the band's."""
    d = saddle.inertia[i]
    a = load9(saddle.band.diagonal, i)
    a = (a[0] + d, a[1], a[2], a[3], a[4] + d, a[5], a[6], a[7], a[8] + d)
    if i > 0:
        a = plus_line(a, 1.0, saddle.across[i - 1], saddle.along[i - 1], saddle.direction, i - 1)
    if i < saddle.across.shape[0]:
        a = plus_line(a, 1.0, saddle.across[i], saddle.along[i], saddle.direction, i)
    return a


@small
def respond(a, p, q, s, free):
    """Return M, u, w and 1 / d of a node and the tension before it."""
    b = inverse(a) if free != 0.0 else ZERO9
    u, w = apply(b, p), apply_left(q, b)
    over = 1.0 / (s + dot3(w, p))
    w = scale3(over, w)
    return less_product(b, u, w), u, w, over


@small
def keep(saddle, i, z1, mt, t1, wt):
    """Store what the way back needs of node `i`."""
    factor = saddle.factor
    for k in range(9):
        factor[i, k] = z1[k]
    factor[i, 9], factor[i, 10], factor[i, 11] = mt
    factor[i, 12], factor[i, 13], factor[i, 14] = t1
    factor[i, 15] = wt


@small
def keep_far(saddle, i, z2, t2):
    """Store what the way back needs of the next node but one."""
    factor = saddle.far_factor
    for k in range(9):
        factor[i, k] = z2[k]
    factor[i, 9], factor[i, 10], factor[i, 11] = t2


@deferred()
def band_sweep(saddle):
    """Solve the equations; the solution is in `moved` and `pulled`, not finite where there is none."""
    band, force, z = saddle.band, saddle.force, saddle.moved
    n = saddle.free.shape[0]
    far = band.upper2.shape[0] > 0
    a, f = node_block(saddle, 0), (force[0, 0], force[1, 0], force[2, 0])
    p, q, p2, q2, s, g = ZERO3, ZERO3, ZERO3, ZERO3, 1.0, 0.0
    up_less, low_less, a_less, f_less = ZERO9, ZERO9, ZERO9, ZERO3
    for i in range(n):
        m, u, w, over = respond(a, p, q, s, saddle.free[i])
        pull = dot3(w, f) - over * g
        y = apply(m, f)
        y = (y[0] + over * g * u[0], y[1] + over * g * u[1], y[2] + over * g * u[2])
        z[0, i], z[1, i], z[2, i] = y
        if i > 0:
            saddle.pulled[i - 1] = pull
        if i == n - 1:
            break
        across, along, on = saddle.across[i], saddle.along[i], saddle.carries[i]
        t = (saddle.direction[0, i], saddle.direction[1, i], saddle.direction[2, i])
        up = plus_line(load9(band.upper1, i), -1.0, across, along, saddle.direction, i)
        low = plus_line(load9(band.lower1, i), -1.0, across, along, saddle.direction, i)
        up, low = subtract(up, up_less), subtract(low, low_less)
        mt, wt = apply(m, t), dot3(w, t)
        z1, t1 = multiply(m, up), apply_left(w, up)
        if far:
            z1, t1 = less_product(z1, scale3(-over, u), q2), minus3(t1, scale3(over, q2))
        keep(saddle, i, z1, mt, t1, wt)
        s = saddle.compliance[i] + on * dot3(t, mt)
        tz, lt = apply_left(t, z1), apply(low, mt)
        q = (on * (t[0] + tz[0]), on * (t[1] + tz[1]), on * (t[2] + tz[2]))
        p = (t[0] + lt[0] + wt * p2[0], t[1] + lt[1] + wt * p2[1], t[2] + lt[2] + wt * p2[2])
        g = on * dot3(t, y) - saddle.misfit[i]
        a = subtract(subtract(node_block(saddle, i + 1), multiply(low, z1)), a_less)
        f = (force[0, i + 1], force[1, i + 1], force[2, i + 1])
        f = minus3(minus3(f, apply(low, y)), f_less)
        if far:
            a, f = less_product(a, p2, t1), minus3(f, scale3(pull, p2))
            up2, low2 = load9(band.upper2, i), load9(band.lower2, i)
            z2, t2 = multiply(m, up2), apply_left(w, up2)
            keep_far(saddle, i, z2, t2)
            up_less = less_product(multiply(low, z2), scale3(-1.0, p2), t2)
            low_less, a_less = multiply(low2, z1), multiply(low2, z2)
            q2, p2, f_less = scale3(on, apply_left(t, z2)), apply(low2, mt), apply(low2, y)
    _go_back(saddle, far)


@kernel
def _go_back(saddle, far):
    """Put each node's solution into those before it, from the last to the first."""
    z, tension, f, h = saddle.moved, saddle.pulled, saddle.factor, saddle.far_factor
    n = z.shape[1]
    for back in range(n - 1):
        i = n - 2 - back
        pull = tension[i]
        z0, z1, z2 = z[0, i + 1], z[1, i + 1], z[2, i + 1]
        y0 = z[0, i] + f[i, 9] * pull - (f[i, 0] * z0 + f[i, 1] * z1 + f[i, 2] * z2)
        y1 = z[1, i] + f[i, 10] * pull - (f[i, 3] * z0 + f[i, 4] * z1 + f[i, 5] * z2)
        y2 = z[2, i] + f[i, 11] * pull - (f[i, 6] * z0 + f[i, 7] * z1 + f[i, 8] * z2)
        more = f[i, 15] * pull - (f[i, 12] * z0 + f[i, 13] * z1 + f[i, 14] * z2)
        if far and i < n - 2:
            z0, z1, z2 = z[0, i + 2], z[1, i + 2], z[2, i + 2]
            y0 -= h[i, 0] * z0 + h[i, 1] * z1 + h[i, 2] * z2
            y1 -= h[i, 3] * z0 + h[i, 4] * z1 + h[i, 5] * z2
            y2 -= h[i, 6] * z0 + h[i, 7] * z1 + h[i, 8] * z2
            more -= h[i, 9] * z0 + h[i, 10] * z1 + h[i, 11] * z2
        z[0, i], z[1, i], z[2, i] = y0, y1, y2
        if i > 0:
            tension[i - 1] += more
