"""How the forces of contacts change with places and velocities; see `contact`.

With H of the surface, k the slope of R, b = mu R_n, q before it is cut and s = q/|q|,
    -dR_n = k n.dx + z c (n.dv + v.H dx - n.(W x dx))      of a contact that pushes, see `closing` beside it
    -dq   = k_t P dx + c P dv + (n.w) H dx + n (w.H dx),   w = R' - k_t D - c v
    -dR   = n (-dR_n) - R_n H dx + (-dq                                  where it sticks
                                    mu s (-dR_n) + (b/|q|) (I - s s^T) (-dq)   where it slips)
The last but one makes it unsymmetric. The surface's own velocity changes with the place by its spin, which is
W where it moves the surface itself.
"""

from __future__ import annotations

import math

from ropewalk.core.blocks import load9, subtract
from ropewalk.core.jit import deferred, kernel
from ropewalk.laws.closing import across, closing
from ropewalk.laws.contact_frame import DAMP, STIFF, friction_at, spring_pull
from ropewalk.laws.hardening import squeezed
from ropewalk.laws.obstacle_lead import led
from ropewalk.laws.obstacle_pose import body_of, pose_of, probe_turned, rates_of, swept
from ropewalk.laws.obstacle_reach import is_out_of_reach
from ropewalk.laws.wheel_rows import surface_then
from ropewalk.laws.wheels import begin_ties, find_rates, turned, write_row


@deferred()
def contact_tangent(x, v, obstacles, memory, now, weight_x, weight_v, band):
    """Add -(weight_x dR/dx + weight_v dR/dv) of all contacts to the band's diagonal."""
    diagonal, place, since = band.diagonal, memory.place, now[0] - now[1]
    find_rates(x, v, obstacles, memory, now)
    begin_ties(x, v, obstacles, memory, now)
    for o in range(obstacles.kind.shape[0]):
        hub, axle, grip = obstacles.hub[o], obstacles.axle[o], memory.grip[o]
        mx, my, mz, ux, uy, uz, angle, rate = turned(obstacles, memory, o, now)
        then = surface_then(obstacles, memory.wheel, o, now)
        body, pose = body_of(obstacles, o), pose_of(obstacles, o, then[6] + angle)
        (wx, wy, wz), sweep = rates_of(obstacles, o, rate)
        to, at, count = (mx, my, mz), (ux, uy, uz), x.shape[1]
        to, at, turns, per, own_speed = led(obstacles, memory, o, now, then, to, at, angle)
        (mx, my, mz), (ux, uy, uz) = to, at
        if is_out_of_reach(x, v, obstacles, grip, o, pose, to, at, sweep, 0, count):
            continue
        tied = obstacles.wheel[o] >= 0
        whole = tied and obstacles.sweeps[o]  # what presses turns it, too
        for i in range(x.shape[1]):
            if memory.held[i] != 0:
                continue
            px, py, pz = x[0, i] - mx, x[1, i] - my, x[2, i] - mz
            g, nx, ny, nz, ax, ay, az, ca, cb = probe_turned(body, pose, px, py, pz)
            ox, oy, oz = px - hub[0], py - hub[1], pz - hub[2]
            lx, ly, lz = swept(ux, uy, uz, sweep, ox, oy, oz)
            vx, vy, vz = v[0, i] - lx, v[1, i] - ly, v[2, i] - lz
            c, depth = grip[DAMP, i], obstacles.thickness[i] - g
            damper = obstacles.ratio[o] * c
            n, a, speed = (nx, ny, nz), (ax, ay, az), (vx, vy, vz)
            rise, by_gap, by_place, by_speed = closing(
                nx * vx + ny * vy + nz * vz, -depth, n, a, ca, cb, speed
            )
            pressed, k, _ = squeezed(obstacles, o, i, depth)
            push = pressed - damper * rise
            if not push > 0.0:
                continue
            vH = across(ca, cb, n, a, speed)
            hx, hy, hz = swept(vH[0], vH[1], vH[2], sweep, nx, ny, nz)  # - n . (W x dx)
            # -dR_n = drop . (weighted step)
            apart = weight_x * (k + damper * by_gap) + weight_v * damper
            aside = damper * (weight_x * by_place + weight_v * by_speed)
            by_turn = weight_x * damper
            tx, ty, tz = swept(0.0, 0.0, 0.0, sweep, vH[0], vH[1], vH[2])
            drop = (
                apart * nx + by_turn * (hx + by_speed * tx) + aside * vH[0],
                apart * ny + by_turn * (hy + by_speed * ty) + aside * vH[1],
                apart * nz + by_turn * (hz + by_speed * tz) + aside * vH[2],
            )
            bend = -weight_x * push  # R_n H
            before = load9(diagonal, i)
            for p in range(3):
                for r in range(3):
                    diagonal[i, 3 * p + r] += n[p] * drop[r] + bend * curve(ca, cb, n, a, p, r)
            mu = friction_at(grip, i, since)
            bound, pull = mu * push, (0.0, 0.0, 0.0)
            if bound > 0.0:
                vx, vy, vz = (
                    vx - (wy * oz - wz * oy),
                    vy - (wz * ox - wx * oz),
                    vz - (wx * oy - wy * ox),
                )
                kt = grip[STIFF, i]
                kt, c = kt + per * c, own_speed * c
                sx, sy, sz = spring_pull(
                    kt, hub, axle, angle, then, grip, place, i, px, py, pz, turns
                )
                pull = (sx - c * vx, sy - c * vy, sz - c * vz)
                own, turn = weight_x * kt + weight_v * c, weight_x * c
                turning = (turn * (wx + sweep[0]), turn * (wy + sweep[1]), turn * (wz + sweep[2]))
                before = before if whole else load9(diagonal, i)
                rub(diagonal, i, n, a, ca, cb, pull, bound, mu, drop, own, turning, weight_x)
            if whole or (tied and bound > 0.0):
                arm, more = (ox, oy, oz), subtract(load9(diagonal, i), before)
                presses = push if whole else 0.0
                write_row(obstacles, memory, o, i, arm, n, presses, pull, bound, more, weight_x)


