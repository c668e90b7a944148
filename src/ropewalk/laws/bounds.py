"""The stretch limiter inside a stage of an implicit method: bounds that no segment leaves.

A segment of stretch s = r - L within [a, b] pulls with T = k s; at a bound its tension is an unknown that
may be any beyond: T >= k b at s = b, T <= k a at s = a. Of the two conditions
    s - b <= 0,   T - k s >= 0,   one of them an equation
that of the length holds where e' (T - k b) + s - b > 0, e' the inertial compliance: on the far side of the
line through the curve's corner that weighs both alike (a semismooth Newton method: Qi & Sun 1993); the same
with other signs at a. What the tension is beyond k s is the limiter's force.

What comes to a bound with speed is stopped there by an impulse, which is no force that lasts: a step in
which such an impact takes much is taken by implicit Euler, and the next, as where contacts close.
"""

from __future__ import annotations

from ropewalk.core.jit import kernel, part, small
from ropewalk.laws.ledger import kinetic_energy
from ropewalk.laws.rare import limits

KEPT = 1e-3  # [1] of the force now: BDF2's mean goes on long after a bound was left
IMPACT = 0.01  # [1] of the kinetic energy: what is carried on of a lesser impulse moves little


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


@part
def is_stopped(system, state, forces, x):
    """Tell whether bounds that are met in a step take a good part of its kinetic energy, an impact.

    `forces` are means of the step, for one may be thrown back within it, `x` (3, n) the places at its end;
    `state` is its begin.
    """
    if not limits(system):
        return False
    before, after = state.forces.limiter, forces.limiter
    taken = stopped_energy(before, after, state.v, x, state.mass, state.inverse_mass)
    return taken > 0.0 and taken > IMPACT * kinetic_energy(state.v, state.mass)


@kernel
def stopped_energy(before, after, v, x, mass, inverse_mass):
    """Return the kinetic energy along the segments that come to a bound in a step [J].

    Each joins what hangs on both its ends by segments that are at bounds, too. `before` and `after` are the
    limiter's forces at the step's begin and in it, (3, n + 1): zero away from the bounds; `v` the velocities
    that it begins with and `x` the places at its end, (3, n).
    """
    total, s = 0.0, mass.shape[0] - 1
    for j in range(s):
        if pull_of(before, j) >= KEPT * pull_of(after, j):  # zero, too, and none
            continue
        along, square = 0.0, 0.0
        for k in range(3):
            along += (x[k, j + 1] - x[k, j]) * (v[k, j + 1] - v[k, j])
            square += (x[k, j + 1] - x[k, j]) ** 2
        low, high = j, j + 1
        below, above = inverse_mass[low], inverse_mass[high]
        while low > 0 and below > 0.0 and pull_of(after, low - 1) > 0.0:
            low -= 1
            below = 1.0 / (1.0 / below + mass[low]) if inverse_mass[low] > 0.0 else 0.0
        while high < s and above > 0.0 and pull_of(after, high) > 0.0:
            high += 1
            above = 1.0 / (1.0 / above + mass[high]) if inverse_mass[high] > 0.0 else 0.0
        if square > 0.0 and below + above > 0.0:
            total += 0.5 * along * along / (square * (below + above))
    return total


@small
def pull_of(limiter, j):
    """Return the size of the limiter's force in segment `j`, zero away from the bounds [N]."""
    return abs(limiter[0, j + 1]) + abs(limiter[1, j + 1]) + abs(limiter[2, j + 1])
