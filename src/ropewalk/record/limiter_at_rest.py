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
#: What follows from it, of a check and of a result.
WITHOUT = (
    "all that is said of rest is without the limiter: with it a span hangs flatter and carries more, and so "
    "do its anchors; let a run come to rest for that"
)


def stretches_beyond(longest: float, stretch: Floats) -> NDArray[np.bool_]:
    """Tell which stretches [1] are more than a limiter's longest [1]; any shape."""
    return np.asarray(stretch > longest * (1.0 + _ROUNDING))


def rests_beyond(result: Result, found: Mapping[str, Extreme]) -> bool:
    """Tell whether a result is an equilibrium with a segment beyond its limiter, by its extremes."""
    limiter = result.scene.limiter
    if limiter is None or result.status != AT_REST:
        return False
    most = np.asarray(found["greatest stretch"].value)
    return bool(stretches_beyond(limiter.max_stretch, most))


def rest_limiter_note(result: Result, found: Mapping[str, Extreme]) -> str:
    """Say so where an equilibrium lies beyond its limiter; else ""."""
    limiter = result.scene.limiter
    if limiter is None or not rests_beyond(result, found):
        return ""
    most = found["greatest stretch"].value
    return (
        f"it would act at rest, where a segment is {most:.4g} of its length and it allows "
        f"{limiter.max_stretch:g}: {WITHOUT}"
    )
