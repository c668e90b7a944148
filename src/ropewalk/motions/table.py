"""Where an anchor or an obstacle is at a time: position and velocity of every kind of motion.

Each kind is a branch over a row of parameters; positions are absolute, `origin` is the start of the node, or
of the body's middle.
    fixed     x = origin
    velocity  x = origin + u clamp(t - start, 0, stop - start)         params 3..5 u, 6 start, 7 stop
    table     piecewise cubic in the motion's own table (linear is a cubic with two zero coefficients);
              constant before the first and after the last row
    shake     x = origin + A e sin(2 pi f t + phase) - its value at t = 0   params 3..5 A e, 6 f, 7 phase
    orbit     x = centre + R(axis, 2 pi f t) (origin - centre)         params 3..5 centre, 6..8 axis, 9 f
    hand      the host sets the velocity; the position is its sum over the steps
"""

from __future__ import annotations

import math

from ropewalk.core.jit import kernel, part

FIXED, VELOCITY, TABLE, SHAKE, ORBIT, HAND = range(6)
CODES = {
    "fixed": FIXED,
    "velocity": VELOCITY,
    "table": TABLE,
    "shake": SHAKE,
    "orbit": ORBIT,
    "hand": HAND,
}


@kernel
def place_velocity(p, t):
    """Return place and velocity of a point that moves during an interval (velocity right-continuous)."""
    elapsed = min(max(t - p[6], 0.0), p[7] - p[6])
    moving = 1.0 if p[6] <= t < p[7] else 0.0
    return (
        p[0] + p[3] * elapsed,
        p[1] + p[4] * elapsed,
        p[2] + p[5] * elapsed,
        p[3] * moving,
        p[4] * moving,
        p[5] * moving,
    )


@kernel
def place_shake(p, t):
    """Return place and velocity of a point that shakes harmonically along an axis."""
    rate = 2.0 * math.pi * p[6]
    offset = math.sin(rate * t + p[7]) - math.sin(p[7])
    speed = rate * math.cos(rate * t + p[7])
    return (
        p[0] + p[3] * offset,
        p[1] + p[4] * offset,
        p[2] + p[5] * offset,
        p[3] * speed,
        p[4] * speed,
        p[5] * speed,
    )


@kernel
def place_orbit(p, t):
    """Return place and velocity of a point on its circle about an axis (Rodrigues' rotation)."""
    rate = 2.0 * math.pi * p[9]
    c, s = math.cos(rate * t), math.sin(rate * t)
    ex, ey, ez = p[6], p[7], p[8]
    rx, ry, rz = p[0] - p[3], p[1] - p[4], p[2] - p[5]
    along = (ex * rx + ey * ry + ez * rz) * (1.0 - c)
    qx = c * rx + s * (ey * rz - ez * ry) + along * ex
    qy = c * ry + s * (ez * rx - ex * rz) + along * ey
    qz = c * rz + s * (ex * ry - ey * rx) + along * ez
    return (
        p[3] + qx,
        p[4] + qy,
        p[5] + qz,
        rate * (ey * qz - ez * qy),
        rate * (ez * qx - ex * qz),
        rate * (ex * qy - ey * qx),
    )


@kernel
def table_row(table, first, rows, t):
    """Return the row of a table in which time `t` lies, and 1 where the point moves then, else 0."""
    low, high = first, first + rows - 1
    if t >= table[high, 0]:
        return high, 0.0
    while high - low > 1:
        middle = (low + high) // 2
        if table[middle, 0] <= t:
            low = middle
        else:
            high = middle
    return low, 1.0 if table[first, 0] <= t else 0.0


@kernel
def along_row(table, low, c, s, moving):
    """Return a coordinate `s` after the time of a row, whose c0 is in column `c`, and its rate."""
    c1, c2, c3 = table[low, c + 1], table[low, c + 2], table[low, c + 3]
    found = table[low, c] + s * (c1 + s * (c2 + s * c3))
    return found, moving * (c1 + s * (2.0 * c2 + s * 3.0 * c3))


@kernel
def place_table(table, first, rows, t):
    """Return place and velocity on a table: row = time, then c0..c3 of x, y, z in the time since the row."""
    low, moving = table_row(table, first, rows, t)
    s = max(t - table[low, 0], 0.0) if low < first + rows - 1 else 0.0
    x, vx = along_row(table, low, 1, s, moving)
    y, vy = along_row(table, low, 5, s, moving)
    z, vz = along_row(table, low, 9, s, moving)
    return x, y, z, vx, vy, vz


@part
def whereabouts(motions, row, t):
    """Return the place [m] and the velocity [m/s] of what moves by `row` at time `t` [s], six numbers.

    `motions` has the columns kind, params, table_start, table_rows and table of `core.arrays.Anchors`. A
    hand is where it began, at rest.
    """
    kind, p = motions.kind[row], motions.params[row]
    found = (p[0], p[1], p[2], 0.0, 0.0, 0.0)
    if kind == VELOCITY:
        found = place_velocity(p, t)
    elif kind == TABLE:
        found = place_table(motions.table, motions.table_start[row], motions.table_rows[row], t)
    elif kind == SHAKE:
        found = place_shake(p, t)
    elif kind == ORBIT:
        found = place_orbit(p, t)
    return found


@part
def place(anchors, row, t, x, v):
    """Write position and velocity of anchor `row` at time `t` [s]; a hand's place is left alone."""
    if anchors.kind[row] != HAND:
        x[0], x[1], x[2], v[0], v[1], v[2] = whereabouts(anchors, row, t)


@kernel
def place_now(motions, row, t):
    """Return what `whereabouts` does, for the host."""
    return whereabouts(motions, row, t)
