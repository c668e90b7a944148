"""When a step is to end for an event inside it; see `methods.crossings`."""

from __future__ import annotations

import math

from ropewalk.core.jit import small


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
