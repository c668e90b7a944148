"""Where obstacles are at a time, how far places are from them, and how fast their surfaces go."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING, Any

import numpy as np

from ropewalk.core.arrays import Floats
from ropewalk.laws.contact_frame import drawn_from, find_gaps, surface_at, surface_by
from ropewalk.laws.obstacle_pose import pose_of, rotated
from ropewalk.laws.obstacle_shapes import BOX, CAPSULE, CYLINDER, HALF_PIPE, MESH, PLANE, TORUS
from ropewalk.laws.triangles import NORMALS, ROUNDING, TRIANGLES
from ropewalk.motions.registry import FIXED
from ropewalk.motions.rows import largest_speed, motion_rows
from ropewalk.motions.whereabouts import place_now

if TYPE_CHECKING:
    from ropewalk.core.arrays import System
    from ropewalk.laws.obstacle import Obstacles


def depths(obstacles: Obstacles, x: Floats, t: float = 0.0) -> Floats:
    """Return how deep nodes at places (3, n) [m] are in every obstacle at time `t` [s], (k, n) [m].

    Negative outside.
    """
    return np.asarray(obstacles.thickness - gaps(obstacles, x, t))


def gaps(obstacles: Obstacles, x: Floats, t: float = 0.0) -> Floats:
    """Return the distances of places (3, n) [m] to every obstacle at time `t` [s], (k, n) [m]."""
    found = np.empty((len(obstacles.kind), x.shape[1]))
    find_gaps(x, obstacles, t, found)
    return found


def surface_near(obstacles: Obstacles, row: int, place: Floats, t: float = 0.0) -> Any:
    """Return the distance of a place (3,) [m] to an obstacle at time `t` [s], the normal there, and more.

    See `obstacle_shapes.probe`.
    """
    return surface_by(obstacles, row, t, *map(float, place))


def drawn_places(obstacles: Obstacles, row: int, places: Floats, t: float = 0.0) -> Floats:
    """Return where places (n, 3) [m] at time `t` [s] were before an obstacle moved and turned, (n, 3)."""
    found = [drawn_from(obstacles, row, t, *map(float, place)) for place in places]
    return np.array(found).reshape(-1, 3)


def moves(obstacles: Obstacles, row: int) -> bool:
    """Tell whether an obstacle's middle ever leaves the place where it starts."""
    return bool(obstacles.motion.kind[row] != FIXED)


def stays(obstacles: Obstacles, row: int) -> bool:
    """Tell whether an obstacle's surface is always where it starts; what is round may turn there."""
    turning = turning_rate(obstacles, row) > 0.0 or obstacles.wheel[row] >= 0
    return not moves(obstacles, row) and not (turning and obstacles.sweeps[row])


def turn_of(obstacles: Obstacles, row: int, t: float) -> Floats:
    """Return by which rotation a surface has turned at `t` [s], (3, 3); what is round by none."""
    return rotation_by(obstacles, row, surface_at(obstacles, row, t)[6])


def rotation_by(obstacles: Obstacles, row: int, angle: float) -> Floats:
    """Return the rotation of a surface turned by an angle [rad], (3, 3); what is round by none."""
    pose = pose_of(obstacles, row, angle)
    columns = [rotated(obstacles.axle[row], *pose, *one) for one in np.eye(3)]
    return np.array(columns).T


def moved_by(obstacles: Obstacles, row: int, t: float) -> Floats:
    """Return by how much an obstacle has moved at time `t` [s], (3,) [m]."""
    return np.array(place_now(obstacles.motion, row, t)[:3]) - obstacles.center[row]


def middle_at(obstacles: Obstacles, row: int, t: float) -> Floats:
    """Return where an obstacle's middle is at time `t` [s], (3,) [m]."""
    return middle_turned(obstacles, row, t, surface_at(obstacles, row, t)[6])


def middle_turned(obstacles: Obstacles, row: int, t: float, angle: float) -> Floats:
    """Return where the middle of an obstacle turned by an angle [rad] is at time `t` [s], (3,) [m]."""
    arm = obstacles.center[row] - obstacles.hub[row]
    turned = rotation_by(obstacles, row, angle) @ arm
    found: Floats = obstacles.hub[row] + moved_by(obstacles, row, t) + turned
    return found


