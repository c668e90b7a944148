"""What has parted of ropes, as pages are told of it: where, when, at what tension, where a gap is."""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterable
from typing import Any, NamedTuple

import numpy as np

from ropewalk.core.arrays import Floats
from ropewalk.lowering import Span
from ropewalk.record.parted import Parting
from ropewalk.scene import Scene
from ropewalk.simulation import Simulation


class Parted(NamedTuple):
    """A parting, and where that is along its rope, or what of it is off its drums."""

    parting: Parting
    place: float  # [m] of unstretched rope from its start to the middle of the segment
    length: float  # [m] of the whole rope


def located(parting: Parting, scene: Scene, span: Span, rest: Floats) -> Parted:
    """Return a parting with its place along its rope, which has these unstretched lengths then, (s,) [m]."""
    rope, k = scene.rope_named(parting.rope), span.spare_start + parting.segment
    if not any(winch.rope == rope.name for winch in scene.winches):
        place = (parting.segment + 0.5) * rope.segment_length
        return Parted(parting, place, rope.length_unstretched)
    own = rest[span.first : span.last]
    off = np.union1d(np.flatnonzero(own), k)
    own = np.where(own > 0.0, own, rope.segment_length)  # of what has parted, too
    before = float(own[off[0] : k].sum()) + 0.5 * float(own[k])
    return Parted(parting, before, float(own[off[0] : off[-1] + 1].sum()))


def gaps(simulation: Simulation) -> dict[int, Parting]:
    """Return what has parted of ropes that are still drawn as one, by the index of the segment."""
    parted, layout = simulation.arrays.memory.parting, simulation.layout
    inside = {j for span in layout.ropes for j in range(span.first, span.last)}
    return {
        j: Parting(float(parted.time[j]), *layout.rope_of(j), float(parted.tension[j]))
        for j in map(int, np.flatnonzero(np.isfinite(parted.time)))
        if j in inside
    }


def unknown(found: Iterable[Parting], known: Iterable[Parted]) -> list[Parting]:
    """Return the partings that are not known, of those `found` in ropes that are still drawn as one.

    Known ones have the names that ropes had then; where a rope has been torn since, one is known by time and
    tension, each as often as it is known: two cuts of slack rope at one moment differ by their places alone.
    """
    left, new = [one.parting for one in known], list[Parting]()
    for one in found:
        left.remove(one) if one in left else new.append(one)
    older = Counter((one.time, one.tension) for one in left)
    fresh = list[Parting]()
    for one in new:
        older[one.time, one.tension] -= 1
        if older[one.time, one.tension] < 0:
            fresh.append(one)
    return fresh


def told(
    known: Iterable[Parted], where: dict[int, Parting], later: float = 0.0
) -> dict[str, list[dict[str, Any]]]:
    """Return what a layout message says of it; times are shown `later` [s]."""
    return {
        "parted": [
            {
                "rope": one.rope,
                "place": place,
                "length": length,
                "tension": one.tension,
                "time": one.time + later,
            }
            for one, place, length in known
        ],
        "gaps": [{"index": index, "time": one.time + later} for index, one in where.items()],
    }
