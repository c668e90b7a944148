"""Contact of nodes with obstacles: Coulomb friction that sticks.

With g the gap, v the velocity over the surface (see `obstacle_lead`), D the way over it since the last
accepted step, R' the friction spring's force then, P = I - n n^T and R the force of a squeeze, see
`hardening`,
    R_n = max(0, R(-g) - z c n.v)                         a damper that never pulls, see `closing`
    q   = P (R' - k_t D) - c P v
    R_t = q            where |q| <= mu R_n                it sticks
          mu R_n q/|q| elsewhere                          it slips; mu of a node, see `polygon`
What is kept to the next step is the spring's part, P (R' - k_t D), cut to mu R_n. A contact that sticks does
not creep: its memory is a force. A node that an anchor or a drum holds is pushed by nothing: it is where it
is held, see `held_nodes`. A body that moves is looked at in its own frame, at the time of the forces.
k_t is R over the depth at the last step, k of what is not pressed far. With c = 2 sqrt(k m) and z = 1 a node
that hits a surface on its own stays there; with less it leaves with a part of its speed, see `rebound`.
Sources: Cundall & Strack 1979, Geotechnique 29:47 (friction with memory); Simo & Hughes, Computational
Inelasticity, 1998, ch. 2 (return mapping).
"""

from __future__ import annotations

import math

from ropewalk.core.jit import deferred, kernel, small
from ropewalk.laws.closing import closing
from ropewalk.laws.contact_books import OFTEN, OVER, PRESSED, RUBBED, WHEN, note_way, put_apart
from ropewalk.laws.contact_frame import (
    DAMP,
    MOVES,
    OFTENER,
    PUSH,
    STIFF,
    STILL,
    STOPS,
    cut,
    friction_at,
    spring_pull,
)
from ropewalk.laws.hardening import along_surface, squeezed
from ropewalk.laws.obstacle_lead import led, mean_speed
from ropewalk.laws.obstacle_pose import body_of, pose_of, probe_turned, rates_of, swept
from ropewalk.laws.obstacle_reach import RUN, first_run, is_out_of_reach
from ropewalk.laws.obstacle_shapes import PLANE
from ropewalk.laws.polygon import keep_friction
from ropewalk.laws.wheel_rows import surface_now, surface_then
from ropewalk.laws.wheels import find_rates, keep_wheels, turned

NOTHING = (0.0, 0.0, 0.0)


