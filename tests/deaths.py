"""A process that dies, or a disk that is full, at any one of the operations that write files.

Every opening for writing, write, truncation, fsync, rename, removal and new folder is one operation. A write
at which the process dies has written the half of its bytes. After a death nothing is written any more: what
the code does to clean up is not done by a process that is killed.
"""

from __future__ import annotations

import builtins
import errno
import json
import os
from collections.abc import Callable
from contextlib import suppress
from pathlib import Path
from typing import Any

import pytest

PAGE = 4096
replace, rename = os.replace, os.rename


class Killed(BaseException):
    """Stands for the end of the process."""


class Disk:
    """Counts what is written below a folder; ends it at operation number `last`, if there is one.

    With `full` the disk is full from there on: what needs room fails, what needs none goes on.
    """

    def __init__(self, below: Path, last: int = 0, *, full: bool = False) -> None:
        self.below, self.last, self.full = str(below), last, full
        self.done = 0
        self.shown = 0  # the most frames that readers have seen

    def install(self, patch: pytest.MonkeyPatch) -> None:
        """Stand between Python and the system."""
        for name in ("replace", "rename"):
            patch.setattr(os, name, self._named(getattr(os, name), needs_room=False))
        for name in ("unlink", "rmdir"):
            patch.setattr(os, name, self._named(getattr(os, name), needs_room=False))
        patch.setattr(os, "mkdir", self._named(os.mkdir, needs_room=True))
        real_open, real_sync, plain_open = builtins.open, os.fsync, os.open

        def fsync(handle: int) -> None:
            self.step(needs_room=True)
            real_sync(handle)

        def opened(path: Any, mode: str = "r", *args: Any, **more: Any) -> Any:
            if not self._mine(path) or not set(mode) & set("wax+"):
                return real_open(path, mode, *args, **more)
            self.step(needs_room=True)
            return _File(self, real_open(path, mode, *args, **more))

        def opened_plainly(path: Any, flags: int, *args: Any, **more: Any) -> int:
            if self._mine(path) and flags & os.O_CREAT:
                self.step(needs_room=True)
            return plain_open(path, flags, *args, **more)

        patch.setattr(os, "fsync", fsync)
        patch.setattr(builtins, "open", opened)
        patch.setattr(os, "open", opened_plainly)

    def step(self, *, needs_room: bool, torn: Callable[[], object] = lambda: None) -> None:
        """Count an operation; `torn` is what of it is done when it is the last one."""
        self.done += 1
        if not self.last or self.done < self.last:
            return
        if self.done == self.last:
            torn()
        if not self.full:
            raise Killed
        if needs_room:
            raise OSError(errno.ENOSPC, "No space left on device")

    def _mine(self, path: Any) -> bool:
        return not isinstance(path, int) and os.fspath(path).startswith(self.below)

    def _named(self, real: Callable[..., Any], *, needs_room: bool) -> Callable[..., Any]:
        def operation(path: Any, *args: Any, **more: Any) -> Any:
            if not self._mine(path):
                return real(path, *args, **more)
            self.step(needs_room=needs_room)
            found = real(path, *args, **more)
            if real in (replace, rename) and ".new" not in str(
                args[0]
            ):  # what is begun there nobody sees yet
                target = Path(args[0])
                root = target if target.name == "zarr.json" else target / "data.zarr/zarr.json"
                if root.parent.name == "data.zarr":
                    self.shown = max(self.shown, shown_frames(root))
            return found

        return operation


class _File:
    """A file that is open for writing."""

    def __init__(self, disk: Disk, real: Any) -> None:
        self._disk, self._real = disk, real

    def write(self, data: Any) -> Any:
        half = len(data) // 2 // PAGE * PAGE if len(data) > PAGE else len(data) // 2
        self._disk.step(needs_room=True, torn=lambda: self._tear(memoryview(data)[:half]))
        return self._real.write(data)

    def _tear(self, part: memoryview) -> None:
        with suppress(OSError):  # written past the system's cache: whole pages only
            self._real.write(part)

    def truncate(self, size: int) -> Any:
        self._disk.step(needs_room=False)
        return self._real.truncate(size)

    def __getattr__(self, name: str) -> Any:
        return getattr(self._real, name)

    def __enter__(self) -> _File:
        return self

    def __exit__(self, *_: object) -> None:
        self._real.close()


def shown_frames(root: Path) -> int:
    """Return the frames that a store shows, 0 where there is none; a sweep's store has no time."""
    if not root.exists():
        return 0
    arrays = json.loads(root.read_bytes())["consolidated_metadata"]["metadata"]
    return int(arrays["time"]["shape"][0]) if "time" in arrays else 0
