"""Intervals by profile likelihood: how far a value can go while all others are fitted anew.

Source: Raue et al., Bioinformatics 25 (2009) 1923. In a linear problem they are those of the covariance.
"""

from __future__ import annotations

import math
from collections.abc import Callable

import numpy as np

from ropewalk.core.arrays import Floats
from ropewalk.sweeps.identify import Findings

_TRIES = 8
_CLOSE = 0.02  # of the threshold

Function = Callable[[Floats], Floats]


def profile_intervals(
    residuals: Function, jacobian: Function, share: Floats, findings: Findings
) -> list[tuple[float, float]]:
    """Return the interval of every value, as shares of the ranges.

    It ends where the sum of squares has risen by the quantile squared, times the variance that the fit
    leaves when the errors are not known; or at the end of the range.
    """
    best = residuals(share)
    least = float(best @ best)
    if findings.variance == 0.0:
        return [(float(s), float(s)) for s in share]
    ends = []
    for place in range(len(share)):
        low, high = (
            _end(residuals, jacobian, share, place, sign, least, findings) for sign in (-1.0, 1.0)
        )
        ends.append((low, high))
    return ends


def _end(
    residuals: Function,
    jacobian: Function,
    share: Floats,
    place: int,
    sign: float,
    least: float,
    findings: Findings,
) -> float:
    """Return where the profile passes the threshold in one direction."""
    rise = findings.quantile**2 * findings.variance
    room = 1.0 - share[place] if sign > 0 else share[place]
    if room <= 0.0:
        return float(share[place])
    guess = min(room, findings.quantile * float(findings.deviation[place]))
    if not guess > 0.0:
        return float(share[place])
    # The root of sqrt(rise) - what is wanted: in a linear problem a straight line.
    wanted = math.sqrt(rise)
    near, far, step, start = 0.0, math.inf, guess, share
    for _ in range(_TRIES):
        start, cost = _refit(residuals, jacobian, start, place, float(share[place] + sign * step))
        height = math.sqrt(max(cost - least, 0.0))
        if abs(height - wanted) <= _CLOSE * wanted:
            break
        if height < wanted:
            near = step
            if step >= room:
                return float(share[place] + sign * room)
        else:
            far = step
        ahead = step * wanted / height if height > 0.0 else 2.0 * step
        low, high = near + 0.05 * (min(far, room) - near), min(far, 4.0 * step, room)
        step = min(max(ahead, low), high)
    return float(share[place] + sign * min(step, room))


def _refit(
    residuals: Function, jacobian: Function, start: Floats, place: int, value: float
) -> tuple[Floats, float]:
    """Return the best values with one of them held, and their sum of squares."""
    from scipy.optimize import least_squares

    others = [i for i in range(len(start)) if i != place]
    whole = start.copy()
    whole[place] = value

    def full(part: Floats) -> Floats:
        made = whole.copy()
        made[others] = part
        return made

    if not others:
        found = residuals(whole)
        return whole, float(found @ found)
    fit = least_squares(
        lambda part: residuals(full(part)),
        np.clip(start[others], 1e-9, 1.0 - 1e-9),
        lambda part: jacobian(full(part))[:, others],
        bounds=(0.0, 1.0),
        xtol=1e-8,
        max_nfev=20,
    )
    return full(fit.x), 2.0 * float(fit.cost)
