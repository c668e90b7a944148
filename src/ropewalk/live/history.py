"""The last seconds of a session, to go back to."""

from __future__ import annotations

from collections import deque
from typing import Any, NamedTuple

from ropewalk.core.arrays import flatten
from ropewalk.live.saved import Saved

EVERY = 0.25  # [s] of simulated time between two moments
LONGEST = 40  # moments
MOST_BYTES = 100_000_000


class Moment(NamedTuple):
    """All tracks of a session at one time."""

    time: float  # [s]
    tracks: tuple[Saved, ...]
    session: Any  # what the session itself remembers with it
    number: int  # in the order in which moments were kept: times may be the same, or smaller again


class History:
    """The last moments, as many as fit."""

    def __init__(self, longest: int = LONGEST) -> None:
        """Keep at most so many."""
        self._longest = longest
        self._moments: deque[Moment] = deque()
        self._bytes: deque[int] = deque()

    def add(self, moment: Moment) -> None:
        """Keep a moment; forget the oldest beyond the limits."""
        self._moments.append(moment)
        self._bytes.append(sum(_size(saved) for saved in moment.tracks))
        while len(self._moments) > self._longest or (
            len(self._moments) > 2 and sum(self._bytes) > MOST_BYTES
        ):
            self._moments.popleft()
            self._bytes.popleft()

    def __len__(self) -> int:
        return len(self._moments)

    def pop(self) -> Moment:
        """Return the newest moment, and forget it. Raises IndexError where there is none."""
        self._bytes.pop()
        return self._moments.pop()

    def newest_first(self) -> list[Moment]:
        """Return all moments, the newest first."""
        return list(reversed(self._moments))

    def forget_after(self, moment: Moment) -> None:
        """Forget what came after a moment, when it has been gone back to."""
        while self._moments and self._moments[-1] is not moment:
            self._moments.pop()
            self._bytes.pop()

    def clear(self) -> None:
        """Forget everything."""
        self._moments.clear()
        self._bytes.clear()


def _size(saved: Saved) -> int:
    return sum(array.nbytes for array in flatten(saved.snapshot.state).values())
