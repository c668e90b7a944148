"""The log of a run: `events.jsonl`, one JSON object a line, oldest first.

Every event has `at` (the wall clock) and `event`; what happened in the scene has its `time` [s] too; every
line ends with a checksum.
"""

from __future__ import annotations

import json
from pathlib import Path
from typing import Any

from ropewalk.hands.drum import PARTED
from ropewalk.methods.registry import METHODS
from ropewalk.record.facts import BROKE, ROPE_BROKE, now
from ropewalk.record.place import EVENTS as NAME
from ropewalk.record.seal import log_fault, sealed_line

Event = dict[str, Any]
RAN_OFF = "ran off its rope"  # the event of a slide on a rope that has parted
_LAST = 1 << 18  # bytes at the end of a log, in which the line before is looked for


def log(folder: Path, event: str, **more: Any) -> None:
    """Add a line to the log, with its checksum. Raises OSError."""
    line = json.dumps({"at": now(), "event": event, **more}, ensure_ascii=False).encode()
    with open(folder / NAME, "ab+", buffering=0) as file:
        file.seek(max(0, file.tell() - _LAST))
        last = file.read()
        begun = last and not last.endswith(b"\n")  # the process was killed in the middle of a line
        file.write((b"\n" if begun else b"") + sealed_line(line, last) + b"\n")


def fault_of(folder: Path) -> str:
    """Say what is wrong with the log; "" where nothing is, or there is none."""
    try:
        return log_fault((folder / NAME).read_bytes())
    except OSError:
        return ""


def read_events(folder: Path) -> tuple[Event, ...]:
    """Read the log; lines that a kill has torn are left out, and what a resumed run told again."""
    try:
        lines = (folder / NAME).read_bytes().splitlines()
    except OSError:
        return ()
    found: list[Event] = []
    told: list[Event] = []
    for line in lines:
        try:
            event = json.loads(line)
        except (ValueError, RecursionError):
            continue
        if not isinstance(event, dict) or not isinstance(event.get("event"), str):
            continue
        event.pop("checksum", None)
        if _is_of_the_scene(event):
            what = {key: value for key, value in event.items() if key != "at"}
            if what in told:
                continue
            told.append(what)
        found.append(event)
    return tuple(found)


def until(events: tuple[Event, ...], time: float, method: str) -> tuple[Event, ...]:
    """Leave out what happened in the scene after a frame of a time [s], by a method of integration.

    A killed run has told of what was never committed; one that is resumed simulates it again. `adaptive`
    parts, at that very time, after the frame.
    """
    late = () if METHODS[method].fixed else (PARTED, RAN_OFF)

    def is_in(event: Event) -> bool:
        at = float(event.get("time", 0.0))
        return at < time or (at == time and event["event"] not in late)

    return tuple(event for event in events if not _is_of_the_scene(event) or is_in(event))


def _is_of_the_scene(event: Event) -> bool:
    named = bool({"anchor", "winch", "segment", "slide"} & event.keys())
    return named or event["event"] in (BROKE, ROPE_BROKE)
