"""Islands: what is coupled is solved together, all else alone.

Ropes that nothing ties to each other have no business in one set of equations: the halving of a step, the
search along a line or the tolerance that one of them asks for would change the others. So every island of a
scene has arrays of its own, those of a scene with nothing else in it, and moves by itself. Between two calls
of the kernels all of it lies in the arrays of the whole scene, which everybody else sees and changes.

A method that solves equations, or chooses its steps, has an island for every rope. The others treat every
node by itself: ropes may share an island there, but for those with kinks or releases, which cut steps, and
with winches. An island that broke can be ended: it stays as it is, and the others go on.
"""

from __future__ import annotations

import os
from collections.abc import Callable, Iterator, Sequence
from concurrent.futures import ThreadPoolExecutor
from contextlib import contextmanager
from dataclasses import replace
from itertools import chain
from threading import local

import numpy as np

from ropewalk.core import arrays
from ropewalk.core.arrays import APPLIED, Floats, flatten, pooled
from ropewalk.core.deferred import clock, each, wait_too
from ropewalk.core.status import BROKEN, OK, PAUSED
from ropewalk.engine.abreast import go_abreast
from ropewalk.engine.crews import Crew, Crews, batches, go_alone, go_once
from ropewalk.engine.engine import (
    Asked,
    Controls,
    Engine,
    Moved,
    controlled,
    controls_of,
    never,
    own_state,
)
from ropewalk.engine.frames import Frames, hold_frames
from ropewalk.engine.gate import Gate
from ropewalk.engine.places import find_links, pool_size
from ropewalk.engine.shares import gather_peaks, shares_of
from ropewalk.engine.shelf import on_shelf, size_of
from ropewalk.engine.slices import Slices
from ropewalk.engine.start import all_started, started
from ropewalk.lowering import Model, Pieces
from ropewalk.methods.adaptive import Walk
from ropewalk.methods.recording import Recording
from ropewalk.methods.registry import METHODS

#: So many threads move islands side by side, where none is told to work alone (`one_after_another`).
threads = len(os.sched_getaffinity(0)) if hasattr(os, "sched_getaffinity") else os.cpu_count() or 1
ROUND = (
    2.0  # [s] about so long are all islands moved in one call; one that is stopped early is lost
)
LONG = 2e-3  # [s] a call that takes longer is worth threads
FEW = (
    8  # frames that are collected all at once: for each array that takes as long as copying so many
)


_here = local()  # what is so in one thread only


@contextmanager
def one_after_another() -> Iterator[None]:
    """Have this thread move islands by itself: others have work for every processor."""
    before = getattr(_here, "alone", False)
    _here.alone = True
    try:
        yield
    finally:
        _here.alone = before


def walk_of(engines: Sequence[Engine]) -> Walk:
    """Return the walks of engines, one after another."""
    return Walk(*map(np.concatenate, zip(*(one.walk for one in engines), strict=True)))


