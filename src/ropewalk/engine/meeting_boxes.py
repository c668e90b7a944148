"""Which islands have come within reach of each other: by the boxes that contacts keep of ropes' ways."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING

import numpy as np

from ropewalk.core.arrays import Floats, Ints, State, System
from ropewalk.laws.pairs.swept import FROM, HIGH, LOW, TO
from ropewalk.laws.pairs.table import REACH
from ropewalk.methods.verdict import LARGEST

if TYPE_CHECKING:
    from ropewalk.engine.engine import Engine

CANDIDATES = 1 << 20  # pairs of boxes that are looked at at once
NEAR = 7  # beside `core.status`: in a call of many frames some came near, it is to be of one frame
RUN = 16  # boxes that are looked at as one first


def boxes_at(system: System, state: State, *more: State) -> Floats:
    """Return the boxes of all runs of rope where a state stands, (k, 6) [m], and straight on to `more`."""
    table, memory = system.node.contact, state.memory.contact
    runs, ends = memory.swept[:, FROM].astype(np.int64), memory.swept[:, TO].astype(np.int64)
    wide, there = REACH * table.radius, state.stiffness > 0.0
    if not wide.size:  # they touch no others: nodes that have parted from all count, too
        wide = np.zeros(there.size)
        begun = np.bincount(runs, minlength=there.size + 1)
        there = np.cumsum(begun - np.bincount(ends + 1, minlength=there.size + 1))[:-1] > 0
    low, high = np.full((3, wide.size), np.inf), np.full((3, wide.size), -np.inf)
    for one in (state, *more):
        low = np.minimum(low, np.minimum(one.x[:, :-1], one.x[:, 1:]) - wide)
        high = np.maximum(high, np.maximum(one.x[:, :-1], one.x[:, 1:]) + wide)
    low[:, ~there], high[:, ~there] = np.inf, -np.inf
    boxes = (np.minimum.reduceat(low, runs, axis=1), np.maximum.reduceat(high, runs, axis=1))
    return np.concatenate(boxes).T


def been(engines: Sequence[Engine]) -> tuple[Floats, Ints]:
    """Return the boxes of where the ropes of islands have been (k, 6) [m], and of which island each is."""
    tables = [engine.system.node.contact for engine in engines]
    memories = [engine.state.memory.contact for engine in engines]
    nodes = [one.place.shape[1] for one in memories]
    counts, first = [len(one.swept) for one in memories], np.cumsum([0, *nodes[:-1]])
    swept, owners = (
        np.concatenate([one.swept for one in memories]),
        np.repeat(np.arange(len(counts)), counts),
    )
    wide = REACH * np.concatenate([np.append(one.radius, 0.0) for one in tables])[:-1]
    there = np.concatenate([np.append(one.rope, -1) for one in memories])[:-1] >= 0
    hull = np.concatenate([one.hull for one in memories], axis=1)
    low = np.minimum(hull[:3, :-1], hull[:3, 1:]) - wide
    high = np.maximum(hull[3:, :-1], hull[3:, 1:]) + wide
    low[:, ~there], high[:, ~there] = np.inf, -np.inf
    runs = swept[:, FROM].astype(np.int64) + first[owners]
    lowest = np.minimum(swept[:, LOW:HIGH], np.minimum.reduceat(low, runs, axis=1).T)
    highest = np.maximum(swept[:, HIGH:FROM], np.maximum.reduceat(high, runs, axis=1).T)
    return np.hstack([lowest, highest]), owners


def meeting(boxes: Floats, owners: Ints) -> set[tuple[int, int]]:
    """Return which owners of boxes (k, 6) have some that overlap, as pairs, the lesser number first.

    Boxes about up to RUN neighbours decide who is looked at one by one.
    """
    if not len(boxes):
        return set()
    place, begins = np.arange(len(boxes)), np.diff(owners, prepend=owners[0]) != 0
    first = np.flatnonzero((place - np.maximum.accumulate(place * begins)) % RUN == 0)
    low = np.minimum.reduceat(boxes[:, LOW:HIGH], first)
    high = np.maximum.reduceat(boxes[:, HIGH:FROM], first)
    pairs = _overlapping(np.hstack([low, high]), owners[first])
    near = np.isin(owners, [owner for pair in pairs for owner in pair])
    return _overlapping(boxes[near], owners[near])


def _overlapping(boxes: Floats, owners: Ints) -> set[tuple[int, int]]:
    """Return what `meeting` does, by all boxes."""
    there = np.flatnonzero((boxes[:, LOW:HIGH] <= boxes[:, HIGH:FROM]).all(axis=1))
    corners = np.clip(boxes[there], -LARGEST, LARGEST)  # of what has burst they may be infinite
    middles = corners[:, LOW:HIGH] + corners[:, HIGH:FROM]
    axis = int(np.argmax(np.ptp(middles, axis=0))) if there.size else 0
    there = there[np.argsort(boxes[there, axis], kind="stable")]
    boxes, owners = boxes[there], owners[there]
    last = np.searchsorted(boxes[:, axis], boxes[:, HIGH + axis], side="right")
    counts = last - np.arange(1, len(boxes) + 1)
    ends, found, first = np.cumsum(counts), set[tuple[int, int]](), 0
    while first < len(boxes):
        before = int(ends[first - 1]) if first else 0
        to = max(int(np.searchsorted(ends, before + CANDIDATES)), first + 1)
        rows = np.repeat(np.arange(first, to), counts[first:to])
        starts = np.repeat(ends[first:to] - counts[first:to] - before, counts[first:to])
        others = rows + 1 + np.arange(rows.size) - starts
        apart = owners[rows] != owners[others]
        rows, others = rows[apart], others[apart]
        low, high = boxes[:, LOW:HIGH], boxes[:, HIGH:FROM]
        touch = (low[rows] <= high[others]) & (low[others] <= high[rows])
        rows, others = rows[touch.all(axis=1)], others[touch.all(axis=1)]
        pairs = np.sort(np.stack([owners[rows], owners[others]], axis=1), axis=1)
        found |= {(int(a), int(b)) for a, b in np.unique(pairs, axis=0)}
        first = to
    return found


def joined(groups: list[tuple[int, ...]], pairs: set[tuple[int, int]]) -> list[tuple[int, ...]]:
    """Return groups of ropes of which some pairs, by their numbers, are one now, with all that those meet."""
    lead = list(range(len(groups)))

    def first(k: int) -> int:
        while lead[k] != k:
            lead[k] = k = lead[lead[k]]
        return k

    for a, b in pairs:
        a, b = sorted((first(a), first(b)))
        lead[b] = a
    found: dict[int, list[int]] = {}
    for k, group in enumerate(groups):
        found.setdefault(first(k), []).extend(group)
    return sorted(tuple(sorted(ropes)) for ropes in found.values())
