"""Islands of ropes that can touch each other, or turn a wheel: each moves by itself until it meets another.

Contacts keep where their ropes have been (`laws.pairs.swept`). Where such boxes of two islands overlap after
a step, all go back to its beginning, the two become one, and the step is taken again: nothing passes unseen,
and until then a rope has the bits that it has alone. A call of many steps is looked at as a whole, and cut in
halves where boxes overlap, down to single steps: where calls begin and end changes no bit. Islands that have
met stay one. Once all are one it moves in the arrays of the whole itself.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from typing import Any, NamedTuple

import numpy as np

from ropewalk.core import arrays
from ropewalk.core.arrays import APPLIED, Floats, Ints, flatten, pooled
from ropewalk.core.status import BROKEN, OK, UNSOLVED
from ropewalk.engine.burst import unburst
from ropewalk.engine.contact_rows import Rows, differ, joined_rows, rows_among, rows_of, write_rows
from ropewalk.engine.crews import Crews
from ropewalk.engine.engine import Asked, Engine, Moved, controlled, controls_of, own_state
from ropewalk.engine.exchange import Carried, Told
from ropewalk.engine.frames import Frames
from ropewalk.engine.islands import Islands, walk_of
from ropewalk.engine.join import begin_all_boxes, begin_boxes, join_own, spread_sums
from ropewalk.engine.lying import falls_beside
from ropewalk.engine.meeting_boxes import NEAR, been, joined, meeting
from ropewalk.engine.met_before import Ropes, is_as, met_before, misfit
from ropewalk.engine.own_controls import own_controls, take_controls
from ropewalk.engine.places import OwnLinks, own_links, places_in
from ropewalk.engine.shares import Share, shares_of
from ropewalk.engine.shelf import on_shelf, size_of
from ropewalk.engine.start import all_started, started
from ropewalk.engine.wheel_reach import Wheels, follow_others
from ropewalk.lowering import Model, Pieces
from ropewalk.methods.adaptive import Walk
from ropewalk.methods.recording import Recording


class Part(NamedTuple):
    """An island by the numbers of its ropes."""

    ropes: Ropes
    share: Share
    engine: Engine
    pool: Floats  # its state's numbers
    shelf: Floats  # what its steps were looked at for
    links: OwnLinks | None  # None: it lies in the arrays of the whole
    there: Ints  # (s,) its segments by their numbers in the whole, -1 between ropes


class Meetings(Islands):
    """The engines of islands that may meet, and the arrays of the whole."""

    by_frames = True

    def __init__(self, model: Model, groups: Sequence[Sequence[int]], *, ledger: bool) -> None:
        """Take up a model whose ropes are grouped into islands; one that starts at rest has started.

        Raises SceneError and NoRest as `start.all_started` does.
        """
        self._origin, self._drawn, self._ledger = model, flatten(model.state), ledger
        self.state, self._pool = own_state(model)
        self._shelf = np.zeros(size_of(self.state.peaks))
        self.state = self.state._replace(peaks=on_shelf(self.state.peaks, self._shelf))
        self.controls = controls_of(model.system)
        self.system = controlled(model.system, self.controls)
        self._seen = arrays.copy(self.controls.bodies)
        self._places = places_in(self.state, self._pool)
        self._seconds, self._beside = 0.0, None
        self._over = set[int]()  # ropes that have ended
        self._began = [tuple(group) for group in groups]
        self._touching = model.scene.contact is not None
        self._wheels = Wheels(model, self.system.node.obstacle)
        keep, lists = Pieces(), [list(group) for group in groups]
        shares = shares_of(model, lists, self._wheels.homes)
        begun = all_started((self._cut(share, keep) for share in shares), lists)
        self._take(
            [
                self._part(tuple(group), share, part)
                for group, share, part in zip(groups, shares, begun, strict=True)
            ]
        )
        self._gather()
        self.model = replace(model, state=arrays.copy(self.state), started=True)

    def _cut(self, share: Share, keep: Pieces) -> Model:
        """Return the model of some ropes as it is drawn, or as all have started."""
        part = share.cut(self._origin, self._drawn, keep)
        if part.started and self._touching:
            own = np.full(self.state.stiffness.size, -1)
            own[share.segments] = share.own_segments
            rows = rows_among(rows_of(self._origin.state.memory.contact), own)
            state = part.state
            write_rows(rows, part.system.node.contact, state.memory.contact, state.stiffness)
        return part

    def _part(self, ropes: Ropes, share: Share, model: Model) -> Part:
        """Return an island with arrays of its own."""
        own = own_controls(self.controls, share, len(model.system.bending.turn))
        model = self._wheels.watched(model, share.nodes)
        state, pool = pooled(model.state)
        shelf = np.zeros(size_of(state.peaks))
        state = state._replace(peaks=on_shelf(state.peaks, shelf))
        engine = Engine(model, own, ledger=self._ledger, room=(state, pool))
        there = np.full(state.stiffness.size, -1)
        there[share.own_segments] = share.segments
        links = own_links(self._places, share, state, pool)
        begin_boxes(engine)
        return Part(ropes, share, engine, pool, shelf, links, there)

    def _make(self, ropes: Ropes) -> Part:
        """Return an island of ropes of several; what it stands at is to come."""
        share = shares_of(self._origin, [list(ropes)], self._wheels.homes)[0]
        if len(ropes) < len(self._origin.scene.ropes):
            return self._part(ropes, share, started(self._cut(share, Pieces())))
        room = self.state, self._pool
        engine = Engine(self.model, self.controls, ledger=self._ledger, room=room)
        there = np.arange(self.state.stiffness.size)
        return Part(ropes, share, engine, self._pool, self._shelf, None, there)

    def _take(self, parts: list[Part]) -> None:
        """Go on with these islands."""
        self._parts = parts
        self.shares = [part.share for part in parts]
        self.engines = [part.engine for part in parts]
        states = [engine.state for engine in self.engines]
        self._frames, self._crews = Frames(self.shares, states, self.state), Crews(self.engines)
        self._ended = np.array([float(part.ropes[0] in self._over) for part in parts])
        self._before = self._inner(None), self._pool.copy()
        self._last: Told | None = None
        self._held = list[Floats | Ints]()
        each = [(one.pool, one.links, one.engine.state, one.there) for one in parts if one.links]
        self._numbers = Carried(*zip(*each, strict=True)) if each else None

    def _parts_of(self, groups: Sequence[Ropes]) -> list[Part]:
        """Return these islands, of which there are some; new ones stand anywhere."""
        now = {part.ropes: part for part in self._parts}
        return [now.get(ropes) or self._make(ropes) for ropes in groups]

    def _regroup(self, groups: Sequence[Ropes]) -> None:
        """Have these islands; new ones stand where those of their ropes do."""
        now = [part.ropes for part in self._parts]
        if list(groups) == now:
            return
        self._spread()  # what hands have changed
        parts = self._parts_of(groups)
        for part in parts:
            if part.ropes not in now:
                here = set(part.ropes)
                self._join(part, [one for one in self._parts if here.issuperset(one.ropes)])
        self._take(parts)

    def _join(self, part: Part, parts: list[Part]) -> None:
        """Let an island stand where some parts of it, and the whole, do."""
        state, own = part.engine.state, np.full(self.state.stiffness.size, -1)
        own[part.there[part.there >= 0]] = np.flatnonzero(part.there >= 0)
        bodies = [(one.share.bodies, one.share.nodes) for one in parts]
        self._wheels.meet(self.state, part.share.bodies, bodies)
        self._read(part)
        rows = joined_rows(
            [one.engine.state.memory.contact for one in parts],
            [np.where(one.there < 0, -1, own[one.there]) for one in parts],
        )
        table = part.engine.system.node.contact
        write_rows(rows, table, state.memory.contact, state.stiffness)
        join_own(part.engine, part.share, [(one.engine, one.share) for one in parts])
        begin_boxes(part.engine)

    # -- between the whole and its islands -------------------------------------------------

    def _gather(self) -> None:
        """Write what the islands have into the arrays of the whole."""
        carried, state = self._numbers, self.state
        if carried is None:
            return
        carried.take_up()
        self._last = told = carried.tell(state)
        self._pool.view(np.int64)[carried.there] = told.values
        for part in self._parts:
            follow_others(part.engine.state, state, part.share.nodes)
        table, memory = self.system.node.contact, state.memory.contact
        write_rows(told.rows, table, memory, state.stiffness)

    def _read(self, part: Part) -> None:
        """Take up in an island what is the whole's."""
        links = part.links
        if links is None:
            return
        values = self._pool.view(np.int64)[links.there]
        values[links.indices] -= np.where(values[links.indices] < 0, 0, links.moved)
        part.pool.view(np.int64)[links.own] = values

    def _spread(self) -> None:
        """Take up in the islands what the whole has, and what hands have changed there."""
        whole, carried, told = self.state, self._numbers, self._last
        if carried is not None:
            values = self._pool.view(np.int64).take(carried.there)
            if not carried.is_told(told, whole, values):
                carried.hand_out(values)
                spread_sums(whole, [engine.state for engine in self.engines])
                carried.take_up()
            rows, kept = rows_of(whole.memory.contact), told.rows if told else carried.rows()
            if differ(rows, kept):
                self._spread_rows(rows)
            self._take_controls()
        applied = whole.forces.applied.any()
        for engine in self.engines:
            pushed = applied and engine.state.forces.applied.any()
            engine.system.flags[APPLIED] = int(pushed)

    def _take_controls(self) -> None:
        """Take up in the islands what hands have changed of the whole's controls."""
        now = *self.controls[:3], *self.controls.bodies
        if self._held and all(map(np.array_equal, self._held, now)):
            return
        self._held = [part.copy() for part in now]
        for part in self._parts:
            take_controls(part.engine.controls, self.controls, part.share)

    def _spread_rows(self, rows: Rows) -> None:
        """Take up contacts that come from elsewhere, as of a scene that was edited."""
        for k, part in enumerate(self._parts):
            state, own = part.engine.state, np.full(self.state.stiffness.size, -1)
            own[part.there[part.there >= 0]] = np.flatnonzero(part.there >= 0)
            found = rows_among(rows, own)
            found = found if k == 0 else found._replace(books=np.zeros_like(rows.books))
            table = part.engine.system.node.contact
            write_rows(found, table, state.memory.contact, state.stiffness)

    @property
    def inner(self) -> Floats:
        """A copy of which ropes are one, which have ended, and all numbers of the islands' states, (m,).

        (0,) where all are one: the state of the whole has them.
        """
        return np.zeros(0) if self._parts[0].links is None else self._inner(None)

    def _inner(self, room: Floats | None) -> Floats:
        """Copy all these numbers, of the only island, too; into an array where one is given."""
        count = len(self._origin.scene.ropes)
        first, over = np.zeros(count), np.zeros(count)
        for part in self._parts:
            first[list(part.ropes)] = part.ropes[0]
        over[list(self._over)] = 1.0
        own = [array for part in self._parts for array in (part.pool, part.shelf)]
        return np.concatenate([first, over, *own], out=room)

    def restore(self, inner: Floats, walk: Walk) -> None:
        """Go back to islands and their numbers and walks; those of the whole are the caller's.

        Raises ValueError, with nothing changed, where they are not of this scene.
        """
        groups, over = met_before(inner, self._began)
        parts = self._parts_of(groups)
        own = [array for part in parts for array in (part.pool, part.shelf)]
        at = 2 * len(self._origin.scene.ropes)
        if inner.size not in (0, at + sum(array.size for array in own)):
            raise misfit("the numbers of its islands")
        known = is_as(walk_of([part.engine for part in parts]), walk)
        if inner.size and not known:
            raise misfit("the steps of its islands")
        self._over, self._last = over, None
        if groups != [part.ropes for part in self._parts]:
            self._take(parts)
        self._ended[:] = [float(part.ropes[0] in over) for part in parts]
        for array in own if inner.size else ():
            array[:] = inner[at : at + array.size]
            at += array.size
        if known:
            self._restore_walks(walk)
        else:
            self.begin_anew(None)

    def prepare(self, time: float) -> None:
        """Evaluate the forces at the state itself, tensions of rigid links included, where it was changed."""
        before = [part.pool.view(np.int64).copy() for part in self._parts]
        self._spread()
        moved = self.note_bodies()
        for part, old in zip(self._parts, before, strict=True):
            if moved or part.links is None or (old != part.pool.view(np.int64)).any():
                part.engine.prepare(time)
        self._gather()

    def island(self, number: int) -> Engine:
        """Return the engine of an island that has fallen, by its number there."""
        return self.engines[self._standing([number])[0]]

    def end(self, numbers: list[int]) -> bool:
        """Let some islands stay as they are from now on, where others go on; else change nothing."""
        where = self._standing(numbers)
        if not super().end(where):
            return False
        self._over |= {rope for k in where for rope in self._parts[k].ropes}
        return True

    def _standing(self, numbers: list[int]) -> list[int]:
        """Return where islands that have fallen are now; what had met by then is made one again."""
        groups = [part.ropes for part in self._parts]
        fallen = [[rope for rope in range(n.bit_length()) if n >> rope & 1] for n in numbers]
        here = {rope: k for k, ropes in enumerate(groups) for rope in ropes}
        pairs = {(here[ropes[0]], here[rope]) for ropes in fallen for rope in ropes}
        self._regroup(joined(groups, pairs))
        here = {rope: k for k, part in enumerate(self._parts) for rope in part.ropes}
        return [here[ropes[0]] for ropes in fallen]

    def call(
        self, now: Floats, frames: int, most: int, out: Recording, stop: bool, asked: Asked
    ) -> Moved:
        """Move all islands, see `Islands.call`; those that meet in a frame go on as one, in more: NEAR."""
        if len(self._parts) == 1 or frames != 1:
            return self._call_far(now, frames, most, out, stop, asked)
        began, back = now.copy(), None
        left, done = [int(now[3])], 0
        spared: bool | None = False  # whether some that had burst were; None: they came back
        try:
            while left:
                steps = left.pop()
                piece, last = now.copy(), not left
                piece[3:] = steps, began[4] or done > 0, began[5] or not last
                room, halt = (out, stop) if last else (out.part(0, 0), False)
                walk = self.walk
                moved = super().call(piece, 1, most, room, halt, asked)
                if moved.status == OK and moved.good == 0:  # asked to stop
                    if back is not None:
                        self._go_back(*back)
                    now[:] = began
                    return moved
                time = piece[0] + piece[1] * piece[2]
                touch = near = self._near() if moved.status == OK else set()
                if near and (steps == 1 or not stop):
                    near = unburst(self.engines, touch, stop, None if spared is None else time)
                meet = {pair for pair in near if not self._ended[[*pair]].any()}
                fell = moved.status == UNSOLVED or (moved.status == BROKEN and stop)
                here = self._before[0], walk, self._before[1]
                if left or touch or fell:  # what another call writes to
                    here = here[0].copy(), walk, here[2].copy()
                back = here if back is None else back
                if steps > 1 and (near or fell):
                    self._go_back(*here)
                    left += [steps - steps // 2, steps // 2]
                elif meet:
                    self._go_back(*here)
                    self._regroup(joined([part.ropes for part in self._parts], meet))
                    left.append(steps)
                elif near:
                    falls = falls_beside(self.engines, near, self._ended, time)
                    self._go_back(*here)
                    return self._told_of(Moved(UNSOLVED, 0, done, falls))
                else:
                    now[:3], done = piece[:3], done + steps
                    if moved.status != OK:
                        return self._told_of(moved)
                    spared = spared if spared is None else spared or touch != near
                    if last and stop and spared:
                        self._go_back(*back)
                        now[:], left, done, spared = began, [int(began[3])], 0, None
                        continue
                    begin_all_boxes(self.engines)
        except BaseException:
            if back is not None:
                self._go_back(*back)
            now[:] = began
            raise
        return Moved(OK, 1, done)

    def _call_far(self, now: Floats, frames: int, *more: Any) -> Moved:
        """As `call`, where no islands can meet, or to the end of many frames."""
        moved = self._told_of(super().call(now, frames, *more))
        if len(self._parts) > 1 and frames > 1:
            moved = Moved(NEAR, 0, 0) if self._near() else moved
            begin_all_boxes(self.engines)
        return moved

    def _go_back(self, inner: Floats, walk: Walk, pool: Floats) -> None:
        """Go back to where islands and whole were."""
        self.restore(inner, walk)
        self._pool[:] = pool

    def _near(self) -> set[tuple[int, int]]:
        """Return which islands have come within reach of each other in the last call, ended ones too."""
        states = [engine.state for engine in self.engines]
        pairs = self._wheels.met([part.ropes for part in self._parts], states, self._ended)
        if self._touching:
            pairs |= meeting(*been(self.engines))
        return {pair for pair in pairs if not self._ended[[*pair]].all()}

    def _told_of(self, moved: Moved) -> Moved:
        """Return how far a call has come; the numbers of its falls have a bit for each rope of the island.

        So they are known later on, where others have met, or these have not yet.
        """
        falls = tuple(
            fall._replace(island=sum(1 << rope for rope in self._parts[fall.island].ropes))
            for fall in moved.falls
        )
        return moved._replace(falls=falls)
