"""The pieces of a sweep whose rows lean away from their columns: blocks have nine numbers.

The band's diagonal adds blocks that nodes have of themselves.

Forces along a segment that follow the motion of its ends by `lean`, (rub t + w)^T (z_(j+1) - z_j), go into
its tension's unknown: with N' = T' + lean . (z_(j+1) - z_j) the nodes know N' t only, and segment j's row is
    q . (z_(j+1) - z_j) - e N' = -g,   q = d t + e lean.
With B = across I + (along - across) t t^T, eliminating a node and N' of the segment before it leaves
    M = A^-1 - u v^T / (s + q . u),   u = A^-1 p,   v = A^-T q
    s' = e + q . M t,   p' = t - B M t,   q' = q - B M^T q,   A' = inertia + B - B M B .
"""

from __future__ import annotations

from ropewalk.core.blocks import (
    add,
    apply,
    apply_left,
    dot3,
    free_inverse,
    less_product,
    load9,
    minus3,
    plus3,
    scale3,
)
from ropewalk.core.jit import small
from ropewalk.core.twin import first, second, twin


@small
def nothing(no, one):
    """Return what comes before the first node."""
    zero = (no, no, no)
    return (no, no, no, no, no, no, no, no, no), zero, zero, one, no, zero


@small
def row(saddle, i, t):
    """Return the row q of segment `i`."""
    on, e, lean = saddle.carries[i], saddle.compliance[i], saddle.lean
    return on * t[0] + e * lean[0, i], on * t[1] + e * lean[1, i], on * t[2] + e * lean[2, i]


@small
def rows(saddle, i, j, t):
    """Return the rows of segments `i` and `j`, the second one gone through from its other end."""
    lean = saddle.lean
    on = twin(saddle.carries[i], saddle.carries[j])
    e = twin(saddle.compliance[i], saddle.compliance[j])
    return (
        on * t[0] + e * twin(lean[0, i], -lean[0, j]),
        on * t[1] + e * twin(lean[1, i], -lean[1, j]),
        on * t[2] + e * twin(lean[2, i], -lean[2, j]),
    )


@small
def both9(blocks, i, j):
    """Return the first nine numbers of rows `i` and `j`."""
    b = blocks
    return (
        twin(b[i, 0], b[j, 0]), twin(b[i, 1], b[j, 1]), twin(b[i, 2], b[j, 2]),
        twin(b[i, 3], b[j, 3]), twin(b[i, 4], b[j, 4]), twin(b[i, 5], b[j, 5]),
        twin(b[i, 6], b[j, 6]), twin(b[i, 7], b[j, 7]), twin(b[i, 8], b[j, 8]),
    )  # fmt: skip


@small
def plus_inertia(a, d):
    """Return a + d I."""
    return a[0] + d, a[1], a[2], a[3], a[4] + d, a[5], a[6], a[7], a[8] + d


@small
def own(saddle, i):
    """Return what node `i` has of itself: inertia and the band's block."""
    return plus_inertia(load9(saddle.band.diagonal, i), saddle.inertia[i])


@small
def owns(saddle, i, j):
    """Return what nodes `i` and `j` have of themselves."""
    d = twin(saddle.inertia[i], saddle.inertia[j])
    return plus_inertia(both9(saddle.band.diagonal, i, j), d)


@small
def add_node(passed, own, force, t, across, bend):
    """Add a node's own block, force and B of its other segment to what came from those before it."""
    a, p, q, s, g, f = passed
    a = plus_inertia(add(a, own), across)
    b0, b1, b2 = bend * t[0], bend * t[1], bend * t[2]
    xy, xz, yz = b0 * t[1], b0 * t[2], b1 * t[2]
    a = (
        a[0] + b0 * t[0], a[1] + xy, a[2] + xz,
        a[3] + xy, a[4] + b1 * t[1], a[5] + yz,
        a[6] + xz, a[7] + yz, a[8] + b2 * t[2],
    )  # fmt: skip
    return a, p, q, s, g, plus3(f, force)


@small
def respond(passed, free):
    """Eliminate a node and the tension before it: M (9), v times its weight (3), y (3), pull."""
    a, p, q, s, g, f = passed
    b = free_inverse(a, free)
    u, v = apply(b, p), apply_left(q, b)
    pivot = 1.0 / (s + dot3(q, u))
    w = scale3(pivot, v)
    pull = dot3(w, f) - pivot * g
    return less_product(b, u, w), w, minus3(apply(b, f), scale3(pull, u)), pull


