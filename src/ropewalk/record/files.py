"""Files that are there whole or not at all, and what the system says in plain words."""

from __future__ import annotations

import errno
import json
import mmap
import os
from collections.abc import Iterable, Iterator
from contextlib import contextmanager, suppress
from pathlib import Path
from typing import Any

from ropewalk.record.errors import RunError

PARTIAL = ".partial"
DIRECT = getattr(os, "O_DIRECT", 0)
_REASONS = {
    errno.ENOSPC: "there is no space left on the disk",
    errno.EDQUOT: "the disk quota is used up",
    errno.EFBIG: "the file would be larger than is allowed here",
    errno.EROFS: "the disk is read-only",
    errno.EACCES: "there is no permission",
    errno.EPERM: "there is no permission",
    errno.EEXIST: "a part of the path is a file, not a folder",
    errno.ENOTDIR: "a part of the path is a file, not a folder",
    errno.ENAMETOOLONG: "the name is too long",
    errno.ENOENT: "no such file or folder",
}


def reason(error: OSError) -> str:
    """Return what the system refused, in words."""
    known = _REASONS.get(error.errno or 0)
    return known or (error.strerror or str(error)).lower()


@contextmanager
def writing(path: str | Path, more: str = "") -> Iterator[None]:
    """Turn what the system refuses while writing into one RunError about `path`."""
    try:
        yield
    except OSError as error:
        raise RunError(path, f"cannot be written: {reason(error)}{more}") from error


@contextmanager
def reading(path: str | Path) -> Iterator[None]:
    """Turn what goes wrong while reading into one RunError about `path`."""
    try:
        yield
    except FileNotFoundError:
        raise RunError(path, "is missing; a run folder has it") from None
    except OSError as error:
        raise RunError(path, f"cannot be read: {reason(error)}") from error


def write(path: Path, data: bytes | memoryview, *, sync: bool = False) -> None:
    """Write a file in place of the one that is there, if any: readers see the old or the new one.

    With `sync` it has reached the disk before it gets its name. Raises OSError.
    """
    partial = path.with_name(path.name + PARTIAL)
    try:
        with open(partial, "wb", buffering=0) as file:
            view = memoryview(data)
            while len(view):
                view = view[file.write(view) :]
            if sync:
                os.fsync(file.fileno())
        os.replace(partial, path)
    except OSError:
        with suppress(OSError):
            partial.unlink()
        raise


def write_pages(path: Path, pages: mmap.mmap, size: int, *, sync: bool = False) -> None:
    """Write `size` bytes of memory, past the system's cache where that is possible, as `write` does.

    The processor then copies nothing. `pages` are whole pages. Raises OSError.
    """
    partial = path.with_name(path.name + PARTIAL)
    try:
        with open(partial, "wb", buffering=0, opener=_open_direct) as file:
            view = memoryview(pages)
            while len(view):
                view = view[file.write(view) :]
            file.truncate(size)
            if sync:
                os.fsync(file.fileno())
        os.replace(partial, path)
    except OSError as error:
        with suppress(OSError):
            partial.unlink()
        if error.errno != errno.EINVAL or not DIRECT:
            raise
        write(
            path, memoryview(pages)[:size], sync=sync
        )  # on a file system that has only the other way


def _open_direct(path: str, flags: int) -> int:
    return os.open(path, flags | DIRECT, 0o666)


def write_json(path: Path, value: Any, *, indent: int | None = 1, sync: bool = False) -> None:
    """Write JSON in place of the file that is there, if any. Raises OSError.

    Without `indent` it is written many times as fast.
    """
    text = json.dumps(value, indent=indent, ensure_ascii=False, allow_nan=False)
    write(path, text.encode(), sync=sync)


def read_json(path: Path) -> dict[str, Any]:
    """Read a JSON object. Raises RunError."""
    with reading(path):
        data = path.read_bytes()
    try:
        value = json.loads(data)
    except (ValueError, RecursionError):
        raise RunError(path, "is damaged: it holds no JSON") from None
    if not isinstance(value, dict):
        raise RunError(path, "is damaged: it holds no JSON object")
    return value


def sync_all(paths: Iterable[Path]) -> None:
    """Make sure that files (or folders) have reached the disk. Raises OSError."""
    for path in paths:
        handle = os.open(path, os.O_RDONLY)
        try:
            os.fsync(handle)
        finally:
            os.close(handle)
