"""Which pulls and pushes of a shape at rest are told: those that are no rounding."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

_ROUNDING = 1e-6  # [1] of the largest tension: a smaller push is none
FAR = 100.0  # [1] times the force that is left at rest: a smaller push or pull is none


def largest_push(tension: NDArray[np.float64], left: float) -> float:
    """Return the largest push among tensions at rest (s,) [N]; 0 where it is rounding.

    NaN are those that wait on a drum; `left` is the largest force that is left on a node [N].
    """
    push = -float(np.fmin.reduce(tension, initial=0.0))
    largest = float(np.fmax.reduce(np.abs(tension), initial=0.0))
    return push if push > max(_ROUNDING * largest, FAR * left) else 0.0


def pull_told(pull: float, left: float) -> float:
    """Return a pull at rest [N], 0 where it is rounding beside the largest force left on a node [N]."""
    return pull if pull > FAR * left else 0.0
