"""How strongly one number follows another, whatever the curve."""

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
