"""What segments remember, an inner strain each, whatever their law; see `elastic_law`.

* Runge-Kutta methods have d among their unknowns.
* Semi-implicit Euler and Verlet take d over the step with the strain linear in time, as its law does.
* A stage of an implicit method knows d = d^ + c d', so that only compliance and length of a segment change.

A tension-only segment that is slack keeps the strain without tension, and changes as one that nothing pulls.
What is lost is booked as friction, and taken out of what springs did.

Rows of `State.inner`: NOW, d; CHANGE, that in the last step; RATE, which a method keeps [1/s]; FIRST, the
strain that a step began with.
"""

from __future__ import annotations

from typing import Any

from ropewalk.core.jit import deferred, kernel, part, small
from ropewalk.laws.bounds import within
from ropewalk.laws.elastic import CHANGE, FIRST, NOW, RATE, asking, held_strain, strain_of
from ropewalk.laws.elastic_law import ElasticLaw
from ropewalk.laws.fresh import (
    gained_by_mixing,
    growing,
    remembers,
    thin_half,
    thin_rates,
    thin_solved,
    thin_stage,
    working_segment,
)
from ropewalk.laws.nodes import fold
from ropewalk.laws.rare import has_inner, winds
from ropewalk.laws.registry import ELASTIC_LAWS
from ropewalk.laws.stretch import stretched

# -- what the laws say, each of its own segments ----------------------------------------------


@part
def _no_rate(elastic, j, strain, inner, c):
    return 0.0


@part
def _no_move(elastic, j, inner, first, last, dt):
    return inner


def _moving(law: ElasticLaw, k: int, rest: Any) -> Any:
    rate = law.rate

    @part
    def _by_its_rate(table, j, inner, first, last, dt):
        return inner + dt * rate(table, j, 0.5 * (first + last), inner, 0.5 * dt)

    own = _by_its_rate if law.move is None else law.move

    @part
    def _move(elastic, j, inner, first, last, dt):
        if elastic.of[j] == k:
            found = own(elastic.table[k], j, inner, first, last, dt)
        else:
            found = rest(elastic, j, inner, first, last, dt)
        return found

    return _move


@part
def _no_heat(elastic, j, change, dt):
    return 0.0


def _heating(law: ElasticLaw, k: int, rest: Any) -> Any:
    own = law.heat

    @part
    def _heat(elastic, j, change, dt):
        if elastic.of[j] == k:
            found = own(elastic.table[k], j, change, dt)
        else:
            found = rest(elastic, j, change, dt)
        return found

    return _heat


_rate_of = fold(asking("rate"), _no_rate, "rate", ELASTIC_LAWS)
_move_of = fold(_moving, _no_move, "rate", ELASTIC_LAWS)
_heat_of = fold(_heating, _no_heat, "heat", ELASTIC_LAWS)


@small
def rate_of(elastic, j, strain, inner, c):
    """Return d' of segment `j` where d is `inner + c d'` [1/s]."""
    return _rate_of(elastic, j, strain, inner, c)


@small
def move_of(elastic, j, inner, first, last, dt):
    """Return d of segment `j` after a step [1]."""
    return _move_of(elastic, j, inner, first, last, dt)


@small
def heat_of(elastic, stiffness, rest_length, change, j, dt):
    """Return what segment `j` loses in a step of `dt` [J], as its inner strain changes [1]."""
    if not remembers(elastic, stiffness, j):
        return 0.0
    return stiffness[j] * rest_length[j] * rest_length[j] * _heat_of(elastic, j, change, dt)


# -- explicit methods --------------------------------------------------------------------------


@deferred()
def strains(elastic, stiffness, rest_length, floor, x, inner, out):
    """Write the strain of what the segments are made of at places `x`, (s,) [1]."""
    for j in range(out.shape[0]):
        if remembers(elastic, stiffness, j):
            strain = (stretched(x, j) - rest_length[j]) / rest_length[j]
            out[j] = held_strain(elastic, j, floor[j], strain, inner[j])


@deferred()
def rates(elastic, stiffness, strain, inner, out):
    """Write d' of every segment, (s,) [1/s]; `out` may be `strain`."""
    for j in range(out.shape[0]):
        acts = remembers(elastic, stiffness, j)
        out[j] = rate_of(elastic, j, strain[j], inner[j], 0.0) if acts else 0.0


@part
def write_rates(system, state, x, out):
    """Write d' of every segment at places `x`, (s,) [1/s], for the d that the state has."""
    elastic, k, inner = system.elastic, state.stiffness, state.inner[NOW]
    strains(elastic, k, state.rest_length, system.slack_floor, x, inner, out)
    rates(elastic, k, out, inner, out)
    if winds(system, state):
        thin_rates(system, state, out)


