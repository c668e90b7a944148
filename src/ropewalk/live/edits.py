"""Changes of a scene's structure while it runs: pins, cuts, loads.

Each takes a scene and its layout and returns the new scene and, per node of the new one, where it was: the
(fractional) index of the old node. The scene's shapes are not used any more once a simulation runs, so
they are put aside for straight ones, which fit any number of nodes.
"""

from __future__ import annotations

import math
from collections.abc import Iterable, Sequence
from dataclasses import dataclass
from itertools import count
from typing import Any

import numpy as np

from ropewalk.core.arrays import Floats
from ropewalk.live.parameters import LONGEST_BASE, refusal
from ropewalk.lowering.contact_checks import refuse_tying, refuse_untying
from ropewalk.lowering.layout import Layout, make_layout
from ropewalk.lowering.slide_checks import refuse_slides
from ropewalk.scene import (
    Anchor,
    Force,
    Hand,
    Joint,
    Load,
    Material,
    Rope,
    Scene,
    SceneError,
    Straight,
    Tie,
)
from ropewalk.scene.rubbing import between_pieces, of_pieces

MOST_ANCHORS, MOST_ROPES = 100, 200
MOST_NODES = 200_000


@dataclass(frozen=True)
class Edit:
    """A changed scene, and where its nodes were before."""

    scene: Scene
    source: Floats  # (new nodes,) index of the old node, fractional between two
    note: str = ""
    parted: tuple[int, ...] = ()  # old segments that part now and stay a gap


class CutEnd(Load):
    """Half a segment's mass at the end of a cut rope: the rope's own, which no hand takes off."""


def check_size(scene: Scene) -> None:
    """Raise SceneError for a scene that is too large to be shown live."""
    nodes = sum(rope.nodes for rope in scene.ropes)
    if nodes > MOST_NODES:
        raise refusal("rope", f"{nodes} nodes", f"must be at most {MOST_NODES} in a live view")
    if len(scene.ropes) > MOST_ROPES:
        rule = f"must be at most {MOST_ROPES} in a live view"
        raise refusal("rope", f"{len(scene.ropes)} ropes", rule)


def neutral(scene: Scene) -> Scene:
    """Return the scene with straight shapes, for a simulation whose nodes have places already.

    It does not start at rest, nor ringing: what is made of it goes on where the simulation stands.
    """
    shape = Straight(start=(0.0, 0.0, 0.0), end=(1.0, 0.0, 0.0))
    ropes = [rope.replace(shape=shape, kicks=()) for rope in scene.ropes]
    return scene.replace(ropes=ropes, run=scene.run.replace(start="shape", ring=None))


def same_nodes(layout: Layout) -> Floats:
    """Return the sources when every node stays the same."""
    return np.arange(layout.nodes, dtype=np.float64)


def matched(before: Layout, after: Layout) -> Floats:
    """Return the sources when ropes may have other numbers of segments.

    Equal shares of arc length, between one anchor and the next: an anchored node stays where it is.
    """
    held = dict(zip(before.anchor_names, before.anchor_nodes, strict=True))
    pairs = [
        (node, held[name])
        for name, node in zip(after.anchor_names, after.anchor_nodes, strict=True)
        if name in held
    ]
    parts = []
    for old, new in zip(before.ropes, after.ropes, strict=True):
        nodes = np.arange(new.first, new.last + 1, dtype=np.float64)
        if old.nodes == new.nodes:
            parts.append(nodes + (old.first - new.first))
            continue
        ends = {new.first: old.first, new.last: old.last}
        fixed = sorted((ends | {a: b for a, b in pairs if new.first <= a <= new.last}).items())
        here, there = np.array(fixed, dtype=np.float64).T
        parts.append(np.interp(nodes, here, there))
    return np.concatenate(parts)


