"""Memory of frames in one piece: the system hands out one large page for hundreds of small ones."""

from __future__ import annotations

from math import prod

import numpy as np

from ropewalk.core.arrays import Floats

LINE = 8  # numbers in a line of a cache
LARGE = 2**22 // 8  # numbers from which numpy asks for large pages
PER_NODE = 14  # numbers of a node and its segment in a frame


class Room:
    """Hands out arrays that lie one after another in one."""

    def __init__(self, frames: int, nodes: int) -> None:
        """Have room for the large arrays of so many frames, see `make_recording`."""
        self._size, self._first = frames * nodes * PER_NODE + 2 * LINE * PER_NODE, 0
        self._all = np.empty(self._size if self._size >= LARGE else 0)

    def __call__(self, shape: tuple[int, ...]) -> Floats:
        """Return an array that is not cleared."""
        size = prod(shape)
        first, end = self._first, self._first + size
        if end > self._all.size:
            return np.empty(shape)
        self._first = -(-end // LINE) * LINE
        return self._all[first:end].reshape(shape)
