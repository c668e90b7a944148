"""Events inside a step: nodes that touch or leave the ground, segments that go taut or slack.

A step keeps the friction of the side on which it begins (`Band.frozen`), so that it stays smooth. When a
node or a segment has changed sides at its end, the moment t* of the change is estimated from both ends, the
earlier of
    gap(0) + gap'(0) t = 0          approach at the speed it had
    the chord from gap(0) to gap(h)
and the step is to end where what is beyond the event moves by half the tolerance, at
t* + tolerance / (2 |gap'|).
Source: Hairer, Norsett & Wanner, Solving Ordinary Differential Equations I, II.6 (discontinuous equations).
"""

from __future__ import annotations

import math

from ropewalk.core.arrays import TENSION_ONLY
from ropewalk.core.jit import kernel, part, small
from ropewalk.laws.ground import mark_touching
from ropewalk.laws.stretch_tangent import mark_rubbing


@part
def mark_sides(system, state, band):
    """Mark what rubs and what touches at the state itself, for a step with frozen marks."""
    if system.flags[TENSION_ONLY] == 1:
        mark_rubbing(state.x, state.rest_length, system.slack_floor, band.rubs)
    else:
        for j in range(band.rubs.shape[0]):
            band.rubs[j] = 1.0
    if system.ground.active == 1:
        mark_touching(state.x, system.ground, band.touches)


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


@kernel
def ground_crossings(x0, v0, x1, v1, inverse_mass, ground, dt, tolerance):
    """Return where the step is to end for the ground [s], inf: where it does, and the changes of sides."""
    ux, uy, uz = ground.up[0], ground.up[1], ground.up[2]
    end, changes = math.inf, 0
    for i in range(inverse_mass.shape[0]):
        before = ground.height - (x0[0, i] * ux + x0[1, i] * uy + x0[2, i] * uz)
        after = ground.height - (x1[0, i] * ux + x1[1, i] * uy + x1[2, i] * uz)
        if inverse_mass[i] == 0.0 or (before > 0.0) == (after > 0.0):
            continue
        changes += 1
        rate0 = -(v0[0, i] * ux + v0[1, i] * uy + v0[2, i] * uz)
        rate1 = -(v1[0, i] * ux + v1[1, i] * uy + v1[2, i] * uz)
        end = min(end, end_of_crossing(before, rate0, after, rate1, dt, tolerance))
    return end, changes


@small
def gap_of(x, v, j, length):
    """Return r - L [m] of segment `j` and its rate [m/s]."""
    dx, dy, dz = x[0, j + 1] - x[0, j], x[1, j + 1] - x[1, j], x[2, j + 1] - x[2, j]
    ux, uy, uz = v[0, j + 1] - v[0, j], v[1, j + 1] - v[1, j], v[2, j + 1] - v[2, j]
    r = math.sqrt(dx * dx + dy * dy + dz * dz)
    rate = (dx * ux + dy * uy + dz * uz) / r if r > 0.0 else 0.0
    return r - length, rate


@kernel
def slack_crossings(x0, v0, x1, v1, rest_length, floor, dt, tolerance):
    """Return where the step is to end for tension-only segments [s], and the changes of sides."""
    end, changes = math.inf, 0
    for j in range(floor.shape[0]):
        if floor[j] != 0.0 or rest_length[j] == 0.0:
            continue
        before, rate0 = gap_of(x0, v0, j, rest_length[j])
        after, rate1 = gap_of(x1, v1, j, rest_length[j])
        if (before >= 0.0) == (after >= 0.0):
            continue
        changes += 1
        end = min(end, end_of_crossing(before, rate0, after, rate1, dt, tolerance))
    return end, changes


@part
def crossings(system, before, after, dt, tolerance):
    """Return where a step from state `before` to `after` is to end for its first event [s], inf: where it
    does, and how many nodes and segments have changed sides."""
    end, changes = math.inf, 0
    if system.ground.active == 1:
        end, changes = ground_crossings(
            before.x, before.v, after.x, after.v, after.inverse_mass, system.ground, dt, tolerance
        )
    if system.flags[TENSION_ONLY] == 1:
        other, more = slack_crossings(
            before.x,
            before.v,
            after.x,
            after.v,
            after.rest_length,
            system.slack_floor,
            dt,
            tolerance,
        )
        end, changes = min(end, other), changes + more
    return end, changes
