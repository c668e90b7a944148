"""Whether what lies in a run folder is what was written there."""

from __future__ import annotations

from pathlib import Path
from typing import NamedTuple

from ropewalk.record import checkpoint
from ropewalk.record.errors import RunError
from ropewalk.record.folder import open_parts
from ropewalk.record.place import CHECKPOINT


class Verdict(NamedTuple):
    """What was looked at and what is damaged: one error for each file."""

    chunks: int
    faults: tuple[RunError, ...]


def verify(folder: Path) -> Verdict:
    """Read every chunk of a run, and its checkpoint, and compare them with their checksums.

    Raises RunError when the folder is so damaged that one cannot tell what should be there.
    """
    _, _, stored = open_parts(folder)
    if not stored.checked:
        raise RunError(folder, "was written before runs had checksums: it cannot be verified")
    faults: list[RunError] = []
    chunks = 0
    for path in stored.files():
        chunks += 1
        if fault := stored.fault(path):
            faults.append(fault)
    if (folder / CHECKPOINT).exists():
        try:
            checkpoint.read(folder)
        except RunError as error:
            faults.append(error)
    return Verdict(chunks, tuple(faults))
