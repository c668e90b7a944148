"""Newton's method on the equations of rest, with pseudo-time where a step would go too far."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

from ropewalk.core.arrays import Floats
from ropewalk.statics.balance import Balance

STEPS = 2000
_TURN = 0.5  # largest turn of a segment in one step [rad]
_NEAR = 1e-4  # error below which the equations are taken as they are, compression and all [1]
_EXACT = 1e-3  # of what is allowed: with less there is nothing to improve [1]
_LEAST = 1e-13  # least inertia, in units of the model's own rate [1]
_PATIENCE = 8  # steps without a better error after which rounding is reached


class Found(NamedTuple):
    """What Newton's method came to."""

    x: Floats  # (3, n) [m]
    tension: Floats  # (s,) [N]
    error: float  # largest residual, in the model's units [1]
    allowed: float  # error that counts as at rest [1]
    steps: int

    @property
    def at_rest(self) -> bool:
        """Whether the equations are solved."""
        return self.error <= self.allowed


def settle(balance: Balance, x: Floats, tension: Floats, inertia: float = 0.0) -> Found:
    """Return the rest shape that is reached from places `x` (3, n) and tensions (s,).

    Args:
        balance: the equations.
        x: places to begin with [m].
        tension: tensions to begin with [N].
        inertia: lambda to begin with, in units of the model's rate [1]; 0 is plain Newton.

    The result is the best that was seen; look at `at_rest`.
    """
    least = _LEAST * balance.rate
    tension = np.where(balance.live, tension, 0.0)
    inertia = max(inertia * balance.rate, least)
    best = _found(balance, x, tension, balance.error(x, tension), 0)
    if best.error <= _EXACT * best.allowed:
        return best
    error, tired = best.error, 0
    for count in range(1, STEPS + 1):
        dx, pull, pivot = balance.step(x, tension, inertia, error < _NEAR)
        turn = largest_turn(balance, x, dx) if pivot > 0.0 else np.inf
        if not turn <= 2.0 * _TURN:  # NaN goes this way, too
            if inertia > 1e12 * balance.rate:
                break
            inertia = max(4.0 * inertia, 1e-6 * balance.rate)
            continue
        x, tension = x + dx, pull
        before, error = error, balance.error(x, tension)
        if error < best.error:
            tired = 0 if error < 0.5 * best.error else tired + 1
            best = _found(balance, x, tension, error, count)
        else:
            tired += 1
        if error == 0.0 or (best.at_rest and tired >= 2):
            break
        if tired >= _PATIENCE * 5:  # going round in circles: smaller steps
            inertia, tired = max(100.0 * inertia, 1e-3 * balance.rate), 0
        elif error < before or turn < 0.2 * _TURN:
            inertia = max(inertia * (0.1 if turn < 0.5 * _TURN else 0.5), least)
    return best


def _found(balance: Balance, x: Floats, tension: Floats, error: float, steps: int) -> Found:
    return Found(x, tension, error, balance.allowed(x, tension), steps)


def largest_turn(balance: Balance, x: Floats, dx: Floats) -> float:
    """Return the largest sideways motion of a segment over its length [1], or of a node at all."""
    t, r = balance.directions(x)
    d = np.diff(dx, axis=1)
    along = (d * t).sum(axis=0)
    sideways = np.sqrt(((d - along * t) ** 2).sum(axis=0))
    size = np.maximum(np.maximum(r, balance.rest), 1e-9 * balance.length)
    return float(np.where(balance.live, sideways / size, 0.0).max(initial=0.0))
