"""Greatest and least of every step since the row before, where not every frame makes a row.

A run keeps them from one frame to the next. A row of an export that leaves frames out has those of all frames
since the row before it, the first row of all since the start: what lies between two rows is in the latter.
"""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray

from ropewalk.core.arrays import Floats
from ropewalk.core.peaks import EXTREMES
from ropewalk.record.extremes import LEAST, had_rope

if TYPE_CHECKING:
    from ropewalk.record.result import Result

_VALUES = 2_000_000  # numbers read together
# What says of which frame a number is, and for each of its columns whether the greatest counts, as it does
# where none are told.
_ALONG = {
    "extremes": tuple(name not in LEAST for name in EXTREMES),
    "energy_errors": (False, True),
}
_RULED = {
    "extremes": "extremes",
    "extreme_places": "extremes",
    "extreme_since": "extremes",
    "extreme_until": "extremes",
    "energy_errors": "energy_errors",
    "energy_error_times": "energy_errors",
    "surface_force_times": "greatest_surface_forces",
    "surface_forces_before": "greatest_surface_forces",
}
#: Of frames in which a segment was no rope at any step, zeros count for nothing beside those where it was.
_PULLS = ("greatest_tension", "least_tension")


def is_of_steps(name: str) -> bool:
    """Tell whether a quantity is the greatest or least of all steps since the frame before."""
    return name in _RULED or name.startswith(("greatest_", "least_"))


def of_rows(result: Result, name: str, frames: NDArray[np.int64], first: int) -> Floats:
    """Return such a quantity of rows at `frames` (rising), of all frames since the row before.

    `first` is the first frame that counts for the first row.
    """
    if name in _RULED:
        return _ruled(result, name, frames, first)
    stop = int(frames[-1]) + 1
    one = result.read(name, first, first + 1)
    step = max(1, _VALUES // max(1, one.size))
    beyond = np.fmax if name.startswith("greatest_") else np.fmin
    found = np.full((len(frames), *one.shape[1:]), np.nan)
    bare = np.full(found.shape, name in _PULLS)
    for start in range(first, stop, step):
        values = result.read(name, start, min(start + step, stop))
        rows = np.searchsorted(frames, np.arange(start, start + len(values)))
        begins = np.flatnonzero(np.diff(rows, prepend=-1))
        there = rows[begins]
        if name in _PULLS:
            rope = had_rope(result, start, start + len(values))
            values = np.where(rope, values, np.nan)
            bare[there] &= ~np.logical_or.reduceat(rope, begins, axis=0)
        found[there] = beyond(found[there], beyond.reduceat(values, begins, axis=0))
    found[bare] = 0.0
    return found


def _ruled(result: Result, name: str, frames: NDArray[np.int64], first: int) -> Floats:
    """Return, for every row and column, the number of the frame where the greatest or least is."""
    stop, ruling = int(frames[-1]) + 1, _RULED[name]
    ruled, values = result.read(ruling, first, stop), result.read(name, first, stop)
    count = np.arange(len(ruled))
    rows = np.searchsorted(frames, first + count)
    found = np.empty((len(frames), values.shape[1]))
    for column, greatest in enumerate(_ALONG.get(ruling, (True,) * values.shape[1])):
        number = ruled[:, column] if greatest else -ruled[:, column]
        order = np.lexsort((-count, np.where(np.isnan(number), -np.inf, number), rows))
        last = np.flatnonzero(np.diff(rows[order], append=len(frames)))
        found[:, column] = values[order[last], column]
    return found
