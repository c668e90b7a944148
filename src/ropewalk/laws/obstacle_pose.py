"""How bodies lie that have turned, and how their surfaces move.

The surface of a body of revolution that turns about its own axis stays where it is, and slides along itself.
Those of all others sweep (`Obstacles.sweeps`): with the angle a about the axle e through the hub, and w its
rate, places are turned back to where the body was drawn, and what `probe` finds there is turned along. A
place of the surface, o from the hub, goes at w e x o.
"""

from __future__ import annotations

import math

from ropewalk.core.jit import kernel, part, small
from ropewalk.laws.obstacle_shapes import probe
from ropewalk.motions.registry import FIXED


@small
def rotated(axis, c, s, x, y, z):
    """Return a vector turned about an axis by the angle of cosine `c` and sine `s`."""
    ex, ey, ez = axis[0], axis[1], axis[2]
    along = (ex * x + ey * y + ez * z) * (1.0 - c)
    return (
        c * x + s * (ey * z - ez * y) + along * ex,
        c * y + s * (ez * x - ex * z) + along * ey,
        c * z + s * (ex * y - ey * x) + along * ez,
    )


@kernel
def pose_of(obstacles, o, angle):
    """Return cosine and sine of the angle by which a surface has turned; 1, 0 of a round one."""
    if angle != 0.0 and obstacles.sweeps[o]:
        return math.cos(angle), math.sin(angle)
    return 1.0, 0.0


@kernel
def rates_of(obstacles, o, rate):
    """Return the angular velocity [rad/s] at which a surface slides along itself, and at which it sweeps.

    (3) each; one of both is nothing.
    """
    axle, none = obstacles.axle[o], (0.0, 0.0, 0.0)
    turning = (rate * axle[0], rate * axle[1], rate * axle[2])
    if obstacles.sweeps[o]:
        return none, turning
    return turning, none


@small
def swept(ux, uy, uz, sweep, ox, oy, oz):
    """Return the velocity u + W x o of a place of a body that moves at u, its surface sweeping at W [m/s]."""
    wx, wy, wz = sweep
    return ux + (wy * oz - wz * oy), uy + (wz * ox - wx * oz), uz + (wx * oy - wy * ox)


@small
def body_of(obstacles, o):
    """Return kind, middle, axis, axle, size and hub of obstacle o, for loops over nodes; for kernels only."""
    center, axis, axle = obstacles.center[o], obstacles.axis[o], obstacles.axle[o]
    return obstacles.kind[o], center, axis, axle, obstacles.size[o], obstacles.hub[o]


@small
def drawn_place(body, pose, x, y, z):
    """Return where a place was before the body turned; x, y, z in the frame that moves with it [m]."""
    _, _, _, axle, _, hub = body
    c, s = pose
    if s == 0.0 and c == 1.0:
        return x, y, z
    ox, oy, oz = rotated(axle, c, -s, x - hub[0], y - hub[1], z - hub[2])
    return hub[0] + ox, hub[1] + oy, hub[2] + oz


@small
def probe_turned(body, pose, x, y, z):
    """Return what `probe` does of a body, see `body_of`, as it lies; x, y, z as for `drawn_place`."""
    kind, center, axis, axle, size, _ = body
    c, s = pose
    x, y, z = drawn_place(body, pose, x, y, z)
    g, nx, ny, nz, ax, ay, az, ca, cb = probe(kind, center, axis, size, x, y, z)
    if s != 0.0 or c != 1.0:
        nx, ny, nz = rotated(axle, c, s, nx, ny, nz)
        ax, ay, az = rotated(axle, c, s, ax, ay, az)
    return g, nx, ny, nz, ax, ay, az, ca, cb


@part
def all_stand(obstacles):
    """Tell whether no body ever moves or turns."""
    moving = 0
    for o in range(obstacles.kind.shape[0]):
        moving += 1 if obstacles.motion.kind[o] != FIXED or obstacles.turns.kind[o] != FIXED else 0
        moving += 1 if obstacles.wheel[o] >= 0 else 0
        moving += 1 if obstacles.spin[o, 0] != 0.0 else 0
    return moving == 0
