"""The curve that a node slides along, and the place on it that is nearest to the node.

X(u), u = 0 .. N, between the rope's nodes x_0 .. x_N, those off its drums or of the part of a broken rope:
straight from either end to the middle of the last segment; from middle to middle an arc of an ellipse that
touches both segments there, with s = u - i,
    X = (1 - s - q) x_(i-1) / 2 + q x_i + (1 + s - q) x_(i+1) / 2,    q = sqrt(1/2 - s^2)
It goes on without a kink, and is the straight line where the nodes are on one. Why an ellipse: a force F on
X, shared among the nodes so, sinks into a string of segments h under tension T by sum S (1 - S) h F / T less
than into one without segments, S the share of the nodes on one side of a segment: that is 1/4 at every u. On
straight segments a load would roll over bumps of 0.25 h F / T, on parabolas (a B-spline) of 0.03 h F / T.
With r = p - X(u) from the curve to the node p, the nearest place is where g = r . r' = 0 and g' > 0, or an
end; shares a of the four nodes x: r = sum a x, r' = sum a' x, r'' = sum a'' x. How it changes with the nodes:
    grad u = -(a r' + a' r) / g',    g' = r' . r' + r . r''
Beyond a broken end it goes on straight: what is there at the end of a step has run off.
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
    HIGH,
    HIGHEST,
    INSIDE,
    LOOSE,
    LOW,
    LOWEST,
    PER_PLACE,
    PLACE,
    R1,
    R2,
    RATE,
    SHARE,
    SLOPE,
    STRETCHES,
    TURNS,
    R,
)

ROUNDS = 60
BEYOND = 2.0  # [1] segments beyond a broken end, within a step
LEAST = 0.05  # [1] of g' over r' . r'
FOLDED = 0.05  # [1] of |r'| over the segments' length: less is a cusp, see `slide_force`
STRIDE = 1.0 / 16.0  # [1] segments: so far apart places downhill are looked at
NEAR = 1e-13  # [1] segments: a shorter step of Newton's is the last


@small
def piece_of(u, ends):
    """Return the piece on which a place lies, one about each node between the `ends`."""
    return min(max(math.floor(u + 0.5), ends[LOW]), ends[HIGH])


@small
def shares(u, piece, ends):
    """Return shares of three nodes in X, X', of the middle one in X'', and the middle one.

    The others have minus half of those each.
    """
    if piece == ends[LOW] or piece == ends[HIGH]:
        left = ends[LOW] if piece == ends[LOW] else ends[HIGH] - 1
        s = u - left
        if left == ends[LOWEST] or (piece == ends[LOW] and left + 2 <= ends[HIGHEST]):
            return 1.0 - s, s, 0.0, -1.0, 1.0, 0.0, 0.0, left + 1
        return 0.0, 1.0 - s, s, 0.0, -1.0, 1.0, 0.0, left
    s = u - piece
    q = math.sqrt(0.5 - s * s)
    turn = -s / q
    left, right = 0.5 * (1.0 - s - q), 0.5 * (1.0 + s - q)
    bend = -0.5 / (q * q * q)
    return left, q, right, 0.5 * (-1.0 - turn), turn, 0.5 * (1.0 - turn), bend, piece


@kernel
def point_at(x, first, ends, u):
    """Return a place of the curve [m], of a rope's first node and `ends`, see `table`; `x` is (3, n)."""
    w0, w1, w2, _, _, _, _, middle = shares(u, piece_of(u, ends), ends)
    i = first + middle
    return (
        w0 * x[0, i - 1] + w1 * x[0, i] + w2 * x[0, i + 1],
        w0 * x[1, i - 1] + w1 * x[1, i] + w2 * x[1, i + 1],
        w0 * x[2, i - 1] + w1 * x[2, i] + w2 * x[2, i + 1],
    )


