"""The pieces of a sweep whose blocks are symmetric: six numbers each, xx, xy, xz, yy, yz, zz.

With B = across I + (along - across) t t^T of a segment and its row q = d t, eliminating a node and the
tension of the segment before it leaves, for the next node and segment,
    M = A^-1 - d u u^T / (s + d p . u),  u = A^-1 p       the node's response, its segment held to its length
    s' = e + d t . M t,   p' = t - B M t,   A' = inertia + B - B M B
with p and s column and pivot of the tension; of its row d p only d is handed on.
"""

from __future__ import annotations

from ropewalk.core.jit import small
from ropewalk.core.twin import first, second, twin


@small
def nothing(no, one):
    """Return what comes before the first node."""
    return (no, no, no, no, no, no), (no, no, no), no, one, no, (no, no, no)


@small
def row(saddle, i, t):
    """Return the row of segment `i`, of which d is all there is."""
    return saddle.carries[i]


@small
def rows(saddle, i, j, t):
    """Return the rows of segments `i` and `j`."""
    return twin(saddle.carries[i], saddle.carries[j])


@small
def own(saddle, i):
    """Return the inertia of node `i`, which is all that it has of itself."""
    return saddle.inertia[i]


@small
def owns(saddle, i, j):
    """Return those of nodes `i` and `j`."""
    return twin(saddle.inertia[i], saddle.inertia[j])


@small
def add_node(passed, inertia, force, t, across, bend):
    """Add a node's inertia, force and B of its other segment to what came from those before it."""
    a, p, on, s, g, f = passed
    d = inertia + across
    b0, b1, b2 = bend * t[0], bend * t[1], bend * t[2]
    a = (
        a[0] + d + b0 * t[0], a[1] + b0 * t[1], a[2] + b0 * t[2],
        a[3] + d + b1 * t[1], a[4] + b1 * t[2], a[5] + d + b2 * t[2],
    )  # fmt: skip
    return a, p, on, s, g, (f[0] + force[0], f[1] + force[1], f[2] + force[2])


@small
def respond(passed, free):
    """Eliminate a node and the tension before it: M (6), u times its weight (3), y (3), pull."""
    (a0, a1, a2, a3, a4, a5), p, on, s, g, f = passed
    c0, c1, c2 = a3 * a5 - a4 * a4, a2 * a4 - a1 * a5, a1 * a4 - a2 * a3
    over = free / (a0 * c0 + a1 * c1 + a2 * c2)
    m0, m1, m2 = over * c0, over * c1, over * c2
    m3, m4, m5 = over * (a0 * a5 - a2 * a2), over * (a1 * a2 - a0 * a4), over * (a0 * a3 - a1 * a1)
    u0 = m0 * p[0] + m1 * p[1] + m2 * p[2]
    u1 = m1 * p[0] + m3 * p[1] + m4 * p[2]
    u2 = m2 * p[0] + m4 * p[1] + m5 * p[2]
    pivot = 1.0 / (s + on * (p[0] * u0 + p[1] * u1 + p[2] * u2))
    w = on * pivot
    w0, w1, w2 = w * u0, w * u1, w * u2
    pull = w0 * f[0] + w1 * f[1] + w2 * f[2] - pivot * g
    y0 = m0 * f[0] + m1 * f[1] + m2 * f[2] - pull * u0
    y1 = m1 * f[0] + m3 * f[1] + m4 * f[2] - pull * u1
    y2 = m2 * f[0] + m4 * f[1] + m5 * f[2] - pull * u2
    m = (m0 - w0 * u0, m1 - w0 * u1, m2 - w0 * u2, m3 - w1 * u1, m4 - w1 * u2, m5 - w2 * u2)
    return m, (w0, w1, w2), (y0, y1, y2), pull


@small
def pass_on(m, y, t, across, bend, e, on, misfit):
    """Return what an eliminated node leaves to the next one; `bend` is along - across."""
    t0, t1, t2 = t
    m0, m1, m2, m3, m4, m5 = m
    q0 = m0 * t0 + m1 * t1 + m2 * t2
    q1 = m1 * t0 + m3 * t1 + m4 * t2
    q2 = m2 * t0 + m4 * t1 + m5 * t2
    give = t0 * q0 + t1 * q1 + t2 * q2
    b, c = across * bend, 0.5 * bend * (bend * give - 1.0)
    h0, h1, h2 = b * q0 + c * t0, b * q1 + c * t1, b * q2 + c * t2
    b = across * across
    a = (
        across - b * m0 - 2.0 * h0 * t0, -b * m1 - h0 * t1 - h1 * t0, -b * m2 - h0 * t2 - h2 * t0,
        across - b * m3 - 2.0 * h1 * t1, -b * m4 - h1 * t2 - h2 * t1, across - b * m5 - 2.0 * h2 * t2,
    )  # fmt: skip
    c = 1.0 - bend * give
    p = (c * t0 - across * q0, c * t1 - across * q1, c * t2 - across * q2)
    rate = t0 * y[0] + t1 * y[1] + t2 * y[2]
    c = bend * rate
    f = (across * y[0] + c * t0, across * y[1] + c * t1, across * y[2] + c * t2)
    return a, p, on, e + on * give, on * rate - misfit, f


