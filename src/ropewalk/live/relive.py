"""Replaying a session from its log, without any page, to the same bits."""

from __future__ import annotations

from contextlib import suppress
from pathlib import Path
from typing import Any

from ropewalk.live.commands import parse
from ropewalk.live.keeper import parts
from ropewalk.live.session import Break, Session
from ropewalk.record.errors import RunError
from ropewalk.record.event_log import read_events
from ropewalk.record.folder import read_scene
from ropewalk.record.place import EVENTS as NAME
from ropewalk.record.result import Result
from ropewalk.scene import SceneError


def relive(folder: Path) -> Session:
    """Return the session of a run folder, played again to its end, to the same bits.

    Raises RunError when the folder holds none, or it does not fit this version's commands.
    """
    scene, events = read_scene(folder), read_events(folder)
    begun = [event for event in events if event.get("event") == "session"]
    if not begun:
        raise RunError(folder, "is no live session: its log has no commands to play again")
    try:
        session = Session(scene, begun[0].get("preset"))
        for event in events:
            _replay(session, event)
        if session.broken is None and events[-1].get("event") != "ended":
            with suppress(RunError):  # of frames that are damaged: as far as the log goes
                _go_on(session, folder)
    except (SceneError, KeyError, TypeError) as error:
        raise RunError(folder / NAME, f"cannot be played again: {error}") from None
    return session


def _go_on(session: Session, folder: Path) -> None:
    """Go on to the last frame that was kept: a session that was killed has none of its own end in its log."""
    until = float(Result.open(parts(folder)[-1]).time[-1])
    steps = round((until - session.time) / session.main.dt)
    if steps > 0:
        session.advance(steps)


def _replay(session: Session, event: dict[str, Any]) -> None:
    kind = event.get("event")
    if kind not in ("command", "broken", "ended"):
        return
    steps = int(event["step"]) - session.count
    if steps > 0:
        session.broken = None  # it went on, so the break was over
        session.advance(steps)
    if kind == "broken":
        session.broken = Break(int(event["variant"]), 1)
    elif kind == "command":
        session.apply(parse(event["command"]), int(event["client"]))
