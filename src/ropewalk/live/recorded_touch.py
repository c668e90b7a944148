"""What ropes touch in a recorded run, frame by frame."""

from __future__ import annotations

import math
from collections.abc import Mapping
from typing import NamedTuple

import numpy as np

from ropewalk.core.arrays import Floats
from ropewalk.laws.contact_books import ENTRIES
from ropewalk.laws.wheel_rows import RECORDED
from ropewalk.live.losses import driven_work
from ropewalk.live.touch import NOTHING, Room, Touch, Wraps, room_of, taken_by, touch_of, wound_on
from ropewalk.lowering import Model
from ropewalk.record.contacts import lying, model_of, seen_at, touching
from ropewalk.record.quantities import (
    CONTACT_WORK,
    OBSTACLE_FORCE,
    PULLEYS,
    ROPE_CONTACTS,
    has_rope,
    rest_length_at_start,
)
from ropewalk.record.result import Result

FORCE = "contact_force"
NAMES = (FORCE, OBSTACLE_FORCE, ROPE_CONTACTS, CONTACT_WORK, PULLEYS, "rest_length")
# Of more nodes wraps are found anew after so long for each node [s of the run], and at the last frame: that
# takes longer than all else of a frame, 20 us a node.
_FEW, _PER_NODE = 200, 1e-3
_RUB = ENTRIES.index("friction")
#: In the provenance of a session's part: its books go on from those of the part before.
BOOKS_GO_ON = "contact_books_go_on"
#: There, too: what the session's changes have put in until the part begins [J].
GIVEN = "put_in_by_changes"
#: Event of a part: what they have put in until then [J], as of a kick, which begins no part.
PUT_IN = "put in by changes"


class Works(NamedTuple):
    """What obstacles' drives, and friction of each surface, have done on ropes [J]."""

    driven: float
    books: Floats  # (k, 5)

    @property
    def rubbed(self) -> Floats:
        """What friction of each surface has done [J], (k,)."""
        found: Floats = self.books[:, _RUB]
        return found

    def less(self, other: Works) -> Works:
        """Return what more that is than another."""
        return Works(self.driven - other.driven, self.books - other.books)


class RecordedTouch:
    """Reads it for one reader of a run, from the pieces of frames that this has read."""

    def __init__(self, result: Result, piece: int) -> None:
        self.result = result
        #: What its books have of works that do not count, see `follow`; None: what its first frame has.
        self.since: Works | None = None
        nodes = result.layout.nodes
        least = _PER_NODE * nodes if nodes > _FEW else 0.0
        self.every = min(max(1, math.floor(least / result.plan.frame_interval + 1e-9)), piece)
        self._lengths = [rope.segment_length for rope in result.scene.ropes]
        self._model: Model | None = None
        self._held: tuple[int, Wraps] = -1, Wraps()

    @property
    def room(self) -> Room:
        """What its frames hold: in runs from before they were kept apart one force of all that is touched."""
        scene, names = self.result.scene, self.result.source.names
        if FORCE not in names:
            return Room()
        apart = OBSTACLE_FORCE in names if scene.obstacles else ROPE_CONTACTS in names
        room = room_of(scene, self.result.layout, pairs=apart)
        return room._replace(forces=room.forces or not apart)

    @property
    def none(self) -> Touch:
        """What a frame holds where nothing of it is known."""
        room, nodes = self.room, self.result.layout.nodes
        unknown = np.full(room.surfaces, np.nan)
        return touch_of(room, np.zeros((nodes, 3)), None, None, 0.0, unknown)

    def of(self, data: dict[str, Floats], row: int, frame: int) -> Touch:
        """Return what is touched at a frame, that row of the piece read."""
        if FORCE not in data:
            return NOTHING
        room = self.room
        force = data.get(OBSTACLE_FORCE, data[FORCE])[row]
        pairs = data[ROPE_CONTACTS][row] if ROPE_CONTACTS in data else None
        late = 0 if frame == self.result.frames - 1 else row % self.every
        wraps = self._wraps(data, row - late, frame - late)
        time, rubbed = float(data["time"][row]), self.works_at(data, row).rubbed
        return touch_of(room, force, pairs, wraps, time, rubbed)

    def _wraps(self, data: dict[str, Floats], row: int, frame: int) -> Wraps:
        """Return the wraps at a frame, kept until another one's are asked for."""
        if self._held[0] != frame:
            self._held = frame, self._find(data, row)
        return self._held[1]

    def _find(self, data: dict[str, Floats], row: int) -> Wraps:
        scene, layout = self.result.scene, self.result.layout
        force, t = data.get(OBSTACLE_FORCE, data[FORCE])[row], float(data["time"][row])
        only, rest = wound_on(scene), data.get("rest_length")
        if not only or not force.any():
            return Wraps((), t)
        self._model = self._model or model_of(self.result)
        now = rest_length_at_start(layout, self._lengths) if rest is None else rest[row]
        there = has_rope(layout, now[None], self._lengths)[0]
        places = (data["positions"][row], data["velocities"][row], force)
        x, v, push = (np.ascontiguousarray(part.T) for part in places)
        wheels = data[PULLEYS][row] if PULLEYS in data else None
        table = self._model.system.node.obstacle
        then, span = seen_at(self._model, t)  # as `Result.contacts` has them
        contacts = touching(table, x, v, push, there, wheels, then, only, span)
        return Wraps(tuple(lying(scene, layout, contacts, data["tension"][row], only)), t)

    def works_at(self, data: Mapping[str, Floats], row: int) -> Works:
        """Return what drives and friction have done until a frame, that row of `data`; NaN where unknown."""
        if CONTACT_WORK not in data or not self.result.facts.ledger:
            return Works(
                math.nan, np.full((len(self.result.layout.surfaces), len(ENTRIES)), math.nan)
            )
        if self.since is None:
            self.since = self._noted(self._frame(0), 0)
        return self._noted(data, row).less(self.since)

    def works_until(self, frame: int) -> Works:
        """Return what drives and friction have done until a frame."""
        return self.works_at(self._frame(frame), 0)

    def taken_until_each(self) -> Floats:
        """Return what `taken_by` says of every frame [J], (frames,); NaN where that is unknown."""
        until = self.works_until(0)
        if CONTACT_WORK not in self.result.source.names:
            return np.full(self.result.frames, math.nan)
        books = self.result.read(CONTACT_WORK)
        return taken_by(until.books + books - books[0], len(self.result.scene.obstacles))

    def _noted(self, data: Mapping[str, Floats], row: int) -> Works:
        """Return what the books have of a frame."""
        books = data[CONTACT_WORK][row]
        wheels = data[PULLEYS][row] if PULLEYS in data else np.zeros((0, len(RECORDED)))
        return Works(driven_work(books[: len(self.result.scene.obstacles)], wheels), books)

    def _frame(self, frame: int) -> dict[str, Floats]:
        """Return what books and wheels there are of a frame, as one row."""
        there = [name for name in (CONTACT_WORK, PULLEYS) if name in self.result.source.names]
        return {name: self.result.source.read(name, frame, frame + 1) for name in there}

    def follow(self, before: RecordedTouch, frame: int) -> None:
        """Count works on from a frame of a part that this one goes on from.

        Its books go on from those of that part; in folders of older versions they begin anew.
        """
        first, done = self._frame(0), before.works_until(frame)
        same = self.result.layout.surfaces == before.result.layout.surfaces
        if CONTACT_WORK not in first or before.since is None or not same:
            return
        go_on = self.result.facts.provenance.get(BOOKS_GO_ON)
        self.since = before.since if go_on else self._noted(first, 0).less(done)
