"""The solution of a saddle-point system whose band is empty, from both ends of the chain at once.

With B = across I + (along - across) t t^T of a segment the node equations are symmetric. Eliminating a node
and the tension of the segment before it leaves, for the next node and segment,
    M = A^-1 - d u u^T / (s + d p . u),  u = A^-1 p       the node's response, its segment held to its length
    s' = e + d t . M t,   p' = t - B M t,   A' = inertia + B - B M B
with p and s column and pivot of the tension. The two ends are independent of each other until they meet
at the middle node: what is done to both is done to a `Twin`, two numbers in one register.
"""

from __future__ import annotations

from ropewalk.core.jit import kernel, small
from ropewalk.core.twin import first, second, twin


@small
def respond(a, p, s, g, f, on, free):
    """Eliminate a node and the tension before it: M (6), u times its weight (3), y (3), pull."""
    a0, a1, a2, a3, a4, a5 = a  # xx, xy, xz, yy, yz, zz
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
def pass_on(m, y, t, across, bend, e, on):
    """Give the eliminated node's part to the next: B - B M B (6), p, s, d t . y, B y.

    `bend` is along - across.
    """
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
    return a, p, e + on * give, on * rate, f


@small
def add_segment(a, inertia, t, across, bend):
    """Add a node's inertia and B of its other segment."""
    d = inertia + across
    b0, b1, b2 = bend * t[0], bend * t[1], bend * t[2]
    return (
        a[0] + d + b0 * t[0], a[1] + b0 * t[1], a[2] + b0 * t[2],
        a[3] + d + b1 * t[1], a[4] + b1 * t[2], a[5] + d + b2 * t[2],
    )  # fmt: skip


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


@kernel
def sweep(saddle):
    """Solve the equations; the solution is in `moved` and `pulled`, not finite where there is none."""
    free, inertia = saddle.free, saddle.inertia
    across, along, e, on = saddle.across, saddle.along, saddle.compliance, saddle.carries
    d0, d1, d2 = saddle.direction[0], saddle.direction[1], saddle.direction[2]
    r0, r1, r2 = saddle.force[0], saddle.force[1], saddle.force[2]
    z0, z1, z2 = saddle.moved[0], saddle.moved[1], saddle.moved[2]
    misfit, tension, factor = saddle.misfit, saddle.pulled, saddle.factor
    n = free.shape[0]
    middle = n // 2
    no, one = twin(0.0, 0.0), twin(1.0, 1.0)
    zero = (no, no, no)
    A, P, S, G, F, D = (no, no, no, no, no, no), zero, one, no, zero, no
    for i in range(n - 1 - middle):  # from both ends
        h, j = n - 1 - i, n - 2 - i
        t = (twin(d0[i], -d0[j]), twin(d1[i], -d1[j]), twin(d2[i], -d2[j]))
        stiff = twin(across[i], across[j])
        bend = twin(along[i], along[j]) - stiff
        A = add_segment(A, twin(inertia[i], inertia[h]), t, stiff, bend)
        F = (F[0] + twin(r0[i], r0[h]), F[1] + twin(r1[i], r1[h]), F[2] + twin(r2[i], r2[h]))
        m, w, y, pull = respond(A, P, S, G, F, D, twin(free[i], free[h]))
        keep_both(factor, i, h, m, w)
        z0[i], z1[i], z2[i] = first(y[0]), first(y[1]), first(y[2])
        z0[h], z1[h], z2[h] = second(y[0]), second(y[1]), second(y[2])
        if i > 0:
            tension[i - 1], tension[h] = first(pull), second(pull)
        D = twin(on[i], on[j])
        A, P, S, G, F = pass_on(m, y, t, stiff, bend, twin(e[i], e[j]), D)
        G = G - twin(misfit[i], misfit[j])
    a = (first(A[0]), first(A[1]), first(A[2]), first(A[3]), first(A[4]), first(A[5]))
    p, f = (first(P[0]), first(P[1]), first(P[2])), (first(F[0]), first(F[1]), first(F[2]))
    s, g, d = first(S), first(G), first(D)
    for i in range(n - 1 - middle, middle):  # of an even number of nodes one is left
        t = (d0[i], d1[i], d2[i])
        bend = along[i] - across[i]
        a = add_segment(a, inertia[i], t, across[i], bend)
        f = (f[0] + r0[i], f[1] + r1[i], f[2] + r2[i])
        m, w, y, pull = respond(a, p, s, g, f, d, free[i])
        keep(factor, i, m, w)
        z0[i], z1[i], z2[i] = y
        if i > 0:
            tension[i - 1] = pull
        d = on[i]
        a, p, s, g, f = pass_on(m, y, t, across[i], bend, e[i], d)
        g -= misfit[i]
    i = middle
    a = (a[0] + second(A[0]) + inertia[i], a[1] + second(A[1]), a[2] + second(A[2]),
         a[3] + second(A[3]) + inertia[i], a[4] + second(A[4]),
         a[5] + second(A[5]) + inertia[i])  # fmt: skip
    f = (f[0] + second(F[0]) + r0[i], f[1] + second(F[1]) + r1[i], f[2] + second(F[2]) + r2[i])
    m, w, y, pull = respond(a, p, s, g, f, d, free[i])
    if i < n - 1:  # the tension of the segment that comes from the other end
        p = (second(P[0]), second(P[1]), second(P[2]))
        q0 = m[0] * p[0] + m[1] * p[1] + m[2] * p[2]
        q1 = m[1] * p[0] + m[3] * p[1] + m[4] * p[2]
        q2 = m[2] * p[0] + m[4] * p[1] + m[5] * p[2]
        pivot = second(S) + second(D) * (p[0] * q0 + p[1] * q1 + p[2] * q2)
        other = (second(D) * (p[0] * y[0] + p[1] * y[1] + p[2] * y[2]) - second(G)) / pivot
        tension[i] = other
        y = (y[0] - other * q0, y[1] - other * q1, y[2] - other * q2)
        pull -= other * (w[0] * p[0] + w[1] * p[1] + w[2] * p[2])
    z0[i], z1[i], z2[i] = y
    if i > 0:
        tension[i - 1] = pull
    _go_back(saddle, middle)


