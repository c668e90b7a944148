"""A run's numbers as a Zarr store, written chunk by chunk and committed at once.

A chunk holds the same frames of every quantity. Chunk files come first, under names that the present shape
does not reach or with contents that repeat what is there; then the root's zarr.json, which holds the shapes
of all arrays, is replaced by one rename. Whatever moment a run is killed at, the store opens with
consistent lengths.

Behind the last frame of a chunk that is not full lie NaNs: what is read beyond is no number.
"""

from __future__ import annotations

import mmap
from math import prod
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np

from ropewalk.core.arrays import Floats, State
from ropewalk.lowering import Layout
from ropewalk.methods.recording import LARGE, Recording, make_recording
from ropewalk.record.dataset import TIME, attributes, coordinates
from ropewalk.record.files import sync_all, write, write_json, write_pages
from ropewalk.record.quantities import WORKS, Quantity, raw, recorded, sizes
from ropewalk.record.seal import crc_of
from ropewalk.record.zarr_format import (
    CHECKSUM,
    HEADER,
    ArraySpec,
    checksum,
    encode,
    encode_stored,
    encode_texts,
    group_metadata,
    stored_header,
)
from ropewalk.scene import Scene
from ropewalk.simulation.block import Block

if TYPE_CHECKING:
    from ropewalk.record.reader import Stored

FORMAT = 10  # of the run folder
READABLE = (2, 3, 4, 5, 6, 7, 8, 9, FORMAT)
CHECKED = 3  # from this format on every chunk has a checksum
SEALED = 5  # from this one on the rest has, too
ROOT = "zarr.json"
SEAL = "ropewalk_checksum"  # attribute of the root
LEADING = "positions"  # the array whose chunks are the frames that are written at a time
LONGEST_FILE = 4096  # [frames] of small arrays in one file
FILE_BYTES = 1_000_000  # of them, before compression


def array_specs(
    quantities: tuple[Quantity, ...], layout: Layout, chunk: int, version: int = FORMAT
) -> list[ArraySpec]:
    """Return the descriptions of the time coordinate and of the quantities in a format, in order.

    A file of a LARGE quantity holds one chunk of frames, that of a small one several.
    """
    rows, checked = (_frames(chunk, 8),), version >= CHECKED
    specs = [ArraySpec("time", ("time",), (0,), rows, "float64", dict(TIME), checked=checked)]
    lengths = sizes(layout, version)
    for quantity in quantities:
        rest = tuple(lengths[dim] for dim in quantity.dims[1:])
        frames = chunk if quantity.field in LARGE else _frames(chunk, 8 * prod(rest))
        about = {"units": quantity.unit, "long_name": quantity.long_name}
        shape, form = (0, *rest), (frames, *rest)
        name, dims, swapped = quantity.name, quantity.dims, quantity.swapped
        specs.append(ArraySpec(name, dims, shape, form, "float64", about, swapped, checked))
    return specs


def seal_of(root: dict[str, Any]) -> str:
    """Return the checksum of the root's metadata without its own."""
    about = {name: value for name, value in root["attributes"].items() if name != SEAL}
    return crc_of({**root, "attributes": about})


