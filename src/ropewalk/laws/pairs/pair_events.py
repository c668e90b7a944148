"""When ropes begin to press each other: events, since the force of a contact jumps or has a kink there.

As a length a contact presses by e = (R(-g) - c g') / k, see `force` and `laws.touch_events`, from where e
rises through zero. One that was there as the step began is followed along the flight of its four nodes, with
the accelerations that they began with, and its own points, normal and offset. What has become a contact in
the step is followed to where it is within reach, for before there is none, and then to where it is pressed.
Steps end just behind that reach where its damper takes hold of it there, and else just before it is pressed.
Segments that throw back are followed to where they are pressed, wherever they are nearest: beside each other
at one end, they may meet at the other. What takes over from a contact beside it begins nothing. Where ropes
part no step ends but of contacts that throw back, just behind: others have little of their speed left, and so
little error.
"""

from __future__ import annotations

import math

from ropewalk.core.jit import deferred, kernel, small
from ropewalk.laws.events import KINK, end_of_pressing
from ropewalk.laws.pairs.distance import less, nearest_of, product
from ropewalk.laws.pairs.force import depth_at, squeeze
from ropewalk.laws.pairs.search import row_of
from ropewalk.laws.pairs.table import (
    CONTACTS,
    LAYER,
    NORMAL,
    OTHER,
    OWN,
    PUSH,
    REACH,
    between,
    reduced,
    spring_of,
    throws_back,
)

TRIES = 100  # for where a pair is within reach
NEAR = 1e-3  # [1] of the reach: so near Newton's method takes over
REFINED = 4  # so many times
LOOKS = 20  # for where segments meet that throw back


@small
def across(a, grip, row, i, j):
    """Return the part across a contact of what its points have of a (3, n)."""
    u = between(a, i, j, grip[row, OWN], grip[row, OTHER])
    return grip[row, NORMAL] * u[0] + grip[row, NORMAL + 1] * u[1] + grip[row, NORMAL + 2] * u[2]


@kernel
def pressed_by(x, v, table, memory, row, i, j):
    """Return by how much a contact presses at x and v as a length [m]; less than nothing: it is open."""
    soft, hard, stop, damping, size = spring_of(table, memory.grip, row, i, j)
    depth = depth_at(x, memory, row, i, j, size)
    force = squeeze(depth, soft, hard, stop, LAYER * size)[0]
    return (force - table.ratio[0] * damping * across(v, memory.grip, row, i, j)) / soft


@small
def first_root(e, rate, bend):
    """Return where e + rate t - bend t^2 / 2 rises through zero, e < 0, for the first time; inf: nowhere."""
    square = rate * rate + 2.0 * bend * e
    if square < 0.0 or (rate <= 0.0 and bend >= 0.0):
        return math.inf
    root = math.sqrt(square)
    return -2.0 * e / (rate + root) if rate > 0.0 else (root - rate) / -bend


@kernel
def end_of_touch(table, before, after, row, i, j, dt, tolerance):
    """Return where a step is to end [s] in which a contact begins or ceases to press; inf: where it does."""
    memory = before.memory.contact
    soft, _, _, damping, _ = spring_of(table, memory.grip, row, i, j)
    damping *= table.ratio[0]
    mass, bend = (
        reduced(table, memory.grip, row, i, j),
        across(before.acceleration, memory.grip, row, i, j),
    )
    e = pressed_by(before.x, before.v, table, memory, row, i, j)
    e1 = pressed_by(after.x, after.v, table, memory, row, i, j)
    if (e > 0.0) == (e1 > 0.0) or (e > 0.0 and not throws_back(table)):
        return math.inf
    rate = -across(before.v, memory.grip, row, i, j) - damping / soft * bend
    early = math.inf
    if e1 > 0.0:
        early = first_root(e, rate, bend)
        e1 *= 1.0 + dt * damping / mass  # had nothing braked it
    return end_of_pressing(e, rate, early, e1, dt, math.sqrt(soft / mass), tolerance)


@small
def flown(state, i, t):
    """Return where a node will be in a time [s] that flies on with its acceleration [m]."""
    x, v, a = state.x, state.v, state.acceleration
    return (
        x[0, i] + t * (v[0, i] + 0.5 * t * a[0, i]),
        x[1, i] + t * (v[1, i] + 0.5 * t * a[1, i]),
        x[2, i] + t * (v[2, i] + 0.5 * t * a[2, i]),
    )


@small
def flies(state, i, t):
    """Return how fast it will be then [m/s]."""
    v, a = state.v, state.acceleration
    return (v[0, i] + t * a[0, i], v[1, i] + t * a[1, i], v[2, i] + t * a[2, i])


@small
def mean(a, b, s):
    """Return the weighted mean (1 - s) a + s b."""
    return (
        (1.0 - s) * a[0] + s * b[0],
        (1.0 - s) * a[1] + s * b[1],
        (1.0 - s) * a[2] + s * b[2],
    )


@kernel
def apart_then(state, i, j, t):
    """Return how far apart two segments will be in a time [s] that fly on so [m], and its rate [m/s]."""
    a, b = flown(state, i, t), flown(state, i + 1, t)
    c, d = flown(state, j, t), flown(state, j + 1, t)
    p, q, distance = nearest_of(a, b, c, d)
    if distance == 0.0:
        return 0.0, 0.0
    u = less(mean(a, b, p), mean(c, d, q))
    w = less(
        mean(flies(state, i, t), flies(state, i + 1, t), p),
        mean(flies(state, j, t), flies(state, j + 1, t), q),
    )
    return distance, product(u, w) / distance


