"""The forces in one frame: the ropes coloured by tension, the anchors' forces, tension along the ropes."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np
from matplotlib.axes import Axes
from matplotlib.cm import ScalarMappable
from matplotlib.collections import LineCollection
from matplotlib.colors import Normalize
from matplotlib.figure import Figure
from matplotlib.ticker import MaxNLocator

from ropewalk.plots.arcs import arc_label, node_arcs, segment_arcs
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
from ropewalk.plots.given_forces import arrow_scale, draw_forces, given_notes, roomy
from ropewalk.plots.legends import legend_above
from ropewalk.plots.margin_notes import margin_notes
from ropewalk.plots.room import Room
from ropewalk.plots.sight import (
    Floats,
    anchors_at,
    gone_ropes,
    good_frames,
    holding,
    limits,
    shown_positions,
)
from ropewalk.plots.style import (
    COLOURS,
    describe,
    escape,
    line_style,
    new_figure,
    scaled_axis,
    set_note,
    set_title,
    styled,
)
from ropewalk.plots.tensions import colour_scale, line_map, reach
from ropewalk.plots.torn import broken_note
from ropewalk.words.prefixes import prefixed

if TYPE_CHECKING:
    from ropewalk.record.result import Result

_MOST = 8  # places whose forces are told
_NEAR = 0.02  # [1] of the drawing's size: anchors nearer to each other have one number
_LETTERS = 8.0  # [pt]
_WIDE = 5.6  # [inch] of the drawing, at most


@styled
def forces(result: Result, *, plane: str | None = None) -> Figure:
    """Draw the last frame: shape and anchors' forces, and the tension along the ropes.

    Of an equilibrium it is the only one, of a broken run the last good one. `plane` names the two axes to
    look at, as "xz".

    Raises ValueError for a plane that is none.
    """
    good = good_frames(result)
    frame = good - 1
    seen = backdrop(result, plane, [frame], still=True)  # forces pull along the ropes
    box = seen.box
    height = float(np.clip(6.4 * box.height / box.width, 1.6, 4.6))
    figure = new_figure(7.2, height + 3.2)
    above, below = figure.subplots(2, 1, height_ratios=[height, 1.7])
    scale, colours, extend = colour_scale([result.tension[frame][result.live[frame]]])
    pulls = _draw_shape(above, result, seen, frame, height, scale, colours)
    bar = figure.colorbar(
        ScalarMappable(scale, line_map(colours)),
        ax=above,
        extend=extend,
        pad=0.015,
        aspect=16,
        panchor=(0.5, 0.5),
    )
    scaled_axis(bar.ax, result.tension_name, "N", reach(scale))
    _draw_profile(below, result, frame)
    when, about = f"forces at t = {result.time[frame]:.4g} s", describe(result)
    if result.status == "at rest":
        when = "at rest"
        about = f"equilibrium; at most {result.residual:.1e} N left on a node"
    set_title(figure, f"{result.scene.name}: {when}", about)
    clipped = "the last good frame is drawn"
    notes = broken_note(result, good, clipped=clipped) + magnification_note(box)
    notes += margin_notes(result, frame, frame + 1)
    notes += pulls
    notes += given_notes(result.scene, gone=gone_ropes(result, frame))
    set_note(figure, notes)
    return figure


def _draw_shape(
    axes: Axes,
    result: Result,
    seen: Backdrop,
    frame: int,
    tall: float,
    scale: Normalize,
    colours: str,
) -> list[str]:
    """Draw the ropes and all that pulls on them, `tall` [inch]; return what to say of anchors' forces."""
    points = seen.view.project(shown_positions(result, frame))
    ends = np.stack([points[:-1], points[1:]], axis=1)
    live = result.live[frame]
    prepare(axes, seen.box)
    draw_still(axes, seen)
    draw_moving(axes, result, seen.view, float(result.time[frame]))
    axes.add_collection(
        LineCollection(
            list(ends[live]),
            array=result.tension[frame][live],
            cmap=line_map(colours),
            norm=scale,
            linewidths=2.2,
            capstyle="round",
            zorder=3,
        )
    )
    pulls = _draw_forces(axes, result, seen, frame, tall)
    draw_anchors(axes, result, seen.view, frame)
    draw_loads(axes, result, seen.view, frame)
    label(axes, seen.view)
    (left, right), (low, high) = axes.get_xlim(), axes.get_ylim()
    wide = tall * (right - left) / ((high - low) * seen.box.magnified)  # with equal scales
    axes.xaxis.set_major_locator(MaxNLocator(int(np.clip(1.7 * wide, 2, 9))))
    return pulls


