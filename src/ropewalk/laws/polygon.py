"""Friction of nodes round a surface: that of the arcs which they stand for.

Where nodes turn towards a surface by the angle a each, a polygon's tensions grow by more than exp(mu a). So
mu is replaced by mu' = tan p,
    tan p = tanh(mu a / 2) / tan(a / 2),
with which two equal chords have exactly T2 / T1 = (1 + mu' tan(a/2)) / (1 - mu' tan(a/2)) = exp(mu a).

The first and the last node on a round are not pressed along the middle of their turn but off it, by e towards
where the rope comes from, up to half the angle of a segment; so are all where it is pressed in deeper and
deeper. Such a one slips at T2 / T1 = cos(a/2 + e - q) / cos(a/2 - e + q) if mu' = tan q. On bodies that are
round it has
    q = p + c e,
exp(mu a) again, c the cosine between the rope and its pull on what rubs: 1 where tension grows along it, -1
where it falls. That is the cone of p about the middle of the turn. e counts up to NEARLY p, so that friction
takes, HALF_WAY from p to a right angle, and half a segment's angle: more of it is another rope's, or weight.
With segments longer than FINE radii, as knots on a bar have, nothing of it counts. Boxes and meshes lack it:
they have flat faces.

e changes as a node moves by a part of a segment, so that what it was a step ago were too much or too little
by v dt / 2 R at both ends of a round. So it is looked at where the forces are; c is that of the last step.
"""

from __future__ import annotations

import math

from ropewalk.core.jit import kernel
from ropewalk.laws.contact_frame import AHEAD, GRIP, surface_at
from ropewalk.laws.obstacle_shapes import CAPSULE, CYLINDER, SPHERE, TORUS, probe

LEVEL = 1e-6  # [rad] a node that turns by less lies straight
NEARLY = 0.95  # [1] with all of p friction one way were 0, and would not tell which way it was
HALF_WAY = 0.5  # [1] to a right angle: beyond that friction were less than none
FINE = 0.35  # [1] longest segment over the radius
MOVES = 1e-3  # [rad] a node that is off the middle by less is between others, where nothing changes


@kernel
def find_frictions(x, obstacles, memory, now, lo, hi):
    """Write the coefficients of those of nodes `lo` to `hi - 1` that are first or last on a round at `x`."""
    for o in range(obstacles.kind.shape[0]):
        if not is_round(obstacles, o):
            continue
        grip, kind, center = memory.grip[o], obstacles.kind[o], obstacles.center[o]
        axis, size = obstacles.axis[o], obstacles.size[o]
        mx, my, mz, _, _, _, _, _ = surface_at(obstacles, o, now[0])
        for i in range(lo, hi):
            if grip[AHEAD, i] != 0.0:
                px, py, pz = x[0, i] - mx, x[1, i] - my, x[2, i] - mz
                _, nx, ny, nz, ax, ay, az, ca, cb = probe(kind, center, axis, size, px, py, pz)
                rise, fall = slopes(x, i, nx, ny, nz)
                middle = on_polygon(obstacles.friction[o, i], rise + fall)
                counts = counting(x, i, (ax, ay, az), ca, cb, middle)
                grip[GRIP, i] = off_middle(middle, rise, fall, grip[AHEAD, i], counts)


@kernel
def keep_friction(x, obstacles, memory, o, i, probed, stiffness):
    """Keep the coefficient of node `i` on an obstacle that rubs on it as `Memory.grip` has it.

    `probed` is what `probe` tells of its surface there, from n on.
    """
    grip = memory.grip[o]
    rubs = grip[0, i], grip[1, i], grip[2, i]
    grip[GRIP, i], grip[AHEAD, i] = node_friction(obstacles, o, x, i, probed, rubs, stiffness)


@kernel
def node_friction(obstacles, o, x, i, probed, rubs, stiffness):
    """Return the coefficient of node `i` on an obstacle that rubs on it [N], and what to keep as AHEAD.

    That is 0 where nothing rubs, or it is pressed along the middle of its turn.
    """
    nx, ny, nz, ax, ay, az, ca, cb = probed
    rise, fall = 0.0, 0.0
    if lies_inside(x, i, stiffness):
        rise, fall = slopes(x, i, nx, ny, nz)
    middle = on_polygon(obstacles.friction[o, i], rise + fall)
    if rise + fall < LEVEL or not middle > 0.0 or not is_round(obstacles, o):
        return middle, 0.0
    counts = counting(x, i, (ax, ay, az), ca, cb, middle)
    ahead = pulls_ahead(x, i, nx, ny, nz, rubs[0], rubs[1], rubs[2])
    if counts == 0.0 or ahead == 0.0:
        return middle, 0.0
    found = off_middle(middle, rise, fall, ahead, counts)
    return found, ahead if abs(rise - fall) > MOVES else 0.0


