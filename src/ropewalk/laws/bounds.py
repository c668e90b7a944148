"""The stretch limiter inside a stage of an implicit method: bounds that no segment leaves.

A segment of stretch s = r - L within [a, b] pulls with T = k s, or as its elastic law has it, T = f(s); at a
bound its tension is an unknown that may be any beyond: T >= f(b) at s = b, T <= f(a) at s = a. Of the two
conditions
    s - b <= 0,   T - f(s) >= 0,   one of them an equation
that of the length holds where e' (T - f(b)) + s - b > 0, e' the inertial compliance: on the far side of the
line through the curve's corner that weighs both alike (a semismooth Newton method: Qi & Sun 1993); the same
with other signs at a. What the tension is beyond f(s) is the limiter's force. In a stage f is that of a law
whose memory follows the stage, d = d^ + c d'. Rigid links have no s, and nothing to bound.

What comes to a bound with speed is stopped there by an impulse, which is no force that lasts: a step in
which such an impact takes much is taken by implicit Euler, and the next, as where contacts close.
"""

from __future__ import annotations

import math

from ropewalk.core.jit import kernel, part, small
from ropewalk.laws.elastic import pull_of
from ropewalk.laws.ledger import energy_past_anchors
from ropewalk.laws.rare import limits

IMPACT = 0.01  # [1] of the kinetic energy: what is carried on of a lesser impulse moves little
TURNED = (
    2.0  # [1] times step and square of the rate across: half of it a step of implicit Euler leaves
)
SLACK = 1e-9  # [1] a tension-only link shorter by this part is slack
STILL = 1e-9  # [1/s] a rate of strain that rounding may leave of what hangs still in its bound


@small
def own_pull(elastic, stiffness, length, floor, work, j, s):
    """Return what segment `j` pulls with by itself at a stretch of `s` in a stage [N]."""
    if elastic.time.shape[0] == 0 or elastic.of[j] < 0:
        pull = s / work.soft[j]
    else:
        known, c = 0.0, 0.0
        if work.start.shape[0] > 0:
            known, c = work.start[j], work.follow[j]
        share, _, _ = pull_of(elastic, j, s / length[j], known, c)
        pull = stiffness[j] * length[j] * share
    return max(pull, floor[j])


@small
def true_stretch(length, work, j):
    """Return r - L of segment `j` [m]: `work.stretch` is without the free strain of one that remembers."""
    s = work.stretch[j]
    if work.free.shape[0] > 0:
        s += length[j] * work.free[j]
    return s


@small
def within(limiter, strain):
    """Return a strain within the bounds [1]."""
    return min(max(strain, limiter.shortest - 1.0), limiter.longest - 1.0)


@kernel
def bound_segments(limiter, elastic, stiffness, tension, weights, length, floor, work, saddle):
    """Decide which segments are at a bound, and write their equations s - b = 0 over those of springs."""
    carries, e, g = saddle.carries, saddle.compliance, saddle.misfit
    for j in range(tension.shape[0]):
        held = weights[j] + weights[j + 1] == 0.0
        if work.over[j] == 0.0 or held or stiffness[j] == math.inf:
            continue
        s, slack = true_stretch(length, work, j), 1.0 / work.weight[j]
        low, high = (limiter.shortest - 1.0) * length[j], (limiter.longest - 1.0) * length[j]
        upper = own_pull(elastic, stiffness, length, floor, work, j, high)
        lower = own_pull(elastic, stiffness, length, floor, work, j, low)
        if slack * (tension[j] - upper) + s - high > 0.0:
            carries[j], e[j], g[j] = 1.0, 0.0, s - high
        elif slack * (tension[j] - lower) + s - low < 0.0:
            carries[j], e[j], g[j] = 1.0, 0.0, s - low


@kernel
def split_tension(laws, stiffness, tension, length, floor, work, saddle, elastic, limiter):
    """Give what segments at a bound pull beyond their own to the limiter's channel, both (3, n + 1) [N]."""
    for j in range(tension.shape[0]):
        extra, rigid = 0.0, stiffness[j] == math.inf
        if saddle.carries[j] != 0.0 and saddle.compliance[j] == 0.0 and not rigid:
            s = true_stretch(length, work, j)
            extra = tension[j] - own_pull(laws, stiffness, length, floor, work, j, s)
        for k in range(3):
            force = extra * saddle.direction[k, j]
            limiter[k, j + 1] = force
            elastic[k, j + 1] -= force


@part
def is_stopped(system, state, forces, dt):
    """Tell whether bounds, or strings that get taut, take a good part of the kinetic energy in a step of
    `dt` [s], an impact.

    `forces` are means of the step, whose begin `state` is.
    """
    x, v, before = state.x, state.v, state.forces
    stiffness, floor, length = state.stiffness, system.slack_floor, state.rest_length
    taken = tightening_energy(stiffness, floor, length, x, v, before.elastic, forces.elastic, dt)
    if limits(system):
        lasting = 0.0 if state.jolt[0] > 0.0 else 1.0  # what an impact's last step left is none
        taken += stopped_energy(before.limiter, forces.limiter, lasting, x, v, dt)
    return taken > 0.0 and taken > IMPACT * energy_past_anchors(
        state.v, state.mass, state.inverse_mass
    )


@small
def run_in(before, after, x, v, j):
    """Return how segment `j` meets what stops it, all times its length: its pull after a step and before [N],
    its rate of length [m/s]; and its length's square [m^2].

    `before` and `after`, (3, n + 1), are what stops it as the step begins and in it; `x` and `v` (3, n) are
    those it begins with.
    """
    pull, held, rate, square = 0.0, 0.0, 0.0, 0.0
    for k in range(3):
        d = x[k, j + 1] - x[k, j]
        pull += d * after[k, j + 1]
        held += d * before[k, j + 1]
        rate += d * (v[k, j + 1] - v[k, j])
        square += d * d
    return pull, held, rate, square


