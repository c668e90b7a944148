"""What figures show of a break: the note, and the single steps that a run keeps past its last good frame."""

from __future__ import annotations

from typing import TYPE_CHECKING, NamedTuple

import numpy as np

from ropewalk.plots.style import COLOURS
from ropewalk.plots.view import Floats, positions_of

if TYPE_CHECKING:
    from ropewalk.record.result import Result

BROKEN = COLOURS[1]  # the colour of all that is past a break
PAST = "past the break"
_TORN = (1.5, 3.0)  # [1] longest segment of a broken shape that is drawn, over that before


class Torn(NamedTuple):
    """Single steps past the last good frame of a run, as far as the rope is not torn apart."""

    time: Floats  # (k,) [s]
    positions: Floats  # (k, n, 3) [m]
    tension: Floats | None  # (k, s) [N]; None in run folders that did not keep it
    shapes: list[int]  # one or two of the steps, those that show the break best


def torn(result: Result) -> Torn | None:
    """Return the steps past the break that can be drawn; None of a run that has none.

    They end with the last one in which no segment is longer than three times the longest before; of the
    `shapes` the first is the last one below one and a half times.
    """
    beyond = result.beyond
    if beyond is None:
        return None
    before = float(_longest(positions_of(result, slice(result.frames - 1, result.frames)))[0])
    longest = _longest(beyond.positions)
    chosen = [np.flatnonzero(longest <= factor * before) for factor in _TORN]
    rows = sorted({int(found[-1]) if found.size else 0 for found in chosen})
    end = rows[-1] + 1
    tension = beyond.tension
    return Torn(
        beyond.time[:end],
        beyond.positions[:end],
        None if tension is None else np.asarray(tension[:end]),
        rows,
    )


def broken_shapes(result: Result) -> list[tuple[float, Floats]]:
    """Return one or two steps past the break that show it, time [s] and points [m] (n, 3); or none."""
    found = torn(result)
    if found is None:
        return []
    return [(float(found.time[row]), found.positions[row]) for row in found.shapes]


def _longest(positions: Floats) -> Floats:
    """Return the longest distance of two neighbours [m], (f,)."""
    with np.errstate(all="ignore"):
        size: Floats = np.linalg.norm(np.diff(positions, axis=1), axis=2).max(axis=1)
    return size


def broken_note(
    result: Result, good: int, *, clipped: str = "axes show the part before"
) -> list[str]:
    """Say that a run broke, and what of it is drawn; empty for a sound run."""
    time = result.time
    if good < len(time):
        return [f"The run broke after t = {time[good - 1]:.4g} s: {clipped}."]
    if result.beyond is not None:
        end = f"{time[-1]:.6g} s, the last good frame"
        return [f"The run broke after t = {end}. Orange, where drawn: single steps past it."]
    if result.status == "broke":
        return [f"The run broke after t = {time[-1]:.4g} s, the last frame here."]
    return []
