"""What is built beside the broadcast while the scene plays on: other scenes, and rest for a reset."""

from __future__ import annotations

from collections.abc import Callable
from concurrent.futures import Future
from functools import partial
from typing import NamedTuple

from ropewalk.live.actions import begin_anew, opened
from ropewalk.live.anew import Anew
from ropewalk.live.aside import aside
from ropewalk.live.commands import Command, Reset, SceneCommand
from ropewalk.live.inbox import Item
from ropewalk.live.messages import error_message
from ropewalk.live.parameters import refusal
from ropewalk.live.reading import read_apart
from ropewalk.live.session import Session
from ropewalk.live.sources import Start
from ropewalk.simulation.warming import warm_up

Ready = Callable[[Session], str]  # puts in place what was built
OF_PLAY = frozenset(["play", "pause", "speed", "listen"])
# Hands send these many times a second.
OF_HANDS = frozenset(["drag", "drop", "move", "obstacle", "grab", "let_go", "kick", "listen"])
WORDS = {
    "reset": "Looking for the ropes' rest from which they begin: it may take ten seconds or more …",
    "scene": "Opening the scene …",
}


class Opened(NamedTuple):
    """What is ready, or its error; the command that asked for it, and what a reset begins with."""

    item: Item
    made: Future[Ready]
    anew: Anew | None
    also: list[Item]  # other resets, which are done with that


class Opening:
    """Builds one thing at a time; of those that wait meanwhile only the newest is built next."""

    def __init__(self, session: Session, wake: Callable[[], None]) -> None:
        self._session, self._wake = session, wake
        self._now: Opened | None = None
        self._next: Item | None = None

    @property
    def clients(self) -> dict[int, frozenset[str]]:
        """The pages whose scene is on its way, each with the types of commands that do not wait for it.

        What they send else is meant for that scene; hands may go on until a reset is there.
        """
        found: dict[int, frozenset[str]] = {}
        for item in (*([self._now.item, *self._now.also] if self._now else []), self._next):
            if item is not None:
                passes = OF_PLAY | OF_HANDS if isinstance(item.what, Reset) else OF_PLAY
                found[item.client] = passes & found.get(item.client, passes)
        return found

    @property
    def words(self) -> str:
        """What is on its way, or ""."""
        return WORDS[self._now.item.what.type] if self._now is not None else ""

    @staticmethod
    def takes(command: Command, session: Session) -> bool:
        """Tell whether a command is carried out by way of this."""
        settles = isinstance(command, Reset) and Anew.of(session, original=True).settles
        return isinstance(command, SceneCommand) or settles

    def ask(self, item: Item) -> None:
        """Have built what a command asks for."""
        now, command = self._now, item.what
        again = now is not None and isinstance(command, Reset) and isinstance(now.item.what, Reset)
        if now is not None and again and self._next is None and command.all == now.item.what.all:
            now.also.append(item)
            return
        if self._next is not None:
            was = self._next.what
            preset = getattr(was, "preset", None)
            error = refusal("scene", preset, "another scene has been asked for since")
            self._next.reply(error_message(was.type, was.id, error))
        self._next = item
        self._begin()

    def take(self) -> Opened | None:
        """Return what is ready, once: a reset only while the session would still begin with it."""
        found = self._now
        if found is None or not found.made.done():
            return None
        self._now = None
        if found.anew is not None and found.anew != _anew(self._session, found.item.what):
            self._now = self._job(found.item, found.also)  # a constant was changed meanwhile
            return None
        self._begin()
        return found

    def _begin(self) -> None:
        if self._now is None and self._next is not None:
            item, self._next = self._next, None
            self._now = self._job(item, [])

    def _job(self, item: Item, also: list[Item]) -> Opened:
        command, anew = item.what, None
        if isinstance(command, Reset):
            anew = _anew(self._session, command)
            what = partial(_begun, command, anew)
        else:
            what = partial(_open, command, self._session.start)
        return Opened(item, aside(what, "opening", self._wake), anew, also)


def _anew(session: Session, command: Reset) -> Anew:
    return Anew.of(session, original=command.all)


def _begun(command: Reset, anew: Anew) -> Ready:
    made = anew.tracks()
    for track in made:
        warm_up(track.simulation)
    return lambda session: begin_anew(session, command, made)


def _open(command: SceneCommand, start: Start) -> Ready:
    made = opened(Session, command, start, read_apart)
    warm_up(made.main.simulation)

    def put(session: Session) -> str:
        session.adopt(made)
        return ""

    return put
