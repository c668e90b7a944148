"""What was asked of a sweep, in a file that ends with its own checksum, and in a copy of it."""

from __future__ import annotations

from pathlib import Path
from typing import Any

from ropewalk.record.errors import RunError
from ropewalk.record.seal import read_sealed

_SEALED = 3  # the format from which on there are checksum and copy


def _sound(path: Path) -> dict[str, Any]:
    """Return the facts of a file. Raises RunError when it is missing or not as it was written."""
    return read_sealed(path, _must_be_sealed)


def _must_be_sealed(facts: dict[str, Any]) -> bool:
    version = facts.get("format")
    return isinstance(version, int) and version >= _SEALED


def fault(path: Path) -> str:
    """Return what is wrong with a file of facts, "" when it is as it was written."""
    if not path.exists():
        return "it is missing"
    try:
        _sound(path)
    except RunError as error:
        return error.rule.removeprefix("is damaged: ")
    return ""


def read_facts(path: Path, copy: Path) -> dict[str, Any]:
    """Return what was asked, from the copy where the file is damaged.

    Raises RunError when both are damaged, or are of two sweeps.
    """
    why, copy_why = fault(path), fault(copy)
    if why and copy_why:
        rule = (
            f"is damaged ({why}), and its copy {copy} too ({copy_why}): what was asked is lost; put back a "
            "file of your own copies, or make the sweep anew (plain xarray may still read data.zarr)"
        )
        raise RunError(path, rule)
    if why or copy_why:
        return _sound(copy if why else path)
    facts = _sound(path)
    if _sound(copy).get("id") != facts.get("id"):
        rule = f"and its copy {copy} are of two sweeps; remove the one that does not belong here"
        raise RunError(path, rule)
    return facts
