"""What an island that has come from several begins with, and what the whole has of all together."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any, NamedTuple

import numpy as np

from ropewalk.core.arrays import Floats, Ints, State, System
from ropewalk.core.status import HONEST, LAST, SEEN, TAKEN, ZERO
from ropewalk.engine.engine import Engine
from ropewalk.engine.pressed import join_pressed
from ropewalk.engine.shares import PEAKS_OF_SEGMENTS, Share, best_of
from ropewalk.laws.pairs.swept import HELD_WIDTH, place_boxes, place_held
from ropewalk.methods.controller import (
    ACCEPTED,
    BEFORE,
    BEGUN,
    LONGEST,
    REJECTED,
    SHORTEST,
    WISH,
    make_control,
)
from ropewalk.methods.loop import nodes_out
from ropewalk.methods.part_lengths import LENGTH

Whose = tuple[Engine, Share]


class Among(NamedTuple):
    """Where a part's nodes and anchors lie in the island."""

    nodes: Ints
    anchors: Ints


def join_own(new: Engine, share: Share, parts: Sequence[Whose]) -> None:
    """Write what is of all ropes together, from those of the parts; the rest stands already."""
    state, states = new.state, [engine.state for engine, _ in parts]
    for name in ("limiter", "winch"):
        getattr(state.work, name)[...] = sum(getattr(one.work, name) for one in states)
    state.now[:] = np.max([one.now for one in states], axis=0)
    state.jolt[:] = np.max([one.jolt for one in states], axis=0)
    _join_past(state, states)
    rows = np.argsort(np.concatenate([own.anchors for _, own in parts]), kind="stable")
    state.most[:-1] = np.concatenate([one.most[:-1] for one in states])[rows]
    state.most[-1] = sum(one.most[-1] for one in states)
    balance = np.sum([one.balance for one in states], axis=0)
    state.balance[[ZERO, LAST, TAKEN]] = balance[[ZERO, LAST, TAKEN]]
    state.balance[SEEN] = max(one.balance[SEEN] for one in states)
    more = new.energy_scale() - sum(engine.energy_scale() for engine, _ in parts)
    state.balance[HONEST] = balance[HONEST] + more
    _join_peaks(state, share, parts)
    if new.walk.control.size:
        _join_walks(new, [engine for engine, _ in parts])


def _join_past(state: State, states: Sequence[State]) -> None:
    """Let a multistep method go on where it would in all parts, else begin anew."""
    past = np.array([one.past for one in states])
    goes = all(
        one.past[0] == past[0, 0]
        and one.past[1] == one.held.sum()
        and one.past[2] == nodes_out(one.winch_exit)
        for one in states
    )
    shortest = np.argmin(np.where(past[:, LENGTH] > 0.0, past[:, LENGTH], np.inf))
    state.past[:] = past[shortest]
    state.past[0] = past[0, 0] if goes else 0.0
    state.past[1:3] = state.held.sum(), nodes_out(state.winch_exit)


def _join_peaks(state: State, share: Share, parts: Sequence[Whose]) -> None:
    """Let what was seen in the parts since the interval began be seen."""
    peaks = state.peaks
    if not peaks.speed.size:
        return
    own = np.full(share.nodes.max() + 1, -1)
    own[share.nodes] = np.arange(share.nodes.size)
    held = {row: k for k, row in enumerate(share.anchors.tolist())}
    each = list[tuple[list[Any], Floats]]()
    for engine, part in parts:
        seen = engine.state.peaks
        for name in PEAKS_OF_SEGMENTS:
            getattr(peaks, name)[own[part.segments]] = getattr(seen, name)[part.own_segments]
        for name in ("speed", "high", "low"):
            getattr(peaks, name)[own[part.nodes]] = getattr(seen, name)
        rows = [held[row] for row in part.anchors.tolist()]
        peaks.reaction[rows] = seen.reaction
        if seen.moment.size:
            peaks.moment[rows] = seen.moment
        each.append(([Among(own[part.nodes], np.array(rows, np.int64))], seen.found[None].copy()))
    peaks.found[:] = best_of(each, np.arange(len(parts)))
    places = [np.searchsorted(share.bodies, part.bodies) for _, part in parts]
    join_pressed(
        state, [(engine.state, rows) for (engine, _), rows in zip(parts, places, strict=True)]
    )
    first = parts[0][0].state.peaks
    peaks.looked[:] = first.looked
    peaks.error[:, 0] = sum(engine.state.peaks.error[:, 0] for engine, _ in parts)
    peaks.error[:, 1] = first.error[:, 1]
    peaks.error_zero[:] = sum(engine.state.peaks.error_zero for engine, _ in parts)


def _join_walks(new: Engine, engines: Sequence[Engine]) -> None:
    """Let the adaptive method walk on from the state that is shown, with the steps of all counted.

    Its next step is as long as the shortest one that any wishes for.
    """
    control, own = new.walk.control, np.array([engine.walk.control for engine in engines])
    control[:] = make_control()
    control[ACCEPTED], control[REJECTED] = own[:, ACCEPTED].sum(), own[:, REJECTED].sum()
    control[SHORTEST], control[LONGEST] = own[:, SHORTEST].min(), own[:, LONGEST].max()
    shortest = np.argmin(own[:, WISH])  # 0: one has none yet
    control[WISH], control[BEFORE] = own[shortest, WISH], own[shortest, BEFORE]
    control[BEGUN] = 0.0


def begin_boxes(engine: Engine) -> None:
    """Let the boxes of an island's ropes begin anew where they are, in all that its method walks on from."""
    system, state, walk = engine.system, engine.state, engine.walk
    if not walk.control.size:
        _begin_at(system, state, state)
        return
    scratch: Any = engine.scratch
    known = np.array_equal(scratch.here.view(np.int64), walk.shown.view(np.int64))
    _begin_at(system, state, state)
    # what is ahead of the frame was walked in one step from `begin`
    _begin_at(system, scratch.ahead, scratch.begin)
    _begin_at(system, scratch.begin, scratch.begin)
    if known:
        walk.shown[:] = scratch.here


def begin_all_boxes(engines: Sequence[Engine]) -> None:
    """Let the boxes of all islands begin anew where they are."""
    for engine in engines:
        begin_boxes(engine)


def _begin_at(system: System, state: State, other: State) -> None:
    """Let a state's boxes begin anew where it is, and straight on to another one."""
    radius, memory = system.node.contact.radius, state.memory.contact
    swept = memory.swept
    if radius.size:
        place_boxes(state.x, other.x, state.stiffness, radius, swept, memory.hull)
    if swept.shape[1] == HELD_WIDTH:
        place_held(state.x, state.v, other.x, other.v, swept)


def spread_sums(whole: State, states: Sequence[State]) -> None:
    """Take up in islands what the whole has of all together: the first one gets what is more."""
    for name in ("limiter", "winch"):
        more = getattr(whole.work, name) - sum(getattr(one.work, name) for one in states)
        getattr(states[0].work, name)[...] += more
    latest = np.max([one.now for one in states], axis=0)
    for one in states:
        if whole.past[0] == 0.0:  # a multistep method is to begin anew
            one.past[0] = 0.0
        if not np.array_equal(whole.now, latest):
            one.now[:] = whole.now
