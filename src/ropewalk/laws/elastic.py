"""The elastic laws together: kernels of `stretch` for segments that obey one, see `elastic_law`.

Segments without a law obey Hooke's with the arithmetic of `stretch`.
"""

from __future__ import annotations

import math
from typing import Any

import numpy as np

from ropewalk.core.jit import deferred, kernel, part, small
from ropewalk.core.peaks import greater, lesser
from ropewalk.core.ranges import ALL
from ropewalk.laws.elastic_law import ElasticLaw
from ropewalk.laws.nodes import fold
from ropewalk.laws.rare import has_elastic_laws
from ropewalk.laws.registry import ELASTIC_LAWS
from ropewalk.laws.stretch import elastic_energy, segment_tension, stretched
from ropewalk.laws.stretch_tangent import add_line

NOW, CHANGE, RATE, FIRST = range(4)  # rows of `State.inner`, see `inner`


@part
def _no_pull(elastic, j, strain, inner, c):
    return 0.0, 0.0, 0.0


@part
def _no_strain(elastic, j, pull, inner, c):
    return 0.0, 1.0


def asking(piece: str) -> Any:
    """Return what asks the segment's own law for a piece of five arguments."""

    def make(law: ElasticLaw, k: int, rest: Any) -> Any:
        own = getattr(law, piece)

        @part
        def _ask(elastic, j, value, inner, c):
            if elastic.of[j] == k:
                found = own(elastic.table[k], j, value, inner, c)
            else:
                found = rest(elastic, j, value, inner, c)
            return found

        return _ask

    return make


_pull_of = fold(asking("pull"), _no_pull, "pull", ELASTIC_LAWS)
_strain_of = fold(asking("strain"), _no_strain, "strain", ELASTIC_LAWS)


@small
def pull_of(elastic, j, strain, inner, c):
    """Return g, its slope and G of segment `j` [1], see `elastic_law`."""
    return _pull_of(elastic, j, strain, inner, c)


@small
def strain_of(elastic, j, pull, inner, c):
    """Return the strain of segment `j` at which g is `pull`, and the slope of g there [1]."""
    return _strain_of(elastic, j, pull, inner, c)


@small
def elastic_pull(elastic, inner, j, length, k, r):
    """Return the elastic tension of segment `j` at length `r` [N], before it is slack."""
    if elastic.of[j] < 0 or k == 0.0:
        return k * (r - length)
    known = inner[NOW, j] if inner.shape[1] > 0 else 0.0
    pull, _, _ = pull_of(elastic, j, (r - length) / length, known, 0.0)
    return k * length * pull


@small
def held_strain(elastic, j, floor, strain, inner):
    """Return the strain of what the rope is made of [1]: that without tension where it is slack.

    `inner` is that of now. Of segments whose law remembers nothing it is the strain itself.
    """
    if floor == 0.0 and elastic.time[j] < math.inf:
        free, _ = strain_of(elastic, j, 0.0, inner, 0.0)
        strain = max(strain, free)
    return strain


@small
def stored_by(elastic, inner, j, length, k, floor, strain):
    """Return what a segment with a law stores [J]; one that remembers does so while it is slack, too."""
    if elastic.time[j] < math.inf:
        return stored_with(elastic, j, length, k, floor, strain, inner[NOW, j])
    if floor == 0.0 and strain < 0.0:
        return 0.0
    _, _, energy = pull_of(elastic, j, strain, 0.0, 0.0)
    return k * length * length * energy


@small
def stored_with(elastic, j, length, k, floor, strain, inner):
    """Return what a segment that remembers `inner` stores [J]."""
    strain = held_strain(elastic, j, floor, strain, inner)
    _, _, energy = pull_of(elastic, j, strain, inner, 0.0)
    return k * length * length * energy


@deferred()
def law_forces(x, rest_length, stiffness, floor, elastic, inner, out, lo=0, hi=ALL):
    """Write the elastic force of every segment with a law [N], (3, n + 1)."""
    for j in range(lo, min(hi, rest_length.shape[0])):
        if elastic.of[j] < 0 or stiffness[j] == 0.0:
            continue
        r = stretched(x, j)
        pull = max(elastic_pull(elastic, inner, j, rest_length[j], stiffness[j], r), floor[j])
        over = pull / r if r > 0.0 else 0.0
        for k in range(3):
            out[k, j + 1] = over * (x[k, j + 1] - x[k, j])


@deferred()
def law_tensions(x, rest_length, stiffness, floor, elastic, inner, tension):
    """Write the elastic tension of every segment with a law [N], (s,)."""
    for j in range(rest_length.shape[0]):
        if elastic.of[j] >= 0 and stiffness[j] > 0.0:
            pull = elastic_pull(elastic, inner, j, rest_length[j], stiffness[j], stretched(x, j))
            tension[j] = max(pull, floor[j])


