"""What islands have in arrays of their own, one after another: carried to the whole's and back at once."""

from __future__ import annotations

from collections.abc import Sequence
from itertools import pairwise
from typing import NamedTuple

import numpy as np

from ropewalk.core.arrays import Floats, Ints, State
from ropewalk.engine.contact_rows import Rows
from ropewalk.engine.places import OwnLinks, start_in
from ropewalk.laws.pairs.table import CONTACTS, NEAR, WIDTH

SUMS = ("limiter", "winch")  # works of all ropes together


class Told(NamedTuple):
    """What the whole was told last, to see what others have changed since."""

    values: Ints
    sums: list[Floats]
    begins: bool  # whether the methods of all islands begin anew
    now: Floats
    rows: Rows


class Carried:
    """The numbers of all islands in one array, and where they are in the whole's."""

    def __init__(
        self,
        pools: Sequence[Floats],
        links: Sequence[OwnLinks],
        states: Sequence[State],
        there: Sequence[Ints],
    ) -> None:
        """Take up islands by their pools, links to the whole's, states in these pools, and segments there."""
        self._pools, self._sea = pools, np.zeros(sum(pool.size for pool in pools))
        ends = np.cumsum([0] + [pool.size for pool in pools])
        self._rooms = [slice(*pair) for pair in pairwise(ends.tolist())]
        counts = np.cumsum([0] + [one.there.size for one in links])
        self.there = np.concatenate([one.there for one in links])
        own = zip(links, ends.tolist(), strict=False)
        self._own = np.concatenate([one.own + first for one, first in own])
        indices = zip(links, counts.tolist(), strict=False)
        self._indices = np.concatenate([one.indices + first for one, first in indices])
        self._moved = np.concatenate([one.moved for one in links])
        self._sums = {
            name: self._places([getattr(one.work, name) for one in states]) for name in SUMS
        }
        self._past = self._places([one.past for one in states])[:, 0]
        self._now = self._places([one.now for one in states])
        self._touching = states[0].memory.contact.tally.size > 0
        contacts = [one.memory.contact for one in states]
        self._tally = self._places([one.tally for one in contacts])
        self._books = self._places([one.books for one in contacts])
        self._firsts = {
            name: self._first([getattr(one, name) for one in contacts])
            for name in ("pair", "grip", "near")
        }
        self._there = np.concatenate(there)
        self._begins = np.cumsum([0] + [part.size for part in there])[:-1]

    def _first(self, arrays: Sequence[Floats | Ints]) -> Ints:
        """Return where an array of each island begins."""
        parts = zip(self._rooms, arrays, self._pools, strict=True)
        return np.array([room.start + start_in(array, pool) for room, array, pool in parts])

    def _places(self, arrays: Sequence[Floats]) -> Ints:
        """Return where the numbers of an array of each island are, (k, m)."""
        return self._first(arrays)[:, None] + np.arange(arrays[0].size)

    def take_up(self) -> None:
        """Take up what the islands have now."""
        np.concatenate(self._pools, out=self._sea)

    def values(self) -> Ints:
        """Return the numbers that were taken up as the whole has them."""
        values = self._sea.view(np.int64).take(self._own)
        values[self._indices] += np.where(values[self._indices] < 0, 0, self._moved)
        return values

    def hand_out(self, values: Ints) -> None:
        """Let the islands have the whole's numbers."""
        self.take_up()
        values = values.copy()
        values[self._indices] -= np.where(values[self._indices] < 0, 0, self._moved)
        self._sea.view(np.int64)[self._own] = values
        for pool, room in zip(self._pools, self._rooms, strict=True):
            pool[:] = self._sea[room]

    def tell(self, whole: State) -> Told:
        """Write into the whole's state what it has of all together; return what it is told in all."""
        sums = [self._added(self._sums[name]) for name in SUMS]
        for name, total in zip(SUMS, sums, strict=True):
            getattr(whole.work, name)[...] = total
        past = self._sea[self._past]
        whole.past[0] = past.max()
        whole.now[:] = self._sea[self._now].max(axis=0)
        return Told(self.values(), sums, not past.any(), whole.now.copy(), self.rows())

    def _added(self, places: Ints) -> Floats:
        """Return the sums over all islands, added up in their order."""
        total: Floats = np.add.accumulate(self._sea[places], axis=0)[-1] + 0.0
        return total

    def rows(self) -> Rows:
        """Return the rows of all contacts that were taken up, by the segments of the whole."""
        whole = self._sea.view(np.int64)
        tallies = whole[self._tally]
        tally = tallies.max(axis=0)
        if not self._touching:
            none = np.zeros((0, 2), np.int64)
            return Rows(none, np.zeros((0, WIDTH)), none, tally, np.zeros(0))
        contacts, near = tallies[:, CONTACTS], tallies[:, NEAR]
        tally[[CONTACTS, NEAR]] = contacts.sum(), near.sum()
        pair, listed = self._pairs("pair", contacts), self._pairs("near", near)
        owner, row = _counted(contacts)
        places = (self._firsts["grip"][owner] + WIDTH * row)[:, None] + np.arange(WIDTH)
        grip = self._sea[places]
        order = np.lexsort((pair[:, 1], pair[:, 0]))
        books = np.add.accumulate(self._sea[self._books], axis=0)[-1]
        return Rows(pair[order], grip[order], listed, tally, books)

    def _pairs(self, name: str, counts: Ints) -> Ints:
        """Return pairs of segments by their numbers in the whole, (c, 2)."""
        owner, row = _counted(counts)
        places = (self._firsts[name][owner] + 2 * row)[:, None] + np.arange(2)
        own = self._sea.view(np.int64)[places]
        pairs: Ints = self._there[self._begins[owner][:, None] + own]
        return pairs

    def is_told(self, told: Told | None, whole: State, values: Ints) -> bool:
        """Tell whether the whole has what it was told, but for rows of contacts."""
        if told is None or not np.array_equal(values, told.values):
            return False
        pairs = zip(SUMS, told.sums, strict=True)
        same = all(np.array_equal(getattr(whole.work, name), total) for name, total in pairs)
        anew = whole.past[0] == 0.0 and not told.begins
        return same and not anew and np.array_equal(whole.now, told.now)


def _counted(counts: Ints) -> tuple[Ints, Ints]:
    """Return the owners of rows of which each has so many, and the numbers of rows there."""
    owner = np.repeat(np.arange(counts.size), counts)
    row = np.arange(owner.size) - np.repeat(np.cumsum(counts) - counts, counts)
    return owner, row
