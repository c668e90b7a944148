"""Which segments never touch: neighbours along a rope, at joints, and where nodes slide."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING

import numpy as np

from ropewalk.core.arrays import Floats
from ropewalk.laws.pairs.table import Pairs

if TYPE_CHECKING:
    from collections.abc import Sequence

    from ropewalk.lowering.layout import Layout
    from ropewalk.scene import Joint, Rope
    from ropewalk.scene.slide import Slide

NEIGHBOURS = 0.8 * math.pi  # [1] rope on each side that counts as neighbour, over its radius


def neighbours(rope: Rope, radius: float = 0.0) -> int:
    """Return how many segments on each side of one are its neighbours, which it does not touch.

    Or, where a node slides along a rope of some radius [m], which of those beside it do not touch that one.
    """
    reach = NEIGHBOURS * max(0.5 * rope.diameter, radius)
    if reach >= rope.length_unstretched:  # springs of no length, too
        return rope.segments
    return math.ceil(reach / rope.segment_length)


def note_joints(
    table: Pairs, layout: Layout, ropes: Sequence[Rope], joints: Sequence[Joint], inert: Floats
) -> None:
    """Write which joints are so near a segment that those beyond them are its neighbours; what they tie."""
    numbers = {rope.name: number for number, rope in enumerate(ropes)}
    for j, joint in enumerate(joints):
        nodes = [layout.node(tie.node, tie.rope) for tie in joint.points]
        together, pushed = table.load[nodes].sum(), (inert + table.behind)[nodes].max()
        table.joined[nodes] = inert[nodes].sum() - inert[nodes]
        table.behind[nodes] = max(inert[nodes].sum(), pushed) - inert[nodes]
        for tie in joint.points:
            rope, span = ropes[numbers[tie.rope]], layout.ropes[numbers[tie.rope]]
            node, reach = layout.node(tie.node, tie.rope), max(1, neighbours(rope))
            table.load[node] = together
            for k in range(max(node - reach, span.first), min(node + reach, span.last)):
                side = 0 if k >= node else 1
                if table.joint[k, side] < 0 or abs(k - node) < reach:
                    table.joint[k, side] = j


def with_slides(
    table: Pairs, layout: Layout, ropes: Sequence[Rope], slides: Sequence[Slide]
) -> Pairs:
    """Return the table with the segments near nodes that slide along ropes: they lie inside those."""
    numbers = {rope.name: number for number, rope in enumerate(ropes)}
    rows: list[tuple[int, ...]] = []
    near: list[list[int]] = [[] for _ in table.rope]
    for number, slide in enumerate(slides):
        own, line = numbers[slide.rope], numbers[slide.on]
        span, other = layout.ropes[own], layout.ropes[line]
        radius = 0.5 * max(ropes[own].diameter, ropes[line].diameter)
        node = layout.node(slide.node, slide.rope)
        reach, within = (max(1, neighbours(ropes[i], radius)) for i in (own, line))
        for k in range(max(node - reach, span.first), min(node + reach, span.last)):
            near[k].append(len(rows))
            rows.append((k, number, other.first, other.last - 1, within, node, other.start))
    found = np.full((len(near), max(map(len, near), default=0)), -1, np.int64)
    for k, one in enumerate(near):
        found[k, : len(one)] = one
    return table._replace(slides=found, inside=np.array(rows, np.int64).reshape(-1, 7))