@deferred("float64")
def law_energy(x, rest_length, stiffness, floor, elastic, inner):
    """Return the elastic energy of all segments [J], with a law or without; see `elastic_energy`."""
    total = 0.0
    for j in range(rest_length.shape[0]):
        length, k = rest_length[j], stiffness[j]
        e = stretched(x, j) - length
        if elastic.of[j] >= 0 and k > 0.0:
            total += stored_by(elastic, inner, j, length, k, floor[j], e / length)
        elif k < np.inf and not (floor[j] == 0.0 and e < 0.0):
            total += 0.5 * k * e * e
    return total


@deferred()
def hold_secants(tension, rest_length, stiffness, elastic, work):
    """Write what a segment with a law gives over its tension [m/N], (s,), beyond its length without.

    With it the tangent of that, for `hold_tangents`.
    """
    soft, remembers = work.soft, work.known.shape[0] > 0
    for j in range(tension.shape[0]):
        if elastic.of[j] >= 0 and stiffness[j] > 0.0:
            product, known, c = stiffness[j] * rest_length[j], 0.0, 0.0
            if remembers:
                known, c = work.start[j], work.follow[j]
            strain, slope = strain_of(elastic, j, tension[j] / product, known, c)
            if remembers:
                strain -= work.free[j]
                work.stretch[j] -= rest_length[j] * work.free[j]
            given = strain * rest_length[j] / tension[j] if tension[j] != 0.0 else 0.0
            work.tangent[j] = 1.0 / (stiffness[j] * slope)
            soft[j] = given if tension[j] != 0.0 else work.tangent[j]


@kernel
def hold_tangents(stiffness, elastic, work, carries, compliance):
    """Write the tangent compliance [m/N], (s,), of the segments with a law that carry."""
    for j in range(carries.shape[0]):
        if elastic.of[j] >= 0 and stiffness[j] > 0.0 and carries[j] != 0.0:
            compliance[j] = work.tangent[j]


@kernel
def law_tangent(x, rest_length, stiffness, floor, elastic, weight, clamp, band):
    """As `elastic_tangent`, of segments with a law or without: their stiffness at rest."""
    for j in range(rest_length.shape[0]):
        length, along = rest_length[j], stiffness[j]
        r = stretched(x, j)
        if r == 0.0:
            if length == 0.0:
                add_line(band, j, 0.0, 0.0, 0.0, weight * along, weight * along)
            continue
        tension = along * (r - length)
        if elastic.of[j] >= 0 and along > 0.0:
            pull, slope, _ = pull_of(elastic, j, (r - length) / length, 0.0, math.inf)
            tension, along = along * length * pull, along * slope
        if tension < floor[j]:
            continue
        across = tension / r
        if clamp and across < 0.0:
            across = 0.0
        tx, ty, tz = (
            (x[0, j + 1] - x[0, j]) / r,
            (x[1, j + 1] - x[1, j]) / r,
            (x[2, j + 1] - x[2, j]) / r,
        )
        add_line(band, j, tx, ty, tz, weight * across, weight * along)


@deferred()
def keep_laws(state, floor, elastic, high, low, lo, hi):
    """As `methods.peaks.keep_tension`, of segments with a law or without."""
    x, v = state.x, state.v
    for j in range(lo, min(hi, high.shape[0])):
        r, length = stretched(x, j), state.rest_length[j]
        rubs, rate = state.damping_vector[j] + state.damping_axial[j], 0.0
        for k in range(3):
            rate += (v[k, j + 1] - v[k, j]) * (x[k, j + 1] - x[k, j])
        rubs = rubs * rate / r if r > 0.0 and (floor[j] != 0.0 or r >= length) else 0.0
        pull = elastic_pull(elastic, state.inner, j, length, state.stiffness[j], r)
        new = max(pull, floor[j]) + rubs
        high[j], low[j] = greater(new, high[j]), lesser(new, low[j])


@deferred()
def settle_laws(peaks, rest_length, stiffness, floor, vector, axial, elastic, inner):
    """As `methods.peaks.settle`, of segments with a law or without; those that remember are looked at."""
    for j in range(rest_length.shape[0]):
        if peaks.square_high[j] < 0.0:
            continue
        length, k = rest_length[j], stiffness[j]
        longest, shortest = math.sqrt(peaks.square_high[j]), math.sqrt(peaks.square_low[j])
        if length > 0.0:
            peaks.stretch[j] = max(peaks.stretch[j], longest / length)
        if vector[j] + axial[j] == 0.0 and inner.shape[1] == 0:
            high = max(elastic_pull(elastic, inner, j, length, k, longest), floor[j])
            low = max(elastic_pull(elastic, inner, j, length, k, shortest), floor[j])
            peaks.tension_high[j] = max(peaks.tension_high[j], high)
            peaks.tension_low[j] = min(peaks.tension_low[j], low)


