"""What a frame holds of the surfaces that ropes touch: obstacles one after another, then ropes on ropes."""

from __future__ import annotations

from ropewalk.core.arrays import State
from ropewalk.core.jit import part
from ropewalk.laws.contact_books import ENTRIES, record_books
from ropewalk.laws.pairs.pair_books import record_pair_books
from ropewalk.laws.wheel_rows import RECORDED
from ropewalk.laws.wheels import record_wheels


def surface_shapes(state: State) -> list[tuple[int, int]]:
    """Return the shapes of the books of obstacles and of ropes on ropes, and of what turns freely."""
    of_ropes = min(len(getattr(state.memory.contact, "books", ())), 1)
    count = len(getattr(state.memory.obstacle, "books", ())) + of_ropes
    wheels = len(getattr(state.memory.obstacle, "wheel", ()))
    return [(count, len(ENTRIES)), (wheels, len(RECORDED))]


@part
def record_turning(system, state, out):
    """Write how what turns freely does so, (w, 7)."""
    if system.rare is not None:
        record_wheels(system.node.obstacle.inertia, state.memory.obstacle.wheel, out)


@part
def record_surfaces(system, state, out):
    """Write what obstacles, and ropes on ropes, have given and taken [J], (k, 5)."""
    if system.rare is None:
        return
    books = state.memory.obstacle.books
    record_books(books, out)
    if out.shape[0] > books.shape[0]:
        record_pair_books(state.x, system.node.contact, state.memory.contact, out[books.shape[0]])
