"""The same scene with its ropes cut into half or twice as many segments, to see what the cutting does."""

from __future__ import annotations

from itertools import pairwise
from typing import Any, NamedTuple

from ropewalk.scene.at_nodes import Kick
from ropewalk.scene.rope import Rope, Springs
from ropewalk.scene.scene import Scene
from ropewalk.scene.shapes import Points

_FEWEST = 4  # segments that are halved


class Recut(NamedTuple):
    """A scene cut anew, or why it cannot be."""

    scene: Scene | None
    factor: float  # [1] number of segments over that of the given scene
    why_not: str = ""


def recut(scene: Scene, *, finer: bool = False) -> Recut:
    """Return the scene with half the segments; with twice as many where nodes would be lost, or if `finer`.

    Nodes that anchors, joints, slides, loads and forces name stay where they are on the rope.
    """
    for rope in scene.ropes:
        if isinstance(rope.made_of, Springs):
            why = f"rope {rope.name!r} is given spring by spring: with other segments it is another rope"
            return Recut(None, 1.0, why)
        if rope.kicks and not _everywhere(scene, rope):
            why = f"rope {rope.name!r} has kicks at some nodes, which push less mass the finer it is cut"
            return Recut(None, 1.0, why)
    halves = all(_halves(rope, _named(scene, rope)) for rope in scene.ropes)
    half = halves and not finer and not _close(scene)
    return Recut(_cut(scene, half=half), 0.5 if half else 2.0)


def _everywhere(scene: Scene, rope: Rope) -> bool:
    """Tell whether every node that no anchor holds is kicked, so that the kicks are a motion of the rope."""
    held = [rope.node_index(one.node) for one in scene.anchors if one.rope == rope.name]
    kicked = [rope.node_index(kick.node) for kick in rope.kicks]
    return len({*kicked}) == len(kicked) and {*held, *kicked} == {*range(rope.segments + 1)}


def _close(scene: Scene) -> bool:
    """Tell whether a joint ties nodes of a rope that would be neighbours among half of them."""
    for joint in scene.joints:
        at = {(tie.rope, scene.rope_named(tie.rope).node_index(tie.node)) for tie in joint.points}
        if any((rope, node + 2) in at for rope, node in at):
            return True
    return False


def _named(scene: Scene, rope: Rope) -> list[int]:
    """Return the nodes of a rope that something of the scene names, counted from 0."""
    own = [load.node for load in rope.loads] + [force.node for force in rope.forces]
    own += [anchor.node for anchor in scene.anchors if anchor.rope == rope.name]
    own += [tie.node for joint in scene.joints for tie in joint.points if tie.rope == rope.name]
    own += [slide.node for slide in scene.slides if slide.rope == rope.name]
    return [rope.node_index(node) for node in own]


def _halves(rope: Rope, named: list[int]) -> bool:
    """Tell whether every other node of a rope can go."""
    even = rope.segments % 2 == 0 and all(node % 2 == 0 for node in named)
    return even and rope.segments >= _FEWEST and rope.shape.kind != "knot"  # as fine as must be


def _cut(scene: Scene, *, half: bool) -> Scene:
    def moved(rope: Rope, part: Any) -> Any:
        node = rope.node_index(part.node)
        return part.replace(node=node // 2 if half else 2 * node)

    ropes = []
    for rope in scene.ropes:
        changes: dict[str, Any] = {
            "segments": rope.segments // 2 if half else 2 * rope.segments,
            "loads": tuple(moved(rope, load) for load in rope.loads),
            "forces": tuple(moved(rope, force) for force in rope.forces),
            "kicks": _kicks(rope, half),
        }
        if isinstance(rope.shape, Points):
            changes["shape"] = rope.shape.replace(points=_thinned(rope.shape.points, half))
        ropes.append(rope.replace(**changes))
    anchors = [moved(scene.rope_named(anchor.rope), anchor) for anchor in scene.anchors]
    joints = [
        joint.replace(points=[moved(scene.rope_named(tie.rope), tie) for tie in joint.points])
        for joint in scene.joints
    ]
    slides = [moved(scene.rope_named(slide.rope), slide) for slide in scene.slides]
    return scene.replace(ropes=ropes, anchors=anchors, joints=joints, slides=slides)


def _kicks(rope: Rope, half: bool) -> list[Kick]:
    """Return the kicks of every other node, or those and the means between neighbours."""
    if not rope.kicks:
        return []
    velocity: list[Any] = [getattr(rope.shape, "velocity", (0.0, 0.0, 0.0))] * (rope.segments + 1)
    kicked = {rope.node_index(kick.node): kick.velocity for kick in rope.kicks}
    for node, one in kicked.items():
        velocity[node] = one
    found = []
    for node, one in enumerate(_thinned(velocity, half)):
        old = 2 * node if half else node / 2  # a node that an anchor holds has no kick
        if old in kicked or old % 1:
            found.append(Kick(node=node, velocity=one))
    return found


def _thinned(points: Any, half: bool) -> list[Any]:
    """Return every other point, or the points and the middles between them."""
    if half:
        return list(points[::2])
    found = [points[0]]
    for a, b in pairwise(points):
        found += [tuple(0.5 * (p + q) for p, q in zip(a, b, strict=True)), b]
    return found
