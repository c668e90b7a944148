"""What a scene gives besides the ropes: constant forces at nodes and weights in water, in pictures."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np
from matplotlib.axes import Axes

from ropewalk.plots.canvas import Stage
from ropewalk.plots.view import shown_positions
from ropewalk.scene import Scene
from ropewalk.words.prefixes import prefixed

if TYPE_CHECKING:
    from ropewalk.record.result import Result

_LONGEST = 0.12  # of the box's larger side, of the largest force's arrow
_COLOUR = "#b5460f"


def given_notes(scene: Scene) -> list[str]:
    """Return a sentence for each rope that lies in water, and one on the arrows of forces."""
    several = len(scene.ropes) > 1
    found = []
    for rope in scene.ropes:
        if rope.submerged_weight is not None:
            of = f"of {rope.name!r} " if several else ""
            found.append(f"Weight {of}in water: {rope.submerged_weight:.4g} N/m.")
    if any(rope.forces for rope in scene.ropes):
        found.append("Arrows: constant forces at nodes.")
    return found


def draw_forces(axes: Axes, result: Result, seen: Stage, frame: int) -> None:
    """Draw the constant forces at their nodes, each with its size."""
    points = shown_positions(result, frame)
    places, forces = [], []
    for span, rope in zip(result.layout.ropes, result.scene.ropes, strict=True):
        for one in rope.forces:
            places.append(points[span.start + rope.node_index(one.node)])
            forces.append(one.force)
    sizes = np.linalg.norm(np.reshape(forces, (-1, 3)), axis=1)
    if not sizes.any():
        return
    longest = _LONGEST * max(seen.box.width, seen.box.height) / sizes.max()
    for place, force, size in zip(places, forces, sizes, strict=True):
        if size == 0.0:
            continue
        start, tip = seen.view.project(np.stack([place, place + longest * np.array(force)]))
        axes.annotate(
            prefixed(float(size), "N"),
            xy=tip,
            xytext=tip,
            color=_COLOUR,
            fontsize=8,
            ha="left",
            va="bottom",
            annotation_clip=False,
        )
        arrow = {"arrowstyle": "-|>", "color": _COLOUR, "shrinkA": 0.0, "shrinkB": 0.0}
        axes.annotate("", xy=tip, xytext=start, arrowprops=arrow, annotation_clip=False)
