"""What the steps of islands were looked at for, side by side in one array."""

from __future__ import annotations

from ropewalk.core.arrays import Floats
from ropewalk.core.peaks import Peaks


def size_of(peaks: Peaks) -> int:
    """Count the numbers of what was seen."""
    return sum(part.size for part in peaks)


def on_shelf(peaks: Peaks, room: Floats) -> Peaks:
    """Return the same numbers in the first part of an array."""
    views, first = [], 0
    for part in peaks:
        views.append(room[first : first + part.size].reshape(part.shape))
        views[-1][...] = part
        first += part.size
    return Peaks(*views)
