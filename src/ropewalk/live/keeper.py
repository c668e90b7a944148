"""Keeping a live session as a run folder: frames as they come, and every command with its step.

The folder is a run like any other: scene, numbers, provenance, events. A part of its own, in the
folder `part-2` and so on, begins where the arrays, the time or the constants are not those of before: after
a cut, a pin, another number of segments, a reset, a slider. The log of the whole session is `events.jsonl`
of the first part; replayed from its scene it gives the same bits (`relive`).
"""

from __future__ import annotations

import math
import queue
import threading
import time
from collections.abc import Callable
from concurrent.futures import Future
from contextlib import ExitStack, suppress
from dataclasses import asdict, dataclass, replace
from pathlib import Path
from typing import Any

from ropewalk.hands.drum import PARTED
from ropewalk.live.bodies import Spot, Way, spots, ways_of, with_ways
from ropewalk.live.commands import Command
from ropewalk.live.frozen import Frozen, scene_now
from ropewalk.live.gaps import Parted
from ropewalk.live.recorded_touch import BOOKS_GO_ON, GIVEN, PUT_IN
from ropewalk.live.session import Session
from ropewalk.lowering import Layout, Plan
from ropewalk.record.errors import RunError
from ropewalk.record.event_log import log
from ropewalk.record.facts import FINISHED, RUNNING, Facts, now, provenance
from ropewalk.record.files import writing
from ropewalk.record.folder import begin, change_provenance, change_scene, write_status
from ropewalk.record.lock import locked
from ropewalk.record.place import DATA, new_folder
from ropewalk.record.store import Writer
from ropewalk.scene import Scene
from ropewalk.simulation.block import Block

COMMIT_SECONDS = 1.0
BYTES_PER_SECOND = (
    1_000_000  # of simulated time at most; larger scenes are recorded at fewer frames
)
CHUNK_FRAMES = 120
_BYTES_OF_A_NODE = 112  # and its segment, in a frame of all quantities: 72 and 40
MOST_PARTS = 1000
MOST_BY_CONSTANTS = 500  # parts beyond which changed constants alone begin none
SETTLED = 0.5  # [s] simulated from one part to the next, where constants change on and on
QUIET = 0.1  # [s] simulated without a further change, after which they begin a part at once
_JUMPS = frozenset(["reset", "scene", "back", "undo", "remedy"])
_LAST = 600.0  # [s] for what is left to be written at the end, of a machine that is very slow


@dataclass
class Part:
    """One stretch of a session, with arrays of one shape, on its way into a folder."""

    folder: Path
    writer: Writer
    facts: Facts
    scene: Scene
    ways: dict[str, Way]  # of bodies that hands move
    moved: bool = False  # there is more of them than in the file
    frames: int = 0
    last_time: float = 0.0


