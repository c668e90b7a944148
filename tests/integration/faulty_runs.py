"""Runs to damage: a disk that gets full, files that are changed."""

from __future__ import annotations

import json
from collections.abc import Callable
from pathlib import Path

import pytest

from ropewalk.record.seal import write_sealed


def fill_disk(monkeypatch: pytest.MonkeyPatch, after: int) -> None:
    """Let the disk be full after so many written chunk files."""
    from ropewalk.record import store

    seen = 0

    def filling(real: Callable[..., None]) -> Callable[..., None]:
        def write(path: Path, *data: object, **more: object) -> None:
            nonlocal seen
            seen += 1
            if seen > after:
                raise OSError(28, "No space left on device", str(path))
            real(path, *data, **more)

        return write

    monkeypatch.setattr(store, "write", filling(store.write))
    monkeypatch.setattr(store, "write_pages", filling(store.write_pages))


def edit(path: Path, key: str, value: object) -> None:
    """Change one value of a JSON file, and its checksum with it."""
    found = json.loads(path.read_text()) | {key: value}
    found.pop("checksum")
    write_sealed(path, found)


def flip(path: Path, place: int) -> None:
    """Change one bit of a file."""
    data = bytearray(path.read_bytes())
    data[place % len(data)] ^= 1 << (place % 8)
    path.write_bytes(data)