def turning_rate(obstacles: Obstacles, row: int, until: float = math.inf) -> float:
    """Return the largest rate at which an obstacle turns before a time [s] [rad/s].

    Of a free one that sweeps that at the start.
    """
    w = obstacles.wheel[row]
    if w >= 0 and obstacles.sweeps[row]:
        return abs(float(obstacles.rate[w]))
    rate, start = obstacles.spin[row, :2]
    steady = abs(float(rate)) if start < until else 0.0
    return steady + largest_speed(obstacles.turns, row, until)


def surface_speed(obstacles: Obstacles, row: int, until: float = math.inf) -> float:
    """Return the largest speed of what an obstacle's motion and turning drag along before a time [s] [m/s].

    A plane or a torus drags at most what is as far from its axis as the solid reaches; that of a plane is not
    known, and its turning not counted.
    """
    turning = turning_rate(obstacles, row, until)
    return largest_speed(obstacles.motion, row, until) + turning * reach_of(obstacles, row)


def reach_of(obstacles: Obstacles, row: int) -> float:
    """Return how far a surface is from the axle at most [m], of a half-pipe where ropes lie; 0 of a plane."""
    size, kind, axle = obstacles.size[row], obstacles.kind[row], obstacles.axle[row]
    middle = obstacles.center[row] - obstacles.hub[row]
    off = float(np.linalg.norm(np.cross(axle, middle)))
    if kind == BOX:
        return off + float(np.linalg.norm(size[:3]) + size[3])
    if kind == MESH:
        corners = size[int(size[TRIANGLES]) : int(size[NORMALS])].reshape(-1, 3)
        across = np.cross(corners + middle, axle)
        return float(np.linalg.norm(across, axis=1).max() + size[ROUNDING])
    if not obstacles.sweeps[row] or kind in (PLANE, HALF_PIPE):
        return float(size[0] + (size[1] if kind == TORUS else 0.0))
    ring = float(size[1]) if kind == TORUS else 0.0
    tilt = float(np.linalg.norm(np.cross(axle, obstacles.axis[row])))
    if kind in (CYLINDER, CAPSULE) and tilt > 1e-9:  # an end of it is the farthest
        return off + float(size[0] + tilt * size[1])
    return off + float(size[0]) + ring


def reaches_of_wheels(obstacles: Obstacles, x: Floats) -> Floats:
    """Return how far what turns freely is from its axle at most (w,) [m]; of a plane, nodes (3, n)."""
    found = np.zeros(len(obstacles.inertia))
    for row in np.flatnonzero(obstacles.wheel >= 0).tolist():
        reach = reach_of(obstacles, row)
        if obstacles.kind[row] == PLANE:
            arms = np.cross(obstacles.axle[row], x.T - obstacles.hub[row])
            reach = float(np.linalg.norm(arms, axis=1).max())
        found[obstacles.wheel[row]] = reach
    return found


def sweeping_speed(obstacles: Obstacles, row: int, until: float = math.inf) -> float:
    """Return the largest speed at which a surface itself moves before a time [s] [m/s].

    Turning moves no round one.
    """
    turning = turning_rate(obstacles, row, until) if obstacles.sweeps[row] else 0.0
    return largest_speed(obstacles.motion, row, until) + turning * reach_of(obstacles, row)


def standing(obstacles: Obstacles) -> Obstacles:
    """Return the same obstacles at rest where they start."""
    still = [None] * len(obstacles.kind)
    start = np.zeros_like(obstacles.center)
    start[:, 0] = [place_now(obstacles.turns, row, 0.0)[0] for row in range(len(still))]
    return obstacles._replace(
        wheel=np.full_like(obstacles.wheel, -1),
        spin=np.zeros_like(obstacles.spin),
        motion=motion_rows(still, obstacles.center),
        turns=motion_rows(still, start),
    )


def as_at_rest(system: System) -> System:
    """Return a system whose obstacles stand where they start; those that turn freely are still told apart.

    Unlike `standing`: of these lies and turns each as is remembered of it, and is to be given no rate.
    """
    table = system.node.obstacle
    if not len(table.kind):
        return system
    still = standing(table)._replace(wheel=table.wheel)
    return system._replace(node=system.node._replace(obstacle=still))
