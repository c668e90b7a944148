"""A simulation at an instant, to go back to."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

from ropewalk.core.arrays import Floats, Ints, State, flatten
from ropewalk.engine.engine import Bodies
from ropewalk.methods.adaptive import Walk

_OF_CONTACTS = ("pair", "grip", "tally", "books")
#: Arrays that older versions have with fewer numbers: what these stand for was not kept then.
#: Or with more rows of contacts than there can be.
GROWN = ("state.past", *(f"state.memory.contact.{name}" for name in _OF_CONTACTS))
#: What depends on which ropes have met.
MET = ("inner", *(f"walk.{name}" for name in Walk._fields))


def lengthened(old: Floats, new: Floats) -> Floats:
    """Return such an array of an older version, (..., m), with zeros for what it lacks beside a new one.

    And without the rows that are too many.
    """
    old = old[: len(new)] if old.ndim > 1 else old
    more = max(new.shape[-1] - old.shape[-1], 0)
    return np.pad(old, [(0, 0)] * (old.ndim - 1) + [(0, more)])


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
    # (m,) what islands keep to themselves, and, where ropes can touch, which have met; (0,) where all is one
    inner: Floats
    layout: str = ""  # its mark, see `layout.Layout`; snapshots of older versions have none

    def fitting(self, here: Snapshot, touching: bool = False) -> Snapshot:
        """Return what a simulation that is `here` now can go to. Raises ValueError for another scene's.

        What islands keep counts for those alone that have islands; where ropes are `touching` each other
        other ones may have met.
        """
        past = lengthened(self.state.past, here.state.past)
        memory, now = self.state.memory, here.state.memory.contact
        kept = {
            name: lengthened(getattr(memory.contact, name), getattr(now, name))
            for name in _OF_CONTACTS
        }
        memory = memory._replace(contact=memory.contact._replace(**kept))
        found = self._replace(state=self.state._replace(past=past, memory=memory))
        own, there = self._counts(), here._counts()
        if own != there:
            raise ValueError(f"snapshot: {own} - must be of this simulation, {there}")
        old, new = flatten(found), flatten(here)
        if touching:
            new = {name: part for name, part in new.items() if name not in MET}
        elif here.inner.size == 0:
            del old["inner"], new["inner"]
        misfits = [name for name, part in new.items() if np.shape(old[name]) != np.shape(part)]
        if misfits or self.layout not in ("", here.layout):
            what = ", ".join(misfits) or "the nodes of its ropes, and which are held and tied"
            raise ValueError(f"snapshot: of another scene - must be of this simulation: {what}")
        return found

    def _counts(self) -> str:
        nodes, winches = self.state.x.shape[1], self.winch_drive.shape[1]
        return f"of {nodes} nodes, {self.motion_kinds.size} anchors and {winches} winches"
