"""Arithmetic of 3 x 3 blocks held in tuples of nine numbers, row by row, and of vectors of three.

Tuples live in registers: no array is allocated and nothing is written to memory.
"""

from __future__ import annotations

from ropewalk.core.jit import small

ZERO3 = (0.0, 0.0, 0.0)
ZERO9 = (0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0)


@small
def load9(blocks, i):
    """Return block `i` of an array (n, 9)."""
    return (
        blocks[i, 0], blocks[i, 1], blocks[i, 2],
        blocks[i, 3], blocks[i, 4], blocks[i, 5],
        blocks[i, 6], blocks[i, 7], blocks[i, 8],
    )  # fmt: skip


@small
def store9(blocks, i, m):
    """Write block `i` of an array (n, 9)."""
    for k in range(9):
        blocks[i, k] = m[k]


@small
def dot3(a, b):
    """Return the scalar product."""
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]


@small
def scale3(c, a):
    """Return c a."""
    return c * a[0], c * a[1], c * a[2]


@small
def plus3(a, b):
    """Return the vector a + b."""
    return a[0] + b[0], a[1] + b[1], a[2] + b[2]


@small
def minus3(a, b):
    """Return the vector a - b."""
    return a[0] - b[0], a[1] - b[1], a[2] - b[2]


@small
def apply(m, a):
    """Return the vector m a."""
    return (
        m[0] * a[0] + m[1] * a[1] + m[2] * a[2],
        m[3] * a[0] + m[4] * a[1] + m[5] * a[2],
        m[6] * a[0] + m[7] * a[1] + m[8] * a[2],
    )


@small
def apply_left(a, m):
    """Return the vector a^T m."""
    return (
        a[0] * m[0] + a[1] * m[3] + a[2] * m[6],
        a[0] * m[1] + a[1] * m[4] + a[2] * m[7],
        a[0] * m[2] + a[1] * m[5] + a[2] * m[8],
    )


@small
def multiply(a, b):
    """Return the block a b."""
    return (
        a[0] * b[0] + a[1] * b[3] + a[2] * b[6],
        a[0] * b[1] + a[1] * b[4] + a[2] * b[7],
        a[0] * b[2] + a[1] * b[5] + a[2] * b[8],
        a[3] * b[0] + a[4] * b[3] + a[5] * b[6],
        a[3] * b[1] + a[4] * b[4] + a[5] * b[7],
        a[3] * b[2] + a[4] * b[5] + a[5] * b[8],
        a[6] * b[0] + a[7] * b[3] + a[8] * b[6],
        a[6] * b[1] + a[7] * b[4] + a[8] * b[7],
        a[6] * b[2] + a[7] * b[5] + a[8] * b[8],
    )


@small
def scale9(c, a):
    """Return the block c a."""
    return (
        c * a[0], c * a[1], c * a[2],
        c * a[3], c * a[4], c * a[5],
        c * a[6], c * a[7], c * a[8],
    )  # fmt: skip


@small
def transpose(a):
    """Return the block with rows and columns exchanged."""
    return a[0], a[3], a[6], a[1], a[4], a[7], a[2], a[5], a[8]


@small
def add(a, b):
    """Return the block a + b."""
    return (
        a[0] + b[0], a[1] + b[1], a[2] + b[2],
        a[3] + b[3], a[4] + b[4], a[5] + b[5],
        a[6] + b[6], a[7] + b[7], a[8] + b[8],
    )  # fmt: skip


@small
def subtract(a, b):
    """Return the block a - b."""
    return (
        a[0] - b[0], a[1] - b[1], a[2] - b[2],
        a[3] - b[3], a[4] - b[4], a[5] - b[5],
        a[6] - b[6], a[7] - b[7], a[8] - b[8],
    )  # fmt: skip


@small
def less_product(m, u, w):
    """Return the block m - u w^T."""
    return (
        m[0] - u[0] * w[0], m[1] - u[0] * w[1], m[2] - u[0] * w[2],
        m[3] - u[1] * w[0], m[4] - u[1] * w[1], m[5] - u[1] * w[2],
        m[6] - u[2] * w[0], m[7] - u[2] * w[1], m[8] - u[2] * w[2],
    )  # fmt: skip


