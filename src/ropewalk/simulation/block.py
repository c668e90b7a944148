"""Frames as the simulation hands them out: recorded arrays with their times."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from ropewalk.core.arrays import Floats
from ropewalk.core.status import OK
from ropewalk.methods.recording import Recording


@dataclass(frozen=True)
class Block:
    """`frames` consecutive frames, as C-contiguous arrays with the frame first.

    `status` is OK, or BROKEN when the frame after the last one here is broken.
    """

    time: Floats  # (f,) [s]
    recording: Recording
    status: int = OK
    pairs: Floats | None = None  # (f, slots, 8) where ropes touch ropes, see `rope_contacts`

    @property
    def frames(self) -> int:
        """Number of frames."""
        return len(self.time)

    def head(self, frames: int) -> Block:
        """Return the first `frames` frames."""
        pairs = None if self.pairs is None else self.pairs[:frames]
        return Block(self.time[:frames], self.recording.part(0, frames), self.status, pairs)


def join(blocks: list[Block]) -> Block:
    """Return several blocks as one."""
    columns = zip(*(block.recording for block in blocks), strict=True)
    recording = Recording(*(np.concatenate(column) for column in columns))
    times = np.concatenate([block.time for block in blocks])
    return Block(times, recording, blocks[-1].status, join_pairs(blocks))


def join_pairs(blocks: list[Block]) -> Floats | None:
    """Return where ropes touch ropes in several blocks; None where none can."""
    pairs = [block.pairs for block in blocks if block.pairs is not None]
    return np.concatenate(pairs) if pairs else None