@deferred()
def contact_forces(x, v, obstacles, memory, now, force, lo, hi):
    """Write the force of all obstacles on nodes `lo` to `hi - 1` [N], (3, n).

    `now` holds the time of `x` and `v`, and that of the memory [s]. Where `force` has more rows they get, for
    one obstacle after another, what presses and what rubs, 3 rows each.
    """
    first, last = max(lo, 0), min(hi, x.shape[1])
    place, held, apart = memory.place, memory.held, force.shape[0] > 3
    since = now[0] - now[1]
    find_rates(x, v, obstacles, memory, now)
    for row in range(force.shape[0]):
        clear_nodes(force, row, first, last)
    for o in range(obstacles.kind.shape[0]):
        hub, axle, grip = obstacles.hub[o], obstacles.axle[o], memory.grip[o]
        slip = memory.slip[o]
        mx, my, mz, ux, uy, uz, angle, rate = turned(obstacles, memory, o, now)
        then = surface_then(obstacles, memory.wheel, o, now)
        body, pose = body_of(obstacles, o), pose_of(obstacles, o, then[6] + angle)
        (wx, wy, wz), sweep = rates_of(obstacles, o, rate)
        to, at = (mx, my, mz), (ux, uy, uz)
        to, at, turn, per, own = led(obstacles, memory, o, now, then, to, at, angle)
        (mx, my, mz), (ux, uy, uz) = to, at
        if is_out_of_reach(x, v, obstacles, grip, o, pose, to, at, sweep, first, last):
            continue
        away, seen = False, first_run(obstacles, o, first, last)
        for i in range(first, last):
            if i == seen:
                seen = min(i + RUN, last)
                away = is_out_of_reach(x, v, obstacles, grip, o, pose, to, at, sweep, i, seen)
            if away or held[i] != 0:
                continue
            px, py, pz = x[0, i] - mx, x[1, i] - my, x[2, i] - mz
            g, nx, ny, nz, ax, ay, az, ca, cb = probe_turned(body, pose, px, py, pz)
            ox, oy, oz = px - hub[0], py - hub[1], pz - hub[2]
            after = since == 0.0 and slip[OFTEN, i] > 0.0 and slip[WHEN, i] == now[0]
            if after:  # the state that such a step has left
                ux, uy, uz = mean_speed(obstacles, o, now[0], slip[OFTEN, i])
            lx, ly, lz = swept(ux, uy, uz, sweep, ox, oy, oz)
            vx, vy, vz = v[0, i] - lx, v[1, i] - ly, v[2, i] - lz
            k, c, depth = grip[STIFF, i], grip[DAMP, i], obstacles.thickness[i] - g
            rise, damper = nx * vx + ny * vy + nz * vz, obstacles.ratio[o] * c
            pressed = squeezed(obstacles, o, i, depth)[0]
            if not pressed - damper * rise > 0.0:  # `closing` leaves less
                continue
            n, a = (nx, ny, nz), (ax, ay, az)
            push = pressed - damper * closing(rise, -depth, n, a, ca, cb, (vx, vy, vz))[0]
            if not push > 0.0:
                continue
            sx, sy, sz = 0.0, 0.0, 0.0
            bound = friction_at(grip, i, since) * push
            if bound > 0.0:
                vx, vy, vz = (
                    vx - (wy * oz - wz * oy),
                    vy - (wz * ox - wx * oz),
                    vz - (wx * oy - wy * ox),
                )
                if after:
                    vx, vy, vz = last_slip(slip, i)
                k, c = k + per * c, own * c
                sx, sy, sz = spring_pull(
                    k, hub, axle, angle, then, grip, place, i, px, py, pz, turn
                )
                sx, sy, sz = sx - c * vx, sy - c * vy, sz - c * vz
                across = nx * sx + ny * sy + nz * sz
                sx, sy, sz = sx - across * nx, sy - across * ny, sz - across * nz
                sx, sy, sz = cut(sx, sy, sz, bound)
            force[0, i] += push * nx + sx
            force[1, i] += push * ny + sy
            force[2, i] += push * nz + sz
            if apart:
                put_apart(force, o, i, push, nx, ny, nz, sx, sy, sz)


@small
def clear_nodes(force, row, first, last):
    """Write 0 to nodes `first` to `last - 1` of a row; by an index that may be below 0 it takes longer."""
    own = force[row][first:last]
    for i in range(own.shape[0]):
        own[i] = 0.0


