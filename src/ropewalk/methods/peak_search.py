"""The search for the farthest of what was kept since the last frame, and what has to be settled before."""

from __future__ import annotations

import math

import numpy as np

from ropewalk.core.jit import apart, kernel, part, small
from ropewalk.core.peaks import (
    FORCE,
    HIGHEST,
    LEAST_TENSION,
    LOWEST,
    MOMENT,
    PLACE,
    SINCE,
    SPEED,
    STRETCH,
    TENSION,
    UNTIL,
    VALUE,
    greater,
)
from ropewalk.laws.elastic import settle_laws
from ropewalk.laws.rare import has_elastic_laws
from ropewalk.methods.scratch import LANES, SUMS


@small
def is_live(rest_length, stiffness):
    """Tell whether a segment is real: not between two ropes, nor on a drum."""
    return rest_length > 0.0 or stiffness > 0.0


@kernel
def fill(row, value):
    """Write one value everywhere, (m,)."""
    for j in range(row.shape[0]):
        row[j] = value


@kernel
def settle(peaks, rest_length, stiffness, floor, vector, axial):
    """Take tension and stretch from the squares of the lengths that were kept."""
    most, least, stretch = peaks.tension_high, peaks.tension_low, peaks.stretch
    for j in range(rest_length.shape[0]):
        length, k, square = rest_length[j], stiffness[j], peaks.square_high[j]
        seen = square >= 0.0
        longest = math.sqrt(square) if seen else 0.0
        shortest = math.sqrt(peaks.square_low[j]) if seen else 0.0
        high, low = max(k * (longest - length), floor[j]), max(k * (shortest - length), floor[j])
        if seen and length > 0.0:
            stretch[j] = max(stretch[j], longest / length)
        if seen and vector[j] + axial[j] == 0.0:
            most[j], least[j] = max(most[j], high), min(least[j], low)


@apart
def hold_farthest(values, rest_length, stiffness, sign, lo, hi, lanes):
    """Hold `values`, times `sign`, from `lo` to `hi - 1` against `lanes`, one a lane.

    Finite ones count; of segments only real ones, see `is_live`. Of all else `rest_length` is None.
    """
    values = values[lo:hi]
    if rest_length is not None:
        lengths, k = rest_length[lo:hi], stiffness[lo:hi]
    for j in range(values.shape[0]):
        value = sign * values[j]
        counts = value - value == 0.0
        if rest_length is not None:
            counts = counts and is_live(lengths[j], k[j])
        lanes[j] = greater(value if counts else -np.inf, lanes[j])


@kernel
def count_beyond(values, sign, best):
    """Return how many of `values` (m,), times `sign`, are beyond the best: mostly none."""
    more = 0
    for j in range(values.shape[0]):
        more += 1 if sign * values[j] > best else 0
    return more


@kernel
def farthest_lane(lanes, width):
    """Return the greatest of so many lanes, a power of two, holding halves against halves."""
    half = width // 2
    while half > 0:
        for i in range(half):
            lanes[i] = greater(lanes[half + i], lanes[i])
        half //= 2
    return lanes[0]


@kernel
def search(values, rest_length, stiffness, sign, which, found, since, until, lanes):
    """Note the farthest one of `values` with its place and time [s] if it is beyond the best so far.

    It is searched for in `lanes`, more of them in long ropes: numbers do not wait for each other.
    """
    if count_beyond(values, sign, sign * found[VALUE, which]) == 0:
        return
    width = LANES if values.shape[0] <= SUMS * LANES else SUMS * LANES
    fill(lanes[:width], -np.inf)
    for lo in range(0, values.shape[0], width):
        hi = min(lo + width, values.shape[0])
        hold_farthest(values, rest_length, stiffness, sign, lo, hi, lanes)
    best = farthest_lane(lanes, width)
    if best > sign * found[VALUE, which]:
        for j in range(values.shape[0]):
            here = sign * values[j] == best
            if rest_length is not None:
                here = here and is_live(rest_length[j], stiffness[j])
            if here:
                found[VALUE, which], found[PLACE, which] = values[j], j
                found[SINCE, which], found[UNTIL, which] = since, until
                break


@part
def settle_kept(system, state):
    """Take tension and stretch from the squares of the lengths that were kept."""
    peaks, lengths, k, floor = state.peaks, state.rest_length, state.stiffness, system.slack_floor
    vector, axial = state.damping_vector, state.damping_axial
    if has_elastic_laws(system):
        settle_laws(peaks, lengths, k, floor, vector, axial, system.elastic, state.inner)
    else:
        settle(peaks, lengths, k, floor, vector, axial)


@kernel
def search_kept(state, until, sums):
    """Note what is beyond the best of the interval so far, of steps that end at `until` [s] at the latest."""
    peaks, lengths, k = state.peaks, state.rest_length, state.stiffness
    found, since = peaks.found, peaks.looked[0]
    search(peaks.tension_high, lengths, k, 1.0, TENSION, found, since, until, sums)
    search(peaks.tension_low, lengths, k, -1.0, LEAST_TENSION, found, since, until, sums)
    search(peaks.stretch, None, None, 1.0, STRETCH, found, since, until, sums)
    search(peaks.speed, None, None, 1.0, SPEED, found, since, until, sums)
    search(peaks.high, None, None, 1.0, HIGHEST, found, since, until, sums)
    search(peaks.low, None, None, -1.0, LOWEST, found, since, until, sums)
    search(peaks.reaction, None, None, 1.0, FORCE, found, since, until, sums)
    search(peaks.moment, None, None, 1.0, MOMENT, found, since, until, sums)
    peaks.looked[0] = until


@part
def search_all(system, state, until, sums):
    """As `search_kept`, of what was kept as squares, too."""
    settle_kept(system, state)
    search_kept(state, until, sums)
