"""Which node or segment of one variant stands for one of another."""

from __future__ import annotations

import numpy as np

from ropewalk.core.arrays import Floats
from ropewalk.simulation import Simulation


def counterpart(main: Simulation, other: Simulation, node: int) -> int | None:
    """Return the node of another variant that stands for a node of the first one."""
    if main is other or not 0 <= node < main.layout.nodes:
        return node
    name, number = main.layout.rope_of(node)
    spans = {span.name: span for span in other.layout.ropes}
    if name not in spans:
        return None
    here, there = main.layout.span(name), spans[name]
    share = number / max(here.end - here.start, 1)
    return there.start + round(share * (there.end - there.start))


def counterparts(here: Simulation, there: Simulation) -> Floats | None:
    """Return for every node of `here` its place among the nodes of `there`, fractional, (n,).

    None when a rope is missing there.
    """
    spans = {span.name: span for span in there.layout.ropes}
    found = np.zeros(here.layout.nodes)
    for span in here.layout.ropes:
        if span.name not in spans:
            return None
        other = spans[span.name]
        found[span.first : span.last + 1] = np.linspace(other.first, other.last, span.nodes)
    return found


def segment_of(main: Simulation, other: Simulation, segment: int) -> int | None:
    """Return the segment of another variant in which the middle of one of the first lies."""
    if main is other or not 0 <= segment < main.layout.segments:
        return segment
    name, number = main.layout.rope_of(segment)
    spans = {span.name: span for span in other.layout.ropes}
    if name not in spans:
        return None
    here, there = main.layout.span(name), spans[name]
    count = there.end - there.start
    share = (number + 0.5) / max(here.end - here.start, 1)
    return there.start + min(int(share * count), count - 1)