@deferred("float64")
def solved_laws(x, rest_length, stiffness, floor, elastic, inner, solved, near, tension):
    """As `methods.recording.record_tension`, of segments with a law or without.

    The tension `solved` for counts where it is `near`: to these parts of the length and of the places [1].
    """
    total = 0.0
    for j in range(rest_length.shape[0]):
        length, k = rest_length[j], stiffness[j]
        r = stretched(x, j)
        e, gives = r - length, k < np.inf
        pull = k * e if gives else solved[j]
        stored = 0.5 * pull * e if gives and pull >= floor[j] else 0.0
        if elastic.of[j] >= 0 and k > 0.0:
            pull = elastic_pull(elastic, inner, j, length, k, r)
            stored = stored_by(elastic, inner, j, length, k, floor[j], e / length)
        size = max(abs(x[0, j]), abs(x[1, j]), abs(x[2, j]))
        if abs(solved[j] - pull) <= k * (near[0] * length + near[1] * size):
            pull = solved[j]
        tension[j] = max(pull, floor[j])
        total += stored
    return total


@part
def stored_energy(system, state, x, inner):
    """Return the elastic energy of all segments at places `x`, (3, n), with `inner` as it is then [J]."""
    lengths, k, floor = state.rest_length, state.stiffness, system.slack_floor
    if has_elastic_laws(system):
        energy = law_energy(x, lengths, k, floor, system.elastic, inner)
    else:
        energy = elastic_energy(x, lengths, k, floor)
    return energy


@part
def length_slope(system, state, j, r):
    """Return by how much more segment `j` stores with every metre of rest length, at length `r` [N].

    Of V = EA L G(e) that is EA (G - (1 + e) g), e the strain. For laws that remember see `fresh`.
    """
    length, k = state.rest_length[j], state.stiffness[j]
    strain = (r - length) / length
    pull, energy = strain, 0.5 * strain * strain
    if has_elastic_laws(system) and system.elastic.of[j] >= 0:
        pull, _, energy = pull_of(system.elastic, j, strain, 0.0, 0.0)
    slope = k * length * (energy - (1.0 + strain) * pull)
    if system.slack_floor[j] == 0.0 and strain < 0.0:
        slope = 0.0
    return slope


@part
def tensions(system, state, tension):
    """Write the elastic tension of every segment [N], (s,); negative where it is compressed."""
    lengths, k, floor = state.rest_length, state.stiffness, system.slack_floor
    segment_tension(state.x, lengths, k, floor, tension)
    if has_elastic_laws(system):
        law_tensions(state.x, lengths, k, floor, system.elastic, state.inner, tension)


# -- at rest, for the host -----------------------------------------------------------------


@kernel
def rest_pulls(elastic, rest_length, stiffness, stretch, tension, stored):
    """Write tension [N] and energy [J] of segments with a law at stretches [m], (s,), pressed ones too."""
    for j in range(stretch.shape[0]):
        if elastic.of[j] >= 0 and stiffness[j] > 0.0:
            length, EA = rest_length[j], stiffness[j] * rest_length[j]
            pull, _, energy = pull_of(elastic, j, stretch[j] / length, 0.0, math.inf)
            tension[j], stored[j] = EA * pull, EA * length * energy


@kernel
def rest_strains(elastic, rest_length, stiffness, tension, stretch, soft):
    """Write stretch [m] and compliance [m/N] of segments with a law under tensions [N], (s,)."""
    for j in range(tension.shape[0]):
        if elastic.of[j] >= 0 and stiffness[j] > 0.0:
            length, EA = rest_length[j], stiffness[j] * rest_length[j]
            strain, slope = strain_of(elastic, j, tension[j] / EA, 0.0, math.inf)
            stretch[j], soft[j] = strain * length, 1.0 / (stiffness[j] * slope)


@kernel
def slopes(elastic, stiffness, strain, slow, fast):
    """Write how tension rises with length, slowly and at once, from strains at rest [N/m], (s,)."""
    for j in range(strain.shape[0]):
        slow[j], fast[j] = stiffness[j], stiffness[j]
        if elastic.of[j] >= 0 and stiffness[j] > 0.0:
            _, at_rest, _ = pull_of(elastic, j, strain[j], strain[j], math.inf)
            _, sudden, _ = pull_of(elastic, j, strain[j], strain[j], 0.0)
            slow[j], fast[j] = stiffness[j] * at_rest, stiffness[j] * sudden
