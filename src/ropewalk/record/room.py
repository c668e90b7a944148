"""Memory for the frames of one chunk, used again and again while a run is written."""

from __future__ import annotations

import mmap
from math import prod

import numpy as np

from ropewalk.core.arrays import Floats, State
from ropewalk.methods.recording import LARGE, Recording, make_recording
from ropewalk.record.zarr_format import CHECKSUM, HEADER, checksum, stored_header


class Room:
    """Buffers for a chunk whose large arrays lie in memory as their files will, header and all.

    `pages` has that memory by field: whole pages of it, so that the system can take them as they are.
    """

    def __init__(self, state: State, frames: int, with_lengths: bool) -> None:
        found: list[mmap.mmap] = []

        def empty(shape: tuple[int, ...]) -> Floats:
            size = 8 * prod(shape)
            pages = mmap.mmap(-1, -(-(HEADER + size + CHECKSUM) // mmap.PAGESIZE) * mmap.PAGESIZE)
            pages[:HEADER] = stored_header(size)
            found.append(pages)
            return np.frombuffer(pages, count=prod(shape), offset=HEADER).reshape(shape)

        self.recording = make_recording(state, frames, with_lengths, empty)
        self.pages = dict(zip(LARGE, found, strict=True))

    def seal(self, field: str) -> int:
        """Put the checksum behind what `field` holds; return the bytes of its file."""
        pages = self.pages[field]
        end: int = HEADER + getattr(self.recording, field).nbytes
        pages[end : end + CHECKSUM] = checksum(np.frombuffer(pages, np.uint8, end))
        return end + CHECKSUM

    def part(self, start: int, stop: int) -> Recording:
        """Return the buffers of the frames from `start` to `stop`."""
        return self.recording.part(start, stop)
