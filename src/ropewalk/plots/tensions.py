"""Tension along the rope and in time."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING, Any, NamedTuple

import numpy as np
from matplotlib.axes import Axes
from matplotlib.colors import Colormap, LinearSegmentedColormap, Normalize
from matplotlib.figure import Figure

from ropewalk.lowering import Span
from ropewalk.plots.arcs import IN_SEGMENTS, arc_label, laid_lengths, segment_arcs
from ropewalk.plots.curves import mark_break, time_limits
from ropewalk.plots.legends import legend_above
from ropewalk.plots.margin_notes import margin_notes
from ropewalk.plots.sight import Floats, frame_at, good_frames, limits
from ropewalk.plots.style import (
    ALL_STEPS,
    BAND,
    COLOURS,
    DASHES,
    describe,
    escape,
    line_style,
    new_figure,
    scaled_axis,
    set_note,
    set_title,
    styled,
    times_map,
)
from ropewalk.plots.torn import BROKEN, broken_note
from ropewalk.record.beyond import Torn, until_torn

if TYPE_CHECKING:
    from ropewalk.record.result import Result

_MOST_ROPES = 6
_PIXELS = 1600  # columns of an image; more frames than that are joined, the largest tension kept
_TAIL = 0.2  # percent of the values that may lie beyond the colours, on either side


class Map(NamedTuple):
    """Tension of one rope at equally long pieces of the arc from 0 to `length` [m], or of its segments."""

    values: Floats  # (f, s) [N] in the frames
    least: Floats  # (f, s) [N] of all steps since the frame before; of the frame where no more is known
    greatest: Floats  # (f, s) [N]
    length: float
    label: str  # of the axis along the rope, with its unit


@styled
def tension(
    result: Result,
    times: Sequence[float] | None = None,
    *,
    ropes: Sequence[str] | None = None,
) -> Figure:
    """Draw the tension of every rope over arc length and time, with profiles at some times [s].

    The colours are of what was farthest from zero since the frame before, so that no peak between frames is
    missed. Behind the profiles lies the band between the least and the greatest of the whole run.
    The colours reach over all but the last few thousandths of the values, so that a spike does not
    bleach the rest; a triangle at the colour bar says that values lie beyond.

    Raises ValueError for times outside the run and ropes that are not there.
    """
    shown, notes = _shown(result, ropes)
    good = good_frames(result)
    maps = [tension_map(result, number) for number in shown]
    scale, colours, extend = colour_scale([farthest(m)[:good] for m in maps])
    frames = frame_at(result, times) if times is not None else []
    past = until_torn(result)
    if past is not None and (past.tension is None or not _broke(result, past, shown)):
        past = None
    rows = len(shown) + bool(frames) + (past is not None)
    figure = new_figure(7.2, min(1.3 + max(1.35, 2.9 - 0.5 * len(shown)) * rows, 10.0))
    grid = figure.subplots(rows, 1, squeeze=False)[:, 0]
    for number, axes, found in zip(shown, grid, maps, strict=False):
        image = draw_map(axes, result, found, scale, colours)
        axes.set_ylabel(found.label)
        axes.set_xlim(*time_limits(result, good))
        mark_break(axes, result, good)
        if len(shown) > 1:
            name = escape(result.layout.ropes[number].name)
            axes.set_title(name, loc="left", fontsize=8.5, pad=3.0)
        axes.tick_params(labelbottom=number == shown[-1])
    grid[len(shown) - 1].set_xlabel("time [s]")
    bar = figure.colorbar(
        image, ax=list(grid[: len(shown)]), extend=extend, pad=0.015, aspect=18 * min(len(shown), 3)
    )
    since = ", largest since the frame before" if _has_band(result) else ""
    unit_of = reach(scale)  # one unit in all panels, so that their numbers compare
    scaled_axis(bar.ax, result.tension_name + since, "N", unit_of)
    if frames:
        _draw_profiles(grid[len(shown)], result, maps, shown, frames, good)
        scaled_axis(grid[len(shown)], result.tension_name, "N", unit_of)
    if past is not None:
        name = _draw_break(grid[-1], result, past, shown)
        scaled_axis(grid[-1], result.tension_name + name, "N", unit_of)
    set_title(figure, f"{result.scene.name}: {result.tension_name}", describe(result))
    set_note(figure, broken_note(result, good) + notes + margin_notes(result, 0, good))
    return figure


def _shown(result: Result, ropes: Sequence[str] | None) -> tuple[list[int], list[str]]:
    """Numbers of the ropes to draw, and a remark when some are left out."""
    names = [span.name for span in result.layout.ropes]
    if ropes is not None:
        wrong = [name for name in ropes if name not in names]
        if wrong or not ropes:
            raise ValueError(f"ropes: {wrong or ()!r} - there is {', '.join(names)}")
        return [names.index(name) for name in ropes], []
    if len(names) <= _MOST_ROPES:
        return list(range(len(names))), []
    return list(range(_MOST_ROPES)), [f"The first {_MOST_ROPES} of {len(names)} ropes are shown."]


def tension_map(result: Result, rope: int) -> Map:
    """Return the tension of a rope on equal pieces of arc length; NaN where no rope is.

    Without a winch the pieces are the segments. With one the arc is counted from the other end, and
    each piece takes the tension of the segment at its middle.
    """
    span = result.layout.ropes[rope]
    view = result.rope(span.name)
    layers = [view.tension, view.least_tension, view.greatest_tension]
    winches = {w.end for w in result.scene.winches if w.rope == span.name}
    if not winches:
        length = result.scene.ropes[rope].length_unstretched
        label = "arc length [m]" if length else IN_SEGMENTS
        return Map(layers[0], layers[1], layers[2], length or float(span.nodes - 1), label)
    rest = laid_lengths(result, span.name)
    turned = "start" in winches
    if turned:
        layers, rest = [values[:, ::-1] for values in layers], rest[:, ::-1]
    total = rest.sum(axis=1)
    length = float(total.max())
    middle = (np.arange(_pieces(length, rest)) + 0.5) * length / _pieces(length, rest)
    out = [np.full((len(rest), len(middle)), np.nan) for _ in layers]
    for frame in range(len(rest)):
        here = middle < total[frame]
        at = np.searchsorted(np.cumsum(rest[frame]), middle[here], side="right")
        for layer, values in zip(out, layers, strict=True):
            layer[frame, here] = values[frame, at]
    label = "arc length from end [m]" if turned else "arc length [m]"
    return Map(out[0], out[1], out[2], length, label)


def farthest(found: Map) -> Floats:
    """Return what was farthest from zero since the frame before [N], (f, s)."""
    with np.errstate(invalid="ignore"):
        return np.where(np.abs(found.least) > np.abs(found.greatest), found.least, found.greatest)


def _pieces(length: float, rest: Floats) -> int:
    """So many pieces that even the shortest usual segment has a few."""
    return int(np.clip(8 * length / np.median(rest[rest > 0.0]), 50, 600))


def colour_scale(values: list[Floats]) -> tuple[Normalize, str, str]:
    """Return scale, colour map and the colour bar's open ends for these tensions [N].

    Where ropes push as well as pull the colours diverge from zero.
    """
    flat = np.concatenate([np.ravel(part) for part in values])
    flat = flat[np.isfinite(flat)]
    if flat.size == 0:
        return Normalize(0.0, 1.0), "viridis", "neither"
    low, high = np.percentile(flat, [_TAIL, 100.0 - _TAIL])
    least, most = float(flat.min()), float(flat.max())
    if low < -0.02 * max(high, 0.0):
        reach = float(max(abs(low), abs(high))) or 1.0
        scale, colours = Normalize(-reach, reach), "RdBu_r"
    else:
        low = min(0.0, float(low)) if low < 0.3 * high else float(low)
        if high - low <= 1e-9 * abs(high):
            low, high = (0.0, float(high)) if high > 0.0 else (0.0, 1.0)
        scale, colours = Normalize(low, float(high)), "viridis"
    return scale, colours, open_ends(scale, least, most)


def open_ends(scale: Normalize, least: float, most: float) -> str:
    """Return which ends of a colour bar are open, as matplotlib names them, for all that lies beyond it."""
    slack = 0.01 * (scale.vmax - scale.vmin)  # type: ignore[operator]
    beyond = (least < scale.vmin - slack, most > scale.vmax + slack)  # type: ignore[operator]
    names = {(False, False): "neither", (True, False): "min", (False, True): "max"}
    return names.get(beyond, "both")


def reach(scale: Normalize) -> float:
    """Return the largest size of a number on a scale."""
    return max(abs(float(scale.vmin or 0.0)), abs(float(scale.vmax or 0.0)))


def line_map(name: str) -> Colormap:
    """Return a colour map for lines on white; the diverging one is dark at zero, not white."""
    if name == "RdBu_r":
        stops = ["#56B4E9", "#0072B2", "#303030", "#D55E00", "#F0A030"]
        return LinearSegmentedColormap.from_list("pull", stops)
    return times_map()


def draw_map(axes: Axes, result: Result, found: Map, scale: Normalize, colours: str) -> Any:
    """Draw a tension map as an image; rope that is not there stays white."""
    values = thinned(farthest(found))
    with np.errstate(all="ignore"):
        values = np.clip(values, -1e30, 1e30)
    axes.grid(False)
    return axes.imshow(
        values.T,
        origin="lower",
        aspect="auto",
        extent=(*_times_of(result), 0.0, found.length),
        interpolation="nearest",
        norm=scale,
        cmap=colours,
        rasterized=True,
    )


def _times_of(result: Result) -> tuple[float, float]:
    """Return where the first column of an image begins and the last ends [s].

    What is of all steps since the frame before ends at the frame; what is of the frame alone lies about it.
    """
    time = result.time
    interval = float(time[-1] - time[0]) / max(len(time) - 1, 1) or 1.0
    joined = _joined(len(time))
    columns = -(-len(time) // joined)
    first = float(time[0]) - interval * (1.0 if _has_band(result) else 0.5)
    return first, first + columns * joined * interval


def _joined(count: int) -> int:
    """Return how many neighbours of so many are one column, or row, of an image."""
    return -(-count // _PIXELS)


def thinned(values: Floats) -> Floats:
    """Join neighbouring frames and segments where there are too many, keeping the largest size."""
    for axis in (0, 1):
        step = _joined(values.shape[axis])
        if step > 1:
            values = np.moveaxis(values, axis, 0)
            groups = [values[i : i + step] for i in range(0, len(values), step)]
            rows = []
            for group in groups:
                size = np.where(np.isnan(group), -1.0, np.abs(group))
                best = size.argmax(axis=0)[None]
                rows.append(np.take_along_axis(group, best, axis=0)[0])
            values = np.moveaxis(np.array(rows), 0, axis)
    return values


def _draw_profiles(
    axes: Axes, result: Result, maps: list[Map], shown: list[int], frames: list[int], good: int
) -> None:
    """Draw tension over arc length at some frames, before the band that all steps of the run fill."""
    number = 0
    curves = []
    for rope, found in zip(shown, maps, strict=True):
        pieces = found.values.shape[1]
        middle = (np.arange(pieces) + 0.5) * found.length / pieces
        name = f"{escape(result.layout.ropes[rope].name)}, " if len(shown) > 1 else ""
        if _has_band(result):
            low, high = envelope(found, good)
            curves += [low, high]
            axes.fill_between(middle, low, high, **BAND, label="_" if number else ALL_STEPS)  # type: ignore[arg-type]
        for frame in frames:
            curves.append(found.values[frame])
            label = f"{name}{result.time[frame]:.4g} s"
            axes.plot(middle, found.values[frame], label=label, **line_style(number))
            number += 1
    axes.set_ylim(*limits(curves))
    axes.set_xlim(0.0, max(found.length for found in maps))
    axes.set_xlabel(" or ".join(dict.fromkeys(found.label for found in maps)))
    legend_above(axes)


def _has_band(result: Result) -> bool:
    """Tell whether there are steps between frames of which more is known."""
    return result.has_extremes and result.frames > 1


def envelope(found: Map, good: int) -> tuple[Floats, Floats]:
    """Return least and greatest of a whole run [N], (s,) each; NaN where no rope ever was."""
    with np.errstate(invalid="ignore"):
        low = np.where(np.isnan(found.least[:good]), np.inf, found.least[:good]).min(axis=0)
        high = np.where(np.isnan(found.greatest[:good]), -np.inf, found.greatest[:good]).max(axis=0)
    none = low > high
    return np.where(none, np.nan, low), np.where(none, np.nan, high)


def _broke(result: Result, past: Torn, shown: list[int]) -> list[Span]:
    """Return those of the ropes that are shown of which there are steps past the break."""
    spans = [result.layout.ropes[rope] for rope in shown]
    return [span for span in spans if np.isfinite(past.positions[0, span.first]).all()]


def _draw_break(axes: Axes, result: Result, past: Torn, shown: list[int]) -> str:
    """Draw the tension along the rope that broke: the last good frame, and in orange steps past it.

    Returns whose it is, where there are several.
    """
    assert past.tension is not None
    last = past.last
    with np.errstate(all="ignore"):
        after = np.clip(past.tension[past.shapes], -1e30, 1e30)
        jump = np.abs(after - result.tension[last])
    spans = _broke(result, past, shown)
    span = max(spans, key=lambda one: float(jump[:, one.first : one.last].max()))
    rope = result.rope(span.name)
    live = rope.live[last]
    arc = segment_arcs(result, last, span.name)
    curves = [
        np.where(live, curve, np.nan)  # a line would go over what has parted
        for curve in (rope.tension[last], *after[:, span.first : span.last])
    ]
    times = [result.time[last], *past.time[past.shapes]]
    for number, (time, curve) in enumerate(zip(times, curves, strict=True)):
        broken = (
            {"color": BROKEN, "linestyle": DASHES[number - 1]} if number else {"color": COLOURS[0]}
        )
        axes.plot(arc, curve, label=f"{time:.6g} s{' (broken)' if number else ''}", **broken)  # type: ignore[arg-type]
    first, end = float(arc[live][0]), float(arc[live][-1])
    axes.set_xlim(first, end if end > first else first + 1.0)
    axes.set_ylim(*limits(curves))
    axes.set_xlabel(arc_label(result, [span.name]))
    axes.legend(ncols=3, fontsize=8.0, loc="lower left", bbox_to_anchor=(0.0, 1.0))
    return f" of {escape(span.name)}" if len(result.layout.ropes) > 1 else ""
