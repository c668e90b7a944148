"""Running a scene into a run folder: block by block, in constant memory, killable at any moment."""

from __future__ import annotations

import signal
import threading
import time
from collections.abc import Callable, Iterator
from concurrent.futures import Future, ThreadPoolExecutor
from contextlib import ExitStack, contextmanager, suppress
from dataclasses import dataclass, field
from functools import partial
from itertools import cycle
from pathlib import Path
from types import FrameType, TracebackType

from ropewalk.core.deferred import clock
from ropewalk.core.status import OK
from ropewalk.engine.engine import counts
from ropewalk.engine.slices import NODE_STEP
from ropewalk.lowering import Model
from ropewalk.methods.registry import METHODS
from ropewalk.record import beyond, checkpoint
from ropewalk.record.checkpoint import Checkpoint
from ropewalk.record.ends import in_words
from ropewalk.record.errors import RunError
from ropewalk.record.event_log import Event, log
from ropewalk.record.facts import BROKE, FINISHED, INTERRUPTED, RUNNING, Facts, provenance
from ropewalk.record.files import sync_all, writing
from ropewalk.record.folder import begin, write_end, write_status
from ropewalk.record.identity import source_hash
from ropewalk.record.place import BEYOND, DATA, new_folder
from ropewalk.record.result import Result
from ropewalk.record.simulate import Explain, Progress, Runner, no_explanation
from ropewalk.record.store import Room, Writer
from ropewalk.scene import Scene
from ropewalk.simulation import Simulation
from ropewalk.simulation.block import Block

CHUNK_SECONDS = 0.25  # about this long a chunk of frames is simulated [s]
COMMIT_SECONDS = 1.0  # at least this long between two commits [s]
COMMIT_SHARE = 0.05  # commits take at most about this share of the time [1]
KEPT = "; everything up to the last commit is kept, and `ropewalk resume` goes on from there"


@dataclass
class Recorder:
    """One run on its way into its folder."""

    simulation: Simulation
    folder: Path
    writer: Writer
    facts: Facts
    runner: Runner
    commit_seconds: float = COMMIT_SECONDS
    begun: float = field(default_factory=clock)
    earlier: float = 0.0  # wall time of former parts of this run [s]
    last_commit: float = field(default_factory=time.perf_counter)
    commit_cost: float = 0.0

    def record(self, progress: Progress | None) -> str:
        """Simulate and write to the end; return how it ended. Raises RunError.

        A block is written while the next one is simulated: one in flight, and no more.
        """
        plan, chunk, taken = self.facts.plan, self.writer.chunk, self.writer.frames
        state, lengths = self.simulation.arrays, self.simulation.scene.lengths_change
        rooms = cycle([Room(state, chunk, lengths) for _ in range(2)])
        with stop_requests() as stop, Background() as beside:
            self.simulation.slices.asked = lambda: bool(stop)
            while taken <= plan.frames:
                begun, room = taken % chunk, next(rooms)
                count = min(chunk - begun, plan.frames + 1 - taken)
                out = room.part(begun, begun + count)
                block = self.runner.advance(count, out)
                beside.wait()
                taken += block.frames
                if progress is not None:
                    progress(taken - 1, plan.frames, block)
                last = block.status != OK or (bool(stop) and taken <= plan.frames)
                due = self._is_due() and not last
                made = self._checkpoint(taken) if due else None
                own = room if block.recording is out else None
                beside.start(partial(self._write, block, own, self.runner.take_events(), made))
                if last:
                    return BROKE if block.status != OK else INTERRUPTED
        return BROKE if self.runner.diagnosis else FINISHED

    def _is_due(self) -> bool:
        if self.commit_seconds == 0.0:  # after every chunk
            return True
        wait = max(self.commit_seconds, self.commit_cost / COMMIT_SHARE)
        return time.perf_counter() - self.last_commit >= wait

    def _write(
        self, block: Block, room: Room | None, events: list[Event], made: Checkpoint | None
    ) -> None:
        """Write a block and what happened in it; commit it where there is a checkpoint."""
        with writing(self.folder, KEPT):
            self.writer.add(block, room)
            for event in events:
                log(self.folder, **event)
            if made is not None:
                self._commit(RUNNING, made)

    def commit(self, status: str) -> None:
        """Show readers what there is. Raises RunError."""
        with writing(self.folder, KEPT):
            self.write_down(status)

    def write_down(self, status: str) -> None:
        """Show readers what there is. Raises OSError."""
        self._commit(status, self._checkpoint(self.writer.frames))

    def _checkpoint(self, frames: int) -> Checkpoint:
        """Return what it takes to go on from here, where `frames` frames have been recorded."""
        seconds = self.earlier + clock() - self.begun
        return Checkpoint(self.simulation.state, frames, source_hash(), seconds, self.runner.ends)

    def _commit(self, status: str, made: Checkpoint) -> None:
        """Numbers first, then the checkpoint, then the new length of the store.

        So the frames that are shown are never more than those that a resumed run goes on after: it
        never has to write what readers have seen.
        """
        start = time.perf_counter()
        diagnosis = in_words(made.ends, len(self.simulation.scene.ropes))
        taken = counts(made.snapshot.walk)
        self.facts = self.facts.but(
            status=status,
            seconds=made.seconds,
            diagnosis=diagnosis,
            step_counts=taken,
            ends=made.ends,
        )
        self.writer.flush()
        past = self.runner.beyond
        if made.ends and past is not None and not (self.folder / BEYOND).exists():
            beyond.save(self.folder, past)  # a run that is resumed has it no longer
        checkpoint.save(self.folder, made)
        sync_all([self.folder])
        self.writer.show()
        now = made.snapshot
        write_status(self.folder, self.facts, made.frames, now.start + now.step * now.dt)
        self.last_commit = time.perf_counter()
        self.commit_cost = self.last_commit - start


