"""Reading a run's store, a few frames at a time."""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from ropewalk.core.arrays import Floats
from ropewalk.laws.wheel_rows import RECORDED
from ropewalk.lowering import Layout
from ropewalk.record.errors import RunError
from ropewalk.record.files import read_json, reading
from ropewalk.record.place import PROVENANCE
from ropewalk.record.quantities import BY_NAME, PULLEYS, stored
from ropewalk.record.store import (
    CHECKED,
    LEADING,
    READABLE,
    ROOT,
    SEAL,
    SEALED,
    array_specs,
    seal_of,
)
from ropewalk.record.zarr_format import ArraySpec, decode, opened
from ropewalk.scene import Scene


def reads() -> str:
    """Say which formats can be read."""
    *others, last = map(str, READABLE)
    return f"this version of ropewalk reads {', '.join(others)} and {last}"


def _same_numbers(found: Any, expected: dict[str, Any]) -> bool:
    """Tell whether an array's metadata describe the same numbers: its words were reworded since."""
    return isinstance(found, dict) and {**found, "attributes": expected["attributes"]} == expected


class Stored:
    """The quantities of a run folder, read when they are asked for. Every fault is a RunError.

    `started` is when the run began, by its provenance: numbers of another one, which has replaced it since,
    are refused. Without it nobody asks.
    """

    def __init__(
        self, folder: Path, scene: Scene, layout: Layout, started: str | None = None
    ) -> None:
        self.folder, self._started = folder, started
        self.root = read_json(folder / ROOT)
        version = self._check_format()
        try:
            arrays = self.root["consolidated_metadata"]["metadata"]
            self._frames = int(arrays["time"]["shape"][0])
            self._chunk = int(arrays[LEADING]["chunk_grid"]["configuration"]["chunk_shape"][0])
        except (KeyError, TypeError, IndexError, ValueError):
            raise RunError(folder / ROOT, "is damaged: it does not describe a run") from None
        if self._frames < 1 or self._chunk < 1:
            raise RunError(folder / ROOT, "is damaged: it has no frames")
        self.shown = self._frames  # frames that the store's own metadata tell of
        self.checked, self.sealed = version >= CHECKED, version >= SEALED
        quantities = stored(layout, scene, version)
        specs = array_specs(quantities, layout, self._chunk, version)
        self._specs = {spec.name: spec for spec in specs}
        for spec in specs:
            if not _same_numbers(arrays.get(spec.name), spec.metadata(self._frames)):
                rule = f"is damaged or was changed: {spec.name!r} does not fit the scene"
                raise RunError(folder / ROOT, rule)

    def _check_format(self) -> int:
        about = self.root.get("attributes")
        version = about.get("ropewalk_format") if isinstance(about, dict) else None
        if version is None:
            raise RunError(self.folder, "is no run of ropewalk")
        if version not in READABLE:
            raise RunError(self.folder, f"has the format {version!r}; {reads()}")
        return int(version)

    @property
    def frames(self) -> int:
        """Number of frames."""
        return self._frames

    def go_to(self, frames: int) -> None:
        """Take so many frames, of which the last ones need not be shown yet.

        Raises RunError when they are not there, or a chunk that holds any of them is damaged.
        """
        if fault := self.root_fault():  # a resumed run takes from it what it writes
            raise fault
        self._frames = frames
        there = int(np.isfinite(self.read_raw("time")).sum())
        if there < frames:
            rule = f"is damaged: it has {there} frames, and its checkpoint stands at {frames}"
            raise RunError(self.folder, rule)
        for path in self.files():
            if fault := self.fault(path):
                raise fault

    def root_fault(self) -> RunError | None:
        """Return what is wrong with the root's zarr.json, of a store in which it has a checksum."""
        if self.sealed and self.root["attributes"].get(SEAL) != seal_of(self.root):
            return RunError(self.folder / ROOT, "is damaged: it does not fit its checksum")
        return None

    def header_faults(self, *, ended: bool) -> Iterator[RunError]:
        """Go through the zarr.json of single arrays and say which are not what the root says of them.

        A kill may leave any number of frames in those of a run that has not ended: nobody reads it there.
        """
        for name, about in self.root["consolidated_metadata"]["metadata"].items():
            path = self.folder / name / ROOT
            try:
                found = read_json(path)
            except RunError as error:
                yield error
                continue
            if not ended and name in self._specs:
                found["shape"] = about["shape"]
            if found != about:
                yield RunError(path, "is damaged: it is not what the store's own zarr.json has")

    def files(self) -> Iterator[Path]:
        """Go through the files of all chunks, those of fixed coordinates included."""
        for name, about in self.root["consolidated_metadata"]["metadata"].items():
            spec = self._specs.get(name)
            if spec is None:
                yield self.folder / name / ("c" + ".0" * len(about["shape"]))
            else:
                for number in range(-(-self._frames // spec.chunk[0])):
                    yield self.folder / spec.key(number)

    def fault(self, path: Path) -> RunError | None:
        """Return what is wrong with a chunk's file; without checksums only whether it is there."""
        try:
            with reading(path):
                data = path.read_bytes()
            if self.checked:
                opened(data)
        except RunError as error:
            return error
        except ValueError as error:
            return RunError(path, f"is damaged: {error}")
        return None

    @property
    def names(self) -> tuple[str, ...]:
        """Names of the recorded quantities."""
        return tuple(name for name in self._specs if name != "time")

    @property
    def chunk(self) -> int:
        """Frames that are best read together."""
        return self._chunk

    def read(self, name: str, start: int = 0, stop: int | None = None) -> Floats:
        """Return a quantity of some frames; in older folders no weight has turned a pulley."""
        array = self.read_raw(name, start, stop)
        if name == PULLEYS and (missing := len(RECORDED) - array.shape[2]):
            return np.pad(array, ((0, 0), (0, 0), (0, missing)))
        return array.transpose(0, 2, 1) if name in BY_NAME and BY_NAME[name].swapped else array

    def refuse_another(self) -> None:
        """Raise RunError where the folder holds another run than it did when it was opened."""
        run = self.folder.parent
        if self._started is None or read_json(run / PROVENANCE).get("started") == self._started:
            return
        raise RunError(run, "holds another run by now; open it again")

    def read_raw(self, name: str, start: int = 0, stop: int | None = None) -> Floats:
        """Return a quantity of some frames as it was recorded: (time, axis, node) if swapped."""
        try:
            return self._read_raw(name, start, stop)
        finally:  # afterwards: a run that is replaced while it is read would be told as the old one
            self.refuse_another()

    def _read_raw(self, name: str, start: int, stop: int | None) -> Floats:
        start, stop, _ = slice(start, stop).indices(self._frames)
        spec = self._specs[name]
        shape = self._stored_shape(spec)[1:]
        out: Floats = np.empty((max(0, stop - start), *shape))
        rows = spec.chunk[0]
        for number in range(start // rows, -(-stop // rows)):
            first = number * rows
            low, high = max(start, first), min(stop, first + rows)
            if low < high:
                out[low - start : high - start] = self._load(spec, number)[
                    low - first : high - first
                ]
        return out

    def _stored_shape(self, spec: ArraySpec) -> tuple[int, ...]:
        if spec.swapped:
            return spec.chunk[0], spec.chunk[2], spec.chunk[1]
        return spec.chunk

    def _load(self, spec: ArraySpec, number: int) -> NDArray[Any]:
        path = self.folder / spec.key(number)
        with reading(path):
            data = path.read_bytes()
        try:
            return decode(
                opened(data) if self.checked else data, spec.kind, self._stored_shape(spec)
            )
        except ValueError as error:
            raise RunError(path, f"is damaged: {error}") from None