def _draw_forces(axes: Axes, result: Result, seen: Backdrop, frame: int, tall: float) -> list[str]:
    """Draw the anchors' forces as arrows, and write their sizes beside them; return what to say of them."""
    holds = holding(result, float(result.time[frame]))
    forces = np.nan_to_num(result.reactions[frame][holds])  # NaN: of a rope that broke before
    sizes = np.linalg.norm(forces, axis=1)
    reach = arrow_scale(seen, result, largest=float(sizes.max(initial=0.0)))
    given = draw_forces(axes, result, seen, frame, scale=reach)
    if len(given):
        _make_room(axes, given)
    if not sizes.size or sizes.max() == 0.0:
        return []
    places, ways = seen.view.project(anchors_at(result, frame)), seen.view.project(forces)
    drawn = np.flatnonzero(sizes > 1e-9 * sizes.max())
    tips = places + reach * ways * (1.0, 1.0 / seen.box.magnified)
    for row in drawn:
        axes.annotate(
            "",
            xy=tuple(tips[row]),
            xytext=tuple(places[row]),
            arrowprops={"arrowstyle": "-|>", "color": COLOURS[1], "linewidth": 1.3},
            annotation_clip=False,
        )
    _make_room(axes, tips[drawn])
    notes = ["Orange arrows: the anchors' forces on the ropes."]
    room = Room(axes, (_WIDE, tall), seen.box.magnified)
    groups = _at_one_place(
        places, drawn[np.argsort(-sizes[drawn], kind="stable")].tolist(), seen.box
    )
    groups.sort(key=lambda rows: (-float(f"{sizes[rows[0]]:.4g}"), -len(rows)))
    written = [_write_size(axes, room, rows, tips, ways, sizes) for rows in groups[:_MOST]]
    if not all(written) or len(groups) > _MOST:
        notes.append("Where they stand close only the largest are told.")
    return notes


def _at_one_place(places: Floats, rows: list[int], box: Box) -> list[list[int]]:
    """Return rows of anchors, those at one place together."""
    near = _NEAR * max(box.width, box.high - box.low)
    groups: list[list[int]] = []
    for row in rows:
        beside = (g for g in groups if np.linalg.norm(places[g[0]] - places[row]) < near)
        group = next(beside, None)
        if group is None:
            groups.append([row])
        else:
            group.append(row)
    return groups


def _write_size(
    axes: Axes, room: Room, rows: list[int], tips: Floats, ways: Floats, sizes: Floats
) -> bool:
    """Write the size of the first of forces at one place, the largest, where there is room; tell whether."""
    tip, way, size = tips[rows[0]], ways[rows[0]], float(sizes[rows[0]])
    words = prefixed(size, "N")
    if len(rows) > 1:
        words = f"{len(rows)} anchors, at most {words}"
    side = "left" if way[0] >= 0.0 else "right"
    ha = side if abs(way[0]) > 0.2 * size else "center"
    if len(rows) > 1:  # long words
        ha = room.side(tip, f" {words} ", wanted=ha, size=_LETTERS)
    va = "bottom" if way[1] >= -0.2 * size else "top"
    if not room.take(tip, f" {words} ", ha=ha, va=va, size=_LETTERS):
        return False
    style = {"fontsize": _LETTERS, "color": COLOURS[1], "annotation_clip": False}
    axes.annotate(f" {words} ", xy=tuple(tip), ha=ha, va=va, **style)  # type: ignore[arg-type]
    return True


def _make_room(axes: Axes, tips: np.ndarray) -> None:
    """Widen the axes so that the arrows and what is written at them lie inside."""
    box = roomy(Box(*axes.get_xlim(), *axes.get_ylim()), tips)
    axes.set_xlim(box.left, box.right)
    axes.set_ylim(box.low, box.high)


def _draw_profile(axes: Axes, result: Result, frame: int) -> None:
    """Draw the tension of every segment along its rope."""
    curves = []
    most = 0.0
    for number, span in enumerate(result.layout.ropes):
        rope = result.rope(span.name)
        arc = segment_arcs(result, frame, span.name)
        values = np.where(rope.live[frame], rope.tension[frame], np.nan)  # no line over what parted
        curves.append(values)
        most = max(most, float(node_arcs(result, frame, span.name)[-1]))
        name = escape(span.name) if np.isfinite(values).any() else "_"  # it broke before
        axes.plot(arc, values, marker=".", label=name, **line_style(number))
    low, high = limits(curves)
    axes.set_ylim(min(low, 0.0) if low < 0.5 * high else low, high)
    axes.set_xlim(0.0, most or 1.0)
    axes.set_xlabel(arc_label(result, [span.name for span in result.layout.ropes]))
    scaled_axis(axes, result.tension_name, "N", max(map(abs, axes.get_ylim())))
    if 1 < len(curves) <= 8:
        legend_above(axes)
