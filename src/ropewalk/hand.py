"""Anchors as live objects: read where they are, move them by hand."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import ArrayLike

from ropewalk.core.arrays import Floats

if TYPE_CHECKING:
    from ropewalk.simulation import Simulation


class AnchorHandle:
    """One anchor of a running simulation; once it has let go it follows the node that it held."""

    def __init__(self, simulation: Simulation, row: int) -> None:
        self._simulation = simulation
        self._row = row

    @property
    def position(self) -> Floats:
        """Where the anchor is, or the node that it let go [m], (3,), a copy."""
        state = self._simulation.arrays
        return np.array(state.anchor_x[self._row] if self.holds else state.x[:, self._node])

    @property
    def velocity(self) -> Floats:
        """Velocity of the anchor, or of the node that it let go [m/s], (3,), a copy.

        Set it to move the anchor from now on. Raises ValueError for anything but three finite numbers,
        and when the anchor has let go.
        """
        state = self._simulation.arrays
        return np.array(state.anchor_v[self._row] if self.holds else state.v[:, self._node])

    @velocity.setter
    def velocity(self, value: ArrayLike) -> None:
        vector = np.asarray(value, dtype=np.float64)
        if vector.shape != (3,) or not np.isfinite(vector).all():
            raise ValueError(f"velocity: {value!r} - must be three finite numbers [m/s]")
        if not self.holds:
            raise ValueError("velocity: the anchor has let go of its node and moves nothing")
        self._simulation.take_in_hand(self._row)
        self._simulation.arrays.anchor_v[self._row] = vector

    @property
    def reaction(self) -> Floats:
        """Force of the anchor on the rope [N], (3,), mean over the last step, a copy."""
        return np.array(self._simulation.arrays.reaction[self._row])

    @property
    def holds(self) -> bool:
        """Whether the anchor still holds its node."""
        return bool(self._simulation.arrays.held[self._row])

    @property
    def _node(self) -> int:
        return int(self._simulation.arrays.anchor_node[self._row])

    def __repr__(self) -> str:
        name = self._simulation.layout.anchor_names[self._row]
        x, y, z = self.position
        released = "" if self.holds else "released, its node "
        return f"<Anchor {name!r} {released}at ({x:.4g}, {y:.4g}, {z:.4g}) m>"
