"""The part of the Zarr v3 format that a run folder uses: metadata, chunk names, codecs.

Written by hand, because the order in which files appear decides whether a killed run can be read, and so
that recording imports little. Source: zarr-specs.readthedocs.io, core specification 3.1 and its codecs.
"""

from __future__ import annotations

import struct
from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

_LITTLE = {"name": "bytes", "configuration": {"endian": "little"}}
_BLOSC = {
    "name": "blosc",
    "configuration": {
        "typesize": 8,
        "cname": "lz4",
        "clevel": 1,
        "shuffle": "shuffle",
        "blocksize": 0,
    },
}
_SWAP = {"name": "transpose", "configuration": {"order": [0, 2, 1]}}
_TEXT = {"name": "vlen-utf8"}
_CHECKSUM = {"name": "crc32c"}
HEADER = 16  # bytes
CHECKSUM = 4  # bytes, at the end of every chunk


@dataclass(frozen=True)
class ArraySpec:
    """One array of the store."""

    name: str
    dims: tuple[str, ...]
    shape: tuple[int, ...]
    chunk: tuple[int, ...]
    kind: str  # float64, int64 or string
    attributes: dict[str, Any]
    swapped: bool = False  # chunks lie as (time, axis, node)
    checked: bool = True  # chunks end with their checksum

    def metadata(self, frames: int | None = None) -> dict[str, Any]:
        """Return the array's zarr.json; `frames` in place of the first length."""
        shape = list(self.shape) if frames is None else [frames, *self.shape[1:]]
        codecs: list[dict[str, Any]] = [_TEXT] if self.kind == "string" else [_LITTLE, _BLOSC]
        codecs += [_CHECKSUM] if self.checked else []
        fill: Any = {"float64": "NaN", "int64": 0, "string": ""}[self.kind]
        return {
            "zarr_format": 3,
            "node_type": "array",
            "shape": shape,
            "data_type": self.kind,
            "chunk_grid": {"name": "regular", "configuration": {"chunk_shape": list(self.chunk)}},
            "chunk_key_encoding": {"name": "default", "configuration": {"separator": "."}},
            "fill_value": fill,
            "codecs": [_SWAP, *codecs] if self.swapped else codecs,
            "attributes": self.attributes,
            "dimension_names": list(self.dims),
            "storage_transformers": [],
        }

    def key(self, number: int) -> str:
        """Return the file of the chunk `number` (along the first dimension), below the store."""
        return f"{self.name}/c.{number}" + ".0" * (len(self.dims) - 1)


def group_metadata(attributes: dict[str, Any], arrays: dict[str, dict[str, Any]]) -> dict[str, Any]:
    """Return the root's zarr.json with the metadata of all arrays in it."""
    return {
        "zarr_format": 3,
        "node_type": "group",
        "attributes": attributes,
        "consolidated_metadata": {"kind": "inline", "must_understand": False, "metadata": arrays},
    }


def checksum(data: bytes | NDArray[np.uint8]) -> bytes:
    """Return the CRC-32C of a chunk as it lies behind it."""
    import google_crc32c

    return struct.pack("<I", google_crc32c.value(data))


def opened(data: bytes) -> bytes:
    """Return a chunk without its checksum. Raises ValueError when it does not fit."""
    body = data[:-CHECKSUM]
    if len(data) < CHECKSUM or checksum(body) != data[-CHECKSUM:]:
        raise ValueError(f"its {len(data)} bytes do not fit their checksum")
    return body


def encode(array: NDArray[Any]) -> bytes:
    """Return a chunk of numbers as it lies on disk (same input, same bytes)."""
    from numcodecs import blosc

    data = np.ascontiguousarray(array)
    if data.dtype.byteorder == ">":
        data = data.astype(data.dtype.newbyteorder("<"))
    with_threads = blosc.use_threads
    blosc.use_threads = False  # several threads would put the parts in any order
    try:
        packed: bytes = blosc.compress(data, b"lz4", 1, blosc.SHUFFLE, 0)
    finally:
        blosc.use_threads = with_threads
    return packed + checksum(packed)


def stored_header(size: int) -> bytes:
    """Return what comes before `size` bytes of numbers in a chunk that is not compressed.

    Blosc's format 2 with its flags for shuffled, copied and lz4: every reader of packed chunks reads it.
    """
    return struct.pack("<BBBBIII", 2, 1, 0x01 | 0x02 | 0x20, 8, size, size, size + HEADER)


def encode_stored(array: NDArray[Any]) -> bytes:
    """Return a chunk of numbers as `encode` does, but not compressed."""
    plain = np.ascontiguousarray(array, dtype="<f8").tobytes()
    data = stored_header(array.nbytes) + plain
    return data + checksum(data)


def decode(data: bytes, kind: str, shape: tuple[int, ...]) -> NDArray[Any]:
    """Return the numbers of a chunk without its checksum. Raises ValueError when it is damaged."""
    from numcodecs import blosc

    size = 8 * int(np.prod(shape))
    header = struct.unpack("<II", data[4:8] + data[12:16]) if len(data) >= 16 else (0, 0)
    if header != (size, len(data)):  # the library itself reads beyond the end of a cut chunk
        raise ValueError(f"{len(data)} bytes that do not hold {size}")
    try:
        plain = blosc.decompress(data)
    except (RuntimeError, ValueError) as error:
        raise ValueError(str(error)) from None
    return np.frombuffer(plain, dtype="<f8" if kind == "float64" else "<i8").reshape(shape)


def encode_texts(values: list[str]) -> bytes:
    """Return texts as the codec vlen-utf8 has them."""
    packed = {value: _length_and_bytes(value.encode()) for value in set(values)}
    data = struct.pack("<I", len(values)) + b"".join([packed[value] for value in values])
    return data + checksum(data)


def _length_and_bytes(text: bytes) -> bytes:
    return struct.pack("<I", len(text)) + text
