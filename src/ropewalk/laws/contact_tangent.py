"""How the forces of contacts change with places and velocities; see `contact`.

With H of the surface, k the slope of R, b = mu R_n, q before it is cut and s = q/|q|,
    -dR_n = k n.dx + z c (n.dv + v.H dx - n.(W x dx))      of a contact that pushes, see `closing` beside it
    -dq   = k_t P dx + c P dv + (n.w) H dx + n (w.H dx),   w = R' - k_t D - c v
    -dR   = n (-dR_n) - R_n H dx + (-dq                                  where it sticks
                                    mu s (-dR_n) + (b/|q|) (I - s s^T) (-dq)   where it slips)
Where ropes touch, s s^T counts less while a node turns in a solve, see `slip_course`.
The last but one makes it unsymmetric. The surface's own velocity changes with the place by its spin, which is
W where it moves the surface itself. `Band.definite` leaves - R_n H out: far from the solution, in a ball by
centimetres, it outweighs a node's inertia a thousand times.
"""

from __future__ import annotations

import math

from ropewalk.core.blocks import ZERO3, ZERO9, add, load9, scale3, scale9, store9, subtract
from ropewalk.core.jit import deferred, small
from ropewalk.laws.closing import across, closing
from ropewalk.laws.contact_frame import DAMP, STIFF, SURELY, friction_at, spring_pull
from ropewalk.laws.hardening import squeezed
from ropewalk.laws.obstacle_lead import led
from ropewalk.laws.obstacle_pose import body_of, pose_of, probe_turned, rates_of, swept
from ropewalk.laws.obstacle_reach import RUN, first_run, is_out_of_reach
from ropewalk.laws.slip_course import follow_slip
from ropewalk.laws.wheel_rows import surface_then
from ropewalk.laws.wheels import begin_ties, find_rates, turned, write_row


@deferred()
def contact_tangent(x, v, obstacles, memory, now, weight_x, weight_v, band):
    """Add -(weight_x dR/dx + weight_v dR/dv) of all contacts to the band's diagonal."""
    diagonal, place, since = band.diagonal, memory.place, now[0] - now[1]
    by_bend = 0.0 if band.definite[0] == 1 else weight_x
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
        away, seen = False, first_run(obstacles, o, 0, count)
        for i in range(count):
            if i == seen:
                seen = min(i + RUN, count)
                away = is_out_of_reach(x, v, obstacles, grip, o, pose, to, at, sweep, i, seen)
            if away or memory.held[i] != 0:
                continue
            px, py, pz = x[0, i] - mx, x[1, i] - my, x[2, i] - mz
            g, nx, ny, nz, ax, ay, az, ca, cb = probe_turned(body, pose, px, py, pz)
            ox, oy, oz = px - hub[0], py - hub[1], pz - hub[2]
            lx, ly, lz = swept(ux, uy, uz, sweep, ox, oy, oz)
            vx, vy, vz = v[0, i] - lx, v[1, i] - ly, v[2, i] - lz
            c, depth = grip[DAMP, i], obstacles.thickness[i] - g
            damper, rise = obstacles.ratio[o] * c, nx * vx + ny * vy + nz * vz
            n, a, speed = (nx, ny, nz), (ax, ay, az), (vx, vy, vz)
            pressed, k, _ = squeezed(obstacles, o, i, depth)
            if not pressed - damper * rise > 0.0:  # `closing` leaves less
                continue
            rise, by_gap, by_place, by_speed = closing(rise, -depth, n, a, ca, cb, speed)
            push = pressed - damper * rise
            if not push > 0.0:
                continue
            bent = ca != 0.0 or cb != 0.0
            vH = across(ca, cb, n, a, speed) if bent else ZERO3
            hx, hy, hz = swept(vH[0], vH[1], vH[2], sweep, nx, ny, nz)  # - n . (W x dx)
            # -dR_n = drop . (weighted step)
            apart = weight_x * (k + damper * by_gap) + weight_v * damper
            by_turn, aside = weight_x * damper, damper * (weight_x * by_place + weight_v * by_speed)
            tx, ty, tz = swept(0.0, 0.0, 0.0, sweep, vH[0], vH[1], vH[2])
            drop = (
                apart * nx + by_turn * (hx + by_speed * tx) + aside * vH[0],
                apart * ny + by_turn * (hy + by_speed * ty) + aside * vH[1],
                apart * nz + by_turn * (hz + by_speed * tz) + aside * vH[2],
            )
            bend = -by_bend * push  # R_n H
            curves = curved(ca, cb, n, a) if bent else ZERO9
            before = load9(diagonal, i)
            block = add(before, press(n, drop, bend, curves))
            mu, pull = friction_at(grip, i, since), ZERO3
            bound = mu * push
            if bound > 0.0:
                vx, vy, vz = (
                    vx - (wy * oz - wz * oy),
                    vy - (wz * ox - wx * oz),
                    vz - (wx * oy - wy * ox),
                )
                kt, c = grip[STIFF, i] + per * c, own_speed * c
                sx, sy, sz = spring_pull(
                    kt, hub, axle, angle, then, grip, place, i, px, py, pz, turns
                )
                pull = (sx - c * vx, sy - c * vy, sz - c * vz)
                own, turn = weight_x * kt + weight_v * c, weight_x * c
                turning = (turn * (wx + sweep[0]), turn * (wy + sweep[1]), turn * (wz + sweep[2]))
                before = before if whole else block
                bends = curves, across(ca, cb, n, a, pull) if bent else ZERO3
                slips = mu, follow_slip(band.slips, o, i, n, pull, bound)
                block = add(block, rub(n, bends, pull, bound, slips, drop, own, turning, weight_x))
            store9(diagonal, i, block)
            if whole or (tied and bound > 0.0):
                arm, more, presses = (ox, oy, oz), subtract(block, before), push if whole else 0.0
                write_row(obstacles, memory, o, i, arm, n, presses, pull, bound, more, weight_x)


