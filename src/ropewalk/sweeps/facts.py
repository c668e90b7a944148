"""What was asked of a sweep, in a file that ends with its own checksum, and in a copy of it."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import google_crc32c

from ropewalk.record.errors import RunError
from ropewalk.record.files import read_json, reading

_KEY = b'"checksum": "'
_TAIL = len(_KEY) + len(' 00000000"\n}')
_UNSEALED = (1, 2)  # formats that had neither checksum nor copy


def _tail(body: bytes) -> bytes:
    return b" " + _KEY + f'{google_crc32c.value(body):08x}"\n}}'.encode()


def sealed(text: str) -> bytes:
    """Return a JSON object with the CRC-32C (hexadecimal) of all that stands before it as its last entry."""
    body = text.rstrip().removesuffix("}").rstrip().encode() + b",\n"
    return body + _tail(body)


def _sound(path: Path) -> dict[str, Any]:
    """Return the facts of a file. Raises RunError when it is missing or not as it was written."""
    facts = read_json(path)
    with reading(path):
        data = path.read_bytes()
    has_seal = _KEY in data[-_TAIL:] or facts.get("format") == _UNSEALED[-1] + 1
    if has_seal and data[-_TAIL:] != _tail(data[:-_TAIL]):
        raise RunError(path, f"is damaged: its {len(data)} bytes do not fit their checksum")
    facts.pop("checksum", None)
    return facts


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
