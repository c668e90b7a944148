"""What to say of the moment on a clamp of a taut rope whose segments are longer than its bend there.

Under a tension T a rope bends at a clamp within sqrt(EI / T) or so, and the clamp bears the moment
sqrt(EI T) a, a the angle at which the rope goes on. Of a chain of segments l it is
sqrt(EI T) a / sqrt(1 + T l^2 / 4 EI): their angles p beyond a have
p(i+1) - 2 p(i) + p(i-1) = (T l^2 / EI) p(i), and half a cell lies beside the clamp.
Source: Poffenberger and Swart, IEEE Trans. Power Apparatus and Systems 84 (1965) 281, for the smooth rope.
"""

from __future__ import annotations

import math
from typing import TYPE_CHECKING

import numpy as np

from ropewalk.record.drums import off_drums
from ropewalk.record.extremes import Extreme

if TYPE_CHECKING:
    from ropewalk.lowering.layout import Span
    from ropewalk.record.result import Result

_LOW = 0.02  # [1] by which a moment may be too low without a word


def moment_note(result: Result, moment: Extreme) -> str:
    """Say by how much the largest moment on a clamp is too low for the length of its segments; else ""."""
    if not moment.value > 0.0 or not math.isfinite(moment.value):
        return ""
    node = result.layout.anchor_nodes[moment.place]
    name, _ = result.layout.rope_of(node)
    rope, span = result.scene.rope_named(name), result.layout.span(name)
    frame = min(int(np.searchsorted(result.time, moment.until)), result.good_frames - 1)
    beside = _beside(result, span, node, float(result.time[frame]))
    tension = float(result.read("tension", frame, frame + 1)[0, beside].max(initial=0.0))
    if not 0.0 < tension < math.inf:
        return ""
    bend = math.sqrt(rope.bending_stiffness / tension)
    share = math.sqrt(1.0 + (0.5 * rope.segment_length / bend) ** 2)
    if share < 1.0 + _LOW:
        return ""
    enough = math.ceil(rope.length_unstretched / (2.0 * bend * math.sqrt((1.0 + _LOW) ** 2 - 1.0)))
    length = rope.segment_length
    return (
        f"too low: a rope as taut bends there within {bend:.3g} m, which segments of {length:.3g} m "
        f"do not show. It is about {share:.3g} times as large; {enough} segments or more have it to "
        f"{100.0 * _LOW:g} %"
    )


def _beside(result: Result, span: Span, node: int, time: float) -> slice:
    """Return the segments beside an anchor's node; at a drum the one that is off it at a time [s]."""
    ends = [winch.end for winch in result.scene.winches if winch.rope == span.name]
    off = off_drums(result, span, time) if ends else np.zeros(0, dtype=np.int64)
    for end, at, last in (("start", span.start, 0), ("end", span.end, -1)):
        if end in ends and node == at and off.size:
            beside = span.first + int(off[last])
            return slice(beside, beside + 1)
    return slice(max(node - 1, span.first), min(node + 1, span.last))