@kernel
def counting(x, i, a, ca, cb, middle):
    """Return up to which angle a normal off the middle counts [rad]; `a`, `ca`, `cb` as of `probe`."""
    step, p = max(angle_of(x, i - 1, a, ca, cb), angle_of(x, i, a, ca, cb)), math.atan(middle)
    if not 0.0 < step <= FINE:  # nor on the inside of a ring
        return 0.0
    return min(0.5 * step, NEARLY * p, HALF_WAY * (0.5 * math.pi - p))


@kernel
def angle_of(x, i, a, ca, cb):
    """Return a segment's length over the radius of the surface along it [1]."""
    dx, dy, dz = x[0, i + 1] - x[0, i], x[1, i + 1] - x[1, i], x[2, i + 1] - x[2, i]
    square, along = dx * dx + dy * dy + dz * dz, a[0] * dx + a[1] * dy + a[2] * dz
    if not square > 0.0:
        return 0.0
    part = along * along / square
    return math.sqrt(square) * (ca * (1.0 - part) + cb * part)


@kernel
def is_round(obstacles, o):
    """Tell whether a body is round about what a rope turns round, and does not sweep as it turns."""
    kind = obstacles.kind[o]
    rounds = kind == SPHERE or kind == CYLINDER or kind == CAPSULE or kind == TORUS
    return rounds and not obstacles.sweeps[o]


@kernel
def lies_inside(x, i, stiffness):
    """Tell whether a segment leads to node `i` and another one on from it."""
    inner = i > 0 and i < x.shape[1] - 1
    return inner and stiffness[i - 1] != 0.0 and stiffness[i] != 0.0


@kernel
def slopes(x, i, nx, ny, nz):
    """Return how steeply a rope rises to node `i` from a surface of this normal, and falls after it [rad].

    Both 0 where it does not turn towards it. All of the angle between the segments in a plane with the normal
    counts, nothing of it within the surface, as in a bight on a floor.
    """
    ax, ay, az = x[0, i] - x[0, i - 1], x[1, i] - x[1, i - 1], x[2, i] - x[2, i - 1]
    bx, by, bz = x[0, i + 1] - x[0, i], x[1, i + 1] - x[1, i], x[2, i + 1] - x[2, i]
    before, after = nx * ax + ny * ay + nz * az, nx * bx + ny * by + nz * bz
    if before <= 0.0 and after >= 0.0:  # away from it
        return 0.0, 0.0
    a, b = math.sqrt(ax * ax + ay * ay + az * az), math.sqrt(bx * bx + by * by + bz * bz)
    if not (a > 0.0 and b > 0.0):
        return 0.0, 0.0
    before, after = before / a, after / b
    if not before > after:
        return 0.0, 0.0
    before, after = min(max(before, -1.0), 1.0), min(max(after, -1.0), 1.0)
    return math.asin(before), -math.asin(after)


@kernel
def turn_towards(x, i, nx, ny, nz, stiffness):
    """Return the angle by which the rope turns at node `i` towards a surface of this normal [rad]; else 0."""
    if not lies_inside(x, i, stiffness):
        return 0.0
    rise, fall = slopes(x, i, nx, ny, nz)
    return rise + fall


@kernel
def on_polygon(friction, turn):
    """Return the coefficient with which a node that turns by `turn` [rad] acts as its arc would."""
    if turn < LEVEL:
        return friction
    return math.tanh(0.5 * friction * turn) / math.tan(0.5 * turn)


@kernel
def off_middle(middle, rise, fall, ahead, counts):
    """Return the coefficient of a node between such slopes [rad], `middle` were they alike.

    `ahead` is the cosine between the rope and what it pulls with on what rubs.
    """
    off = min(max(0.5 * (rise - fall), -counts), counts)
    return math.tan(math.atan(middle) + ahead * off)


@kernel
def pulls_ahead(x, i, nx, ny, nz, rx, ry, rz):
    """Return the cosine between the rope at node `i` along a surface and its pull on what rubs; 0: none."""
    tx, ty, tz, size = 0.0, 0.0, 0.0, math.sqrt(rx * rx + ry * ry + rz * rz)
    if not size > 0.0:
        return 0.0
    for j in (i - 1, i):
        ax, ay, az = x[0, j + 1] - x[0, j], x[1, j + 1] - x[1, j], x[2, j + 1] - x[2, j]
        a = math.sqrt(ax * ax + ay * ay + az * az)
        tx, ty, tz = tx + ax / a, ty + ay / a, tz + az / a
    across = nx * tx + ny * ty + nz * tz
    tx, ty, tz = tx - across * nx, ty - across * ny, tz - across * nz
    along = math.sqrt(tx * tx + ty * ty + tz * tz)
    if not along > 0.0:
        return 0.0
    return -(tx * rx + ty * ry + tz * rz) / (along * size)
