"""What has parted of ropes, as pages are told of it: where, when, at what tension, where a gap is."""

from __future__ import annotations

from collections.abc import Iterable
from typing import Any, NamedTuple

import numpy as np

from ropewalk.record.parted import Parting
from ropewalk.scene import Scene
from ropewalk.simulation import Simulation


class Parted(NamedTuple):
    """A parting, and where that is along its rope."""

    parting: Parting
    place: float  # [m] of unstretched rope from its start to the middle of the segment
    length: float  # [m] of the whole rope


def located(parting: Parting, scene: Scene) -> Parted:
    """Return a parting with its place along its rope."""
    rope = scene.rope_named(parting.rope)
    return Parted(parting, (parting.segment + 0.5) * rope.segment_length, rope.length_unstretched)


def gaps(simulation: Simulation) -> dict[int, Parting]:
    """Return what has parted of ropes that are still drawn as one, by the index of the segment."""
    parted, layout = simulation.arrays.memory.parting, simulation.layout
    inside = {j for span in layout.ropes for j in range(span.first, span.last)}
    return {
        j: Parting(float(parted.time[j]), *layout.rope_of(j), float(parted.tension[j]))
        for j in map(int, np.flatnonzero(np.isfinite(parted.time)))
        if j in inside
    }


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
