"""Where and when contacts stick and slip: nodes against time, the mode by colour."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np
from matplotlib.axes import Axes
from matplotlib.colors import BoundaryNorm, ListedColormap
from matplotlib.figure import Figure
from matplotlib.patches import Patch
from matplotlib.ticker import MaxNLocator
from numpy.typing import NDArray

from ropewalk.plots.sight import good_frames
from ropewalk.plots.style import (
    COLOURS,
    describe,
    escape,
    new_figure,
    set_note,
    set_title,
    styled,
)
from ropewalk.plots.torn import broken_note
from ropewalk.record.contact_modes import MODES, OPEN, SLIPS, STICKS, UNKNOWN
from ropewalk.record.contacts import RANK, node_modes

if TYPE_CHECKING:
    from ropewalk.record.result import Result

_MOST_ROPES = 6
_LOOKS = {OPEN: "#FFFFFF", STICKS: COLOURS[0], SLIPS: COLOURS[1], UNKNOWN: "#B8B8B8"}
_PIXELS = 1600  # columns of an image; more frames than that are joined


@styled
def sticking(result: Result) -> Figure:
    """Draw which nodes stick and which slip, on obstacles and on ropes, against time.

    Of a segment that lies on another rope both nodes are coloured. Raises ValueError for a run in which
    nothing can touch anything, or whose contact forces were not recorded.
    """
    if "contact_force" not in result.source.names:
        raise ValueError("result: has no contact_force - it needs obstacles, or a [contact] table")
    good = good_frames(result)
    modes = np.maximum(node_modes(result)[:good], OPEN)  # ropes that broke do nothing
    spans = result.layout.ropes[:_MOST_ROPES]
    figure = new_figure(7.2, min(1.5 + max(1.2, 2.9 - 0.5 * len(spans)) * len(spans), 9.0))
    grid = figure.subplots(len(spans), 1, squeeze=False, sharex=True)[:, 0]
    for axes, span in zip(grid, spans, strict=True):
        ever = np.flatnonzero(result.rope(span.name).live[:good].any(axis=0))  # off a drum
        first, last = span.first + int(ever[0]), span.first + int(ever[-1]) + 1
        _draw(axes, result.time[:good], modes[:, first : last + 1], first - span.start)
        axes.set_ylabel("node")
        axes.yaxis.set_major_locator(MaxNLocator(5, integer=True))
        if len(result.layout.ropes) > 1:
            axes.set_title(escape(span.name), loc="left", fontsize=8.5, pad=3.0)
    grid[-1].set_xlabel("time [s]")
    seen = [mode for mode in (STICKS, SLIPS, UNKNOWN) if (modes == mode).any()]
    patches = [Patch(facecolor=_LOOKS[mode], label=MODES[mode]) for mode in seen]
    if patches:
        figure.legend(handles=patches, loc="outside upper right", ncols=len(patches), fontsize=8.0)
    set_title(figure, f"{result.scene.name}: sticking and slipping", describe(result))
    set_note(figure, broken_note(result, good) + _notes(result, modes, seen))
    return figure


def _draw(axes: Axes, time: NDArray[np.float64], modes: NDArray[np.int8], first: int) -> None:
    """Draw what nodes from number `first` on do, (frames, nodes)."""
    step = -(-len(modes) // _PIXELS)
    starts = np.arange(0, len(modes), step)
    ranks = np.maximum.reduceat(RANK[modes], starts, axis=0)  # what is rare stays to be seen
    half = 0.5 * float(time[-1] - time[0]) / max(len(time) - 1, 1) or 0.5
    axes.grid(False)
    axes.imshow(
        np.argsort(RANK)[ranks].T,
        origin="lower",
        aspect="auto",
        extent=(
            float(time[0]) - half,
            float(time[-1]) + half,
            first - 0.5,
            first + modes.shape[1] - 0.5,
        ),
        interpolation="nearest",
        cmap=ListedColormap([_LOOKS[mode] for mode in range(len(MODES))]),
        norm=BoundaryNorm(np.arange(len(MODES) + 1) - 0.5, len(MODES)),
        rasterized=True,
    )


def _notes(result: Result, modes: NDArray[np.int8], seen: list[int]) -> list[str]:
    touching = int((modes != OPEN).sum())
    if not touching:
        return ["Nothing touches anything in this run."]
    shares = [f"{MODES[mode]} {(modes == mode).sum() / touching * 100:.3g} %" for mode in seen]
    notes = [f"Of all nodes that touch, over all frames: {', '.join(shares)}."]
    if len(result.layout.ropes) > _MOST_ROPES:
        notes.append(f"The first {_MOST_ROPES} of {len(result.layout.ropes)} ropes are shown.")
    return notes