def at_node(layout: Layout, index: int) -> tuple[str, int]:
    """Return rope and node number of an index of the arrays. Raises SceneError."""
    if not 0 <= index < layout.nodes:
        raise refusal("node", index, f"must be from 0 to {layout.nodes - 1}")
    rope, node = layout.rope_of(index)
    span = layout.span(rope)
    if not span.start <= index <= span.end:
        rule = "is on a winch's drum, or came off it since the start: choose a point farther out"
        raise refusal("node", index, rule)
    return rope, node


def free_name(scenes: Iterable[Scene], prefix: str) -> str:
    """Return the first of `prefix`1, `prefix`2 .. that no anchor of these scenes has."""
    taken = {anchor.name for scene in scenes for anchor in scene.anchors}
    return next(name for i in count(1) if (name := f"{prefix}{i}") not in taken)


def pin(scene: Scene, layout: Layout, index: int, name: str) -> Edit:
    """Hold a node where it is, by an anchor of this name that can be moved by hand.

    It takes the place of one that has let go of the node.
    """
    rope, node = at_node(layout, index)
    if len(scene.anchors) >= MOST_ANCHORS:
        raise refusal("node", index, f"{MOST_ANCHORS} anchors are there already")
    gone = [one for one in scene.anchors if one.rope == rope and scene.anchor_node(one) == node]
    scene = scene.replace(anchors=[one for one in scene.anchors if one not in gone])
    made = Anchor(name=name, rope=rope, node=node, motion=Hand())
    return Edit(scene.replace(anchors=[*scene.anchors, made]), same_nodes(layout))


def drop_anchor(scene: Scene, layout: Layout, name: str) -> Edit:
    """Take an anchor away."""
    kept = [anchor for anchor in scene.anchors if anchor.name != name]
    if len(kept) == len(scene.anchors):
        there = ", ".join(anchor.name for anchor in scene.anchors) or "none"
        raise refusal("anchor", name, f"no such anchor; there is {there}")
    return Edit(scene.replace(anchors=kept), same_nodes(layout))


def drop_anchors(scene: Scene, layout: Layout, names: Sequence[str]) -> Edit:
    """Take anchors away, those that are there."""
    kept = [anchor for anchor in scene.anchors if anchor.name not in names]
    return Edit(scene.replace(anchors=kept), same_nodes(layout))


def load(scene: Scene, layout: Layout, index: int, mass: float) -> Edit:
    """Hang a mass on a node [kg], in place of what hangs there; 0 takes it off."""
    name, node = at_node(layout, index)
    if not (math.isfinite(mass) and 0.0 <= mass <= 1e9):
        raise refusal("mass", mass, "must be from 0 to 1e+09 kg")
    ropes = list(scene.ropes)
    i = scene.rope_index(name)
    loads = [
        one
        for one in ropes[i].loads
        if isinstance(one, CutEnd) or ropes[i].node_index(one.node) != node
    ]
    loads += [Load(node=node, mass=mass)] if mass > 0.0 else []
    ropes[i] = ropes[i].replace(loads=loads)
    return Edit(scene.replace(ropes=ropes), same_nodes(layout))


