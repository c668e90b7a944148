"""What segments carry and how far they are stretched, as frames record it and looks see it."""

from __future__ import annotations

import math

import numpy as np

from ropewalk.core.jit import apart, kernel, part
from ropewalk.core.ranges import rows
from ropewalk.laws.elastic import solved_laws
from ropewalk.laws.pulls import add_pulls
from ropewalk.laws.rare import has_elastic_laws, limits, winds
from ropewalk.laws.stretch import stretched
from ropewalk.methods.scratch import ENERGY, LANES, clear_lanes, total_of

SOLVED = 1e-13  # [1] length error of a segment that is as long as its tension makes it ...
ROUNDING = 2e-15  # [1] ... and this share of its place


@kernel
def record_tension(x, rest_length, stiffness, floor, solved, sums, tension):
    """Write every segment's elastic tension [N], (s,); return their energy [J]. See `laws.stretch`.

    A rigid link has the tension that was solved for, and stores nothing. An elastic segment has it where its
    length agrees to rounding: k (r - L) loses the more digits, the larger k.
    """
    clear_lanes(sums, 1)
    s, springs = rest_length.shape[0], (rest_length, stiffness, floor, solved)
    for lo in range(0, s, LANES):
        hi = min(lo + LANES, s)
        _add_tension(x, springs, lo, hi, sums, tension, None, None, None)
    return total_of(sums, 0)


@kernel
def read_springs(x, v, rest_length, stiffness, floor, solved, vector, axial, sums, segments):
    """As `record_tension` and, in the same sweep, `add_rubbing` and `stretches`, rows of `segments`."""
    clear_lanes(sums, 1)
    tension, more = segments[0], (segments[1], segments[2])
    s, springs, rubs = (
        rest_length.shape[0],
        (rest_length, stiffness, floor, solved),
        (vector, axial),
    )
    for lo in range(0, s, LANES):
        hi = min(lo + LANES, s)
        _add_tension(x, springs, lo, hi, sums, tension, v, rubs, more)
    return total_of(sums, 0)


@apart
def _add_tension(x, springs, lo, hi, sums, tension, v, rubs, more):
    rest_length, stiffness, floor, solved = springs
    x0, x1, x2 = rows(x, lo, hi + 1)
    rest_length, stiffness, floor = rest_length[lo:hi], stiffness[lo:hi], floor[lo:hi]
    solved, tension = solved[lo:hi], tension[lo:hi]
    if v is not None:
        v0, v1, v2 = rows(v, lo, hi + 1)
        vector, axial = rubs[0][lo:hi], rubs[1][lo:hi]
        carried, stretch = more[0][lo:hi], more[1][lo:hi]
    for j in range(rest_length.shape[0]):
        dx, dy, dz = x0[j + 1] - x0[j], x1[j + 1] - x1[j], x2[j + 1] - x2[j]
        r, length = math.sqrt(dx * dx + dy * dy + dz * dz), rest_length[j]
        e, gives = r - length, stiffness[j] < np.inf
        pull = stiffness[j] * e if gives else solved[j]
        size = max(abs(x0[j]), abs(x1[j]), abs(x2[j]))
        if abs(solved[j] - pull) <= stiffness[j] * (SOLVED * length + ROUNDING * size):
            pull = solved[j]
        elastic = max(pull, floor[j])
        tension[j] = elastic
        sums[j] += 0.5 * pull * e if gives and pull >= floor[j] else 0.0
        if v is not None:
            ux, uy, uz = v0[j + 1] - v0[j], v1[j + 1] - v1[j], v2[j + 1] - v2[j]
            c = vector[j] + axial[j] if floor[j] != 0.0 or r >= length else 0.0
            along = (ux * dx + uy * dy + uz * dz) / r if r > 0.0 and c > 0.0 else 0.0
            carried[j] = elastic + c * along
            stretch[j] = r / length if length > 0.0 else -np.inf


@kernel
def stretches(x, rest_length, found):
    """Write the stretch of every segment that has a rest length [1]."""
    for j in range(rest_length.shape[0]):
        length = rest_length[j]
        found[j] = stretched(x, j) / length if length > 0.0 else -np.inf


