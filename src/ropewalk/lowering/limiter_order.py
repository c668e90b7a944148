"""The order in which the stretch limiter visits the segments."""

from __future__ import annotations

from collections import deque

import numpy as np

from ropewalk.core.arrays import Floats, Ints
from ropewalk.lowering.layout import Layout, Span


def limiter_order(layout: Layout) -> tuple[Ints, Floats]:
    """Return segments from the anchors outward, and the first node's share of each correction.

    The node nearer to an anchor stays (share 0 or 1); halfway between two anchors, and in a rope
    that nothing holds, both give way (1/2).
    """
    order: list[int] = []
    share: list[float] = []
    for span in layout.ropes:
        held = tuple(_far_side(span, node) for node in layout.anchor_nodes)
        distance = _distances(span.first, span.last, held)
        segments = range(span.first, span.last)

        def far(j: int, d: dict[int, int] = distance) -> int:
            return max(d[j], d[j + 1])

        for j in sorted(segments, key=lambda j: (far(j), j)):
            near, other = distance[j], distance[j + 1]
            order.append(j)
            share.append(0.5 if near == other else (0.0 if near < other else 1.0))
    return np.array(order, dtype=np.int64), np.array(share, dtype=np.float64)


def _far_side(span: Span, node: int) -> int:
    """A held end's node, or the innermost one on its drum: all rope comes from there."""
    return {span.start: span.first, span.end: span.last}.get(node, node)


def _distances(first: int, last: int, anchors: tuple[int, ...]) -> dict[int, int]:
    """Count segments from every node of a rope to the nearest anchor; 0 everywhere without one."""
    held = [node for node in anchors if first <= node <= last]
    if not held:
        return dict.fromkeys(range(first, last + 1), 0)
    distance = dict.fromkeys(held, 0)
    queue = deque(held)
    while queue:
        node = queue.popleft()
        for other in (node - 1, node + 1):
            if first <= other <= last and other not in distance:
                distance[other] = distance[node] + 1
                queue.append(other)
    return distance