def cut(scene: Scene, layout: Layout, segment: int) -> Edit:
    """Cut a segment through its middle.

    Springs lose the spring. Of a material half a segment stays at either end, as mass only, so that no
    mass is lost and no node's mass changes. A node that is left all alone is dropped, with its anchor.
    A rope that a winch winds stays one: there the segment parts.
    """
    if not 0 <= segment < layout.segments:
        raise refusal("segment", segment, f"must be from 0 to {layout.segments - 1}")
    name = layout.rope_of(segment)[0]
    span, wound = layout.span(name), any(winch.rope == name for winch in scene.winches)
    if segment >= (span.last if wound else span.end):
        raise refusal("segment", segment, "lies between two ropes: there is nothing to cut")
    i = scene.rope_index(name)
    rope = scene.ropes[i]
    if any(rope.name in (slide.rope, slide.on) for slide in scene.slides):
        refuse_slides(scene, "a rope cannot be cut while something slides along it, or it slides")
    if wound:  # what came off a drum since the start, too
        return _part(scene, layout, segment)
    first = segment - span.start
    if rope.segments == 1:
        raise refusal("segment", segment, "is the rope's only one: nothing would be left")
    if len(scene.ropes) >= MOST_ROPES:
        raise refusal("segment", segment, f"{MOST_ROPES} ropes are there already")
    names = _two_names(scene, name)
    ends = [
        (low, high, new)
        for low, high, new in ((0, first, names[0]), (first + 1, rope.segments, names[1]))
        if high > low
    ]
    if len(ends) == 1:
        ends = [(ends[0][0], ends[0][1], name)]
    ropes = list(scene.ropes)
    ropes[i : i + 1] = [_piece(scene, rope, low, high, new) for low, high, new in ends]
    anchors = []
    for anchor in scene.anchors:
        if anchor.rope != name:
            anchors.append(anchor)
            continue
        node = rope.node_index(anchor.node)
        for low, high, new in ends:
            if low <= node <= high:
                anchors.append(anchor.replace(rope=new, node=node - low))
    joints = [one for joint in scene.joints if (one := _retied(joint, rope, ends)) is not None]
    kept = np.ones(layout.nodes, dtype=bool)
    kept[span.start : span.end + 1] = False
    for low, high, _ in ends:
        kept[span.start + low : span.start + high + 1] = True
    note = "" if len(ends) == 2 else "the last node is no rope any more and was dropped"
    made = scene.replace(
        ropes=ropes,
        anchors=anchors,
        joints=joints,
        **_rubbing(scene, name, [new for *_, new in ends]),
    )
    return Edit(made, np.flatnonzero(kept).astype(np.float64), note)


def _part(scene: Scene, layout: Layout, segment: int) -> Edit:
    """Let a segment of a wound rope part, as its nodes are the winch's. Raises SceneError where none can."""
    if not scene.parts:
        rule = "a rope that a winch winds can part only in a scene with a rope that does (parts = true)"
        raise refusal("segment", segment, rule)
    return Edit(scene, same_nodes(layout), "its winch stands from now on", (segment,))


def cut_all(scene: Scene, layout: Layout, segments: Sequence[int]) -> Edit:
    """Cut several segments that have parted already; those that cannot be cut are left as they are."""
    source, kept = same_nodes(layout), scene
    for segment in sorted(segments, reverse=True):  # what comes before keeps its number
        try:
            change = cut(kept, layout_of(kept), segment)
        except SceneError:
            continue
        kept, source = change.scene, source[change.source.astype(np.int64)]
    return Edit(kept, source)


def untie(scene: Scene, layout: Layout, name: str) -> Edit:
    """Let the nodes of a joint go their own ways.

    Raises SceneError where there is none of that name, or where ropes touch each other.
    """
    refuse_untying(scene)
    kept = [joint for joint in scene.joints if joint.name != name]
    if len(kept) == len(scene.joints):
        there = ", ".join(joint.name for joint in scene.joints) or "none"
        raise refusal("joint", name, f"no such joint; there is {there}")
    return Edit(scene.replace(joints=kept), same_nodes(layout))


def knot(scene: Scene, layout: Layout, nodes: tuple[int, int], hands: Sequence[str] = ()) -> Edit:
    """Tie two nodes, and all that is tied to them already, in one joint; `hands` are anchors that let go.

    Raises SceneError where they cannot be tied.
    """
    refuse_tying(scene)
    points = [at_node(layout, node) for node in nodes]
    told = " and ".join(f"node {node} of {rope!r}" for rope, node in points)
    members, name = list(dict.fromkeys(points)), ""
    kept = []
    for joint in scene.joints:
        tied = [(tie.rope, scene.rope_named(tie.rope).node_index(tie.node)) for tie in joint.points]
        if not set(tied) & set(points):
            kept.append(joint)
            continue
        if set(points) <= set(tied):
            raise refusal("nodes", told, f"are tied already, by joint {joint.name!r}")
        name = name or joint.name
        members += [one for one in tied if one not in members]
    if len(members) < 2:
        raise refusal("nodes", told, "are one and the same: choose another point")
    if any((rope, node + 1) in members for rope, node in members):
        rule = "are neighbours on their rope: the segment between would have no length"
        raise refusal("nodes", told, rule)
    taken = {joint.name for joint in scene.joints}
    name = name or next(f"knot{i}" for i in range(1, len(taken) + 2) if f"knot{i}" not in taken)
    ties = [Tie(rope=rope, node=node) for rope, node in members]
    anchors = [anchor for anchor in scene.anchors if anchor.name not in hands]
    joints = [*kept, Joint(name=name, points=ties)]
    made = scene.replace(anchors=anchors, joints=joints)
    return Edit(made, same_nodes(layout))


