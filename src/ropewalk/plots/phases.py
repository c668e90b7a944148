"""The phase plane of one node."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np
from matplotlib.collections import LineCollection
from matplotlib.colors import Normalize
from matplotlib.figure import Figure

from ropewalk.plots.curves import drawable
from ropewalk.plots.sight import (
    AXES,
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
from ropewalk.plots.style import describe, new_figure, set_note, set_title, styled, times_map
from ropewalk.plots.torn import broken_note

if TYPE_CHECKING:
    from ropewalk.record.result import Result


@styled
def phase(
    result: Result, node: int | str | tuple[str, int] | None = None, axis: str | None = None
) -> Figure:
    """Draw velocity against position of one coordinate of a node, coloured by time.

    Without a node it is a free end, or the middle of the longest stretch between anchors; `axis` is "x",
    "y", "z" or "up" (default: the one along which the node moves most).

    Raises ValueError for a node or an axis that is not there.
    """
    index = telling_nodes(result, 1)[0] if node is None else node_index(result, node)
    good = good_frames_of(result, result.layout.rope_of(index)[0])
    direction, name = _direction(result, index, axis, good)
    position = along(result.positions[:, index], direction)
    velocity = along(result.velocities[:, index], direction)
    shown = min(good + 2, len(position))
    points = np.stack([drawable(position, good), drawable(velocity, good)], axis=1)[:shown]
    figure = new_figure(5.8, 4.9)
    axes = figure.add_subplot()
    time = result.time
    scale = Normalize(float(time[0]), float(time[good - 1]) if good > 1 else float(time[0]) + 1.0)
    lines = LineCollection(
        list(np.stack([points[:-1], points[1:]], axis=1)),
        cmap=times_map(),
        norm=scale,
        linewidths=1.1,
    )
    lines.set_array(0.5 * (time[: shown - 1] + time[1:shown]))
    axes.add_collection(lines)
    ends = {"linestyle": "none", "markeredgecolor": "black", "zorder": 4}
    axes.plot(*points[:1].T, marker="o", color="white", label="start", **ends)  # type: ignore[arg-type]
    axes.plot(
        *points[good - 1 : good].T,
        marker="D",
        color="black",
        label="last good" if good < len(time) else "end",
        **ends,  # type: ignore[arg-type]
    )
    axes.set_xlim(*limits([position[:good]], 0.06))
    axes.set_ylim(*limits([velocity[:good]], 0.06))
    axes.set_xlabel(f"position {name} [m]")
    axes.set_ylabel(f"velocity {name} [m/s]")
    axes.legend(loc="lower right", bbox_to_anchor=(1.0, 1.0), ncols=2, borderaxespad=0.1)
    figure.colorbar(lines, ax=axes, label="time [s]", pad=0.02)
    set_title(
        figure, f"{result.scene.name}: phase plane of {node_name(result, index)}", describe(result)
    )
    set_note(figure, broken_note(result, good_frames(result)))
    return figure


def _direction(result: Result, index: int, axis: str | None, good: int) -> tuple[Floats, str]:
    """Unit vector and name of the coordinate to draw."""
    if axis == "up":
        return up_label(result)
    if axis is None:
        axis = AXES[int(np.argmax(np.ptp(result.positions[:good, index], axis=0)))]
    if axis not in AXES:
        raise ValueError(f"axis: {axis!r} - must be x, y, z or up")
    return np.eye(3)[AXES.index(axis)], axis