@kernel
def _go_back(saddle, middle):
    """Put each node's solution into the next one outward, from the middle to both ends."""
    across, along = saddle.across, saddle.along
    d0, d1, d2 = saddle.direction[0], saddle.direction[1], saddle.direction[2]
    z0, z1, z2 = saddle.moved[0], saddle.moved[1], saddle.moved[2]
    tension, factor = saddle.pulled, saddle.factor
    n = across.shape[0] + 1
    x, y, z = z0[middle], z1[middle], z2[middle]
    Z = (twin(x, x), twin(y, y), twin(z, z))
    for i in range(middle - 1, 2 * middle - n, -1):
        h, j = 2 * middle - i, 2 * middle - i - 1
        t = (twin(d0[i], -d0[j]), twin(d1[i], -d1[j]), twin(d2[i], -d2[j]))
        stiff = twin(across[i], across[j])
        bend = twin(along[i], along[j]) - stiff
        pulled = twin(tension[i], tension[j])
        change, pull = come_back(kept_both(factor, i, h), Z, pulled, t, stiff, bend)
        Z = (
            twin(z0[i], z0[h]) + change[0],
            twin(z1[i], z1[h]) + change[1],
            twin(z2[i], z2[h]) + change[2],
        )
        z0[i], z1[i], z2[i] = first(Z[0]), first(Z[1]), first(Z[2])
        z0[h], z1[h], z2[h] = second(Z[0]), second(Z[1]), second(Z[2])
        if i > 0:
            tension[i - 1] += first(pull)
        if h < n - 1:
            tension[h] += second(pull)
    z = (first(Z[0]), first(Z[1]), first(Z[2]))
    for i in range(2 * middle - n, -1, -1):  # of an even number of nodes one is left
        t = (d0[i], d1[i], d2[i])
        bend = along[i] - across[i]
        change, pull = come_back(kept(factor, i), z, tension[i], t, across[i], bend)
        z0[i], z1[i], z2[i] = z0[i] + change[0], z1[i] + change[1], z2[i] + change[2]
        if i > 0:
            tension[i - 1] += pull