@kernel
def rub(diagonal, i, n, a, ca, cb, pull, bound, friction, drop, own, turning, weight_x):
    """Add the derivative of R_t. `pull` is R' - k D - c v, `own` the weighted k_t and c.

    `turning` is the weighted c times the surface's angular velocity.
    """
    tx, ty, tz = turning
    along = n[0] * pull[0] + n[1] * pull[1] + n[2] * pull[2]
    q = (pull[0] - along * n[0], pull[1] - along * n[1], pull[2] - along * n[2])
    total = math.sqrt(q[0] * q[0] + q[1] * q[1] + q[2] * q[2])
    slips = total > bound
    share = bound / total if slips else 1.0
    over = 1.0 / total if slips else 0.0
    s = (over * q[0], over * q[1], over * q[2])
    wH = across(ca, cb, n, a, pull)
    for r in range(3):
        # column r of -dq
        e = (own * (r == 0), own * (r == 1), own * (r == 2))
        # c dv: less the surface's velocity w x dx
        if r == 0:
            e = (e[0], e[1] - tz, e[2] + ty)
        elif r == 1:
            e = (e[0] + tz, e[1], e[2] - tx)
        else:
            e = (e[0] - ty, e[1] + tx, e[2])
        lift = n[0] * e[0] + n[1] * e[1] + n[2] * e[2]
        d0 = e[0] - lift * n[0] + weight_x * (along * curve(ca, cb, n, a, 0, r) + n[0] * wH[r])
        d1 = e[1] - lift * n[1] + weight_x * (along * curve(ca, cb, n, a, 1, r) + n[1] * wH[r])
        d2 = e[2] - lift * n[2] + weight_x * (along * curve(ca, cb, n, a, 2, r) + n[2] * wH[r])
        if slips:
            ahead = s[0] * d0 + s[1] * d1 + s[2] * d2
            more = friction * drop[r]
            d0 = share * (d0 - ahead * s[0]) + more * s[0]
            d1 = share * (d1 - ahead * s[1]) + more * s[1]
            d2 = share * (d2 - ahead * s[2]) + more * s[2]
        diagonal[i, r] += d0
        diagonal[i, 3 + r] += d1
        diagonal[i, 6 + r] += d2


@kernel
def curve(ca, cb, n, a, p, r):
    """Return entry (p, r) of H."""
    one = 1.0 if p == r else 0.0
    return ca * (one - n[p] * n[r] - a[p] * a[r]) + cb * a[p] * a[r]
