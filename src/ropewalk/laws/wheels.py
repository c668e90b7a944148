"""Obstacles that turn freely about their axis: pulleys, driven by the friction of the ropes on them.

With the rate w, the angle h w by which a wheel has turned since the last accepted step, h ago, and the
friction R_t that contacts have on nodes then (see `contact`), o a node's place from the axis and e = a x o,
    I (w - w') / h = -sum e . R_t(x, v, w) - viscous w - bearing sign(w) .
The left side less the right one rises with w: it has one root, which is found anew wherever forces are asked
for. So the force of a wheel's contacts is a function of places and velocities, as that of all others, and
solvers know of it by their matrix only. Below the bearing's torque the wheel stands, exactly.
That is implicit Euler, which explicit methods have for the wheel. Stages of implicit ones have w = w^ + c M/I
and a way of d^ + c w, M the sum of all torques: their own method, with what is known of the stage (`aim`).
The wheel ties all nodes on it together: with u = dF/dw and z how the torque changes with the nodes,
    -dF = K dx - u (z . dx) / s,   s = I / h + viscous - d torque / dw ,
which solvers take up by Sherman and Morrison's formula, see `methods.wheel_ties`.
Source: Golub & Van Loan, Matrix Computations, 2.1.4 (Sherman and Morrison).
"""

from __future__ import annotations

import math

from ropewalk.core.jit import deferred, kernel
from ropewalk.laws.closing import closing
from ropewalk.laws.contact_frame import DAMP, STIFF, carried, cut, friction_at, surface_at
from ropewalk.laws.hardening import squeezed
from ropewalk.laws.obstacle_lead import carried_on, led_freely, turn_by_rate
from ropewalk.laws.obstacle_shapes import probe
from ropewalk.laws.rotors import find_turning, turning_torque, work_of_weight
from ropewalk.laws.wheel_rows import (
    ANGLE,
    BEARING,
    BOUND,
    COLUMN,
    COUNT,
    DRAG,
    DRIVE,
    FALL,
    GAIN,
    KNOWN,
    LEAD,
    MEAN_DRAG,
    MEAN_DRIVE,
    MOVED,
    NODE,
    NORMAL,
    PART,
    PULL,
    RATE,
    RATES,
    ROPES,
    ROW,
    SHARE,
    STAGES,
    TIE,
    TORQUE,
    TRIAL,
    WAY,
    WEIGH,
    WEIGHED,
    span_of,
)  # fmt: skip

MOST = 200  # iterations, halvings of its bounds among them
TIGHT, CLOSE = 1e-15, 1e-9  # [1] of the sum of all torques
WIDER = 0.1  # [1] by which the bounds of a rate are wider than its nodes' own


@kernel
def turned(obstacles, memory, row, now):
    """Return what `surface_at` does at `now`, with the angle since the memory; a wheel turns as found."""
    dx, dy, dz, vx, vy, vz, angle, rate = surface_at(obstacles, row, now[0])
    w = obstacles.wheel[row]
    if w >= 0:
        rate = memory.wheel[w, TRIAL]
        angle = memory.wheel[w, LEAD] + rate * span_of(memory.wheel[w], now)
    else:
        angle = angle - surface_at(obstacles, row, now[1])[6]
    return dx, dy, dz, vx, vy, vz, angle, rate


@kernel
def find_rates(x, v, obstacles, memory, now):
    """Write the rates of all wheels for nodes at places `x` with velocities `v`, (3, n)."""
    if obstacles.inertia.shape[0] > 0:
        _find_rates(x, v, obstacles, memory, now)


@deferred()
def _find_rates(x, v, obstacles, memory, now):
    """Do what `find_rates` does where there are wheels."""
    for o in range(obstacles.wheel.shape[0]):
        w = obstacles.wheel[o]
        if w < 0:
            continue
        wheel = memory.wheel[w]
        if not wheel[PART] > 0.0:
            wheel[KNOWN], wheel[LEAD] = wheel[RATE], 0.0
        h = span_of(wheel, now)
        wheel[TRIAL], wheel[TIE], wheel[DRIVE], wheel[DRAG] = wheel[KNOWN], 0.0, 0.0, 0.0
        wheel[WEIGH] = 0.0
        if obstacles.sweeps[o]:
            if h > 0.0:
                find_turning(x, v, obstacles, memory, o, now)
            continue
        _list_nodes(x, v, obstacles, memory, o, now)
        if h > 0.0:
            _find_rate(x, v, obstacles, memory, o, now)


