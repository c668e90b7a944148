"""Half a segment's weight at a rope's end: the anchor there bears it, and no segment does.

The mass of a rope lies in its nodes, of each segment half at either end. So the tension of the segment beside
an anchor is that of its middle, and a heavy rope pulls by as much more at the anchor as half of it weighs.
"""

from __future__ import annotations

import math
from typing import TYPE_CHECKING

import numpy as np

from ropewalk.core.arrays import Floats
from ropewalk.record.margins import breaking_load
from ropewalk.words.percents import percent
from ropewalk.words.safe_side import percent_up

if TYPE_CHECKING:
    from ropewalk.lowering import Layout
    from ropewalk.record.extremes import Extreme
    from ropewalk.record.result import Result
    from ropewalk.scene import Scene

MORE = 0.01  # [1] of the tension: an anchor that bears so much more is told
_APART = 0.1  # [1] of half a segment's weight: both may have their largest at other times


def anchor_beside(scene: Scene, layout: Layout, segment: int) -> int | None:
    """Return the row of the anchor at a rope's end beside this segment; None where more than it is there.

    None, too, of an anchor that moves, and of springs, whose nodes have masses of their own.
    """
    name, _ = layout.rope_of(segment)
    rope, span = scene.rope_named(name), layout.span(name)
    nodes = [one.node for one in rope.loads] + [one.node for one in rope.forces]
    given = [rope.node_index(node) for node in nodes]
    for node, beside in ((span.first, span.first), (span.last, span.last - 1)):
        if beside != segment or node not in layout.anchor_nodes or rope.made_of.kind == "springs":
            continue
        row = layout.anchor_nodes.index(node)
        alone = node not in layout.tied_nodes and node - span.start not in given
        if alone and scene.anchors[row].motion.kind == "fixed":
            return row
    return None


def is_end_weight(
    model: tuple[Scene, Layout], row: int, segment: int, pulls: tuple[float, float], at: Floats,
    least: float = MORE,
) -> bool:  # fmt: skip
    """Tell whether the anchor in this row bears more by half the weight of its segment, and by that alone.

    And more by the `least` of the tension [1]. `pulls` are the segment's tension and the anchor's force [N],
    `at` (n, 3) the places of all nodes [m]. Wind and bending act on the anchor's node as well: what they
    make more is no weight.
    """
    (scene, layout), (tension, force) = model, pulls
    if not tension > 0.0 or not force > (1.0 + least) * tension:
        return False
    rope, node = scene.rope_named(layout.rope_of(segment)[0]), layout.anchor_nodes[row]
    half = [0.5 * rope.own_mass / rope.segments * part for part in scene.gravity]
    if rope.submerged_weight is not None:  # what water leaves of it
        half = [-0.5 * rope.submerged_weight * rope.segment_length * part for part in scene.up]
    here, there = at[node].tolist(), at[segment + 1 if node == segment else segment].tolist()
    if here == there:
        return False
    along = [tension * (b - a) / math.dist(here, there) for a, b in zip(here, there, strict=True)]
    alone = math.hypot(*(a + b for a, b in zip(along, half, strict=True)))
    return abs(force - alone) <= _APART * math.hypot(*half)


def weight_note(result: Result, peak: Extreme, pressed: bool) -> str:
    """Say what the anchor beside the largest tension bears, where that is half a segment's weight more.

    `pressed`: something touches the rope there, which the anchor bears, too.
    """
    if not peak.value > 0.0 or not math.isfinite(peak.value) or pressed:
        return ""
    row = anchor_beside(result.scene, result.layout, peak.place)
    if row is None:
        return ""
    if "greatest_reactions" in result.source.names:
        force = float(result.read("greatest_reactions", 0, result.good_frames)[:, row].max())
    else:
        pulls = result.read("reactions", 0, result.good_frames)[:, row]
        force = float(np.linalg.norm(pulls, axis=1).max())
    if not force > (1.0 + MORE) * peak.value:
        return ""
    # an equilibrium is one frame, and does not say of rigid links when
    frame = result.frame_at(peak.until) if math.isfinite(peak.until) else 0
    places = result.read("positions", frame, frame + 1)[0]
    model = result.scene, result.layout
    if not is_end_weight(model, row, peak.place, (peak.value, force), places):
        return ""
    more = percent(100.0 * (force / peak.value - 1.0))
    load = breaking_load(result.scene.rope_named(result.layout.rope_of(peak.place)[0]))
    share = "" if load is None else f", {percent_up(100.0 * force / load, 3)} of the breaking load"
    return (
        f"the anchor bears {force:.6g} N, half a segment's weight more ({more}){share}; "
        "more segments bring the two together"
    )