@small
def press(n, drop, bend, curves):
    """Return n (-dR_n) - R_n H, the last a `bend` of H."""
    across_it = (
        n[0] * drop[0], n[0] * drop[1], n[0] * drop[2],
        n[1] * drop[0], n[1] * drop[1], n[1] * drop[2],
        n[2] * drop[0], n[2] * drop[1], n[2] * drop[2],
    )  # fmt: skip
    return add(across_it, scale9(bend, curves))


@small
def rub(n, bends, pull, bound, slips, drop, own, turning, weight_x):
    """Return the derivative of R_t. `pull` is R' - k D - c v, `own` the weighted k_t and c.

    `bends` are H and H pull, `turning` is the weighted c times the surface's angular velocity, `slips` are mu
    and the part of s s^T that counts.
    """
    tx, ty, tz = turning
    curves, wH = bends
    along = n[0] * pull[0] + n[1] * pull[1] + n[2] * pull[2]
    q = (pull[0] - along * n[0], pull[1] - along * n[1], pull[2] - along * n[2])
    s, cutting = ZERO3, (False, 1.0, slips[0], slips[1])
    square = q[0] * q[0] + q[1] * q[1] + q[2] * q[2]
    if not square < SURELY * bound * bound and math.sqrt(square) > bound:
        total = math.sqrt(square)
        s, cutting = scale3(1.0 / total, q), (True, bound / total, slips[0], slips[1])
    # columns of -dq; c dv is less the surface's velocity w x dx
    e, h = (own, 0.0 - tz, 0.0 + ty), (curves[0], curves[3], curves[6])
    one = column(n, e, h, along, weight_x, wH[0], s, cutting, drop[0])
    e, h = (0.0 + tz, own, 0.0 - tx), (curves[1], curves[4], curves[7])
    two = column(n, e, h, along, weight_x, wH[1], s, cutting, drop[1])
    e, h = (0.0 - ty, 0.0 + tx, own), (curves[2], curves[5], curves[8])
    three = column(n, e, h, along, weight_x, wH[2], s, cutting, drop[2])
    return (
        one[0], two[0], three[0],
        one[1], two[1], three[1],
        one[2], two[2], three[2],
    )  # fmt: skip


@small
def column(n, e, h, along, weight_x, turns, s, cutting, drop):
    """Return a column of what `rub` does, of one of -dq with neither P nor H in it, and one of H."""
    slips, share, friction, counts = cutting
    lift = n[0] * e[0] + n[1] * e[1] + n[2] * e[2]
    d0 = e[0] - lift * n[0] + weight_x * (along * h[0] + n[0] * turns)
    d1 = e[1] - lift * n[1] + weight_x * (along * h[1] + n[1] * turns)
    d2 = e[2] - lift * n[2] + weight_x * (along * h[2] + n[2] * turns)
    if slips:
        ahead = counts * (s[0] * d0 + s[1] * d1 + s[2] * d2)
        more = friction * drop
        d0 = share * (d0 - ahead * s[0]) + more * s[0]
        d1 = share * (d1 - ahead * s[1]) + more * s[1]
        d2 = share * (d2 - ahead * s[2]) + more * s[2]
    return d0, d1, d2


@small
def curved(ca, cb, n, a):
    """Return H, nine numbers."""
    return (
        curve(1.0, ca, cb, n[0], n[0], a[0], a[0]),
        curve(0.0, ca, cb, n[0], n[1], a[0], a[1]),
        curve(0.0, ca, cb, n[0], n[2], a[0], a[2]),
        curve(0.0, ca, cb, n[1], n[0], a[1], a[0]),
        curve(1.0, ca, cb, n[1], n[1], a[1], a[1]),
        curve(0.0, ca, cb, n[1], n[2], a[1], a[2]),
        curve(0.0, ca, cb, n[2], n[0], a[2], a[0]),
        curve(0.0, ca, cb, n[2], n[1], a[2], a[1]),
        curve(1.0, ca, cb, n[2], n[2], a[2], a[2]),
    )


@small
def curve(one, ca, cb, n, m, a, b):
    """Return an entry of H, `one` on its diagonal: n and m, a and b are those of its row and column."""
    return ca * (one - n * m - a * b) + cb * a * b
