"""The run folder: what it holds, how it comes to be, how it is opened.

scene.toml        the scene as it was run
provenance.json   versions, machine, method, steps, start and end
data.zarr/        the numbers; xarray opens it
beyond.npz        of a run that broke: single steps past its last good frame
checkpoint.npz    what a continuation needs
events.jsonl      what happened, one JSON object a line
status.json       running, finished, broke or interrupted; up to where
"""

from __future__ import annotations

import os
import shutil
from collections.abc import Iterator
from contextlib import contextmanager, suppress
from dataclasses import asdict
from pathlib import Path
from typing import Any

from ropewalk.build import Layout, Plan
from ropewalk.build.layout import make_layout
from ropewalk.methods.registry import METHODS
from ropewalk.record import beyond
from ropewalk.record.errors import RunError
from ropewalk.record.events import NAME as EVENTS
from ropewalk.record.events import log, read_events
from ropewalk.record.facts import INTERRUPTED, RUNNING, Facts, now
from ropewalk.record.files import read_json, reason, write, write_json, writing
from ropewalk.record.lock import NAME as LOCK
from ropewalk.record.lock import is_locked
from ropewalk.record.reader import Stored, reads
from ropewalk.record.result import Result
from ropewalk.record.store import FORMAT, READABLE, Writer
from ropewalk.scene import Scene, SceneError, dumps, load

SCENE, PROVENANCE, DATA = "scene.toml", "provenance.json", "data.zarr"
STATUS = "status.json"
PACKING_STEPS = 130  # explicit steps that take ten times as long as compressing the frame
PARTS = (SCENE, PROVENANCE, DATA, "checkpoint.npz", beyond.NAME, EVENTS, STATUS, LOCK)


def is_run(folder: Path) -> bool:
    """Tell whether a folder looks like a run folder."""
    return (folder / PROVENANCE).is_file() and (folder / DATA).is_dir()


def check_free(folder: Path, overwrite: bool) -> None:
    """Raise RunError when a run must not be written to `folder`."""
    try:
        if not folder.exists() and not folder.is_symlink():
            return
        if not folder.is_dir():
            raise RunError(folder, "is a file; a run needs a folder of its own")
        entries = list(folder.iterdir())
    except OSError as error:
        raise RunError(folder, f"cannot be written: {reason(error)}") from None
    if not entries:
        return
    if not is_run(folder):
        raise RunError(folder, "exists and is no run folder; a run never replaces other files")
    if not overwrite:
        raise RunError(
            folder,
            "holds a run already; choose another folder, or allow to overwrite (overwrite=True)",
        )
    if is_locked(folder):
        raise RunError(folder, "is being written by another process")


@contextmanager
def new_folder(folder: Path, overwrite: bool) -> Iterator[Path]:
    """Give an empty folder to fill, which then appears as `folder`, whole.

    In place of an old run only the run's own files go; others that lie there stay. Raises RunError.
    """
    check_free(folder, overwrite)
    folder = Path(os.path.abspath(folder.resolve()))
    made = folder.with_name(f".{folder.name}.{os.getpid()}.new")
    with writing(folder):
        folder.parent.mkdir(parents=True, exist_ok=True)
        made.mkdir()
    try:
        with writing(folder):
            yield made
            _put_in_place(made, folder)
    finally:
        shutil.rmtree(made, ignore_errors=True)


def _put_in_place(made: Path, folder: Path) -> None:
    try:
        os.rename(made, folder)  # where there is nothing, or an empty folder
        return
    except OSError:
        if not is_run(folder):
            raise
    old = folder.with_name(f".{folder.name}.{os.getpid()}.old")
    os.rename(folder, old)
    os.rename(made, folder)
    for entry in list(old.iterdir()):
        if entry.name not in PARTS:
            os.rename(entry, folder / entry.name)
    shutil.rmtree(old)


def begin(folder: Path, scene: Scene, layout: Layout, facts: Facts, chunk: int) -> Writer:
    """Write everything but the frames into an empty folder. Raises OSError."""
    write(folder / SCENE, dumps(scene).encode(), sync=True)
    provenance = {"format": FORMAT, **facts.provenance}
    write_json(folder / PROVENANCE, provenance, sync=True)
    writer = Writer(folder / DATA, scene, layout, chunk, is_packed(facts.plan))
    writer.create(provenance)
    return writer