@part
def note_strains(system, state):
    """Note what a step begins with."""
    elastic, k, first = system.elastic, state.stiffness, state.inner[FIRST]
    floor, inner = system.slack_floor, state.inner[NOW]
    strains(elastic, k, state.rest_length, floor, state.x, inner, first)


@part
def relax(system, state, dt, ledger):
    """Take what segments remember through a step of `dt` [s] that has led to the places in `state`."""
    floor = system.slack_floor
    relax_through(
        system.elastic, state.stiffness, state.rest_length, floor, state.x, state.inner, dt
    )
    if ledger:
        book_heat(system, state, dt)


@part
def relax_while_winding(system, state, dt, ledger):
    """As `relax`, where winches have turned in the step: half of what comes off them before, half after."""
    winding = winds(system, state)
    if winding:
        for j in range(state.inner.shape[1]):
            state.inner[CHANGE, j] = 0.0
        thin_half(system, state, dt, False)
    relax(system, state, dt, False)
    if winding:
        thin_half(system, state, dt, True)
    if ledger:
        book_step(system, state, dt)


@part
def book_step(system, state, dt):
    """Book what was lost in a step of `dt` [s], in which winches may have turned."""
    book_heat(system, state, dt)
    if winds(system, state):
        book_heat_at_drums(system, state, dt)


@deferred()
def relax_through(elastic, stiffness, rest_length, floor, x, inner, dt):
    """Move d, the strain being linear in time; twice, as the strain of a slack one follows it."""
    for j in range(inner.shape[1]):
        if not remembers(elastic, stiffness, j):
            continue
        before, first = inner[NOW, j], inner[FIRST, j]
        strain = (stretched(x, j) - rest_length[j]) / rest_length[j]
        now = before
        for _ in range(2):
            last = held_strain(elastic, j, floor[j], strain, now)
            now = move_of(elastic, j, before, first, last, dt)
        inner[NOW, j], inner[CHANGE, j] = now, now - before


@deferred()
def book_heat(system, state, dt):
    """Book what was lost in a step of `dt` [s], from the change of d in it."""
    elastic, inner, work = system.elastic, state.inner, state.work
    for j in range(inner.shape[1]):
        heat = heat_of(elastic, state.stiffness, state.rest_length, inner[CHANGE, j], j, dt)
        work.friction[j] -= heat
        work.elastic[j] += heat


@deferred("float64")
def heat(elastic, stiffness, rest_length, change, dt):
    """Return what all segments lose in a step of `dt` [J]; `change` (s,) of their d in it [1]."""
    total = 0.0
    for j in range(change.shape[0]):
        total += heat_of(elastic, stiffness, rest_length, change[j], j, dt)
    return total


@deferred("float64")
def heat_at_drums(system, state, inner, dt, back, row):
    """Return how much more the segment at the drum of winch `row` loses in a step of `dt` [J] than of itself.

    That is, than if its d changed by its law alone and its length was that of now. Rows of `inner` as at the
    step's end, `back` [s] the time since its middle.
    """
    j = working_segment(system.winches, state.winch_exit, row)
    total, fresh = growing(system.winches, state.winch_exit, row, state.winch_rate)
    if total == 0.0 and fresh == 0.0:
        return 0.0
    k, lengths, change = state.stiffness, state.rest_length, inner[CHANGE, j]
    mean = lengths[j] - back * total
    moved = change + dt * fresh / mean * (inner[NOW, j] - 0.5 * change)
    booked = heat_of(system.elastic, k, lengths, change, j, dt)
    return heat_of(system.elastic, k, lengths, moved, j, dt) * mean / lengths[j] - booked


@deferred("float64")
def gained_at_drums(system, state, x, ends, dt):
    """Return what a step gives to segments for what has come off drums [J], heat of it taken out.

    Nodes at `x`, (3, n), rows of `State.inner` as at the step's end; rest lengths are the step's mean.
    """
    total = gained_by_mixing(system, state, x, ends, dt)
    for row in range(state.winch_exit.shape[0]):
        total -= heat_at_drums(system, state, ends, dt, 0.0, row)
    return total


@deferred()
def book_heat_at_drums(system, state, dt):
    """Book what the segments at drums have lost besides, rest lengths being those of the step's end."""
    for row in range(state.winch_exit.shape[0]):
        more = heat_at_drums(system, state, state.inner, dt, 0.5 * dt, row)
        j = working_segment(system.winches, state.winch_exit, row)
        state.work.friction[j] -= more
        state.work.elastic[j] += more


