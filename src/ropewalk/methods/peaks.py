"""The greatest and least of every step since the last frame, per segment, node and anchor.

Frames see nothing of what lies between: the force of a catch, the crack of a whip. So every step is looked
at, element by element, in loops that vectorise. Elastic segments without friction keep the square of their
length alone: tension and stretch never fall where it grows, nor do their roundings, so that the law is taken
of the extremes, not of every step. Over a rope is searched once in DEPTH steps: an extreme is known to
the step in value, and to so many steps in time; methods whose steps cost more know the step.
"""

from __future__ import annotations

import math

import numpy as np

from ropewalk.core.jit import apart, kernel, part, small
from ropewalk.core.peaks import (
    BEFORE,
    FORCE,
    GREATEST,
    LEAST,
    LEAST_TENSION,
    LOOKED,
    LOWEST,
    MOMENT,
    PLACE,
    SINCE,
    SPEED,
    SQUARE,
    STEPS,
    UNTIL,
    VALUE,
    WHEN,
    WITHIN,
    greater,
    lesser,
)
from ropewalk.core.ranges import ALL, rows
from ropewalk.laws.anchors import first_index, last_index
from ropewalk.laws.elastic import keep_laws
from ropewalk.laws.pulls import pulls
from ropewalk.laws.rare import (
    acts_after,
    has_clamps,
    has_elastic_laws,
    has_inner,
    limits,
    parts,
    winds,
)
from ropewalk.methods.peak_search import fill, is_live, search_all
from ropewalk.methods.scratch import put_row

DEPTH = 32  # steps


@part
def wanted(state):
    """Tell whether extremes are kept."""
    return state.peaks.speed.shape[0] > 0


@part
def adds_to_springs(system, state):
    """Tell whether anything adds to what springs and friction carry, or they part."""
    return limits(system) or winds(system, state) or parts(system) or pulls(system)


@part
def looks_at_all(system, extras):
    """Tell whether a method without equations looks at every step as a frame records it, by `watch`."""
    return acts_after(extras) or parts(system) or pulls(system)


@small
def keep_between(values, high, low, lo, hi):
    """Keep the greater and the lesser of each, arrays (m,)."""
    values, high, low = values[lo:hi], high[lo:hi], low[lo:hi]
    for j in range(high.shape[0]):
        high[j], low[j] = greater(values[j], high[j]), lesser(values[j], low[j])


@kernel
def keep_live(tension, rest_length, stiffness, high, low):
    """As `keep_between`, of real segments: on a drum, or once it has parted, none has carried 0 N."""
    for j in range(tension.shape[0]):
        if is_live(rest_length[j], stiffness[j]):
            high[j], low[j] = greater(tension[j], high[j]), lesser(tension[j], low[j])


@small
def keep_squares(x, high, low, lo, hi):
    """Keep greatest and least square of the length of every segment [m^2]."""
    x0, x1, x2 = rows(x, lo, hi + 1)
    high, low = high[lo:hi], low[lo:hi]
    for j in range(high.shape[0]):
        dx, dy, dz = x0[j + 1] - x0[j], x1[j + 1] - x1[j], x2[j + 1] - x2[j]
        square = dx * dx + dy * dy + dz * dz
        high[j], low[j] = greater(square, high[j]), lesser(square, low[j])


@apart
def keep_tension(x, v, rest_length, stiffness, floor, vector, axial, peaks, lo, hi):
    """As `keep_squares`, and keep greatest and least tension, friction along the segments included."""
    x0, x1, x2 = rows(x, lo, hi + 1)
    v0, v1, v2 = rows(v, lo, hi + 1)
    rest_length, stiffness, floor = rest_length[lo:hi], stiffness[lo:hi], floor[lo:hi]
    vector, axial = vector[lo:hi], axial[lo:hi]
    longest, shortest = peaks.square_high[lo:hi], peaks.square_low[lo:hi]
    high, low = peaks.tension_high[lo:hi], peaks.tension_low[lo:hi]
    for j in range(rest_length.shape[0]):
        dx, dy, dz = x0[j + 1] - x0[j], x1[j + 1] - x1[j], x2[j + 1] - x2[j]
        ux, uy, uz = v0[j + 1] - v0[j], v1[j + 1] - v1[j], v2[j + 1] - v2[j]
        square = dx * dx + dy * dy + dz * dz
        longest[j], shortest[j] = greater(square, longest[j]), lesser(square, shortest[j])
        r = math.sqrt(square)
        rubs = vector[j] + axial[j] if floor[j] != 0.0 or r >= rest_length[j] else 0.0
        along = (ux * dx + uy * dy + uz * dz) / r if r > 0.0 else 0.0
        new = max(stiffness[j] * (r - rest_length[j]), floor[j]) + rubs * along
        high[j], low[j] = greater(new, high[j]), lesser(new, low[j])


@small
def keep_speed(v, kept, lo, hi):
    """Keep the greatest square of the speed of every node [m^2/s^2]."""
    v0, v1, v2 = rows(v, lo, hi)
    kept = kept[lo:hi]
    for i in range(kept.shape[0]):
        kept[i] = greater(v0[i] * v0[i] + v1[i] * v1[i] + v2[i] * v2[i], kept[i])


