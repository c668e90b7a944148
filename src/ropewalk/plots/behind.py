"""Which segments of ropes obstacles hide from the viewer."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray

from ropewalk.laws.contact_frame import find_gaps
from ropewalk.plots.sight import Floats
from ropewalk.record.obstacle_table import obstacle_table, table_then

if TYPE_CHECKING:
    from ropewalk.record.result import Result

_ENDLESS = ("plane", "half-pipe")  # drawn edge-on alone, where they hide nothing
_INSIDE = 0.25  # [1] of half a width: nearer to a surface than this is behind it
_LOOKS = 100  # along a line of sight, at most
_FAR = 100.0  # [1] of the ropes' extent: a body farther away hides nothing


class Obstacles:
    """The obstacles of a run that may stand before its ropes."""

    def __init__(self, result: Result, toward: Floats) -> None:
        """`toward` (3,) points at the viewer."""
        self._result, self._toward = result, toward
        self._table = obstacle_table(result.scene, result.layout)
        bodies = result.scene.obstacles
        self._rows = [row for row, body in enumerate(bodies) if body.kind not in _ENDLESS]

    def hide(self, places: Floats, half: Floats, time: float) -> NDArray[np.bool_]:
        """Return which segments are hidden at a time [s], between nodes at places (n, 3) [m].

        Half their widths is (n - 1,) [m]. From the middle of each we go towards the viewer, as far in one go
        as no surface can be.
        """
        hidden: NDArray[np.bool_] = np.zeros(len(half), dtype=bool)
        if self._table is None or not self._rows:
            return hidden
        table = table_then(self._result, self._table, time)
        middle = 0.5 * (places[:-1] + places[1:])
        x = np.ascontiguousarray((middle + half[:, None] * self._toward).T)
        left: NDArray[np.bool_] = np.asarray(np.isfinite(x).all(axis=0))
        if not left.any():
            return hidden
        far = _FAR * float(np.ptp(places[np.isfinite(places).all(axis=1)], axis=0).max())
        for _ in range(_LOOKS):
            at = np.flatnonzero(left)
            if not len(at):
                break
            gaps = np.empty((len(self._result.scene.obstacles), len(at)))
            find_gaps(np.ascontiguousarray(x[:, at]), table, time, gaps)
            gap, least = gaps[self._rows].min(axis=0), _INSIDE * half[at]
            hidden[at] = gap < least
            left[at] = (gap >= least) & (gap < far)
            x[:, at] += np.maximum(gap, least) * self._toward[:, None]
        return hidden