@part
def record_elastic(system, state, sums, tension):
    """Write every segment's elastic tension [N], (s,); return their energy [J]."""
    lengths, k, floor, solved = (
        state.rest_length,
        state.stiffness,
        system.slack_floor,
        state.tension,
    )
    if has_elastic_laws(system):
        elastic, inner = system.elastic, state.inner
        near = SOLVED, ROUNDING
        energy = solved_laws(state.x, lengths, k, floor, elastic, inner, solved, near, tension)
    else:
        energy = record_tension(state.x, lengths, k, floor, solved, sums, tension)
    return energy


@part
def carried_tension(system, state, elastic, tension):
    """Write what every segment carries along itself [N], (s,): its elastic tension, friction, bound
    and what laws of segments pull.

    Vector friction counts with its part along the segment. A rigid link has no friction, and its elastic
    tension is what was solved for.
    """
    floor, lengths = system.slack_floor, state.rest_length
    vector, axial = state.damping_vector, state.damping_axial
    add_rubbing(state.x, state.v, lengths, floor, vector, axial, elastic, tension)
    add_rarer(system, state, elastic, tension)


@part
def add_rarer(system, state, elastic, tension):
    """Add what winches, bounds and laws of segments make of what segments carry [N], (s,)."""
    if winds(system, state):
        take_growth(state.x, state, system.winches, system.slack_floor, tension)
    if limits(system):
        add_bounds(state.forces.limiter, state.tension, state.limited, elastic, tension)
    add_pulls(system, state, state.x, state.v, tension)


@kernel
def add_rubbing(x, v, rest_length, floor, vector, axial, elastic, tension):
    """Write elastic tension and friction along the segment; a slack tension-only one has neither."""
    x0, x1, x2 = x[0], x[1], x[2]
    v0, v1, v2 = v[0], v[1], v[2]
    for j in range(rest_length.shape[0]):
        dx, dy, dz = x0[j + 1] - x0[j], x1[j + 1] - x1[j], x2[j + 1] - x2[j]
        ux, uy, uz = v0[j + 1] - v0[j], v1[j + 1] - v1[j], v2[j + 1] - v2[j]
        r = math.sqrt(dx * dx + dy * dy + dz * dz)
        rubs = vector[j] + axial[j] if floor[j] != 0.0 or r >= rest_length[j] else 0.0
        along = (ux * dx + uy * dy + uz * dz) / r if r > 0.0 and rubs > 0.0 else 0.0
        tension[j] = elastic[j] + rubs * along


@kernel
def take_growth(x, state, winches, floor, tension):
    """Take the growth of the winches' working segments out of their friction; see `growth_friction`."""
    for row in range(state.winch_exit.shape[0]):
        drum = state.winch_exit[row]
        j = drum if winches.step[row] > 0 else drum - 1
        if state.rest_length[j] == 0.0:  # it has parted
            continue
        dx, dy, dz = x[0, j + 1] - x[0, j], x[1, j + 1] - x[1, j], x[2, j + 1] - x[2, j]
        stretch = math.sqrt(dx * dx + dy * dy + dz * dz) / state.rest_length[j]
        if floor[j] != 0.0 or stretch >= 1.0:
            c = state.damping_vector[j] + state.damping_axial[j]
            tension[j] -= c * state.winch_rate[row] * stretch


@kernel
def add_bounds(limiter, solved, limited, elastic, tension):
    """Add what the bound of the stretch holds: solved for by implicit methods, else mean of the step."""
    for j in range(tension.shape[0]):
        if limiter[0, j + 1] != 0.0 or limiter[1, j + 1] != 0.0 or limiter[2, j + 1] != 0.0:
            tension[j] += solved[j] - elastic[j]
        tension[j] += limited[j]


@kernel
def read_segments(system, state, look):
    """Write what every segment carries, its stretch, and the elastic energy, to `look`."""
    lengths, k, sums, segments = state.rest_length, state.stiffness, look.sums, look.segments
    if has_elastic_laws(system):
        look.known[ENERGY] = record_elastic(system, state, sums, segments[0])
        carried_tension(system, state, segments[0], segments[1])
        stretches(state.x, lengths, segments[2])
    else:
        floor, solved = system.slack_floor, state.tension
        vector, axial = state.damping_vector, state.damping_axial
        look.known[ENERGY] = read_springs(
            state.x, state.v, lengths, k, floor, solved, vector, axial, sums, segments
        )
        add_rarer(system, state, segments[0], segments[1])
