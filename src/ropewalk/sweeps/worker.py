"""What a worker does with a batch, in this process or another one: plain data in, plain data out."""

from __future__ import annotations

import json
import threading
from functools import lru_cache
from pathlib import Path
from typing import Any

import numpy as np

from ropewalk.engine.islands import one_after_another
from ropewalk.record.errors import RunError
from ropewalk.sweeps.batch import GOOD, Batch, Batcher, Recipe
from ropewalk.sweeps.identity import sweep_hash
from ropewalk.sweeps.sweep_folder import SweepFolder
from ropewalk.sweeps.sweep_plan import SweepPlan

#: What a worker says of a batch.
STORED, CARRIED, REFUSED = "stored", "carried", "refused"


def batcher_of(recipe: str) -> Batcher:
    """Return what makes the runs of a recipe, given as JSON; kept for this thread's next batch."""
    return _batcher_of(recipe, threading.get_ident())


@lru_cache(maxsize=64)
def _batcher_of(recipe: str, thread: int) -> Batcher:
    return Batcher(Recipe.of(json.loads(recipe)))


@lru_cache(maxsize=8)
def _folder_of(folder: str, name: str) -> SweepFolder | None:
    """Return the sweep's folder if this machine sees it."""
    try:
        found = SweepFolder.open(Path(folder))
    except (RunError, OSError):
        return None
    return found if found.plan.id == name else None


def make_batch(job: dict[str, Any], number: int, columns: list[Any]) -> dict[str, Any]:
    """Make a batch and store it, or carry it to the client where the store is out of reach.

    A batch that is stored already is not made again. Whatever goes wrong is told in words: an error of a
    class that the client cannot read would make it wait for ever.
    """
    try:
        return _made(job, number, columns)
    except Exception as error:
        why = str(error) if isinstance(error, RunError) else f"{type(error).__name__}: {error}"
        return {"number": number, "what": REFUSED, "why": why}


def _made(job: dict[str, Any], number: int, columns: list[Any]) -> dict[str, Any]:
    if job["source"] != sweep_hash():
        text = (
            "it has other sources of ropewalk, or another numpy or numba, and would not make the same bits; "
            "install there what is installed here, and start it anew"
        )
        return {"number": number, "what": REFUSED, "why": text, "who": _address()}
    store = _folder_of(job["folder"], job["id"]) if job["folder"] else None
    if store is not None and store.is_done(number):
        return {"number": number, "what": STORED, "broken": None}
    with one_after_another():  # a worker for every processor is there already
        batch = batcher_of(job["recipe"]).make(unpacked_rows(columns))
    if store is None:
        return {"number": number, "what": CARRIED, "broken": batch.broken, "batch": packed(batch)}
    if SweepFolder.open(store.folder).plan.id != job["id"]:
        text = "its folder holds another sweep by now"
        return {"number": number, "what": REFUSED, "why": text}
    store.write(number, batch)
    return {"number": number, "what": STORED, "broken": batch.broken}


def _address() -> str:
    """Return where this worker is found, "" of what is none."""
    from distributed import get_worker

    try:
        return str(get_worker().address)
    except ValueError:  # a thread that is no worker's
        return ""


def warm_up(recipe: str, columns: list[Any]) -> str:
    """Have the kernels of some runs compiled; return what went wrong, if anything."""
    wrong = ""
    for row in unpacked_rows(columns):
        try:
            batcher_of(recipe).compile(row)
        except Exception as error:
            wrong = f"{type(error).__name__}: {error}"
    return wrong


def job_of(plan: SweepPlan, folder: Path | None) -> dict[str, Any]:
    """Return what a worker needs besides the values; plain data."""
    return {
        "recipe": json.dumps(plan.recipe.plain()),
        "source": plan.recipe.source,
        "folder": str(folder.resolve()) if folder is not None else "",
        "id": plan.id,
    }


def packed_rows(rows: list[list[Any]]) -> list[Any]:
    """Return the values of runs as columns: bytes of numbers, lists of texts."""
    return [_packed(list(column)) for column in zip(*rows, strict=True)]


def _packed(column: list[Any]) -> Any:
    for code, kind in (("<f8", float), ("<i8", int)):
        if all(type(value) is kind for value in column):
            return {"kind": code, "data": np.array(column, dtype=code).tobytes()}
    return column


def unpacked_rows(columns: list[Any]) -> list[list[Any]]:
    """Return the rows that `packed_rows` gave."""
    lists = [
        np.frombuffer(column["data"], dtype=column["kind"]).tolist()
        if isinstance(column, dict)
        else column
        for column in columns
    ]
    return [list(row) for row in zip(*lists, strict=True)]


def packed(batch: Batch) -> dict[str, Any]:
    """Return a batch as lists, texts and bytes."""
    return {
        "status": batch.status,
        "reason": batch.reason,
        "notes": batch.notes,
        "broke_at": np.asarray(batch.broke_at).tobytes(),
        "kept": {name: (array.shape, array.tobytes()) for name, array in batch.kept.items()},
    }


def unpacked(plain: dict[str, Any]) -> Batch:
    """Return the batch that `packed` gave."""
    kept = {
        name: np.frombuffer(data, dtype=np.float64).reshape(shape)
        for name, (shape, data) in plain["kept"].items()
    }
    broke_at = np.frombuffer(plain["broke_at"], dtype=np.float64).tolist()
    return Batch(list(plain["status"]), list(plain["reason"]), broke_at, kept, list(plain["notes"]))


def count_broken(status: list[str]) -> int:
    """Count the runs that did not end well."""
    return sum(one not in GOOD for one in status)