@small
def condition(x, node, first, ends, u, piece):
    """Return g and g' at a place [m^2]."""
    w0, w1, w2, d0, d1, d2, bend, middle = shares(u, piece, ends)
    i, g, slope = first + middle, 0.0, 0.0
    for k in range(3):
        a, b, c = x[k, i - 1], x[k, i], x[k, i + 1]
        r = x[k, node] - (w0 * a + w1 * b + w2 * c)
        t = d0 * a + d1 * b + d2 * c
        g -= r * t
        slope += t * t - r * bend * (b - 0.5 * (a + c))
    return g, slope


@kernel
def root(x, node, first, ends, low, high):
    """Return a place between two, g < 0 < g there, at which g is zero."""
    u = 0.5 * (low + high)
    for _ in range(ROUNDS):
        g, slope = condition(x, node, first, ends, u, piece_of(u, ends))
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
        if way <= 4e-16 * max(abs(u), 1.0):
            break
    return u


@small
def bounds_of(ends):
    """Return the first and the last place there can be: a stop, or somewhat beyond a broken end."""
    return ends[LOW] - BEYOND * ends[LOOSE], ends[HIGH] + BEYOND * ends[LOOSE + 1]


@kernel
def place_beside(x, node, first, ends, start):
    """Return the place that Newton's steps lead to from `start`, each shorter than the last; nan: to none.

    Where a rope folds there are several near each other; this is the one that the node is at.
    """
    least, most = bounds_of(ends)
    u, last = min(max(start, least), most), math.inf
    for _ in range(ROUNDS):
        g, slope = condition(x, node, first, ends, u, piece_of(u, ends))
        if not (slope > 0.0 and abs(g) < last * slope):
            return math.nan
        last = abs(g) / slope
        new = min(max(u - g / slope, least), most)
        way, u = abs(new - u), new
        if way <= 4e-16 * max(abs(u), 1.0) or last < NEAR:
            return u
    return math.nan


@kernel
def nearest_place(x, node, first, ends, start):
    """Return the place on the rope that is nearest to a node, downhill from `start`."""
    u = place_beside(x, node, first, ends, start)
    if u == u:
        return u
    least, most = bounds_of(ends)
    u = min(max(start, least), most)
    side = -1.0 if condition(x, node, first, ends, u, piece_of(u, ends))[0] > 0.0 else 1.0
    end = least if side < 0.0 else most
    while u != end:
        new = min(max(u + side * STRIDE, least), most)
        if side * condition(x, node, first, ends, new, piece_of(new, ends))[0] >= 0.0:
            return root(x, node, first, ends, min(u, new), max(u, new))
        u = new
    return u


@kernel
def look(x, table, memory, row):
    """Write where a slide is at places (3, n) and what it needs of the curve there, see `table`."""
    node, first, ends = table.node[row], table.first[row], memory.ends[row]
    sight, group = memory.sight, memory.group
    u = nearest_place(x, node, first, ends, memory.grip[row, PLACE])
    w0, w1, w2, d0, d1, d2, bend, middle = shares(u, piece_of(u, ends), ends)
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
    square, speed, slope, stretches = 0.0, 0.0, 0.0, 0.0
    for k in range(3):
        square += sight[row, R + k] * sight[row, R + k]
        speed += sight[row, R1 + k] * sight[row, R1 + k]
        slope += sight[row, R + k] * sight[row, R2 + k]
        stretches += sight[row, R1 + k] * sight[row, R2 + k]
    slope = max(speed + slope, LEAST * speed)
    least, most = bounds_of(ends)
    inside = least < u < most and speed > 0.0
    sight[row, AT], sight[row, APART], sight[row, SLOPE] = u, math.sqrt(square), slope
    folded = (FOLDED * table.length[row]) ** 2
    sight[row, PER_PLACE] = slope / math.sqrt(max(speed, folded)) if inside else 0.0
    sight[row, TURNS] = 1.0 / speed if inside and speed > folded else 0.0
    sight[row, STRETCHES] = stretches * sight[row, TURNS]
    sight[row, INSIDE] = 1.0 if inside else 0.0
    for m in range(4):
        a, b = sight[row, SHARE + m], sight[row, RATE + m]
        for k in range(3):
            turn = a * sight[row, R1 + k] + b * sight[row, R + k]
            sight[row, GRADIENT + 3 * m + k] = -turn / slope if inside else 0.0
