"""Which ropes pull each other: those that joints tie, or slides hang on each other."""

from __future__ import annotations

from ropewalk.scene.joint import tied_ropes
from ropewalk.scene.scene import Scene


def bound_ropes(scene: Scene) -> list[list[int]]:
    """Return the ropes that joints tie, or slides hang on each other, by their numbers."""
    groups = tied_ropes(scene.ropes, scene.joints)
    number = {rope.name: i for i, rope in enumerate(scene.ropes)}
    for slide in scene.slides:
        ends = {number[slide.rope], number[slide.on]}
        bound = [group for group in groups if ends & set(group)]
        groups = [group for group in groups if group not in bound]
        groups.append(sorted(i for group in bound for i in group))
    return groups
