"""What waits for a broadcast: commands from pages, and things to be done there, from any thread."""

from __future__ import annotations

import queue
from collections.abc import Callable, Container, Mapping
from typing import Any, NamedTuple

from ropewalk.live.commands import Command, SceneCommand
from ropewalk.live.messages import error_message
from ropewalk.live.parameters import refusal

Reply = Callable[[dict[str, Any]], None]
MOST_WAITING = 2000
_COALESCED = frozenset(["set", "drag", "grab", "move", "obstacle"])


class Item(NamedTuple):
    """A command, or something to be done in the broadcast, with the page that it is from."""

    what: Any
    client: int
    reply: Reply


class Inbox:
    """Items in the order of their coming; of commands about the same thing only the last is kept."""

    def __init__(self, replaced: Callable[[Command, Reply], None]) -> None:
        """`replaced` is told of every command in whose place a later one has come."""
        self._replaced = replaced
        self._coming: queue.SimpleQueue[Item] = queue.SimpleQueue()
        self._items: list[Item] = []

    def put(self, item: Item) -> None:
        """Take an item (from any thread)."""
        self._coming.put(item)

    def gather(self) -> None:
        """Take in what has come, in place of what it replaces."""
        come: list[Item] = []
        while True:
            try:
                come.append(self._coming.get_nowait())
            except queue.Empty:
                break
        if not come:
            return
        items = self._items + come
        last = {_subject(item): i for i, item in enumerate(items) if _replaceable(item)}
        self._items = []
        for i, item in enumerate(items):
            if _replaceable(item) and last[_subject(item)] != i:
                self._replaced(item.what, item.reply)
            elif len(self._items) >= MOST_WAITING and isinstance(item.what, Command):
                _refuse(item)
            else:
                self._items.append(item)

    def take(self, held: Mapping[int, Container[str]]) -> Item | None:
        """Return the next item; None: there is none.

        Of the pages `held`, which wait for their scene, only that they want another one now, and the types
        of commands that are given for them.
        """
        passed: set[int] = set()
        for i, item in enumerate(self._items):
            if item.client not in held or not isinstance(item.what, Command):
                return self._items.pop(i)
            if item.what.type in held[item.client]:
                return self._items.pop(i)
            if isinstance(item.what, SceneCommand) and item.client not in passed:
                return self._items.pop(i)
            passed.add(item.client)
        return None


def _replaceable(item: Item) -> bool:
    return isinstance(item.what, Command) and item.what.type in _COALESCED


def _subject(item: Item) -> tuple[Any, ...]:
    """What a command is about."""
    about = item.what.model_dump(exclude={"id", "value", "target", "velocity", "pace", "angle"})
    return (item.client, *sorted((key, str(value)) for key, value in about.items()))


def _refuse(item: Item) -> None:
    rule = f"{MOST_WAITING} commands wait already; the simulation is at work"
    error = refusal("type", item.what.type, rule)
    item.reply(error_message(item.what.type, item.what.id, error))
