"""Reaction forces at the anchors."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure

from ropewalk.plots.curves import drawable, lone, mark_break, set_limits, time_limits
from ropewalk.plots.sight import AXES, Floats, good_frames
from ropewalk.plots.style import (
    COLOURS,
    GREY,
    describe,
    escape,
    line_style,
    new_figure,
    scaled_axis,
    set_note,
    set_title,
    styled,
)
from ropewalk.plots.torn import broken_note

if TYPE_CHECKING:
    from ropewalk.record.result import Result

_PANELS = 6  # more anchors than that share one panel, with magnitudes only
_LINES = 12
MOST = "largest of all steps"
_LIGHT = {"color": "0.6", "linewidth": 0.8, "zorder": 1.5}


@styled
def reactions(result: Result, *, on_anchors: bool = False) -> Figure:
    """Draw the force of each anchor on its rope over time: components and magnitude [N].

    With `on_anchors` that of the rope on the anchor, the opposite one.

    The light curve is the largest magnitude of all steps since the frame before, which limits are chosen by,
    so that no peak between frames is missed.
    """
    good = good_frames(result)
    names = [escape(name) for name in result.layout.anchor_names]
    forces = 0.0 - result.reactions if on_anchors else np.asarray(result.reactions)
    notes = broken_note(result, good)
    if names:
        whose = ("ropes", "anchors") if on_anchors else ("anchors", "ropes")
        notes.insert(0, "Forces of the {} on the {}.".format(*whose))
    if not names:
        figure = new_figure(7.2, 2.4)
        figure.add_subplot().text(0.5, 0.5, "no anchors", ha="center", color=GREY)
        figure.axes[0].set_axis_off()
    elif len(names) <= _PANELS:
        figure = new_figure(7.2, min(1.35 + max(1.5, 3.0 - 0.6 * len(names)) * len(names), 10.0))
        grid = figure.subplots(len(names), 1, sharex=True, squeeze=False)[:, 0]
        sizes = _known(np.abs(forces[:good])).max(axis=(0, 1))
        parts = [bool(size > 1e-9 * sizes.max()) for size in sizes]
        for row, axes in enumerate(grid):
            _draw_anchor(axes, result, row, forces[:, row], good, parts)
            if len(names) > 1:
                axes.set_title(names[row], loc="left", fontsize=8.5, pad=3.0)
        grid[-1].set_xlabel("time [s]")
        figure.align_ylabels()
        figure.legend(*grid[0].get_legend_handles_labels(), loc="outside right upper")
    else:
        figure = new_figure(7.2, 3.9)
        _draw_magnitudes(figure.add_subplot(), result, names, forces, good)
        if result.has_extremes and result.frames > 1:
            notes.append("Light steps: the largest of all steps since the frame before.")
        if len(names) > _LINES:
            notes.append(f"The {_LINES} largest of {len(names)} anchors are shown.")
    what = "forces on the anchors" if on_anchors else "reactions"
    if len(names) == 1:
        of = "force on" if on_anchors else "reaction of"
        what = f"{of} anchor '{result.layout.anchor_names[0]}'"
    set_title(figure, f"{result.scene.name}: {what}", describe(result))
    set_note(figure, notes)
    return figure


def magnitude(forces: Floats) -> Floats:
    """Return the lengths of vectors (..., 3); no overflow below 1e300."""
    with np.errstate(all="ignore"):
        length: Floats = np.hypot(np.hypot(forces[..., 0], forces[..., 1]), forces[..., 2])
    return length


def _greatest(result: Result, row: int) -> Floats | None:
    """Return the largest force of an anchor in all steps since the frame before [N], (f,); None: not kept."""
    if not result.has_extremes or result.frames < 2:
        return None
    return np.asarray(result.read("greatest_reactions", 0, result.frames)[:, row])


def _known(sizes: Floats) -> Floats:
    """Return sizes of forces with 0 for those of ropes that broke before, which are NaN."""
    return np.nan_to_num(sizes, nan=0.0)


def _draw_anchor(
    axes: Axes, result: Result, row: int, force: Floats, good: int, parts: list[bool]
) -> None:
    """Draw one anchor's force; only the axes of `parts`, the others are always zero."""
    size = magnitude(force)
    most = _greatest(result, row)
    curves = [*([] if most is None else [most]), size, *(force[:, k] for k in range(3) if parts[k])]
    if most is not None:
        axes.step(result.time, drawable(most, good, curves), where="pre", label=MOST, **_LIGHT)  # type: ignore[arg-type]
    black = {"color": "black", "linewidth": 1.6, "label": "magnitude", **lone(result)}
    axes.plot(result.time, drawable(size, good, curves), **black)
    for k in range(3):
        if not parts[k]:
            continue
        curve = drawable(force[:, k], good, curves)
        axes.plot(
            result.time, curve, color=COLOURS[k], linewidth=1.0, label=AXES[k], **lone(result)
        )
    largest = set_limits(axes, curves, good)
    _finish(axes, result, largest, good)
    release = result.scene.anchors[row].release_time
    if release is not None and release <= result.time[-1]:
        axes.axvline(release, color=GREY, linestyle=":", linewidth=1.2)
        axes.annotate(
            "released",
            (release, 1.0),
            xycoords=("data", "axes fraction"),
            xytext=(3, -3),
            textcoords="offset points",
            va="top",
            fontsize=8.0,
            color=GREY,
        )


def _draw_magnitudes(
    axes: Axes, result: Result, names: list[str], forces: Floats, good: int
) -> None:
    """Draw the magnitudes of many anchors in one panel."""
    sizes = magnitude(forces)
    peaks = [_greatest(result, row) for row in range(len(names))]
    most = np.stack([sizes[:, row] if p is None else p for row, p in enumerate(peaks)], axis=1)
    order = np.argsort(-_known(most[:good]).max(axis=0), kind="stable")[:_LINES]
    shown = [most[:, row] for row in order]
    for number, row in enumerate(sorted(order)):
        style = line_style(number)
        curve = drawable(sizes[:, row], good, shown)
        axes.plot(result.time, curve, label=names[row], **style, **lone(result))
        if peaks[row] is not None:
            light = {**_LIGHT, "color": style["color"], "alpha": 0.5}
            axes.step(result.time, drawable(most[:, row], good, shown), where="pre", **light)
    largest = set_limits(axes, shown, good)
    _finish(axes, result, largest, good)
    axes.set_xlabel("time [s]")
    axes.figure.legend(loc="outside right upper")


def _finish(axes: Axes, result: Result, largest: float, good: int) -> None:
    scaled_axis(axes, "force", "N", largest)
    axes.set_xlim(*time_limits(result, good))
    axes.axhline(0.0, color="#808080", linewidth=0.6, zorder=0.5)
    mark_break(axes, result, good)
