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

    @property
    def frames(self) -> int:
        """Number of frames."""
        return len(self.time)

    def head(self, frames: int) -> Block:
        """Return the first `frames` frames."""
        return Block(self.time[:frames], self.recording.part(0, frames), self.status)


def join(blocks: list[Block]) -> Block:
    """Return several blocks as one."""
    columns = zip(*(block.recording for block in blocks), strict=True)
    recording = Recording(*(np.concatenate(column) for column in columns))
    return Block(np.concatenate([b.time for b in blocks]), recording, blocks[-1].status)
