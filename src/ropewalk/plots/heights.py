"""Height against time of chosen nodes."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING

from matplotlib.figure import Figure

from ropewalk.plots.curves import drawable, mark_break, set_limits, time_limits
from ropewalk.plots.style import (
    EARTH,
    describe,
    line_style,
    new_figure,
    set_note,
    set_title,
    styled,
)
from ropewalk.plots.view import (
    along,
    broken_note,
    good_frames,
    node_index,
    node_name,
    telling_nodes,
    up_label,
)

if TYPE_CHECKING:
    from ropewalk.record.result import Result

_MOST = 6


@styled
def height(result: Result, nodes: Sequence[int | str | tuple[str, int]] | None = None) -> Figure:
    """Draw the height of nodes over time (default: free ends and middles between anchors).

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
    figure = new_figure(7.2, 3.7)
    axes = figure.add_subplot()
    ground = result.scene.ground
    if ground is not None:
        axes.axhline(ground.height, color=EARTH, linewidth=1.2, label="ground")
    curves = []
    for index in chosen:
        values = along(result.positions[:, index], up)
        curves.append(values)
    for number, (index, values) in enumerate(zip(chosen, curves, strict=True)):
        curve = drawable(values, good, curves)
        axes.plot(result.time, curve, label=node_name(result, index), **line_style(number))
    axes.set_xlim(*time_limits(result, good))
    set_limits(axes, curves, good)
    mark_break(axes, result, good)
    axes.set_xlabel("time [s]")
    axes.set_ylabel("height [m]" if name == "height" else f"height {name} [m]")
    figure.legend(loc="outside right upper")
    set_title(figure, f"{result.scene.name}: height of nodes", describe(result))
    notes = broken_note(result, good)
    ropes = len(result.layout.ropes)
    if nodes is None and ropes > _MOST:
        notes.append(f"One node of each of the first {_MOST} of {ropes} ropes is shown.")
    set_note(figure, notes)
    return figure
