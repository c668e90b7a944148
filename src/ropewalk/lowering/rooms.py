"""Where two bodies leave a rope between them less room than it is thick."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from ropewalk.core.arrays import Floats
from ropewalk.laws.obstacle import Obstacles
from ropewalk.laws.obstacle_places import gaps, surface_near

SQUEEZED = 0.1  # of a rope's diameter that is lacking, from which it is told [1]
FACING = -0.9  # [1] cosine of two normals: these surfaces face each other, as a groove's do not


class Room(NamedTuple):
    """Room for one node between two bodies that face each other."""

    node: int
    one: int  # the obstacles
    other: int
    room: float  # between their surfaces there [m]; negative where they overlap
    size: float  # diameter of the node's rope [m]

    @property
    def lacks(self) -> float:
        """What of its diameter the rope lacks [m]."""
        return self.size - self.room

    def words(self, one: str, other: str) -> str:
        """Say what the bodies of these names leave."""
        bodies = f"{one!r} and {other!r}"
        if self.room <= 0.0:
            return f"{bodies}, which overlap by {-1e3 * self.room:.3g} mm there"
        return f"{bodies}, which leave a rope of {1e3 * self.size:.3g} mm a gap of {1e3 * self.room:.3g} mm"


def tightest(
    table: Obstacles, x: Floats, t: float, nodes: NDArray[np.bool_], *, touching: bool = True
) -> Room | None:
    """Return which of the `nodes` (n,) at places (3, n) [m] lacks most room at `t` [s]; None: none lacks it.

    With `touching` of nodes that both bodies press only; else also of those beside which both come together.
    A body that turns freely and is not round counts only once `at_rates` has put it where it is.
    """
    found, size = gaps(table, x, t), 2.0 * table.thickness
    able = nodes & (size > 0.0)
    known = [row for row in range(len(found)) if not (table.wheel[row] >= 0 and table.sweeps[row])]
    if touching:
        known = [row for row in known if (able & (found[row] < table.thickness)).any()]
    worst: Room | None = None
    for k, one in enumerate(known):
        for other in known[k + 1 :]:
            lacks = np.where(able, size - found[one] - found[other], -np.inf)
            tight = lacks > max(0.0, worst.lacks if worst else 0.0)
            tight &= lacks > SQUEEZED * size
            if touching:
                tight &= np.maximum(found[one], found[other]) < table.thickness
            for node in np.flatnonzero(tight)[np.argsort(-lacks[tight], kind="stable")].tolist():
                if _face(table, one, other, x[:, node], t):
                    room = float(found[one, node] + found[other, node])
                    worst = Room(node, one, other, room, float(size[node]))
                    break
    return worst


def _face(table: Obstacles, one: int, other: int, place: Floats, t: float) -> bool:
    """Tell whether the surfaces of two bodies next to a place (3,) [m] face each other."""
    a, b = (np.array(surface_near(table, row, place, t)[1:4]) for row in (one, other))
    return float(a @ b) < FACING
