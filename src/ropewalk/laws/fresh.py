"""Rope that comes off a drum remembers nothing: what winches do to the inner strains of segments.

On a drum rope counts as unstrained, and as at rest: its d is 0. Rope that goes on to a drum takes its own d
with it. So the mean d of a segment, which is what its tension follows from, goes by
    d' = f(e, d) - w d,   w = L' / L where rope is paid out, else 0,
f its law's. In a stage, where d = d^ + c d',
    d = d^ / (1 + c w) + c / (1 + c w) f,
so that a law is asked for another d^ and another c. Pieces of other d under the same tension T have stored
more than their mean has: sum L_i (u_i - u - T (e_i - e)) >= 0, as u(e, d) is convex. It is what each would
lose until all are alike, and is booked as friction.
"""

from __future__ import annotations

import math

from ropewalk.core.jit import deferred, part, small
from ropewalk.laws.elastic import CHANGE, NOW, held_strain, pull_of, stored_with, strain_of
from ropewalk.laws.stretch import stretched


@small
def working_segment(winches, exits, row):
    """Return the segment next to the drum of winch `row`."""
    drum = exits[row]
    return drum if winches.step[row] > 0 else drum - 1


@small
def remembers(elastic, stiffness, j):
    """Tell whether segment `j` is there and has a law with a memory."""
    return stiffness[j] > 0.0 and elastic.time[j] < math.inf


@small
def growing(winches, exits, row, rates):
    """Return how fast the working segment of winch `row` grows, and by rope from drums, both [m/s].

    Both ends of a rope may work on one segment: then all is the first winch's, and the others have none.
    """
    j = working_segment(winches, exits, row)
    total, fresh = 0.0, 0.0
    for other in range(exits.shape[0]):
        if working_segment(winches, exits, other) == j:
            if other < row:
                return 0.0, 0.0
            total += rates[other]
            fresh += max(rates[other], 0.0)
    return total, fresh


# -- rates and stages ------------------------------------------------------------------------


@deferred()
def thin_rates(system, state, out):
    """Take the rope that comes off drums into account in d' of segments, (s,) [1/s]."""
    for row in range(state.winch_exit.shape[0]):
        j = working_segment(system.winches, state.winch_exit, row)
        _, fresh = growing(system.winches, state.winch_exit, row, state.winch_rate)
        if fresh > 0.0 and remembers(system.elastic, state.stiffness, j):
            out[j] -= fresh / state.rest_length[j] * state.inner[NOW, j]


@deferred()
def thin_stage(system, state, start, follow):
    """Change d^ and c of a stage, (s,) [1, s], to what laws are asked for."""
    for row in range(state.winch_exit.shape[0]):
        j = working_segment(system.winches, state.winch_exit, row)
        _, fresh = growing(system.winches, state.winch_exit, row, state.winch_rate)
        if fresh > 0.0 and remembers(system.elastic, state.stiffness, j):
            over = 1.0 / (1.0 + follow[j] * fresh / state.rest_length[j])
            start[j] *= over
            follow[j] *= over


@deferred()
def thin_solved(system, state, start, follow, out):
    """Write d' of a stage that is solved, (s,) [1/s], in place of its laws' own."""
    for row in range(state.winch_exit.shape[0]):
        j = working_segment(system.winches, state.winch_exit, row)
        _, fresh = growing(system.winches, state.winch_exit, row, state.winch_rate)
        if fresh > 0.0 and remembers(system.elastic, state.stiffness, j):
            out[j] -= fresh / state.rest_length[j] * (start[j] + follow[j] * out[j])


@deferred()
def thin_half(system, state, dt, last):
    """Let half of what comes off drums in a step of `dt` [s] come, rest lengths being those of its end.

    After `last` the change of d is that of the whole step.
    """
    inner = state.inner
    for row in range(state.winch_exit.shape[0]):
        j = working_segment(system.winches, state.winch_exit, row)
        total, fresh = growing(system.winches, state.winch_exit, row, state.winch_rate)
        if fresh > 0.0 and remembers(system.elastic, state.stiffness, j):
            left = math.exp(-0.5 * dt * fresh / (state.rest_length[j] - 0.5 * dt * total))
            before = (inner[NOW, j] - inner[CHANGE, j]) / left
            inner[NOW, j] *= left
            if last:
                inner[CHANGE, j] = inner[NOW, j] - before


# -- books -----------------------------------------------------------------------------------