@small
def keep_heights(x, up, high, low, lo, hi):
    """Keep the highest and lowest place of every node along `up` [m]."""
    if up[2] == 1.0:
        keep_between(x[2], high, low, lo, hi)
    elif up[1] == 1.0:
        keep_between(x[1], high, low, lo, hi)
    else:
        x0, x1, x2 = rows(x, lo, hi)
        high, low = high[lo:hi], low[lo:hi]
        a, b, c = up[0], up[1], up[2]
        for i in range(high.shape[0]):
            new = a * x0[i] + b * x1[i] + c * x2[i]
            high[i], low[i] = greater(new, high[i]), lesser(new, low[i])


@part
def keep_nodes(system, state, lo=0, hi=ALL):
    """Look at speed and height of nodes `lo` to `hi - 1`."""
    peaks = state.peaks
    keep_speed(state.v, peaks.speed, lo, hi)
    keep_heights(state.x, system.up, peaks.high, peaks.low, lo, hi)


@part
def heights(x, up, room, lo, hi):
    """Return the height of every node along `up` [m], (n,): a row of `x`, or `room` with those from `lo`."""
    if up[2] == 1.0:
        height = x[2]
    elif up[1] == 1.0:
        height = x[1]
    else:
        height = room
        write_heights(x, up, room, lo, hi + 1)
    return height


@small
def write_heights(x, up, room, lo, hi):
    """Write the height of every node along `up` [m], (n,)."""
    x0, x1, x2 = rows(x, lo, hi)
    room = room[lo:hi]
    a, b, c = up[0], up[1], up[2]
    for i in range(room.shape[0]):
        room[i] = a * x0[i] + b * x1[i] + c * x2[i]


@part
def keep_last(state, height, hi):
    """Look at the last node, at which no segment begins, where it is before `hi`."""
    peaks, i = state.peaks, state.mass.shape[0] - 1
    if hi > i:
        p, q, r = state.v[0, i], state.v[1, i], state.v[2, i]
        peaks.speed[i] = greater(p * p + q * q + r * r, peaks.speed[i])
        peaks.high[i] = greater(height[i], peaks.high[i])
        peaks.low[i] = lesser(height[i], peaks.low[i])


@part
def keep_anchors(system, state, lo=0, hi=ALL):
    """Look at the force of every anchor that holds one of these nodes, and at the moments of all clamps."""
    order, kept = system.anchors.order, state.peaks.reaction
    for index in range(first_index(order, state, lo), last_index(order, state, hi)):
        row = max(order[index], 0)
        a, b, c = state.reaction[row, 0], state.reaction[row, 1], state.reaction[row, 2]
        new = a * a + b * b + c * c
        if new > kept[row]:
            kept[row] = new
    if has_clamps(system, state):
        for row in range(state.moment.shape[0]):
            new = 0.0
            for k in range(3):
                size = state.moment[row, k] + state.moment[row, k + 3]
                new += size * size
            if new > state.peaks.moment[row]:
                state.peaks.moment[row] = new


@part
def keep_pressed(system, state, t):
    """Look at the force on every obstacle as a step ends, at time `t` [s].

    Unlike all else that is not looked at where an interval begins: that is the end of a step before, or a
    shape as it is drawn, whose overlap is no load.
    """
    if system.rare is not None and state.peaks.pressed.shape[0] > 0:
        keep_loads(state.memory.obstacle.load, state.peaks.pressed, t)


@kernel
def keep_loads(load, pressed, t):
    """Hold forces on obstacles (k, 3) [N] against the greatest so far, each step once."""
    for o in range(load.shape[0]):
        if t <= pressed[o, LOOKED]:
            continue
        a, b, c = load[o, 0], load[o, 1], load[o, 2]
        new = a * a + b * b + c * c
        if new > pressed[o, SQUARE]:
            pressed[o, SQUARE], pressed[o, WHEN], least = new, t, np.inf
            for k in range(STEPS, STEPS + WITHIN):
                least = lesser(pressed[o, k], least)
            pressed[o, BEFORE] = least if least < np.inf else np.nan
        for k in range(STEPS + WITHIN - 1, STEPS, -1):
            pressed[o, k] = pressed[o, k - 1]
        pressed[o, STEPS], pressed[o, LOOKED] = new, t


@part
def keep_springs(system, state, rubs, lo=0, hi=ALL):
    """Look at elastic segments without bounds and winches; `rubs` tells whether any has friction."""
    peaks, lengths, k, floor = state.peaks, state.rest_length, state.stiffness, system.slack_floor
    if rubs and not has_elastic_laws(system):
        vector, axial = state.damping_vector, state.damping_axial
        keep_tension(state.x, state.v, lengths, k, floor, vector, axial, peaks, lo, hi)
    else:
        keep_squares(state.x, peaks.square_high, peaks.square_low, lo, hi)
        if has_elastic_laws(system) and (rubs or has_inner(system, state)):
            high, low = peaks.tension_high, peaks.tension_low
            keep_laws(state, floor, system.elastic, high, low, lo, hi)


