"""When obstacles begin and cease to press nodes: events, since the slope of the force jumps there.

What presses is max(0, R(-g) - c n.v), see `contact`. As a length that is e = (R(-g) - c n.v) / k: it presses
from where e rises through zero to where it falls through it, not from where the gap g closes. What has met a
surface in a step is followed along its flight, with the acceleration that it began with; what has left one,
or ought not to have met it by that, along the parabola of its rate at the begin and through both ends.

Steps end on the open side, just before a node is pressed and just after it was: so no step has a kink but
within half of the tolerance, as e, of its beginning or its end, and none of free flight has any force. What
changes sides by less than that, times w h in short steps, w = sqrt(k / m), is let go, so that what hovers at
a surface makes no events.
Source: Hairer, Norsett & Wanner, Solving Ordinary Differential Equations I, II.6 (discontinuous equations).
"""

from __future__ import annotations

import math

from ropewalk.core.jit import deferred, kernel
from ropewalk.laws.closing import closing
from ropewalk.laws.contact_frame import DAMP, PUSH, surface_at
from ropewalk.laws.events import end_of_pressing
from ropewalk.laws.hardening import squeezed
from ropewalk.laws.obstacle_pose import body_of, pose_of, probe_turned, rates_of, swept
from ropewalk.laws.standstill import standstills
from ropewalk.laws.wheel_rows import surface_then

SOON = 1e-3  # [1] of a step: over so much of it a rate is found
LOOKS = 20  # for where a node meets a surface


@deferred("float64", 2)
def contact_events(obstacles, before, after, dt, tolerance):
    """Return where a step between two states is to end for its first event [s], inf: where it does, and how
    many nodes have stopped, touched and left."""
    end, changes = standstills(obstacles, before, after, dt, tolerance)
    for o in range(obstacles.kind.shape[0]):
        first, last = before.memory.obstacle.grip[o], after.memory.obstacle.grip[o]
        for i in range(after.inverse_mass.shape[0]):
            if (first[PUSH, i] > 0.0) == (last[PUSH, i] > 0.0) or after.inverse_mass[i] == 0.0:
                continue
            changes += 1
            end = min(end, end_of_touch(obstacles, before, after, o, i, dt, tolerance))
    return end, float(changes)


@kernel
def end_of_touch(obstacles, before, after, o, i, dt, tolerance):
    """Return where a step is to end [s] in which obstacle o has begun or ceased to press node i; inf: where
    it does."""
    k, rate = obstacles.stiffness[o, i] * after.inverse_mass[i], 1.0 / (SOON * dt)
    c = obstacles.ratio[o] * before.memory.obstacle.grip[o, DAMP, i]
    e, e1 = pressed_at(obstacles, before, o, i, c, 0.0), pressed_at(obstacles, after, o, i, c, 0.0)
    if (e > 0.0) == (e1 > 0.0):
        return math.inf  # the contact has hardened in between
    rate *= pressed_at(obstacles, before, o, i, c, SOON * dt) - e
    early = math.inf
    if e1 > 0.0:
        early = meets(obstacles, before, o, i, c, e, dt)
        e1 *= 1.0 + dt * c * after.inverse_mass[i]  # had nothing braked it
    return end_of_pressing(e, rate, early, e1, dt, math.sqrt(k), tolerance)


@kernel
def meets(obstacles, state, o, i, c, e, dt):
    """Return when a node begins to be pressed that goes on with its acceleration [s], inf: not in `dt`."""
    low, high = 0.0, dt
    first, last = e, pressed_at(obstacles, state, o, i, c, dt)
    if not last > 0.0:
        return math.inf
    for look in range(LOOKS):
        at = low + (high - low) * (0.5 if look % 2 == 0 else first / (first - last))
        here = pressed_at(obstacles, state, o, i, c, at)
        if here > 0.0:
            high, last = at, here
        else:
            low, first = at, here
    return low - (high - low) * first / (last - first)


@kernel
def pressed_at(obstacles, state, o, i, c, ahead):
    """Return by how much obstacle o presses node i with a damper c [m]; less than nothing: it does not.

    At an accepted state, or so long after it [s], were the node to go on with its acceleration.
    """
    x, v, a, hub = state.x, state.v, state.acceleration, obstacles.hub[o]
    mx, my, mz, ux, uy, uz, angle, turning = surface_then(
        obstacles, state.memory.obstacle.wheel, o, state.now
    )
    if ahead > 0.0:
        mx, my, mz, ux, uy, uz, there, rate = surface_at(obstacles, o, state.now[1] + ahead)
        if obstacles.wheel[o] < 0:
            angle, turning = there, rate
        else:  # it turns on as it does
            angle += ahead * turning
    vx, vy, vz = v[0, i] + ahead * a[0, i], v[1, i] + ahead * a[1, i], v[2, i] + ahead * a[2, i]
    px = x[0, i] + 0.5 * ahead * (v[0, i] + vx) - mx
    py = x[1, i] + 0.5 * ahead * (v[1, i] + vy) - my
    pz = x[2, i] + 0.5 * ahead * (v[2, i] + vz) - mz
    body, pose = body_of(obstacles, o), pose_of(obstacles, o, angle)
    g, nx, ny, nz, ax, ay, az, ca, cb = probe_turned(body, pose, px, py, pz)
    sweep = rates_of(obstacles, o, turning)[1]
    ux, uy, uz = swept(ux, uy, uz, sweep, px - hub[0], py - hub[1], pz - hub[2])
    vx, vy, vz = vx - ux, vy - uy, vz - uz
    depth, rise = obstacles.thickness[i] - g, nx * vx + ny * vy + nz * vz
    rise = closing(rise, -depth, (nx, ny, nz), (ax, ay, az), ca, cb, (vx, vy, vz))[0]
    return (squeezed(obstacles, o, i, depth)[0] - c * rise) / obstacles.stiffness[o, i]
