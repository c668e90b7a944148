"""A sweep on disk: a folder with the scene, what was asked, and a Zarr store with one chunk per batch.

A batch's data are written first, each file whole or not at all, then its mark in `done`: a checksum over
those files and the sweep's id. A mark that is there and right says that the batch is there, whole and right.
"""

from __future__ import annotations

import json
import os
import shutil
import struct
import uuid
from collections.abc import Iterable, Iterator
from contextlib import suppress
from pathlib import Path
from typing import Any

import google_crc32c
import numpy as np

from ropewalk.record.errors import RunError
from ropewalk.record.files import read_json, reading, writing
from ropewalk.record.zarr_format import (
    ArraySpec,
    decode,
    encode,
    encode_texts,
    group_metadata,
    opened,
)
from ropewalk.scene import Scene, loads, save
from ropewalk.sweeps.batch import Batch
from ropewalk.sweeps.parameters import FLOAT, INT
from ropewalk.sweeps.plan import FORMAT, SweepPlan

FACTS, SCENE, DATA, PARTIAL, DONE = "sweep.json", "scene.toml", "data.zarr", ".partial", "done"


def is_sweep(folder: Path) -> bool:
    """Tell whether a folder holds a sweep."""
    return (folder / FACTS).is_file()


class SweepFolder:
    """The folder of a sweep: what it is, and where its batches are written and read."""

    def __init__(self, folder: Path, plan: SweepPlan) -> None:
        self.folder, self.plan = folder, plan
        self.specs = {spec.name: spec for spec in _specs(plan)}
        # So that a late worker of a sweep that was overwritten cannot mark a batch of this one.
        self._seed = int(google_crc32c.value(plan.id.encode()))

    @classmethod
    def open(cls, folder: Path) -> SweepFolder:
        """Open a sweep's folder. Raises RunError when it is none, or damaged."""
        if not is_sweep(folder):
            what = "holds no sweep" if folder.is_dir() else "no such sweep"
            raise RunError(folder, what)
        facts = read_json(folder / FACTS)
        if facts.get("format") != FORMAT:
            rule = f"is of format {facts.get('format')}; this version of ropewalk reads {FORMAT}"
            raise RunError(folder / FACTS, rule)
        try:
            return cls(folder, SweepPlan.of(facts))
        except (KeyError, TypeError, ValueError) as error:
            raise RunError(folder / FACTS, f"is damaged: {error!r}") from None

    @classmethod
    def create(
        cls, folder: Path, plan: SweepPlan, scene: Scene, values: Iterable[list[Any]]
    ) -> SweepFolder:
        """Write a new sweep with the values of all its runs and no results.

        It is there as soon as its facts are, which are written last. Raises RunError.
        """
        made = cls(folder, plan)
        with writing(folder):
            (folder / FACTS).unlink(missing_ok=True)  # of one that is overwritten; the first to go
            shutil.rmtree(folder / DATA, ignore_errors=True)
            (folder / PARTIAL).mkdir(parents=True, exist_ok=True)
            made.tidy()
            for spec in made.specs.values():
                (folder / DATA / spec.name).mkdir(parents=True, exist_ok=True)
            arrays = {spec.name: spec.metadata() for spec in made.specs.values()}
            for name, array in arrays.items():
                made._write(f"{name}/zarr.json", json.dumps(array).encode())
            attributes = made._attributes()
            made._write("zarr.json", json.dumps(group_metadata(attributes, arrays)).encode())
            made._write_values(values)
            save(scene, folder / SCENE)
            facts = json.dumps(plan.plain(), indent=1, ensure_ascii=False)
            made._write(f"../{FACTS}", facts.encode())
        return made

    @property
    def scene(self) -> Scene:
        """The scene that is varied."""
        return loads(self.plan.recipe.scene, str(self.folder / SCENE))

    def _attributes(self) -> dict[str, Any]:
        plan = self.plan
        seed = {} if plan.seed is None else {"seed": plan.seed}
        names = [parameter["name"] for parameter in plan.parameters]
        return {
            "title": plan.title,
            "source": f"ropewalk {plan.provenance.get('ropewalk', '')}".rstrip(),
            "design": plan.design,
            **seed,
            "grid": json.dumps(list(plan.shape)),
            "coordinates": " ".join(names),
        }

    def _write_values(self, values: Iterable[list[Any]]) -> None:
        """Write the values of all runs, cut at the chunks."""
        names = [parameter["name"] for parameter in self.plan.parameters]
        number = 0
        waiting: list[Any] = [[] for _ in names]
        size = self.plan.batch
        for piece in values:
            waiting = [
                np.concatenate([w, p]) if len(w) else p for w, p in zip(waiting, piece, strict=True)
            ]
            while len(waiting[0]) >= size:
                self._write_chunks(
                    number, dict(zip(names, (w[:size] for w in waiting), strict=True))
                )
                waiting = [w[size:] for w in waiting]
                number += 1
        if len(waiting[0]):
            self._write_chunks(number, dict(zip(names, waiting, strict=True)))
        for dim, about in self.plan.coordinates.items():
            self._write_chunks(0, {dim: about["values"]})
        for batch in range(self.plan.batches):
            self._write_chunks(batch, {"run": np.array(self.plan.rows(batch))})

    # -- batches ---------------------------------------------------------------------------

    def write(self, number: int, batch: Batch) -> None:
        """Write a batch, then its mark. Raises RunError when the disk refuses."""
        with writing(self.folder, "; what was marked before is kept"):
            check = self._write_chunks(number, batch.arrays())
            self._write_chunks(number, {DONE: np.array([check + 1])})

    def _write_chunks(self, number: int, columns: dict[str, Any]) -> int:
        """Write one chunk of each column; return the checksum over all their files."""
        check = self._seed
        for name in columns:
            data = _encoded(self.specs[name], columns[name])
            check = google_crc32c.extend(check, data)
            self._write(self.specs[name].key(number), data)
        return int(check)

    def _write(self, name: str, data: bytes) -> None:
        """Write a file of the store: it gets its name when all of it has reached the disk."""
        partial = self.folder / PARTIAL / uuid.uuid4().hex
        try:
            with open(partial, "wb") as file:
                file.write(data)
                file.flush()
                os.fsync(file.fileno())
            os.replace(partial, self.folder / DATA / name)
        except OSError:
            with suppress(OSError):
                partial.unlink()
            raise

    def marked(self, number: int) -> int | None:
        """Return the checksum in a batch's mark; None when it has none, or a damaged one."""
        try:
            values = self._read_chunk(DONE, number)
        except (OSError, ValueError):
            return None
        return int(values[0]) - 1 if values[0] > 0 else None

    def is_done(self, number: int) -> bool:
        """Tell whether a batch is marked and its files are as they were when it was."""
        wanted = self.marked(number)
        if wanted is None:
            return False
        check = self._seed
        try:
            for path in self._files(number):
                check = google_crc32c.extend(check, path.read_bytes())
        except OSError:
            return False
        return int(check) == wanted

    def standing(self) -> tuple[list[int], list[int]]:
        """Return the batches that are done, and those whose marks or data are damaged."""
        done, damaged = [], []
        for number in range(self.plan.batches):
            if self.is_done(number):
                done.append(number)
            elif (self.folder / DATA / self.specs[DONE].key(number)).exists():
                damaged.append(number)
        return done, damaged

    def unmarked_runs(self) -> list[slice]:
        """Return the runs of batches without a mark, or of which a file is missing."""
        numbers = range(self.plan.batches)
        rows = (self.plan.rows(n) for n in numbers if self.marked(n) is None or not self._whole(n))
        return [slice(part.start, part.stop) for part in rows]

    def _whole(self, number: int) -> bool:
        """Tell whether all files of a batch are there."""
        return all(path.is_file() for path in self._files(number))

    def _files(self, number: int) -> list[Path]:
        """Return the files of a batch that its mark answers for, in order."""
        names = (*(v.name for v in self.plan.variables), "broke_at", "reason", "status")
        return [self.folder / DATA / self.specs[name].key(number) for name in names]

    def unmark(self, numbers: Iterable[int]) -> None:
        """Take the marks of damaged batches away, so that they are made again. Raises RunError."""
        with writing(self.folder):
            for number in numbers:
                (self.folder / DATA / self.specs[DONE].key(number)).unlink(missing_ok=True)

    def tidy(self) -> None:
        """Remove files that were being written when their writer died."""
        for path in (self.folder / PARTIAL).glob("*"):
            with suppress(OSError):
                path.unlink()

    def rows(self, number: int) -> list[list[Any]]:
        """Return the values of a batch's runs. Raises RunError when they are damaged."""
        columns = []
        for parameter in self.plan.parameters:
            path = self.folder / DATA / self.specs[parameter["name"]].key(number)
            with reading(path):
                try:
                    columns.append(self._read_chunk(parameter["name"], number))
                except ValueError as error:
                    raise RunError(path, f"is damaged: {error}") from None
        count = len(self.plan.rows(number))
        return [list(row) for row in zip(*columns, strict=True)][:count]

    def row(self, run: int) -> list[Any]:
        """Return the values of one run. Raises RunError for a run that is not there."""
        if not 0 <= run < self.plan.runs:
            raise RunError(self.folder, f"has no run {run}; it has 0 to {self.plan.runs - 1}")
        number, place = divmod(run, self.plan.batch)
        return self.rows(number)[place]

    def statuses(self, done: Iterable[int]) -> Iterator[tuple[list[str], list[str]]]:
        """Yield status and reason of the runs of batches that are done."""
        for number in done:
            count = len(self.plan.rows(number))
            status, reason = (self._read_chunk(name, number) for name in ("status", "reason"))
            yield status[:count], reason[:count]

    def _read_chunk(self, name: str, number: int) -> list[Any]:
        """Return a chunk's values. Raises OSError, ValueError when it is not there or damaged."""
        spec = self.specs[name]
        data = (self.folder / DATA / spec.key(number)).read_bytes()
        body = opened(data)
        if spec.kind == "string":
            return _decoded_texts(body)
        values: list[Any] = decode(body, spec.kind, spec.chunk).tolist()
        return values


