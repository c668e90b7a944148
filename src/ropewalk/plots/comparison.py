"""Two or more runs in one figure."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from typing import TYPE_CHECKING

import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure
from matplotlib.gridspec import GridSpec

from ropewalk.analysis.compare import Comparison, compare_runs, positions_at
from ropewalk.plots.canvas import (
    Backdrop,
    Box,
    backdrop,
    draw_anchors,
    draw_loads,
    draw_moving,
    draw_still,
    label,
    magnification_note,
    prepare,
)
from ropewalk.plots.curves import drawable, lone, mark_break
from ropewalk.plots.energies import energy_curves
from ropewalk.plots.given_forces import arrow_scale, arrows_note, draw_forces, with_room
from ropewalk.plots.shape_figure import draw_points, draw_ropes
from ropewalk.plots.sight import Floats, frame_at, limits, shown_positions, telling_frames
from ropewalk.plots.style import (
    COLOURS,
    GREY,
    escape,
    line_style,
    method_and_step,
    new_figure,
    scaled_axis,
    set_note,
    set_title,
    shorten,
    styled,
    times_map,
)
from ropewalk.record.ends import shortly

if TYPE_CHECKING:
    from ropewalk.record.result import Result

_COLUMNS = 4
_TIMES = 5


@styled
def compare(
    results: Sequence[Result] | Comparison,
    labels: Sequence[str] | None = None,
    *,
    times: Sequence[float] | None = None,
    plane: str | None = None,
) -> Figure:
    """Draw runs side by side: shapes at some times [s], distance from the first run, energies.

    Raises ValueError for fewer than two runs, labels that are not one per run and different, and times
    outside a run.
    """
    found = results if isinstance(results, Comparison) else compare_runs(results, labels)
    backdrops = _common_backdrops(found, plane)
    columns = min(len(found.results), _COLUMNS)
    rows = -(-len(found.results) // columns)
    ratio = float(np.clip(backdrops[0].box.height / backdrops[0].box.width, 0.25, 1.6))
    tall = min(8.4 / columns * ratio + 0.55, 3.6)
    figure = new_figure(8.8, rows * tall + 3.6)
    grid = GridSpec(2, 1, figure=figure, height_ratios=(rows * tall, 2.4))
    shapes = grid[0].subgridspec(rows, columns)
    upper = list(np.ravel(shapes.subplots(sharex=True, sharey=True, squeeze=False)))
    lower = list(np.ravel(grid[1].subgridspec(1, 3).subplots(squeeze=False)))
    _draw_shapes(upper, columns, found, backdrops, times)
    _draw_distance(lower[0], found)
    for axes, name in ((lower[1], "kinetic"), (lower[2], "total")):
        _draw_energy(axes, found, backdrops, name)
    handles, names = lower[2].get_legend_handles_labels()
    names = [shorten(name, 22) for name in names]
    figure.legend(handles, names, loc="outside right center", title="run")
    scenes = {result.scene.name for result in found.results}
    title = f"{scenes.pop()}: comparison" if len(scenes) == 1 else "comparison of runs"
    set_title(figure, title, _subtitle(found))
    set_note(figure, _notes(found, backdrops))
    return figure


def _common_backdrops(found: Comparison, plane: str | None) -> list[Backdrop]:
    """One box for all runs, in the plane of the first."""
    own = [backdrop(result, plane) for result in found.results]
    view = own[0].view
    names = view.across_name + view.up_name
    if plane is None and len(names) == 2:
        own = [own[0], *(backdrop(result, names) for result in found.results[1:])]
    own = [replace(one, view=view, box=_around(own)) for one in own]
    room = [with_room(*pair, sizes=False) for pair in zip(found.results, own, strict=True)]
    return [replace(one, box=_around(room)) for one in own]


def _around(backdrops: list[Backdrop]) -> Box:
    """Return the box around those of all runs."""
    boxes = [one.box for one in backdrops]
    return Box(
        min(b.left for b in boxes),
        max(b.right for b in boxes),
        min(b.low for b in boxes),
        max(b.high for b in boxes),
        min(b.magnified for b in boxes),
    )


def _draw_shapes(
    grid: list[Axes],
    columns: int,
    found: Comparison,
    backdrops: list[Backdrop],
    times: Sequence[float] | None,
) -> None:
    """Draw one panel per run, with the ropes at the same times."""
    colours = times_map()
    chosen = _times(found, backdrops, times)
    scale = arrow_scale(backdrops[0], *found.results)
    for number, axes in enumerate(grid):
        if number >= len(found.results):
            axes.set_visible(False)
            continue
        result, seen = found.results[number], backdrops[number]
        prepare(axes, seen.box)
        draw_still(axes, seen)
        frame = 0
        for i, time in enumerate(chosen):
            if time > result.time[seen.good - 1] + 1e-9:
                continue
            frame = frame_at(result, [time])[0]
            colour = colours(i / max(len(chosen) - 1, 1))
            places = _places(result, seen, frame, time)
            draw_moving(axes, result, seen.view, time)
            draw_points(axes, result, seen, places, colour, f"{time:.3g} s", time, broken=False)
            draw_loads(axes, result, seen.view, frame, places, color=colour, markersize=4.5)
            draw_anchors(axes, result, seen.view, frame, places, color=colour, markersize=3.5)
        draw_forces(axes, result, seen, frame, scale=scale, sizes=False)
        broke = seen.good < len(result.time)
        if broke:
            after = min(seen.good + 1, len(result.time) - 1)
            draw_ropes(axes, result, seen, after, COLOURS[1], "_broken")
        name = shorten(found.labels[number], int(100 / columns)) + (
            " (orange: broken)" if broke else ""
        )
        axes.set_title(name, loc="left", fontsize=9.0, fontweight="bold")
        below = number + columns >= len(found.results)
        axes.tick_params(labelbottom=below)
        label(axes, seen.view, across=below, up=number % columns == 0)
    # a run that broke early shows fewer times than the others
    handles, names = max(
        (axes.get_legend_handles_labels() for axes in grid), key=lambda x: len(x[1])
    )
    grid[0].figure.legend(handles, names, loc="outside right upper", title="time")


def _places(result: Result, seen: Backdrop, frame: int, time: float) -> Floats:
    """Return the nodes at a time [m], (n, 3), near to a `frame`; NaN for ropes that broke before it."""
    shown = shown_positions(result, frame)
    return np.where(np.isnan(shown), np.nan, positions_at(result, np.array([time]), seen.good)[0])


def _times(
    found: Comparison, backdrops: list[Backdrop], times: Sequence[float] | None
) -> list[float]:
    """The times of the shapes: those nearest to given ones, or some; frames of one run.

    Of the runs that go on to the end, to a frame, that of the fewest: between its frames it has no places.
    """
    frames = [
        result.time[: seen.good] for result, seen in zip(found.results, backdrops, strict=True)
    ]
    end = max(float(own[-1]) for own in frames)
    whole = [i for i, own in enumerate(frames) if own[-1] + np.diff(own[:2]).sum() > end - 1e-9]
    result = found.results[min(whole, key=lambda i: len(frames[i]))]
    if times is not None:
        return [float(result.time[f]) for f in frame_at(result, times)]
    return [float(result.time[f]) for f in telling_frames(result, _TIMES, 0)]


def _draw_distance(axes: Axes, found: Comparison) -> None:
    """Draw the largest distance of any node from where the first run has it."""
    curves = []
    for number, distance in enumerate(found.distances, start=1):
        if distance.defined:
            curves.append(distance.largest)
            name = escape(found.labels[number])
            style = line_style(number) | lone(found.results[number])
            axes.plot(distance.time, distance.largest, label=name, **style)
    axes.set_xlabel("time [s]")
    if not curves:
        axes.text(0.5, 0.5, "not defined", transform=axes.transAxes, ha="center", color=GREY)
        axes.set_ylabel("largest node distance [m]")
        return
    largest = max(float(curve.max()) for curve in curves)
    scaled_axis(axes, "largest node distance", "m", largest)
    axes.set_ylim(0.0, 1.05 * largest if largest > 0.0 else 1.0)
    axes.set_xlim(0.0, None)


def _draw_energy(axes: Axes, found: Comparison, backdrops: list[Backdrop], name: str) -> None:
    """Draw one energy of all runs, gravity's part 0 in each scene's own shape."""
    parts = []
    end = 0.0
    pairs = zip(found.results, backdrops, strict=True)
    sound = any(seen.good == len(result.time) for result, seen in pairs)
    for number, (result, seen) in enumerate(zip(found.results, backdrops, strict=True)):
        values = energy_curves(result)[name]
        if seen.good == len(result.time) or not sound:
            parts.append(values[: seen.good])
        end = max(end, float(result.time[seen.good - 1]))
        curve = drawable(values, seen.good)
        axes.plot(
            result.time, curve, label=found.labels[number], **line_style(number), **lone(result)
        )
        mark_break(axes, result, seen.good)
    axes.set_ylim(*limits(parts))
    axes.set_xlim(0.0, end or 1.0)
    largest = max(float(np.nanmax(np.abs(part))) for part in parts)
    scaled_axis(axes, f"{name} energy", "J", largest)
    axes.set_xlabel("time [s]")


def _subtitle(found: Comparison) -> str:
    """How each run was made; once where all were made alike."""
    ways = [method_and_step(result) for result in found.results]
    if len(set(ways)) == 1:
        return ways[0]
    return "; ".join(f"{name}: {way}" for name, way in zip(found.labels, ways, strict=True))


def _notes(found: Comparison, backdrops: list[Backdrop]) -> list[str]:
    """What has to be said of the runs and of the distance."""
    first = found.labels[0]
    notes = []
    for number, distance in enumerate(found.distances, start=1):
        name = f"Distance of {found.labels[number]} from {first}"
        if distance.note:
            notes.append(f"{name}: {distance.note}.")
        elif distance.way != "node by node":
            notes.append(f"{name} {distance.way}.")
    for label_, result, seen in zip(found.labels, found.results, backdrops, strict=True):
        if any(end.frames < seen.good for end in result.ends):
            notes.append(f"{label_}: ended early, {shortly(result.ends)}.")
        elif seen.good < len(result.time) or result.status == "broke":
            notes.append(f"{label_} broke after t = {result.time[seen.good - 1]:.4g} s.")
    shown = found.settings[:4]
    if shown:
        parts = [f"{path} {' / '.join(values)}" for path, values in shown]
        more = len(found.settings) - len(shown)
        tail = f"; and {more} more" if more else ""
        notes.append(f"Scenes differ in {'; '.join(parts)}{tail}.")
    notes += arrows_note(*(result.scene for result in found.results))
    return [escape(note) for note in notes + magnification_note(backdrops[0].box)]
