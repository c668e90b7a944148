"""How bodies lead what sticks to them, by the steps of the method in hand.

A node's velocity is what its method makes of its way: by implicit Euler the mean over the step, (x1 - x0)/h;
of a method that begins with such a stage, of c = g h, (X - x0)/c there. Against the velocity u that the body
has then, a node which sticks to what is accelerated would slip, by a h/2. So friction's damper has it against
what the method would make of a place p of the body that the node sticks to:
    implicit Euler        p1 at its end, as it lies; V - U = (x1 - p1) / h
    a first stage         U = ((p1 - p0)/h - g u1) / (1 - g), P = p0 + c U; V - U = (X - P) / c
with which the next stage, by u1 and p1 as they are, is the end of the same way. Either is the way D over the
surface by the time: the damper is a spring of c/h more. What presses has the mean of the body's way without
its turning: a chord of what turns has a part across its surface, which only what sticks goes along with. Of
what stands, or goes on as it does and does not turn, all that is v - u, and left as it is.
What turns freely has a rate w of the method's own, and turns by w h, in a first stage by w c. Its end is not
known there; taken to turn on by w it comes to the same but for the third order of h.
"""

from __future__ import annotations

import math

from ropewalk.core.jit import kernel, part, small
from ropewalk.laws.contact_frame import surface_at, turn_of
from ropewalk.laws.wheel_rows import RATE, span_of

ROUNDED = 1e-12  # [1] of the places: more than rounding does to a way
FARTHEST = 0.5 * math.pi  # [rad] in a step: what turns farther has no chord to speak of


@part
def lead_until(state, end):
    """Note the end of the step in hand [s] where a stage of it begins as above, -inf: it does not."""
    until = state.memory.obstacle.until
    if until.shape[0] > 0:
        until[0] = end


@kernel
def led(obstacles, memory, o, now, then, moved, speed, angle):
    """Return how obstacle o leads what sticks to it: place [m] and velocity [m/s], (3) each, and three more.

    How a place goes with its turning, `carried`'s (c, s); 1 over the time by which a way over it is made a
    velocity [1/s], 0: it is not; and 0 or 1, what counts of the velocity in hand. `moved`, `speed`, `angle`
    are its own, `then` where it was.
    """
    turn, end, span = turn_of(angle), memory.until[0], now[0] - now[1]
    if not (end >= now[0] and span > 0.0):
        return moved, speed, turn, 0.0, 1.0
    x, y, z, vx, vy, vz, whole, rate = surface_at(obstacles, o, end)
    w, whole, h, size = obstacles.wheel[o], whole - then[6], end - now[1], 0.0
    far = abs(whole)
    if w >= 0:
        whole, rate, far = angle * (h / span), angle / span, abs(memory.wheel[w, RATE]) * h
    way = (x - then[0], y - then[1], z - then[2])
    off = (way[0] - h * vx, way[1] - h * vy, way[2] - h * vz)
    for k in range(3):
        size += abs(obstacles.center[o, k]) + abs(then[k]) + abs(way[k])
    jumps = abs(off[0]) + abs(off[1]) + abs(off[2]) > ROUNDED * size
    if not (jumps or whole != 0.0) or far > FARTHEST:
        return moved, speed, turn, 0.0, 1.0
    if end > now[0]:
        turn = first_turn(span / h, whole, h * rate)
        if jumps:
            moved, speed = first_place(span, h, then, way, (vx, vy, vz))
    elif jumps:
        speed = (way[0] / h, way[1] / h, way[2] / h)
    return moved, speed, turn, 1.0 / span, 0.0


@kernel
def led_freely(obstacles, memory, o, now, angle):
    """Return how obstacle o lay as the memory was kept, and what `led` has if it turned by `angle` since."""
    x, y, z, vx, vy, vz, _, _ = surface_at(obstacles, o, now[0])
    then = surface_at(obstacles, o, now[1])
    return then, led(obstacles, memory, o, now, then, (x, y, z), (vx, vy, vz), angle)


@kernel
def turn_by_rate(obstacles, memory, o, now, angle, per):
    """Return how a way's (c, s) change with the rate of what turns freely [s]; `per` is `led`'s."""
    c, s, span = math.cos(angle), math.sin(angle), span_of(memory.wheel[obstacles.wheel[o]], now)
    if not (per > 0.0 and memory.until[0] > now[0]):
        return -span * s, span * c
    h = memory.until[0] - now[1]
    g, whole = span / h, angle * (h / span)
    c, s, more = math.cos(whole), math.sin(whole), span / (1.0 - g)
    return more * (g * whole * c - (1.0 - g) * s), more * (g * whole * s + (1.0 - g) * c)


@small
def carried_on(axis, by, o):
    """Return by how much `rotated` changes a vector as its cosine and sine change by these two."""
    ax, ay, az = axis[0], axis[1], axis[2]
    c, s = by
    ex, ey, ez = ay * o[2] - az * o[1], az * o[0] - ax * o[2], ax * o[1] - ay * o[0]
    return (
        s * ex - c * (ay * ez - az * ey),
        s * ey - c * (az * ex - ax * ez),
        s * ez - c * (ax * ey - ay * ex),
    )


@kernel
def mean_speed(obstacles, o, time, often):
    """Return the velocity of a body without its turning [m/s], the mean of 1 / `often` before a time [s]."""
    x, y, z, _, _, _, _, _ = surface_at(obstacles, o, time)
    then = surface_at(obstacles, o, time - 1.0 / often)
    return often * (x - then[0]), often * (y - then[1]), often * (z - then[2])


@small
def first_turn(g, whole, turning):
    """Return (c, s) for a first stage of g of a step that turns by `whole` [rad], at its end at `turning`."""
    c, s, more = math.cos(whole), math.sin(whole), g / (1.0 - g)
    return 1.0 + more * (c - 1.0 + g * turning * s), more * (s - g * turning * c)


@small
def first_place(span, h, then, way, speed):
    """Return where a first stage of `span` [s] of a step of h [s] has a body, and its velocity."""
    g = span / h
    more = 1.0 / (1.0 - g)
    u = (
        more * (way[0] / h - g * speed[0]),
        more * (way[1] / h - g * speed[1]),
        more * (way[2] / h - g * speed[2]),
    )
    return (then[0] + span * u[0], then[1] + span * u[1], then[2] + span * u[2]), u