class Islands:
    """The engines of a scene's islands, and the arrays of the whole."""

    by_frames = False

    def __init__(self, model: Model, groups: list[list[int]], *, ledger: bool) -> None:
        """Take up a model whose ropes are grouped into islands, by their numbers.

        Raises SceneError and NoRest as `start.all_started` does.
        """
        if model.scene.run.ring is not None:
            model = started(model)  # its modes are those of the whole scene
        self.shares = shares_of(model, groups)
        whole = flatten(model.state)
        keep = Pieces()
        parts = all_started((share.cut(model, whole, keep) for share in self.shares), groups)
        self.state, self._pool = own_state(model)
        self.controls = controls_of(model.system)
        self.system = controlled(model.system, self.controls)
        self._make_controls(parts)
        sizes = [pool_size(part.state) for part in parts]
        self._sea = np.zeros(sum(sizes))
        self._shelf = np.zeros(sum(size_of(part.state.peaks) for part in parts))
        self.engines, self._rooms, first, seen = [], list[slice](), 0, 0
        for part, controls, size in zip(parts, self._own_controls, sizes, strict=True):
            room = self._sea[first : first + size]
            state, _ = pooled(part.state, room)
            state = state._replace(peaks=on_shelf(state.peaks, self._shelf[seen:]))
            seen += size_of(state.peaks)
            # the model keeps the start: breaks are explained from there
            self.engines.append(Engine(part, controls, ledger=ledger, room=(state, room)))
            self._rooms.append(slice(first, first + size))
            first += size
        states = [engine.state for engine in self.engines]
        self._links = find_links((self.state, self._pool), self.shares, states, self._sea)
        self._carried = np.zeros(self._links.there.size, np.int64)
        self._frames = Frames(self.shares, states, self.state)
        self._gather()
        self.model = replace(model, state=arrays.copy(self.state), started=True)
        self._crews = Crews(self.engines)
        self._ended = np.zeros(len(self.engines))  # 1: it stays as it is
        self._before = self.inner, self._pool.copy()  # as the last call began
        self._seconds, self._ledger = 0.0, ledger
        self._beside: ThreadPoolExecutor | None = None

    def _make_controls(self, parts: list[Model]) -> None:
        """Give every island its controls, parts of arrays that are filled at once."""
        rows = np.concatenate([share.anchors for share in self.shares])
        wound = np.concatenate([share.winches for share in self.shares])
        clamped = [
            share.anchors[: len(part.system.bending.turn)]
            for share, part in zip(self.shares, parts, strict=True)
        ]
        self._rows = rows, wound, np.concatenate(clamped)
        kinds, drive, turns, bodies = self.controls
        self._seen = arrays.copy(bodies)
        self._own = Controls(kinds[rows], drive[:, wound], turns[:, self._rows[2]], bodies)
        self._own_controls, a, w, c = [], 0, 0, 0
        for share, held in zip(self.shares, clamped, strict=True):
            to = a + len(share.anchors), w + len(share.winches), c + len(held)
            own = (
                self._own.kinds[a : to[0]],
                self._own.drive[:, w : to[1]],
                self._own.turns[:, c : to[2]],
                bodies,
            )
            self._own_controls.append(Controls(*own))
            a, w, c = to

    # -- between the whole and its islands -------------------------------------------------

    def _gather(self) -> None:
        """Write what the islands have into the arrays of the whole."""
        links, whole, sea = self._links, self._pool.view(np.int64), self._sea.view(np.int64)
        values = sea.take(links.own, out=self._carried, mode="clip")
        values[links.indices] += np.where(values[links.indices] < 0, 0, links.moved)
        whole[links.there] = values
        work = flatten(self.state)
        for name, places in links.sums.items():
            work[name][...] = self._sea[places].sum(axis=0)
        self.state.past[0] = self._sea[links.past].max()
        self.state.now[:] = self._sea[links.now].max(axis=0)  # one that has ended stays behind

    def _spread(self) -> None:
        """Take up in the islands what the whole has, and what hands have changed there."""
        links, whole, sea = self._links, self._pool.view(np.int64), self._sea.view(np.int64)
        values = whole.take(links.there, out=self._carried, mode="clip")
        values[links.indices] -= np.where(values[links.indices] < 0, 0, links.moved)
        sea[links.own] = values
        work = flatten(self.state)
        for name, places in links.sums.items():
            self._sea[places[0]] += work[name] - self._sea[places].sum(axis=0)
        if self.state.past[0] == 0.0:  # a multistep method is to begin anew
            self._sea[links.past] = 0.0
        if not np.array_equal(self.state.now, self._sea[links.now].max(axis=0)):
            self._sea[links.now] = (
                self.state.now
            )  # it comes from elsewhere, as of a scene that was edited
        rows, wound, clamped = self._rows
        self._own.kinds[:] = self.controls.kinds[rows]
        self._own.drive[:] = self.controls.drive[:, wound]
        self._own.turns[:] = self.controls.turns[:, clamped]
        applied = self.state.forces.applied.any()
        for engine in self.engines:
            pushed = applied and engine.state.forces.applied.any()
            engine.system.flags[APPLIED] = int(pushed)

    # -- as an engine ----------------------------------------------------------------------

    def make_slices(self) -> Slices:
        """Return how to cut long calls: at frames, where steps vary."""
        method = METHODS[self.model.plan.method]
        return Slices(self.model.layout.nodes, method.cost, span=ROUND)

    @property
    def walk(self) -> Walk:
        """The walks of all islands, one after another."""
        return walk_of(self.engines)

    @property
    def inner(self) -> Floats:
        """A copy of all numbers of the islands' states, and which have ended, (m,)."""
        return self._inner(None)

    def _inner(self, room: Floats | None) -> Floats:
        """Copy these numbers, into an array where one is given."""
        return np.concatenate([self._sea, self._shelf, self._ended], out=room)

    def restore(self, inner: Floats, walk: Walk) -> None:
        """Go back to the numbers of the islands and their walks; those of the whole are the caller's."""
        ends = np.cumsum([self._sea.size, self._shelf.size])
        self._sea[:], self._shelf[:], self._ended[:] = np.split(inner, ends)
        self._restore_walks(walk)

    def _restore_walks(self, walk: Walk) -> None:
        """Go back to the walks of the islands, which lie one after another."""
        first = [0] * len(walk)
        for engine in self.engines:
            for k, (to, numbers) in enumerate(zip(engine.walk, walk, strict=True)):
                to[:] = numbers[first[k] : first[k] + to.size]
                first[k] += to.size

    def count_errors(self, time: float) -> None:
        """Count errors of the energies, and extremes, from the present state of a `time` [s] on."""
        self._spread()
        for engine in self.engines:
            engine.count_errors(time)
        self.show_peaks()

    def show_peaks(self) -> None:
        """Write what the islands have seen into the state of the whole."""
        gather_peaks(self.shares, [engine.state for engine in self.engines], self.state)

    def begin(self) -> None:
        """Evaluate forces and reactions at time zero, take a first look, and note the energies."""
        for engine in self.engines:
            engine.begin()
        self._gather()

    def prepare(self, time: float) -> None:
        """Evaluate the forces at the state itself, tensions of rigid links included, where it was changed."""
        before = self._sea.view(np.int64).copy()
        self._spread()
        changed = before != self._sea.view(np.int64)
        moved = self.note_bodies()
        for engine, room in zip(self.engines, self._rooms, strict=True):
            if moved or changed[room].any():
                engine.prepare(time)
        self._gather()

    def note_bodies(self) -> bool:
        """Note how obstacles move; tell whether it is new: ropes of every island may lie on them."""
        pairs = zip(self._seen, self.controls.bodies, strict=True)
        moved = [not np.array_equal(seen, now) for seen, now in pairs]
        for seen, now in zip(self._seen, self.controls.bodies, strict=True):
            seen[...] = now
        return any(moved)

    def begin_anew(self, row: int | None) -> None:
        """Let the adaptive method walk on from the state that is shown, in the island of anchor `row`.

        None: in all of them.
        """
        for share, engine in zip(self.shares, self.engines, strict=True):
            if row is None or row in share.anchors:
                engine.begin_anew(row)

    def island(self, number: int) -> Engine:
        """Return the engine of an island."""
        return self.engines[number]

    def end(self, numbers: list[int]) -> bool:
        """Let some islands stay as they are from now on, where others go on; else change nothing."""
        ended = self._ended.copy()
        ended[numbers] = 1.0
        if ended.all():
            return False
        self._ended[:] = ended
        return True

    def call(
        self, now: Floats, frames: int, most: int, out: Recording, stop: bool, asked: Asked
    ) -> Moved:
        """Move all islands by `frames` frames, see `Engine.call`; `taken` are steps, or frames.

        All stand at the same time again: at the end of the first frame that is broken, or of the last one
        before a step without solution; where `asked` says so in between, and when anything is raised, where
        they stood.
        """
        inner, walk, pool = self._inner(self._before[0]), self.walk, self._before[1]
        pool[:] = self._pool
        try:
            self._spread()
            done = self._move(now, frames, out, stop, asked)
            first = min(done, key=lambda moved: moved.good)
            if any(moved.status == PAUSED for moved in done):
                self.restore(inner, walk)
                return Moved(OK, 0, 0)
            together = frames if first.status == OK else first.good + (first.status == BROKEN)
            if together < frames:
                self.restore(inner, walk)
                self._spread()
                self._move(now, together, out, False, never)
            self._gather()
            now[2] += now[3] * together
        except BaseException:
            self.restore(inner, walk)
            self._pool[:] = pool
            raise
        falls = tuple(
            moved.falls[0]._replace(island=k)
            for k, moved in enumerate(done)
            if moved.falls and moved.good == first.good
        )
        return Moved(first.status, first.good, int(now[3]) * together, falls)

    def _move(
        self, now: Floats, frames: int, out: Recording, stop: bool, asked: Asked
    ) -> list[Moved]:
        """Move every island from the same time and collect what they record."""
        begun, rows = clock(), min(frames, len(out.x))
        lengths = out.rest_length.shape[1] > 0
        outs = self._frames.nothing
        if rows:
            outs = self._frames.make(rows, lengths)
            for k in np.flatnonzero(self._ended):
                hold_frames(self.engines[k], outs[k], self._ledger)

        mates = self._crews.mates
        crews = self._crews.now(self._ended)
        alone = threads == 1 or getattr(_here, "alone", False)
        beside = not alone and self._seconds * frames > LONG
        lines = rows > FEW

        def go(crew: Crew) -> list[Moved]:
            first = crew.numbers[0]
            if self._ended[first]:
                return [Moved(OK, frames, 0)]
            slices = self._crews.slices(crew)
            if frames == 1 and not crew.abreast and slices.holds(int(now[3])):
                return go_once(mates[first], slices, now.copy(), outs[first], stop)
            those, rooms = zip(*((mates[k], outs[k]) for k in crew.numbers), strict=True)
            way = go_abreast if crew.abreast else go_alone
            return way(those, slices, now.copy(), frames, rooms, stop, asked)

        def run(some: list[Crew]) -> tuple[list[list[Moved]], float]:
            moved, waited = list[list[Moved]](), 0.0
            for batch in batches(some):
                found, seconds = each(go, batch)
                moved, waited = moved + found, waited + seconds
                if lines:  # while they are at hand
                    numbers = [k for crew in batch for k in crew.numbers]
                    self._frames.collect_lines(out, rows, numbers)
            return moved, waited

        parts = self._go_beside(run, crews) if beside else run(crews)[0]
        found = dict(zip((k for crew in crews for k in crew.numbers), chain(*parts), strict=True))
        done = [found[k] for k in range(len(self.engines))]
        if frames:
            self._seconds = (clock() - begun) / frames
        good = min(rows, min(moved.good for moved in done)) if stop else rows
        if not rows:
            return done
        self._frames.collect(out, good, not lines)
        return done

    def _go_beside(
        self, run: Callable[[list[Crew]], tuple[list[list[Moved]], float]], crews: list[Crew]
    ) -> list[list[Moved]]:
        """Let threads move the islands, each a run of neighbours; wait for all, whatever is raised."""
        if self._beside is None:
            self._beside = ThreadPoolExecutor(threads, thread_name_prefix="islands")
        parts = np.array_split(np.arange(len(crews)), min(4 * threads, len(crews)))

        gate = Gate()
        try:  # from the first one on, they move the islands
            jobs = [self._beside.submit(gate.run, run, [crews[k] for k in part]) for part in parts]
            found = [one for one in (job.result() for job in jobs) if one is not None]
        finally:
            gate.close()
        moved, seconds = zip(*found, strict=True)
        wait_too(max(seconds))
        return list(chain(*moved))
