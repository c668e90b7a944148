"""Which anchors go as all others do that hold the same ropes: what is between those may be led with them."""

from __future__ import annotations

import numpy as np

from ropewalk.core.arrays import Ints
from ropewalk.lowering.layout import Layout
from ropewalk.scene import Anchor, Joint, Slide
from ropewalk.scene.motions import Motion, Table

_NEAR = 1e-9  # [1] of a table's places: they are the same way from another place


def going_alike(
    anchors: tuple[Anchor, ...],
    joints: tuple[Joint, ...],
    slides: tuple[Slide, ...],
    layout: Layout,
) -> Ints:
    """Return 1 for each anchor, (a,), that alone holds what hangs together, or with others that go alike.

    Ropes hang together by joints and slides. Those that go round go alike only where there is but one.
    """
    ties = [[layout.node(tie.node, tie.rope) for tie in one.points] for one in joints]
    ties += [[layout.node(one.node, one.rope), layout.node(0, one.on)] for one in slides]
    parent = {span.name: span.name for span in layout.ropes}

    def piece(node: int) -> str:
        name = layout.rope_of(node)[0]
        while parent[name] != name:
            parent[name] = name = parent[parent[name]]
        return name

    for first, *others in ties:
        for node in others:
            parent[piece(node)] = piece(first)
    found, leads = np.ones(len(anchors), np.int64), dict[str, Anchor]()
    own = [piece(node) for node in layout.anchor_nodes]
    pairs = list(zip(own, anchors, strict=True))
    apart = {name for name, one in pairs if not _alike(leads.setdefault(name, one), one)}
    found[[name in apart for name in own]] = 0
    return found


def _alike(one: Anchor, other: Anchor) -> bool:
    if one is other:
        return True
    if one.above_ground or other.above_ground:
        return False
    return same_way(one.motion, other.motion)


def same_way(one: Motion, other: Motion) -> bool:
    """Tell whether two motions take their nodes the same way, each from its own place."""
    if isinstance(one, Table) and isinstance(other, Table):
        if one.times != other.times or one.interpolation != other.interpolation:
            return False
        ways = [np.asarray(table.positions, dtype=float) for table in (one, other)]
        near = _NEAR * float(max(np.abs(way).max() for way in ways))
        return bool(np.abs(np.diff([way - way[0] for way in ways], axis=0)).max() <= near)
    return one == other and one.kind in ("fixed", "shake", "velocity")
