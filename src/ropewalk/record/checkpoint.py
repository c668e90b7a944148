"""Checkpoints: all that a simulation needs to go on to the same bits, in one file.

The arrays lie there in one row, for a zip file of fifty arrays takes ten times as long to write.
"""

from __future__ import annotations

import io
import json
import os
from contextlib import suppress
from dataclasses import dataclass
from math import prod
from pathlib import Path
from typing import Any

import numpy as np

from ropewalk.core.arrays import Floats, flatten
from ropewalk.record.ends import End, from_dicts
from ropewalk.record.errors import RunError
from ropewalk.record.files import PARTIAL, reading
from ropewalk.record.place import CHECKPOINT as NAME
from ropewalk.simulation import Snapshot
from ropewalk.simulation.snapshot import GROWN, MET, lengthened

SWEPT, HULL = "state.memory.contact.swept", "state.memory.contact.hull"


@dataclass(frozen=True)
class Checkpoint:
    """A snapshot and what goes with it."""

    snapshot: Snapshot
    frames: int  # recorded up to the snapshot, the initial one included
    source_hash: str
    seconds: float  # wall time so far [s]
    ends: tuple[End, ...]  # of ropes that broke, in a run that goes on


class _MisfitError(ValueError):
    """Arrays of another size or kind than the model's."""


def save(folder: Path, checkpoint: Checkpoint) -> None:
    """Write the checkpoint in place of the one that is there. Raises OSError."""
    path = folder / NAME
    partial = path.with_name(NAME + PARTIAL)
    about: dict[str, Any] = {
        "frames": checkpoint.frames,
        "source_hash": checkpoint.source_hash,
        "seconds": checkpoint.seconds,
        "ends": json.dumps([end.as_dict() for end in checkpoint.ends]),
    }
    arrays = _in_a_row(flatten(checkpoint.snapshot))
    arrays |= {f"run.{name}": value for name, value in about.items()}
    try:
        with open(partial, "wb") as file:
            np.savez(file, allow_pickle=False, **arrays)
            file.flush()
            os.fsync(file.fileno())
        os.replace(partial, path)
    except OSError:
        with suppress(OSError):
            partial.unlink()
        raise


def load(folder: Path, like: Snapshot) -> Checkpoint:
    """Read a folder's checkpoint; `like` is any snapshot of the same model.

    Raises RunError when it is missing, damaged, or of another model.
    """
    path, found = folder / NAME, read(folder)
    # those of older versions have none
    contact = like.state.memory.contact
    known = {"layout": np.asarray(like.layout), SWEPT: contact.swept, HULL: contact.hull}
    try:
        return Checkpoint(
            _fill(like, known | _apart(found), ""),
            int(found["run.frames"]),
            str(found["run.source_hash"]),
            float(found["run.seconds"]),
            from_dicts(json.loads(str(found["run.ends"]))),
        )
    except KeyError as error:
        rule = f"is damaged, or of another version: it lacks {error.args[0]}"
        raise RunError(path, rule) from None
    except _MisfitError as error:
        raise RunError(path, f"is of another scene, or of another version: {error}") from None
    except (ValueError, TypeError) as error:
        raise RunError(path, f"is damaged: {error}") from None


def read(folder: Path) -> dict[str, Any]:
    """Read the arrays of a folder's checkpoint. Raises RunError when it is missing or damaged."""
    path = folder / NAME
    with reading(path):
        data = path.read_bytes()
    try:
        with np.load(io.BytesIO(data), allow_pickle=False) as archive:  # zip files have checksums
            return {name: archive[name] for name in archive.files}
    except Exception as error:  # a damaged header of numpy's or of zip's can raise nearly anything
        raise RunError(path, f"is damaged: {error}") from None


def _in_a_row(arrays: dict[str, Floats]) -> dict[str, Any]:
    """Return the bytes of many arrays as one array, and name, kind and shape of each as text."""
    parts = {name: np.asarray(value) for name, value in arrays.items()}
    index = [(name, part.dtype.str, part.shape) for name, part in parts.items()]
    data = np.frombuffer(b"".join(part.tobytes() for part in parts.values()), np.uint8)
    return {"data": data, "index": json.dumps(index)}


def _apart(found: dict[str, Any]) -> dict[str, Any]:
    """Undo `_in_a_row`. Raises KeyError and ValueError."""
    arrays, start = {}, 0
    for name, kind, shape in json.loads(str(found["index"])):
        part = np.frombuffer(found["data"], kind, prod(shape), start)
        arrays[name] = part.reshape(shape)
        start += part.nbytes
    return arrays


def _fill(like: Any, found: dict[str, Any], prefix: str) -> Any:
    """Return a nested named tuple like `like` with the arrays of `found`."""
    values = []
    for name, item in zip(like._fields, like, strict=True):
        key = prefix + name
        if isinstance(item, tuple):
            values.append(_fill(item, found, f"{key}."))
            continue
        array, old = found[key], np.asarray(item)
        if key in GROWN and array.ndim == old.ndim > 0:
            array = lengthened(array, old)
        met = key in MET and array.ndim == 1  # that it is of these ropes is seen later on
        if (array.shape != old.shape and not met) or array.dtype != old.dtype:
            raise _MisfitError(f"{key} does not fit the scene")
        values.append(array if isinstance(item, np.ndarray) else array.item())
    return type(like)(*values)
