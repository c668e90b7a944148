"""Frames as the simulation hands them out: recorded arrays with their times."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

import numpy as np

from ropewalk.core.arrays import Floats, State
from ropewalk.core.status import OK
from ropewalk.methods.recording import Recording, make_recording
from ropewalk.simulation.pages import Room


@dataclass(frozen=True)
class Block:
    """`frames` consecutive frames, as C-contiguous arrays with the frame first.

    `status` is OK, or BROKEN when the frame after the last one here is broken.
    """

    time: Floats  # (f,) [s]
    recording: Recording
    status: int = OK
    pairs: Floats | None = None  # (f, slots, 8) where ropes touch ropes, see `rope_contacts`
    obstacles: Floats | None = (
        None  # (f, 3, n) force of obstacles alone, where ropes touch ropes too [N]
    )

    @property
    def frames(self) -> int:
        """Number of frames."""
        return len(self.time)

    def head(self, frames: int) -> Block:
        """Return the first `frames` frames."""
        kept = [None if part is None else part[:frames] for part in (self.pairs, self.obstacles)]
        return Block(self.time[:frames], self.recording.part(0, frames), self.status, *kept)


def make_frames(state: State, frames: int, lengths: bool) -> Recording:
    """Return buffers for frames, those with numbers of every node or segment in one piece of memory."""
    refuse_unless_count("frames", frames)
    return make_recording(state, frames, lengths, Room(frames, state.x.shape[1]))


def join(blocks: list[Block]) -> Block:
    """Return several blocks as one."""
    columns = zip(*(block.recording for block in blocks), strict=True)
    recording = Recording(*(np.concatenate(column) for column in columns))
    times = np.concatenate([block.time for block in blocks])
    return Block(times, recording, blocks[-1].status, *join_parts(blocks))


def join_parts(blocks: list[Block]) -> list[Floats | None]:
    """Return `pairs` and `obstacles` of several blocks as one; None where there are none."""
    columns = [[block.pairs for block in blocks], [block.obstacles for block in blocks]]
    there = [[part for part in column if part is not None] for column in columns]
    return [
        (parts[0] if len(parts) == 1 else np.concatenate(parts)) if parts else None
        for parts in there
    ]


def refuse_unless_count(name: str, value: Any) -> None:
    """Raise ValueError for anything but a whole number from 0 on: less would turn the clock back."""
    whole = isinstance(value, (int, np.integer)) and not isinstance(value, bool)
    if not whole or value < 0:
        raise ValueError(f"{name}: {value!r} - must be a whole number from 0 on")
