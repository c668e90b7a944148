"""What contacts remember, between the arrays of a whole and those of its parts.

Their rows are of pairs of segments, sorted and counted, so that no table of places says which are which.
"""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

from ropewalk.core.arrays import Floats, Ints
from ropewalk.laws.pairs.search import NOWHERE
from ropewalk.laws.pairs.table import CONTACTS, FAULT, FULL, NEAR, SEEN, Memory, Pairs


class Rows(NamedTuple):
    """The rows that count, and what is added up."""

    pair: Ints  # (c, 2)
    grip: Floats  # (c, WIDTH)
    near: Ints  # (d, 2)
    tally: Ints  # (10,)
    books: Floats  # (4,) [J]


def rows_of(memory: Memory) -> Rows:
    """Return the rows of a memory; none where ropes do not touch each other."""
    if not memory.tally.size:
        return Rows(memory.pair, memory.grip, memory.near, memory.tally, memory.books)
    count, near = memory.tally[CONTACTS], memory.tally[NEAR]
    return Rows(
        memory.pair[:count],
        memory.grip[:count],
        memory.near[:near],
        memory.tally,
        memory.books,
    )


def joined_rows(parts: list[Memory], segments: list[Ints]) -> Rows:
    """Return the rows of several memories as one; `segments` are those of each by their numbers there."""
    each = [rows_of(memory) for memory in parts]
    if not each[0].tally.size:
        return each[0]
    pair = np.concatenate([own[rows.pair] for own, rows in zip(segments, each, strict=True)])
    near = np.concatenate([own[rows.near] for own, rows in zip(segments, each, strict=True)])
    order = np.lexsort((pair[:, 1], pair[:, 0]))
    grip = np.concatenate([rows.grip for rows in each])[order]
    tally = np.max([rows.tally for rows in each], axis=0)
    tally[[CONTACTS, NEAR]] = len(pair), len(near)
    books = np.add.accumulate([rows.books for rows in each], axis=0)[-1]
    return Rows(pair[order], grip, near, tally, books)


def rows_among(rows: Rows, own: Ints) -> Rows:
    """Return those between segments of a part; `own` (s,) are their numbers in it, -1 of all others.

    With the books of all: whose works they are is not known.
    """
    pair, near = own[rows.pair], own[rows.near]
    here, listed = (pair >= 0).all(axis=1), (near >= 0).all(axis=1)
    tally = rows.tally.copy()
    tally[[CONTACTS, NEAR]] = here.sum(), listed.sum()
    return Rows(pair[here], rows.grip[here], near[listed], tally, rows.books)


def write_rows(rows: Rows, table: Pairs, memory: Memory, stiffness: Floats) -> None:
    """Let a memory have these rows; who else is near is found anew. Too many are a fault."""
    if not memory.tally.size:
        return
    room, listed = len(memory.pair), len(memory.near)
    count, near = min(len(rows.pair), room), min(len(rows.near), listed)
    memory.pair[:count], memory.grip[:count] = rows.pair[:count], rows.grip[:count]
    memory.near[:near] = rows.near[:near]
    memory.tally[:] = rows.tally
    memory.tally[[CONTACTS, NEAR]] = count, near
    if count < len(rows.pair):
        memory.tally[FAULT] = FULL
    memory.books[:] = rows.books
    memory.rope[:] = np.where(stiffness > 0.0, table.rope, -1)
    memory.origin[:] = NOWHERE
    memory.tree[:] = 0.0
    memory.order[:] = np.arange(len(memory.order))


def differ(one: Rows, other: Rows) -> bool:
    """Tell whether contacts hold something else in some rows than in others."""
    if not one.tally.size:
        return False
    if one.tally[SEEN] != other.tally[SEEN] or len(one.pair) != len(other.pair):
        return True
    parts = ("pair", "grip", "books")
    return any(getattr(one, name).tobytes() != getattr(other, name).tobytes() for name in parts)
