"""Axes in metres: room around the rope, the ground, anchors, loads."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np
from matplotlib.axes import Axes
from matplotlib.patches import PathPatch

from ropewalk.plots.outlines import Outline, draw_outlines, near, outlines_of
from ropewalk.plots.sight import (
    Floats,
    Sight,
    good_frames,
    ground_height,
    held_nodes,
    load_nodes,
    positions_of,
    shown_positions,
    sight,
    spread,
)
from ropewalk.plots.style import EARTH

if TYPE_CHECKING:
    from ropewalk.record.result import Result

_FLAT = 10.0  # a box flatter than this is drawn with unequal scales
_THICK = 12.0  # diameters: where ropes that touch each other are no higher, scales are equal
ANCHOR = {"marker": "s", "color": "black", "markersize": 5.5, "linestyle": "none"}
LOAD = {"marker": "o", "color": "#404040", "markersize": 7.0, "linestyle": "none"}
JOINT = {"marker": "o", "color": "#404040", "markersize": 3.0, "linestyle": "none"}


@dataclass(frozen=True)
class Box:
    """Limits of the drawing's axes [m], and how much larger heights are drawn than widths."""

    left: float
    right: float
    low: float
    high: float
    magnified: float = 1.0

    @property
    def width(self) -> float:
        return self.right - self.left

    @property
    def height(self) -> float:
        """Height of the box in units of its horizontal scale [m]."""
        return (self.high - self.low) * self.magnified


def box_around(
    points: Floats, ground: float | None, *, roomy: bool = False, thick: float = 0.0
) -> Box:
    """Return a box with a margin around points (..., 2) [m], and the ground where it is near.

    A rope that is long and nearly straight gets unequal scales, else its waves could not be seen;
    a `roomy` box has equal scales and much room, for what a break throws about. Ropes that touch each other
    are `thick` [m]: where that is much of their height, as in a knot, scales are equal, and they are seen so.
    """
    flat = points.reshape(-1, 2)
    flat = flat[np.isfinite(flat).all(axis=1)]
    low, high = flat.min(axis=0), flat.max(axis=0)
    size = float((high - low).max()) or 1.0
    if ground is not None and low[1] - ground < size:
        low[1] = min(low[1], ground)
    span = high - low
    size = float(span.max()) or 1.0
    if roomy:
        middle = 0.5 * (low + high)
        low, high = np.minimum(low, middle - 0.3 * size), np.maximum(high, middle + 0.3 * size)
    elif span[0] >= _FLAT * span[1] > max(1e-9 * size, _FLAT * _THICK * thick):
        room = np.array([0.04 * span[0], 0.15 * span[1]])
        low, high = low - room, high + room
        factor = (high[0] - low[0]) / (high[1] - low[1]) / 3.0
        return Box(low[0], high[0], low[1], high[1], float(_round_down(factor)))
    low, high = low - 0.05 * size, high + 0.05 * size
    short = 0.3 * size - (high - low)
    pad = np.maximum(short, 0.0) / 2.0
    return Box(low[0] - pad[0], high[0] + pad[0], low[1] - pad[1], high[1] + pad[1])


def _round_down(value: float) -> float:
    """1, 2, 3, 4 or 5 times a power of ten, at most `value`."""
    power = 10.0 ** np.floor(np.log10(value))
    return float(max(step * power for step in (1.0, 2.0, 3.0, 4.0, 5.0) if step * power <= value))


def prepare(axes: Axes, box: Box) -> None:
    """Set limits and scales."""
    axes.set_xlim(box.left, box.right)
    axes.set_ylim(box.low, box.high)
    axes.set_aspect(box.magnified, adjustable="box")


def label(axes: Axes, view: Sight, *, across: bool = True, up: bool = True) -> None:
    """Label the axes in metres."""
    if across:
        axes.set_xlabel(f"{view.across_name} [m]")
    if up:
        axes.set_ylabel(f"{view.up_name} [m]")


def draw_still(axes: Axes, seen: Backdrop) -> None:
    """Draw ground and obstacles where they are in view."""
    draw_outlines(axes, seen.outlines)
    height, box = seen.ground, seen.box
    if height is None or height < box.low:
        return
    axes.axhspan(box.low, height, facecolor="#EFEAE4", edgecolor="none", zorder=0.5)
    axes.axhline(height, color=EARTH, linewidth=1.2, zorder=0.6, label="_ground")


def draw_moving(axes: Axes, result: Result, view: Sight, time: float) -> list[PathPatch]:
    """Draw the obstacles that move where they are at a time [s]; return what was drawn."""
    return draw_outlines(axes, outlines_of(result, view, time))


def draw_anchors(
    axes: Axes,
    result: Result,
    view: Sight,
    frame: int,
    places: Floats | None = None,
    **style: object,
) -> None:
    """Draw the anchors that hold at a frame; `places` (nodes, 3) [m]: of a time beside it."""
    nodes = held_nodes(result, float(result.time[frame]))
    at = view.project((shown_positions(result, frame) if places is None else places)[nodes])
    axes.plot(at[:, 0], at[:, 1], **{**ANCHOR, "zorder": 4, **style})  # type: ignore[arg-type]


def draw_loads(
    axes: Axes,
    result: Result,
    view: Sight,
    frame: int,
    places: Floats | None = None,
    **style: object,
) -> None:
    """Draw the extra masses, and a dot where ropes are tied; `places` as of `draw_anchors`."""
    places = shown_positions(result, frame) if places is None else places
    tied = list(result.layout.tied_nodes)
    if tied:
        at = view.project(places[tied])
        own = {key: value for key, value in style.items() if key != "markersize"}
        axes.plot(at[:, 0], at[:, 1], **{**JOINT, "zorder": 3.4, **own})  # type: ignore[arg-type]
    nodes = load_nodes(result)
    if nodes:
        at = view.project(places[nodes])
        axes.plot(at[:, 0], at[:, 1], **{**LOAD, "zorder": 3.5, **style})  # type: ignore[arg-type]


@dataclass(frozen=True)
class Backdrop:
    """All that drawings of one run share: the plane, the box, how far the run is good."""

    view: Sight
    box: Box
    ground: float | None
    good: int
    outlines: tuple[Outline, ...] = ()  # of obstacles that stay where they are


def backdrop(
    result: Result, plane: str | None, frames: list[int] | None = None, *, still: bool = False
) -> Backdrop:
    """Make the backdrop: its box holds the rope at the good ones of `frames` (default: of all frames).

    What is drawn `still` is seen in the plane of its shape, not of its motion.
    """
    view, good = sight(result, plane, still=still), good_frames(result)
    ground = ground_height(result, view)
    if frames is None:
        frames = spread(good, 400)
    inside = [f for f in frames if f < good] or [good - 1]
    points = np.stack([positions_of(result, slice(f, f + 1))[0] for f in inside])
    broken = good < len(result.time)
    flat = view.project(points)
    outlines = outlines_of(result, view)
    moving = [one for f in inside for one in outlines_of(result, view, float(result.time[f]))]
    around = np.concatenate([flat.reshape(-1, 2), near([*outlines, *moving], flat)])
    touch = result.scene.contact is not None
    thick = max(rope.diameter for rope in result.scene.ropes) if touch else 0.0
    box = box_around(around, ground, roomy=broken, thick=thick)
    return Backdrop(view, box, ground, good, outlines)


def magnification_note(box: Box) -> list[str]:
    """Say that the scales differ."""
    if box.magnified == 1.0:
        return []
    return [f"Heights are drawn {box.magnified:g} times as large as widths."]
