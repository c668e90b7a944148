"""Shapes of ropes at several times as one small picture: the earlier, the paler."""

from __future__ import annotations

from collections.abc import Sequence
from typing import NamedTuple
from xml.sax.saxutils import escape

import numpy as np

from ropewalk.core.arrays import Floats
from ropewalk.scene import Scene
from ropewalk.simulation import Simulation

WIDTH, HEIGHT, MARGIN = 160, 100, 9
_MOST_POINTS = 80
_PALEST = 0.22  # opacity of the first shape
_BALL, _PIN, _NODE = 4.0, 3.0, 3.0  # radii of masses and anchors, width of nodes


class Shot(NamedTuple):
    """Where everything is at one time [m]."""

    ropes: tuple[Floats, ...]  # nodes of each piece, (n, 3)
    anchors: Floats  # (a, 3)
    masses: Floats  # loads, and the ends of ropes of one segment, (m, 3)


class Manner(NamedTuple):
    """How shapes are drawn."""

    apart: tuple[float, float] = (0.0, 0.0)  # right of and below the shape before [m]
    oblique: float = 0.0  # how far right and up a metre into the depth is drawn [m]
    room: float | None = (
        None  # for later shapes, in parts of the first one's size; the rest is cut off
    )
    nodes: bool = False  # whether nodes are drawn


def shot(simulation: Simulation, origin: Floats | None = None, magnify: float = 1.0) -> Shot:
    """Return a simulation as it is now, its ways from `origin` (n, 3) magnified."""
    scene, layout, state = simulation.scene, simulation.layout, simulation.arrays
    x = simulation.positions.copy()
    if origin is not None:
        x = origin + magnify * (x - origin)
    held = set(layout.anchor_nodes)
    masses = [
        layout.node(rope.node_index(load.node), rope.name)
        for rope in scene.ropes
        for load in rope.loads
    ]
    for rope, span in zip(scene.ropes, layout.ropes, strict=True):
        if rope.segments == 1 and not rope.loads:
            masses.append(span.end if span.start in held else span.start)
    ropes = tuple(x[span.first : span.last + 1] for span in layout.ropes)
    return Shot(ropes, state.anchor_x[state.held.astype(bool)], x[masses])


def draw(
    shots: Sequence[Shot],
    scene: Scene,
    manner: Manner = Manner(),  # noqa: B008 - it cannot be changed
) -> str:
    """Return shapes in the order of time, seen across the longest side of all of them; up is up."""
    up = np.array(scene.up)
    middle, across = _sight(shots, up)
    deep = np.cross(up, across)
    right = across + manner.oblique * deep
    down = -up - manner.oblique * deep
    plane = np.stack([right, down], axis=1)
    flat = [
        [(points - middle) @ plane + i * np.array(manner.apart) for points in _parts(one)]
        for i, one in enumerate(shots)
    ]
    place, scale = _frame(flat if manner.room is None else flat[:1], manner.room or 0.0)
    body = [_ground(scene, middle, up, place, scale)]
    for i, parts in enumerate(flat):
        age = 1.0 if len(flat) == 1 else i / (len(flat) - 1)
        opacity = _PALEST + (1.0 - _PALEST) * age**1.5
        shapes = _shapes([place + scale * points for points in parts], manner.nodes)
        body.append(f'<g opacity="{opacity:.2f}">{shapes}</g>')
    return document("".join(body), scene.name)


def _parts(one: Shot) -> list[Floats]:
    return [*one.ropes, one.anchors, one.masses]


def _sight(shots: Sequence[Shot], up: Floats) -> tuple[Floats, Floats]:
    """A middle, and the level direction of the longest extent, which points to the right."""
    points = np.concatenate([nodes for one in shots for nodes in one.ropes])
    middle = points.mean(axis=0)
    level = points - middle
    level = level - np.outer(level @ up, up)
    if np.abs(level).max() < 1e-9:
        along = np.eye(3)[int(np.argmin(np.abs(up)))]
        return middle, along - (along @ up) * up
    across = np.linalg.svd(level, full_matrices=False)[2][0]
    return middle, -across if across[np.argmax(np.abs(across))] < 0.0 else across


def _frame(planes: Sequence[Sequence[Floats]], room: float) -> tuple[Floats, float]:
    """Shift and scale that fit points in the plane, and some room around them, into the picture."""
    points = np.concatenate([points for flat in planes for points in flat])
    low, high = points.min(axis=0), points.max(axis=0)
    more = room * float((high - low).max())
    size = np.maximum(high - low + 2.0 * more * np.array([0.0, 1.0]), 1e-12)
    space = np.array([WIDTH - 2 * MARGIN, HEIGHT - 2 * MARGIN])
    scale = float((space / size).min())
    return np.array([WIDTH / 2, HEIGHT / 2]) - scale * 0.5 * (low + high), scale


def _ground(scene: Scene, middle: Floats, up: Floats, place: Floats, scale: float) -> str:
    """The ground as a line."""
    if scene.ground is None:
        return ""
    y = place[1] + scale * float(middle @ up - scene.ground.height)
    return f'<path d="M0,{y:.1f}H{WIDTH}" opacity="0.4" stroke-width="1"/>'


def _shapes(parts: Sequence[Floats], with_nodes: bool) -> str:
    *ropes, anchors, masses = parts
    found = []
    for nodes in ropes:
        step = max(1, len(nodes) // _MOST_POINTS)
        chosen = np.concatenate([nodes[:-1:step], nodes[-1:]])
        chosen = np.clip(chosen, -9 * WIDTH, 9 * WIDTH)  # what breaks flies far
        text = " ".join(f"{x:.1f},{y:.1f}" for x, y in chosen)
        found.append(f'<polyline points="{text}"/>')
        if with_nodes:
            ways = "".join(f"M{x:.1f},{y:.1f}h0" for x, y in chosen)  # round caps make dots
            found.append(f'<path d="{ways}" stroke-width="{_NODE}"/>')
    found += [_dot(point, _PIN, "square") for point in anchors]
    found += [_dot(point, _BALL, "round") for point in masses]
    return "".join(found)


def _dot(point: Floats, size: float, kind: str) -> str:
    x, y = point
    if kind == "round":
        return f'<circle cx="{x:.1f}" cy="{y:.1f}" r="{size}" fill="currentColor" stroke="none"/>'
    return (
        f'<rect x="{x - size:.1f}" y="{y - size:.1f}" width="{2 * size}" height="{2 * size}" '
        'fill="currentColor" stroke="none"/>'
    )


def document(body: str, title: str = "") -> str:
    """Return an SVG document with this in it."""
    return (
        f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {WIDTH} {HEIGHT}" '
        'fill="none" stroke="currentColor" stroke-width="2" stroke-linejoin="round" '
        f'stroke-linecap="round"><title>{escape(title)}</title>{body}</svg>'
    )
