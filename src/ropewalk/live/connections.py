"""Connections of the web server: those that have asked for nothing yet are few, and not for long."""

from __future__ import annotations

import asyncio
from typing import TYPE_CHECKING, Any

from uvicorn.protocols.http.h11_impl import H11Protocol

if TYPE_CHECKING:
    from h11 import Request

PATIENCE = 5.0  # [s] that a connection may take to ask for something, from its beginning or its last answer
MOST = 64  # of these at once; a further one takes the place of the oldest


class Waiting:
    """Connections without a whole request, the oldest first."""

    def __init__(self) -> None:
        self._timers: dict[Connection, asyncio.TimerHandle] = {}

    def __len__(self) -> int:
        return len(self._timers)

    def add(self, one: Connection) -> None:
        """Wait for a connection's request, unless it is waited for already."""
        if one in self._timers:
            return
        if len(self._timers) >= MOST:
            next(iter(self._timers)).give_up()
        self._timers[one] = one.loop.call_later(PATIENCE, one.give_up)

    def discard(self, one: Connection) -> None:
        """Wait for it no longer: it has asked, or is gone."""
        timer = self._timers.pop(one, None)
        if timer is not None:
            timer.cancel()


class Connection(H11Protocol):
    """One connection; uvicorn alone would wait for a request for ever."""

    def __init__(self, *args: Any, waiting: Waiting, **options: Any) -> None:
        super().__init__(*args, **options)
        self._waiting = waiting

    def connection_made(self, transport: asyncio.Transport) -> None:  # type: ignore[override]
        super().connection_made(transport)
        self._waiting.add(self)

    def data_received(self, data: bytes) -> None:
        super().data_received(data)
        self._look()

    def on_response_complete(self) -> None:
        super().on_response_complete()
        self._look()

    def connection_lost(self, exc: Exception | None) -> None:
        self._waiting.discard(self)
        super().connection_lost(exc)

    def handle_websocket_upgrade(self, event: Request) -> None:
        self._waiting.discard(self)
        super().handle_websocket_upgrade(event)

    def give_up(self) -> None:
        """End the connection."""
        self._waiting.discard(self)
        self.transport.abort()

    def _look(self) -> None:
        if self.transport.get_protocol() is not self or self.transport.is_closing():
            return
        if self.cycle is not None and not self.cycle.response_complete:
            self._waiting.discard(self)
        else:
            self._waiting.add(self)
