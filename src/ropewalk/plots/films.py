"""The ropes over time as a strip of pictures."""

from __future__ import annotations

import math
from collections.abc import Sequence
from typing import TYPE_CHECKING

import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure
from matplotlib.ticker import MaxNLocator

from ropewalk.plots.canvas import (
    Backdrop,
    backdrop,
    draw_anchors,
    draw_loads,
    draw_moving,
    draw_still,
    label,
    magnification_note,
    prepare,
)
from ropewalk.plots.given_forces import arrows_note, draw_forces, with_room
from ropewalk.plots.shape_figure import draw_points, draw_ropes
from ropewalk.plots.sight import Floats, gone_ropes, shown_positions, sight_notes, spread_frames
from ropewalk.plots.style import COLOURS, FAINT, describe, new_figure, set_note, set_title, styled
from ropewalk.plots.torn import BROKEN, broken_note, broken_shapes
from ropewalk.record.beyond import until_torn

if TYPE_CHECKING:
    from ropewalk.record.result import Result

_COUNT = 12
_WIDE = 1.5  # panels [inch] with room for "(broken)" beside a time


@styled
def film(
    result: Result, frames: int | Sequence[int] = _COUNT, *, plane: str | None = None
) -> Figure:
    """Draw the ropes as a strip of small pictures with common axes; the one before in grey.

    `frames` is how many pictures, spread over the run, or which frames.

    Raises ValueError for frames that are not there and for a plane that is none.
    """
    seen = with_room(result, backdrop(result, plane), sizes=False)
    chosen = _chosen(result, frames, seen.good)
    torn = broken_shapes(result) if chosen[-1] == result.frames - 1 else []
    count = len(chosen) + len(torn)
    ratio = seen.box.height / seen.box.width
    columns, rows = _grid(count, ratio)
    width = 7.6
    panel = (width - 0.7) / columns
    broken = " (broken)" if panel > _WIDE else "\n(broken)"
    head = 0.27 if panel > _WIDE or not (torn or chosen[-1] >= seen.good) else 0.4
    tall = min(panel * min(max(ratio, 0.2), 3.0) + head, 8.75 / rows)
    ticks = MaxNLocator(max(2, int(1.7 * min(panel, (tall - head) / ratio))))
    figure = new_figure(width, rows * tall + 1.25)
    grid = figure.subplots(rows, columns, sharex=True, sharey=True, squeeze=False)
    for number, axes in enumerate(grid.flat):
        if number >= count:
            axes.set_visible(False)
            continue
        prepare(axes, seen.box)
        draw_still(axes, seen)
        if 0 < number < len(chosen) and chosen[number - 1] < seen.good:
            draw_ropes(axes, result, seen, chosen[number - 1], FAINT, "_before", thick=True)
        if number < len(chosen):
            _draw_frame(axes, result, seen, chosen[number])
            stamp = f"t = {result.time[chosen[number]]:.4g} s"
            stamp += broken if chosen[number] >= seen.good else ""
        else:
            time, points = torn[number - len(chosen)]
            if number == len(chosen):
                _draw_last(axes, result, seen, points)
            draw_points(axes, result, seen, points, BROKEN, "rope", broken=True)
            stamp = f"t = {time:.6g} s{broken}"
        axes.set_title(stamp, fontsize=8.5, loc="left", pad=3.0)
        below = number + columns >= count
        axes.tick_params(labelbottom=below)
        axes.xaxis.set_major_locator(ticks)
        label(axes, seen.view, across=below, up=number % columns == 0)
    set_title(figure, f"{result.scene.name}: film strip", describe(result))
    clipped = "the broken shapes (orange) leave the picture"
    notes = broken_note(result, seen.good, clipped=clipped) + magnification_note(seen.box)
    notes += sight_notes(result, seen.view)
    set_note(figure, notes + arrows_note(result.scene, gone=gone_ropes(result, chosen[0])))
    return figure


def _draw_frame(axes: Axes, result: Result, seen: Backdrop, frame: int) -> None:
    """Draw one recorded frame with its time."""
    colour = COLOURS[0] if frame < seen.good else BROKEN
    draw_moving(axes, result, seen.view, float(result.time[frame]))
    draw_ropes(axes, result, seen, frame, colour, "rope", thick=True)
    draw_loads(axes, result, seen.view, frame, markersize=4.5)
    draw_anchors(axes, result, seen.view, frame, markersize=3.5)
    if frame < seen.good:
        draw_forces(axes, result, seen, frame, sizes=False)


def _draw_last(axes: Axes, result: Result, seen: Backdrop, torn: Floats) -> None:
    """Draw in grey the last good frame of the ropes that broke, whose nodes are `torn` [m], (n, 3), after."""
    past = until_torn(result)
    assert past is not None
    before = np.where(np.isnan(torn), np.nan, shown_positions(result, past.last))
    draw_points(axes, result, seen, before, FAINT, "_before", broken=False, thick=True)


def _chosen(result: Result, frames: int | Sequence[int], good: int) -> list[int]:
    """Which frames to show."""
    count = len(result.time)
    if isinstance(frames, int):
        if frames < 1:
            raise ValueError(f"frames: {frames!r} - must be at least 1")
        if frames == 1:
            return [0]
        return spread_frames(result, frames, good, min(4, frames // 2))
    wrong = [f for f in frames if not -count <= f < count]
    if wrong or not frames:
        raise ValueError(f"frames: {wrong or ()!r} - the run has the frames 0 to {count - 1}")
    return [int(f) % count for f in frames]


def _grid(count: int, ratio: float) -> tuple[int, int]:
    """Columns and rows of panels of this height over width that fill a page well."""
    best = math.sqrt(count * max(ratio, 0.15) * 2.6)
    columns = min(max(round(best), 2), 8, count)
    rows = math.ceil(count / columns)
    return math.ceil(count / rows), rows
