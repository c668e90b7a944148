"""One page's WebSocket: commands in, frames and messages out, within bounds."""

from __future__ import annotations

import asyncio
import time
from contextlib import suppress
from typing import TYPE_CHECKING, Any

from starlette.websockets import WebSocket, WebSocketDisconnect

from ropewalk.live.commands import LARGEST_ID, Ack, SceneCommand, parse
from ropewalk.live.door import SUBPROTOCOL
from ropewalk.live.hub import Mailbox
from ropewalk.live.json_input import read_json
from ropewalk.live.messages import error_message
from ropewalk.live.parameters import refusal
from ropewalk.scene import SceneError

if TYPE_CHECKING:
    from ropewalk.live.app import Live

PROTOCOL = 1
LONGEST_MESSAGE = 64_000  # characters, of all but a scene
PER_SECOND, BURST = 240.0, 480.0
MOST_MALFORMED = 20
MALFORMED, FAST, FULL = 4400, 4429, 4503
SEND_SECONDS = 20.0  # a page that takes nothing for so long is gone


class Allowance:
    """So many messages a second, on average."""

    def __init__(self) -> None:
        self._left, self._last = BURST, time.monotonic()

    def take(self) -> bool:
        """Take one message from the allowance; tell whether there was one."""
        now = time.monotonic()
        self._left = min(BURST, self._left + PER_SECOND * (now - self._last))
        self._last = now
        self._left -= 1.0
        return self._left >= 0.0


async def serve_socket(socket: WebSocket, live: Live) -> None:
    """Serve a page from its coming to its going."""
    asked = socket.scope.get("subprotocols") or []
    await socket.accept(subprotocol=SUBPROTOCOL if SUBPROTOCOL in asked else None)
    if live.hub.size >= live.most_clients:
        await socket.close(FULL, f"{live.most_clients} pages are open already")
        return
    box = live.hub.enter()
    try:
        await socket.send_text(live.hello(box.number))
        live.join(box)
        sender = asyncio.create_task(_send(socket, box))
        try:
            await _receive(socket, box, live)
        finally:
            sender.cancel()
            await asyncio.gather(sender, return_exceptions=True)
    except (WebSocketDisconnect, RuntimeError, OSError):
        pass  # the page is gone
    finally:
        live.hub.leave(box)
        live.do(lambda broadcast: broadcast.leave(box.number))


async def _send(socket: WebSocket, box: Mailbox) -> None:
    try:
        while not box.overflown:
            texts, frame = await box.take()
            async with asyncio.timeout(SEND_SECONDS):
                for text in texts:
                    await socket.send_text(text)
                if frame is not None:
                    await socket.send_bytes(frame)
        await socket.close(1013, "too far behind")
    except TimeoutError:  # it takes nothing any more: without this it stood open, and still
        with suppress(Exception):
            async with asyncio.timeout(1.0):
                await socket.close(1013, "too far behind")
    except (WebSocketDisconnect, RuntimeError, OSError):
        return


async def _receive(socket: WebSocket, box: Mailbox, live: Live) -> None:
    allowance, malformed = Allowance(), 0
    while True:
        message = await socket.receive()
        if message["type"] == "websocket.disconnect":
            return
        if not allowance.take():
            await socket.close(FAST, "too many messages")
            return
        try:
            command = _command(message.get("text"))
        except SceneError as error:
            malformed += 1
            if malformed > MOST_MALFORMED:
                await socket.close(MALFORMED, "too many malformed messages")
                return
            number, kind = _about(message.get("text"))
            live.hub.tell_one(box, error_message(kind, number, error))
            continue
        if isinstance(command, Ack):
            box.acknowledge(command.frame)
        else:
            live.submit(command, box)


def _command(text: str | None) -> Any:
    if text is None:
        raise refusal("message", "bytes", "must be text")
    command = parse(read_json(text))
    if len(text) > LONGEST_MESSAGE and not isinstance(command, SceneCommand):
        raise refusal("message", f"{len(text)} characters", f"must be at most {LONGEST_MESSAGE}")
    return command


def _about(text: str | None) -> tuple[int | None, str | None]:
    """Return the id and type of a faulty message, where they can be told."""
    try:
        data = read_json(text or "", checked=False)
    except SceneError:
        return None, None
    if not isinstance(data, dict):
        return None, None
    number, kind = data.get("id"), data.get("type")
    known = isinstance(number, int) and not isinstance(number, bool) and 0 <= number <= LARGEST_ID
    return (number if known else None, kind[:40] if isinstance(kind, str) else None)
