"""The part of a run before it broke."""

from __future__ import annotations

from collections.abc import Callable
from functools import wraps
from typing import TYPE_CHECKING, TypeVar
from weakref import WeakKeyDictionary

import numpy as np

from ropewalk.record.facts import BROKE

if TYPE_CHECKING:
    from ropewalk.record.result import Result

_T = TypeVar("_T")
_CHUNK = 256  # frames looked at together
_ROUNDING = 1e-9  # [1]


def remembered(function: Callable[[Result], _T]) -> Callable[[Result], _T]:
    """Remember what a function says of a result, as long as the result lives."""
    known: WeakKeyDictionary[Result, tuple[int, _T]] = WeakKeyDictionary()

    @wraps(function)
    def wrapper(result: Result) -> _T:
        found = known.get(result)
        if found is None or found[0] != len(result.time):
            found = known[result] = (len(result.time), function(result))
        return found[1]

    return wrapper


@remembered
def good_part(result: Result) -> int:
    """Return the number of frames before the run broke (1 at least); the others were recorded into it.

    By what the run itself noted, and of a run that broke by the lengths of the segments.
    """
    last = _until_noted(result)
    if result.status != BROKE and last == len(result.time):
        return last  # the simulation knows best: soft ropes may hang at many times their length
    from ropewalk.record.contacts import model_of  # which imports what imports this

    longest = np.full(result.layout.segments, np.inf)
    factor = model_of(result).system.break_stretch * (1.6 if result.scene.winches else 1.0)
    for span, rope in zip(result.layout.ropes, result.scene.ropes, strict=True):
        if rope.segment_length > 0.0:
            longest[span.first : span.last] = factor * rope.segment_length
    for start in range(0, last, _CHUNK):
        points = result.read("positions", start, min(start + _CHUNK, last))
        with np.errstate(all="ignore"):
            length = np.sqrt((np.diff(points, axis=1) ** 2).sum(axis=2))
            whole = length <= longest
            if result.scene.parts:  # what has parted has no length
                whole |= result.read("rest_length", start, start + len(points)) == 0.0
            fine = whole.all(axis=1) & np.isfinite(points).all(axis=(1, 2))
        if not fine.all():
            return max(1, start + int(np.argmin(fine)))
    return last


def _until_noted(result: Result) -> int:
    """Return the number of frames up to the break that a run which went on has noted."""
    broke = [
        event["time"] for event in result.events if event["event"] == BROKE and "time" in event
    ]
    if not (broke and result.facts.keep_going):
        return len(result.time)
    time = result.time
    end = float(broke[0]) + _ROUNDING * max(float(time[-1] - time[0]), 1.0)
    return max(1, int(np.searchsorted(time, end, side="right")))
