"""Who writes a run folder: a lock that the system drops when its holder dies."""

from __future__ import annotations

import os
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import Any

from ropewalk.record.errors import RunError

fcntl: Any
try:
    import fcntl
except ImportError:  # pragma: no cover - not a POSIX system
    fcntl = None

NAME = ".lock"
_REMEDY = ": wait until it is done, or end it first"
PATIENCE = 0.2  # [s]; one who asks whether a folder is locked holds it for a moment himself


@contextmanager
def locked(folder: Path, name: str | Path = "") -> Iterator[None]:
    """Hold a folder's lock, wherever it is moved. Raises OSError from the system.

    Raises RunError, about `name` if given, when another process has it.
    """
    from filelock import FileLock, Timeout  # slow to import; who only reads has no need of it

    lock = FileLock(folder / NAME, timeout=PATIENCE, thread_local=False, mode=0o644)
    try:
        lock.acquire(poll_interval=0.01)
    except Timeout:
        raise RunError(name or folder, f"is being written by another process{_REMEDY}") from None
    try:
        yield
    finally:
        lock.release()


def is_locked(folder: Path) -> bool:
    """Tell whether a process writes the folder now."""
    if fcntl is None:  # pragma: no cover - not a POSIX system
        return _is_held(folder)
    try:
        handle = os.open(folder / NAME, os.O_RDONLY)  # as one who may not write there can
    except OSError:
        return False
    try:
        fcntl.flock(handle, fcntl.LOCK_SH | fcntl.LOCK_NB)
    except OSError:
        return True
    finally:
        os.close(handle)
    return False


def _is_held(folder: Path) -> bool:
    if not (folder / NAME).exists():
        return False
    try:
        with locked(folder):
            return False
    except RunError:
        return True
    except OSError:
        return False