def record_run(
    scene: Scene | Model,
    folder: Path,
    *,
    keep_going: bool = False,
    overwrite: bool = False,
    progress: Progress | None = None,
    ledger: bool = True,
    explain: Explain = no_explanation,
    commit_seconds: float = COMMIT_SECONDS,
) -> Result:
    """Run a scene into a new run folder and open it.

    Raises SceneError when the scene cannot be planned, RunError when the folder cannot be written.
    """
    simulation = Simulation(scene, ledger=ledger, apart=True)
    plan = simulation.plan
    about = provenance(plan, ledger, keep_going)
    facts = Facts(plan, ledger, keep_going, RUNNING, provenance=about)
    chunk = chunk_frames(simulation)
    with ExitStack() as held:
        with new_folder(folder, overwrite, held) as made:
            writer = begin(made, simulation.scene, simulation.layout, facts, chunk)
            runner = Runner(simulation, keep_going, explain)
            recorder = Recorder(simulation, made, writer, facts, runner, commit_seconds)
            writer.add(simulation.recording())
            recorder.write_down(RUNNING)
            log(made, "started", planned_frames=plan.frames + 1)
        recorder.folder, writer.folder = folder, folder / DATA
        return finish(recorder, progress)


def finish(recorder: Recorder, progress: Progress | None) -> Result:
    """Record to the end and close the folder, whose lock is held. Raises RunError."""
    folder = recorder.folder
    recorder.simulation.advance_frames(0)  # compiles outside the clock
    recorder.begun, recorder.last_commit = clock(), time.perf_counter()
    try:
        status = recorder.record(progress)
        if recorder.runner.beyond is not None:
            with writing(folder):
                beyond.save(folder, recorder.runner.beyond)
        recorder.commit(status)
    except RunError as error:
        with suppress(OSError):
            log(folder, "failed", reason=error.rule)
        raise
    with writing(folder):
        write_end(folder)
        log(folder, **recorder.runner.ending(status, recorder.writer.frames))
    return Result.open(folder)


def chunk_frames(simulation: Simulation) -> int:
    """Return the frames of one chunk: some megabytes, and about a quarter of a second of work."""
    plan, nodes = simulation.plan, simulation.layout.nodes
    cost = max(1.0, METHODS[plan.method].cost)
    by_time = CHUNK_SECONDS / (NODE_STEP * cost * plan.steps_per_frame * nodes)
    return max(1, min(simulation.block_frames, int(by_time), plan.frames + 1))


@contextmanager
def stop_requests() -> Iterator[list[int]]:
    """Collect Ctrl-C instead of raising it, so that frames are kept; the second one raises."""
    requests: list[int] = []

    def note(number: int, _: FrameType | None) -> None:
        if requests:
            raise KeyboardInterrupt
        requests.append(number)

    if threading.current_thread() is not threading.main_thread():
        yield requests
        return
    before = signal.signal(signal.SIGINT, note)
    try:
        yield requests
    finally:
        signal.signal(signal.SIGINT, before)


class Background:
    """Runs tasks in a thread, one after another; what a task raises comes out of the next `wait`.

    Use as a context manager: at its end the task in flight, if any, is waited for.
    """

    def __init__(self) -> None:
        self._pool = ThreadPoolExecutor(1, "ropewalk-writer")
        self._running: Future[None] | None = None

    def start(self, task: Callable[[], None]) -> None:
        """Start a task when the one before is done. Raises what that one raised."""
        self.wait()
        self._running = self._pool.submit(task)

    def wait(self) -> None:
        """Wait until nothing is in flight. Raises what the task raised."""
        running, self._running = self._running, None
        if running is not None:
            running.result()

    def __enter__(self) -> Background:
        return self

    def __exit__(
        self,
        kind: type[BaseException] | None,
        error: BaseException | None,
        trace: TracebackType | None,
    ) -> None:
        self._pool.shutdown()
        if kind is None:
            self.wait()
