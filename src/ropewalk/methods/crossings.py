"""Events inside a step: nodes on which a law begins or ceases to act, segments that go taut or slack.

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
from ropewalk.laws.events import end_of_crossing
from ropewalk.laws.nodes import mark_nodes, node_crossings
from ropewalk.laws.rare import parts
from ropewalk.laws.stretch_tangent import mark_rubbing


@part
def mark_sides(system, state, band):
    """Mark what rubs and what the laws of nodes act on at the state itself, for a step with frozen marks."""
    if system.flags[TENSION_ONLY] == 1:
        mark_rubbing(state.x, state.rest_length, system.slack_floor, band.rubs)
    else:
        for j in range(band.rubs.shape[0]):
            band.rubs[j] = 1.0
    mark_nodes(system, state.x, band)


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


@kernel
def load_crossings(x0, v0, x1, v1, states, of, strength, dt, tolerance):
    """Return where the step is to end for the first segment at its breaking load [s], and how many are.

    `states` are rest lengths, stiffness, and vector and axial friction, (s,) each. Gaps are what is left to
    the load, as a length by the stiffness. Of rigid links none is known, nor of segments with a curve `of`
    (s,) the scene's: they part at the end of a step.
    """
    lengths, stiffness, vector, axial = states
    end, changes = math.inf, 0
    for j in range(lengths.shape[0]):
        k = stiffness[j]
        if of[j] >= 0 or not (strength[j] < math.inf and 0.0 < k < math.inf):
            continue
        rubs = (vector[j] + axial[j]) / k
        before, rate0 = gap_of(x0, v0, j, lengths[j])
        after, rate1 = gap_of(x1, v1, j, lengths[j])
        left0 = strength[j] / k - before - rubs * rate0
        left1 = strength[j] / k - after - rubs * rate1
        if left0 > 0.0 > left1:
            rate = (left1 - left0) / dt
            changes += 1
            end = min(end, end_of_crossing(left0, rate, left1, rate, dt, tolerance))
    return end, changes


@part
def crossings(system, before, after, dt, tolerance):
    """Return where a step from state `before` to `after` is to end for its first event [s], inf: where it
    does, and how many nodes and segments have changed sides."""
    end, changes = node_crossings(system, before, after, dt, tolerance)
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
    if parts(system):
        lengths, k = after.rest_length, after.stiffness
        states, strength = (
            (lengths, k, after.damping_vector, after.damping_axial),
            system.node.parting.strength,
        )
        other, more = load_crossings(
            before.x, before.v, after.x, after.v, states, system.elastic.of, strength, dt, tolerance
        )
        end, changes = min(end, other), changes + more
    return end, changes
