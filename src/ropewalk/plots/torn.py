"""What figures show of a break: the note, and the single steps that a run keeps past its last good frame."""

from __future__ import annotations

from typing import TYPE_CHECKING

from ropewalk.plots.sight import Floats
from ropewalk.plots.style import COLOURS
from ropewalk.record.beyond import until_torn
from ropewalk.record.ends import shortly

if TYPE_CHECKING:
    from ropewalk.record.result import Result

BROKEN = COLOURS[1]  # the colour of all that is past a break
PAST = "past the break"


def broken_shapes(result: Result) -> list[tuple[float, Floats]]:
    """Return one or two steps past the break that show it, time [s] and points [m] (n, 3); or none."""
    found = until_torn(result)
    if found is None:
        return []
    return [(float(found.time[row]), found.positions[row]) for row in found.shapes]


def broken_note(
    result: Result, good: int, *, clipped: str = "axes show the part before"
) -> list[str]:
    """Say that a run broke, and what of it is drawn; empty for a sound run."""
    time = result.time
    if any(end.frames < good for end in result.ends):
        return [
            f"Ended early: {shortly(result.ends)}. Their numbers end there; sums count them as they were."
        ]
    if good < len(time):
        return [f"The run broke after t = {time[good - 1]:.4g} s: {clipped}."]
    if result.beyond is not None:
        end = f"{time[-1]:.6g} s, the last good frame"
        return [f"The run broke after t = {end}. Orange, where drawn: single steps past it."]
    if result.status == "broke":
        return [f"The run broke after t = {time[-1]:.4g} s, the last frame here."]
    return []
