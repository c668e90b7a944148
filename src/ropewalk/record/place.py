"""Where a run goes: a folder that appears whole, already locked, and never in place of what others made."""

from __future__ import annotations

import os
import shutil
import uuid
from collections.abc import Iterator
from contextlib import ExitStack, contextmanager
from pathlib import Path

from ropewalk.record.errors import RunError
from ropewalk.record.files import reason, writing
from ropewalk.record.lock import NAME as LOCK
from ropewalk.record.lock import is_locked, locked

SCENE, PROVENANCE, STATUS = "scene.toml", "provenance.json", "status.json"
DATA, CHECKPOINT, EVENTS = "data.zarr", "checkpoint.npz", "events.jsonl"
BEYOND = "beyond.npz"
PARTS = (SCENE, PROVENANCE, STATUS, DATA, CHECKPOINT, BEYOND, EVENTS, LOCK)
NOTHING = "; nothing was kept"


def is_run(folder: Path) -> bool:
    """Tell whether a folder looks like a run folder."""
    return (folder / PROVENANCE).is_file() and (folder / DATA).is_dir()


def check_free(folder: Path, overwrite: bool) -> None:
    """Raise RunError when a run must not be written to `folder`."""
    try:
        if not folder.exists() and not folder.is_symlink():
            return
        if not folder.is_dir():
            raise RunError(folder, "is a file; a run needs a folder of its own")
        entries = list(folder.iterdir())
    except OSError as error:
        raise RunError(folder, f"cannot be written: {reason(error)}") from None
    if not entries:
        return
    if not is_run(folder):
        raise RunError(folder, "exists and is no run folder; a run never replaces other files")
    if is_locked(folder):
        raise RunError(folder, "is being written by another process; choose another folder")
    if not overwrite:
        raise RunError(
            folder,
            "holds a run already; choose another folder, or allow to overwrite (overwrite=True)",
        )


@contextmanager
def new_folder(folder: Path, overwrite: bool, held: ExitStack | None = None) -> Iterator[Path]:
    """Give an empty folder to fill, which then appears as `folder`, whole and locked.

    The lock is handed over to `held`, else dropped. In place of an old run only the run's own files go;
    others that lie there stay. Of several that write to one folder at once, one wins. Raises RunError.
    """
    check_free(folder, overwrite)
    given, folder = folder, Path(os.path.abspath(folder.resolve()))
    made = _beside(folder, "new")
    with writing(given):
        folder.parent.mkdir(parents=True, exist_ok=True)
        made.mkdir()
    try:
        with ExitStack() as stack, writing(given, NOTHING):
            stack.enter_context(locked(made, given))
            yield made
            _put_in_place(made, folder, given, overwrite)
            if held is not None:
                held.enter_context(stack.pop_all())
    finally:
        shutil.rmtree(made, ignore_errors=True)


def _beside(folder: Path, kind: str) -> Path:
    """Return a hidden name beside a folder that nobody else uses."""
    return folder.with_name(f".{folder.name[:200]}.{uuid.uuid4().hex[:12]}.{kind}")


def _put_in_place(made: Path, folder: Path, given: Path, overwrite: bool) -> None:
    """Rename `made` to `folder`. Raises RunError when that is taken, OSError from the system."""
    try:
        os.rename(made, folder)  # where there is nothing, or an empty folder
        return
    except OSError:
        if not folder.exists():
            raise
    check_free(given, overwrite)
    with locked(folder, given):
        old = _beside(folder, "old")
        os.rename(folder, old)
        try:
            os.rename(made, folder)
        except OSError:
            if not folder.exists():
                os.rename(old, folder)
                raise
            _move_others(old, folder)  # another run took the place in between: that one stays
            check_free(given, overwrite=False)
            raise
        _move_others(old, folder)


def _move_others(old: Path, folder: Path) -> None:
    """Move what is not a run's own from an old run folder to the new one; drop the rest."""
    for entry in list(old.iterdir()):
        if entry.name not in PARTS:
            os.rename(entry, folder / entry.name)
    shutil.rmtree(old)