@small
def inverse(a):
    """Return the inverse by cofactors; infinite where the block is singular."""
    return free_inverse(a, 1.0)


@small
def free_inverse(a, free):
    """Return `free` times the inverse."""
    c0 = a[4] * a[8] - a[5] * a[7]
    c3 = a[5] * a[6] - a[3] * a[8]
    c6 = a[3] * a[7] - a[4] * a[6]
    over = free / (a[0] * c0 + a[1] * c3 + a[2] * c6)
    return (
        over * c0, over * (a[2] * a[7] - a[1] * a[8]), over * (a[1] * a[5] - a[2] * a[4]),
        over * c3, over * (a[0] * a[8] - a[2] * a[6]), over * (a[2] * a[3] - a[0] * a[5]),
        over * c6, over * (a[1] * a[6] - a[0] * a[7]), over * (a[0] * a[4] - a[1] * a[3]),
    )  # fmt: skip


@small
def plus_line(m, sign, across, along, direction, j):
    """Return m + sign (across I + (along - across) t t^T), t column `j` of directions (3, s)."""
    t0, t1, t2 = direction[0, j], direction[1, j], direction[2, j]
    d, q = sign * across, sign * (along - across)
    q0, q1, q2 = q * t0, q * t1, q * t2
    return (
        m[0] + d + q0 * t0, m[1] + q0 * t1, m[2] + q0 * t2,
        m[3] + q1 * t0, m[4] + d + q1 * t1, m[5] + q1 * t2,
        m[6] + q2 * t0, m[7] + q2 * t1, m[8] + d + q2 * t2,
    )  # fmt: skip


@small
def triangles(m):
    """Return the factors L U of a block: L below the diagonal, whose own is 1, and 1 over U's diagonal.

    Where a block is stiff along one line an inverse by cofactors loses what it has across, factors do not.
    """
    over0 = 1.0 / m[0]
    l3, l6 = m[3] * over0, m[6] * over0
    u4, u5 = m[4] - l3 * m[1], m[5] - l3 * m[2]
    over4 = 1.0 / u4
    l7 = (m[7] - l6 * m[1]) * over4
    over8 = 1.0 / (m[8] - l6 * m[2] - l7 * u5)
    return over0, m[1], m[2], l3, over4, u5, l6, l7, over8


@small
def solve3(f, a):
    """Return m^-1 a for the factors `f` of m."""
    y1 = a[1] - f[3] * a[0]
    z2 = (a[2] - f[6] * a[0] - f[7] * y1) * f[8]
    z1 = (y1 - f[5] * z2) * f[4]
    return (a[0] - f[1] * z1 - f[2] * z2) * f[0], z1, z2


@small
def solve_left3(a, f):
    """Return a^T m^-1 for the factors `f` of m."""
    y0 = a[0] * f[0]
    y1 = (a[1] - y0 * f[1]) * f[4]
    z2 = (a[2] - y0 * f[2] - y1 * f[5]) * f[8]
    z1 = y1 - z2 * f[7]
    return y0 - z1 * f[3] - z2 * f[6], z1, z2


@small
def solve9(f, b):
    """Return the block m^-1 b for the factors `f` of m."""
    p = solve3(f, (b[0], b[3], b[6]))
    q = solve3(f, (b[1], b[4], b[7]))
    r = solve3(f, (b[2], b[5], b[8]))
    return p[0], q[0], r[0], p[1], q[1], r[1], p[2], q[2], r[2]


@small
def solve_left9(b, f):
    """Return the block b m^-1 for the factors `f` of m."""
    p = solve_left3((b[0], b[1], b[2]), f)
    q = solve_left3((b[3], b[4], b[5]), f)
    r = solve_left3((b[6], b[7], b[8]), f)
    return p[0], p[1], p[2], q[0], q[1], q[2], r[0], r[1], r[2]
