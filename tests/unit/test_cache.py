"""The cache of compiled kernels: what is damaged in it is compiled anew, what is sound in it is used."""

from __future__ import annotations

import errno
from collections.abc import Callable
from pathlib import Path
from typing import Any

import pytest

from ropewalk.core import cache
from ropewalk.core.jit import kernel, small


def squares(n):
    """Return the sum of the squares below n."""
    total = 0
    for i in range(n):
        total += i * i
    return total


@pytest.fixture
def folder(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    """An empty cache folder, not made yet, of which nothing has been said."""
    found = tmp_path / "cache" / ("0" * 16)
    monkeypatch.setattr(cache, "cache_folder", lambda: found)
    cache._warn.cache_clear()
    return found


def used() -> tuple[int, int]:
    """Call the kernel as a new process would; return how often the cache had it and had it not."""
    compiled = kernel(squares)
    assert compiled(5) == 30
    stats = compiled.stats
    return sum(stats.cache_hits.values()), sum(stats.cache_misses.values())


def test_what_kernels_take_in_is_kept_where_python_calls_it(folder: Path) -> None:
    """Every process compiled it again: 3.7 s before the first wrap was found."""
    for kept in (0, 1):
        compiled = small(squares)
        assert compiled(5) == 30
        stats = compiled.stats
        assert (sum(stats.cache_hits.values()), sum(stats.cache_misses.values())) == (
            kept,
            1 - kept,
        )


def files(folder: Path) -> dict[str, Path]:
    """Return the only index and the only data file of the entry, by their endings."""
    mine = [path for path in folder.iterdir() if "-inner." not in path.name]
    found = {path.suffix: path for path in mine}
    assert sorted(found) == [".nbc", ".nbi"]
    assert len(mine) == 2
    return found


def flip(data: bytes) -> bytes:
    """Return the data with one bit of the middle changed."""
    changed = bytearray(data)
    changed[len(changed) // 2] ^= 4
    return bytes(changed)


DAMAGES: dict[str, Callable[[bytes], bytes]] = {
    "empty": lambda data: b"",
    "cut": lambda data: data[: len(data) // 2],
    "garbage": lambda data: b"\x93not a pickle" * 20,
    "one bit": flip,
}


@pytest.mark.parametrize("damage", DAMAGES)
@pytest.mark.parametrize("kind", [".nbi", ".nbc"])
def test_a_damaged_file_is_compiled_anew(folder: Path, kind: str, damage: str) -> None:
    assert used() == (0, 1)
    assert used() == (1, 0)
    path = files(folder)[kind]
    path.write_bytes(DAMAGES[damage](path.read_bytes()))
    assert used() == (0, 1)
    assert used() == (1, 0)


def test_a_lost_data_file_is_compiled_anew(folder: Path) -> None:
    used()
    files(folder)[".nbc"].unlink()
    assert used() == (0, 1)
    assert used() == (1, 0)
    files(folder)


@pytest.mark.parametrize("number", [errno.EROFS, errno.ENOSPC, errno.EACCES])
def test_a_folder_that_takes_nothing_is_read_and_named(
    folder: Path, number: int, monkeypatch: pytest.MonkeyPatch, recwarn: pytest.WarningsRecorder
) -> None:
    used()

    def refuse(*_: Any) -> None:
        raise OSError(number, "No space left on device", "a file")

    monkeypatch.setattr(cache._CheckedFiles, "_open_for_write", refuse)
    assert used() == (1, 0)  # what is valid is used, without a word
    assert not recwarn.list
    files(folder)[".nbc"].unlink()
    assert used() == (0, 1)
    assert used() == (0, 1)
    (said,) = [str(one.message) for one in recwarn if one.category is cache.CacheWarning]
    assert said.startswith(f"{folder}: compiled kernels cannot be kept there: no space left")


def test_a_folder_that_cannot_be_made_is_named(folder: Path) -> None:
    folder.parent.write_text("a file where the folder should be")
    with pytest.warns(cache.CacheWarning, match="cannot be kept there: not a directory"):
        assert used() == (0, 1)


def test_only_old_caches_go(folder: Path) -> None:
    others = [f"{i:016x}" for i in range(1, 8)]
    for name in [*others, "letters", "0123456789abcdef0"]:
        (folder.parent / name).mkdir(parents=True)
    used()
    left = {path.name for path in folder.parent.iterdir()}
    assert {"letters", "0123456789abcdef0", folder.name} <= left
    assert len(left) == 2 + cache.KEPT_CACHES
