"""Many frames in one call, as long as ropes that may touch have nothing near them.

What contacts remember is read between calls, and islands are looked at after each: else a frame is a call.
Where calls begin and end changes no bit, and a call in which anything was near is taken back: how many frames
go into one decides about time alone. The adaptive method takes a frame in every call: it begins anew where
anything was changed between calls, also the first row of what contacts remember.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator
from contextlib import contextmanager
from typing import TYPE_CHECKING, Any

import numpy as np

from ropewalk.core.arrays import Ints
from ropewalk.core.status import OK
from ropewalk.laws.pairs.table import CONTACTS
from ropewalk.methods.recording import Recording
from ropewalk.simulation.block import Block, join_parts

if TYPE_CHECKING:
    from ropewalk.engine.engine import Engine
    from ropewalk.engine.islands import Islands
    from ropewalk.engine.slices import Slices
    from ropewalk.simulation.simulation import Simulation

GROWTH = 4  # [1] by which a call is longer than the last one, where nothing was near
DEAR = 8  # [1] so many times the frames that were taken back go by before a call is longer again


class FarApart:
    """Advances a scene whose ropes may touch by many frames; knows how many the next call may have."""

    def __init__(self, engine: Engine | Islands) -> None:
        self._engine, self._most, self._rest = engine, GROWTH, 0
        memory = engine.state.memory
        wheels, walks = memory.obstacle.wheel.size > 0, engine.walk.shown.size > 0
        self._goes = memory.contact.tally.size > 0 and not (wheels or walks)

    def advance(
        self, simulation: Simulation, frames: int, out: Recording, keep_going: bool
    ) -> Block:
        """Advance by frames as `Simulation.advance_frames` does, into buffers of as many."""
        parts, done, status = list[Block](), 0, OK
        while done < frames:
            count = 1 if simulation._goals else self._frames(frames - done)
            room = out.part(done, done + count)
            block = self._in_one(simulation, count, room) if count > 1 else None
            if block is None:  # taken back
                count = 1
                block = simulation.advance_frames(1, keep_going=keep_going, out=room.part(0, 1))
            status = block.status
            if block.frames or not parts:
                parts.append(block)
                done += block.frames
            if block.frames < count or (status != OK and not keep_going):
                break
        kept = out if done == frames else out.part(0, done)
        times = np.concatenate([part.time for part in parts])
        return Block(times, kept, status, *join_parts(parts))

    def _in_one(self, simulation: Simulation, frames: int, out: Recording) -> Block | None:
        """Advance by frames in one call, but take all back, None, where anything was near, or broke."""
        before = simulation.state
        with self._watched(simulation.slices) as touches:
            block, good = simulation._block(frames, out, True)
            stands = block.status == OK and not touches()
            if not stands:
                simulation.restore(before)
                simulation._forget_break()
        self._note(frames, stands)
        return simulation._told(block.head(good)) if stands else None

    def _note(self, frames: int, stand: bool) -> None:
        """Take up that so many frames went into a call, and whether they stand."""
        if not stand:
            self._most = max(self._most // GROWTH, 1)
            self._rest = max(self._rest, 0) + DEAR * frames
            return
        self._rest -= frames
        if self._rest <= 0 and self._most <= frames:
            self._most *= GROWTH

    def _frames(self, left: int) -> int:
        """Return how many of the frames that are left go into the next call: one where anything touches."""
        touches = not self._goes or any(tally[CONTACTS] for tally, _ in self._memories())
        if touches or self._most == 1:
            self._rest -= 1
        if self._most == 1 and self._rest <= 0:
            self._most = GROWTH
        return 1 if touches else min(left, self._most)

    @contextmanager
    def _watched(self, slices: Slices) -> Iterator[Callable[[], bool]]:
        """Have a call end early once anything touches; yield what tells whether anything has, ever.

        The first row of a memory keeps the pair that was in it last: none has been where it stays clear.
        """
        islands, asked = self._islands(), slices.asked
        first = [pair[:1] for _, pair in self._memories()]
        kept = [row.copy() for row in first]
        for row in first:
            row[:] = 0

        found = False  # a call that ends early goes back to a frame before

        def touches() -> bool:
            nonlocal found
            found = found or self._islands() is not islands or any(row.any() for row in first)
            return found

        slices.asked = lambda: touches() or (asked is not None and asked())
        try:
            yield touches
        finally:
            slices.asked = asked
            for row, pair in zip(first, kept, strict=True):
                row[:] = row if row.any() else pair

    def _islands(self) -> Any:
        return getattr(self._engine, "engines", None)

    def _memories(self) -> list[tuple[Ints, Ints]]:
        engines = self._islands() or [self._engine]
        memories = [engine.state.memory.contact for engine in engines]
        return [(memory.tally, memory.pair) for memory in memories]
