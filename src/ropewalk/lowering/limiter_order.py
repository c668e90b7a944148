"""The order in which the stretch limiter visits the segments."""

from __future__ import annotations

from collections import deque
from itertools import pairwise
from typing import NamedTuple

import numpy as np

from ropewalk.core.arrays import Floats, Ints, Joints
from ropewalk.lowering.layout import Layout, Span


class Order(NamedTuple):
    """Segments from the anchors outward, the first node's share of each correction, the row of the anchor
    that it goes by, and the joints that their nodes belong to, (2, s); -1: none."""

    segments: Ints
    share: Floats
    anchor: Ints
    joint: Ints


def limiter_order(layout: Layout, joints: Joints) -> Order:
    """Return the order; the way from an anchor goes on through joints.

    The node nearer to an anchor stays (share 0 or 1), as long as that anchor holds; halfway between two
    anchors, and in what nothing holds, both give way (1/2).
    """
    members = [joints.member[a:b].tolist() for a, b in pairwise(joints.first)]
    joint_of = {node: j for j, nodes in enumerate(members) for node in nodes}
    held = {
        _far_side(span, node): row
        for span in layout.ropes
        for row, node in enumerate(layout.anchor_nodes)
        if span.first <= node <= span.last
    }
    distance, anchor_of = _distances(layout, held, members, joint_of)
    segments = [j for span in layout.ropes for j in range(span.first, span.last)]
    segments.sort(key=lambda j: (max(distance[j], distance[j + 1]), j))
    steps = [distance[j] - distance[j + 1] for j in segments]
    share = [0.5 if step == 0 else (0.0 if step < 0 else 1.0) for step in steps]
    anchor = [anchor_of[j if step < 0 else j + 1] for j, step in zip(segments, steps, strict=True)]
    ends = [[joint_of.get(j + k, -1) for j in segments] for k in range(2)]
    return Order(
        np.array(segments, np.int64),
        np.array(share, np.float64),
        np.array(anchor, np.int64),
        np.array(ends, np.int64),
    )


def _far_side(span: Span, node: int) -> int:
    """A held end's node, or the innermost one on its drum: all rope comes from there."""
    return {span.start: span.first, span.end: span.last}.get(node, node)


def _distances(
    layout: Layout, held: dict[int, int], members: list[list[int]], joint_of: dict[int, int]
) -> tuple[dict[int, int], dict[int, int]]:
    """Count segments from every node to the nearest anchor, and say which one; 0 and -1 where none is."""
    span_of = {node: span for span in layout.ropes for node in range(span.first, span.last + 1)}
    distance: dict[int, int] = {}
    anchor: dict[int, int] = {}
    queue = deque((node, 0, row) for node, row in sorted(held.items()))
    while queue:
        node, far, row = queue.popleft()
        if node in distance:
            continue
        distance[node], anchor[node] = far, row
        if node in joint_of:
            queue.extendleft((other, far, row) for other in members[joint_of[node]])
        span = span_of[node]
        near = (other for other in (node - 1, node + 1) if span.first <= other <= span.last)
        queue.extend((other, far + 1, row) for other in near)
    nodes = span_of
    return {i: distance.get(i, 0) for i in nodes}, {i: anchor.get(i, -1) for i in nodes}
