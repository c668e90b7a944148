"""A sweep on disk: a folder with the scene, what was asked, and a Zarr store with one chunk per batch.

A batch's data are written first, each file whole or not at all, then its mark in `done/marks`: a checksum
over those files and the sweep's id. A mark that is there and right says that the batch is there, whole and
right.
The values of the runs are written before anything runs, then what was asked; both have a copy, from which
`resume` mends them.
"""

from __future__ import annotations

import json
import os
import shutil
import uuid
from collections.abc import Iterable, Iterator
from contextlib import suppress
from pathlib import Path
from typing import Any

import google_crc32c
import numpy as np

from ropewalk.record.errors import RunError
from ropewalk.record.files import reading, writing
from ropewalk.record.seal import sealed
from ropewalk.record.zarr_format import decode, group_metadata, opened
from ropewalk.scene import Scene, dumps, loads
from ropewalk.sweeps.batch import Batch
from ropewalk.sweeps.facts import read_facts
from ropewalk.sweeps.store_layout import (
    DONE,
    NOTES,
    OF_BROKEN,
    REASON,
    RUN,
    STATUS,
    array_specs,
    decoded_texts,
    encoded,
    marks_spec,
    nothing_broke,
)
from ropewalk.sweeps.sweep_plan import READS, SweepPlan
from ropewalk.words.shell import typed

FACTS, SCENE, DATA, PARTIAL = "sweep.json", "scene.toml", "data.zarr", ".partial"
#: A second time the values of the runs and what was asked: nothing else could bring them back.
COPIES = "values"
_NONE_BROKE = 1 << 32  # in the mark of a batch of which no run broke


def runs_in_words(runs: range) -> str:
    """Return the numbers of some runs as words."""
    return f"run {runs[0]}" if len(runs) == 1 else f"runs {runs[0]} to {runs[-1]}"


def is_sweep(folder: Path) -> bool:
    """Tell whether a folder holds a sweep."""
    return (folder / FACTS).is_file() or (folder / COPIES / FACTS).is_file()


