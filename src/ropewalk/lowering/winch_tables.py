"""Winches of a scene -> their table."""

from __future__ import annotations

import math
from collections.abc import Sequence

import numpy as np

from ropewalk.core.arrays import Winches
from ropewalk.lowering.layout import Layout, Span
from ropewalk.lowering.masses import line_density
from ropewalk.lowering.slide_checks import shortest_length
from ropewalk.scene import Rope, Scene


def winch_tables(scene: Scene, layout: Layout) -> Winches:
    """Return the table of a scene's winches."""
    rows = []
    for winch in scene.winches:
        rope, span = scene.rope_named(winch.rope), layout.span(winch.rope)
        at_start = winch.end == "start"
        drum = span.start if at_start else span.end
        length = rope.segment_length
        friction = rope.segment_friction * length
        form = (friction, 0.0) if rope.made_of.friction == "vector" else (0.0, friction)
        rows.append(
            (
                layout.anchor_nodes.index(drum),
                span.first if at_start else span.last,
                span.last if at_start else span.first,
                1 if at_start else -1,
                _next_load(rope, span, at_start),
                winch.speed,
                winch.start,
                winch.stop,
                length,
                shortest_length(scene, winch, length),
                winch.max_length or math.inf,
                span.length_on_drum(winch.end, length) if winch.on_drum is None else winch.on_drum,
                rope.segment_stiffness * length,
                *form,
                line_density(rope),
            )
        )
    return winches_of(rows)


def _next_load(rope: Rope, span: Span, at_start: bool) -> int:
    """Return the node between a rope's ends with a load that is next to this end; -1: none."""
    nodes = {rope.node_index(load.node) for load in rope.loads} - {0, rope.segments}
    if not nodes:
        return -1
    return span.start + (min(nodes) if at_start else max(nodes))


def winches_of(rows: Sequence[tuple[float, ...]]) -> Winches:
    """Return a table of rows with a number for each of its columns."""
    columns = np.array(rows, dtype=np.float64).reshape(-1, 16).T
    anchor, first, last, step, load = (column.astype(np.int64) for column in columns[:5])
    rest = (np.ascontiguousarray(column) for column in columns[5:])
    return Winches(anchor, first, last, step, load, *rest)
