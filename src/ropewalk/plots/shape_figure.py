"""The shape of the ropes at chosen times."""

from __future__ import annotations

import math
from collections.abc import Sequence
from typing import TYPE_CHECKING

import numpy as np
from matplotlib.axes import Axes
from matplotlib.cm import ScalarMappable
from matplotlib.colors import Normalize, to_rgba
from matplotlib.figure import Figure

from ropewalk.plots.canvas import (
    ANCHOR,
    JOINT,
    LOAD,
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
from ropewalk.plots.given_forces import draw_forces, given_notes, with_room
from ropewalk.plots.outlines import outlines_of
from ropewalk.plots.sight import (
    Floats,
    frame_at,
    gone_ropes,
    held_nodes,
    load_nodes,
    positions_of,
    rope_lines,
    shown_positions,
    sight_notes,
    tame,
    telling_frames,
)
from ropewalk.plots.strands import Strands, live_segments
from ropewalk.plots.style import (
    describe,
    new_figure,
    set_note,
    set_title,
    styled,
    times_map,
)
from ropewalk.plots.torn import BROKEN, broken_note, broken_shapes

if TYPE_CHECKING:
    from ropewalk.record.result import Result

_COLUMNS = 1.6  # [1] how wide shapes side by side are together, over their height
_FEW = 8  # so many times are named one by one, more get a colour bar


@styled
def shape(
    result: Result, times: Sequence[float] | None = None, *, plane: str | None = None
) -> Figure:
    """Draw the ropes at some times [s] (default: six, and where a run breaks two beyond).

    `plane` names the two axes to look at, as "xz"; by default up and the axis of the largest extent.

    Raises ValueError for times outside the run and for a plane that is none.
    """
    whole = backdrop(result, plane)
    frames = telling_frames(result, 6, 2) if times is None else frame_at(result, times)
    frames = sorted(set(frames))
    if not frames:
        raise ValueError("times: () - must be at least one time")
    good = [frame for frame in frames if frame < whole.good]
    seen = with_room(result, backdrop(result, plane, frames), good[-1:])
    upright = _upright(result, seen, frames)
    figure = new_figure(*_size(seen, upright))
    axes = figure.add_subplot()
    if upright:
        _draw_upright(axes, result, seen, frames)
    else:
        _draw_over(axes, result, seen, frames)
        label(axes, seen.view)
    set_title(figure, f"{result.scene.name}: shape", describe(result))
    shown = "the broken shapes leave the picture" if frames[-1] >= seen.good else "not drawn here"
    notes = broken_note(result, whole.good, clipped=shown) + magnification_note(seen.box)
    notes += sight_notes(result, seen.view)
    gone = gone_ropes(result, good[-1]) if good else ()
    notes += given_notes(result.scene, gone=gone, arrows=bool(good) and not upright)
    if upright:
        notes.append(
            "The shapes are set side by side, to one scale; each is upright above its time."
        )
    set_note(figure, notes)
    return figure


def _size(seen: Backdrop, upright: bool) -> tuple[float, float]:
    """Figure size [inch] that suits the box: no large empty margins."""
    if upright:
        return 7.2, 4.8
    ratio = seen.box.height / seen.box.width
    width = 7.2 if ratio < 1.2 else max(4.6, 1.9 + 5.4 / ratio)
    return width, float(np.clip(5.2 * ratio + 1.35, 2.9, 6.8))


def _draw_over(axes: Axes, result: Result, seen: Backdrop, frames: list[int]) -> None:
    """Draw all times over one another, coloured from early to late."""
    colours = times_map()
    scale = Normalize(float(result.time[frames[0]]), float(result.time[frames[-1]]) or 1.0)
    if scale.vmin == scale.vmax:
        scale = Normalize(scale.vmin, scale.vmax + 1.0)  # type: ignore[operator]
    prepare(axes, seen.box)
    draw_still(axes, seen)
    for frame in frames:
        time = float(result.time[frame])
        colour = colours(scale(time))
        draw_moving(axes, result, seen.view, time)
        alone = len(frames) == 1  # several times would hide one another
        draw_ropes(axes, result, seen, frame, colour, f"{time:.4g} s", thick=alone)
        draw_loads(axes, result, seen.view, frame, color=colour)
        draw_anchors(axes, result, seen.view, frame, color=colour, markeredgecolor="black")
    good = [frame for frame in frames if frame < seen.good]
    if good:
        draw_forces(axes, result, seen, good[-1])
    if frames[-1] == result.frames - 1:
        for time, points in broken_shapes(result):
            name = f"{time:.6g} s (broken)"
            draw_points(axes, result, seen, points, BROKEN, name, broken=True)
    figure = axes.figure
    mappable = ScalarMappable(scale, colours)
    if len(frames) > _FEW:
        figure.colorbar(mappable, ax=axes, label="time [s]", shrink=0.9, pad=0.02)
    _legend(axes, result, len(frames) <= _FEW)


def draw_ropes(
    axes: Axes,
    result: Result,
    seen: Backdrop,
    frame: int,
    colour: object,
    name: str,
    *,
    thick: bool = False,
) -> None:
    """Draw all ropes at a frame, with `thick` as thick as they are; the first one's line has the name."""
    points = shown_positions(result, frame)
    time = float(result.time[frame])
    broken = frame >= seen.good
    draw_points(axes, result, seen, points, colour, name, time, broken=broken, thick=thick)


def draw_points(
    axes: Axes,
    result: Result,
    seen: Backdrop,
    places: Floats,
    colour: object,
    name: str,
    time: float = math.inf,
    *,
    broken: bool,
    thick: bool = False,
) -> None:
    """Draw all ropes, nodes at `places` [m], (n, 3), at `time` [s]; broken ones not too far outside.

    With `thick` as thick as they are where that is wider than a line, nearer strands over farther ones.
    """
    if thick and not broken and seen.box.magnified == 1.0 and Strands.wide(axes, result):
        axes.plot([], [], color=colour, label=name)
        live = live_segments(result, time) & np.isfinite(places[:-1] + places[1:]).all(axis=1)
        strands = Strands(axes, result, seen.view)
        shades: Floats = np.tile(to_rgba(colour), (len(live), 1))  # type: ignore[arg-type]
        strands.show(places, shades, live, min(time, float(result.time[-1])))
        strands.artist.set_zorder(2.0)
        return
    points = seen.view.project(places)
    box = seen.box
    if broken:
        points = np.stack(
            [
                tame(points[:, 0], box.left, box.right),
                tame(points[:, 1], box.low, box.high),
            ],
            axis=1,
        )
    for number, line in enumerate(rope_lines(result, points, time)):
        few = {"marker": ".", "markersize": 3.0} if len(line) <= 60 else {}
        axes.plot(
            line[:, 0],
            line[:, 1],
            color=colour,
            label=name if number == 0 else "_",
            **few,  # type: ignore[arg-type]
        )


def _legend(axes: Axes, result: Result, with_times: bool) -> None:
    """Name times, anchors, loads and ground at the right of the axes."""
    handles, names = axes.get_legend_handles_labels()
    if not with_times:
        handles, names = [], []
    grey = {"color": "#808080", "markeredgecolor": "black"}
    if result.scene.anchors:
        handles += axes.plot([], [], **{**ANCHOR, **grey})  # type: ignore[arg-type]
        names.append("anchor")
    if load_nodes(result):
        handles += axes.plot([], [], **{**LOAD, **grey})  # type: ignore[arg-type]
        names.append("load")
    if result.scene.joints:
        handles += axes.plot([], [], **{**JOINT, **grey})  # type: ignore[arg-type]
        names.append("joint")
    if with_times:
        axes.figure.legend(handles, names, title="time", loc="outside right upper")
    elif names:
        axes.legend(
            handles, names, ncols=2, loc="lower right", bbox_to_anchor=(1.0, 1.0), borderaxespad=0.1
        )


# -- ropes that hang straight down -------------------------------------------------------


def _upright(result: Result, seen: Backdrop, frames: list[int]) -> bool:
    """Whether all shapes lie on one upright line, so that they would hide one another.

    Not beside obstacles: across, the picture is then of time, and has room only for what is level.
    """
    good = [f for f in frames if f < seen.good]
    moving = outlines_of(result, seen.view, float(result.time[0]))
    if len(good) < 2 or moving or not all(one.level for one in seen.outlines):
        return False
    points = np.stack([positions_of(result, slice(f, f + 1))[0] for f in good])
    flat = seen.view.project(points)
    spread = np.ptp(flat.reshape(-1, 2), axis=0)
    return bool(spread[0] < 0.02 * spread[1])


def _draw_upright(axes: Axes, result: Result, seen: Backdrop, frames: list[int]) -> None:
    """Draw the shapes side by side, one column per time, to equal scales."""
    view, colours = seen.view, times_map()
    good = [f for f in frames if f < seen.good]
    apart = _COLUMNS * (seen.box.high - seen.box.low) / len(good)  # [m] from one column to the next
    draw_still(axes, seen)
    for column, frame in enumerate(good):
        colour = colours(column / max(len(good) - 1, 1))
        points = view.project(shown_positions(result, frame))
        middle = 0.5 * (np.nanmin(points[:, 0]) + np.nanmax(points[:, 0]))  # NaN: broke before
        for line in rope_lines(result, points, float(result.time[frame])):
            across = line[:, 0] - middle + column * apart
            axes.plot(across, line[:, 1], color=colour, marker=".", markersize=4.0)
        anchors = held_nodes(result, float(result.time[frame]))
        for nodes, style in ((load_nodes(result), LOAD), (anchors, ANCHOR)):
            if nodes:
                at = points[nodes]
                own = {**style, "color": colour, "markeredgecolor": "black"}
                axes.plot(at[:, 0] - middle + column * apart, at[:, 1], **own)  # type: ignore[arg-type]
    axes.set_aspect("equal")
    axes.set_xticks(
        [column * apart for column in range(len(good))], [f"{result.time[f]:.4g}" for f in good]
    )
    axes.set_xlim(-0.6 * apart, (len(good) - 0.4) * apart)
    axes.set_ylim(seen.box.low, seen.box.high)
    axes.grid(False, axis="x")
    axes.set_xlabel("time [s]")
    axes.set_ylabel(f"{view.up_name} [m]")
    _legend(axes, result, with_times=False)