@deferred("float64")
def remember_contacts(x, v, obstacles, memory, now, stiffness):
    """Keep what the contacts carry at `x` and `v`, the places, and the coefficients of friction there.

    Return how many contacts have closed. What surfaces that move give to nodes in the step is added up, too,
    their force at its end times their way; and the force on every obstacle then.
    """
    n, place, held, closed = x.shape[1], memory.place, memory.held, 0.0
    clear(memory.load)
    dt = now[0] - now[1]
    find_rates(x, v, obstacles, memory, now)
    for o in range(obstacles.kind.shape[0]):
        hub, axle, grip = obstacles.hub[o], obstacles.axle[o], memory.grip[o]
        slip = memory.slip[o]
        mx, my, mz, ux, uy, uz, angle, rate = turned(obstacles, memory, o, now)
        then = surface_then(obstacles, memory.wheel, o, now)
        to, at = (mx, my, mz), (ux, uy, uz)
        _, (ux, uy, uz), turned_by, per, _ = led(obstacles, memory, o, now, then, to, at, angle)
        body, pose = body_of(obstacles, o), pose_of(obstacles, o, then[6] + angle)
        (wx, wy, wz), sweep = rates_of(obstacles, o, rate)
        for i in range(n):
            px, py, pz = x[0, i] - mx, x[1, i] - my, x[2, i] - mz
            g, nx, ny, nz, ax, ay, az, ca, cb = probe_turned(body, pose, px, py, pz)
            ox, oy, oz = px - hub[0], py - hub[1], pz - hub[2]
            lx, ly, lz = swept(ux, uy, uz, sweep, ox, oy, oz)
            vx, vy, vz = v[0, i] - lx, v[1, i] - ly, v[2, i] - lz
            k, c, depth = grip[STIFF, i], grip[DAMP, i], obstacles.thickness[i] - g
            pressed, _, stored = squeezed(obstacles, o, i, depth)
            normal, a, rise = (nx, ny, nz), (ax, ay, az), nx * vx + ny * vy + nz * vz
            rise = closing(rise, -depth, normal, a, ca, cb, (vx, vy, vz))[0]
            push = pressed - obstacles.ratio[o] * c * rise
            if held[i] != 0:
                push, stored = 0.0, 0.0
            if push > 0.0 and grip[PUSH, i] == 0.0:
                closed += 1.0
            grip[PUSH, i] = max(push, 0.0)
            bound = friction_at(grip, i, dt) * grip[PUSH, i]
            note_way(obstacles, memory, o, i, to, then, angle, px, py, pz, g, nx, ny, nz)
            slip[OFTEN, i], slip[WHEN, i] = per, now[0]
            sx, sy, sz, rx, ry, rz, pull = 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, NOTHING
            gx, gy, gz = wy * oz - wz * oy, wz * ox - wx * oz, wx * oy - wy * ox
            softer = harden(obstacles, grip, o, i, depth)
            if bound > 0.0:
                sx, sy, sz = spring_pull(
                    k, hub, axle, angle, then, grip, place, i, px, py, pz, turned_by
                )
                across = nx * sx + ny * sy + nz * sz
                sx, sy, sz = sx - across * nx, sy - across * ny, sz - across * nz
                fx, fy, fz = last_slip(slip, i) if per > 0.0 else (vx - gx, vy - gy, vz - gz)
                rx, ry, rz = sx - c * fx, sy - c * fy, sz - c * fz
                sx, sy, sz = cut(softer * sx, softer * sy, softer * sz, bound)
                across = nx * rx + ny * ry + nz * rz
                rx, ry, rz = rx - across * nx, ry - across * ny, rz - across * nz
                rx, ry, rz = cut(rx, ry, rz, bound)
                pull = pull_along(sx, sy, sz, grip[DAMP, i], (fx, fy, fz), nx, ny, nz)
            grip[0, i], grip[1, i], grip[2, i] = sx, sy, sz
            memory.books[o, PRESSED, i] = stored
            memory.books[o, RUBBED, i] = 0.5 * (sx * sx + sy * sy + sz * sz) / grip[STIFF, i]
            if push > 0.0:
                rx, ry, rz = rx + push * nx, ry + push * ny, rz + push * nz
                add_load(memory.load, o, rx, ry, rz)
                power = rx * (lx + gx) + ry * (ly + gy) + rz * (lz + gz)
                memory.given[i] += max(dt * power, 0.0)
            gx, gy, gz = dt * (v[0, i] - ux), dt * (v[1, i] - uy), dt * (v[2, i] - uz)
            probed, later = (nx, ny, nz, ax, ay, az, ca, cb), (px + gx, py + gy, pz + gz)
            turns = then[6] + angle + dt * rate
            keep_friction(x, v, obstacles, grip, o, i, pull, probed, later, turns, dt, stiffness)
    keep_wheels(obstacles, memory, dt)
    for k in range(3):
        for i in range(n):
            memory.way[k, i] = x[k, i] - place[k, i]
            place[k, i] = x[k, i]
    return closed


