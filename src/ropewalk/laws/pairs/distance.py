"""Where two segments are nearest to each other, and how near they come on the way of a step.

Sources: Ericson, Real-Time Collision Detection, 2005, 5.1.9 (segments); Mirtich, Impulse-based Dynamic
Simulation, 1996, ch. 2 (conservative advancement).
"""

from __future__ import annotations

import math

from ropewalk.core.jit import kernel, small

PARALLEL = 1e-6  # [1] square of the angle below which segments count as parallel
NEVER = 2.0  # in place of a share of the step
TRIES = 200


@small
def held(value):
    """Return a number within 0 and 1."""
    return min(max(value, 0.0), 1.0)


@small
def on_way(x, y, share, i):
    """Return the place of a node at a share of its way from x to y."""
    return (
        x[0, i] + share * (y[0, i] - x[0, i]),
        x[1, i] + share * (y[1, i] - x[1, i]),
        x[2, i] + share * (y[2, i] - x[2, i]),
    )


@small
def product(a, b):
    """Return a . b."""
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]


@small
def less(a, b):
    """Return a - b."""
    return (a[0] - b[0], a[1] - b[1], a[2] - b[2])


@kernel
def nearest_of(a, b, c, e):
    """Return the nearest points of two segments, 0 to 1 each, from a to b and c to e, and their distance [m].

    Of parallel ones the middle of what lies side by side.
    """
    u, w, r = less(b, a), less(e, c), less(a, c)
    uu, ww, uw = max(product(u, u), 1e-300), max(product(w, w), 1e-300), product(u, w)
    ur, wr = product(u, r), product(w, r)
    flat = uu * ww - uw * uw
    if flat > PARALLEL * uu * ww:
        s = held((uw * wr - ur * ww) / flat)
    else:
        start = -ur / uu
        end = start + uw / uu
        s = 0.5 * (held(min(start, end)) + held(max(start, end)))
    t = (uw * s + wr) / ww
    if t < 0.0:
        t, s = 0.0, held(-ur / uu)
    elif t > 1.0:
        t, s = 1.0, held((uw - ur) / uu)
    d = (r[0] + s * u[0] - t * w[0], r[1] + s * u[1] - t * w[1], r[2] + s * u[2] - t * w[2])
    return s, t, math.sqrt(product(d, d))


@kernel
def nearest(x, y, share, i, j):
    """Return the same of segments i and j at a share of the way from x to y, (3, n)."""
    a, b = on_way(x, y, share, i), on_way(x, y, share, i + 1)
    c, e = on_way(x, y, share, j), on_way(x, y, share, j + 1)
    return nearest_of(a, b, c, e)


@kernel
def relative_way(x, y, i, j):
    """Return the most by which points of two segments move against each other from x to y [m]."""
    most = 0.0
    for p in range(2):
        for q in range(2):
            square = 0.0
            for k in range(3):
                way = y[k, i + p] - x[k, i + p] - (y[k, j + q] - x[k, j + q])
                square += way * way
            most = max(most, square)
    return math.sqrt(most)


@kernel
def comes_to(x, y, i, j, target, start, way):
    """Return the share of the way at which two segments are `target` apart for the first time, or NEVER.

    They are `start` apart at x and move by `way` against each other [m]. In doubt it is too early.
    """
    share, distance = 0.0, start
    for _ in range(TRIES):
        if distance <= 1.001 * target:
            return share
        share += (distance - target) / max(way, 1e-300)
        if not share < 1.0:
            return NEVER
        distance = nearest(x, y, share, i, j)[2]
    return share