def _retied(joint: Joint, rope: Rope, ends: Sequence[tuple[int, int, str]]) -> Joint | None:
    """Return a joint with the nodes of a cut rope in its parts; None where it ties no two any more."""
    points = []
    for tie in joint.points:
        node = rope.node_index(tie.node) if tie.rope == rope.name else 0
        if tie.rope != rope.name:
            points.append(tie)
        for low, high, new in ends if tie.rope == rope.name else ():
            if low <= node <= high:
                points.append(tie.replace(rope=new, node=node - low))
    return joint.replace(points=points) if len(points) > 1 else None


def _rubbing(scene: Scene, name: str, pieces: Sequence[str]) -> dict[str, Any]:
    """Return obstacles and contact once a rope is in pieces, where pairs of it have friction of their own."""
    found: dict[str, Any] = {}
    if any(body.pairs for body in scene.obstacles):
        found["obstacles"] = [
            body.replace(pairs=of_pieces(body.pairs, name, pieces)) for body in scene.obstacles
        ]
    if scene.contact is not None and scene.contact.pairs:
        pairs = between_pieces(scene.contact.pairs, name, pieces)
        found["contact"] = scene.contact.replace(pairs=pairs)
    return found


def _two_names(scene: Scene, name: str) -> tuple[str, str]:
    """Return names for the two halves of a cut rope that no other rope has."""
    taken = {rope.name for rope in scene.ropes}
    base = name[:LONGEST_BASE]
    found = [f"{base}-{i}" for i in range(1, MOST_ROPES + 3) if f"{base}-{i}" not in taken]
    return found[0], found[1]


def _piece(scene: Scene, rope: Rope, low: int, high: int, name: str) -> Rope:
    """Return the part of a rope from node `low` to node `high`, with half a segment's mass at cuts."""
    loads = [
        one.replace(node=node - low)
        for one in rope.loads
        if low <= (node := rope.node_index(one.node)) <= high
    ]
    forces = [
        Force(node=node - low, force=one.force)
        for one in rope.forces
        if low <= (node := rope.node_index(one.node)) <= high
    ]
    changes: dict[str, Any] = {"name": name, "segments": high - low, "forces": forces}
    if isinstance(rope.made_of, Material):
        changes["length"] = rope.segment_length * (high - low)
        half = 0.5 * rope.made_of.mass_per_length * rope.segment_length
        if rope.submerged_weight is not None:  # what stays as mass stays in the water, too
            size = math.hypot(*scene.gravity)
            lift = half * size - 0.5 * rope.submerged_weight * rope.segment_length
            lifted = tuple(lift * part for part in scene.up)
            forces += [Force(node=0, force=lifted)] if low > 0 else []
            forces += [Force(node=high - low, force=lifted)] if high < rope.segments else []
            changes["forces"] = forces
        if low > 0:
            loads.append(CutEnd(node=0, mass=half))
        if high < rope.segments:
            loads.append(CutEnd(node=high - low, mass=half))
    return rope.replace(loads=loads, **changes)


def layout_of(scene: Scene) -> Layout:
    """Return the layout of a scene."""
    return make_layout(scene)
