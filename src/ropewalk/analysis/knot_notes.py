"""What `check` says of ropes that are tied in a knot: what a knot needs besides its rope."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from ropewalk.knots.tying import named
from ropewalk.laws.obstacle_places import surface_near
from ropewalk.lowering import Model
from ropewalk.scene import Knot, Rope

if TYPE_CHECKING:
    from ropewalk.core.arrays import Floats

_PAIRS = ("reef", "granny")
_NO_CROSSING = "bollard"  # its turns lie beside each other
_THINNER = 0.75  # of the radius a hitch is tied for: what is about that thick [1]
_ASKEW = 0.8  # cosine of the angle between a post that is a rope, and where it should go


def knot_warnings(model: Model) -> list[str]:
    """Return a sentence for every knot that is none as the scene is: strands or a post pass through."""
    found, scene = [], model.scene
    tied = [(rope, rope.shape) for rope in scene.ropes if isinstance(rope.shape, Knot)]
    for rope, shape in tied:
        name = f"rope {rope.name!r}: is tied in {named(shape.knot)}, "
        if scene.contact is None and shape.knot != _NO_CROSSING:
            found.append(f"{name}but strands go through each other; add a [contact] table")
        if shape.post_radius is not None:
            found += [name + words for words in _without_post(model, rope, shape)]
        others = {(other.knot, other.rope) for one, other in tied if one is not rope}
        if shape.knot in _PAIRS and (shape.knot, 3 - shape.rope) not in others:
            found.append(
                f"{name}but its other rope is not there; give one the same shape with rope = "
                f"{3 - shape.rope}"
            )
    return found


def _without_post(model: Model, rope: Rope, shape: Knot) -> list[str]:
    """Return what is to be told of a hitch that is tied about nothing, or about what is thinner."""
    if not model.scene.obstacles and len(model.scene.ropes) == 1:
        return ["but there is no post; add it as an obstacle (`shape.post()`)"]
    axis, radius = shape.axis(rope.diameter), shape.post_radius or 0.0
    table = model.system.node.obstacle
    deep = [
        min(-float(surface_near(table, row, place)[0]) for place in axis)
        for row in range(len(model.scene.obstacles))
    ]
    x = model.state.x
    deep += [
        _thick(x[:, span.first : span.last + 1].T, 0.5 * other.diameter, axis, radius)
        for other, span in zip(model.scene.ropes, model.layout.ropes, strict=True)
        if other is not rope
    ]
    if max(deep) >= _THINNER * radius:
        return []
    return [
        f"but no post of about {radius:g} m radius stands at its center along its normal: it is tied about "
        "nothing, or slack about what is thinner; put one there as an obstacle (`shape.post()`)"
    ]


def _thick(nodes: Floats, half: float, axis: Floats, radius: float) -> float:
    """Return how thick a post a rope is that is so thick [m] and goes through a hitch of that radius [m].

    How far it reaches from the middle of the hitch's axis (3, 3); 0 of one that goes by, or across.
    """
    ways, from_first = np.diff(nodes, axis=0), axis[1] - nodes[:-1]
    along = np.einsum("ij,ij->i", from_first, ways) / np.einsum("ij,ij->i", ways, ways)
    off = np.linalg.norm(from_first - np.clip(along, 0.0, 1.0)[:, None] * ways, axis=1)
    k, straight = int(np.argmin(off)), axis[2] - axis[0]
    size = float(np.linalg.norm(ways[k]) * np.linalg.norm(straight))
    through = off[k] <= radius and abs(float(ways[k] @ straight)) >= _ASKEW * size
    return float(off[k]) + half if through else 0.0
