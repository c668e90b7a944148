"""A simulation at an instant, to go back to."""

from __future__ import annotations

from typing import NamedTuple

from ropewalk.core.arrays import Floats, Ints, State
from ropewalk.engine.engine import Bodies
from ropewalk.methods.adaptive import Walk


class Snapshot(NamedTuple):
    """All that a simulation needs to go on to the same bits."""

    state: State
    start: float  # [s] time at step 0 of the present step length
    dt: float  # [s]
    step: int
    motion_kinds: Ints  # (a,) which anchors have been taken in hand
    winch_drive: Floats  # (3, w) speed [m/s], start and stop [s] of the winches
    walk: Walk  # of the adaptive method
    clamp_turns: Floats  # (3, a, 3) direction, axis and turn of the clamps, see `arrays.Bending`
    bodies: Bodies  # how obstacles move, as hands have it
    inner: Floats  # (m,) what islands keep to themselves; (0,) where all is one

    def must_fit(self, state: State, motion_kinds: Ints, winch_drive: Floats) -> None:
        """Raise ValueError where it has not as many nodes, anchors and winches as a simulation."""
        own = (self.state.x.shape[1], self.motion_kinds.size, self.winch_drive.shape[1])
        here = (state.x.shape[1], motion_kinds.size, winch_drive.shape[1])
        if own != here:
            shown = "of {} nodes, {} anchors and {} winches"
            rule = f"must be of this simulation, {shown.format(*here)}"
            raise ValueError(f"snapshot: {shown.format(*own)} - {rule}")