@kernel
def next_stage(system, state, x, c, b, first):
    """Bring d to a stage of an explicit Runge-Kutta method, at places `x`.

    It is `c` [s] along the rate of the stage before, of which `first` has none; its own counts for `b` [s].
    """
    inner = state.inner
    for j in range(inner.shape[1]):
        if first:
            inner[FIRST, j], inner[CHANGE, j] = inner[NOW, j], 0.0
        else:
            inner[NOW, j] = inner[FIRST, j] + c * inner[RATE, j]
    write_rates(system, state, x, inner[RATE])
    for j in range(inner.shape[1]):
        inner[CHANGE, j] += b * inner[RATE, j]


@part
def end_stages(system, state, dt, ledger):
    """Bring d to the end of a step of an explicit Runge-Kutta method."""
    inner = state.inner
    for j in range(inner.shape[1]):
        inner[NOW, j] = inner[FIRST, j] + inner[CHANGE, j]
    if ledger:
        book_step(system, state, dt)


# -- implicit methods --------------------------------------------------------------------------


@part
def know_past(state, share, row, known):
    """Write what a stage knows of d, (s,) [1]: now, and `share` of a row of `State.inner`."""
    if state.inner.shape[1] > 0:
        inner = state.inner
        for j in range(known.shape[0]):
            known[j] = inner[NOW, j] + share * inner[row, j]


@part
def know_stages(state, table, s, dt, known_rates, known):
    """Write what stage `s` of a DIRK method knows of d, (s,) [1], from rates (stages, s)."""
    if state.inner.shape[1] > 0:
        for j in range(known.shape[0]):
            total = state.inner[NOW, j]
            for r in range(s):
                total += dt * table[s, r] * known_rates[r, j]
            known[j] = total


@part
def begin_inner(system, state, work, c):
    """Write what stays the same of segments that remember while a stage is solved, d = d^ + c d'."""
    if has_inner(system, state):
        for j in range(work.start.shape[0]):
            work.start[j], work.follow[j] = work.known[j], c
        if winds(system, state):
            thin_stage(system, state, work.start, work.follow)
        _begin(system.elastic, state.stiffness, work)


@deferred()
def _begin(elastic, stiffness, work):
    for j in range(work.free.shape[0]):
        work.free[j] = 0.0
        if remembers(elastic, stiffness, j):
            work.free[j], _ = strain_of(elastic, j, 0.0, work.start[j], work.follow[j])


@part
def end_inner(system, state, work, tension, out):
    """Write d' of a stage that is solved, from its tensions, (s,) [1/s]."""
    if has_inner(system, state):
        k, floor, bounds = state.stiffness, system.slack_floor, system.limiter
        _end(system.elastic, bounds, k, state.rest_length, floor, work, tension, out)
        if winds(system, state):
            thin_solved(system, state, work.start, work.follow, out)


@deferred()
def _end(elastic, limiter, stiffness, rest_length, floor, work, tension, out):
    for j in range(out.shape[0]):
        out[j] = 0.0
        if remembers(elastic, stiffness, j):
            pull = tension[j] / (stiffness[j] * rest_length[j])
            strain, _ = strain_of(elastic, j, pull, work.start[j], work.follow[j])
            if limiter.active == 1:  # its share of the tension stretches nothing
                strain = within(limiter, strain)
                strain = max(strain, work.free[j]) if floor[j] == 0.0 else strain
            out[j] = rate_of(elastic, j, strain, work.start[j], work.follow[j])


@part
def write_ends(state, ends, weights, stage_rates, dt):
    """Write the end of a DIRK step, rows as in `State.inner`, from rates (stages, s)."""
    for j in range(state.inner.shape[1]):
        total = 0.0
        for s in range(weights.shape[0]):
            total += dt * weights[s] * stage_rates[s, j]
        ends[NOW, j] = state.inner[NOW, j] + total
        ends[CHANGE, j], ends[RATE, j] = total, stage_rates[weights.shape[0] - 1, j]


@part
def write_end(state, ends, share, row, c, rate, kept):
    """Write the end of a multistep method's step, rows as in `State.inner`.

    d changes by `share` of a row and `c` [s] of the `rate` (s,) that is kept, which is
    (rate - kept RATE) / (1 - kept): filtered where `kept` is not 0.
    """
    for j in range(state.inner.shape[1]):
        now = (rate[j] - kept * state.inner[RATE, j]) / (1.0 - kept)
        change = share * state.inner[row, j] + c * now
        ends[NOW, j] = state.inner[NOW, j] + change
        ends[CHANGE, j], ends[RATE, j] = change, now


@part
def take_ends(system, state, ends, dt, ledger):
    """Bring d to the end of a step of an implicit method."""
    if has_inner(system, state):
        for j in range(ends.shape[1]):
            for row in range(ends.shape[0]):
                state.inner[row, j] = ends[row, j]
        if ledger:
            book_step(system, state, dt)
