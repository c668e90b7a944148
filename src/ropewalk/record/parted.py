"""Where and when ropes parted, as the events of a run tell it."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING, Any, Literal, NamedTuple

import numpy as np

from ropewalk.hands.drum import PARTED
from ropewalk.methods.registry import METHODS
from ropewalk.words.prefixes import prefixed

if TYPE_CHECKING:
    from collections.abc import Iterable, Sequence

    from numpy.typing import ArrayLike, NDArray

    from ropewalk.record.event_log import Event
    from ropewalk.record.result import Result

_NAMED = 3


class Parting(NamedTuple):
    """A segment that has parted."""

    time: float  # [s] the end of the step in which its tension passed the breaking load
    rope: str
    segment: int  # counted from the rope's start
    tension: float  # that it carried then [N]

    def __str__(self) -> str:
        """Say which, when and at what."""
        at = f"{prefixed(self.tension, 'N', 4)} at t = {self.time:.6g} s"
        return f"segment {self.segment} of {self.rope!r} at {at}"


def partings_of(events: Iterable[Event]) -> tuple[Parting, ...]:
    """Return the partings that events tell of, in order of time."""
    return tuple(
        Parting(float(one["time"]), one["rope"], int(one["segment"]), float(one["tension"]))
        for one in events
        if one["event"] == PARTED
    )


def count_parted(partings: Sequence[Parting], times: ArrayLike, method: str) -> NDArray[np.int64]:
    """Return how many of these partings, in order of time, frames of some times [s] have in them.

    Steps of a fixed length end with what they part. `adaptive` parts as it goes on: a frame of that very
    time is before it.
    """
    side: Literal["left", "right"] = "right" if METHODS[method].fixed else "left"
    found = np.searchsorted([one.time for one in partings], np.asarray(times, np.float64), side)
    return np.asarray(found, np.int64)


def fault_of_partings(result: Result) -> str:
    """Say why a result's log cannot be believed in what parted; "" where it can.

    It is the only record of when and at what tension; which segments are gone the frames know, too. (A winch
    takes segments away as well.)
    """
    if result.facts.log_fault:
        return result.facts.log_fault
    last = float(result.time[-1])
    for rope in result.scene.ropes:
        wound = any(winch.rope == rope.name for winch in result.scene.winches)
        if math.isinf(rope.strength) or wound or rope.segment_length == 0.0:
            continue
        partings = [one for one in partings_of(result.events) if one.rope == rope.name]
        told = int(count_parted(partings, last, result.plan.method))
        span = result.layout.span(rope.name)
        there = result.read("rest_length", result.frames - 1)[0, span.start : span.end] > 0.0
        gone = int((~there).sum())
        if gone != told:
            return f"is damaged: it tells of {told} partings of {rope.name!r}, the frames of {gone}"
    return ""


def parting_rows(partings: tuple[Parting, ...]) -> dict[str, Any]:
    """Return the rows of a table: how many segments parted, which, and when the first one; NaN: none did."""
    more = len(partings) - _NAMED
    told = "; ".join(str(one) for one in partings[:_NAMED])
    first = partings[0] if partings else Parting(math.nan, "", 0, math.nan)
    return {
        "segments parted": len(partings),
        "segments parted at": told + (f"; and {more} more" if more > 0 else ""),
        "first parting [s]": first.time,
        "tension at the first parting [N]": first.tension,
    }