@part
def keep_step(system, state, rubs, count, t, sums):
    """Look at the end of a step, the `count`-th, at time `t` [s], where `watch` does not."""
    keep_springs(system, state, rubs)
    keep_nodes(system, state)
    keep_anchors(system, state)
    keep_pressed(system, state, t)
    if count % DEPTH == 0:
        search_all(system, state, t, sums)


@kernel
def any_rubs(vector, axial):
    """Tell whether any segment has friction."""
    total = 0.0
    for j in range(vector.shape[0]):
        total += vector[j] + axial[j]
    return total > 0.0


@small
def keep_row(values, high):
    """Keep the greater of each, arrays (m,)."""
    for j in range(high.shape[0]):
        high[j] = greater(values[j], high[j])


@part
def clear_peaks(peaks):
    """Begin an interval: nothing was seen yet, but for what `begin_seen` begins with."""
    fill(peaks.square_high, -np.inf)
    fill(peaks.square_low, np.inf)
    fill(peaks.reaction, -np.inf)
    fill(peaks.moment, -np.inf)
    for row in range(peaks.pressed.shape[0]):
        peaks.pressed[row, SQUARE] = -np.inf
        peaks.pressed[row, WHEN] = peaks.pressed[row, BEFORE] = np.nan
    for which in range(peaks.found.shape[1]):
        least = which == LEAST_TENSION or which == LOWEST
        peaks.found[VALUE, which] = np.inf if least else -np.inf
        peaks.found[PLACE, which] = -1.0
        peaks.found[SINCE, which] = peaks.found[UNTIL, which] = np.nan
    peaks.error[LEAST, 0], peaks.error[GREATEST, 0] = np.inf, -np.inf
    peaks.error[LEAST, 1] = peaks.error[GREATEST, 1] = np.nan


@kernel
def begin_between(values, high, low):
    """Begin with these as the greater and the lesser of each, arrays (m,)."""
    for j in range(high.shape[0]):
        value = values[j]
        high[j], low[j] = greater(value, -np.inf), lesser(value, np.inf)


@kernel
def begin_nodes(x, v, up, peaks):
    """Begin with speed and height of every node."""
    v0, v1, v2 = v[0], v[1], v[2]
    for i in range(peaks.speed.shape[0]):
        peaks.speed[i] = greater(v0[i] * v0[i] + v1[i] * v1[i] + v2[i] * v2[i], -np.inf)
    begin_between(heights(x, up, peaks.high, 0, ALL), peaks.high, peaks.low)


@apart
def record_tensions(high, low, most, least):
    """Write greatest and least tension of every segment, 0 where there was no rope [N]."""
    for j in range(most.shape[0]):
        seen = low[j] < np.inf
        most[j], least[j] = high[j] if seen else 0.0, low[j] if seen else 0.0


@small
def root(square):
    """Return the root of a greatest square; no number where none was seen, as of a rope that broke."""
    return math.sqrt(square) if square >= 0.0 else np.nan


@apart
def record_others(stretch, square, most, fastest):
    """Write the greatest stretch of segments, 0 of those of no length [1], and speed of nodes [m/s]."""
    for j in range(most.shape[0]):
        most[j] = max(stretch[j], 0.0)
    for i in range(fastest.shape[0]):
        fastest[i] = root(square[i])


@kernel
def record_peaks(peaks, frame, out):
    """Write the interval that ends with frame `frame`."""
    most, least = out.tension_high[frame], out.tension_low[frame]
    record_tensions(peaks.tension_high, peaks.tension_low, most, least)
    record_others(peaks.stretch, peaks.speed, out.stretch_high[frame], out.speed_high[frame])
    put_row(peaks.high, out.highest[frame])
    put_row(peaks.low, out.lowest[frame])
    for which in range(out.extremes.shape[1]):
        value = peaks.found[VALUE, which]
        if peaks.found[PLACE, which] < 0.0:
            value = np.nan
        elif which == SPEED or which == FORCE or which == MOMENT:
            value = root(value)
        out.extremes[frame, which] = value
        out.extreme_places[frame, which] = peaks.found[PLACE, which]
        out.extreme_since[frame, which] = peaks.found[SINCE, which]
        out.extreme_until[frame, which] = peaks.found[UNTIL, which]
    for bound in range(out.error_range.shape[1]):
        error = peaks.error[bound, 0]
        out.error_range[frame, bound] = error if error - error == 0.0 else np.nan
        out.error_times[frame, bound] = peaks.error[bound, 1]
    for row in range(out.reaction_high.shape[1]):
        out.reaction_high[frame, row] = root(peaks.reaction[row])
    for row in range(out.moment_high.shape[1]):
        out.moment_high[frame, row] = root(peaks.moment[row])
    for row in range(out.pressed_high.shape[1]):
        out.pressed_high[frame, row] = root(peaks.pressed[row, SQUARE])
        out.pressed_time[frame, row] = peaks.pressed[row, WHEN]
        out.pressed_before[frame, row] = root(peaks.pressed[row, BEFORE])
