"""Outlines of obstacles in the plane of a figure."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING, Any, NamedTuple

import numpy as np
from matplotlib.axes import Axes
from matplotlib.patches import PathPatch
from matplotlib.path import Path

from ropewalk.laws.obstacle_places import middle_at, stays, turn_of
from ropewalk.laws.obstacle_rows import corners_of
from ropewalk.plots.sight import Floats, Sight
from ropewalk.record.obstacle_table import obstacle_table, table_then

if TYPE_CHECKING:
    from ropewalk.record.result import Result

_ROUND = 96  # corners of a circle
_FAR = 1e4  # times the extent of the ropes: half of what has no end
_EDGE_ON = 1e-6  # [1] of a plane's normal that may point at the viewer
_ROOM = (
    1.0  # times the ropes' extent: what of an obstacle is farther away need not be in the picture
)
FACE = "#E3E6EA"
_LOOK = {"facecolor": FACE, "edgecolor": "#7B8794", "linewidth": 1.0}


class Outline(NamedTuple):
    """What an obstacle covers: a region and perhaps a hole in it, corners (n, 2) [m].

    A mesh covers its triangles; lines (m, 2, 2) are edges at which its surface turns away from the viewer.
    """

    outer: Floats
    hole: Floats | None = None
    triangles: Floats | None = None  # (t, 3, 2)
    lines: Floats | None = None
    endless: bool = False  # a plane's solid side, or a trough

    @property
    def level(self) -> bool:
        """Whether it is all that is below a height."""
        (left, low), (right, high) = self.outer[:2]
        return (
            self.endless
            and len(self.outer) == 4
            and abs(high - low) <= _EDGE_ON * abs(right - left)
        )


def outlines_of(result: Result, view: Sight, time: float | None = None) -> tuple[Outline, ...]:
    """Return the outlines of obstacles; planes only where they are seen edge-on.

    Those of obstacles that stay where they are, or with a `time` [s] of those that move or turn away, as they
    are then.
    """
    table = obstacle_table(result.scene, result.layout)
    if table is None:
        return ()
    points = result.read("positions", 0, 1)[0]
    size = float(np.ptp(points, axis=0).max()) or 1.0
    found: list[Outline | None] = []
    then = table if time is None else table_then(result, table, time)
    for row, body in enumerate(result.scene.obstacles):
        if stays(table, row) == (time is None):
            turn = turn_of(then, row, time or 0.0)
            center = middle_at(then, row, time or 0.0)
            if body.kind in ("mesh", "sdf"):
                found.append(_surface(body, center, turn, view))
                continue
            parts = (
                body.kind,
                center,
                turn @ table.axis[row],
                _turned(body.kind, table.size[row], turn),
            )
            found.append(_outline(*parts, view, size))
    return tuple(one for one in found if one is not None)


def _turned(kind: str, sizes: Floats, turn: Floats) -> Floats:
    """Return the sizes of a body with the direction that is among them turned."""
    found, first = sizes.copy(), {"box": 4, "half-pipe": 1}.get(kind)
    if first is not None:
        found[first : first + 3] = turn @ sizes[first : first + 3]
    return found


def _outline(
    kind: str, center: Floats, axis: Floats, sizes: Floats, view: Sight, extent: float
) -> Outline | None:
    middle, along = view.project(center), view.project(axis)
    turns = np.linspace(0.0, 2.0 * np.pi, _ROUND, endpoint=False)
    disc = np.stack([np.cos(turns), np.sin(turns)], axis=1)
    half = float(min(sizes[1], _FAR * extent))
    ends = np.stack([middle - half * along, middle + half * along])
    if kind == "plane":
        return _edge_on(middle, along, _FAR * extent)
    if kind == "half-pipe":
        return _trough(middle, along, view.project(sizes[1:4]), float(sizes[0]), extent)
    if kind == "sphere":
        return Outline(middle + sizes[0] * disc)
    if kind == "torus":
        return _ring(middle, along, sizes, disc)
    if kind == "capsule":
        return Outline(hull((ends[:, None] + sizes[0] * disc).reshape(-1, 2)))
    if kind == "cylinder":
        face = sizes[0] * _tilted(along, disc)
        return Outline(hull((ends[:, None] + face).reshape(-1, 2)))
    signs = np.array([[x, y, z] for x in (-1, 1) for y in (-1, 1) for z in (-1, 1)])
    edges = np.stack([sizes[4:7], np.cross(axis, sizes[4:7]), axis])
    corners = view.project(center + signs * sizes[:3] @ edges)
    return Outline(hull((corners[:, None] + sizes[3] * disc).reshape(-1, 2)))


def _surface(body: Any, center: Floats, turn: Floats, view: Sight) -> Outline:
    """Return what a mesh covers; a rounding is not drawn."""
    faces = np.array(body.faces)
    seen = view.project(center + corners_of(body) @ turn.T)
    corners = seen[faces]
    first, second = corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0]
    front = first[:, 0] * second[:, 1] - first[:, 1] * second[:, 0] > 0.0
    edges = np.stack([faces, np.roll(faces, -1, axis=1)], axis=2).reshape(-1, 2)
    sides: dict[tuple[int, int], bool] = {}
    for edge, shown in zip(edges.tolist(), np.repeat(front, 3).tolist(), strict=True):
        sides[edge[0], edge[1]] = shown
    turning = [edge for edge, shown in sides.items() if shown and not sides[edge[1], edge[0]]]
    corners[~front] = corners[~front, ::-1]
    lines = seen[np.array(turning, dtype=np.int64).reshape(-1, 2)]
    return Outline(hull(seen), triangles=corners, lines=lines)


def _edge_on(point: Floats, normal: Floats, far: float) -> Outline | None:
    """Return the solid side of a plane whose normal lies in the picture, else None."""
    if abs(float(np.hypot(*normal)) - 1.0) > _EDGE_ON:
        return None
    way = far * np.array([-normal[1], normal[0]])
    below = -far * normal
    corners = np.stack([point + way, point - way, point - way + below, point + way + below])
    return Outline(corners, endless=True)


def _trough(
    middle: Floats, along: Floats, above: Floats, radius: float, extent: float
) -> Outline | None:
    """Return what is solid about a half-pipe that is seen along its axis, else None."""
    if float(np.hypot(*along)) > _EDGE_ON:
        return None
    turns = np.linspace(0.0, np.pi, _ROUND)[:, None]
    far, beside = _FAR * extent, np.array([above[1], -above[0]])
    inside = middle - radius * (np.cos(turns) * beside + np.sin(turns) * above)
    wide, high, low = far * beside, far * above, middle - far * above
    edges = np.stack([middle - wide, middle + wide])
    return Outline(
        np.concatenate(
            [
                np.stack([low - wide, edges[0] + high, inside[0] + high]),
                inside,
                np.stack([inside[-1] + high, edges[1] + high, low + wide]),
            ]
        ),
        endless=True,
    )


def _tilted(along: Floats, disc: Floats) -> Floats:
    """Return how a circle of radius 1 looks whose axis, of length 1, appears as `along`, (n, 2)."""
    shown = float(np.hypot(*along))
    first = along / shown if shown > 0.0 else np.array([1.0, 0.0])
    short = np.sqrt(max(0.0, 1.0 - shown**2))
    second = np.array([-first[1], first[0]])
    found: Floats = short * disc[:, :1] * first + disc[:, 1:] * second
    return found


def _ring(middle: Floats, along: Floats, sizes: Floats, disc: Floats) -> Outline:
    """Return a ring's outline: its circle as it looks, widened by the bar's radius on either side."""
    circle = sizes[0] * _tilted(along, disc)
    outer = Outline(middle + hull((circle[:, None] + sizes[1] * disc).reshape(-1, 2)))
    short = float(np.sqrt(max(0.0, 1.0 - float(along @ along))))
    if sizes[0] * short**2 <= sizes[1]:  # the bar is wider than the circle's sharpest bend
        return outer
    step = np.roll(circle, -1, axis=0) - np.roll(circle, 1, axis=0)
    inward = np.stack([-step[:, 1], step[:, 0]], axis=1)
    inward *= -np.sign((inward * circle).sum(axis=1, keepdims=True))
    inward /= np.linalg.norm(inward, axis=1, keepdims=True)
    return outer._replace(hole=middle + circle + sizes[1] * inward)


def hull(points: Floats) -> Floats:
    """Return the corners of the convex hull of points (n, 2), counter-clockwise (Andrew's chains)."""
    order = points[np.lexsort((points[:, 1], points[:, 0]))]

    def half(row: Floats) -> list[Floats]:
        found: list[Floats] = []
        for p in row:
            while len(found) > 1:
                (ax, ay), (bx, by) = found[-2], found[-1]
                if (bx - ax) * (p[1] - ay) - (by - ay) * (p[0] - ax) > 0.0:
                    break
                found.pop()
            found.append(p)
        return found[:-1]

    return np.array(half(order) + half(order[::-1]))


def _clockwise(corners: Floats) -> Floats:
    """Return corners the other way round than those of a hull: what they enclose is left empty."""
    after = np.roll(corners, -1, axis=0)
    area = (corners[:, 0] * after[:, 1] - corners[:, 1] * after[:, 0]).sum()
    return corners[::-1] if area > 0.0 else corners


def near(outlines: Sequence[Outline], points: Floats) -> Floats:
    """Return corners that a picture of points (..., 2) must hold, those far away put nearer."""
    flat = points.reshape(-1, 2)
    flat = flat[np.isfinite(flat).all(axis=1)]
    low, high = flat.min(axis=0), flat.max(axis=0)
    room = _ROOM * float((high - low).max())
    whole = [one.outer for one in outlines if not one.endless]
    small = [outer for outer in whole if np.ptp(outer, axis=0).max() < 4.0 * room]
    corners = np.concatenate([np.empty((0, 2)), *small])
    found: Floats = np.clip(corners, low - room, high + room)
    return found


def _draw_surface(axes: Axes, one: Outline) -> list[PathPatch]:
    """Draw a mesh: its triangles without their edges, then the lines."""
    assert one.triangles is not None
    assert one.lines is not None
    closed = np.concatenate([one.triangles, one.triangles[:, :1]], axis=1).reshape(-1, 2)
    codes = np.tile([Path.MOVETO, Path.LINETO, Path.LINETO, Path.CLOSEPOLY], len(one.triangles))
    seams = _LOOK | {"edgecolor": _LOOK["facecolor"], "linewidth": 0.3}
    inside = PathPatch(Path(closed, codes), zorder=0.52, **seams)
    pairs = np.tile([Path.MOVETO, Path.LINETO], len(one.lines))
    rim = PathPatch(Path(one.lines.reshape(-1, 2), pairs), zorder=0.53, **_LOOK, fill=False)
    for patch in (inside, rim):
        axes.add_patch(patch)
    return [inside, rim]


def draw_outlines(axes: Axes, outlines: Sequence[Outline]) -> list[PathPatch]:
    """Draw obstacles over the grid and behind everything else; return what was drawn."""
    drawn = []
    for one in outlines:
        if one.triangles is not None:
            drawn += _draw_surface(axes, one)
            continue
        parts = [one.outer] if one.hole is None else [one.outer, _clockwise(one.hole)]
        vertices = np.concatenate([np.vstack([part, part[:1]]) for part in parts])
        codes = np.concatenate(
            [[Path.MOVETO, *[Path.LINETO] * (len(part) - 1), Path.CLOSEPOLY] for part in parts]
        )
        drawn.append(PathPatch(Path(vertices, codes), zorder=0.52, **_LOOK))
        axes.add_patch(drawn[-1])
    return drawn
