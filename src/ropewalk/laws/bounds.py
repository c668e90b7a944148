"""The stretch limiter inside a stage of an implicit method: bounds that no segment leaves.

A segment of stretch s = r - L within [a, b] pulls with T = k s; at a bound its tension is an unknown that
may be any beyond: T >= k b at s = b, T <= k a at s = a. Of the two conditions
    s - b <= 0,   T - k s >= 0,   one of them an equation
that of the length holds where e' (T - k b) + s - b > 0, e' the inertial compliance: on the far side of the
line through the curve's corner that weighs both alike (a semismooth Newton method: Qi & Sun 1993); the same
with other signs at a. What the tension is beyond k s is the limiter's force.
"""

from __future__ import annotations

from ropewalk.core.jit import kernel


@kernel
def bound_segments(limiter, tension, inverse_mass, length, floor, work, saddle):
    """Decide which segments are at a bound, and write their equations s - b = 0 over those of springs."""
    carries, e, g = saddle.carries, saddle.compliance, saddle.misfit
    for j in range(tension.shape[0]):
        if work.over[j] == 0.0 or inverse_mass[j] + inverse_mass[j + 1] == 0.0:
            continue
        s, k, slack = work.stretch[j], 1.0 / work.soft[j], 1.0 / work.weight[j]
        low, high = (limiter.shortest - 1.0) * length[j], (limiter.longest - 1.0) * length[j]
        if slack * (tension[j] - max(k * high, floor[j])) + s - high > 0.0:
            carries[j], e[j], g[j] = 1.0, 0.0, s - high
        elif slack * (tension[j] - max(k * low, floor[j])) + s - low < 0.0:
            carries[j], e[j], g[j] = 1.0, 0.0, s - low


@kernel
def split_tension(tension, floor, work, saddle, elastic, limiter):
    """Give what segments at a bound pull beyond k s to the limiter's channel, both (3, n + 1) [N]."""
    for j in range(tension.shape[0]):
        extra = 0.0
        if saddle.carries[j] != 0.0 and saddle.compliance[j] == 0.0:
            extra = tension[j] - max(work.stretch[j] / work.soft[j], floor[j])
        for k in range(3):
            force = extra * saddle.direction[k, j]
            limiter[k, j + 1] = force
            elastic[k, j + 1] -= force
