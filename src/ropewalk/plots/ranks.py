"""How numbers are spread, and how strongly one follows another, whatever the curve."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

Floats = NDArray[np.float64]


def rank_correlation(x: Floats, y: Floats) -> float:
    """Return the size of Spearman's rank correlation [1]."""
    if len(x) < 3 or np.ptp(x) == 0.0 or np.ptp(y) == 0.0:
        return 0.0
    return abs(float(np.corrcoef(ranks(x), ranks(y))[0, 1]))


def ranks(values: Floats) -> Floats:
    """Return the place of every value among all, of equal ones the mean."""
    _, place, count = np.unique(values, return_inverse=True, return_counts=True)
    return np.asarray((np.cumsum(count) - 0.5 * (count + 1))[place])


def by_factors(values: Floats) -> bool:
    """Tell whether values are spread by factors: far apart, and their median nearer the geometric middle."""
    sound = np.unique(values[np.isfinite(values)])
    if len(sound) < 2 or sound[0] <= 0.0 or sound[-1] / sound[0] < 50.0:
        return False
    if len(sound) == 2:
        return bool(sound[-1] / sound[0] >= 100.0)
    low, middle, high = sound[0], float(np.median(sound)), sound[-1]
    by_factor = np.log(middle / low) / np.log(high / low)
    return bool(abs(by_factor - 0.5) <= abs((middle - low) / (high - low) - 0.5))
