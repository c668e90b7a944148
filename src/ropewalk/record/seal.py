"""Checksums of what is text in a folder: JSON files end with their own, and so does every line of the log."""

from __future__ import annotations

import json
import re
from collections.abc import Callable
from pathlib import Path
from typing import Any

from ropewalk.record.errors import RunError
from ropewalk.record.files import read_json, reading, write

_KEY = b'"checksum": "'
_TAIL = len(_KEY) + len(' 00000000"\n}')
_LINE = re.compile(rb'(.*), "checksum": "([0-9a-f]{8})"}', re.DOTALL)


def _crc(data: bytes) -> bytes:
    import google_crc32c

    return b"%08x" % google_crc32c.value(data)


def crc_of(value: Any) -> str:
    """Return the CRC-32C (hexadecimal) of what JSON can hold, however it was laid out."""
    return _crc(json.dumps(value, sort_keys=True).encode()).decode()


def _tail(body: bytes) -> bytes:
    return b" " + _KEY + _crc(body) + b'"\n}'


def sealed(text: str) -> bytes:
    """Return a JSON object with the CRC-32C (hexadecimal) of all that stands before it as its last entry."""
    body = text.rstrip().removesuffix("}").rstrip().encode() + b",\n"
    return body + _tail(body)


def write_sealed(path: Path, value: dict[str, Any], *, sync: bool = False) -> None:
    """Write a JSON object with its checksum in place of the file that is there, if any. Raises OSError."""
    text = json.dumps(value, indent=1, ensure_ascii=False, allow_nan=False)
    write(path, sealed(text), sync=sync)


def read_sealed(path: Path, must: Callable[[dict[str, Any]], bool]) -> dict[str, Any]:
    """Read a JSON object, without the checksum that it has, or `must` have by what it says of itself.

    Raises RunError when it is missing or not as it was written.
    """
    facts = read_json(path)
    with reading(path):
        data = path.read_bytes()
    if (_KEY in data[-_TAIL:] or must(facts)) and data[-_TAIL:] != _tail(data[:-_TAIL]):
        raise RunError(path, f"is damaged: its {len(data)} bytes do not fit their checksum")
    facts.pop("checksum", None)
    return facts


def sealed_line(line: bytes, log: bytes) -> bytes:
    """Return a JSON object in one line with a checksum of it and of the line before it in `log`.

    The log's last lines are enough. So a line that is lost between two others is found too.
    """
    before = next(
        (found[2] for found in map(_LINE.fullmatch, reversed(log.split(b"\n"))) if found), b""
    )
    body = line.removesuffix(b"}")
    return body + b', "checksum": "' + _crc(before + body) + b'"}'


def log_fault(log: bytes) -> str:
    """Say which lines of a log are not as they were written; "" where all are."""
    wrong = faulty_lines(log)
    if not wrong:
        return ""
    lines = ", ".join(map(str, wrong[:8])) + (" ..." if len(wrong) > 8 else "")
    return f"is damaged: lines that do not fit their checksums: {lines}"


def faulty_lines(log: bytes) -> list[int]:
    """Return the numbers (from 1) of the lines of a log that are not as they were written.

    A beginning of a line that a kill has torn is none of them: the next one was written as if it were not
    there. A line that was lost at the end is not found.
    """
    faults, before = [], b""
    *lines, rest = log.split(b"\n")
    for number, line in enumerate([*lines, rest] if rest else lines, 1):
        if found := _LINE.fullmatch(line):
            if _crc(before + found[1]) != found[2]:
                faults.append(number)
            before = found[2]
        elif number == len(lines) and not rest:  # it has its end, and so was whole
            faults.append(number)
    return faults
