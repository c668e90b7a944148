"""How a sweep lies in its store: arrays, chunks, files, and the texts and numbers in them."""

from __future__ import annotations

import struct
from collections.abc import Iterator
from typing import Any

import numpy as np
from numpy.typing import NDArray

from ropewalk.record.zarr_format import ArraySpec, encode, encode_texts
from ropewalk.sweeps.parameters import FLOAT, INT
from ropewalk.sweeps.sweep_plan import SweepPlan

RUN, DONE, STATUS, REASON, BROKE_AT = "run", "done", "status", "reason", "broke_at"
NOTES = "notes"
#: The array of the marks, in a group that plain xarray leaves aside; until format 2 it was `done` itself.
_MARKS = f"{DONE}/marks"
#: Files that a batch has only where one of its runs broke.
OF_BROKEN = (BROKE_AT, REASON)
ABOUT_STATUS = {"long_name": "how the run ended"}
ABOUT_NOTES = {"long_name": "what the run's table warns of, by kinds"}


def array_specs(plan: SweepPlan) -> Iterator[ArraySpec]:
    """All arrays of the store. Values have larger chunks than results: they are written at once."""
    runs, size, piece = (plan.runs,), (plan.batch,), (plan.piece,)
    kinds = {FLOAT: "float64", INT: "int64"}
    about: dict[str, Any] = {"long_name": "number of the run"}
    yield ArraySpec(RUN, ("run",), runs, piece, "int64", about)
    for parameter in plan.parameters:
        about = {"path": parameter["path"], "long_name": parameter["long_name"]}
        about |= {"units": parameter["unit"]} if parameter["unit"] else {}
        kind = kinds.get(parameter["kind"], "string")
        yield ArraySpec(parameter["name"], ("run",), runs, piece, kind, about)
    for label in plan.labels:
        kind = kinds.get(label["kind"], "string")
        yield ArraySpec(label["name"], ("run",), runs, piece, kind, label["attributes"])
    for dim, found in plan.coordinates.items():
        count = (len(found["values"]),)
        kind = "string" if isinstance(found["values"][0], str) else "float64"
        yield ArraySpec(dim, (dim,), count, count, kind, found["attributes"])
    yield ArraySpec(STATUS, ("run",), runs, size, "string", ABOUT_STATUS)
    if plan.has_notes:
        yield ArraySpec(NOTES, ("run",), runs, size, "string", ABOUT_NOTES)
    yield ArraySpec(REASON, ("run",), runs, size, "string", {"long_name": "why it broke"})
    about = {"long_name": "time of the last good frame of a broken run", "units": "s"}
    yield ArraySpec(BROKE_AT, ("run",), runs, size, "float64", about)
    for variable in plan.variables:
        dims, shape = ("run", *variable.dims), (plan.runs, *variable.sizes)
        chunk = (plan.batch, *(max(1, size) for size in variable.sizes))
        yield ArraySpec(variable.name, dims, shape, chunk, "float64", variable.attributes)


def marks_spec(plan: SweepPlan) -> ArraySpec:
    """Return the array of the marks. It is in a group of its own: its dimension is not one of the runs."""
    about = {
        "long_name": "1 + checksum (CRC-32C) of the sweep's id and a batch's files, + 2^32 where no run of "
        "it broke; 0: not done"
    }
    return ArraySpec(
        DONE if plan.format < 3 else _MARKS, ("batch",), (plan.batches,), (1,), "int64", about
    )


def encoded(spec: ArraySpec, values: Any) -> bytes:
    """Return a chunk as its file holds it; the last one is filled up."""
    missing = spec.chunk[0] - len(values)
    if spec.kind == "string":
        texts = [str(value) for value in values] + [""] * missing
        return encode_texts(texts)
    array = np.asarray(values, dtype=spec.kind)
    fill = 0 if spec.kind == "int64" else np.nan
    pad = [(0, missing)] + [(0, 0)] * (array.ndim - 1)
    return encode(np.pad(array, pad, constant_values=fill))


def decoded_texts(data: bytes) -> list[str]:
    """Return the texts that the codec vlen-utf8 holds. Raises ValueError when they are damaged."""
    try:
        (count,) = struct.unpack_from("<I", data)
        texts, place = [], 4
        for _ in range(count):
            (size,) = struct.unpack_from("<I", data, place)
            texts.append(data[place + 4 : place + 4 + size].decode())
            place += 4 + size
    except (struct.error, UnicodeDecodeError) as error:
        raise ValueError(str(error)) from None
    return texts


def nothing_broke(columns: dict[str, Any]) -> bool:
    """Tell whether the columns of a batch say nothing of broken runs."""
    broke_at: NDArray[np.float64] = np.asarray(columns[BROKE_AT])
    return not any(columns[REASON]) and bool(np.isnan(broke_at).all())
