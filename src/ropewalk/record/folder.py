"""The run folder: what it holds, how it comes to be, how it is opened and compared with its checksums.

scene.toml        the scene as it was run
provenance.json   versions, machine, method, steps, start and end
data.zarr/        the numbers; xarray opens it
beyond.npz        of a run that broke: single steps past its last good frame
checkpoint.npz    what a continuation needs
events.jsonl      what happened, one JSON object a line
status.json       running, finished, broke or interrupted; up to where
"""

from __future__ import annotations

import hashlib
from collections.abc import Callable, Iterator
from contextlib import suppress
from dataclasses import asdict
from pathlib import Path
from typing import TYPE_CHECKING, Any, NamedTuple

from ropewalk.lowering import Layout, Plan
from ropewalk.lowering.layout import make_layout
from ropewalk.methods.registry import METHODS
from ropewalk.record import beyond, checkpoint
from ropewalk.record.ends import from_dicts
from ropewalk.record.errors import RunError
from ropewalk.record.event_log import fault_of, log, read_events, until
from ropewalk.record.facts import INTERRUPTED, RUNNING, Facts, now
from ropewalk.record.files import read_json, reading, write
from ropewalk.record.lock import is_locked
from ropewalk.record.place import (
    BEYOND,
    CHECKPOINT,
    DATA,
    EVENTS,
    PROVENANCE,
    SCENE,
    STATUS,
    new_folder,
)
from ropewalk.record.quantities import recorded
from ropewalk.record.reader import Stored, reads
from ropewalk.record.seal import log_fault, read_sealed, write_sealed
from ropewalk.record.store import CHECKED, FORMAT, READABLE, SEALED, Writer
from ropewalk.scene import Scene, SceneError, dumps, load
from ropewalk.scene.from_library import origin

if TYPE_CHECKING:
    from ropewalk.record.result import Result

PACKING_STEPS = 130  # explicit steps that take ten times as long as compressing the frame


def begin(folder: Path, scene: Scene, layout: Layout, facts: Facts, chunk: int) -> Writer:
    """Write everything but the frames into an empty folder. Raises OSError."""
    text = dumps(scene).encode()
    write(folder / SCENE, text, sync=True)
    provenance = {**facts.provenance, "format": FORMAT, "scene_hash": _hash(text)}
    if ropes := {rope.name: about for rope in scene.ropes if (about := origin(rope.made_of))}:
        provenance["ropes_of_the_library"] = ropes
    write_sealed(folder / PROVENANCE, provenance, sync=True)
    writer = Writer(folder / DATA, scene, layout, chunk, is_packed(facts.plan), facts.ledger)
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
    if facts.ends:
        status["ends"] = [end.as_dict() for end in facts.ends]
    if facts.step_counts:
        status["steps"] = facts.step_counts
    write_sealed(folder / STATUS, status)


def write_end(folder: Path) -> None:
    """Add the time of the run's end to its provenance. Raises OSError."""
    change_provenance(folder, ended=now())


def change_provenance(folder: Path, **more: Any) -> None:
    """Replace parts of a run's provenance. Raises RunError, OSError."""
    write_sealed(folder / PROVENANCE, {**read_provenance(folder), **more}, sync=True)


def change_scene(folder: Path, scene: Scene) -> None:
    """Write another scene for a run whose obstacles were moved meanwhile. Raises RunError, OSError."""
    text = dumps(scene).encode()
    write(folder / SCENE, text, sync=True)
    change_provenance(folder, scene_hash=_hash(text))


def read_provenance(folder: Path) -> dict[str, Any]:
    """Read the provenance of a run. Raises RunError."""
    if (version := read_json(folder / PROVENANCE).get("format")) not in READABLE:
        raise RunError(folder, f"has the format {version!r}; {reads()}")
    return read_sealed(folder / PROVENANCE, lambda found: found.get("format") == SEALED)


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
    provenance = read_provenance(folder)
    status: dict[str, Any] = {"status": RUNNING}
    if (folder / STATUS).exists():
        status = read_sealed(folder / STATUS, lambda _: provenance["format"] >= SEALED)
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
            from_dicts(status.get("ends", ())),
            fault_of(folder) if provenance["format"] >= SEALED else "",
        )
    except (KeyError, TypeError, ValueError):
        raise RunError(folder / PROVENANCE, "is damaged: it does not describe a run") from None


