"""What ropes touch, as contacts have it at the end of a frame's last step: ropes, and obstacles apart."""

from __future__ import annotations

import numpy as np

from ropewalk.core.arrays import Floats, State, System
from ropewalk.core.ranges import ALL
from ropewalk.laws.contact import contact_forces
from ropewalk.laws.pairs.table import CONTACTS, NORMAL, OTHER, OWN, PUSH, SPRING
from ropewalk.methods.recording import Recording

#: Columns of a contact: its segments, where it lies on each (0 to 1), R_n [N], the force on the first [N].
COLUMNS = ("first", "second", "at_first", "at_second", "normal_force", "fx", "fy", "fz")
SLOTS, SPARE = 2, 16  # contacts that a frame has room for, per segment and besides


def slots(segments: int) -> int:
    """Return how many contacts a frame has room for: the strongest are kept."""
    return SLOTS * segments + SPARE


def rope_contacts(state: State, frames: int = 1) -> Floats | None:
    """Return the contacts that carry something, (1, slots, 8), NaN behind them; None without contact.

    (0, slots, 8) where there are no `frames`.

    The force is that at the end of the last step: its friction is what the contact remembers, without the
    damper, cut to mu R_n. Nothing has been carried before the first step.
    """
    memory = state.memory.contact
    if not memory.tally.size:
        return None
    grip = memory.grip[: memory.tally[CONTACTS]]
    found: Floats = np.full((1, slots(state.rest_length.size), len(COLUMNS)), np.nan)
    rows = np.flatnonzero(grip[:, PUSH] > 0.0)
    if rows.size > found.shape[1]:
        rows = np.sort(rows[np.argsort(-grip[rows, PUSH], kind="stable")[: found.shape[1]]])
    push, normal = grip[rows, PUSH, None], grip[rows, NORMAL : NORMAL + 3]
    rub = grip[rows, SPRING : SPRING + 3]
    rub = rub - (rub * normal).sum(axis=1)[:, None] * normal  # the normal may be a newer one
    parts = (memory.pair[rows], grip[rows][:, [OWN, OTHER]], push, push * normal + rub)
    found[0, : rows.size] = np.hstack(parts)
    return found[:frames]


def on_obstacles(system: System, state: State, frames: int = 1) -> Floats | None:
    """Return the force of obstacles alone on every node at the state [N], (1, 3, n).

    None where ropes touch nothing else, so that it is the force of all contacts; (0, 3, n) where there are
    no `frames`.
    """
    if not state.memory.contact.tally.size or not system.node.obstacle.kind.size:
        return None
    found: Floats = np.zeros((1, 3, state.x.shape[1]))
    table, memory = system.node.obstacle, state.memory.obstacle
    contact_forces(state.x, state.v, table, memory, state.now, found[0], 0, ALL)
    return found[:frames]


def touched(
    system: System, state: State, out: Recording, frames: int
) -> tuple[Floats | None, Floats | None]:
    """Return what a block of `frames` in `out` holds of ropes on ropes, and of obstacles beside them.

    Of more than one frame where no ropes touch each other in any.
    """
    pairs, obstacles = rope_contacts(state, frames), on_obstacles(system, state, frames)
    if frames > 1:
        pairs = None if pairs is None else np.broadcast_to(pairs, (frames, *pairs.shape[1:]))
        obstacles = None if obstacles is None else out.contact.copy()
    return pairs, obstacles
