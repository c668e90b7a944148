"""Which node or segment of one variant stands for one of another."""

from __future__ import annotations

import numpy as np

from ropewalk.core.arrays import Floats
from ropewalk.lowering import Span
from ropewalk.simulation import Simulation


def counterpart(main: Simulation, other: Simulation, node: int) -> int | None:
    """Return the node of another variant that stands for a node of the first one."""
    if main is other or not 0 <= node < main.layout.nodes:
        return node
    found = _share_of(main, other, node, 0.0)
    if found is None:
        return None
    there, share = found
    return there.start + round(share * (there.end - there.start))


def segment_of(main: Simulation, other: Simulation, segment: int) -> int | None:
    """Return the segment of another variant in which the middle of one of the first lies."""
    if main is other or not 0 <= segment < main.layout.segments:
        return segment
    found = _share_of(main, other, segment, 0.5)
    if found is None:
        return None
    there, share = found
    count = there.end - there.start
    name, number = main.layout.rope_of(segment)
    here = main.layout.span(name)
    if here.end - here.start == count:  # what came off a drum is beyond the ends
        return there.start + number
    return there.start + min(int(share * count), count - 1)


def _share_of(
    main: Simulation, other: Simulation, index: int, beyond: float
) -> tuple[Span, float] | None:
    """Return a rope of another variant, and how far along it a place is, `beyond` a node in segments.

    None when the rope is missing there.
    """
    name, number = main.layout.rope_of(index)
    if all(span.name != name for span in other.layout.ropes):
        return None
    here = main.layout.span(name)
    return other.layout.span(name), (number + beyond) / max(here.end - here.start, 1)


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