def check_scene(folder: Path, scene: Scene, facts: Facts) -> None:
    """Raise RunError unless `scene`, read from a run folder, is the one that was run."""
    said = facts.provenance.get("scene_hash")
    if said is None and facts.provenance.get("format", 0) < CHECKED:
        return
    with reading(folder / SCENE):
        if said == _hash((folder / SCENE).read_bytes()):
            return
    if said != _hash(dumps(scene).encode()):  # more than comments or layout
        raise RunError(
            folder / SCENE, "is damaged or was changed: it is not the scene that was run"
        )


def _hash(text: bytes) -> str:
    return hashlib.sha256(text).hexdigest()[:16]


def open_parts(folder: Path) -> tuple[Scene, Facts, Stored]:
    """Open the scene, the facts and the store of a run folder. Raises RunError.

    Of a run that has not ended events are told up to its last frame, as all else is.
    """
    try:
        scene = read_scene(folder)
        facts = read_facts(folder)
        started = facts.provenance.get("started")
        stored = Stored(folder / DATA, scene, make_layout(scene), started)
        check_scene(folder, scene, facts)
        if facts.status in (RUNNING, INTERRUPTED):
            last = float(stored.read("time", stored.frames - 1)[0])
            facts = facts.but(events=until(facts.events, last, facts.plan.method))
    except PermissionError:
        raise RunError(folder, "cannot be read: there is no permission") from None
    return scene, facts, stored


class Verdict(NamedTuple):
    """What was looked at and what is damaged: one error for each file."""

    chunks: int
    faults: tuple[RunError, ...]
    sealed: bool  # all but the chunks and checkpoint.npz has checksums too


def verify(folder: Path) -> Verdict:
    """Read all of a run, and compare it with its checksums: chunks, metadata, checkpoint, log.

    Scene, provenance and status are compared whenever a run is opened. In folders of formats 3 and 4 only
    chunks, checkpoint and scene can be verified. Raises RunError when the folder is so damaged that one
    cannot tell what should be there.
    """
    _, facts, stored = open_parts(folder)
    if not stored.checked:
        raise RunError(folder, "was written before runs had checksums: it cannot be verified")
    paths = list(stored.files())
    faults = [fault for path in paths if (fault := stored.fault(path))]
    for part, read in ((CHECKPOINT, checkpoint.read), (BEYOND, beyond.load)):
        if (folder / part).exists():
            faults += _raised(read, folder)
    if stored.sealed:
        faults += _of_texts(folder, stored, ended=facts.status not in (RUNNING, INTERRUPTED))
    return Verdict(len(paths), tuple(faults), stored.sealed)


def _of_texts(folder: Path, stored: Stored, *, ended: bool) -> Iterator[RunError]:
    if fault := stored.root_fault():
        yield fault
    else:
        yield from stored.header_faults(ended=ended)
    path = folder / EVENTS
    if path.exists():
        with reading(path):
            wrong = log_fault(path.read_bytes())
        if wrong:
            yield RunError(path, wrong)


def _raised(read: Callable[[Path], object], folder: Path) -> Iterator[RunError]:
    try:
        read(folder)
    except RunError as error:
        yield error


def save_result(result: Result, folder: Path, overwrite: bool) -> None:
    """Write a result as a run folder. Raises RunError."""
    if not result.has_total_tension:
        rule = (
            "is of an older format, whose tension is the elastic one only; copy its folder instead"
        )
        raise RunError(result.folder or folder, rule)
    scene = result.scene
    if not result.has_extremes:
        scene = scene.replace(run=scene.run.replace(extremes=False))  # it has none to save
    names = [quantity.name for quantity in recorded(result.layout, scene)]
    if absent := [name for name in names if name not in result.source.names]:
        rule = f"is of an older format, without {', '.join(absent)}; copy its folder instead"
        raise RunError(result.folder or folder, rule)
    step = max(1, min(result.frames, 4096, 4_000_000 // (48 * result.nodes)))
    ended = {} if result.folder else {"ended": now()}  # a run that was opened ended long ago
    facts = result.facts.but(provenance={**ended, **_about(result)})
    with new_folder(folder, overwrite) as made:
        writer = begin(made, scene, result.layout, facts, step)
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


def _about(result: Result) -> dict[str, Any]:
    about = {k: v for k, v in result.facts.provenance.items() if k != "format"}
    return {"plan": asdict(result.plan), "ledger": result.facts.ledger, **about}
