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


class Asked(NamedTuple):
    """A command that waits until it is built, and `also` other resets that are done with it."""

    item: Item
    also: list[Item]


class Opening:
    """Builds one thing at a time; a scene takes the place of all that waits, resets wait or join one."""

    def __init__(self, session: Session, wake: Callable[[], None]) -> None:
        self._session, self._wake = session, wake
        self._now: Opened | None = None
        self._next: list[Asked] = []  # of scenes one at most

    @property
    def clients(self) -> dict[int, frozenset[str]]:
        """The pages whose scene is on its way, each with the types of commands that do not wait for it.

        What they send else is meant for that scene; hands may go on until a reset is there.
        """
        found: dict[int, frozenset[str]] = {}
        for one in self._all:
            for item in (one.item, *one.also):
                passes = OF_PLAY | OF_HANDS if isinstance(item.what, Reset) else OF_PLAY
                found[item.client] = passes & found.get(item.client, passes)
        return found

    @property
    def words(self) -> str:
        """What is on its way, or ""."""
        return next((WORDS[one.item.what.type] for one in self._all), "")

    @property
    def _all(self) -> list[Asked | Opened]:
        """What is built now, then what waits."""
        return [*([self._now] if self._now is not None else []), *self._next]

    @staticmethod
    def takes(command: Command, session: Session) -> bool:
        """Tell whether a command is carried out by way of this."""
        settles = isinstance(command, Reset) and Anew.of(session, original=True).settles
        return isinstance(command, SceneCommand) or settles

    def ask(self, item: Item) -> None:
        """Have built what a command asks for."""
        if isinstance(item.what, Reset):
            for one in self._all:  # one that gives back all constants does for another, too
                if isinstance(one.item.what, Reset) and one.item.what.all >= item.what.all:
                    one.also.append(item)
                    return
        else:
            for one in self._next:
                for left_out in (one.item, *one.also):
                    _leave_out(left_out)
            self._next.clear()
        self._next.append(Asked(item, []))
        self._begin()

    def take(self) -> Opened | None:
        """Return what is ready, once: a reset only while the session would still begin with it."""
        self._begin()  # what waits is built of the session as the one before has left it
        found = self._now
        if found is None or not found.made.done():
            return None
        self._now = None
        if found.anew is not None and found.anew != _anew(self._session, found.item.what):
            self._now = self._job(found.item, found.also)  # a constant was changed meanwhile
            return None
        return found

    def _begin(self) -> None:
        if self._now is None and self._next:
            self._now = self._job(*self._next.pop(0))

    def _job(self, item: Item, also: list[Item]) -> Opened:
        command, anew = item.what, None
        if isinstance(command, Reset):
            anew = _anew(self._session, command)
            what = partial(_begun, command, anew)
        else:
            what = partial(_open, command, self._session.start)
        return Opened(item, aside(what, "opening", self._wake), anew, also)


def _leave_out(item: Item) -> None:
    """Tell who asked for it that a scene has taken its place."""
    command = item.what
    since = "another scene has been asked for since"
    if isinstance(command, Reset):
        rule = f"{since}, so the reset is left out: once that scene is there, reset it if you still want to"
        error = refusal("type", command.type, rule)
    else:
        rule = f"{since}, so this one is not opened: open it again if you still want it"
        error = refusal("scene", command.preset, rule)
    item.reply(error_message(command.type, command.id, error))


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
