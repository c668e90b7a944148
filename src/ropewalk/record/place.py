"""Where a run goes: a folder that appears whole, already locked, and never in place of what others made."""

from __future__ import annotations

import json
import os
import re
import shutil
import time
import uuid
from collections.abc import Iterator
from contextlib import ExitStack, contextmanager, suppress
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
_REPLACED = ".replaced-"  # a folder in a run folder: what was there before, while it is replaced
_LEFT = re.compile(r"[0-9a-f]{12}\.new")
_PART = re.compile(r"part-\d+")  # of a live session, a run of its own
_LEFT_ALONE = 60.0  # [s] after which an unlocked hidden folder belongs to nobody any more
_RENAMES_LOCKED = os.name != "nt"  # Windows renames no folder in which a file is open


def session_folder(folder: Path) -> Path:
    """Return the folder of the live session that a run is a further part of, else the run's own."""
    further = _PART.fullmatch(folder.name) and is_run(folder.parent)
    return folder.parent if further else folder


def _is_part(folder: Path) -> bool:
    """Tell whether a folder holds a further part of a live session; another run may have its name."""
    if not _PART.fullmatch(folder.name) or not is_run(folder):
        return False
    try:
        return json.loads((folder / PROVENANCE).read_text(encoding="utf-8")).get("live") is True
    except (OSError, ValueError, AttributeError):
        return False


def is_run(folder: Path) -> bool:
    """Tell whether a folder looks like a run folder."""
    return (folder / PROVENANCE).is_file() and (folder / DATA).is_dir()


def _half_replaced(folder: Path) -> list[Path]:
    """Return what deaths have left in a folder while a run there was being replaced."""
    return [entry for entry in folder.iterdir() if entry.name.startswith(_REPLACED)]


def check_free(folder: Path, overwrite: bool, *, mine: bool = False) -> None:
    """Raise RunError when a run must not be written to `folder`; `mine`: its lock is the caller's."""
    try:
        if not folder.exists() and not folder.is_symlink():
            return
        if not folder.is_dir():
            raise RunError(folder, "is a file; a run needs a folder of its own")
        entries = list(folder.iterdir())
    except OSError as error:
        raise RunError(folder, f"cannot be written: {reason(error)}") from None
    if not mine and is_locked(folder):
        raise RunError(folder, "is being written by another process; choose another folder")
    if all(entry.name == LOCK for entry in entries):
        return
    if not is_run(folder) and not any(entry.name.startswith(_REPLACED) for entry in entries):
        raise RunError(folder, "exists and is no run folder; a run never replaces other files")
    if not overwrite:
        raise RunError(
            folder,
            "holds a run already; choose another folder, or allow to overwrite (overwrite=True)",
        )


@contextmanager
def new_folder(folder: Path, overwrite: bool, held: ExitStack | None = None) -> Iterator[Path]:
    """Give an empty folder to fill, which then appears as `folder`, whole and locked.

    The lock is handed over to `held`, else dropped. In place of an old run only the run's own files go;
    others that lie there are never moved. Of several that write to one folder at once, one wins. Raises
    RunError.
    """
    check_free(folder, overwrite)
    given, folder = folder, Path(os.path.abspath(folder.resolve()))
    made = folder.with_name(f".{folder.name[:200]}.{uuid.uuid4().hex[:12]}.new")
    with writing(given):
        folder.parent.mkdir(parents=True, exist_ok=True)
        _sweep_up(folder)
        made.mkdir()
    try:
        with ExitStack() as stack, writing(given, NOTHING):
            stack.enter_context(locked(made, given))
            yield made
            _put_in_place(made, folder, given, overwrite, stack)
            if held is not None:
                held.enter_context(stack.pop_all())
    finally:
        shutil.rmtree(made, ignore_errors=True)


def _sweep_up(folder: Path) -> None:
    """Remove the hidden folders that processes which died have left beside `folder`."""
    begins = f".{folder.name[:200]}."
    with suppress(OSError):
        for entry in list(folder.parent.iterdir()):
            name = entry.name
            if not (name.startswith(begins) and _LEFT.fullmatch(name[len(begins) :])):
                continue
            old = time.time() - entry.stat().st_mtime > _LEFT_ALONE
            if old and not is_locked(entry) and {e.name for e in entry.iterdir()} <= set(PARTS):
                shutil.rmtree(entry, ignore_errors=True)


def _put_in_place(made: Path, folder: Path, given: Path, overwrite: bool, stack: ExitStack) -> None:
    """Let `made`, whose lock `stack` holds, become `folder`, and `stack` hold the lock of that.

    Raises RunError when the place is taken, OSError from the system.
    """
    if _RENAMES_LOCKED:
        try:
            os.rename(made, folder)  # where there is nothing, or an empty folder
            return
        except OSError:
            if not folder.exists():
                raise
    else:
        with suppress(FileExistsError):
            folder.mkdir()
    check_free(given, overwrite)
    with stack.pop_all():  # the lock of `made` goes, that of the folder comes
        stack.enter_context(locked(folder, given))
    check_free(given, overwrite, mine=True)
    _replace(made, folder)


def _replace(made: Path, folder: Path) -> None:
    """Move the parts of a run from `made` to a folder whose lock is held, in place of those there.

    Nothing else there is touched. While it lasts the folder is no run, and the marks of it say that it
    is being replaced: who dies in it leaves a folder that may be overwritten.
    """
    away = folder / f"{_REPLACED}{uuid.uuid4().hex[:12]}"
    away.mkdir()
    moved: list[tuple[Path, Path]] = []

    def move(source: Path, target: Path) -> None:
        if source.exists() or source.is_symlink():
            os.rename(source, target)
            moved.append((source, target))

    parts = [part for part in PARTS if part not in (LOCK, PROVENANCE)]
    of_session = [one.name for one in folder.iterdir() if _is_part(one)]
    try:
        for part in (PROVENANCE, *parts, *of_session):
            move(folder / part, away / part)
        for part in (*parts, PROVENANCE):
            move(made / part, folder / part)
    except OSError:
        for source, target in reversed(moved):
            with suppress(OSError):
                os.rename(target, source)
        with suppress(OSError):
            away.rmdir()
        raise
    for old in _half_replaced(folder):
        shutil.rmtree(old, ignore_errors=True)
