"""A served session and pages that talk to it, for tests."""

from __future__ import annotations

import json
import struct
import time
from collections.abc import Callable, Iterator
from contextlib import contextmanager, suppress
from pathlib import Path
from typing import Any

from websockets.exceptions import ConnectionClosed
from websockets.sync.client import ClientConnection, connect

from patience import PATIENCE
from ropewalk.live.launch import serve_session
from ropewalk.live.serve import ViewServer
from ropewalk.live.session import Session

HEADER = struct.Struct("<IIIIddfffI")


@contextmanager
def served(session: Session, place: Path, **options: Any) -> Iterator[ViewServer]:
    """Serve a session with a small page of its own."""
    page = place / "page"
    page.mkdir(parents=True, exist_ok=True)
    (page / "index.html").write_text("<!doctype html><title>a page</title>")
    (page / "bundle.js").write_text("export {};")
    (page / "secret.key").write_text("no")
    server = serve_session(session, page=page, port=0, **options)
    server.start()
    try:
        yield server
    finally:
        server.stop()


class Page:
    """One page's socket."""

    def __init__(self, server: ViewServer, *, acknowledges: bool = True, **options: Any) -> None:
        url = server.address.replace("http:", "ws:") + "socket"
        waits: dict[str, Any] = {"open_timeout": PATIENCE, "ping_timeout": PATIENCE}
        self._manager = connect(url, subprotocols=["ropewalk.1"], **(waits | options))
        self.socket: ClientConnection = self._manager.__enter__()
        self.acknowledges = acknowledges
        self.messages: list[dict[str, Any]] = []
        self.frames: list[tuple[Any, ...]] = []
        self.data = b""

    def send(self, kind: str, **keys: Any) -> None:
        """Send a command."""
        self.socket.send(json.dumps({"type": kind, **keys}))

    def read(self, seconds: float = PATIENCE) -> None:
        """Read one message or frame. Raises TimeoutError."""
        message = self.socket.recv(seconds)
        if isinstance(message, bytes):
            head = HEADER.unpack_from(message)
            self.frames.append(head)
            self.data = message
            if self.acknowledges:
                with suppress(ConnectionClosed):  # what came before the end is still to be read
                    self.send("ack", frame=head[2])
        else:
            self.messages.append(json.loads(message))

    def listen(self, seconds: float) -> None:
        """Read whatever comes for so long; other messages than frames always do."""
        end = time.monotonic() + seconds
        with suppress(TimeoutError):
            while (left := end - time.monotonic()) > 0.0:
                self.read(left)

    def until(self, ready: Callable[[], Any], seconds: float = PATIENCE) -> Any:
        """Read until something is there; return it."""
        end = time.monotonic() + seconds
        while not (found := ready()):
            left = end - time.monotonic()
            assert left > 0.0, f"waited in vain; {[one['type'] for one in self.messages[-9:]]}"
            self.read(left)
        return found

    def message(self, kind: str, **keys: Any) -> dict[str, Any]:
        """Return the first message of a kind with such values, when it comes."""

        def find() -> dict[str, Any] | None:
            for one in self.messages:
                if one["type"] == kind and all(one.get(k) == v for k, v in keys.items()):
                    return one
            return None

        found: dict[str, Any] = self.until(find)
        return found

    def ask(self, number: int, kind: str, **keys: Any) -> dict[str, Any]:
        """Send a command with an id and return its answer."""
        self.send(kind, id=number, **keys)

        def find() -> dict[str, Any] | None:
            answers = [one for one in self.messages if one.get("id") == number]
            return answers[0] if answers else None

        found: dict[str, Any] = self.until(find)
        return found

    def ended(self) -> int | None:
        """Read to the end; return the close code."""
        try:
            self.listen(PATIENCE)
        except ConnectionClosed as error:
            return error.rcvd.code if error.rcvd is not None else None
        raise AssertionError("the server did not close the socket")

    def close(self) -> None:
        """Leave."""
        self._manager.__exit__(None, None, None)

    def __enter__(self) -> Page:
        return self

    def __exit__(self, *_: object) -> None:
        self.close()