class Keeper:
    """Writes a session into a folder, in a thread of its own, while it plays."""

    def __init__(self, session: Session, folder: Path, *, go_on: bool = False) -> None:
        """Begin the folder, or `go_on` in that of an earlier part of the same session.

        Raises RunError when it cannot be written.
        """
        self.session, self.folder = session, folder
        self.failure: str | None = None
        self._parts = 0
        self._part: Part | None = None
        self._jobs: queue.SimpleQueue[Callable[[], None] | None] = queue.SimpleQueue()
        self._last_commit = time.monotonic()
        self._begun = time.monotonic()
        self._every = 1
        self._count = 0
        self._layout: Layout | None = None
        self._scene = self._seen = session.main.scene  # when the part began, at the last command
        self._due = False  # more than constants has changed since the part began
        self._latest, self._since = self._scene, -math.inf  # as it is now, and since when [s]
        self._changed = -math.inf  # [s] when constants alone last began a part
        self._taken: dict[str, tuple[bool, bool]] = {}  # bodies that hands have moved, turned
        self._parted: tuple[Parted, ...] = ()  # what was told of
        self._edited = 0.0  # [J] put in by changes until what was told last
        self._held = ExitStack()
        if go_on:
            self._held.enter_context(locked(folder))
            self._parts = len(parts(folder))
            self._begin_part(scene_now(session))
            log(folder, "continued", step=session.count)
        else:
            self._begin_part(session.start[0])
            log(folder, "session", preset=session.preset, live=1)
        session.on_command = self._on_command
        session.on_break = self._on_break
        session.on_frame = self._on_frame
        self._thread = threading.Thread(target=self._run, name="ropewalk-keeper", daemon=True)
        self._thread.start()

    # -- called in the broadcast's thread --------------------------------------------------

    def _on_command(self, count: int, client: int, command: Command) -> None:
        about = command.model_dump(mode="json", exclude={"id"})
        self._put(lambda: self._log("command", step=count, client=client, command=about))
        simulation, scene = self.session.main.simulation, self.session.main.scene
        self._due |= command.type != "set" and scene is not self._seen
        self._seen = scene
        taken = {name: one.taken for name, one in spots(simulation).items()}
        if command.type in _JUMPS or simulation.layout != self._layout or taken != self._taken:
            self._new_part(Frozen.of(self.session, fresh=command.type in ("reset", "scene")))

    def _on_break(self, count: int, variant: int) -> None:
        self._put(lambda: self._log("broken", step=count, variant=variant))

    def _on_frame(self, session: Session) -> None:
        simulation = session.main.simulation
        parted = session.main.parted
        new = tuple(one for one in parted if one not in self._parted)
        self._parted = parted
        for one, *_ in new:
            self._tell(PARTED, **one._asdict())
        torn = simulation.layout != self._layout  # what has parted is two ropes now
        if torn or self._has_other_constants():
            self._new_part(Frozen.of(session))
            return
        if session.main.edited != self._edited:  # by a kick, which begins no part
            self._edited = session.main.edited
            self._tell(PUT_IN, time=simulation.time, energy=self._edited)
        self._count += 1
        if self._count % self._every == 0:
            block, here = session.main.frame(), spots(simulation)
            self._put(lambda: self._add(block, here))

    def _has_other_constants(self) -> bool:
        """Tell whether constants, loads, joints are not the part's: a slider makes few parts only."""
        now, scene = self.session.time, self.session.main.scene
        if scene is not self._latest:
            self._latest, self._since = scene, now
        if scene is self._scene:
            return False
        quiet = abs(now - self._since) > QUIET - 1e-9
        if not (self._due or quiet) and abs(now - self._changed) < SETTLED:
            return False
        self._changed = now
        return self._parts < (MOST_PARTS if self._due else MOST_BY_CONSTANTS)

    def _new_part(self, frozen: Frozen) -> None:
        if self._parts >= MOST_PARTS or self.failure:
            return
        layout, plan = self.session.main.simulation.layout, self.session.main.simulation.plan
        block, here = self.session.main.frame(), spots(self.session.main.simulation)
        about = _about(plan, self.session.main.edited)
        self._begins(layout)
        self._taken = {name: one.taken for name, one in here.items()}
        self._put(lambda: self._next_part(frozen.thaw(), layout, about, block, here))

    def _tell(self, event: str, **more: Any) -> None:
        """Log what has happened in the part in which it did."""

        def job() -> None:
            if self._part is not None:
                log(self._part.folder, event, **more)

        self._put(job)

    def _begins(self, layout: Layout) -> None:
        self._edited = self.session.main.edited
        self._layout, self._due = layout, False
        self._scene = self._seen = self.session.main.scene
        frame = max(_BYTES_OF_A_NODE * layout.nodes, 1)
        rate = self.session.loaded.run.frame_rate
        self._every = max(1, round(frame * rate / BYTES_PER_SECOND))

    # -- called in the keeper's thread -----------------------------------------------------

    def _begin_part(self, scene: Scene) -> None:
        simulation = self.session.main.simulation
        self._begins(simulation.layout)
        here = spots(simulation)
        self._taken = {name: one.taken for name, one in here.items()}
        self._parted = self.session.main.parted
        frame = self.session.main.frame()
        about = _about(simulation.plan, self.session.main.edited)
        self._next_part(scene, simulation.layout, about, frame, here)

    def _next_part(
        self, scene: Scene, layout: Layout, facts: Facts, block: Block, here: dict[str, Spot]
    ) -> None:
        self._end_part()
        self._parts += 1
        folder = self.folder if self._parts == 1 else self.folder / f"part-{self._parts}"
        held, ways = self._held if self._parts == 1 else None, ways_of(here)
        with new_folder(folder, overwrite=False, held=held) as made:
            writer = begin(made, with_ways(scene, ways), layout, facts, CHUNK_FRAMES)
            writer.add(block)
            writer.commit()
            write_status(made, facts, 1, float(block.time[-1]))
            log(made, "started", live=1)
        writer.folder = folder / DATA
        self._part = Part(folder, writer, facts, scene, ways, False, 1, float(block.time[-1]))

    def _add(self, block: Block, here: dict[str, Spot]) -> None:
        part = self._part
        if part is None:
            return
        part.writer.add(block)
        for name, spot in here.items():
            part.moved |= part.ways[name].add(spot)
        part.frames += 1
        part.last_time = float(block.time[-1])
        if time.monotonic() - self._last_commit >= COMMIT_SECONDS:
            self._commit()

    def _commit(self) -> None:
        part = self._part
        if part is not None:
            part.writer.commit()
            if part.moved:
                change_scene(part.folder, with_ways(part.scene, part.ways))
                part.moved = False
            seconds = time.monotonic() - self._begun
            write_status(part.folder, part.facts.but(seconds=seconds), part.frames, part.last_time)
        self._last_commit = time.monotonic()

    def _end_part(self) -> None:
        part = self._part
        if part is None:
            return
        plan = replace(part.facts.plan, frames=max(part.frames - 1, 1))
        part.facts = part.facts.but(status=FINISHED, plan=plan)
        self._commit()
        change_provenance(part.folder, plan=asdict(plan), ended=now())
        self._part = None

    def _log(self, event: str, **more: Any) -> None:
        log(self.folder, event, **more)

    def _put(self, job: Callable[[], None]) -> None:
        if self.failure is None:
            self._jobs.put(job)

    def _run(self) -> None:
        while True:
            job = self._jobs.get()
            if job is None:
                return
            if self.failure is not None:
                continue
            try:
                with writing(self.folder):
                    job()
            except RunError as error:  # the session goes on; what was committed is kept
                self.failure = str(error)

    # -- called from anywhere ----------------------------------------------------------------

    def flush(self) -> Path:
        """Have everything up to now on disk; return the folder. Raises RunError."""
        done: Future[None] = Future()

        def job() -> None:
            try:
                self._commit()
            finally:
                done.set_result(None)

        self._put(job)
        if self.failure is None:
            with suppress(TimeoutError):
                done.result(30.0)
        if self.failure is not None:
            raise RunError(self.folder, self.failure)
        return self.folder

    def close(self) -> None:
        """End the folder: everything is on disk, or `failure` says why not."""
        count, when = self.session.count, self.session.time
        if self.session.main.scene is not self._scene:  # a slider's last value
            self._new_part(Frozen.of(self.session))

        def job() -> None:
            self._end_part()
            self._log("ended", step=count, time=when)

        self._put(job)
        self._jobs.put(None)
        self._thread.join(_LAST)
        if self._thread.is_alive():
            self.failure = (
                f"{self.folder}: not all could be written in {_LAST:.0f} s; its end is missing"
            )
        self._held.close()


def parts(folder: Path) -> list[Path]:
    """Return a run folder and the further parts of a live session in it."""
    found, number = [folder], 2
    while (folder / f"part-{number}").is_dir():
        found.append(folder / f"part-{number}")
        number += 1
    return found


def _about(plan: Plan, given: float) -> Facts:
    """Return what is known of a part that begins; `given`: what changes have put in until then [J]."""
    about = {**provenance(plan, True, False), "live": True, BOOKS_GO_ON: True, GIVEN: given}
    return Facts(plan, True, False, RUNNING, provenance=about)
