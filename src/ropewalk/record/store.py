"""A run's numbers as a Zarr store, written chunk by chunk and committed at once.

A chunk holds the same frames of every quantity. Chunk files come first, under names that the present shape
does not reach or with contents that repeat what is there; then the root's zarr.json, which holds the shapes
of all arrays, is replaced by one rename. Whatever moment a run is killed at, the store opens with
consistent lengths.
"""

from __future__ import annotations

from pathlib import Path
from typing import Any

import numpy as np

from ropewalk.block import Block
from ropewalk.build import Layout
from ropewalk.core.arrays import Floats
from ropewalk.record.dataset import TIME, attributes, coordinates
from ropewalk.record.files import sync_all, write, write_json
from ropewalk.record.quantities import Quantity, raw, recorded, sizes
from ropewalk.record.zarr_format import ArraySpec, encode, encode_texts, group_metadata
from ropewalk.scene import Scene

FORMAT = 1  # of the run folder
ROOT = "zarr.json"


def time_spec(chunk: int) -> ArraySpec:
    """Return the description of the time coordinate."""
    return ArraySpec("time", ("time",), (0,), (chunk,), "float64", dict(TIME))


def quantity_spec(quantity: Quantity, layout: Layout, chunk: int) -> ArraySpec:
    """Return the description of a quantity's array."""
    lengths = sizes(layout)
    rest = tuple(lengths[dim] for dim in quantity.dims[1:])
    about = {"units": quantity.unit, "long_name": quantity.long_name}
    return ArraySpec(
        quantity.name,
        quantity.dims,
        (0, *rest),
        (chunk, *rest),
        "float64",
        about,
        quantity.swapped,
    )


class Writer:
    """Writes the blocks of a run into a store.

    `frames` counts what was handed in, `committed` what a reader sees.
    """

    def __init__(self, folder: Path, scene: Scene, layout: Layout, chunk: int) -> None:
        self.folder, self.chunk = folder, chunk
        self._scene, self._layout = scene, layout
        self.quantities = recorded(layout, bool(scene.winches))
        self._specs = [time_spec(chunk)]
        self._specs += [quantity_spec(q, layout, chunk) for q in self.quantities]
        self._fixed: dict[str, dict[str, Any]] = {}
        self._attributes: dict[str, Any] = {}
        self._pending: list[list[Floats]] = [[] for _ in self._specs]
        self._unsynced: list[Path] = []
        self.frames = self.committed = 0

    @property
    def open_frames(self) -> int:
        """Frames that the present chunk still takes."""
        return self.chunk - self.frames % self.chunk

    def create(self, provenance: dict[str, Any]) -> None:
        """Write everything but the frames. Raises OSError."""
        self.folder.mkdir()
        for name, (dim, values, about) in coordinates(self._scene, self._layout).items():
            kind = "string" if values.dtype == object else str(values.dtype)
            length = len(values)
            spec = ArraySpec(name, (dim,), (length,), (length,), kind, dict(about))
            (self.folder / name / "c").mkdir(parents=True)
            texts = kind == "string"
            data = encode_texts([str(v) for v in values]) if texts else encode(values)
            write(self.folder / spec.key(0), data)
            write_json(self.folder / name / ROOT, spec.metadata())
            self._fixed[name] = spec.metadata()
        for spec in self._specs:
            (self.folder / spec.name / "c").mkdir(parents=True)
        self._attributes = attributes(self._scene, provenance)
        self._attributes["ropewalk_format"] = FORMAT
        more = [name for name, spec in self._fixed.items() if spec["dimension_names"] != [name]]
        self._attributes["coordinates"] = " ".join(more)  # where xarray looks for their names

    def go_on(self, root: dict[str, Any], pending: list[Floats], frames: int) -> None:
        """Take up a store where it has `frames` frames, of which `pending` fill no whole chunk."""
        own = {spec.name for spec in self._specs}
        arrays = root["consolidated_metadata"]["metadata"]
        self._fixed = {name: value for name, value in arrays.items() if name not in own}
        self._attributes = root["attributes"]
        self._pending = [[array] if len(array) else [] for array in pending]
        self.frames = self.committed = frames

    def add(self, block: Block) -> None:
        """Take a block of frames; write every chunk that becomes full. Raises OSError."""
        self.add_raw([block.time, *(raw(block, quantity) for quantity in self.quantities)])

    def add_raw(self, arrays: list[Floats]) -> None:
        """Take frames as they are recorded: time, then the quantities in order. Raises OSError."""
        count = len(arrays[0])
        start = 0
        while start < count:
            stop = min(count, start + self.open_frames)
            for parts, array in zip(self._pending, arrays, strict=True):
                parts.append(array[start:stop])
            self.frames += stop - start
            start = stop
            if self.frames % self.chunk == 0:
                self._write_chunk(self.frames // self.chunk - 1)
                self._pending = [[] for _ in self._specs]

    def commit(self) -> None:
        """Show readers all frames so far, on the disk for good. Raises OSError."""
        if self.frames % self.chunk:
            self._write_chunk(self.frames // self.chunk)
        sync_all(self._unsynced)
        arrays = dict(self._fixed)
        for spec in self._specs:
            arrays[spec.name] = spec.metadata(self.frames)
            write_json(self.folder / spec.name / ROOT, arrays[spec.name])
        write_json(self.folder / ROOT, group_metadata(self._attributes, arrays), sync=True)
        sync_all([self.folder])
        self._unsynced.clear()
        self.committed = self.frames

    def _write_chunk(self, number: int) -> None:
        """Write one chunk of every array, filled up with NaN."""
        for spec, parts in zip(self._specs, self._pending, strict=True):
            array = parts[0] if len(parts) == 1 else np.concatenate(parts)
            if len(array) < self.chunk:
                full = np.full((self.chunk, *array.shape[1:]), np.nan)
                full[: len(array)] = array
                array = full
            path = self.folder / spec.key(number)
            path.parent.mkdir(parents=True, exist_ok=True)
            write(path, encode(array))
            self._unsynced.append(path)