@kernel
def _list_nodes(x, v, obstacles, memory, o, now):
    """Write which nodes a wheel rubs on, with normal and what friction can carry there."""
    w, count, since = obstacles.wheel[o], 0, now[0] - now[1]
    kind, center, axis = obstacles.kind[o], obstacles.center[o], obstacles.axis[o]
    size, grip, ties = obstacles.size[o], memory.grip[o], memory.ties[w]
    _, ((mx, my, mz), (ux, uy, uz), _, _, _) = led_freely(obstacles, memory, o, now, 0.0)
    for i in range(x.shape[1]):
        px, py, pz = x[0, i] - mx, x[1, i] - my, x[2, i] - mz
        g, nx, ny, nz, ax, ay, az, ca, cb = probe(kind, center, axis, size, px, py, pz)
        vx, vy, vz = v[0, i] - ux, v[1, i] - uy, v[2, i] - uz
        rise, depth = nx * vx + ny * vy + nz * vz, obstacles.thickness[i] - g
        n, a = (nx, ny, nz), (ax, ay, az)
        rise = closing(rise, -depth, n, a, ca, cb, (vx, vy, vz))[0]
        push = squeezed(obstacles, o, i, depth)[0]
        bound = friction_at(grip, i, since) * (push - grip[DAMP, i] * rise)
        if bound > 0.0 and memory.held[i] == 0:
            ties[NODE, count], ties[BOUND, count] = i, bound
            ties[NORMAL, count], ties[NORMAL + 1, count], ties[NORMAL + 2, count] = nx, ny, nz
            count += 1
    memory.wheel[w, COUNT] = count


@kernel
def _torque(rate, x, v, obstacles, memory, o, now, keep):
    """Return the ropes' torque on a wheel at a rate [N m], -its slope [N m s], and the sum of its parts.

    And the least and greatest rate at which a node would not rub along [rad/s]: with more all hold it back.
    With `keep` what the forces of the nodes change by with the rate is written.
    """
    w = obstacles.wheel[o]
    hub, axis, ties, place = obstacles.hub[o], obstacles.axle[o], memory.ties[w], memory.place
    ax, ay, az = axis[0], axis[1], axis[2]
    h, total, slope, parts = span_of(memory.wheel[w], now), 0.0, 0.0, 0.0
    least, greatest = math.inf, -math.inf
    angle = memory.wheel[w, LEAD] + rate * h
    then, (to, at, turn, per, own) = led_freely(obstacles, memory, o, now, angle)
    by = turn_by_rate(obstacles, memory, o, now, angle, per)
    grip = memory.grip[o]
    for t in range(int(memory.wheel[w, COUNT])):
        i = int(ties[NODE, t])
        nx, ny, nz = ties[NORMAL, t], ties[NORMAL + 1, t], ties[NORMAL + 2, t]
        k, c = grip[STIFF, i] + per * grip[DAMP, i], own * grip[DAMP, i]
        px, py, pz = x[0, i] - to[0], x[1, i] - to[1], x[2, i] - to[2]
        ox, oy, oz = px - hub[0], py - hub[1], pz - hub[2]
        ex, ey, ez = ay * oz - az * oy, az * ox - ax * oz, ax * oy - ay * ox
        fx, fy, fz, dx, dy, dz = carried(hub, axis, angle, then, grip, place, i, px, py, pz, turn)
        qx = fx - k * dx - c * (v[0, i] - at[0] - rate * ex)
        qy = fy - k * dy - c * (v[1, i] - at[1] - rate * ey)
        qz = fz - k * dz - c * (v[2, i] - at[2] - rate * ez)
        fx, fy, fz = h * fx, h * fy, h * fz
        was = (
            place[0, i] - then[0] - hub[0],
            place[1, i] - then[1] - hub[1],
            place[2, i] - then[2] - hub[2],
        )
        gx, gy, gz = carried_on(axis, by, was)
        sx, sy, sz = (
            ay * fz - az * fy + k * gx + c * ex,
            az * fx - ax * fz + k * gy + c * ey,
            ax * fy - ay * fx + k * gz + c * ez,
        )
        along, rise = qx * nx + qy * ny + qz * nz, sx * nx + sy * ny + sz * nz
        qx, qy, qz = qx - along * nx, qy - along * ny, qz - along * nz
        sx, sy, sz = sx - rise * nx, sy - rise * ny, sz - rise * nz
        free = rate - (ex * qx + ey * qy + ez * qz) / (ex * sx + ey * sy + ez * sz)
        least, greatest = min(least, free), max(greatest, free)
        size, bound = math.sqrt(qx * qx + qy * qy + qz * qz), ties[BOUND, t]
        if size > bound:
            share = bound / size
            ahead = (qx * sx + qy * sy + qz * sz) / (size * size)
            sx, sy, sz = (
                share * (sx - ahead * qx),
                share * (sy - ahead * qy),
                share * (sz - ahead * qz),
            )
            qx, qy, qz = share * qx, share * qy, share * qz
        one = ex * qx + ey * qy + ez * qz
        total -= one
        parts += abs(one)
        slope += ex * sx + ey * sy + ez * sz
        if keep:
            ties[COLUMN, i], ties[COLUMN + 1, i], ties[COLUMN + 2, i] = sx, sy, sz
    return total, slope, parts, least, greatest


