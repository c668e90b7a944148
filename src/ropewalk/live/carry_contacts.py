"""Carrying what contacts of ropes hold over into another scene: of pairs of segments that are there still."""

from __future__ import annotations

import numpy as np

from ropewalk.core.arrays import Floats, Ints, State, assign
from ropewalk.laws.pairs.search import NOWHERE, note_ropes
from ropewalk.laws.pairs.swept import FROM
from ropewalk.laws.pairs.table import (
    APART,
    CONTACTS,
    LEVER,
    NORMAL,
    OTHER,
    OWN,
    SPRING,
    Memory,
    Pairs,
)
from ropewalk.simulation import Simulation


def carry_contacts(old: Simulation, made: Simulation, state: State, source: Floats) -> None:
    """Keep what contacts hold between segments that are there still: friction, offsets, and the books.

    Those of segments that are new are as they were found where these lie now. `state` is that of `made`, and
    `source` says for every node of it where it was, (nodes,), fractional between two.
    """
    table, kept, now = made.system.node.contact, old.arrays.memory.contact, state.memory.contact
    if not (kept.pair.size and now.pair.size):
        return
    fresh = rows_of(now)
    whole = source == np.floor(source)
    nodes = source[whole].astype(np.int64)
    alike = kept.pair.shape == now.pair.shape and kept.inside.shape == now.inside.shape
    alike = alike and np.array_equal(kept.swept[:, FROM:], now.swept[:, FROM:])
    if alike and np.array_equal(source, np.arange(old.arrays.x.shape[1])):
        assign(now, kept)
    now.way[:, whole], now.books[...] = kept.way[:, nodes], kept.books
    segments = segments_of(source, table, state.stiffness)
    pair, grip = moved_rows(kept, segments)
    there = np.isin(np.arange(len(table.rope)), segments)
    new = ~there[fresh[0]].all(axis=1)
    pair, grip = np.concatenate([pair, fresh[0][new]]), np.concatenate([grip, fresh[1][new]])
    order = np.lexsort((pair[:, 1], pair[:, 0]))[: len(now.pair)]
    now.pair[: len(order)], now.grip[: len(order)] = pair[order], grip[order]
    now.tally[CONTACTS] = len(order)
    now.origin[0, 0] = NOWHERE  # who is near is found anew: radii may have changed
    note_ropes(table, now, state.stiffness)  # a cut makes two of one


def rows_of(memory: Memory) -> tuple[Ints, Floats]:
    """Return copies of the segments and of what is held of all contacts."""
    count = int(memory.tally[CONTACTS])
    return memory.pair[:count].copy(), memory.grip[:count].copy()


def segments_of(source: Floats, table: Pairs, stiffness: Floats) -> Ints:
    """Return for every old segment which one it is now, -1 where it is gone, or no rope any more."""
    found = np.full(int(source.max(initial=0.0)) + 2, -1, np.int64)
    low = np.floor(source[:-1])
    same = (source[:-1] == low) & (np.diff(source) == 1.0) & (table.rope >= 0) & (stiffness > 0.0)
    found[low[same].astype(np.int64)] = np.flatnonzero(same)
    return found


def moved_rows(kept: Memory, segments: Ints) -> tuple[Ints, Floats]:
    """Return the contacts between segments that are there still, with their new numbers, the lesser first."""
    pair, grip = rows_of(kept)
    pair = np.where(pair < len(segments), segments[np.minimum(pair, len(segments) - 1)], -1)
    there = (pair >= 0).all(axis=1)
    pair, grip = pair[there], grip[there]
    back = pair[:, 0] > pair[:, 1]
    turned = grip[back]
    for first in (NORMAL, SPRING, APART):
        turned[:, first : first + 3] *= -1.0
    turned[:, [OWN, OTHER]] = turned[:, [OTHER, OWN]]
    turned[:, LEVER : LEVER + 6] = np.roll(turned[:, LEVER : LEVER + 6], 3, axis=1)
    grip[back] = turned
    return np.sort(pair, axis=1), grip
