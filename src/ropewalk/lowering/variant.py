"""Which of the two variants of a method's kernels a scene takes, see `laws.rare`."""

from __future__ import annotations

from ropewalk.laws.acting import section_of
from ropewalk.laws.registry import ELASTIC_LAWS, NODE_LAWS
from ropewalk.scene import Scene


def rare_of(scene: Scene) -> int | None:
    """Return 1 where a law beyond springs, friction, weight and anchors may act, else None.

    A section of the scene is enough: what it says does not count.
    """
    sections = [section_of(law, scene) for law in NODE_LAWS]
    listed = scene.winches or scene.limiter or scene.joints or any(sections)
    bends = any(rope.bending_stiffness > 0.0 for rope in scene.ropes)
    elastic = any(law.says(rope) is not None for law in ELASTIC_LAWS for rope in scene.ropes)
    return 1 if listed or bends or elastic else None
