"""Where ropes, nodes and anchors lie in the arrays."""

from __future__ import annotations

import math
from bisect import bisect_left
from dataclasses import dataclass
from functools import cached_property
from hashlib import sha256
from operator import index

from ropewalk.laws.acting import section_of
from ropewalk.laws.registry import NODE_LAWS
from ropewalk.scene import Rope, Scene, Winch
from ropewalk.scene.limits import MOST_ON_DRUM
from ropewalk.scene.obstacles import is_free

ROPES = "ropes on ropes"


@dataclass(frozen=True)
class Span:
    """One rope's share of the arrays; spare nodes lie on a winch's drum."""

    name: str
    first: int
    nodes: int  # spare ones included
    spare_start: int = 0
    spare_end: int = 0

    def length_on_drum(self, end: str, segment_length: float) -> float:
        """Length of the rope that spare nodes wait for on the drum at an end [m]."""
        return (self.spare_start if end == "start" else self.spare_end) * segment_length

    @property
    def last(self) -> int:
        """Index of the rope's last node, spare ones included."""
        return self.first + self.nodes - 1

    @property
    def start(self) -> int:
        """Index of the first node of the rope as the scene describes it."""
        return self.first + self.spare_start

    @property
    def end(self) -> int:
        """Index of the last node of the rope as the scene describes it."""
        return self.last - self.spare_end


@dataclass(frozen=True)
class Layout:
    """All ropes one after another, and the anchors by name."""

    ropes: tuple[Span, ...]
    anchor_names: tuple[str, ...]
    anchor_nodes: tuple[int, ...]
    nodes: int
    bends: bool = False  # whether any rope has bending stiffness
    clamped: bool = False  # whether any anchor holds a direction
    ties: tuple[str, ...] = ()  # what each joint ties: "joint0:rope[4]"
    more: tuple[str, ...] = ()  # names of the laws of nodes with a memory, where there are any
    tied_nodes: tuple[int, ...] = ()  # their indices
    pulleys: tuple[str, ...] = ()  # names of the obstacles that turn freely
    surfaces: tuple[
        str, ...
    ] = ()  # names of all obstacles, and of ropes where they touch each other

    @property
    def segments(self) -> int:
        """Number of segments in the arrays, the dead ones between ropes included."""
        return self.nodes - 1

    @property
    def touches(self) -> bool:
        """Whether ropes can touch anything whose force is recorded: obstacles, or each other."""
        return bool(self.surfaces)

    @cached_property
    def mark(self) -> str:
        """What tells it from other layouts, whatever their names: nodes of ropes, spare, held and tied."""
        ropes = [(span.nodes, span.spare_start, span.spare_end) for span in self.ropes]
        return sha256(repr((ropes, self.anchor_nodes, self.tied_nodes)).encode()).hexdigest()[:16]

    @cached_property
    def _by_name(self) -> dict[str | None, Span]:
        return {span.name: span for span in self.ropes}

    @cached_property
    def _lasts(self) -> list[int]:
        return [span.last for span in self.ropes]

    def span(self, rope: str | None = None) -> Span:
        """Return one rope's span; without a name, the only rope's.

        Raises KeyError for an unknown name, or for no name with several ropes.
        """
        if rope is None and len(self.ropes) == 1:
            return self.ropes[0]
        if rope in self._by_name:
            return self._by_name[rope]
        names = ", ".join(span.name for span in self.ropes)
        raise KeyError(f"name one of the ropes {names}" + (f", not {rope!r}" if rope else ""))

    def node(self, node: int, rope: str | None = None) -> int:
        """Return the array index of a rope's node; negative nodes count from its end.

        Raises KeyError for the rope and IndexError for the node.
        """
        span = self.span(rope)
        count = span.end - span.start + 1
        try:
            number = index(node)
        except TypeError:  # a name, a part of a number
            number = count
        if not -count <= number < count:
            raise IndexError(f"rope {span.name!r} has the nodes 0 to {count - 1}, not {node!r}")
        return span.start + number % count

    def rope_of(self, place: int) -> tuple[str, int]:
        """Return rope name and node number of an array index."""
        number = bisect_left(self._lasts, place)
        if number == len(self.ropes):
            raise IndexError(f"there are {self.nodes} nodes, no index {place}")
        span = self.ropes[number]
        return span.name, place - span.start


def make_layout(scene: Scene) -> Layout:
    """Lay out the ropes of a scene one after another."""
    spans: list[Span] = []
    first = 0
    for rope in scene.ropes:
        spare = {
            winch.end: _spare_nodes(scene, rope, winch)
            for winch in scene.winches
            if winch.rope == rope.name
        }
        start, end = spare.get("start", 0), spare.get("end", 0)
        spans.append(Span(rope.name, first, rope.nodes + start + end, start, end))
        first += spans[-1].nodes
    number = {rope.name: i for i, rope in enumerate(scene.ropes)}
    nodes = tuple(
        spans[number[anchor.rope]].start + scene.ropes[number[anchor.rope]].node_index(anchor.node)
        for anchor in scene.anchors
    )
    tied = [
        (joint.name, number[tie.rope], scene.ropes[number[tie.rope]].node_index(tie.node))
        for joint in scene.joints
        for tie in joint.points
    ]
    return Layout(
        tuple(spans),
        tuple(anchor.name for anchor in scene.anchors),
        nodes,
        first,
        any(rope.bending_stiffness > 0.0 for rope in scene.ropes),
        any(anchor.clamp is not None for anchor in scene.anchors),
        tuple(f"{name}:{spans[rope].name}[{node}]" for name, rope, node in tied),
        tuple(law.name for law in NODE_LAWS if law.memory is not None and section_of(law, scene)),
        tuple(spans[rope].start + node for _, rope, node in tied),
        tuple(
            body.name or f"obstacle{row}"
            for row, body in enumerate(scene.obstacles)
            if is_free(body)
        ),
        surfaces_of(scene),
    )


def surfaces_of(scene: Scene) -> tuple[str, ...]:
    """Return the names of all that ropes of a scene touch: its obstacles, and each other."""
    bodies = tuple(body.name or f"obstacle{row}" for row, body in enumerate(scene.obstacles))
    return bodies if scene.contact is None else (*bodies, ROPES)


def _spare_nodes(scene: Scene, rope: Rope, winch: Winch) -> int:
    """Nodes that must wait on the drum for all the rope that the winch can pay out within the run's duration.

    The last frame may come up to half an interval later: for more than a segment of that give `on_drum`.
    """
    if winch.on_drum is not None:
        return min(math.ceil(winch.on_drum / rope.segment_length * (1.0 - 1e-12)), MOST_ON_DRUM)
    if winch.speed <= 0.0:
        return 0
    paid = winch.speed * max(min(winch.stop, scene.run.duration) - winch.start, 0.0)
    if winch.max_length is not None:
        paid = min(paid, winch.max_length - rope.length_unstretched)
    return min(math.ceil(max(paid, 0.0) / rope.segment_length) + 1, MOST_ON_DRUM)