def is_packed(plan: Plan) -> bool:
    """Tell whether a frame costs so much to simulate that compressing it is a small part of that."""
    return plan.steps_per_frame * METHODS[plan.method].cost >= PACKING_STEPS


def write_status(folder: Path, facts: Facts, frames: int, time: float) -> None:
    """Write how far the run is and how it stands. Raises OSError."""
    status = {
        "status": facts.status,
        "frames": frames,
        "planned_frames": facts.plan.frames + 1,
        "time": time,
        "seconds": facts.seconds,
        "diagnosis": facts.diagnosis,
        "updated": now(),
    }
    if facts.step_counts:
        status["steps"] = facts.step_counts
    write_json(folder / STATUS, status)


def write_end(folder: Path) -> None:
    """Add the time of the run's end to its provenance. Raises OSError."""
    found = read_json(folder / PROVENANCE)
    write_json(folder / PROVENANCE, {**found, "ended": now()}, sync=True)


def read_scene(folder: Path) -> Scene:
    """Read the scene of a run. Raises RunError."""
    if not folder.is_dir():
        with suppress(OSError):
            if folder.exists():
                raise RunError(folder, "is a file, not a run folder")
        raise RunError(folder, "no such run folder")
    if not (folder / PROVENANCE).exists() and not (folder / DATA).exists():
        raise RunError(folder, "is no run folder: it has no provenance.json and no data.zarr")
    if not (folder / SCENE).exists():
        raise RunError(folder / SCENE, "is missing; a run folder has it")
    try:
        return load(folder / SCENE)
    except SceneError as error:
        fault = error.faults[0]
        raise RunError(folder / SCENE, f"is damaged or was changed: {fault}") from None


def read_facts(folder: Path) -> Facts:
    """Read provenance and status of a run. Raises RunError."""
    provenance = read_json(folder / PROVENANCE)
    if (version := provenance.get("format")) not in READABLE:
        raise RunError(folder, f"has the format {version!r}; {reads()}")
    status: dict[str, Any] = {"status": RUNNING}
    if (folder / STATUS).exists():
        status = read_json(folder / STATUS)
    state = status.get("status", RUNNING)
    if state == RUNNING and not is_locked(folder):
        state = INTERRUPTED
    try:
        return Facts(
            Plan(**provenance["plan"]),
            bool(provenance["ledger"]),
            bool(provenance["keep_going"]),
            str(state),
            str(status.get("diagnosis", "")),
            float(status.get("seconds", 0.0)),
            provenance,
            read_events(folder),
            dict(status.get("steps", {})),
        )
    except (KeyError, TypeError, ValueError):
        raise RunError(folder / PROVENANCE, "is damaged: it does not describe a run") from None


def open_result(folder: Path) -> Result:
    """Open a run folder as a result. Raises RunError."""
    try:
        scene = read_scene(folder)
        facts = read_facts(folder)
        layout = make_layout(scene)
        return Result(scene, layout, Stored(folder / DATA, scene, layout), facts, folder)
    except PermissionError:
        raise RunError(folder, "cannot be read: there is no permission") from None


def save_result(result: Result, folder: Path, overwrite: bool) -> Result:
    """Write a result as a run folder and open it from there. Raises RunError."""
    if not result.has_total_tension:
        rule = (
            "is of an older format, whose tension is the elastic one only; copy its folder instead"
        )
        raise RunError(result.folder or folder, rule)
    step = max(1, min(result.frames, 4096, 4_000_000 // (48 * result.nodes)))
    facts = result.facts.but(provenance={**_about(result), "ended": now()})
    with new_folder(folder, overwrite) as made:
        writer = begin(made, result.scene, result.layout, facts, step)
        for start in range(0, result.frames, step):
            arrays = [result.read("time", start, start + step)]
            for quantity in writer.quantities:
                array = result.read(quantity.name, start, start + step)
                arrays.append(array.transpose(0, 2, 1) if quantity.swapped else array)
            writer.add_raw(arrays)
        writer.commit()
        if result.beyond is not None:
            beyond.save(made, result.beyond)
        write_status(made, facts, result.frames, float(result.time[-1]))
        for event in result.events:
            log(made, **event)
        log(made, "saved", status=facts.status)
    return open_result(folder)


def _about(result: Result) -> dict[str, Any]:
    about = {k: v for k, v in result.facts.provenance.items() if k != "format"}
    return {"plan": asdict(result.plan), "ledger": result.facts.ledger, **about}
