"""The scene as a drawing for a workshop: shape, anchors, loads, and the lengths that matter."""

from __future__ import annotations

import itertools
import math
from typing import TYPE_CHECKING, Any

import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure

from ropewalk.plots.canvas import (
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
from ropewalk.plots.legends import legend_above
from ropewalk.plots.room import Room
from ropewalk.plots.sight import Floats, anchors_at, load_nodes, positions_of, rope_lines
from ropewalk.plots.style import (
    COLOURS,
    GREY,
    escape,
    line_style,
    new_figure,
    set_note,
    set_title,
    styled,
)

if TYPE_CHECKING:
    from ropewalk.record.result import Result

_MOST = 8  # names, loads and sags that are written; more would hide each other
_SMALL = 2e-3  # [1] of the drawing's size: shorter than this a length is not told
_WIDE = 6.0  # [inch] of the drawing, at most
_NEAR = 0.02  # [1] of the drawing's size: anchors nearer to each other have one label
_FOOT = 0.15  # [1] of the box: anchors below that have their names below them
# Where words of a load may stand, and within which angle of that no rope may leave it [rad].
_SIDES = (((0, -1), 1.3), ((0, 1), 1.2), ((1, 0), 0.5), ((-1, 0), 0.5))
_ARROWS = {"arrowstyle": "<|-|>", "color": GREY, "linewidth": 0.9, "shrinkA": 0.0, "shrinkB": 0.0}


@styled
def dimensions(result: Result, *, plane: str | None = None) -> Figure:
    """Draw the first frame with its dimensions: distances of the outer anchors, sags, loads.

    Of an equilibrium it is the only frame. `plane` names the two axes to look at, as "xz".

    Raises ValueError for a plane that is none.
    """
    seen = with_room(result, backdrop(result, plane, [0], still=True), [0])
    height = float(np.clip(6.4 * seen.box.height / seen.box.width, 2.0, 3.8))
    figure = new_figure(7.2, height + 1.3)
    axes = figure.subplots()
    prepare(axes, seen.box)
    draw_still(axes, seen)
    draw_moving(axes, result, seen.view, 0.0)
    points = positions_of(result, slice(0, 1))[0]
    for number, (span, line) in enumerate(
        zip(result.layout.ropes, rope_lines(result, seen.view.project(points)), strict=True)
    ):
        style = line_style(number) | {"linewidth": 1.8, "zorder": 3}
        axes.plot(line[:, 0], line[:, 1], label=escape(span.name), **style)
    draw_anchors(axes, result, seen.view, 0)
    draw_loads(axes, result, seen.view, 0)
    draw_forces(axes, result, seen, 0)
    ends = seen.view.project(_ends(result, points))
    loads = seen.view.project(points[load_nodes(result)])
    _measure_ends(axes, ends, seen, np.concatenate([ends, loads]))
    sags = _write_sags(axes, result, points, seen, height)
    _name_anchors(axes, result, seen)
    more = _name_loads(axes, result, seen.view.project(points), seen)
    if any(rope.loads for rope in result.scene.ropes):  # room for the lowest one's words
        low, high = axes.get_ylim()
        axes.set_ylim(min(low, seen.box.low - 0.08 * (seen.box.high - seen.box.low)), high)
    label(axes, seen.view)
    if 1 < len(result.layout.ropes) <= _MOST:
        legend_above(axes)
    at_rest = result.status == "at rest"
    set_title(figure, result.scene.name, "at rest" if at_rest else "at time zero")
    notes = [*sags, *more, *_depth(result, points, seen), *magnification_note(seen.box)]
    set_note(figure, notes + given_notes(result.scene))
    return figure


def _ends(result: Result, points: Floats) -> Floats:
    """Return the places of the anchors, or of the ropes' ends where there are fewer than two [m]."""
    held = anchors_at(result, 0)
    if len(held) > 1:
        return held
    found: Floats = points[[node for s in result.layout.ropes for node in (s.start, s.end)]]
    return found


def _measure_ends(axes: Axes, ends: Floats, seen: Backdrop, named: Floats) -> None:
    """Write how far the outer anchors are apart, across below the drawing and upward beside it.

    Below what is `named` there, (m, 2) [m], too.
    """
    box = seen.box
    size = max(box.width, box.high - box.low)
    (left, low), (right, high) = ends.min(axis=0), ends.max(axis=0)
    high_of = box.high - box.low
    foot = bool((named[:, 1] < box.low + _FOOT * high_of).any())  # their names stand below them
    below, beside = box.low - (0.14 if foot else 0.07) * high_of, box.right + 0.04 * box.width
    if right - left > _SMALL * size:
        for x in (left, right):
            axes.plot([x, x], [ends[ends[:, 0] == x][0, 1], below], color=GREY, linewidth=0.5)
        _measure(axes, (left, below), (right, below), f"{right - left:.5g} m")
        axes.set_ylim(below - 0.07 * high_of, box.high)
    if high - low > _SMALL * size:
        for y in (low, high):
            axes.plot([ends[ends[:, 1] == y][0, 0], beside], [y, y], color=GREY, linewidth=0.5)
        _measure(axes, (beside, low), (beside, high), f"{high - low:.5g} m", beside=True)
        axes.set_xlim(box.left, box.right + 0.16 * box.width)


def _measure(axes: Axes, a: Any, b: Any, text: str, *, beside: bool = False) -> None:
    """Draw a line with two arrows from `a` to `b`, and its length on it or `beside` it."""
    axes.annotate("", xy=a, xytext=b, arrowprops=_ARROWS, annotation_clip=False, zorder=4)
    axes.annotate(
        text,
        xy=(0.5 * (a[0] + b[0]), 0.5 * (a[1] + b[1])),
        xytext=(6.0 if beside else 0.0, 0.0),
        textcoords="offset points",
        ha="left" if beside else "center",
        va="center",
        fontsize=8.5,
        bbox={
            "facecolor": "white",
            "edgecolor": "none",
            "pad": 1.0,
            "alpha": 0.85 if beside else 1.0,
        },
        annotation_clip=False,
        zorder=2.5 if beside else 5,  # ropes go over what stands beside
    )


def _write_sags(
    axes: Axes, result: Result, points: Floats, seen: Backdrop, tall: float
) -> list[str]:
    """Draw the sag of every span between anchors of a scene at rest, the largest ones where there are many.

    The drawing is `tall` [inch]. Returns what could not be drawn.
    """
    if result.status != "at rest" or not any(result.scene.gravity):
        return []
    found, size = [], max(seen.box.width, seen.box.high - seen.box.low)
    up = np.asarray(result.scene.up)
    for first, last in _spans(result):
        part = points[first : last + 1]
        heights, chord = part @ up, _chord(part, up)
        at = int(np.argmax(chord - heights))
        sag = float((chord - heights)[at])
        if sag >= _SMALL * size and at not in (0, len(part) - 1):
            ends = seen.view.project(np.stack([part[at] + sag * up, part[at]]))
            found.append((sag, ends, seen.view.project(part[[0, -1]])))
    found.sort(key=lambda one: -one[0])
    room, drawn = Room(axes, (_WIDE, tall), seen.box.magnified), 0
    for sag, ends, chord_line in found:
        words = f"sag {sag:.4g} m"
        middle = ends.mean(axis=0)
        if drawn < _MOST and room.take(middle, words, ha="left", va="center", size=8.5, aside=6.0):
            drawn += 1
            axes.plot(*chord_line.T, color=GREY, linewidth=0.6, linestyle=(0, (6, 4)), zorder=1)
            _measure(axes, tuple(ends[0]), tuple(ends[1]), words, beside=True)
    if drawn == len(found):
        return []
    return [f"{drawn} of {len(found)} sags are drawn: where they lie close, the largest."]


def _spans(result: Result) -> list[tuple[int, int]]:
    """Return pairs of held nodes of one rope with free ones between."""
    found = []
    for span in result.layout.ropes:
        held = sorted({n for n in result.layout.anchor_nodes if span.start <= n <= span.end})
        found += [pair for pair in itertools.pairwise(held) if pair[1] - pair[0] > 1]
    return found


def _chord(part: Floats, up: Floats) -> Floats:
    """Return the height of the straight line between the ends over every node, (n,) [m]."""
    heights = part @ up
    level = part - np.outer(heights, up) - (part[0] - heights[0] * up)
    way = level[-1]
    across = float(way @ way)
    if across == 0.0:
        return np.full(len(part), min(heights[0], heights[-1]))
    chord: Floats = heights[0] + level @ way / across * (heights[-1] - heights[0])
    return chord


def _name_anchors(axes: Axes, result: Result, seen: Backdrop) -> None:
    names = result.layout.anchor_names
    places = seen.view.project(anchors_at(result, 0))
    if not 0 < len(places) <= _MOST or len(places) != len(names):
        return
    near = _NEAR * max(seen.box.width, seen.box.high - seen.box.low)
    written: list[tuple[Floats, list[str]]] = []  # those at one place have one label
    for name, place in zip(names, places, strict=True):
        for where, there in written:
            if float(np.linalg.norm(where - place)) < near:
                there.append(name)
                break
        else:
            written.append((place, [name]))
    foot = seen.box.low + _FOOT * (seen.box.high - seen.box.low)
    for place, here in written:
        axes.annotate(
            escape(", ".join(here)),
            xy=tuple(place),
            xytext=(0.0, -15.0 if place[1] < foot else 7.0),  # ropes go up from the ground
            textcoords="offset points",
            ha="center",
            fontsize=8.5,
            bbox={"facecolor": "white", "edgecolor": "none", "pad": 0.5, "alpha": 0.85},
            annotation_clip=False,
            zorder=4.5,
        )


def _name_loads(axes: Axes, result: Result, flat: Floats, seen: Backdrop) -> list[str]:
    """Write the mass of every load beside it, where no rope goes; return what could not be written."""
    loads = [
        (span.start + rope.node_index(load.node), load.mass)
        for rope, span in zip(result.scene.ropes, result.layout.ropes, strict=True)
        for load in rope.loads
    ]
    near = _NEAR * max(seen.box.width, seen.box.high - seen.box.low)
    written: list[
        tuple[Floats, list[float], list[int]]
    ] = []  # those beside each other have one label
    for node, mass in loads[:_MOST]:
        beside = (there for there in written if np.linalg.norm(there[0] - flat[node]) < near)
        where, masses, nodes = next(beside, (flat[node].copy(), [], []))
        if not masses:
            written.append((where, masses, nodes))
        masses.append(mass)
        nodes.append(node)
        where[1] = min(where[1], flat[node][1])
    for where, masses, nodes in written:
        across, up = _clear_side(result, flat, nodes, seen)
        axes.annotate(
            f"{' + '.join(f'{mass:.5g}' for mass in masses)} kg",
            xy=tuple(where),
            xytext=(9.0 * across, -14.0 if up < 0.0 else 8.0 * up),
            textcoords="offset points",
            ha=("center", "left", "right")[across],
            va="center" if across else "baseline",
            fontsize=8.5,
            color=COLOURS[1],
            bbox={"facecolor": "white", "edgecolor": "none", "pad": 0.5, "alpha": 0.85},
            annotation_clip=False,
            zorder=5,
        )
    if len(loads) <= _MOST:
        return []
    sizes = {mass for _, mass in loads}
    if len(sizes) == 1:
        return [f"All {len(loads)} loads are of {sizes.pop():.5g} kg; the first {_MOST} are named."]
    return [f"The first {_MOST} of {len(loads)} loads are named."]


def _clear_side(result: Result, flat: Floats, nodes: list[int], seen: Backdrop) -> tuple[int, int]:
    """Return the side of a load on which no rope leaves it, (across, up): below where that is one.

    Of all that are taken, the one that is farthest from every rope.
    """
    spans = result.layout.ropes
    ways = [
        flat[other] - flat[node]
        for node in nodes
        for other in (node - 1, node + 1)
        if any(span.start <= min(node, other) and max(node, other) <= span.end for span in spans)
    ]
    ways = [way * (1.0, seen.box.magnified) for way in ways if way.any()]
    if not ways:
        return _SIDES[0][0]

    def room(side: tuple[int, int], wide: float) -> float:
        return min(
            math.acos(np.clip(way @ side / np.hypot(*way), -1.0, 1.0)) / wide for way in ways
        )

    clear = (side for side, wide in _SIDES if room(side, wide) >= 1.0)
    return next(clear, max(_SIDES, key=lambda one: room(*one))[0])


def _depth(result: Result, points: Floats, seen: Backdrop) -> list[str]:
    """Say how far the ropes reach out of the plane of the drawing, where they do."""
    normal = np.cross(seen.view.across, seen.view.up)
    reach = float(np.ptp(points @ normal))
    if reach <= _SMALL * max(seen.box.width, seen.box.high - seen.box.low):
        return []
    return [f"The ropes reach {reach:.4g} m across the plane of the drawing, too."]
