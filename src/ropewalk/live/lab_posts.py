"""Posts of the lab: the obstacles that stand still, and what their contacts ask of the ropes."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import numpy as np

from ropewalk.laws.obstacle import radius_of
from ropewalk.laws.obstacle_rows import place_of

if TYPE_CHECKING:
    from ropewalk.lowering import Model
    from ropewalk.scene import Scene

KINDS = ("plane", "sphere", "cylinder", "capsule")


def posts_of(model: Model) -> dict[str, Any]:
    """Return a scene's posts and, for each rope, what their stiffness follows from, in SI units."""
    scene = model.scene
    if not scene.obstacles:
        return {"posts": [], "lines": []}
    return {"posts": [_post(scene, body) for body in scene.obstacles], "lines": _lines(model)}


def _post(scene: Scene, body: Any) -> dict[str, Any]:
    center, axis, size = place_of(body)
    long = body.kind in ("cylinder", "capsule") and np.isfinite(size[1])
    return {
        "kind": body.kind,
        "center": [float(value) for value in center],
        "axis": [float(value) for value in axis],
        "radius": float(size[0]),
        "half": float(size[1]) if long else None,  # JSON has no infinity
        "friction": body.friction_with(scene.ropes[0]),
        "compliance": body.compliance,
    }


def _lines(model: Model) -> list[dict[str, Any]]:
    found = []
    for rope, span in zip(model.scene.ropes, model.layout.ropes, strict=True):
        loads = [[span.first + rope.node_index(one.node), one.mass] for one in rope.loads]
        found.append(
            {
                "first": span.first,
                "last": span.last,
                "own": rope.own_mass / max(rope.nodes, 1),
                "whole": rope.total_mass,
                "diameter": rope.diameter,
                "thickness": radius_of(rope),
                "segment": rope.segment_length,
                "loads": loads,
            }
        )
    return found


def refused_posts(scene: Scene) -> list[tuple[str, str]]:
    """Return what of a scene's obstacles the lab does not have, with its path."""
    found = []
    for i, body in enumerate(scene.obstacles or ()):
        path = f"obstacle[{i}]"
        if body.kind not in KINDS:
            found.append((f"{path}.kind", f"obstacles of the kind {body.kind!r}"))
        if body.spin is not None:
            found.append((f"{path}.spin", "obstacles that turn"))
        if body.restitution > 0.0:
            found.append((f"{path}.restitution", "restitution: what hits an obstacle stays there"))
        if body.motion.kind != "fixed":
            found.append((f"{path}.motion", "obstacles that move"))
        if len({body.friction_with(rope) for rope in scene.ropes}) > 1:
            found.append(
                (f"{path}.friction", "obstacles that are rougher to some ropes than to others")
            )
    return found
