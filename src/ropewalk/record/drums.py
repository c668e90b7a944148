"""Places of ropes that winches wind, in words: numbers of what lies on a drum tell nobody anything."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from ropewalk.core.arrays import Ints
from ropewalk.record.quantities import has_rope

if TYPE_CHECKING:
    from ropewalk.lowering.layout import Span
    from ropewalk.record.result import Result


def rope_place(result: Result, noun: str, index: int, time: float) -> str:
    """Return where a node or a segment ("node", "segment") of this index in the arrays is at a time [s].

    By the frame at that time; between two frames what is off the drum in either counts as off. So does what
    has parted.
    """
    name, number = result.layout.rope_of(index)
    plain = f"{noun} {number} of rope {name!r}"
    ends = [winch.end for winch in result.scene.winches if winch.rope == name]
    if not ends or "rest_length" not in result.source.names:
        return plain
    span = result.layout.span(name)
    off = off_drums(result, span, time)
    if not off.any():
        return plain
    first, last = int(off[0]), int(off[-1])
    place = index - span.first
    if noun == "node":
        last += 1
        if (place == first > 0 and "start" in ends) or (
            place == last < span.nodes - 1 and "end" in ends
        ):
            return f"at the drum of rope {name!r}"
    if place < first or place > last:
        return f"on the drum of rope {name!r}"
    if span.start <= index <= span.end - (noun == "segment"):
        return plain
    return f"{plain}, paid out from the drum"


def off_drums(result: Result, span: Span, time: float) -> Ints:
    """Return which segments of a rope, counted along it, are not on a drum, in order.

    Between two frames those of either: what is reeled in before the next one has carried what it did.
    """
    frame = min(int(np.searchsorted(result.time, time)), result.good_frames - 1)
    first = frame if time >= result.time[frame] else max(frame - 1, 0)
    rest = result.read("rest_length", first, frame + 1)
    lengths = [rope.segment_length for rope in result.scene.ropes]
    seen = has_rope(result.layout, rest, lengths)[:, span.first : span.last]
    there = np.logical_or.reduce(seen, axis=0)
    for one in result.partings:
        if one.rope == span.name and one.time <= time:
            there[span.spare_start + one.segment] = True
    found: Ints = np.flatnonzero(there)
    return found
