"""What `check` says of ropes that are tied in a knot: what a knot needs besides its rope."""

from __future__ import annotations

from ropewalk.knots.tying import named
from ropewalk.scene import Knot, Scene

_PAIRS = ("reef", "granny")
_NO_CROSSING = "bollard"  # its turns lie beside each other


def knot_warnings(scene: Scene) -> list[str]:
    """Return a sentence for every knot that is none as the scene is: strands or a post pass through."""
    found = []
    tied = [(rope, rope.shape) for rope in scene.ropes if isinstance(rope.shape, Knot)]
    for rope, shape in tied:
        name = f"rope {rope.name!r}: is tied in {named(shape.knot)}, "
        if scene.contact is None and shape.knot != _NO_CROSSING:
            found.append(f"{name}but strands go through each other; add a [contact] table")
        if shape.post_radius is not None and not scene.obstacles and len(scene.ropes) == 1:
            found.append(f"{name}but there is no post; add it as an obstacle (`shape.post()`)")
        others = {(other.knot, other.rope) for one, other in tied if one is not rope}
        if shape.knot in _PAIRS and (shape.knot, 3 - shape.rope) not in others:
            found.append(
                f"{name}but its other rope is not there; give one the same shape with rope = "
                f"{3 - shape.rope}"
            )
    return found
