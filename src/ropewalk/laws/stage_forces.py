"""Forces inside a stage of an implicit method, where the segments' tensions are unknowns of their own.

A segment pulls with its tension T, whatever its length; that T fits the length is an equation of its own,
    g = r - L - T/k = 0,      tension-only: min(T e', T/k - (r - L)) = 0 with any e' > 0,
(of an elastic law T/k stands for the stretch under T, and its derivative for 1/k in the equations to solve),
the second a complementarity (Qi & Sun 1993): either the segment is slack and T = 0, or it is taut.
What begins and ends abruptly (friction of slack segments, a contact) acts where it is marked.
"""

from __future__ import annotations

import math

from ropewalk.core.arrays import TENSION_ONLY
from ropewalk.core.jit import kernel, part
from ropewalk.laws.bounds import bound_segments, split_tension
from ropewalk.laws.elastic import hold_secants, hold_tangents
from ropewalk.laws.nodes import mark_nodes, marked_node_forces
from ropewalk.laws.rare import has_bending, has_elastic_laws, limits
from ropewalk.laws.stretch import drop_marked_friction
from ropewalk.laws.table import evaluate_bending, rub_segments


@kernel
def pull(x, tension, rest_length, alive, direction, stretch, over, elastic):
    """Write directions (3, s), r - L and 1 / r (s,) and the forces (3, n + 1) at `tension` [N].

    `alive` is 0 for segments between ropes, whose direction and `stretch` are then 0.
    """
    x0, x1, x2 = x[0], x[1], x[2]
    e0, e1, e2 = elastic[0], elastic[1], elastic[2]
    d0, d1, d2 = direction[0], direction[1], direction[2]
    for j in range(tension.shape[0]):
        dx, dy, dz = x0[j + 1] - x0[j], x1[j + 1] - x1[j], x2[j + 1] - x2[j]
        r = math.sqrt(dx * dx + dy * dy + dz * dz)
        over[j] = alive[j] / r if r > 0.0 else 0.0
        tx, ty, tz = over[j] * dx, over[j] * dy, over[j] * dz
        d0[j], d1[j], d2[j] = tx, ty, tz
        stretch[j] = alive[j] * (r - rest_length[j])
        e0[j + 1], e1[j + 1], e2[j + 1] = tension[j] * tx, tension[j] * ty, tension[j] * tz


@kernel
def decide(stretch, tension, over, soft, weight, floor, least, carries, compliance, misfit):
    """Decide which segments carry and write g [m] of those that may not.

    `soft` is 1/k, `weight` the inertial stiffness whose inverse is e' [N/m]. A segment without direction
    (its ends coincide) or between ropes carries nothing. `least` is that of e' - 1/k: with 0, where inertia
    is the stiffer, as in short steps, the length alone decides. Else a tension that is a little off lets go
    of what is taut; springs, whose equation is straight, come back at once, laws may not.
    """
    for j in range(tension.shape[0]):
        slack = 1.0 / weight[j]
        on = over[j] > 0.0
        if floor[j] == 0.0:
            on = on and max(slack - soft[j], least) * tension[j] + stretch[j] > 0.0
        carries[j] = 1.0 if on else 0.0
        compliance[j] = soft[j] if on else slack
        misfit[j] = carries[j] * stretch[j] - compliance[j] * tension[j]


@part
def evaluate_stage(system, state, x, v, tension, work, saddle, forces, known):
    """Write the forces of all laws at `x`, `v` and `tension`, for what is marked in the band.

    With `known` those of nodes are there already.
    """
    over, stretch = work.over, work.stretch
    pull(x, tension, state.rest_length, work.alive, saddle.direction, stretch, over, forces.elastic)
    floor, carries, e, g = system.slack_floor, saddle.carries, saddle.compliance, saddle.misfit
    lengths, k = state.rest_length, state.stiffness
    if has_elastic_laws(system):
        hold_secants(tension, lengths, k, system.elastic, work)
        decide(stretch, tension, over, work.soft, work.weight, floor, 0.0, carries, e, g)
        hold_tangents(k, system.elastic, work, carries, e)
    else:
        decide(stretch, tension, over, work.soft, work.weight, floor, -math.inf, carries, e, g)
    if limits(system):
        weights, laws, bounds = state.inverse_mass, system.elastic, system.limiter
        bound_segments(bounds, laws, k, tension, weights, lengths, floor, work, saddle)
        springs, pulls = forces.elastic, forces.limiter
        split_tension(laws, k, tension, lengths, floor, work, saddle, springs, pulls)
    rub_segments(system, state, x, v, forces)
    if system.flags[TENSION_ONLY] == 1:
        drop_marked_friction(saddle.band.rubs, forces.friction)
    if has_bending(system):
        evaluate_bending(system, state, x, v, forces)
    if not known:
        marked_node_forces(system, state, x, v, saddle.band, forces)


@part
def mark_stage(system, x, work, saddle):
    """Mark what rubs, and what laws of nodes act on, at the iterate; return how many marks changed."""
    changed = 0.0
    if system.flags[TENSION_ONLY] == 1:
        floor, rubs = system.slack_floor, saddle.band.rubs
        changed += mark_taut(floor, work.stretch, work.soft, saddle.carries, rubs)
    return changed + mark_nodes(system, x, saddle.band)


@kernel
def mark_taut(floor, stretch, soft, carries, rubs):
    """Mark the segments with friction: all but slack tension-only ones; return how many changed.

    What gives is taut where it is longer than at rest. That is the same as to carry at the solution, but on
    the way to it a segment lets go as soon as its tension is a little off what its length asks for: the
    more readily the shorter the step.
    """
    changed = 0.0
    for j in range(rubs.shape[0]):
        on = 1.0
        if floor[j] == 0.0:
            on = carries[j]
            if soft[j] > 0.0:
                on = 1.0 if stretch[j] > 0.0 else 0.0
        changed += abs(on - rubs[j])
        rubs[j] = on
    return changed
