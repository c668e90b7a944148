"""Anchors as live objects: read where they are, move and turn them by hand."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import ArrayLike

from ropewalk.core.arrays import Floats
from ropewalk.hands.drive import shortest_turn
from ropewalk.scene.faults import NO_DIRECTION
from ropewalk.words.annotations import unquoted

if TYPE_CHECKING:
    from ropewalk.simulation import Simulation


def three(name: str, value: ArrayLike, unit: str) -> Floats:
    """Return three finite numbers as an array. Raises ValueError for anything else."""
    try:
        vector = np.array(value, dtype=np.float64)
    except (TypeError, ValueError):
        vector = np.zeros(0)
    if vector.shape != (3,) or not np.isfinite(vector).all():
        raise ValueError(f"{name}: {value!r} - must be three finite numbers [{unit}]")
    return vector


@unquoted
class AnchorHandle:
    """One anchor of a running simulation; once it has let go it follows the node that it held."""

    __slots__ = ("_row", "_simulation")  # so that a slip of a name is refused

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
        vector = three("velocity", value, "m/s")
        self._check_holds("velocity")
        self._simulation.forget_position(self._row)
        self._simulation.take_in_hand(self._row)
        self._simulation.arrays.anchor_v[self._row] = vector

    def move_to(self, position: ArrayLike) -> None:
        """Let the anchor be at a `position` [m], (3,), at the end of the next step, exactly.

        Its velocity follows, constant over that step (`Simulation.step` of any duration, or the next
        block of `frames`). There it rests, until it is told again. A ground that stops it may keep it
        from getting there.

        Raises ValueError for anything but three finite numbers, and when the anchor has let go.
        """
        vector = three("position", position, "m")
        self._check_holds("move_to")
        self._simulation.set_goal(self._row, position=vector)

    @property
    def direction(self) -> Floats:
        """Direction in which the anchor's clamp holds the rope, unit vector [1], (3,), a copy.

        From the rope's start towards its end.

        Raises ValueError for an anchor without a clamp, and when it has let go.
        """
        self._check_clamped("direction")
        return np.array(self._simulation.arrays.clamp_direction[self._row])

    def turn_to(self, direction: ArrayLike) -> None:
        """Let the clamp point in a `direction` [1], (3,), at the end of the next step, exactly.

        The direction may have any length. The clamp turns there by the shortest way, at a constant
        rate, and rests.

        Raises ValueError for anything but three finite numbers that are not all zero, for the direction
        opposite to the present one, for an anchor without a clamp, and when it has let go.
        """
        vector = three("direction", direction, "1")
        self._check_clamped("turn_to")
        size = float(np.linalg.norm(vector))
        if size == 0.0:
            raise ValueError(f"direction: {direction!r} - {NO_DIRECTION}")
        shortest_turn(self.direction, vector / size)
        self._simulation.set_goal(self._row, direction=vector / size)

    @property
    def angular_velocity(self) -> Floats:
        """Angular velocity of the anchor's clamp [rad/s], (3,), a copy.

        Set it to turn the clamp from now on.

        Raises ValueError for anything but three finite numbers, for an anchor without a clamp, and when it
        has let go.
        """
        self._check_clamped("angular_velocity")
        return self._simulation.clamp_spin(self._row)

    @angular_velocity.setter
    def angular_velocity(self, value: ArrayLike) -> None:
        vector = three("angular_velocity", value, "rad/s")
        self._check_clamped("angular_velocity")
        self._simulation.turn_clamp(self._row, vector)

    @property
    def reaction(self) -> Floats:
        """Force of the anchor on the rope [N], (3,), a copy.

        Mean over the last of the equal steps that a call of `step` takes, not over the call.
        """
        return np.array(self._simulation.arrays.reaction[self._row])

    @property
    def moment(self) -> Floats:
        """Moment of the anchor's clamp on the rope [N m], (3,), a copy; 0 without a clamp."""
        parts = self._simulation.arrays.moment  # elastic, then friction's
        row = self._row
        return parts[row, :3] + parts[row, 3:] if len(parts) else np.zeros(3)

    @property
    def holds(self) -> bool:
        """Whether the anchor still holds its node."""
        return bool(self._simulation.arrays.held[self._row])

    def _check_holds(self, name: str) -> None:
        if not self.holds:
            raise ValueError(f"{name}: the anchor has let go of its node and moves nothing")

    def _check_clamped(self, name: str) -> None:
        bending = self._simulation.system.bending
        if not (len(bending.clamped) and bending.clamped[self._row]):
            rule = "this anchor holds no direction; give it a clamp: Anchor(clamp=Clamp(direction=...))"
            raise ValueError(f"{name}: {rule}")
        self._check_holds(name)

    @property
    def _node(self) -> int:
        return int(self._simulation.arrays.anchor_node[self._row])

    def __repr__(self) -> str:
        name = self._simulation.layout.anchor_names[self._row]
        x, y, z = self.position
        released = "" if self.holds else "released, its node "
        return f"<Anchor {name!r} {released}at ({x:.4g}, {y:.4g}, {z:.4g}) m>"
