"""Looking at a state as a frame would record it; where intervals between frames begin and end.

What such a look has read stays in the method's `Look` as long as the state stays: a frame is recorded of it,
and the next interval begins with it.
"""

from __future__ import annotations

import numpy as np

from ropewalk.core.jit import kernel, part, seldom
from ropewalk.core.ranges import ALL
from ropewalk.laws.rare import parts, winds
from ropewalk.methods.carried import read_segments
from ropewalk.methods.errors import error_now, keep_error, set_zero
from ropewalk.methods.peak_search import fill, search_all, search_kept, settle_kept
from ropewalk.methods.peaks import (
    begin_between,
    begin_nodes,
    clear_peaks,
    keep_anchors,
    keep_between,
    keep_live,
    keep_nodes,
    keep_pressed,
    keep_row,
    wanted,
)
from ropewalk.methods.scratch import ENERGY, ERROR, SEEN


@kernel
def see(system, state, look):
    """Write what the state has to be looked at for to `look`."""
    read_segments(system, state, look)
    look.known[ERROR] = error_now(system, state, look.known[ENERGY], look.sums)
    look.known[SEEN] = 1.0


@kernel
def keep_seen(system, state, look, t):
    """Hold what was seen of the state, of time `t` [s], against the extremes."""
    peaks, carried = state.peaks, look.segments[1]
    if winds(system, state) or parts(system):
        lengths, k = state.rest_length, state.stiffness
        keep_live(carried, lengths, k, peaks.tension_high, peaks.tension_low)
    else:
        keep_between(carried, peaks.tension_high, peaks.tension_low, 0, ALL)
    keep_row(look.segments[2], peaks.stretch)
    keep_nodes(system, state)
    keep_pressed(system, state, t)
    keep_rest(system, state, look, t)


@kernel
def begin_seen(system, state, look, t):
    """Begin an interval with what was seen of the state, of time `t` [s]."""
    peaks, carried = state.peaks, look.segments[1]
    clear_peaks(peaks)
    if winds(system, state) or parts(system):
        fill(peaks.tension_high, -np.inf)
        fill(peaks.tension_low, np.inf)
        lengths, k = state.rest_length, state.stiffness
        keep_live(carried, lengths, k, peaks.tension_high, peaks.tension_low)
    else:
        begin_between(carried, peaks.tension_high, peaks.tension_low)
    fill(peaks.stretch, -np.inf)
    keep_row(look.segments[2], peaks.stretch)
    begin_nodes(state.x, state.v, system.up, peaks)
    keep_rest(system, state, look, t)


@kernel
def keep_rest(system, state, look, t):
    """Hold error and anchors against the extremes, and search these."""
    keep_error(state.peaks, look.known[ERROR], t)
    keep_anchors(system, state)
    state.peaks.looked[0] = t  # of an extreme that is found now the time is known
    search_kept(state, t, look.sums)


@seldom
def watch(system, state, look, t):
    """Look at the state of time `t` [s], with nothing left to settle."""
    if wanted(state):
        see(system, state, look)
        keep_seen(system, state, look, t)


@seldom
def look_now(system, state, look, t):
    """As `watch`, for the host, within an interval."""
    if wanted(state):
        settle_kept(system, state)
        watch(system, state, look, t)


@part
def open_interval(system, state, look, t):
    """Begin an interval at time `t` [s], with the present state in it."""
    if wanted(state):
        if look.known[SEEN] == 0.0:
            see(system, state, look)
        begin_seen(system, state, look, t)
        look.known[SEEN] = 0.0


@seldom
def begin_interval(system, state, look, t, ledger):
    """As `open_interval`, for the host, at the very start; with a `ledger` of energy errors, too."""
    if wanted(state):
        set_zero(system, state, look, ledger)
    open_interval(system, state, look, t)


@part
def close_interval(system, state, look, last, t):
    """End an interval at time `t` [s] with the present state; steps until `last` [s] were looked at."""
    if wanted(state):
        search_all(system, state, last, look.sums)
        watch(system, state, look, t)
