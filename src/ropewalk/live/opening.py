"""Scenes on their way into the broadcast: read, built and compiled beside it, while the present one plays."""

from __future__ import annotations

from collections.abc import Callable
from concurrent.futures import Future
from functools import partial
from typing import NamedTuple

from ropewalk.live.actions import opened
from ropewalk.live.aside import aside
from ropewalk.live.commands import SceneCommand
from ropewalk.live.inbox import Item
from ropewalk.live.messages import error_message
from ropewalk.live.parameters import refusal
from ropewalk.live.reading import read_apart
from ropewalk.live.session import Session
from ropewalk.live.sources import Start
from ropewalk.simulation.warming import warm_up


class Opened(NamedTuple):
    """A scene that is ready, or the error that it gave, and the command that asked for it."""

    item: Item
    session: Future[Session]


class Opening:
    """Opens one scene at a time; of those that wait meanwhile only the newest is opened next."""

    def __init__(self, start: Start, wake: Callable[[], None]) -> None:
        self._start, self._wake = start, wake
        self._now: Opened | None = None
        self._next: Item | None = None

    @property
    def clients(self) -> set[int]:
        """The pages whose scene is on its way; what they send meanwhile is meant for that scene."""
        items = [self._now.item if self._now else None, self._next]
        return {item.client for item in items if item is not None}

    def ask(self, item: Item) -> None:
        """Have the scene of a command opened."""
        if self._next is not None:
            was = self._next.what
            error = refusal("scene", was.preset, "another scene has been asked for since")
            self._next.reply(error_message(was.type, was.id, error))
        self._next = item
        self._begin()

    def take(self) -> Opened | None:
        """Return the scene that is ready, once."""
        found = self._now
        if found is None or not found.session.done():
            return None
        self._now = None
        self._begin()
        return found

    def _begin(self) -> None:
        if self._now is None and self._next is not None:
            item, self._next = self._next, None
            job = aside(partial(_open, item.what, self._start), "opening", self._wake)
            self._now = Opened(item, job)


def _open(command: SceneCommand, start: Start) -> Session:
    made = opened(Session, command, start, read_apart)
    warm_up(made.main.simulation)
    return made
