"""Newton's method with a line search, for equations of rest that have kinks: contacts that open, stick, slip.

The merit is what is wrong, in units of energy: with the stiffness k of contacts at the nodes,

    sum |F_i|^2 / k_i + k g_j^2      [J]

F the forces that are left and g by how much segments are too long. Where no part of a step brings it down a
part is taken whatever the merit, out of its local minima.
"""

from __future__ import annotations

import numpy as np

from ropewalk.core.arrays import Floats
from ropewalk.statics.balance import Balance
from ropewalk.statics.newton import Found, largest_turn

_TURN = 0.5  # largest turn of a segment in one step [rad]
_NEAR = 1e-4  # error below which the equations are taken as they are, compression and all [1]
_LEAST = 1e-13  # least inertia, in units of the model's own rate [1]
_DESCENT = 1e-4  # share of the promised descent that counts [1]
_HALVINGS = 6
_LEAP = (0.3, 1.0, 1.0)  # parts that are taken whatever the merit, in turn [1]
POLISH = 3  # steps after the first that counts as rest, down to rounding


def search(
    balance: Balance,
    x: Floats,
    tension: Floats,
    most: int,
    most_leaps: float = np.inf,
    polish: int = POLISH,
) -> Found:
    """Return what Newton's method comes to in `most` steps from places (3, n) [m] and tensions (s,) [N].

    It ends sooner where it has taken `most_leaps` steps that did not bring the merit down. After the first
    step that counts as rest it takes `polish` more.
    """
    tension = np.where(balance.live, tension, 0.0)
    least = inertia = _LEAST * balance.rate
    judge = _Judge(balance)
    merit, error = judge(x, tension)
    best = Found(x, tension, error, balance.allowed(x, tension), 0)
    leaps, polished, count = 0, 0, 0
    for count in range(1, most + 1):
        if best.at_rest:
            polished += 1
            if error == 0.0 or polished > polish:
                break
        dx, pull, pivot = balance.step(x, tension, inertia, error < _NEAR)
        turn = largest_turn(balance, x, dx) if pivot > 0.0 else np.inf
        if not np.isfinite(turn):
            inertia = max(10.0 * inertia, 1e-6 * balance.rate)
            continue
        inertia = max(0.1 * inertia, least)
        whole = min(1.0, _TURN / max(turn, 1e-300))
        part = whole
        for _ in range(_HALVINGS + 1):
            trial, error = judge(x + part * dx, tension + part * (pull - tension))
            if trial < (1.0 - _DESCENT * part) * merit:
                break
            part *= 0.5
        else:
            if leaps >= most_leaps:
                break
            part, leaps = whole * _LEAP[leaps % len(_LEAP)], leaps + 1
            trial, error = judge(x + part * dx, tension + part * (pull - tension))
        x, tension, merit = x + part * dx, tension + part * (pull - tension), trial
        if error < best.error:
            best = Found(x, tension, error, balance.allowed(x, tension), count)
    return best._replace(steps=count)


class _Judge:
    """What is wrong with places and tensions."""

    def __init__(self, balance: Balance) -> None:
        self.balance = balance
        stiff = balance.stiffness()
        self.yields = np.where(balance.free, 1.0 / stiff, 0.0)
        self.stiff = float(np.median(stiff))

    def __call__(self, x: Floats, tension: Floats) -> tuple[float, float]:
        """Return the merit [J] and the error as `Balance.error` [1]."""
        balance = self.balance
        left, gap = balance.imbalance(x, tension), balance.gap(x, tension)
        merit = ((left * left).sum(axis=0) * self.yields).sum() + self.stiff * (gap * gap).sum()
        return float(merit), balance.worst(left, gap)