@kernel
def _find_rate(x, v, obstacles, memory, o, now):
    """Write rate, s and torques of a wheel: Newton's method on what rises, held between its bounds."""
    w = obstacles.wheel[o]
    wheel, inertia = memory.wheel[w], obstacles.inertia[w] / span_of(memory.wheel[w], now)
    bearing, viscous, before = obstacles.bearing[w], obstacles.viscous[w], memory.wheel[w, KNOWN]
    drive, slope, parts, _, _ = _torque(0.0, x, v, obstacles, memory, o, now, False)
    push = inertia * before + drive
    if bearing > 0.0 and abs(push) <= bearing:
        wheel[TRIAL], wheel[DRIVE], wheel[DRAG] = 0.0, drive, -push
        return
    hold = bearing if push > 0.0 else -bearing
    # Its root lies on the side of zero that `push` has, and not where everything holds the wheel back.
    _, _, _, low, high = _torque(before, x, v, obstacles, memory, o, now, False)
    low, high = min(low, before, 0.0), max(high, before, 0.0)
    room = WIDER * (high - low)
    low, high = (0.0, high + room) if push > 0.0 else (low - room, 0.0)
    rate, last, close = before, math.inf, False
    if not low <= rate <= high:
        rate = 0.0
    for _ in range(MOST):
        drive, slope, parts, _, _ = _torque(rate, x, v, obstacles, memory, o, now, False)
        left = inertia * (rate - before) + viscous * rate + hold - drive
        scale = inertia * (abs(rate) + abs(before)) + viscous * abs(rate) + bearing + parts
        if close or abs(left) <= TIGHT * scale:
            break
        close = abs(left) <= CLOSE * scale  # one step more is as near as rounding lets it
        slow = abs(left) > 0.5 * last  # from kink to kink
        last = abs(left)
        if left > 0.0:
            high = rate
        else:
            low = rate
        new = rate - left / (inertia + viscous + slope)
        if not close and (slow or not low < new < high):
            new = 0.5 * (low + high)
        if new == rate:
            break
        rate = new
    wheel[TRIAL], wheel[DRIVE], wheel[DRAG] = rate, drive, -hold - viscous * rate
    wheel[TIE] = inertia + viscous + slope


@kernel
def begin_ties(x, v, obstacles, memory, now):
    """Write for the rates found what ties the nodes on a wheel: u; z is to come, by `write_row`."""
    if obstacles.inertia.shape[0] > 0:
        _begin_ties(x, v, obstacles, memory, now)


@deferred()
def _begin_ties(x, v, obstacles, memory, now):
    """Do what `begin_ties` does where there are wheels."""
    for o in range(obstacles.wheel.shape[0]):
        w = obstacles.wheel[o]
        if w < 0:
            continue
        for k in range(COLUMN, MOVED):
            for i in range(x.shape[1]):
                memory.ties[w, k, i] = 0.0
        if not memory.wheel[w, TIE] > 0.0:
            continue
        if obstacles.sweeps[o]:
            turning_torque(memory.wheel[w, TRIAL], x, v, obstacles, memory, o, now, True)
        else:
            _torque(memory.wheel[w, TRIAL], x, v, obstacles, memory, o, now, True)


@kernel
def write_row(obstacles, memory, o, i, arm, n, push, pull, bound, block, weight_x):
    """Write how the torque on a wheel changes with node `i`, whose force changes by -`block`.

    `arm` from the wheel's middle to the node, `pull` its friction before it is cut to `bound`, `push` what
    presses there; 0 of what is round.
    """
    axis, ties = obstacles.axle[o], memory.ties[obstacles.wheel[o]]
    ax, ay, az = axis[0], axis[1], axis[2]
    ox, oy, oz = arm
    ex, ey, ez = ay * oz - az * oy, az * ox - ax * oz, ax * oy - ay * ox
    along = n[0] * pull[0] + n[1] * pull[1] + n[2] * pull[2]
    fx, fy, fz = cut(pull[0] - along * n[0], pull[1] - along * n[1], pull[2] - along * n[2], bound)
    fx, fy, fz = fx + push * n[0], fy + push * n[1], fz + push * n[2]
    turn = (
        fy * az - fz * ay,
        fz * ax - fx * az,
        fx * ay - fy * ax,
    )
    for r in range(3):
        change = ex * block[r] + ey * block[3 + r] + ez * block[6 + r]
        ties[ROW + r, i] = change - weight_x * turn[r]