@small
def plastic_loss(before, after, lasting, x, v, j, dt):
    """Return the kinetic energy that what stops segment `j` takes from it in a step [J].

    A plastic impact of impulses p, which brings the rates of length s' to zero, takes sum p s' / 2 (Carnot):
    in its p is all that hangs on a segment, by joints or by others at bounds. Of the forces as a step begins
    a share `lasting` goes on. See `run_in`.
    """
    pull, held, rate, square = run_in(before, after, x, v, j)
    more = pull - lasting * held
    if pull * rate > 0.0 and more * rate > 0.0 and abs(rate) > STILL * square:
        return 0.5 * dt * more * rate / square
    return 0.0


@kernel
def stopped_energy(before, after, lasting, x, v, dt):
    """Return the kinetic energy that bounds take from segments which run into them in a step [J].

    `before` and `after` are the limiter's forces, as in `plastic_loss`.
    """
    total = 0.0
    for j in range(v.shape[1] - 1):
        total += plastic_loss(before, after, lasting, x, v, j, dt)
    return total


@small
def tightening(stiffness, floor, length, x, v, after, j, dt):
    """Return how segment `j`, where it is a string that gets taut in a step of `dt` [s], goes there: what it
    pulls with, its rate of length and its square as `run_in` has them; nothing of others.

    A string is a rigid link that only pulls. It gets taut that grows longer as the step begins, and is slack,
    or does so faster than a step leaves it that turns. `after` are the elastic forces in it, (3, n + 1).
    """
    if stiffness[j] == math.inf and floor[j] == 0.0:
        pull, _, rate, square = run_in(after, after, x, v, j)
        taut = (1.0 - SLACK) * length[j]
        if pull > 0.0 and rate > STILL * square:
            across = -rate * rate / square
            for k in range(3):
                across += (v[k, j + 1] - v[k, j]) ** 2
            if square < taut * taut or rate > TURNED * dt * across:
                return pull, rate, square
    return 0.0, 0.0, 1.0


@kernel
def tightening_energy(stiffness, floor, length, x, v, before, after, dt):
    """Return the kinetic energy that strings take as they get taut in a step [J]; see `plastic_loss`."""
    total = 0.0
    for j in range(stiffness.shape[0]):
        _, rate, _ = tightening(stiffness, floor, length, x, v, after, j, dt)
        if rate > 0.0:
            total += plastic_loss(before, after, 1.0, x, v, j, dt)
    return total


@part
def book_tightening(system, state, elastic, end, dt):
    """Book what strings do in a step in which one gets taut as friction [J]: it is lost, and none is stored.

    One by one they give and take what goes through them. `elastic` (3, n + 1) is the mean force, `end` (3, n)
    the velocities that the step ends with; `state` is that of its beginning.
    """
    stiffness, floor, length = state.stiffness, system.slack_floor, state.rest_length
    if gets_taut(stiffness, floor, length, state.x, state.v, elastic, dt):
        work = state.work
        move_works(stiffness, floor, elastic, state.v, end, dt, work.elastic, work.friction)


@kernel
def gets_taut(stiffness, floor, length, x, v, after, dt):
    """Tell whether any string gets taut in a step, see `tightening`."""
    count = 0
    for j in range(stiffness.shape[0]):
        _, rate, _ = tightening(stiffness, floor, length, x, v, after, j, dt)
        count += 1 if rate > 0.0 else 0
    return count > 0


@kernel
def move_works(stiffness, floor, elastic, begin, end, dt, stored, lost):
    """Move the works of all strings in a step from `stored` to `lost`, both (s,) [J].

    `begin` and `end` (3, n) are the velocities at its ends.
    """
    for j in range(stiffness.shape[0]):
        if stiffness[j] == math.inf and floor[j] == 0.0:
            done = 0.0
            for k in range(3):
                here, there = begin[k, j] + end[k, j], begin[k, j + 1] + end[k, j + 1]
                done -= 0.5 * dt * elastic[k, j + 1] * (there - here)
            lost[j] += done
            stored[j] -= done


@kernel
def time_to_bounds(limiter, before, after, rest_length, x, v):
    """Return when the first of the segments that come to a bound in a step gets there [s], at the rate that
    it begins with, inf for none, and the largest rate of all that are at one at its end [m/s].

    `before` and `after`, (3, n + 1), are the limiter's forces as the step begins and in it: not zero at a
    bound. Those that are at theirs already come to none: rounding leaves them a rate.
    """
    first, fastest = math.inf, 0.0
    for j in range(rest_length.shape[0]):
        pull, held, rate, square = run_in(before, after, x, v, j)
        if square == 0.0 or pull * rate <= 0.0:
            continue
        r = math.sqrt(square)
        fastest = max(fastest, abs(rate) / r)
        if pull * held <= 0.0:
            bound = (limiter.longest if pull > 0.0 else limiter.shortest) * rest_length[j]
            first = min(first, max((bound - r) * r / rate, 0.0))
    return first, fastest


@kernel
def time_to_taut(stiffness, floor, length, x, v, after, dt):
    """Return the same for strings that get taut in a step of `dt` [s]; `after` are the elastic forces."""
    first, fastest = math.inf, 0.0
    for j in range(stiffness.shape[0]):
        _, rate, square = tightening(stiffness, floor, length, x, v, after, j, dt)
        if rate > 0.0:
            r = math.sqrt(square)
            fastest = max(fastest, rate / r)
            first = min(first, max((length[j] - r) * r / rate, 0.0))
    return first, fastest
