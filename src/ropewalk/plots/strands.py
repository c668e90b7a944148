"""Ropes as thick as they are, nearer strands over farther ones."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np
from matplotlib.axes import Axes
from matplotlib.collections import PolyCollection
from matplotlib.colors import to_rgba
from numpy.typing import NDArray

from ropewalk.plots.behind import Obstacles
from ropewalk.plots.outlines import FACE
from ropewalk.plots.sight import Floats, Sight, along, parted_segments

if TYPE_CHECKING:
    from ropewalk.record.result import Result

LINE = 2.2  # width of a rope that is drawn as a line [points]
_EDGE = 1.3  # width with a white edge, in diameters: where strands cross one sees which is nearer
_PALE = 0.8  # [1] of an obstacle's colour in that of a strand behind it
_MITRE = 1.5  # at most: how much wider a bend is


class Strands:
    """The ropes of a run as ribbons of their diameter."""

    def __init__(self, axes: Axes, result: Result, view: Sight) -> None:
        self._axes, self._view = axes, view
        self._toward = np.cross(view.across, view.up)
        self._half = np.zeros(result.layout.segments)  # [m]
        for span, rope in zip(result.layout.ropes, result.scene.ropes, strict=True):
            self._half[span.first : span.last] = 0.5 * rope.diameter
        self._obstacles = Obstacles(result, self._toward)
        self.artist = PolyCollection([], closed=True)
        axes.add_collection(self.artist)

    @staticmethod
    def wide(axes: Axes, result: Result) -> bool:
        """Whether the thickest rope is wider than a line, on axes that have been laid out."""
        return max(rope.diameter for rope in result.scene.ropes) > LINE / points_per_metre(axes)

    def show(self, places: Floats, colours: Floats, live: NDArray[np.bool_], time: float) -> None:
        """Draw segments between nodes at places [m], (n, 3), with colours (s, 4); only those that live.

        What an obstacle hides at a time [s] is pale, as if it were seen through it.
        """
        points = self._view.project(places)
        half = np.maximum(
            self._half, 0.5 * LINE / points_per_metre(self._axes)
        )  # never out of sight
        inner, outer = (ribbon(points, live, share * half) for share in (1.0, _EDGE))
        middle = 0.5 * (places[:-1] + places[1:])
        hidden = self._obstacles.hide(places, half, time)[:, None]
        face, white = to_rgba(FACE), np.ones(4)
        shades = np.where(hidden, _PALE * np.array(face) + (1.0 - _PALE) * colours, colours)
        shades = np.concatenate([np.where(hidden, face, white), shades])
        # A white edge comes before its neighbours, which it would cut, and after what is a diameter farther.
        depth = along(middle, self._toward)
        order = np.argsort(np.concatenate([depth - half, depth]), kind="stable")
        order = order[np.tile(live, 2)[order]]
        drawn = [(r, g, b, a) for r, g, b, a in shades[order].tolist()]
        self.artist.set_verts(list(np.concatenate([outer, inner])[order]))
        self.artist.set_facecolor(drawn)
        self.artist.set_edgecolor(drawn)
        self.artist.set_linewidth(np.where(order < len(live), 0.0, 0.9).tolist())  # no gaps


def points_per_metre(axes: Axes) -> float:
    """Return how large the axes draw [points / m], with equal scales."""
    (left, right), (low, high) = axes.get_xlim(), axes.get_ylim()
    room = axes.get_window_extent()
    pixels = min(room.width / (right - left), room.height / (high - low))
    return 72.0 * pixels / float(axes.figure.dpi)


def live_segments(result: Result, time: float) -> NDArray[np.bool_]:
    """Return which segments join two nodes of one rope and have not parted by a time [s], (s,)."""
    live = np.ones(result.layout.segments, dtype=bool)
    for span in result.layout.ropes[:-1]:
        live[span.last] = False
    live[parted_segments(result, time)] = False
    return live


def ribbon(points: Floats, live: NDArray[np.bool_], half: Floats) -> Floats:
    """Return the corners, (s, 4, 2), of segments of half a width (s,) between points (n, 2).

    Neighbours that live share their corners, so that bends have no gaps.
    """
    way = np.diff(points, axis=0)
    length = np.linalg.norm(way, axis=1, keepdims=True)
    way = np.where(length > 0.0, way / np.maximum(length, 1e-300), 0.0)
    own = way * live[:, None]
    bend = np.zeros_like(points)
    bend[:-1] += own
    bend[1:] += own
    size = np.linalg.norm(bend, axis=1, keepdims=True)
    there = live & (length[:, 0] > 0.0)  # rope on a drum lies on one point, and has no way
    both = np.zeros(len(points))
    both[:-1] += there
    both[1:] += there
    # In a bend the middle of both ways is shorter than they are: the ribbon's edge is farther out.
    mitre = np.minimum(both[:, None] / np.maximum(size, 1e-12), _MITRE)
    middle = mitre * bend / np.maximum(size, 1e-12)
    side = np.stack([-middle[:, 1], middle[:, 0]], axis=1)
    first, last = side[:-1] * half[:, None], side[1:] * half[:, None]
    begin, end = points[:-1], points[1:]
    return np.stack([begin + first, end + last, end - last, begin - first], axis=1)