@small
def firsts(both):
    """Return what came from the first end."""
    a, p, on, s, g, f = both
    return (
        (first(a[0]), first(a[1]), first(a[2]), first(a[3]), first(a[4]), first(a[5])),
        (first(p[0]), first(p[1]), first(p[2])), first(on), first(s), first(g),
        (first(f[0]), first(f[1]), first(f[2])),
    )  # fmt: skip


@small
def seconds(both):
    """Return what came from the last end."""
    a, p, on, s, g, f = both
    return (
        (second(a[0]), second(a[1]), second(a[2]), second(a[3]), second(a[4]), second(a[5])),
        (second(p[0]), second(p[1]), second(p[2])), second(on), second(s), second(g),
        (second(f[0]), second(f[1]), second(f[2])),
    )  # fmt: skip


@small
def join(one, other, inertia, force):
    """Return the middle node with what both ends left to it; column and row are those of the first end."""
    a, p, on, s, g, f = one
    b, h = other[0], other[5]
    a = (
        a[0] + b[0] + inertia, a[1] + b[1], a[2] + b[2],
        a[3] + b[3] + inertia, a[4] + b[4], a[5] + b[5] + inertia,
    )  # fmt: skip
    f = (f[0] + h[0] + force[0], f[1] + h[1] + force[1], f[2] + h[2] + force[2])
    return a, p, on, s, g, f


@small
def meet(m, y, other):
    """Return the tension that comes from the other end, and what the middle node moves for each of it."""
    _, p, on, s, g, _ = other
    q0 = m[0] * p[0] + m[1] * p[1] + m[2] * p[2]
    q1 = m[1] * p[0] + m[3] * p[1] + m[4] * p[2]
    q2 = m[2] * p[0] + m[4] * p[1] + m[5] * p[2]
    pivot = s + on * (p[0] * q0 + p[1] * q1 + p[2] * q2)
    against = (on * (p[0] * y[0] + p[1] * y[1] + p[2] * y[2]) - g) / pivot
    return against, (q0, q1, q2)


@small
def keep(factor, i, m, w):
    """Store what the way back needs of node `i`."""
    for k in range(6):
        factor[i, k] = m[k]
    factor[i, 6], factor[i, 7], factor[i, 8] = w


@small
def keep_both(factor, i, j, m, w):
    """Store what the way back needs of nodes `i` and `j`."""
    for k in range(6):
        factor[i, k], factor[j, k] = first(m[k]), second(m[k])
    for k in range(3):
        factor[i, 6 + k], factor[j, 6 + k] = first(w[k]), second(w[k])


@small
def kept(factor, i):
    """Return what was kept of node `i`."""
    f = factor
    return (f[i, 0], f[i, 1], f[i, 2], f[i, 3], f[i, 4], f[i, 5], f[i, 6], f[i, 7], f[i, 8])


@small
def kept_both(f, i, j):
    """Return what was kept of nodes `i` and `j`."""
    return (
        twin(f[i, 0], f[j, 0]), twin(f[i, 1], f[j, 1]), twin(f[i, 2], f[j, 2]),
        twin(f[i, 3], f[j, 3]), twin(f[i, 4], f[j, 4]), twin(f[i, 5], f[j, 5]),
        twin(f[i, 6], f[j, 6]), twin(f[i, 7], f[j, 7]), twin(f[i, 8], f[j, 8]),
    )  # fmt: skip


@small
def come_back(k, z, pull, t, across, bend):
    """Return what the next node's solution `z` changes in one that kept `k`, and in the tension before it."""
    c = bend * (t[0] * z[0] + t[1] * z[1] + t[2] * z[2]) + pull
    b0, b1, b2 = across * z[0] + c * t[0], across * z[1] + c * t[1], across * z[2] + c * t[2]
    change = (
        k[0] * b0 + k[1] * b1 + k[2] * b2,
        k[1] * b0 + k[3] * b1 + k[4] * b2,
        k[2] * b0 + k[4] * b1 + k[5] * b2,
    )
    return change, k[6] * b0 + k[7] * b1 + k[8] * b2
