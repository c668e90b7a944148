"""What a frame holds of the surfaces that ropes touch: obstacles one after another, then ropes on ropes."""

from __future__ import annotations

from ropewalk.core.arrays import State
from ropewalk.core.jit import part
from ropewalk.laws.contact_books import record_books
from ropewalk.laws.pairs.pair_books import record_pair_books


def count_surfaces(state: State) -> int:
    """Return how many obstacles there are, and one more where ropes touch ropes."""
    of_ropes = min(len(getattr(state.memory.contact, "books", ())), 1)
    return len(getattr(state.memory.obstacle, "books", ())) + of_ropes


@part
def record_surfaces(system, state, out):
    """Write what obstacles, and ropes on ropes, have given and taken [J], (k, 5)."""
    if system.rare is None:
        return
    books = state.memory.obstacle.books
    record_books(books, out)
    if out.shape[0] > books.shape[0]:
        record_pair_books(state.x, system.node.contact, state.memory.contact, out[books.shape[0]])
