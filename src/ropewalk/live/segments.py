"""Cutting a rope into another number of segments: the same rope, more or less finely."""

from __future__ import annotations

import math
from typing import Any

from ropewalk.lowering.slide_checks import refuse_slides
from ropewalk.scene import (
    Anchor,
    Fault,
    Force,
    Kick,
    Points,
    Polyline,
    Rope,
    Scene,
    SceneError,
    Springs,
)

_MOST_PIECES = 10  # between anchors; more of them would leave too few numbers to choose from


def most_segments() -> int:
    """Return the most segments that a rope may have live."""
    return 20_000


def with_rope(scene: Scene, index: int, rope: Rope) -> Scene:
    """Return the scene with one rope in place of another."""
    ropes = list(scene.ropes)
    ropes[index] = rope
    return scene.replace(ropes=ropes)


def moved_node(node: int, before: int, after: int) -> int:
    """Return the node of a rope of `after` segments nearest to one of `before` segments."""
    return round((node % (before + 1)) / before * after)


def fitting(scene: Scene, rope: Rope, segments: int) -> int:
    """Return the number of segments nearest to the wanted one that has a node at every anchor.

    Where anchors stand at odd places, any number is taken, and they move by part of a segment.
    """
    places = [scene.anchor_node(one) for one in scene.anchors if one.rope == rope.name]
    pieces = rope.segments // math.gcd(rope.segments, *places)
    if pieces > _MOST_PIECES:
        return segments
    return max(1, round(segments / pieces)) * pieces


def resegment(scene: Scene, index: int, segments: int) -> Scene:
    """Return the scene with a rope cut into another number of segments, one that fits its anchors.

    Length, mass and EA stay; so do friction times segment length and the places of anchors and loads.
    With springs, whose every node weighs the same, the ends' share of the mass changes a little.
    Raises SceneError when two anchors would hold the same node, and for a rope that joints tie.
    """
    rope = scene.ropes[index]
    if segments != rope.segments and any(
        tie.rope == rope.name for joint in scene.joints for tie in joint.points
    ):
        rule = "cannot be changed while joints tie the rope: its nodes are theirs"
        raise SceneError([Fault(f"rope[{index}].segments", segments, rule)])
    segments = fitting(scene, rope, segments)
    if segments == rope.segments:
        return scene
    refuse_slides(scene, "the number of segments cannot be changed while something slides")
    changes: dict[str, Any] = {"segments": segments}
    if isinstance(rope.made_of, Springs):
        ratio = segments / rope.segments
        changes["made_of"] = rope.made_of.replace(
            spring_constant=rope.made_of.spring_constant * ratio,
            spring_friction=rope.made_of.spring_friction * ratio,
            segment_length=rope.length_unstretched / segments,
            node_mass=rope.own_mass / (segments + 1),
        )
    if isinstance(rope.shape, Points):
        shape = Polyline(points=rope.shape.points, velocity=rope.shape.velocity)
        changes["shape"] = shape

    def moved(node: int) -> int:
        return moved_node(node, rope.segments, segments)

    changes["forces"] = [Force(node=moved(one.node), force=one.force) for one in rope.forces]
    changes["loads"] = [one.replace(node=moved(one.node)) for one in rope.loads]
    kicks = {moved(one.node): one.velocity for one in rope.kicks}
    changes["kicks"] = [Kick(node=node, velocity=velocity) for node, velocity in kicks.items()]
    anchors: list[Anchor] = [
        one.replace(node=moved(one.node)) if one.rope == rope.name else one for one in scene.anchors
    ]
    ropes = list(scene.ropes)
    ropes[index] = rope.replace(**changes)
    return scene.replace(ropes=ropes, anchors=anchors)