@small
def mixed(elastic, j, pull, one, first, other, second):
    """Return d and strain of two pieces of `one` and `other` metres together, and what mixing loses over EA.

    `first` and `second` are their d, and both are pulled with `pull` over EA.
    """
    share = other / (one + other)
    inner = first + share * (second - first)
    strain, _ = strain_of(elastic, j, pull, inner, 0.0)
    _, _, energy = pull_of(elastic, j, strain, inner, 0.0)
    lost = 0.0
    for k in range(2):
        own, length = (first, one) if k == 0 else (second, other)
        e, _ = strain_of(elastic, j, pull, own, 0.0)
        _, _, stored = pull_of(elastic, j, e, own, 0.0)
        lost += length * (stored - energy - pull * (e - strain))
    return inner, strain, max(lost, 0.0)


@small
def pull_at(elastic, j, floor, strain, inner):
    """Return the pull of segment `j` over EA, and the strain of what it is made of [1]."""
    held = held_strain(elastic, j, floor[j], strain, inner)
    pull, _, _ = pull_of(elastic, j, held, inner, 0.0)
    return (max(pull, 0.0) if floor[j] == 0.0 else pull), held


@deferred()
def book_loss(system, state, j, loss):
    """Book what segment `j` has lost [J] as its friction, and not as what its spring did."""
    state.work.friction[j] -= loss
    state.work.elastic[j] += loss


@deferred()
def book_wound(system, state, j, r, inner, wound):
    """Book the work of winding `wound` m of rope at segment `j`, of length `r` [m] and mean d `inner`.

    What comes off a drum is strained to the segment's tension, which pulls at it: u - (1 + e) T.
    """
    elastic, length = system.elastic, state.rest_length[j]
    EA = state.stiffness[j] * length
    pull, strain = pull_at(elastic, j, system.slack_floor, (r - length) / length, inner)
    if wound > 0.0:
        _, _, loss = mixed(elastic, j, pull, length, inner, wound, 0.0)
        book_loss(system, state, j, EA * loss)
        strain, _ = strain_of(elastic, j, pull, 0.0, 0.0)
        inner = 0.0
    _, _, energy = pull_of(elastic, j, strain, inner, 0.0)
    state.work.winch[1] += EA * wound * (energy - (1.0 + strain) * pull)


@deferred()
def mix_in(system, state, j, wound):
    """Put `wound` m of rope from a drum to segment `j` at once, before its rest length follows."""
    if wound > 0.0 and remembers(system.elastic, state.stiffness, j):
        length, inner = state.rest_length[j], state.inner
        strain = (stretched(state.x, j) - length) / length
        pull, _ = pull_at(system.elastic, j, system.slack_floor, strain, inner[NOW, j])
        found, _, loss = mixed(system.elastic, j, pull, length, inner[NOW, j], wound, 0.0)
        inner[NOW, j] = found
        loss *= state.stiffness[j] * length
        book_loss(system, state, j, loss)
        state.work.winch[1] += loss  # what is stored is less by it, and that is all its work else


@deferred("float64")
def mix_segments(system, state, working, following, merged):
    """Let `following` remember what both do, under the tension of `working`; return their rest length [m].

    `merged` [m] is the length that is left of them.
    """
    elastic, inner = system.elastic, state.inner
    one, other = state.rest_length[working], state.rest_length[following]
    strain = (stretched(state.x, working) - one) / one
    pull, _ = pull_at(elastic, working, system.slack_floor, strain, inner[NOW, working])
    first, second = inner[NOW, working], inner[NOW, following]
    found, strain, loss = mixed(elastic, following, pull, one, first, other, second)
    loss *= state.stiffness[working] * one
    book_loss(system, state, following, loss)
    state.work.winch[1] += loss
    for k in range(inner.shape[0]):
        inner[k, following], inner[k, working] = 0.0, 0.0
    inner[NOW, following] = found
    return merged / (1.0 + strain) if pull > 0.0 else one + other


@part
def split_memory(state, working, new):
    """Let a segment that is split off remember what `working` does."""
    for k in range(state.inner.shape[0]):
        state.inner[k, new] = state.inner[k, working]


@deferred("float64")
def gained_by_mixing(system, state, x, ends, dt):
    """Return what segments store more for the rope that has come off drums in a step [J], d alone.

    Nodes at `x`, (3, n), and rows of `State.inner` as at its end; rest lengths are the step's mean.
    """
    total = 0.0
    for row in range(state.winch_exit.shape[0]):
        j = working_segment(system.winches, state.winch_exit, row)
        _, fresh = growing(system.winches, state.winch_exit, row, state.winch_rate)
        if fresh > 0.0 and remembers(system.elastic, state.stiffness, j):
            length, k, floor = state.rest_length[j], state.stiffness[j], system.slack_floor[j]
            strain, now = (stretched(x, j) - length) / length, ends[NOW, j]
            gone = dt * fresh / length * (now - 0.5 * ends[CHANGE, j])
            total += stored_with(system.elastic, j, length, k, floor, strain, now)
            total -= stored_with(system.elastic, j, length, k, floor, strain, now + gone)
    return total
