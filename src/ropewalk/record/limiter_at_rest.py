"""Whether an equilibrium lies beyond what a stretch limiter allows, which takes no part in it."""

from __future__ import annotations

from collections.abc import Mapping
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray

from ropewalk.core.arrays import Floats
from ropewalk.record.facts import AT_REST

if TYPE_CHECKING:
    from ropewalk.record.extremes import Extreme
    from ropewalk.record.result import Result

_ROUNDING = 1e-9  # [1] of a stretch
_DIGITS = 10  # that tell any such from 1
#: What follows from it, of a check and of a result.
WITHOUT = (
    "all that is said of rest is without the limiter: with it a span hangs flatter and carries more, and so "
    "do its anchors; let a run come to rest for that"
)


def stretches_beyond(longest: float, stretch: Floats) -> NDArray[np.bool_]:
    """Tell which stretches [1] are more than a limiter's longest [1]; any shape."""
    return np.asarray(stretch > longest * (1.0 + _ROUNDING))


def stretches_apart(stretch: float, longest: float) -> tuple[str, str]:
    """Return a stretch and the longest that is allowed [1] as text, in digits that tell them apart."""
    digits = 4
    while digits < _DIGITS and float(f"{stretch:.{digits}g}") <= longest:
        digits += 1
    return f"{stretch:.{digits}g}", f"{longest:g}"


def rests_beyond(result: Result, found: Mapping[str, Extreme]) -> set[str]:
    """Return the ropes of an equilibrium that have a segment beyond its limiter; `found` are its extremes."""
    limiter = result.scene.limiter
    if limiter is None or result.status != AT_REST:
        return set()
    if not stretches_beyond(limiter.max_stretch, np.asarray(found["greatest stretch"].value)):
        return set()
    beyond = set()
    for rope in result.scene.ropes:
        view = result.rope(rope.name)
        over = stretches_beyond(limiter.max_stretch, view.stretch[0]) & (view.rest_length[0] > 0.0)
        if over.any() and not rope.rigid:
            beyond.add(rope.name)
    return beyond


def rest_limiter_note(result: Result, found: Mapping[str, Extreme]) -> str:
    """Say so where an equilibrium lies beyond its limiter; else ""."""
    limiter = result.scene.limiter
    if limiter is None or not rests_beyond(result, found):
        return ""
    most, allowed = stretches_apart(found["greatest stretch"].value, limiter.max_stretch)
    return f"it would act at rest, where a segment is {most} of its length and it allows {allowed}: {WITHOUT}"