@small
def clear(load):
    """Begin with no force on obstacles, (k, 3)."""
    for o in range(load.shape[0]):
        load[o, 0] = load[o, 1] = load[o, 2] = 0.0


@small
def add_load(load, o, fx, fy, fz):
    """Add what a node is pressed with by an obstacle [N] to the force on that."""
    load[o, 0] -= fx
    load[o, 1] -= fy
    load[o, 2] -= fz


@small
def pull_along(sx, sy, sz, c, slip, nx, ny, nz):
    """Return what rubs where a step has ended: a spring's pull [N] and a damper `c` on the slip, (3)."""
    fx, fy, fz = sx - c * slip[0], sy - c * slip[1], sz - c * slip[2]
    across = nx * fx + ny * fy + nz * fz
    return fx - across * nx, fy - across * ny, fz - across * nz


@small
def last_slip(slip, i):
    """Return the velocity of node i over a surface as its way in the last step has it [m/s]."""
    often = slip[OFTEN, i]
    return often * slip[OVER, i], often * slip[OVER + 1, i], often * slip[OVER + 2, i]


@small
def harden(obstacles, grip, o, i, depth):
    """Keep how stiff the springs along a surface are where a node is pressed so deep [m], and its damper.

    Return by what the force of a friction spring changes: a softer one keeps what it has stored.
    """
    before = grip[STIFF, i]
    grip[STIFF, i], grip[DAMP, i] = along_surface(obstacles, o, i, depth)
    return math.sqrt(grip[STIFF, i] / before) if grip[STIFF, i] < before else 1.0


@kernel
def push_on(obstacles, o, i, gap, rise):
    """Return what presses on node i at a gap [m] that grows at `rise` [m/s] [N]; no more than 0: nothing."""
    depth = obstacles.thickness[i] - gap
    c = obstacles.ratio[o] * along_surface(obstacles, o, i, depth)[1]
    return squeezed(obstacles, o, i, depth)[0] - c * rise


@deferred("float64")
def quickest_impact(state, force, dt, obstacles, memory):
    """Return how quickly a surface stops nodes in a step of `dt` [s] that begins at `state` [1/s]; 0: none.

    Under mean forces (3 + 6 k, n) [N]. One that was open and presses in the step is stopped, were it for a
    stage alone; and one that presses as it begins and comes nearer by more than STILL diameters, if the step
    is too long to follow how it is stopped, or if what stops it is the contact's harder part: it has more
    mass behind it than its damper is made for. What throws back is followed on its way out, too.
    """
    struck, now, x, v = 0.0, state.now, state.x, state.v
    for o in range(obstacles.kind.shape[0]):
        hub, grip, row = obstacles.hub[o], memory.grip[o], 3 + 6 * o
        back = obstacles.ratio[o] < 1.0
        oftener, still = (OFTENER, MOVES) if back else (1.0, STILL)
        mx, my, mz, ux, uy, uz, angle, rate = surface_then(obstacles, memory.wheel, o, now)
        body, pose = body_of(obstacles, o), pose_of(obstacles, o, angle)
        _, sweep = rates_of(obstacles, o, rate)
        for i in range(x.shape[1]):
            if force[row, i] == 0.0 and force[row + 1, i] == 0.0 and force[row + 2, i] == 0.0:
                continue
            quick = grip[STIFF, i] / grip[DAMP, i] * oftener
            if grip[PUSH, i] == 0.0:
                struck = max(struck, quick)
                continue
            px, py, pz = x[0, i] - mx, x[1, i] - my, x[2, i] - mz
            gap, nx, ny, nz, _, _, _, _, _ = probe_turned(body, pose, px, py, pz)
            ox, oy, oz = px - hub[0], py - hub[1], pz - hub[2]
            lx, ly, lz = swept(ux, uy, uz, sweep, ox, oy, oz)
            rise = nx * (v[0, i] - lx) + ny * (v[1, i] - ly) + nz * (v[2, i] - lz)
            way = abs(rise) * dt if back else -rise * dt
            fast = way > still * obstacles.diameter[i] and state.inverse_mass[i] > 0.0
            if fast and (
                quick * dt > STOPS or is_stopped_hard(obstacles, force, o, i, gap, rise, dt)
            ):
                struck = max(struck, quick)
    return struck


