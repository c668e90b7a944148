"""Small pictures of scenes for the menu: ropes and anchors at time zero, as SVG."""

from __future__ import annotations

from functools import lru_cache
from typing import Any
from xml.sax.saxutils import escape

import numpy as np

from ropewalk.build import build
from ropewalk.live.sources import START
from ropewalk.scene import Scene, SceneError
from ropewalk.scene.presets import names, preset

WIDTH, HEIGHT, MARGIN = 160, 100, 12
_MOST_POINTS = 80


def svg(name: str, stage: Any) -> str | None:
    """Return the picture of a preset, or of the scene that the program was started with."""
    if name == START:
        start = getattr(getattr(stage, "session", None), "start", None)
        return draw(start[0]) if start else None
    return _preset(name) if name in names() else None


@lru_cache(maxsize=100)
def _preset(name: str) -> str:
    return draw(preset(name))


def draw(scene: Scene) -> str:
    """Return a scene at time zero: up is up, seen across its longest side."""
    try:
        model = build(scene)
    except SceneError:
        return _document("")
    up = np.array(scene.up)
    points = model.state.x.T - model.state.x.T.mean(axis=0)
    flat = points - np.outer(points @ up, up)
    across = np.linalg.svd(flat, full_matrices=False)[2][0] if flat.any() else np.zeros(3)
    if across[np.argmax(np.abs(across))] < 0.0:
        across = -across
    plane = np.stack([points @ across, -(points @ up)], axis=1)
    low, high = plane.min(axis=0), plane.max(axis=0)
    room = np.array([WIDTH - 2 * MARGIN, HEIGHT - 2 * MARGIN])
    size = np.maximum(high - low, 1e-12)
    scale = float((room / size).min())
    plane = (plane - 0.5 * (low + high)) * scale + np.array([WIDTH / 2, HEIGHT / 2])
    parts = []
    for span in model.layout.ropes:
        nodes = plane[span.start : span.end + 1]
        step = max(1, len(nodes) // _MOST_POINTS)
        chosen = np.concatenate([nodes[:-1:step], nodes[-1:]])
        text = " ".join(f"{x:.1f},{y:.1f}" for x, y in chosen)
        parts.append(f'<polyline points="{text}"/>')
    for index in model.layout.anchor_nodes:
        x, y = plane[index]
        parts.append(f'<circle cx="{x:.1f}" cy="{y:.1f}" r="3.5" fill="currentColor"/>')
    return _document("".join(parts), scene.name)


def _document(body: str, title: str = "") -> str:
    return (
        f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {WIDTH} {HEIGHT}" '
        'fill="none" stroke="currentColor" stroke-width="2" stroke-linejoin="round" '
        f'stroke-linecap="round"><title>{escape(title)}</title>{body}</svg>'
    )