class SweepFolder:
    """The folder of a sweep: what it is, and where its batches are written and read."""

    def __init__(self, folder: Path, plan: SweepPlan) -> None:
        self.folder, self.plan = folder, plan
        self.specs = {spec.name: spec for spec in array_specs(plan)} | {DONE: marks_spec(plan)}
        # So that a late worker of a sweep that was overwritten cannot mark a batch of this one.
        self._seed = int(google_crc32c.value(plan.id.encode()))
        self._piece: tuple[int, list[Any]] = -1, []  # the values that were read last

    @classmethod
    def open(cls, folder: Path) -> SweepFolder:
        """Open a sweep's folder. Raises RunError when it is none, or damaged."""
        if not is_sweep(folder):
            what = "holds no sweep" if folder.is_dir() else "no such sweep"
            raise RunError(folder, what)
        facts = read_facts(folder / FACTS, folder / COPIES / FACTS)
        if facts.get("format") not in READS:
            rule = f"is of format {facts.get('format')}; this version of ropewalk reads {READS[-1]}"
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

        It is there as soon as its facts are, which are written last, but for their copy. Raises RunError.
        """
        made = cls(folder, plan)
        with writing(folder):
            for facts in made.facts_files():  # of one that is overwritten; the first to go
                facts.unlink(missing_ok=True)
            for left in (DATA, COPIES):
                shutil.rmtree(folder / left, ignore_errors=True)
            (folder / PARTIAL).mkdir(parents=True, exist_ok=True)
            made.tidy()
            for spec in made.specs.values():
                (folder / DATA / spec.name).mkdir(parents=True, exist_ok=True)
            (folder / COPIES).mkdir(exist_ok=True)
            for name, data in made.known_files():
                made.put(name, data)
            made._write_values(values)
            made.put(f"../{SCENE}", dumps(scene).encode())
            facts_now = made.facts()
            for file in reversed(made.facts_files()):
                made.put(f"../{file.relative_to(folder).as_posix()}", facts_now)
        return made

    def facts_files(self) -> tuple[Path, Path]:
        """Return where what was asked stands: the copy, which is there only beside the other, and that."""
        return self.folder / COPIES / FACTS, self.folder / FACTS

    def facts_state(self) -> tuple[int, int]:
        """Return what tells whether the file of what was asked has been written anew."""
        try:
            found = (self.folder / FACTS).stat()
        except OSError:
            return 0, 0
        return found.st_ino, found.st_mtime_ns

    def refuse_another(self) -> None:
        """Raise RunError where the folder holds another sweep than it did when it was opened, or none."""
        if not is_sweep(self.folder):
            raise RunError(self.folder, "holds no sweep any more")
        if read_facts(self.folder / FACTS, self.folder / COPIES / FACTS).get("id") != self.plan.id:
            raise RunError(self.folder, "holds another sweep by now; open it again")

    def facts(self) -> bytes:
        """Return what was asked as its files hold it."""
        return sealed(json.dumps(self.plan.plain(), indent=1, ensure_ascii=False))

    @property
    def scene(self) -> Scene:
        """The scene that is varied."""
        return loads(self.plan.recipe.scene, str(self.folder / SCENE))

    def _attributes(self) -> dict[str, Any]:
        plan = self.plan
        seed = {} if plan.seed is None else {"seed": plan.seed}
        return {
            "title": plan.title,
            "source": f"ropewalk {plan.provenance.get('ropewalk', '')}".rstrip(),
            "design": plan.design,
            **seed,
            "grid": json.dumps(list(plan.shape)),
            "coordinates": " ".join(plan.columns),
        }

    def known_files(self) -> Iterator[tuple[str, bytes]]:
        """Yield name and content of the files that the plan alone decides."""
        arrays = {spec.name: spec.metadata() for spec in self.specs.values()}
        if self.specs[DONE].name != DONE:
            arrays[DONE] = group_metadata({}, {})
        for name, array in arrays.items():
            yield f"{name}/zarr.json", json.dumps(array).encode()
        yield "zarr.json", json.dumps(group_metadata(self._attributes(), arrays)).encode()
        for dim, about in self.plan.coordinates.items():
            yield self.specs[dim].key(0), encoded(self.specs[dim], about["values"])
        for number in range(self.plan.pieces):
            first = number * self.plan.piece
            runs = np.arange(first, min(first + self.plan.piece, self.plan.runs))
            yield self.specs[RUN].key(number), encoded(self.specs[RUN], runs)

    def value_files(self) -> Iterator[tuple[str, Path, Path]]:
        """Yield name, file and copy of every chunk of values."""
        for name in self.plan.columns:
            spec = self.specs[name]
            for number in range(self.plan.pieces):
                key = spec.key(number)
                copy = self.folder / COPIES / key.replace("/", ".")
                yield key, self.folder / DATA / key, copy

    def _write_values(self, values: Iterable[list[Any]]) -> None:
        """Write the values of all runs, cut at the chunks, twice."""
        names, number = self.plan.columns, 0
        waiting: list[Any] = [[] for _ in names]
        size = self.plan.piece

        def write(columns: Iterable[Any]) -> None:
            for name, column in zip(names, columns, strict=True):
                key, data = self.specs[name].key(number), encoded(self.specs[name], column)
                self.put(key, data)
                self.put(f"../{COPIES}/{key.replace('/', '.')}", data)

        for piece in values:
            waiting = [
                np.concatenate([w, p]) if len(w) else p for w, p in zip(waiting, piece, strict=True)
            ]
            while len(waiting[0]) >= size:
                write(w[:size] for w in waiting)
                waiting = [w[size:] for w in waiting]
                number += 1
        if len(waiting[0]):
            write(waiting)

    # -- batches ---------------------------------------------------------------------------

    def write(self, number: int, batch: Batch) -> None:
        """Write a batch, then its mark. Raises RunError when the disk refuses."""
        columns = {name: part for name, part in batch.arrays().items() if name in self.specs}
        whole = nothing_broke(columns)  # then two files would say nothing
        with writing(self.folder, "; what was marked before is kept"):
            check = self._seed
            for name in columns:
                path = self._file(name, number)
                if whole and name in OF_BROKEN:
                    path.unlink(missing_ok=True)  # of a worker of another sweep
                    continue
                data = encoded(self.specs[name], columns[name])
                check = google_crc32c.extend(check, data)
                self.put(self.specs[name].key(number), data)
            mark = int(check) + 1 + (_NONE_BROKE if whole else 0)
            self.put(self.specs[DONE].key(number), encoded(self.specs[DONE], [mark]))

    def put(self, name: str, data: bytes) -> None:
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
        """Return what a batch's mark says; None when it has none, or a damaged one."""
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
            for path in self.batch_files(number, wanted):
                check = google_crc32c.extend(check, path.read_bytes())
        except OSError:
            return False
        strays = wanted & _NONE_BROKE and any(self._file(n, number).exists() for n in OF_BROKEN)
        return int(check) == wanted & ~_NONE_BROKE and not strays

    def standing(self) -> tuple[list[int], list[int]]:
        """Return the batches that are done, and those whose marks or data are damaged."""
        done, damaged = [], []
        for number in range(self.plan.batches):
            if self.is_done(number):
                done.append(number)
            elif self._file(DONE, number).exists():
                damaged.append(number)
        return done, damaged

    def unmarked_runs(self) -> list[slice]:
        """Return the runs of batches without a mark, or of which a file is missing."""
        numbers = range(self.plan.batches)
        rows = (self.plan.rows(n) for n in numbers if not self._whole(n))
        return [slice(part.start, part.stop) for part in rows]

    def _whole(self, number: int) -> bool:
        """Tell whether a batch is marked and all its files are there."""
        mark = self.marked(number)
        return mark is not None and all(p.is_file() for p in self.batch_files(number, mark))

    def batch_files(self, number: int, mark: int) -> list[Path]:
        """Return the files of a batch that its mark answers for, in order."""
        broken = () if mark & _NONE_BROKE else OF_BROKEN
        notes = (NOTES,) if self.plan.has_notes else ()
        names = (*(v.name for v in self.plan.variables), *broken, *notes, STATUS)
        return [self._file(name, number) for name in names]

    def _file(self, name: str, number: int) -> Path:
        return self.folder / DATA / self.specs[name].key(number)

    def unmark(self, numbers: Iterable[int]) -> None:
        """Take the marks of damaged batches away, so that they are made again. Raises RunError."""
        with writing(self.folder):
            for number in numbers:
                self._file(DONE, number).unlink(missing_ok=True)

    def tidy(self) -> None:
        """Remove files that were being written when their writer died."""
        for path in (self.folder / PARTIAL).glob("*"):
            with suppress(OSError):
                path.unlink()

    def rows(self, number: int) -> list[list[Any]]:
        """Return the values of a batch's runs. Raises RunError when they are damaged."""
        place, rows = self._values_at(self.plan.rows(number).start)
        count = len(self.plan.rows(number))
        return [list(row) for row in zip(*(c[place : place + count] for c in rows), strict=True)]

    def row(self, run: int) -> list[Any]:
        """Return the values of one run. Raises RunError for a run that is not there."""
        if not 0 <= run < self.plan.runs:
            raise RunError(self.folder, f"has no run {run}; it has 0 to {self.plan.runs - 1}")
        place, columns = self._values_at(run)
        return [column[place] for column in columns]

    def _values_at(self, run: int) -> tuple[int, list[list[Any]]]:
        """Return the columns of the chunk that a run's values lie in, and its place in them."""
        number, place = divmod(run, self.plan.piece)
        if self._piece[0] != number:
            columns = []
            for parameter in self.plan.parameters:
                path = self._file(parameter["name"], number)
                with reading(path):
                    try:
                        columns.append(self._read_chunk(parameter["name"], number))
                    except ValueError as error:
                        raise RunError(path, self.damage(path, str(error))) from None
            self._piece = number, columns
        return place, self._piece[1]

    def damage(self, path: Path, why: str) -> str:
        """Say that a file of the store is damaged, whose it is, and what to do."""
        name, _, chunk = (
            path.relative_to(self.folder).as_posix().removeprefix(f"{DATA}/").partition("/c.")
        )
        spec = self.specs.get(name)
        number = chunk.partition(".")[0]
        where, remedy = "", "puts it right"
        if spec is not None and spec.dims[0] == "run" and number.isdecimal():
            first = int(number) * spec.chunk[0]
            where = f" ({runs_in_words(range(first, min(first + spec.chunk[0], self.plan.runs)))})"
            results = {*OF_BROKEN, NOTES, STATUS, *(v.name for v in self.plan.variables)}
            remedy = "makes these runs again" if name in results else remedy
        return f"is damaged{where}: {why}; `ropewalk resume {typed(self.folder)}` {remedy}"

    def statuses(self, done: Iterable[int]) -> Iterator[tuple[list[str], list[str]]]:
        """Yield status and reason of the runs of batches that are done."""
        for number in done:
            count = len(self.plan.rows(number))
            status = self._read_chunk(STATUS, number)[:count]
            broke = self._file(REASON, number).exists()
            yield status, self._read_chunk(REASON, number)[:count] if broke else [""] * count

    def notes(self, number: int) -> list[str]:
        """Return what is noted of the runs of a batch that is done."""
        runs = len(self.plan.rows(number))
        return self._read_chunk(NOTES, number)[:runs] if self.plan.has_notes else [""] * runs

    def _read_chunk(self, name: str, number: int) -> list[Any]:
        """Return a chunk's values. Raises OSError, ValueError when it is not there or damaged."""
        spec = self.specs[name]
        body = opened(self._file(name, number).read_bytes())
        if spec.kind == "string":
            return decoded_texts(body)
        values: list[Any] = decode(body, spec.kind, spec.chunk).tolist()
        return values