@deferred("int64")
def presses_anew(force, grip):
    """Return how many contacts that were open press under a force (3 + 6 k, n)."""
    count = 0
    for o in range(grip.shape[0]):
        push, row = grip[o, PUSH], 3 + 6 * o
        x, y, z = force[row], force[row + 1], force[row + 2]
        for i in range(push.shape[0]):
            presses = x[i] != 0.0 or y[i] != 0.0 or z[i] != 0.0
            count += 1 if presses and push[i] == 0.0 else 0
    return count


@kernel
def is_round(obstacles):
    """Tell whether any obstacle is no plane."""
    count = 0
    for o in range(obstacles.kind.shape[0]):
        count += 1 if obstacles.kind[o] != PLANE else 0
    return count > 0


@kernel
def presses_round(obstacles, force):
    """Tell whether an obstacle that is no plane presses a node under a force (3 + 6 k, n)."""
    most = 0.0
    for o in range(obstacles.kind.shape[0]):
        if obstacles.kind[o] != PLANE:
            x, y, z = force[3 + 6 * o], force[4 + 6 * o], force[5 + 6 * o]
            for i in range(x.shape[0]):
                most = max(most, abs(x[i]) + abs(y[i]) + abs(z[i]))
    return most > 0.0


@small
def is_stopped_hard(obstacles, force, o, i, gap, rise, dt):
    """Tell whether mean forces, see `quickest_impact`, press more than a contact's skin and damper could."""
    k, c, row = obstacles.stiffness[o, i], obstacles.damping[o, i], 3 + 6 * o
    soft = k * max(obstacles.thickness[i] - gap - rise * dt, 0.0) - c * rise
    return force[row, i] ** 2 + force[row + 1, i] ** 2 + force[row + 2, i] ** 2 > soft * soft


@deferred("float64")
def contact_energy(x, obstacles, memory, now):
    """Return what the obstacles' surfaces have stored where they are pressed in [J]."""
    total = 0.0
    for o in range(obstacles.kind.shape[0]):
        mx, my, mz, _, _, _, angle, _ = surface_now(obstacles, memory.wheel, o, now)
        body, pose = body_of(obstacles, o), pose_of(obstacles, o, angle)
        for i in range(x.shape[1]):
            if memory.held[i] != 0:
                continue
            px, py, pz = x[0, i] - mx, x[1, i] - my, x[2, i] - mz
            depth = obstacles.thickness[i] - probe_turned(body, pose, px, py, pz)[0]
            total += squeezed(obstacles, o, i, depth)[2]
    return total


@deferred("float64")
def contact_given(memory):
    """Return what moving and turning surfaces have given to ropes so far [J], never less."""
    total = 0.0
    for i in range(memory.given.shape[0]):
        total += memory.given[i]
    return total


@deferred("float64")
def contact_rounding(x, obstacles):
    """Return what rounding of the places does to the forces of contacts [N]."""
    a, b, c, most = 0.0, 0.0, 0.0, 0.0  # apart: one would wait for the other
    for i in range(x.shape[1]):
        a, b, c = max(a, abs(x[0, i])), max(b, abs(x[1, i])), max(c, abs(x[2, i]))
    size = max(a, b, c)
    for o in range(obstacles.kind.shape[0]):
        for k in range(3):
            size = max(size, abs(obstacles.center[o, k]))
        for i in range(x.shape[1]):
            most = max(most, obstacles.stiffness[o, i] + obstacles.hard[o, i])
    return 16.0 * 2.220446049250313e-16 * most * size
