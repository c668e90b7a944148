"""Looking at a state as a frame would record it; where intervals between frames begin and end."""

from __future__ import annotations

from ropewalk.core.jit import part, seldom
from ropewalk.core.ranges import ALL
from ropewalk.laws.rare import winds
from ropewalk.methods.errors import keep_error, set_zero
from ropewalk.methods.peaks import (
    clear_peaks,
    keep_anchors,
    keep_between,
    keep_live,
    keep_nodes,
    keep_stretch,
    search_all,
    wanted,
)
from ropewalk.methods.recording import carried_tension, record_elastic


@seldom
def watch(system, state, pull, sums, t):
    """Look at the state of time `t` [s]. `pull` (2, s) and `sums` are working space."""
    if not wanted(state):
        return
    peaks, lengths = state.peaks, state.rest_length
    elastic = record_elastic(system, state, sums, pull[0])
    keep_error(system, state, elastic, sums, t)
    carried_tension(system, state, pull[0], pull[1])
    if winds(system, state):
        keep_live(pull[1], lengths, state.stiffness, peaks.tension_high, peaks.tension_low)
    else:
        keep_between(pull[1], peaks.tension_high, peaks.tension_low, 0, ALL)
    keep_stretch(state.x, lengths, peaks.stretch)
    keep_nodes(system, state)
    keep_anchors(system, state)
    peaks.looked[0] = t  # of an extreme that is found now the time is known
    search_all(system, state, t)


@part
def open_interval(system, state, pull, sums, t):
    """Begin an interval at time `t` [s], with the present state in it."""
    if wanted(state):
        clear_peaks(state.peaks)
        watch(system, state, pull, sums, t)


@seldom
def begin_interval(system, state, pull, sums, t, ledger):
    """As `open_interval`, for the host, at the very start; with a `ledger` of energy errors, too."""
    if wanted(state):
        set_zero(system, state, pull, sums, ledger)
    open_interval(system, state, pull, sums, t)


@part
def close_interval(system, state, pull, sums, last, t):
    """End an interval at time `t` [s] with the present state; steps until `last` [s] were looked at."""
    if wanted(state):
        search_all(system, state, last)
        watch(system, state, pull, sums, t)
