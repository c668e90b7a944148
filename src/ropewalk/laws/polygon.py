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
where it falls, 0 where friction holds it across. e counts up to NEARLY p, so that friction takes, HALF_WAY
from p to a right angle, and half a segment's angle: more of it is another rope's, or weight. With segments
longer than FINE radii, as knots on a bar have, nothing of it counts. Boxes and meshes lack it: they have flat
faces.

e changes as a node moves by a part of a segment, so that what it was a step ago were too much or too little
by v dt / 2 R at both ends of a round. So the coefficient goes on with the time as it would if the nodes went
on as they do: by no place within the step, so that tangents lack nothing. It goes on until e is all that
counts, however much longer the next step is.
"""

from __future__ import annotations

import math

from ropewalk.core.jit import kernel, small
from ropewalk.laws.contact_frame import GRIP, GROWS, LASTS
from ropewalk.laws.obstacle_pose import body_of, pose_of, probe_turned
from ropewalk.laws.obstacle_shapes import CAPSULE, CYLINDER, SPHERE, TORUS

LEVEL = 1e-6  # [rad] a node that turns by less lies straight
NEARLY = 0.95  # [1] with all of p friction one way were 0, and would not tell which way it was
HALF_WAY = 0.5  # [1] to a right angle: beyond that friction were less than none
FINE = 0.35  # [1] longest segment over the radius
MOVES = 1e-3  # [rad] a node that is off the middle by less is between others, where nothing changes


@small
def keep_friction(x, v, obstacles, grip, o, i, pull, probed, place, angle, dt, stiffness):
    """Keep the coefficient of node `i` on an obstacle, and its rate [1/s] by what the next `dt` [s] bring.

    `pull` (3) [N] is what rubs at the node, spring and damper: its limit is told by the same one, of a frame.
    `probed` is what `probe` tells of its surface there, from n on; `place` is where the node will be in the
    frame of the body [m], and `angle` how far that will have turned [rad].
    """
    _, middle, off, _ = turned_by(x, v, obstacles, o, i, probed, 0.0, stiffness)
    grip[GRIP, i], grip[GROWS, i] = middle, 0.0
    if off == 0.0:
        return
    c = pulls_ahead(x, i, probed[0], probed[1], probed[2], *pull)
    grip[GRIP, i] = tilted(middle, off, c)
    if c == 0.0 or not abs(off) > MOVES or not dt > 0.0:
        return
    body, pose = body_of(obstacles, o), pose_of(obstacles, o, angle)
    _, nx, ny, nz, ax, ay, az, ca, cb = probe_turned(body, pose, place[0], place[1], place[2])
    later = (nx, ny, nz, ax, ay, az, ca, cb)
    _, middle, off, counts = turned_by(x, v, obstacles, o, i, later, dt, stiffness)
    change = tilted(middle, off, c) - grip[GRIP, i]
    most = tilted(middle, math.copysign(counts, c * change), c) - grip[GRIP, i]
    grip[GROWS, i] = change / dt
    grip[LASTS, i] = dt * max(most / change, 1.0) if change != 0.0 else dt


@small
def turned_by(x, v, obstacles, o, i, probed, dt, stiffness):
    """Return a node's turn towards an obstacle [rad], tan p, e as far as it counts, and how far [rad].

    `probed` as of `keep_friction`, in `dt` [s] at velocities as they are.
    """
    nx, ny, nz, ax, ay, az, ca, cb = probed
    rise, fall = 0.0, 0.0
    if lies_inside(x, i, stiffness):
        rise, fall = slopes(x, v, i, nx, ny, nz, dt)
    turn = max(rise + fall, 0.0)
    middle = on_polygon(obstacles.friction[o, i], turn)
    if turn < LEVEL or not is_round(obstacles, o):
        return turn, middle, 0.0, 0.0
    a = (ax, ay, az)
    counts = counting(max(angle_of(x, i - 1, a, ca, cb), angle_of(x, i, a, ca, cb)), middle)
    return turn, middle, min(max(0.5 * (rise - fall), -counts), counts), counts


@small
def tilted(middle, off, ahead):
    """Return tan(p + c e) for tan p = `middle`, e = `off` [rad].

    `ahead` is c, the cosine between the rope and what it pulls with on what rubs.
    """
    if off == 0.0:
        return middle
    return math.tan(math.atan(middle) + ahead * off)


@small
def counting(step, middle):
    """Return up to which angle a normal off the middle counts [rad]; `step` a segment's angle."""
    p = math.atan(middle)
    if not 0.0 < step <= FINE:  # nor on the inside of a ring
        return 0.0
    return max(min(0.5 * step, NEARLY * p, HALF_WAY * (0.5 * math.pi - p)), 0.0)


@small
def angle_of(x, i, a, ca, cb):
    """Return a segment's length over the radius of the surface along it [1]."""
    dx, dy, dz = x[0, i + 1] - x[0, i], x[1, i + 1] - x[1, i], x[2, i + 1] - x[2, i]
    square, along = dx * dx + dy * dy + dz * dz, a[0] * dx + a[1] * dy + a[2] * dz
    if not square > 0.0:
        return 0.0
    part = along * along / square
    return math.sqrt(square) * (ca * (1.0 - part) + cb * part)


@small
def is_round(obstacles, o):
    """Tell whether a body is round about what a rope turns round."""
    kind = obstacles.kind[o]
    return kind == SPHERE or kind == CYLINDER or kind == CAPSULE or kind == TORUS


@small
def lies_inside(x, i, stiffness):
    """Tell whether a segment leads to node `i` and another one on from it."""
    inner = i > 0 and i < x.shape[1] - 1
    return inner and stiffness[i - 1] != 0.0 and stiffness[i] != 0.0


@small
def slopes(x, v, i, nx, ny, nz, dt):
    """Return how steeply a rope rises to node `i` from a surface of this normal, and falls after it [rad].

    In `dt` [s], at velocities as they are. Both 0 where it does not turn towards it. All of the angle
    between the segments in a plane with the normal counts, nothing of it within the surface, as in a bight on
    a floor.
    """
    ax, ay, az = x[0, i] - x[0, i - 1], x[1, i] - x[1, i - 1], x[2, i] - x[2, i - 1]
    bx, by, bz = x[0, i + 1] - x[0, i], x[1, i + 1] - x[1, i], x[2, i + 1] - x[2, i]
    if dt > 0.0:
        ax, ay = ax + dt * (v[0, i] - v[0, i - 1]), ay + dt * (v[1, i] - v[1, i - 1])
        bx, by = bx + dt * (v[0, i + 1] - v[0, i]), by + dt * (v[1, i + 1] - v[1, i])
        az, bz = az + dt * (v[2, i] - v[2, i - 1]), bz + dt * (v[2, i + 1] - v[2, i])
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
    rise, fall = slopes(x, x, i, nx, ny, nz, 0.0)
    return max(rise + fall, 0.0)


@small
def on_polygon(friction, turn):
    """Return the coefficient with which a node that turns by `turn` [rad] acts as its arc would."""
    if turn < LEVEL:
        return friction
    return math.tanh(0.5 * friction * turn) / math.tan(0.5 * turn)


@small
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
