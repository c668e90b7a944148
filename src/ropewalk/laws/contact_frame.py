"""What contacts are seen in: how a body has moved and turned, and a friction spring carried along with it."""

from __future__ import annotations

import math

from ropewalk.core.jit import kernel, small
from ropewalk.laws.obstacle_pose import body_of, drawn_place, pose_of, probe_turned, rotated
from ropewalk.motions.whereabouts import place_now

# Rows of `Memory.grip` after the spring's force: the coefficient of friction, R_n, the spring's stiffness,
# the damper, the rate of the coefficient and how long it lasts, see `polygon`.
GRIP, PUSH, STIFF, DAMP, GROWS, LASTS, GRIPS = 3, 4, 5, 6, 7, 8, 9
STILL = 0.02  # [1] diameters by which a contact may close in a step that strikes nothing
TOUCHES = 1e-9  # [1] depth over the diameter up to which what is drawn just touching is open
STOPS = 0.5  # [1] longest step that follows how a contact stops what strikes it, over 2 sqrt(m / k)
SURELY = 0.99  # [1] square below which a vector is not too long, whatever rounding does: most take no root
# Of what is thrown back: how much shorter steps are, and from what way across in one on, in diameters [1].
OFTENER, MOVES = 5.0, 5e-4


@kernel
def surface_at(obstacles, row, t):
    """Return how far an obstacle has moved [m], its velocity [m/s], its angle [rad] and its rate [rad/s].

    Velocity and rate are those just after time `t` [s].
    """
    center, spin = obstacles.center[row], obstacles.spin
    x, y, z, vx, vy, vz = place_now(obstacles.motion, row, t)
    by_table = place_now(obstacles.turns, row, t)
    angle = spin[row, 0] * min(max(t - spin[row, 1], 0.0), spin[row, 2] - spin[row, 1])
    rate = spin[row, 0] if spin[row, 1] <= t < spin[row, 2] else 0.0
    dx, dy, dz = x - center[0], y - center[1], z - center[2]
    return dx, dy, dz, vx, vy, vz, angle + by_table[0], rate + by_table[3]


@kernel
def surface_by(obstacles, o, t, x, y, z):
    """Return what `probe` does of obstacle o as it lies at time `t` [s], for a place of the scene [m]."""
    mx, my, mz, _, _, _, angle, _ = surface_at(obstacles, o, t)
    pose = pose_of(obstacles, o, angle)
    return probe_turned(body_of(obstacles, o), pose, x - mx, y - my, z - mz)


@kernel
def drawn_from(obstacles, o, t, x, y, z):
    """Return where a place at time `t` [s] was before obstacle o moved and turned, three numbers [m]."""
    mx, my, mz, _, _, _, angle, _ = surface_at(obstacles, o, t)
    pose = pose_of(obstacles, o, angle)
    return drawn_place(body_of(obstacles, o), pose, x - mx, y - my, z - mz)


@kernel
def find_gaps(x, obstacles, t, found):
    """Write the distances of places (3, n) to every obstacle at time `t` [s], (k, n) [m]."""
    for o in range(obstacles.kind.shape[0]):
        mx, my, mz, _, _, _, angle, _ = surface_at(obstacles, o, t)
        body, pose = body_of(obstacles, o), pose_of(obstacles, o, angle)
        for i in range(x.shape[1]):
            px, py, pz = x[0, i] - mx, x[1, i] - my, x[2, i] - mz
            found[o, i] = probe_turned(body, pose, px, py, pz)[0]


@small
def turn_of(angle):
    """Return cosine and sine of the angle by which a body has turned."""
    if angle == 0.0:
        return 1.0, 0.0
    return math.cos(angle), math.sin(angle)


@small
def carried(hub, axle, angle, then, grip, place, i, x, y, z, turn):
    """Return the spring's force R' [N] and the way D [m], both turned with the surface by `angle`.

    x, y, z in the frame of the body; `then` is what `surface_at` gives for when `place` was kept. `turn` is
    cosine and sine of the angle for the way, or what `obstacle_lead` has for them.
    """
    fx, fy, fz = grip[0, i], grip[1, i], grip[2, i]
    ox = place[0, i] - then[0] - hub[0]
    oy = place[1, i] - then[1] - hub[1]
    oz = place[2, i] - then[2] - hub[2]
    if angle != 0.0 or turn[1] != 0.0:
        c, s = math.cos(angle), math.sin(angle)
        fx, fy, fz = rotated(axle, c, s, fx, fy, fz)
        ox, oy, oz = rotated(axle, turn[0], turn[1], ox, oy, oz)
    return fx, fy, fz, x - hub[0] - ox, y - hub[1] - oy, z - hub[2] - oz


@small
def spring_pull(k, hub, axle, angle, then, grip, place, i, x, y, z, turn):
    """Return R' - k D [N]."""
    fx, fy, fz, dx, dy, dz = carried(hub, axle, angle, then, grip, place, i, x, y, z, turn)
    return fx - k * dx, fy - k * dy, fz - k * dz


@small
def cut(x, y, z, bound):
    """Return a vector, no longer than `bound`."""
    square = x * x + y * y + z * z
    if square < SURELY * bound * bound:
        return x, y, z
    total = math.sqrt(square)
    if total > bound:
        share = bound / total
        return x * share, y * share, z * share
    return x, y, z


@small
def friction_at(grip, i, since):
    """Return the coefficient of a node, so long [s] after `grip` was kept."""
    return max(grip[GRIP, i] + grip[GROWS, i] * min(since, grip[LASTS, i]), 0.0)
