"""Going on with a run that was killed or interrupted, to the same bits."""

from __future__ import annotations

from contextlib import ExitStack
from dataclasses import replace
from pathlib import Path

from ropewalk.lowering import build
from ropewalk.record import checkpoint
from ropewalk.record.errors import RunError
from ropewalk.record.event_log import log
from ropewalk.record.facts import AT_REST, BROKE, FINISHED, Facts
from ropewalk.record.files import writing
from ropewalk.record.folder import check_scene, is_packed, read_facts, read_scene
from ropewalk.record.identity import check_same
from ropewalk.record.lock import locked
from ropewalk.record.place import CHECKPOINT, DATA, session_folder
from ropewalk.record.reader import Stored
from ropewalk.record.result import Result
from ropewalk.record.run import COMMIT_SECONDS, Recorder, finish
from ropewalk.record.simulate import Explain, Progress, Runner, no_explanation
from ropewalk.record.store import FORMAT, Writer
from ropewalk.scene import Scene
from ropewalk.simulation import Simulation
from ropewalk.words.shell import typed


def resume_run(
    folder: Path,
    *,
    force: bool = False,
    progress: Progress | None = None,
    explain: Explain = no_explanation,
    commit_seconds: float = COMMIT_SECONDS,
) -> Result:
    """Continue a run where its last checkpoint stands.

    With `force` also one that other sources of ropewalk began, with a warning: it may not go on to the
    same bits. Raises RunError when there is nothing to continue, or it cannot be.
    """
    scene = read_scene(folder)
    with ExitStack() as held:
        with writing(folder):
            held.enter_context(locked(folder))
        return _go_on(folder, scene, force, progress, explain, commit_seconds)


def _go_on(
    folder: Path,
    scene: Scene,
    force: bool,
    progress: Progress | None,
    explain: Explain,
    commit_seconds: float,
) -> Result:
    """Continue a run whose lock is held. Raises RunError."""
    facts = read_facts(folder)
    _check_open(folder, facts)
    check_same(folder, facts.provenance, force)
    check_scene(folder, scene, facts)
    model = replace(build(scene), plan=facts.plan)
    simulation = Simulation(model, ledger=facts.ledger, apart=True)
    found = checkpoint.load(folder, simulation.state)
    check_same(folder, {**facts.provenance, "source_hash": found.source_hash}, force)
    try:
        simulation.restore(found.snapshot)
    except ValueError as error:
        rule = f"is of another scene, or of another version, and cannot be gone on with: {error}"
        raise RunError(folder / CHECKPOINT, rule) from None
    with writing(folder):
        writer = _take_up(folder, simulation, found.frames)
        log(folder, "resumed", time=simulation.time, frames=found.frames)
    runner = Runner(
        simulation, facts.keep_going, explain, resumed=True, ends=found.ends, frames=found.frames
    )
    recorder = Recorder(simulation, folder, writer, facts, runner, commit_seconds)
    recorder.earlier = found.seconds
    return finish(recorder, progress)


def _check_open(folder: Path, facts: Facts) -> None:
    """Raise RunError when there is nothing to go on with."""
    if facts.provenance.get("format") != FORMAT:
        raise RunError(folder, "is of an older format, which can be read but not gone on with")
    if facts.provenance.get("live"):
        whole = session_folder(folder)
        rule = f"is of a live session, which goes on with: ropewalk view {typed(whole)} --continue"
        raise RunError(folder, rule)
    if facts.status == FINISHED:
        raise RunError(folder, "is finished: there is nothing to resume")
    if facts.status == AT_REST:
        raise RunError(folder, "holds an equilibrium, not a run: there is nothing to resume")
    if facts.status == BROKE:
        raise RunError(folder, f"broke; a broken run cannot be resumed. {facts.diagnosis}".rstrip())
    if not (folder / CHECKPOINT).exists():
        rule = "has no checkpoint, as a saved result has none: resume the folder it was run in"
        raise RunError(folder, rule)


def _take_up(folder: Path, simulation: Simulation, frames: int) -> Writer:
    """Return a writer that goes on after `frames` frames, all of which are sound.

    Raises RunError, OSError.
    """
    stored = Stored(folder / DATA, simulation.scene, simulation.layout)
    stored.go_to(frames)
    scene, layout, packed = simulation.scene, simulation.layout, is_packed(simulation.plan)
    writer = Writer(folder / DATA, scene, layout, stored.chunk, packed, simulation.ledger)
    writer.go_on(stored, frames)
    return writer
