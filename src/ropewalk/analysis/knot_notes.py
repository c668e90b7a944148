"""What `check` says of ropes that are tied in a knot: what a knot needs besides its rope."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING

import numpy as np

from ropewalk.knots.tying import named
from ropewalk.laws.obstacle_places import gaps
from ropewalk.lowering import Model
from ropewalk.scene import Knot, Rope

if TYPE_CHECKING:
    from ropewalk.core.arrays import Floats

_PAIRS = ("reef", "granny")
_NO_CROSSING = "bollard"  # its turns lie beside each other
_THINNER = 0.75  # of the width a hitch is tied for: what is about that thick [1]
# Mean of the widths below over that of the circle, of a bar that its turn is a third too long for [1].
_FLAT = 0.53
_ABOUT = 48  # places about its post; even


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
    radius = shape.post_radius or 0.0
    widest, mean = _widths(model, rope, shape.sections(rope.diameter, _ABOUT))
    if widest >= 2.0 * _THINNER * radius:
        if mean >= 2.0 * _FLAT * radius:
            return []
        return [
            "but what stands in it is flat: it starts slack, its turns longer than the way round that by a "
            "third or more; pull it tight before it has to hold"
        ]
    return [
        f"but no post of about {radius:g} m radius stands at its center along its normal, all through its "
        "turns: it is tied about nothing, or slack about what is thinner; put one there as an obstacle "
        "(`shape.post()`)"
    ]


def _widths(model: Model, rope: Rope, sections: Floats) -> tuple[float, float]:
    """Return how wide what stands in a hitch of `rope` is at the least of its sections, and on average [m].

    Args:
        model: of the scene.
        rope: the one that is tied.
        sections: see `Knot.sections` [m], (sections, 1 + many, 3).

    The width of a section is that between two lines on both sides of it, the way in which it is greatest: so
    a flat bar is as wide as it is broad, two ropes as both, and what stands aside as wide as in the middle.
    It is 2 r less the ways from two opposite places of the circle of radius r to what is nearest, exact where
    those go along the line between the two; 0 or less if nothing is there. What reaches the circle from
    outside only is nothing that the hitch is about. The mean over all ways is small of what is flat.
    """
    places, many = sections.reshape(-1, 3), sections.shape[1] - 1
    away = list(gaps(model.system.node.obstacle, np.ascontiguousarray(places.T)))
    away += [
        _from_rope(model.state.x[:, span.first : span.last + 1].T, places) - 0.5 * other.diameter
        for other, span in zip(model.scene.ropes, model.layout.ropes, strict=True)
        if other is not rope
    ]
    by_section = np.reshape(away, (-1, len(sections), 1 + many))
    radius = float(np.linalg.norm(sections[0, 1] - sections[0, 0]))
    within = by_section[:, :, :1] < radius
    nearest = np.where(within, by_section[:, :, 1:], 2.0 * radius).min(axis=0)
    both = nearest[:, : many // 2] + nearest[:, many // 2 :]
    least, mean = both.min(axis=1).max(), both.mean(axis=1).max()
    return float(2.0 * radius - least), float(2.0 * radius - mean)


def _from_rope(nodes: Floats, places: Floats) -> Floats:
    """Return how far places (n, 3) are from the middle line of a rope with nodes (m, 3) [m], (n,).

    Segments that are farther from all of them than they are from each other are left out; inf without any.
    """
    ways, middle = np.diff(nodes, axis=0), places.mean(axis=0)
    size = 3.0 * np.linalg.norm(places - middle, axis=1).max()
    near = np.linalg.norm(nodes[:-1] - middle, axis=1) <= size + np.linalg.norm(ways, axis=1)
    ways, from_first = ways[near], places[:, None, :] - nodes[:-1][near]
    square = np.maximum(np.einsum("ij,ij->i", ways, ways), 1e-300)
    along = np.clip(np.einsum("kij,ij->ki", from_first, ways) / square, 0.0, 1.0)
    off = np.linalg.norm(from_first - along[:, :, None] * ways, axis=2)
    return np.asarray(off.min(axis=1, initial=math.inf))
