"""Whether what lies in a run folder is what was written there."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from pathlib import Path
from typing import NamedTuple

from ropewalk.record import beyond, checkpoint
from ropewalk.record.errors import RunError
from ropewalk.record.facts import INTERRUPTED, RUNNING
from ropewalk.record.files import reading
from ropewalk.record.folder import open_parts
from ropewalk.record.place import BEYOND, CHECKPOINT, EVENTS
from ropewalk.record.reader import Stored
from ropewalk.record.seal import log_fault


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