def _specs(plan: SweepPlan) -> Iterator[ArraySpec]:
    """All arrays of the store."""
    runs, size = (plan.runs,), (plan.batch,)
    kinds = {FLOAT: "float64", INT: "int64"}
    about: dict[str, Any] = {"long_name": "number of the run"}
    yield ArraySpec("run", ("run",), runs, size, "int64", about)
    for parameter in plan.parameters:
        about = {"path": parameter["path"], "long_name": parameter["long_name"]}
        about |= {"units": parameter["unit"]} if parameter["unit"] else {}
        kind = kinds.get(parameter["kind"], "string")
        yield ArraySpec(parameter["name"], ("run",), runs, size, kind, about)
    for dim, found in plan.coordinates.items():
        count = (len(found["values"]),)
        kind = "string" if isinstance(found["values"][0], str) else "float64"
        yield ArraySpec(dim, (dim,), count, count, kind, found["attributes"])
    about = {"long_name": "how the run ended"}
    yield ArraySpec("status", ("run",), runs, size, "string", about)
    yield ArraySpec("reason", ("run",), runs, size, "string", {"long_name": "why it broke"})
    about = {"long_name": "time of the last good frame of a broken run", "units": "s"}
    yield ArraySpec("broke_at", ("run",), runs, size, "float64", about)
    for variable in plan.variables:
        dims, shape = ("run", *variable.dims), (plan.runs, *variable.sizes)
        chunk = (plan.batch, *(max(1, size) for size in variable.sizes))
        yield ArraySpec(variable.name, dims, shape, chunk, "float64", variable.attributes)
    about = {
        "long_name": "1 + checksum (CRC-32C) of the sweep's id and a batch's files; 0: not done"
    }
    yield ArraySpec(DONE, ("batch",), (plan.batches,), (1,), "int64", about)


def _encoded(spec: ArraySpec, values: Any) -> bytes:
    """Return a chunk as its file holds it; the last one is filled up."""
    missing = spec.chunk[0] - len(values)
    if spec.kind == "string":
        texts = [str(value) for value in values] + [""] * missing
        return encode_texts(texts)
    array = np.asarray(values, dtype=spec.kind)
    fill = 0 if spec.kind == "int64" else np.nan
    pad = [(0, missing)] + [(0, 0)] * (array.ndim - 1)
    return encode(np.pad(array, pad, constant_values=fill))


def _decoded_texts(data: bytes) -> list[str]:
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
