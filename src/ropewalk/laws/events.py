"""When a step is to end for an event inside it; see `methods.crossings`, and `touching` of what presses."""

from __future__ import annotations

import math

from ropewalk.core.jit import small

KINK = 0.5  # [1] of the tolerance: how near the ends of steps what begins to press may do so


@small
def end_of_crossing(gap0, rate0, gap1, rate1, dt, tolerance):
    """Return where the step is to end for one change of sides [s]; inf where it may stay."""
    at = dt * gap0 / (gap0 - gap1) if gap0 != gap1 else 0.0
    if gap0 * rate0 < 0.0:
        at = min(at, -gap0 / rate0)
    speed = max(abs(rate0), abs(rate1))
    if speed * (dt - at) <= tolerance:
        return math.inf
    return at + 0.5 * tolerance / speed


@small
def end_of_pressing(e, rate, early, e1, dt, quick, tolerance):
    """Return where the step is to end [s] in which something begins or ceases to press; inf: where it does.

    As a length it presses by `e` at the step's begin, with a `rate` [m/s], and by `e1` at its end [m], as in
    `touching`; it is thought to begin at `early` [s], inf: that is not known, and rings at `quick` [rad/s].
    """
    side = 1.0 if e1 > 0.0 else -1.0
    e, rate, e1, near = side * e, side * rate, side * e1, KINK * tolerance
    bend = (e1 - e - rate * dt) / (dt * dt)
    slope = math.sqrt(max(rate * rate - 4.0 * bend * e, 0.0))  # where it is zero
    if (e1 - e) * min(1.0, dt * quick) <= near or not rate + slope > 0.0:
        return math.inf
    at, near = early if early < dt else -2.0 * e / (rate + slope), near / slope
    if side > 0.0:
        return at - 0.5 * near if at > near else math.inf
    return at + 0.5 * near if dt - at > near else math.inf
