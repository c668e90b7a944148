"""What curves over time share: limits from the good part, the mark where a run breaks, thinning."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import numpy as np
from matplotlib.axes import Axes

from ropewalk.plots.sight import Floats, limits
from ropewalk.plots.torn import BROKEN

if TYPE_CHECKING:
    from ropewalk.record.result import Result


def time_limits(result: Result, good: int) -> tuple[float, float]:
    """Return limits of the time axis [s]: the run, or its good part and a little of the break."""
    time = result.time
    first, last = float(time[0]), float(time[-1])
    if good < len(time):
        end = float(time[min(good + max(2, good // 8), len(time) - 1)])
        return first, end if end > first else first + 1.0
    return first, last if last > first else first + 1.0


def mark_break(axes: Axes, result: Result, good: int) -> None:
    """Mark the last good frame of a run that goes on into its break, or of ropes that others outlived."""
    for end in result.ends:
        if end.frames < good:
            axes.axvline(end.time, color=BROKEN, linewidth=1.0, linestyle=(0, (1, 3)), label="_end")
    if good < len(result.time):
        at = float(result.time[good - 1])
        axes.axvline(at, color=BROKEN, linewidth=1.0, linestyle=(0, (4, 3)), label="_break")


def lone(result: Result) -> dict[str, Any]:
    """Return the marker of curves of a single frame, which would not be seen; none for more."""
    return {"marker": "o", "clip_on": False} if result.frames == 1 else {}


def drawable(values: Floats, good: int, among: list[Floats] | None = None) -> Floats:
    """Return values to draw: those of the good part as they are, later ones not too far outside it.

    `among` are all curves of the axes.
    """
    if good >= len(values):
        return values
    low, high = limits([part[:good] for part in among or [values]])
    span = high - low
    with np.errstate(all="ignore"):
        later = np.clip(values[good:], low - 20.0 * span, high + 20.0 * span)
    return np.concatenate([values[:good], later])


def set_limits(axes: Axes, values: list[Floats], good: int, margin: float = 0.05) -> float:
    """Set the y limits around the good part; return the largest absolute value there."""
    parts = [np.asarray(part)[:good] for part in values]
    axes.set_ylim(*limits(parts, margin))
    finite = [np.abs(part[np.isfinite(part)]) for part in parts]
    return max((float(part.max()) for part in finite if part.size), default=0.0)
