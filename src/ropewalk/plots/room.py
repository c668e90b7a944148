"""Room for words in a picture: which would lie on others."""

from __future__ import annotations

import numpy as np
from matplotlib.axes import Axes

from ropewalk.plots.sight import Floats

_LETTER = 0.58  # [1] of the size of letters: how wide one is, on average
_HIGH = 1.25  # [1] of it: how high a line is
_ASIDE = {"left": 0.0, "center": 0.5, "right": 1.0}
_BELOW = {"bottom": 0.0, "center": 0.5, "top": 1.0}


class Room:
    """Where words stand in axes of these limits, drawn so wide and high [inch] at most."""

    def __init__(self, axes: Axes, inches: tuple[float, float], magnified: float = 1.0) -> None:
        """Begin without words; heights are drawn `magnified` times as large as widths."""
        wide, high = (float(np.ptp(limits)) for limits in (axes.get_xlim(), axes.get_ylim()))
        per = 72.0 * min(inches[0] / wide, inches[1] / (high * magnified))  # [pt/m]
        self._scale = np.array([per, per * magnified])
        self._sides = np.array(axes.get_xlim()) * per
        self._taken: list[tuple[Floats, Floats]] = []

    def side(self, at: Floats, words: str, *, wanted: str, size: float) -> str:
        """Return how words at a place [m], (2,), are aligned to stay inside; as `wanted` if possible."""
        wide = _LETTER * len(words) * size
        for ha in (wanted, "center", "left", "right"):
            left = float(at[0] * self._scale[0]) - wide * _ASIDE[ha]
            if self._sides[0] <= left and left + wide <= self._sides[1]:
                return ha
        return wanted

    def take(
        self, at: Floats, words: str, *, ha: str, va: str, size: float, aside: float = 0.0
    ) -> bool:
        """Take the room of words of this size [pt] at a place [m], (2,), `aside` [pt] to its right.

        False, and nothing is taken, where some of it is taken already.
        """
        extent = np.array([_LETTER * len(words), _HIGH]) * size
        low = np.asarray(at) * self._scale + (aside, 0.0) - extent * (_ASIDE[ha], _BELOW[va])
        high = low + extent
        if any((low < other[1]).all() and (other[0] < high).all() for other in self._taken):
            return False
        self._taken.append((low, high))
        return True
