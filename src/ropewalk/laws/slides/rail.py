"""The curve that a node slides along, and the place on it that is nearest to the node.

X(u), u = 0 .. N, between the rope's nodes x_0 .. x_N: straight from either end to the middle of the last
segment; from middle to middle an arc of an ellipse that touches both segments there, with s = u - i,
    X = (1 - s - q) x_(i-1) / 2 + q x_i + (1 + s - q) x_(i+1) / 2,    q = sqrt(1/2 - s^2)
It goes on without a kink, and is the straight line where the nodes are on one. Why an ellipse: a force F on
X, shared among the nodes so, sinks into a string of segments h under tension T by sum S (1 - S) h F / T less
than into one without segments, S the share of the nodes on one side of a segment: that is 1/4 at every u. On
straight segments a load would roll over bumps of 0.25 h F / T, on parabolas (a B-spline) of 0.03 h F / T.
With r = p - X(u) from the curve to the node p, the nearest place is where g = r . r' = 0 and g' > 0, or an
end; shares a of the four nodes x: r = sum a x, r' = sum a' x, r'' = sum a'' x. How it changes with the nodes:
    grad u = -(a r' + a' r) / g',    g' = r' . r' + r . r''
Source: Lanczos, The Variational Principles of Mechanics, 1970, ch. 2 (auxiliary conditions).
"""

from __future__ import annotations

import math

from ropewalk.core.jit import kernel, small
from ropewalk.laws.slides.table import (
    APART,
    AT,
    BEND,
    GRADIENT,
    INSIDE,
    PLACE,
    R1,
    R2,
    RATE,
    SHARE,
    SLOPE,
    TURNS,
    R,
)

ROUNDS = 60
LEAST = 0.05  # [1] of g' over r' . r'


@small
def piece_of(u, count):
    """Return the piece on which a place lies; there are count + 1, each about a node."""
    return min(max(math.floor(u + 0.5), 0), count)


@small
def shares(u, piece, count):
    """Return shares of three nodes in X, X', of the middle one in X'' and X''', and the middle one.

    The others have minus half of those each.
    """
    if piece == 0:
        return 1.0 - u, u, 0.0, -1.0, 1.0, 0.0, 0.0, 0.0, 1
    if piece == count:
        s = count - u
        return 0.0, s, 1.0 - s, 0.0, -1.0, 1.0, 0.0, 0.0, count - 1
    s = u - piece
    q = math.sqrt(0.5 - s * s)
    turn = -s / q
    left, right = 0.5 * (1.0 - s - q), 0.5 * (1.0 + s - q)
    bend, more = -0.5 / (q * q * q), -1.5 * s / (q * q * q * q * q)
    return left, q, right, 0.5 * (-1.0 - turn), turn, 0.5 * (1.0 - turn), bend, more, piece


@kernel
def point_at(x, first, last, u):
    """Return a place of the curve [m], of a rope's first and last node; `x` is (3, n)."""
    w0, w1, w2, _, _, _, _, _, middle = shares(u, piece_of(u, last - first), last - first)
    i = first + middle
    return (
        w0 * x[0, i - 1] + w1 * x[0, i] + w2 * x[0, i + 1],
        w0 * x[1, i - 1] + w1 * x[1, i] + w2 * x[1, i + 1],
        w0 * x[2, i - 1] + w1 * x[2, i] + w2 * x[2, i + 1],
    )


@small
def condition(x, node, first, count, u, piece):
    """Return g and g' at a place [m^2]."""
    w0, w1, w2, d0, d1, d2, bend, _, middle = shares(u, piece, count)
    i, g, slope = first + middle, 0.0, 0.0
    for k in range(3):
        a, b, c = x[k, i - 1], x[k, i], x[k, i + 1]
        r = x[k, node] - (w0 * a + w1 * b + w2 * c)
        t = d0 * a + d1 * b + d2 * c
        g -= r * t
        slope += t * t - r * bend * (b - 0.5 * (a + c))
    return g, slope


@kernel
def root(x, node, first, count, start, piece, low, high):
    """Return the place between two, g < 0 < g there, at which g is zero; from a guess."""
    u = min(max(start, low), high)
    for _ in range(ROUNDS):
        g, slope = condition(x, node, first, count, u, piece)
        if g < 0.0:
            low = u
        else:
            high = u
        step = g / slope if slope > 0.0 else math.inf
        new = u - step
        if not (low <= new <= high):
            new = 0.5 * (low + high)
        if new == u:
            break
        u, way = new, abs(new - u)
        if way <= 4e-16 * max(u, 1.0):
            break
    return u


@kernel
def nearest_place(x, node, first, last, start):
    """Return the place on the rope that is nearest to a node, downhill from `start`."""
    count = last - first
    piece, before = piece_of(start, count), 0
    for _ in range(count + 2):
        low, high = max(piece - 0.5, 0.0), min(piece + 0.5, float(count))
        if condition(x, node, first, count, low, piece)[0] > 0.0:
            if piece == 0 or before > 0:
                return low
            piece, before = piece - 1, -1
        elif condition(x, node, first, count, high, piece)[0] < 0.0:
            if piece == count or before < 0:
                return high
            piece, before = piece + 1, 1
        else:
            return root(x, node, first, count, start, piece, low, high)
    return start


@kernel
def look(x, table, memory, row):
    """Write where a slide is at places (3, n) and what it needs of the curve there, see `table`."""
    node, first, last = table.node[row], table.first[row], table.last[row]
    sight, group, count = memory.sight, memory.group, last - first
    u = nearest_place(x, node, first, last, memory.grip[row, PLACE])
    w0, w1, w2, d0, d1, d2, bend, more, middle = shares(u, piece_of(u, count), count)
    group[row, 0] = node
    sight[row, SHARE], sight[row, RATE], sight[row, BEND] = 1.0, 0.0, 0.0
    for m in range(3):
        group[row, m + 1] = first + middle - 1 + m
        sight[row, SHARE + 1 + m] = -(w0, w1, w2)[m]
        sight[row, RATE + 1 + m] = -(d0, d1, d2)[m]
        sight[row, BEND + 1 + m] = bend * (0.5, -1.0, 0.5)[m]
    for k in range(3):
        r, r1, r2 = x[k, node], 0.0, 0.0
        for m in range(1, 4):
            place = x[k, group[row, m]]
            r += sight[row, SHARE + m] * place
            r1 += sight[row, RATE + m] * place
            r2 += sight[row, BEND + m] * place
        sight[row, R + k], sight[row, R1 + k], sight[row, R2 + k] = r, r1, r2
    square, speed, slope, turns = 0.0, 0.0, 0.0, 0.0
    ratio = more / bend if bend != 0.0 else 0.0
    for k in range(3):
        turns += (3.0 * sight[row, R1 + k] + ratio * sight[row, R + k]) * sight[row, R2 + k]
        square += sight[row, R + k] * sight[row, R + k]
        speed += sight[row, R1 + k] * sight[row, R1 + k]
        slope += sight[row, R + k] * sight[row, R2 + k]
    slope = max(speed + slope, LEAST * speed)
    inside = 0.0 < u < count and slope > 0.0
    sight[row, AT], sight[row, APART], sight[row, SLOPE] = u, math.sqrt(square), slope
    sight[row, TURNS] = turns
    sight[row, INSIDE] = 1.0 if inside else 0.0
    for m in range(4):
        a, b = sight[row, SHARE + m], sight[row, RATE + m]
        for k in range(3):
            turn = a * sight[row, R1 + k] + b * sight[row, R + k]
            sight[row, GRADIENT + 3 * m + k] = -turn / slope if inside else 0.0
