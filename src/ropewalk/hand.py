"""Anchors as live objects: read where they are, move them by hand."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import ArrayLike

from ropewalk.core.arrays import Floats

if TYPE_CHECKING:
    from ropewalk.simulation import Simulation


class AnchorHandle:
    """One anchor of a running simulation."""

    def __init__(self, simulation: Simulation, row: int) -> None:
        self._simulation = simulation
        self._row = row

    @property
    def position(self) -> Floats:
        """Where the anchor is [m], (3,), a copy."""
        return np.array(self._simulation.arrays.anchor_x[self._row])

    @property
    def velocity(self) -> Floats:
        """The anchor's velocity [m/s], (3,), a copy; set it to move the anchor from now on."""
        return np.array(self._simulation.arrays.anchor_v[self._row])

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

    def __repr__(self) -> str:
        name = self._simulation.layout.anchor_names[self._row]
        x, y, z = self.position
        return f"<Anchor {name!r} at ({x:.4g}, {y:.4g}, {z:.4g}) m>"
