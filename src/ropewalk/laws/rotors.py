"""Obstacles that turn freely and are not round: whatever presses on them turns them, too.

With F the whole force of the contact on a node at o from the axle a, e = a x o, and the rate w, which turns
the body by h w,
    I (w - w') / h = -sum e . F(x, v, w) + G - viscous w - bearing sign(w) .
The body leads its contacts along: for a node that stays, turning is the same as moving by -h e in the body's
frame, and the velocity u over the surface changes by -(e + h a x u). So
    dF/dw = h a x F + F'(-h e, -(e + h a x u)),   F' how F changes with place and velocity.
The root is found as that of a wheel, from the rate before. G is the torque of the body's own weight, if a
mass is given; explicit methods take it where the step began, as they do with all else.
"""

from __future__ import annotations

import math

from ropewalk.core.blocks import dot3, minus3, plus3, scale3
from ropewalk.core.jit import deferred, kernel, small
from ropewalk.laws.closing import across, closing
from ropewalk.laws.contact_frame import (
    DAMP,
    STIFF,
    carried,
    cut,
    friction_at,
)
from ropewalk.laws.hardening import squeezed
from ropewalk.laws.obstacle_lead import carried_on, led_freely, turn_by_rate
from ropewalk.laws.obstacle_pose import body_of, pose_of, probe_turned, rates_of, swept
from ropewalk.laws.wheel_rows import (
    ANGLE,
    BEARING,
    COLUMN,
    DRAG,
    DRIVE,
    FALL,
    KNOWN,
    LEAD,
    PART,
    RATE,
    ROPES,
    TIE,
    TRIAL,
    WEIGH,
    span_of,
)

MOST = 100  # iterations
TIGHT, CLOSE = 1e-14, 1e-9  # [1] of the sum of all torques
FARTHEST = 0.25  # [rad] by which a guess differs from the one before


@small
def cross3(a, b):
    """Return the vector product."""
    return a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]


@small
def changes(n, dn, push, more, pull, change, mu):
    """Return by how much push n and the friction, `pull` cut to mu push, change with the normal and both."""
    along = dot3(n, pull)
    q = minus3(pull, scale3(along, n))
    lift = dot3(n, change) + dot3(dn, pull)
    d = minus3(minus3(change, scale3(lift, n)), scale3(along, dn))
    total, bound = math.sqrt(dot3(q, q)), mu * push
    if total > bound:
        s = scale3(1.0 / total, q)
        d = scale3(bound / total, minus3(d, scale3(dot3(s, d), s)))
        d = plus3(d, scale3(mu * more, s))
    return plus3(d, plus3(scale3(more, n), scale3(push, dn)))


@kernel
def turning_torque(rate, x, v, obstacles, memory, o, now, keep):
    """Return the ropes' torque on a body at a rate [N m], -its slope [N m s], and the sum of its parts.

    With `keep` what the forces of the nodes change by with the rate is written.
    """
    w = obstacles.wheel[o]
    hub, axle, grip, place = obstacles.hub[o], obstacles.axle[o], memory.grip[o], memory.place
    wheel, ties, axis = memory.wheel[w], memory.ties[w], (axle[0], axle[1], axle[2])
    h, total, slope, parts = span_of(wheel, now), 0.0, 0.0, 0.0
    angle = wheel[LEAD] + rate * h
    then, (to, (ux, uy, uz), turn, per, own) = led_freely(obstacles, memory, o, now, angle)
    by = turn_by_rate(obstacles, memory, o, now, angle, per)
    body, pose = body_of(obstacles, o), pose_of(obstacles, o, wheel[ANGLE] + angle)
    sweep = rates_of(obstacles, o, rate)[1]
    for i in range(x.shape[1]):
        if memory.held[i] != 0:
            continue
        px, py, pz = x[0, i] - to[0], x[1, i] - to[1], x[2, i] - to[2]
        g, nx, ny, nz, ax, ay, az, ca, cb = probe_turned(body, pose, px, py, pz)
        depth = obstacles.thickness[i] - g
        pressed, k, _ = squeezed(obstacles, o, i, depth)
        arm = (px - hub[0], py - hub[1], pz - hub[2])
        n, a, c = (nx, ny, nz), (ax, ay, az), grip[DAMP, i]
        u = minus3((v[0, i], v[1, i], v[2, i]), swept(ux, uy, uz, sweep, arm[0], arm[1], arm[2]))
        rise, by_gap, by_place, by_speed = closing(dot3(n, u), -depth, n, a, ca, cb, u)
        push = pressed - c * rise
        if not push > 0.0:
            continue
        kt, ct, mu = grip[STIFF, i] + per * c, own * c, friction_at(grip, i, now[0] - now[1])
        fx, fy, fz, sx, sy, sz = carried(hub, axle, angle, then, grip, place, i, px, py, pz, turn)
        way = (sx, sy, sz)
        pull = minus3((fx, fy, fz), plus3(scale3(kt, way), scale3(ct, u)))
        q = minus3(pull, scale3(dot3(n, pull), n))
        force = plus3(scale3(push, n), cut(q[0], q[1], q[2], mu * push))
        e = cross3(axis, arm)
        dx, dv = scale3(-h, e), scale3(-1.0, plus3(e, scale3(h, cross3(axis, u))))
        dn = across(ca, cb, n, a, dx)
        uH = across(ca, cb, n, a, u)
        more = (
            by_gap * dot3(n, dx) + by_place * dot3(uH, dx) + by_speed * dot3(uH, dv)
        )  # of what may pass
        more = -k * dot3(n, dx) - c * (dot3(dn, u) + dot3(n, dv) + more)
        was = (
            place[0, i] - then[0] - hub[0],
            place[1, i] - then[1] - hub[1],
            place[2, i] - then[2] - hub[2],
        )
        back = minus3(scale3(-h, cross3(axis, way)), carried_on(axle, by, was))  # of the way
        change = scale3(-1.0, plus3(scale3(kt, back), scale3(ct, dv)))
        led = changes(n, dn, push, more, pull, change, mu)
        led = plus3(led, scale3(h, cross3(axis, force)))
        one = dot3(e, force)
        total -= one
        parts += abs(one)
        slope += dot3(e, led)
        if keep:
            ties[COLUMN, i], ties[COLUMN + 1, i], ties[COLUMN + 2, i] = led
    return total, slope, parts