@kernel
def fastest(state, i, j, dt):
    """Return how fast points of two segments are against each other within a time [s] at most [m/s]."""
    most, v, a = 0.0, state.v, state.acceleration
    for p in range(2):
        for q in range(2):
            speed, more = 0.0, 0.0
            for k in range(3):
                speed += (v[k, i + p] - v[k, j + q]) ** 2
                more += (a[k, i + p] - a[k, j + q]) ** 2
            most = max(most, math.sqrt(speed) + dt * math.sqrt(more))
    return most


@kernel
def comes_within(state, i, j, reach, dt):
    """Return when two segments come within a reach [m] that fly on so [s]; inf: not in `dt`."""
    most, at = max(fastest(state, i, j, dt), 1e-300), 0.0
    for _ in range(TRIES):
        distance = apart_then(state, i, j, at)[0]
        if distance <= (1.0 + NEAR) * reach:
            break
        at += (distance - reach) / most
        if not at < dt:
            return math.inf
    for _ in range(REFINED):
        distance, rate = apart_then(state, i, j, at)
        if not (rate < 0.0 and distance > reach):
            break
        at += (distance - reach) / -rate
    return at if at < dt else math.inf


@kernel
def end_of_meeting(table, before, after, row, i, j, dt, tolerance):
    """Return where a step is to end [s] in which two segments have become a contact; inf: where it does."""
    size = table.radius[i] + table.radius[j]
    soft = 1.0 / (table.soft[i] + table.soft[j])
    mass = reduced(table, after.memory.contact.grip, row, i, j)
    lag = 2.0 * math.sqrt(mass / soft)
    at = comes_within(before, i, j, REACH * size, dt)
    if at == math.inf:
        return at
    distance, rate = apart_then(before, i, j, at)
    if not rate < 0.0:
        return math.inf
    near = KINK * tolerance / -rate
    if size - distance - lag * rate > 0.0:  # it is pressed as soon as it is there
        return at + 0.5 * near if at > 0.0 and dt - at > near else math.inf
    for _ in range(REFINED):
        at += (distance - size + lag * rate) / -rate
        distance, rate = apart_then(before, i, j, at)
        if not rate < 0.0:
            return math.inf
    return at - 0.5 * near if near < at < dt else math.inf


@kernel
def meets(state, i, j, size, lag, dt):
    """Return when segments that fly on so begin to be pressed, where they are nearest [s]; inf: not in `dt`.

    They are where size - distance - lag * rate rises through zero.
    """
    low, high = 0.0, dt
    distance, rate = apart_then(state, i, j, 0.0)
    first = size - distance - lag * rate
    distance, rate = apart_then(state, i, j, dt)
    last = size - distance - lag * rate
    if first > 0.0 or not last > 0.0:
        return math.inf
    for look in range(LOOKS):
        at = low + (high - low) * (0.5 if look % 2 == 0 else first / (first - last))
        distance, rate = apart_then(state, i, j, at)
        here = size - distance - lag * rate
        if here > 0.0:
            high, last = at, here
        else:
            low, first = at, here
    return low - (high - low) * first / (last - first)


@kernel
def end_of_hit(table, before, after, row, i, j, dt, tolerance):
    """Return where a step is to end [s] in which segments have met that throw back; inf: where it does."""
    last = after.memory.contact
    soft, _, _, damping, size = spring_of(table, last.grip, row, i, j)
    presses = last.grip[row, PUSH] > 0.0
    if not presses and not pressed_by(after.x, after.v, table, last, row, i, j) > 0.0:
        return math.inf
    at = meets(before, i, j, size, table.ratio[0] * damping / soft, dt)
    if at == math.inf:
        return at
    rate = apart_then(before, i, j, at)[1]
    near = KINK * tolerance / max(-rate, 1e-300)
    return at - 0.5 * near if near < at < dt - near else math.inf


@kernel
def takes_over(before, after, i, j):
    """Tell whether a contact of segments beside these was pressed, and is gone."""
    first, last = before.memory.contact, after.memory.contact
    for a in range(i - 1, i + 2):
        for b in range(j - 1, j + 2):
            row = row_of(first, a, b)
            if row >= 0 and first.grip[row, PUSH] > 0.0 and row_of(last, a, b) < 0:
                return True
    return False


@deferred("float64", 2)
def pair_events(table, before, after, dt, tolerance):
    """Return where a step between two states is to end for the first contact that begins to press [s].

    Infinite: where it does; or ceases to, of those that throw back. And how many have, or are new.
    """
    first, last, end, changes = before.memory.contact, after.memory.contact, math.inf, 0
    for row in range(last.tally[CONTACTS]):
        i, j = last.pair[row, 0], last.pair[row, 1]
        old = row_of(first, i, j)
        if throws_back(table) and (old < 0 or not first.grip[old, PUSH] > 0.0):
            if old >= 0 or not takes_over(before, after, i, j):
                at = end_of_hit(table, before, after, row, i, j, dt, tolerance)
                changes += 1 if at < math.inf or last.grip[row, PUSH] > 0.0 else 0
                end = min(end, at)
            continue
        if old < 0:
            if not takes_over(before, after, i, j):
                changes += 1
                end = min(end, end_of_meeting(table, before, after, row, i, j, dt, tolerance))
            continue
        was, presses = first.grip[old, PUSH] > 0.0, last.grip[row, PUSH] > 0.0
        if was != presses and (presses or throws_back(table)):
            changes += 1
            end = min(end, end_of_touch(table, before, after, old, i, j, dt, tolerance))
    return end, float(changes)
