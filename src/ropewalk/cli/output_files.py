"""Writing files whole or not at all, and never over another without being told to."""

from __future__ import annotations

import os
import tempfile
from collections.abc import Iterator
from contextlib import contextmanager, suppress
from pathlib import Path

from ropewalk.cli.console import warn
from ropewalk.cli.failures import Refusal

#: What commands make of a run or a sweep, in its folder.
_MADE = ("figures", "csv", "parquet", "run.npz", "vtk", "page.html", "movie.gif")


def refuse_existing(path: Path, *, overwrite: bool = False) -> None:
    """Raise Refusal when there is something at `path` already, or it cannot be a file."""
    if path.is_dir():
        raise Refusal(f"{path}: is a folder; name a file in it")
    if path.exists() and not overwrite:
        raise Refusal(f"{path}: exists already; take another name, or give --overwrite")
    refuse_parent(path)


def refuse_parent(path: Path) -> None:
    """Raise Refusal when a part of the way to `path` is a file."""
    for parent in path.parents:
        if parent.is_dir():
            return
        if parent.exists():
            raise Refusal(f"{path}: {parent} is a file, not a folder")


def write_new(path: Path, text: str, *, overwrite: bool = False) -> None:
    """Write a text file, through a partial one beside it, so that it is there whole or not at all.

    Raises Refusal when it exists, OSError when it cannot be written.
    """
    refuse_existing(path, overwrite=overwrite)
    path.parent.mkdir(parents=True, exist_ok=True)
    handle, partial = tempfile.mkstemp(prefix=f".{path.name[:40]}-", dir=path.parent)
    try:
        with os.fdopen(handle, "w", encoding="utf-8", newline="\n") as file:
            file.write(text)
        Path(partial).chmod(0o666 & ~_umask())
        Path(partial).replace(path)
    except BaseException:
        Path(partial).unlink(missing_ok=True)
        raise


def _umask() -> int:
    mask = os.umask(0)
    os.umask(mask)
    return mask


def warn_of_left(folder: Path, what: str, but: str = "") -> None:
    """Warn of what was made of the run (or sweep, `what`) that was overwritten, and stays.

    `but` is a figure that was made anew, or is about to be.
    """
    left = [name for name in _MADE if (folder / name).exists()]
    if but and "figures" in left and {one.name for one in (folder / "figures").iterdir()} <= {but}:
        left.remove("figures")
    if left:
        warn(f"{folder}: {', '.join(left)} may be of the {what} before: make them anew")


@contextmanager
def claimed(output: Path | None, parent: Path, name: str) -> Iterator[Path]:
    """Give the folder to write to: `output`, or a new one, `parent`/`name`-1, -2 and so on.

    A new one is made at once, so that two processes never take the same; it goes again when
    nothing was put into it. Raises OSError when it cannot be made.
    """
    if output is not None:
        yield output
        return
    made_parent = not parent.exists()
    parent.mkdir(parents=True, exist_ok=True)
    number = 1
    while True:
        folder = parent / f"{name}-{number}"
        try:
            folder.mkdir()
            break
        except FileExistsError:
            number += 1
    try:
        yield folder
    finally:
        with suppress(OSError):  # not empty: there is something to keep
            folder.rmdir()
            if made_parent:
                parent.rmdir()


def free_name(path: Path) -> Path:
    """Return `path`, or with a number before its ending the first that does not exist."""
    number, found = 1, path
    while found.exists():
        number += 1
        found = path.with_name(f"{path.stem}-{number}{path.suffix}")
    return found
