"""Going on with a run that was killed or interrupted, to the same bits."""

from __future__ import annotations

import warnings
from dataclasses import replace
from pathlib import Path

from ropewalk.build import build
from ropewalk.core.cache import source_hash
from ropewalk.record import checkpoint
from ropewalk.record.errors import RunError
from ropewalk.record.events import log
from ropewalk.record.facts import AT_REST, BROKE, FINISHED
from ropewalk.record.files import writing
from ropewalk.record.folder import DATA, is_packed, read_facts, read_scene
from ropewalk.record.lock import is_locked
from ropewalk.record.reader import Stored
from ropewalk.record.result import Result
from ropewalk.record.run import COMMIT_SECONDS, Recorder, finish
from ropewalk.record.simulate import Explain, Progress, Runner, no_explanation
from ropewalk.record.store import Writer
from ropewalk.simulation import Simulation


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
    facts = read_facts(folder)
    if is_locked(folder):
        raise RunError(folder, "is being written by another process")
    if facts.status == FINISHED:
        raise RunError(folder, "is finished: there is nothing to resume")
    if facts.status == AT_REST:
        raise RunError(folder, "holds an equilibrium, not a run: there is nothing to resume")
    if facts.status == BROKE:
        raise RunError(folder, f"broke; a broken run cannot be resumed. {facts.diagnosis}".rstrip())
    _check_sources(folder, str(facts.provenance.get("source_hash")), force)
    model = replace(build(scene), plan=facts.plan)
    simulation = Simulation(model, ledger=facts.ledger)
    found = checkpoint.load(folder, simulation.state)
    _check_sources(folder, found.source_hash, force)
    simulation.restore(found.snapshot)
    writer = _take_up(folder, simulation, found.frames)
    runner = Runner(simulation, facts.keep_going, explain, resumed=True, diagnosis=found.diagnosis)
    recorder = Recorder(simulation, folder, writer, facts, runner, commit_seconds)
    recorder.earlier = found.seconds
    with writing(folder):
        log(folder, "resumed", time=simulation.time, frames=found.frames)
    return finish(recorder, progress)


def _check_sources(folder: Path, made_by: str, force: bool) -> None:
    if made_by == source_hash():
        return
    if not force:
        rule = (
            "was begun by other sources of ropewalk (or another numba), so it would not go on to the "
            "same bits; resume it with the version it was begun with, or force it"
        )
        raise RunError(folder, rule)
    warnings.warn(
        f"{folder}: begun by other sources of ropewalk; it may not go on to the same bits",
        stacklevel=3,
    )


def _take_up(folder: Path, simulation: Simulation, frames: int) -> Writer:
    """Return a writer that goes on after `frames` frames."""
    stored = Stored(folder / DATA, simulation.scene, simulation.layout)
    if stored.frames < frames:
        rule = f"is damaged: it has {stored.frames} frames, and its checkpoint stands at {frames}"
        raise RunError(folder / DATA, rule)
    scene, layout, packed = simulation.scene, simulation.layout, is_packed(simulation.plan)
    writer = Writer(folder / DATA, scene, layout, stored.chunk, packed)
    writer.go_on(stored, frames)
    return writer