@small
def pass_on(m, y, t, across, bend, e, q, misfit):
    """Return what an eliminated node leaves to the next one; `bend` is along - across."""
    t0, t1, t2 = t
    mt, nt, mq = apply(m, t), apply_left(t, m), apply_left(q, m)
    give, lead = dot3(t, mt), dot3(t, mq)
    b, c = across * bend, 0.5 * bend * (bend * give - 1.0)
    h0, h1, h2 = b * mt[0] + c * t0, b * mt[1] + c * t1, b * mt[2] + c * t2
    k0, k1, k2 = b * nt[0] + c * t0, b * nt[1] + c * t1, b * nt[2] + c * t2
    b = across * across
    a = (
        across - b * m[0] - h0 * t0 - k0 * t0, -b * m[1] - h0 * t1 - k1 * t0, -b * m[2] - h0 * t2 - k2 * t0,
        -b * m[3] - h1 * t0 - k0 * t1, across - b * m[4] - h1 * t1 - k1 * t1, -b * m[5] - h1 * t2 - k2 * t1,
        -b * m[6] - h2 * t0 - k0 * t2, -b * m[7] - h2 * t1 - k1 * t2, across - b * m[8] - h2 * t2 - k2 * t2,
    )  # fmt: skip
    p = minus3(scale3(1.0 - bend * give, t), scale3(across, mt))
    f = plus3(scale3(across, y), scale3(bend * dot3(t, y), t))
    rate = dot3(q, y)
    q = minus3(minus3(q, scale3(across, mq)), scale3(bend * lead, t))
    return a, p, q, e + lead, rate - misfit, f


@small
def firsts(both):
    """Return what came from the first end."""
    a, p, q, s, g, f = both
    return (
        (first(a[0]), first(a[1]), first(a[2]), first(a[3]), first(a[4]),
         first(a[5]), first(a[6]), first(a[7]), first(a[8])),
        (first(p[0]), first(p[1]), first(p[2])), (first(q[0]), first(q[1]), first(q[2])),
        first(s), first(g), (first(f[0]), first(f[1]), first(f[2])),
    )  # fmt: skip


@small
def seconds(both):
    """Return what came from the last end."""
    a, p, q, s, g, f = both
    return (
        (second(a[0]), second(a[1]), second(a[2]), second(a[3]), second(a[4]),
         second(a[5]), second(a[6]), second(a[7]), second(a[8])),
        (second(p[0]), second(p[1]), second(p[2])), (second(q[0]), second(q[1]), second(q[2])),
        second(s), second(g), (second(f[0]), second(f[1]), second(f[2])),
    )  # fmt: skip


@small
def join(one, other, own, force):
    """Return the middle node with what both ends left to it; column and row are those of the first end."""
    a, p, q, s, g, f = one
    return add(add(a, other[0]), own), p, q, s, g, plus3(plus3(f, other[5]), force)


@small
def meet(m, y, other):
    """Return the tension that comes from the other end, and what the middle node moves for each of it."""
    _, p, q, s, g, _ = other
    moved = apply(m, p)
    return (dot3(q, y) - g) / (s + dot3(q, moved)), moved


@small
def keep(factor, i, m, w):
    """Store what the way back needs of node `i`."""
    for k in range(9):
        factor[i, k] = m[k]
    factor[i, 9], factor[i, 10], factor[i, 11] = w


@small
def keep_both(factor, i, j, m, w):
    """Store what the way back needs of nodes `i` and `j`."""
    for k in range(9):
        factor[i, k], factor[j, k] = first(m[k]), second(m[k])
    for k in range(3):
        factor[i, 9 + k], factor[j, 9 + k] = first(w[k]), second(w[k])


@small
def kept(f, i):
    """Return what was kept of node `i`: M and w."""
    return load9(f, i), (f[i, 9], f[i, 10], f[i, 11])


@small
def kept_both(f, i, j):
    """Return what was kept of nodes `i` and `j`."""
    w = (twin(f[i, 9], f[j, 9]), twin(f[i, 10], f[j, 10]), twin(f[i, 11], f[j, 11]))
    return both9(f, i, j), w


@small
def come_back(k, z, pull, t, across, bend):
    """Return what the next node's solution `z` changes in one that kept `k`, and in the tension before it."""
    m, w = k
    b = plus3(scale3(across, z), scale3(bend * dot3(t, z) + pull, t))
    return apply(m, b), dot3(w, b)
