"""Intervals by profile likelihood: how far a value can go while all others are fitted anew.

Source: Raue et al., Bioinformatics 25 (2009) 1923. In a linear problem they are those of the covariance.
"""

from __future__ import annotations

import math
from collections.abc import Callable

import numpy as np

from ropewalk.core.arrays import Floats
from ropewalk.sweeps.identify import Findings

_TRIES = 12
_CLOSE = 0.02  # of the threshold, or of the way there

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
    near, far, step = 0.0, math.inf, guess
    for _ in range(_TRIES):
        # From the fit itself: what one refit leaves on a bound would stay there in the next.
        value = float(share[place] + sign * step)
        cost = _refit(residuals, jacobian, share, place, value, wanted)
        height = math.sqrt(max(cost - least, 0.0))
        if abs(height - wanted) <= _CLOSE * wanted:
            break
        if height < wanted:
            near = step
            if step >= room:
                return float(share[place] + sign * room)
        else:
            far = step
        if near >= (1.0 - _CLOSE) * far:  # as at a kink, where another value meets its bound
            step = far
            break
        ahead = step * wanted / height if height > 0.0 else 2.0 * step
        low, high = near + 0.05 * (min(far, room) - near), min(far, 4.0 * step, room)
        if near > 0.0 and not near < ahead < far:
            ahead = 0.5 * (near + far)  # infinite where nothing is known to be beyond
        step = min(max(ahead, low), high)
    else:
        step = far  # not met in time: what is surely beyond it
    return float(share[place] + sign * min(step, room))


def _refit(
    residuals: Function, jacobian: Function, start: Floats, place: int, value: float, size: float
) -> float:
    """Return the least sum of squares with one of the values held; `size` is one that tells, for gtol."""
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
        return float(found @ found)
    fit = least_squares(
        lambda part: residuals(full(part)) / size,
        np.clip(start[others], 1e-9, 1.0 - 1e-9),
        lambda part: jacobian(full(part))[:, others] / size,
        bounds=(0.0, 1.0),
        xtol=1e-8,
        max_nfev=20,
    )
    return 2.0 * float(fit.cost) * size**2
