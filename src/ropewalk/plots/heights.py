"""Height against time of chosen nodes."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING

import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure
from matplotlib.ticker import MaxNLocator

from ropewalk.plots.curves import drawable, lone, mark_break, set_limits, time_limits
from ropewalk.plots.sight import (
    Floats,
    along,
    good_frames,
    good_frames_of,
    limits,
    node_index,
    node_name,
    telling_nodes,
    up_label,
)
from ropewalk.plots.style import (
    ALL_STEPS,
    BAND,
    EARTH,
    describe,
    line_style,
    new_figure,
    set_note,
    set_title,
    styled,
)
from ropewalk.plots.torn import BROKEN, PAST, broken_note
from ropewalk.record.beyond import Torn, until_torn

if TYPE_CHECKING:
    from ropewalk.record.result import Result

_MOST = 6


@styled
def height(result: Result, nodes: Sequence[int | str | tuple[str, int]] | None = None) -> Figure:
    """Draw the height of nodes over time (default: free ends and middles between anchors).

    Behind a curve lies the band between least and greatest of all steps since the frame before.

    A node is a number (negative: from the end) of the first rope, ("rope", 5) or "rope:5".

    Raises ValueError for a node that is not there.
    """
    chosen = (
        telling_nodes(result, _MOST) if nodes is None else [node_index(result, n) for n in nodes]
    )
    if not chosen:
        raise ValueError("nodes: () - must be at least one node")
    up, name = up_label(result)
    good = good_frames(result)
    past = until_torn(result)
    figure = new_figure(7.2 if past is None else 8.4, 3.7)
    axes, beside = figure.add_subplot(), None
    if past is not None:
        figure.clear()
        axes, beside = figure.subplots(1, 2, width_ratios=(2.6, 1.0))
    curves = []
    for index in chosen:
        values = _height_of(result, index, up)
        curves.append(values)
    for number, (index, values) in enumerate(zip(chosen, curves, strict=True)):
        curve = drawable(values, good, curves)
        _draw_band(axes, result, index, good, "_" if number else ALL_STEPS)
        axes.plot(
            result.time, curve, label=node_name(result, index), **line_style(number), **lone(result)
        )
    axes.set_xlim(*time_limits(result, good))
    set_limits(axes, curves, good)
    _draw_ground(axes, result)
    mark_break(axes, result, good)
    axes.set_xlabel("time [s]")
    axes.set_ylabel("height [m]" if name == "height" else f"height {name} [m]")
    if past is not None and beside is not None:
        seen = [n for n in chosen if np.isfinite(past.positions[0, n]).all()]  # of what broke
        extra = [_jumping(result, past, up)] if nodes is None or not seen else []
        more = [n for n in extra if n not in chosen]
        numbers = {n: number for number, n in enumerate([*chosen, *more]) if n in [*seen, *more]}
        _draw_break(beside, result, past, numbers, more, up)
    figure.legend(loc="outside right upper")
    set_title(figure, f"{result.scene.name}: height of nodes", describe(result))
    notes = broken_note(result, good)
    ropes = len(result.layout.ropes)
    if nodes is None and ropes > _MOST:
        notes.append(f"One node of each of the first {_MOST} of {ropes} ropes is shown.")
    set_note(figure, notes)
    return figure


def _height_of(result: Result, index: int, up: Floats) -> Floats:
    """Return the height of a node [m], (frames,); NaN where its rope broke and others went on."""
    values = np.array(along(result.positions[:, index], up))
    good = good_frames_of(result, result.layout.rope_of(index)[0])
    if good < good_frames(result):
        values[good:] = np.nan
    return values


def _draw_ground(axes: Axes, result: Result) -> None:
    """Draw the ground where it is in view."""
    ground, (low, high) = result.scene.ground, axes.get_ylim()
    if ground is not None and low <= ground.height <= high:
        axes.axhline(ground.height, color=EARTH, linewidth=1.2, label="ground")


def _draw_band(axes: Axes, result: Result, index: int, good: int, label: str) -> None:
    """Draw between which heights a node was in the steps between frames."""
    if result.has_extremes and result.frames > 1:
        low, high = (array[:good, index] for array in (result.least_height, result.greatest_height))
        axes.fill_between(result.time[:good], low, high, step="pre", label=label, **BAND)  # type: ignore[arg-type]


def _jumping(result: Result, past: Torn, up: Floats) -> int:
    """Return the node whose height changes most in the last step past the break that is drawn."""
    before = past.positions[-2] if len(past.time) > 1 else result.positions[past.last]
    return int(np.nanargmax(np.abs(along(past.positions[-1] - before, up))))


def _draw_break(
    axes: Axes, result: Result, past: Torn, nodes: dict[int, int], more: list[int], up: Floats
) -> None:
    """Draw how the run broke: its last frames, and the single steps past them in orange.

    `nodes` have the numbers of their lines' styles.
    """
    have = result.time[: past.last + 1]
    span = float(past.time[-1] - have[-1])
    from_frame = int(np.searchsorted(have, have[-1] - 2.0 * span))
    start = max(0, min(from_frame, len(have) - 3))
    curves = []
    for index, number in nodes.items():
        before = along(result.positions[start : len(have), index], up)
        after = np.concatenate([before[-1:], along(past.positions[:, index], up)])
        time = np.concatenate([have[-1:], past.time])
        name = node_name(result, index) if index in more else "_"  # the others have their names
        axes.plot(have[start:], before, label=name, **line_style(number))
        few = {"marker": ".", "markersize": 4.0} if len(time) < 40 else {}
        axes.plot(time, after, color=BROKEN, linewidth=1.0, **few)  # type: ignore[arg-type]
        curves += [before, after]
    axes.axvspan(float(have[-1]), float(past.time[-1]), facecolor=BROKEN, alpha=0.08, lw=0.0)
    axes.set_xlim(float(have[start]), float(past.time[-1]))
    axes.set_ylim(*limits(curves))
    axes.xaxis.set_major_locator(MaxNLocator(3))
    axes.set_xlabel("time [s]")
    axes.set_title(PAST, loc="left", fontsize=8.5, pad=3.0, color=BROKEN)
