"""Books of winches: what rope that is wound within a step does to what segments and bends store."""

from __future__ import annotations

from ropewalk.core.jit import deferred, part
from ropewalk.laws.clamps import bent_energy, turn_clamps
from ropewalk.laws.elastic import CHANGE, NOW, length_slope
from ropewalk.laws.fresh import book_wound, remembers, working_segment
from ropewalk.laws.rare import has_bending, has_inner
from ropewalk.laws.stretch import stretched
from ropewalk.laws.winch import BACK, REACH, STEP, WOUND, wind_to, winding


@deferred()
def book_begin(system, state, x, begin, end, turning):
    """Note how long the working segments are, nodes at `x` (3, n); leave the rest lengths of `end` [s].

    Half of the work on bends is that of the lengths' change from `begin` [s] on at these places.
    """
    if has_bending(system) and winding(turning):
        turn_clamps(system, state, begin)
        _book_bends(system, state, x, begin, end, turning)
        turn_clamps(system, state, end)
    for row in range(turning.shape[0]):
        turning[row, REACH] = stretched(x, working_segment(system.winches, state.winch_exit, row))
    wind_to(system, state, end, turning)


@part
def _book_bends(system, state, x, begin, end, turning):
    """Book half of what bends store more at places `x` with the lengths of `end` than of `begin` [s]."""
    wind_to(system, state, begin, turning)
    stored = bent_energy(system, state, x)
    wind_to(system, state, end, turning)
    state.work.winch[1] += 0.5 * (bent_energy(system, state, x) - stored)


@deferred()
def book_end(system, state, x, begin, end, turning):
    """Book the work of the lengths that change from `begin` to `end` [s], the nodes at `x` (3, n) at the end.

    It is that of dV/dL at the mean lengths of the step. A stiff rope that is slack at one end of the
    step would store more than it ever has, with the places of that end and another's rest length. Leaves the
    rest lengths of `end`.
    """
    if not winding(turning):
        return
    if has_bending(system):
        _book_bends(system, state, x, begin, end, turning)
    wind_to(system, state, 0.5 * (begin + end), turning)
    for row in range(turning.shape[0]):
        working = working_segment(system.winches, state.winch_exit, row)
        reach = 0.5 * (turning[row, REACH] + stretched(x, working))
        if has_inner(system, state) and remembers(system.elastic, state.stiffness, working):
            turning[row, REACH] = reach  # for `book_memory`
            continue
        wound = (turning[row, WOUND] + turning[row, BACK]) * (end - begin) / turning[row, STEP]
        if wound != 0.0:  # of a last segment that has parted, whose length is 0, there is no slope
            state.work.winch[1] += wound * length_slope(system, state, working, reach)
    wind_to(system, state, end, turning)


@deferred()
def book_memory(system, state, begin, end, turning):
    """As `book_end`, after it, of working segments that remember: what they do at the end is known."""
    if not has_inner(system, state) or not winding(turning):
        return
    wind_to(system, state, 0.5 * (begin + end), turning)
    for row in range(turning.shape[0]):
        j = working_segment(system.winches, state.winch_exit, row)
        if remembers(system.elastic, state.stiffness, j):
            mean = state.inner[NOW, j] - 0.5 * state.inner[CHANGE, j]
            wound = (turning[row, WOUND] + turning[row, BACK]) * (end - begin) / turning[row, STEP]
            book_wound(system, state, j, turning[row, REACH], mean, wound)
    wind_to(system, state, end, turning)
