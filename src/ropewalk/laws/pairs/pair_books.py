"""The books of ropes that touch each other: what presses and what rubs apart, see `laws.contact_books`."""

from __future__ import annotations

from ropewalk.core.jit import deferred, kernel
from ropewalk.laws.pairs.force import pair_energy
from ropewalk.laws.pairs.table import CONTACTS, LIFTED, SPRING, STIFF


@deferred()
def book_pairs(memory, force, middle, dt):
    """Book a step's works: of its mean forces, `middle` the mean of the speeds at its ends, (3, n)."""
    way, books = memory.way, memory.books
    if force.shape[0] < 6:
        return
    for k in range(3):
        for i in range(way.shape[1]):
            f, q, d = force[k, i], force[3 + k, i], way[k, i]
            books[0] += (f - q) * d
            books[1] += q * d
            books[2] += f * (dt * middle[k, i] - d)


@kernel
def rubbed_energy(memory):
    """Return what the springs of friction have stored [J]."""
    total, grip = 0.0, memory.grip
    for row in range(memory.tally[CONTACTS]):
        if grip[row, STIFF] > 0.0:
            square = 0.0
            for k in range(3):
                square += grip[row, SPRING + k] ** 2
            total += 0.5 * square / grip[row, STIFF]
    return total


@deferred()
def record_pair_books(x, table, memory, out):
    """Write the entries of all ropes on ropes, (5,) [J]; see `contact_books.ENTRIES`."""
    pressed, rubbed = pair_energy(x, table, memory), rubbed_energy(memory)
    lifted = memory.books[LIFTED]
    out[0], out[1], out[2] = lifted, memory.books[0] + pressed - lifted, memory.books[1] + rubbed
    out[3], out[4] = -pressed - rubbed, memory.books[2]