@deferred()
def aim_wheels(wheel, A, b, s, dt):
    """Write what is known of all wheels in stage `s` of a DIRK step of `dt` [s]."""
    for w in range(wheel.shape[0]):
        one = wheel[w]
        if s == 0:
            one[MEAN_DRIVE], one[MEAN_DRAG] = 0.0, 0.0
        one[PART], one[SHARE] = dt * A[s, s], b[s]
        if A[s, s] == 0.0:  # it is the step's begin
            one[RATES + s], one[STAGES + s] = one[RATE], one[PULL]
            one[MEAN_DRIVE] += b[s] * one[TORQUE]
            one[MEAN_DRAG] += b[s] * (one[PULL] - one[TORQUE] - one[WEIGHED])
            continue
        one[KNOWN], one[LEAD] = 0.0, 0.0
        for r in range(s):
            one[KNOWN] += dt * A[s, r] * one[STAGES + r]
            one[LEAD] += dt * A[s, r] * one[RATES + r]


@deferred()
def know_rates(inertia, wheel):
    """Make rates of what `aim_wheels` has left as changes of angular momentum."""
    for w in range(wheel.shape[0]):
        wheel[w, KNOWN] = wheel[w, RATE] + wheel[w, KNOWN] / inertia[w]


@deferred()
def aim_wheels_bdf2(wheel, dt):
    """Write what is known of all wheels in a step of BDF2 of `dt` [s]."""
    for w in range(wheel.shape[0]):
        one = wheel[w]
        one[KNOWN], one[LEAD] = one[RATE] + one[GAIN] / 3.0, one[WAY] / 3.0
        one[PART], one[SHARE] = 2.0 * dt / 3.0, 2.0 / 3.0
        one[MEAN_DRIVE], one[MEAN_DRAG] = one[STAGES] / 3.0, one[STAGES + 1] / 3.0


@deferred()
def end_aim(wheel, s, last):
    """Keep a stage that is solved; its torques count in the mean, but those of the last one, yet to come."""
    for w in range(wheel.shape[0]):
        one = wheel[w]
        one[RATES + s], one[STAGES + s] = one[TRIAL], one[DRIVE] + one[DRAG] + one[WEIGH]
        if not last:
            one[MEAN_DRIVE] += one[SHARE] * one[DRIVE]
            one[MEAN_DRAG] += one[SHARE] * one[DRAG]


@kernel
def aim_no_wheels(wheel):
    """Let wheels go by implicit Euler from the last accepted step."""
    for w in range(wheel.shape[0]):
        wheel[w, PART] = 0.0


@kernel
def keep_wheels(obstacles, memory, dt):
    """Take the rates found for those at the end of a step of `dt` [s], and book what was done on the wheels.

    With the mean torques of the step and the mean of the rates before and after it, whatever is done is the
    change of the wheel's kinetic energy; but for its weight, whose work is that between both places: what is
    left is the method's error, see `rotors.turning_error`.
    """
    for o in range(obstacles.wheel.shape[0]):
        w = obstacles.wheel[o]
        if w < 0 or not dt > 0.0:
            continue
        wheel = memory.wheel[w]
        drive, drag, turn = wheel[DRIVE], wheel[DRAG], dt * wheel[TRIAL]
        if wheel[PART] > 0.0:
            drive = wheel[MEAN_DRIVE] + wheel[SHARE] * drive
            drag = wheel[MEAN_DRAG] + wheel[SHARE] * drag
            turn = wheel[LEAD] + wheel[PART] * wheel[TRIAL]
        way = 0.5 * dt * (wheel[RATE] + wheel[TRIAL])
        wheel[FALL] += work_of_weight(obstacles.weight, w, wheel[ANGLE], turn)
        wheel[ANGLE] += turn
        wheel[ROPES] += drive * way
        wheel[BEARING] += drag * way
        wheel[GAIN], wheel[WAY] = wheel[TRIAL] - wheel[RATE], turn
        wheel[RATE], wheel[TORQUE], wheel[PULL] = (
            wheel[TRIAL],
            wheel[DRIVE],
            wheel[DRIVE] + wheel[DRAG] + wheel[WEIGH],
        )
        wheel[WEIGHED] = wheel[WEIGH]
        wheel[STAGES], wheel[STAGES + 1] = drive, drag  # the mean ones, for BDF2's next step
        wheel[PART], wheel[LEAD] = 0.0, 0.0  # it is where it lies


@deferred()
def record_wheels(inertia, wheel, out):
    """Write what is recorded of wheels, see `wheel_rows.RECORDED`, (w, 7)."""
    for w in range(out.shape[0]):
        rate = wheel[w, RATE]
        out[w, 0], out[w, 1], out[w, 2] = wheel[w, ANGLE], rate, 0.5 * inertia[w] * rate * rate
        out[w, 3], out[w, 4], out[w, 5] = wheel[w, ROPES], wheel[w, BEARING], wheel[w, TORQUE]
        out[w, 6] = wheel[w, FALL]
