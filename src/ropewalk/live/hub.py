"""The pages that look on: one mailbox each, with the newest frame only, and no queue that grows.

Everything here runs in the server's event loop, but for `show` and `tell`, which come from the
broadcast's thread.
"""

from __future__ import annotations

import asyncio
import json
from typing import Any

from ropewalk.analysis.json_values import plain
from ropewalk.live.audience import Combine

UNACKNOWLEDGED = 3
MOST_MESSAGES = 500  # that wait for one page; one that is further behind is given up
# Of these only the newest is worth sending.
_STATES = frozenset(["layout", "parameters", "status", "stability"])


class Mailbox:
    """What waits for one page."""

    def __init__(self, number: int) -> None:
        self.number = number
        self._texts: dict[Any, str] = {}
        self._other = 0
        self._frame: tuple[int, bytes] | None = None
        self._sent: list[int] = []  # frames on the way
        self._ready = asyncio.Event()
        self.overflown = False
        self.admitted = False  # not before it is told everything: news make no sense to it

    def put_text(self, kind: str, text: str) -> None:
        """Take a message; none once there are too many, as the page is left then."""
        if self.overflown:
            return
        if kind in _STATES:
            self._texts.pop(kind, None)
            self._texts[kind] = text
        else:
            self._other += 1
            self._texts[self._other] = text
        if len(self._texts) > MOST_MESSAGES:
            self.overflown = True
        self._ready.set()

    def put_frame(self, number: int, frame: bytes, combine: Combine | None = None) -> None:
        """Take a frame in place of the one that waits; what was seen for that one is seen in this."""
        if self._frame is not None and combine is not None:
            frame = combine(self._frame[1], frame)
        self._frame = (number, frame)
        if len(self._sent) < UNACKNOWLEDGED:
            self._ready.set()

    def acknowledge(self, number: int) -> None:
        """Note that the page has used a frame, and with it all before it."""
        self._sent = [one for one in self._sent if one > number]
        if self._frame is not None and len(self._sent) < UNACKNOWLEDGED:
            self._ready.set()

    @property
    def on_the_way(self) -> int:
        """Frames that are not acknowledged."""
        return len(self._sent)

    async def take(self) -> tuple[list[str], bytes | None]:
        """Wait for something to send: messages, then perhaps a frame."""
        await self._ready.wait()
        self._ready.clear()
        texts, frame = list(self._texts.values()), None
        self._texts.clear()
        if self._frame is not None and len(self._sent) < UNACKNOWLEDGED:
            number, frame = self._frame
            self._sent.append(number)
            self._frame = None
        return texts, frame


class Hub:
    """All pages."""

    def __init__(self) -> None:
        self.boxes: dict[int, Mailbox] = {}
        self._next = 1
        self._loop: asyncio.AbstractEventLoop | None = None

    def attach(self, loop: asyncio.AbstractEventLoop) -> None:
        """Name the event loop that the pages live in."""
        self._loop = loop

    @property
    def size(self) -> int:
        """Number of pages."""
        return len(self.boxes)

    def enter(self) -> Mailbox:
        """Take in a page."""
        box = Mailbox(self._next)
        self.boxes[self._next] = box
        self._next += 1
        return box

    def leave(self, box: Mailbox) -> None:
        """Forget a page."""
        self.boxes.pop(box.number, None)

    def admit(self, box: Mailbox) -> None:
        """Let a page have what all pages get from now on (from any thread)."""
        self._call(self._admit, box)

    def _admit(self, box: Mailbox) -> None:
        box.admitted = True

    def show(self, number: int, frame: bytes, combine: Combine | None = None) -> None:
        """Show a frame to all pages (from any thread)."""
        self._call(self._show, number, frame, combine)

    def tell(self, message: dict[str, Any]) -> None:
        """Send a message to all pages (from any thread)."""
        self._call(self._tell, message["type"], as_text(message))

    def tell_one(self, box: Mailbox, message: dict[str, Any]) -> None:
        """Send a message to one page (from any thread)."""
        self._call(box.put_text, message["type"], as_text(message))

    def _call(self, function: Any, *values: Any) -> None:
        loop = self._loop
        if loop is not None and not loop.is_closed():
            try:
                loop.call_soon_threadsafe(function, *values)
            except RuntimeError:  # closed in between
                return

    def _show(self, number: int, frame: bytes, combine: Combine | None) -> None:
        for box in self._admitted():
            box.put_frame(number, frame, combine)

    def _tell(self, kind: str, text: str) -> None:
        for box in self.boxes.values() if kind == "bye" else self._admitted():
            box.put_text(kind, text)

    def _admitted(self) -> list[Mailbox]:
        return [box for box in self.boxes.values() if box.admitted]


def as_text(message: dict[str, Any]) -> str:
    """Return a message as JSON; numbers that are not finite become null.

    In ASCII, so that no text in it can be one that a socket refuses to send.
    """
    return json.dumps(plain(message), allow_nan=False)
