"""Where an anchor is at a time: position and velocity of every kind of motion.

Each kind is a branch over a row of parameters; positions are absolute, `origin` is the node's own start.
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
def place_velocity(p, t, x, v):
    """Place a point that moves at a velocity during an interval (velocity right-continuous)."""
    elapsed = min(max(t - p[6], 0.0), p[7] - p[6])
    moving = 1.0 if p[6] <= t < p[7] else 0.0
    for k in range(3):
        x[k] = p[k] + p[3 + k] * elapsed
        v[k] = p[3 + k] * moving


@kernel
def place_shake(p, t, x, v):
    """Place a point that shakes harmonically along an axis."""
    rate = 2.0 * math.pi * p[6]
    offset = math.sin(rate * t + p[7]) - math.sin(p[7])
    speed = rate * math.cos(rate * t + p[7])
    for k in range(3):
        x[k] = p[k] + p[3 + k] * offset
        v[k] = p[3 + k] * speed


@kernel
def place_orbit(p, t, x, v):
    """Place a point on its circle about an axis (Rodrigues' rotation)."""
    rate = 2.0 * math.pi * p[9]
    c, s = math.cos(rate * t), math.sin(rate * t)
    ex, ey, ez = p[6], p[7], p[8]
    rx, ry, rz = p[0] - p[3], p[1] - p[4], p[2] - p[5]
    along = (ex * rx + ey * ry + ez * rz) * (1.0 - c)
    qx = c * rx + s * (ey * rz - ez * ry) + along * ex
    qy = c * ry + s * (ez * rx - ex * rz) + along * ey
    qz = c * rz + s * (ex * ry - ey * rx) + along * ez
    x[0], x[1], x[2] = p[3] + qx, p[4] + qy, p[5] + qz
    v[0] = rate * (ey * qz - ez * qy)
    v[1] = rate * (ez * qx - ex * qz)
    v[2] = rate * (ex * qy - ey * qx)


@kernel
def place_table(table, first, rows, t, x, v):
    """Place a point on its table: row = time, then c0..c3 of x, y, z in the time since the row."""
    low, high = first, first + rows - 1
    if t >= table[high, 0]:
        low = high
    else:
        while high - low > 1:
            middle = (low + high) // 2
            if table[middle, 0] <= t:
                low = middle
            else:
                high = middle
    s = max(t - table[low, 0], 0.0)
    moving = 1.0 if table[first, 0] <= t and low < first + rows - 1 else 0.0
    for k in range(3):
        c = 1 + 4 * k
        x[k] = table[low, c] + s * (
            table[low, c + 1] + s * (table[low, c + 2] + s * table[low, c + 3])
        )
        v[k] = moving * (
            table[low, c + 1] + s * (2.0 * table[low, c + 2] + s * 3.0 * table[low, c + 3])
        )
        if low == first + rows - 1:
            x[k] = table[low, c]


@part
def place(anchors, row, t, x, v):
    """Write position and velocity of anchor `row` at time `t` [s]; a hand's place is left alone."""
    kind = anchors.kind[row]
    p = anchors.params[row]
    if kind == FIXED:
        for k in range(3):
            x[k] = p[k]
            v[k] = 0.0
    elif kind == VELOCITY:
        place_velocity(p, t, x, v)
    elif kind == TABLE:
        place_table(anchors.table, anchors.table_start[row], anchors.table_rows[row], t, x, v)
    elif kind == SHAKE:
        place_shake(p, t, x, v)
    elif kind == ORBIT:
        place_orbit(p, t, x, v)