@kernel
def weight_torque(obstacles, wheel, w, rate, now):
    """Return the torque of a body's weight at a rate [N m], and -its slope [N m s]."""
    p, q = obstacles.weight[w, 0], obstacles.weight[w, 1]
    if wheel[PART] > 0.0:
        h = wheel[PART]
        angle = wheel[ANGLE] + wheel[LEAD] + h * rate
        c, s = math.cos(angle), math.sin(angle)
        return p * c + q * s, h * (p * s - q * c)
    return p * math.cos(wheel[ANGLE]) + q * math.sin(wheel[ANGLE]), 0.0


@kernel
def work_of_weight(weight, w, angle, turn):
    """Return the work of a body's weight as it turns from an angle [J]."""
    p, q = weight[w, 0], weight[w, 1]
    if p == 0.0 and q == 0.0:
        return 0.0
    # sin b - sin a and cos a - cos b, without their difference
    middle, across = angle + 0.5 * turn, 2.0 * math.sin(0.5 * turn)
    return across * (p * math.cos(middle) + q * math.sin(middle))


@deferred("float64")
def turning_error(obstacles, wheel):
    """Return the energy of bodies with a weight that nothing has put in or taken [J], up to a constant.

    Others have none, as `keep_wheels` books works.
    """
    total = 0.0
    for w in range(wheel.shape[0]):
        if obstacles.weight[w, 0] != 0.0 or obstacles.weight[w, 1] != 0.0:
            moves = 0.5 * obstacles.inertia[w] * wheel[w, RATE] * wheel[w, RATE]
            total += moves - wheel[w, ROPES] - wheel[w, BEARING] - wheel[w, FALL]
    return total


@kernel
def find_turning(x, v, obstacles, memory, o, now):
    """Write rate, s and torques of a body: Newton's method, held between bounds as they are found."""
    w = obstacles.wheel[o]
    wheel, h = memory.wheel[w], span_of(memory.wheel[w], now)
    inertia, bearing, viscous = obstacles.inertia[w] / h, obstacles.bearing[w], obstacles.viscous[w]
    before, hold = wheel[KNOWN], 0.0
    if bearing > 0.0:
        drive, _, _ = turning_torque(0.0, x, v, obstacles, memory, o, now, False)
        weigh, _ = weight_torque(obstacles, wheel, w, 0.0, now)
        push = inertia * before + drive + weigh
        if abs(push) <= bearing:
            wheel[TRIAL], wheel[DRIVE], wheel[DRAG], wheel[WEIGH] = (
                0.0,
                drive,
                -inertia * before,
                weigh,
            )
            wheel[DRAG] -= drive + weigh
            return
        hold = bearing if push > 0.0 else -bearing
    low, high, rate, last, close, tie = -math.inf, math.inf, before, math.inf, False, 0.0
    if hold > 0.0:
        low, rate = 0.0, max(rate, 0.0)
    elif hold < 0.0:
        high, rate = 0.0, min(rate, 0.0)
    drive, weigh = 0.0, 0.0
    for _ in range(MOST):
        drive, slope, parts = turning_torque(rate, x, v, obstacles, memory, o, now, False)
        weigh, steep = weight_torque(obstacles, wheel, w, rate, now)
        tie = inertia + viscous + slope + steep
        left = inertia * (rate - before) + viscous * rate + hold - drive - weigh
        scale = (
            inertia * (abs(rate) + abs(before)) + viscous * abs(rate) + bearing + parts + abs(weigh)
        )
        if close or abs(left) <= TIGHT * scale:
            break
        close = abs(left) <= CLOSE * scale  # one step more is as near as rounding lets it
        slow = abs(left) > 0.5 * last
        last = abs(left)
        if left > 0.0:
            high = rate
        else:
            low = rate
        new = next_rate(rate, left, tie, low, high, slow and not close, FARTHEST / h)
        if new == rate:
            break
        rate = new
    wheel[TRIAL], wheel[DRIVE], wheel[DRAG], wheel[WEIGH] = (
        rate,
        drive,
        -hold - viscous * rate,
        weigh,
    )
    wheel[TIE] = tie


@small
def next_rate(rate, left, tie, low, high, slow, most):
    """Return the next guess for a rate between its bounds, no farther than `most` from this one."""
    new = rate - left / tie if tie > 0.0 else rate - math.copysign(most, left)
    new = min(max(new, rate - most), rate + most)
    if (slow or not low < new < high) and high - low < math.inf:
        return 0.5 * (low + high)
    return new
