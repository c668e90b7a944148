"""When nodes that slip over obstacles come to a stop there: an event, since friction then falls below mu R_n.

A node slips at speed u, or is about to, and loses it at the rate a. If it sticks at the end of the step, or
slips back, the step is to end at u / a, or half way where that is beyond it, unless the node could not go
farther than about the tolerance. The friction spring remembers where the step began: a step that goes there
and back sees nothing of the stop in between, nor does its error estimate.
Source: Hairer, Norsett & Wanner, Solving Ordinary Differential Equations I, II.6 (discontinuous equations).
"""

from __future__ import annotations

import math

from ropewalk.core.jit import kernel
from ropewalk.laws.contact_frame import GRIP, PUSH, STIFF, friction_at, surface_at
from ropewalk.laws.obstacle_pose import body_of, pose_of, probe_turned

AT_LIMIT = 1.0 - 1e-9  # [1] of what friction can carry counts as all of it
SHARE = 0.2  # [1] of the way at the first speed: what a step errs by that stops somewhere within
LATE = 0.95  # [1] of a step: so late a stop is not within it for sure
UNSEEN = 0.9  # [1] of the longest step whose stops are passed over: none is cut shorter, or twice by rounding


@kernel
def at_limit(grip, i, mu):
    """Tell whether friction at a node carries all that it can with so much of it; `grip` (8, n)."""
    most = mu * grip[PUSH, i]
    square = grip[0, i] ** 2 + grip[1, i] ** 2 + grip[2, i] ** 2
    return most > 0.0 and math.sqrt(square) >= AT_LIMIT * most


@kernel
def slip_at(obstacles, o, surface, x, v, i):
    """Return the velocity of a node over an obstacle's surface [m/s]; see `surface_at`."""
    hub, axle, pose = obstacles.hub[o], obstacles.axle[o], pose_of(obstacles, o, surface[6])
    px, py, pz = x[0, i] - surface[0], x[1, i] - surface[1], x[2, i] - surface[2]
    _, nx, ny, nz, _, _, _, _, _ = probe_turned(body_of(obstacles, o), pose, px, py, pz)
    ox, oy, oz = px - hub[0], py - hub[1], pz - hub[2]
    wx, wy, wz = surface[7] * axle[0], surface[7] * axle[1], surface[7] * axle[2]
    vx = v[0, i] - surface[3] - (wy * oz - wz * oy)
    vy = v[1, i] - surface[4] - (wz * ox - wx * oz)
    vz = v[2, i] - surface[5] - (wx * oy - wy * ox)
    rise = nx * vx + ny * vy + nz * vz
    return vx - rise * nx, vy - rise * ny, vz - rise * nz


@kernel
def standstills(obstacles, before, after, dt, tolerance):
    """Return where a step between two states is to end [s], inf: where it does, and how many nodes stop."""
    end, changes, a = math.inf, 0, before.acceleration
    for o in range(obstacles.kind.shape[0]):
        if obstacles.wheel[o] >= 0:  # it goes with the nodes: left to the estimate of the error
            continue
        first, last = before.memory.obstacle.grip[o], after.memory.obstacle.grip[o]
        surface = surface_at(obstacles, o, after.now[1] - dt)
        there = surface_at(obstacles, o, after.now[1])
        for i in range(after.inverse_mass.shape[0]):
            if after.inverse_mass[i] == 0.0 or not (first[PUSH, i] > 0.0 and last[PUSH, i] > 0.0):
                continue
            if first[GRIP, i] == 0.0:  # without friction nothing happens as it stops
                continue
            ux, uy, uz = slip_at(obstacles, o, surface, before.x, before.v, i)
            speed = math.sqrt(ux * ux + uy * uy + uz * uz)
            pull = first[STIFF, i] * speed * dt  # were it to stick
            mu = friction_at(
                first, i, dt
            )  # by which the end's is cut; what is kept is of its new turn
            if not at_limit(first, i, mu) and pull <= mu * first[PUSH, i]:
                continue
            wx, wy, wz = slip_at(obstacles, o, there, after.x, after.v, i)
            if at_limit(last, i, mu) and ux * wx + uy * wy + uz * wz >= 0.0:
                continue
            changes += 1
            if SHARE * speed * dt <= tolerance:
                continue
            loss = -(a[0, i] * ux + a[1, i] * uy + a[2, i] * uz) / speed
            at = speed / loss if loss > 0.0 else math.inf
            at = at if at < LATE * dt else 0.5 * dt
            least = UNSEEN * tolerance / (SHARE * speed)
            end = min(end, max(at, least))
    return end, changes