def _frames(chunk: int, size: int) -> int:
    """Return the frames in one file of an array with `size` bytes a frame: whole chunks of them."""
    return chunk * max(1, min(LONGEST_FILE, FILE_BYTES // size) // chunk)


class Writer:
    """Writes the blocks of a run into a store; `frames` counts what was handed in."""

    def __init__(
        self,
        folder: Path,
        scene: Scene,
        layout: Layout,
        chunk: int,
        packed: bool = True,
        ledger: bool = True,
    ) -> None:
        """Unless `packed`, full chunks of LARGE are not compressed; works without a ledger are NaN."""
        self.folder, self.chunk, self.packed = folder, chunk, packed
        self._scene, self._layout = scene, layout
        self.quantities = recorded(layout, scene)
        self._specs = array_specs(self.quantities, layout, chunk)
        self._unknown = () if ledger else WORKS
        self._fields = ["", *(quantity.field for quantity in self.quantities)]
        self._fixed: dict[str, dict[str, Any]] = {}
        self._attributes: dict[str, Any] = {}
        self._pending: list[list[Floats]] = [[] for _ in self._specs]
        self._unsynced: list[Path] = []
        self._touched: set[Path] = set()  # folders that got a file
        self._safe = 0  # frames that are on the disk for good, or shown
        self.frames = 0

    def create(self, provenance: dict[str, Any]) -> None:
        """Write everything but the frames. Raises OSError."""
        self.folder.mkdir()
        for name, (dim, values, about) in coordinates(self._scene, self._layout).items():
            kind = "string" if values.dtype == object else str(values.dtype)
            length = len(values)
            spec = ArraySpec(name, (dim,), (length,), (length,), kind, dict(about))
            (self.folder / name).mkdir()
            texts = kind == "string"
            data = encode_texts([str(v) for v in values]) if texts else encode(values)
            write(self.folder / spec.key(0), data)
            write_json(self.folder / name / ROOT, spec.metadata(), indent=None)
            self._fixed[name] = spec.metadata()
        for spec in self._specs:
            (self.folder / spec.name).mkdir()
        self._attributes = attributes(self._scene, provenance)
        self._attributes["ropewalk_format"] = FORMAT
        more = [name for name, spec in self._fixed.items() if spec["dimension_names"] != [name]]
        self._attributes["coordinates"] = " ".join(more)  # where xarray looks for their names

    def go_on(self, stored: Stored, frames: int) -> None:
        """Take up a store after `frames` frames; more than that it shows no longer.

        Raises RunError, OSError.
        """
        own = {spec.name for spec in self._specs}
        arrays = stored.root["consolidated_metadata"]["metadata"]
        self._fixed = {name: value for name, value in arrays.items() if name not in own}
        self._attributes = stored.root["attributes"]
        for spec, parts in zip(self._specs, self._pending, strict=True):
            begun = frames % spec.chunk[0]
            parts[:] = [stored.read_raw(spec.name, frames - begun, frames)] if begun else []
        self.frames = self._safe = frames
        if stored.shown > frames:  # before a chunk is written anew that holds fewer than are shown
            self.show()

    def add(self, block: Block, room: Room | None = None) -> None:
        """Take a block of frames; write every chunk that becomes full. Raises OSError.

        With the `room` whose last frames are the block's own memory, if it is used again.
        """
        arrays = [block.time, *(raw(block, quantity) for quantity in self.quantities)]
        self.add_raw(arrays, room)

    def add_raw(self, arrays: list[Floats], room: Room | None = None) -> None:
        """Take frames as they are recorded: time, then the quantities in order. Raises OSError."""
        for place, array in enumerate(arrays):
            known = self._specs[place].name not in self._unknown
            self._take(place, array if known else np.full_like(array, np.nan), room)
        self.frames += len(arrays[0])

    def _take(self, place: int, array: Floats, room: Room | None) -> None:
        rows, parts = self._specs[place].chunk[0], self._pending[place]
        done = 0
        while done < len(array):
            begun = (self.frames + done) % rows
            part = array[done : done + rows - begun]
            done += len(part)
            if begun + len(part) == rows:
                self._write_full(place, (self.frames + done) // rows - 1, part, room)
                parts.clear()
            else:
                parts.append(part if room is None else part.copy())

    def _write_full(self, place: int, number: int, part: Floats, room: Room | None) -> None:
        """Write a chunk of which `part` is the end."""
        spec, field, before = self._specs[place], self._fields[place], self._pending[place]
        path = self.folder / spec.key(number)
        again = number * spec.chunk[0] < self._safe  # then it stands in for frames that are safe
        self._touched.add(path.parent)
        if not again:
            self._unsynced.append(path)
        if self.packed or field not in LARGE:
            write(path, encode(np.concatenate([*before, part]) if before else part), sync=again)
        elif room is None:
            write(path, encode_stored(np.concatenate([*before, part])), sync=again)
        else:
            whole = getattr(room.recording, field)
            if before:
                whole[: len(whole) - len(part)] = np.concatenate(before)
            write_pages(path, room.pages[field], room.seal(field), sync=again)

    def commit(self) -> None:
        """Show readers all frames so far, on the disk for good. Raises OSError."""
        self.flush()
        self.show()

    def flush(self) -> None:
        """Have all frames so far on the disk for good; readers do not see them yet. Raises OSError."""
        for spec, parts in zip(self._specs, self._pending, strict=True):
            if parts:
                self._write_part(spec, parts)
        sync_all(self._unsynced)
        sync_all(self._touched)
        self._unsynced.clear()
        self._touched.clear()
        self._safe = self.frames

    def show(self) -> None:
        """Show readers all frames so far, which have been flushed. Raises OSError."""
        arrays = dict(self._fixed)
        for spec in self._specs:
            arrays[spec.name] = spec.metadata(self.frames)
            write_json(self.folder / spec.name / ROOT, arrays[spec.name], indent=None)
        whole = group_metadata(dict(self._attributes), arrays)
        whole["attributes"][SEAL] = seal_of(whole)
        write_json(self.folder / ROOT, whole, indent=None, sync=True)
        sync_all([self.folder])

    def _write_part(self, spec: ArraySpec, parts: list[Floats]) -> None:
        """Write the frames that fill no whole chunk yet."""
        full = np.full((spec.chunk[0], *parts[0].shape[1:]), np.nan)
        np.concatenate(parts, out=full[: sum(map(len, parts))])
        path = self.folder / spec.key(self.frames // spec.chunk[0])
        write(path, encode(full), sync=True)
        self._touched.add(path.parent)


class Room:
    """Buffers for a chunk whose large arrays lie in memory as their files will, header and all.

    `pages` has that memory by field: whole pages of it, so that the system can take them as they are.
    """

    def __init__(self, state: State, frames: int, with_lengths: bool) -> None:
        found: list[mmap.mmap] = []

        def empty(shape: tuple[int, ...]) -> Floats:
            size = 8 * prod(shape)
            pages = mmap.mmap(-1, -(-(HEADER + size + CHECKSUM) // mmap.PAGESIZE) * mmap.PAGESIZE)
            pages[:HEADER] = stored_header(size)
            found.append(pages)
            return np.frombuffer(pages, count=prod(shape), offset=HEADER).reshape(shape)

        self.recording = make_recording(state, frames, with_lengths, empty)
        self.pages = dict(zip(LARGE, found, strict=True))

    def seal(self, field: str) -> int:
        """Put the checksum behind what `field` holds; return the bytes of its file."""
        pages = self.pages[field]
        end: int = HEADER + getattr(self.recording, field).nbytes
        pages[end : end + CHECKSUM] = checksum(np.frombuffer(pages, np.uint8, end))
        return end + CHECKSUM

    def part(self, start: int, stop: int) -> Recording:
        """Return the buffers of the frames from `start` to `stop`."""
        return self.recording.part(start, stop)
