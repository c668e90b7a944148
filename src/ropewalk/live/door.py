"""The door of a view: the page's files at once, all else when the simulation is there.

Loading numba and the kernels takes longer than a browser needs for the page, so it gets that meanwhile.
"""

from __future__ import annotations

import asyncio
import json
from concurrent.futures import Future
from importlib.resources import files
from pathlib import Path

from starlette.responses import PlainTextResponse, Response
from starlette.types import ASGIApp, Receive, Scope, Send
from starlette.websockets import WebSocket

_TYPES = {
    ".html": "text/html; charset=utf-8",
    ".js": "text/javascript; charset=utf-8",
    ".css": "text/css; charset=utf-8",
    ".svg": "image/svg+xml",
    ".png": "image/png",
    ".ico": "image/x-icon",
    ".txt": "text/plain; charset=utf-8",
    ".json": "application/json",
    ".map": "application/json",
    ".webmanifest": "application/manifest+json",
}
SUBPROTOCOL = "ropewalk.1"
_GOING_AWAY = 1001


def page_folder() -> Path:
    """Return the folder of the page's files."""
    return Path(str(files("ropewalk.live"))) / "page"


class Door:
    """An ASGI application in front of another one that comes later, or never does."""

    def __init__(self, page: Path | None = None) -> None:
        folder = page or page_folder()
        there = folder.iterdir() if folder.is_dir() else ()
        self._files = {path.name: path for path in there if path.is_file()}
        self._behind: Future[ASGIApp | str] = Future()

    def open(self, app: ASGIApp) -> None:
        """Let pages through to the application (from any thread)."""
        self._behind.set_result(app)

    def close(self, text: str) -> None:
        """Tell whoever waits why there will be no application, unless there is one (from any thread)."""
        if not self._behind.done():
            self._behind.set_result(text)

    async def __call__(self, scope: Scope, receive: Receive, send: Send) -> None:
        if scope["type"] == "http" and (response := self._file(scope)) is not None:
            await response(scope, receive, send)
            return
        behind = await asyncio.shield(asyncio.wrap_future(self._behind))
        if not isinstance(behind, str):
            await behind(scope, receive, send)
        elif scope["type"] == "websocket":
            socket = WebSocket(scope, receive, send)
            await socket.accept(subprotocol=SUBPROTOCOL)
            await socket.send_text(json.dumps({"type": "bye", "text": behind, "folder": None}))
            await socket.close(_GOING_AWAY)
        else:
            await PlainTextResponse(f"{behind}\n", 503)(scope, receive, send)

    def _file(self, scope: Scope) -> Response | None:
        """Return the page or one of its files, None for what is neither."""
        name = scope["path"].removeprefix(scope.get("root_path", "")).removeprefix("/")
        if "/" in name or scope["method"] not in ("GET", "HEAD"):
            return None
        path = self._files.get(name or "index.html")
        if path is None or path.suffix not in _TYPES:
            text = "no such file" if self._files else "the page is missing from this installation"
            return PlainTextResponse(f"{text}\n", 404)
        data = path.read_bytes()  # a millisecond: a thread's start would take longer
        return Response(data, headers={"content-type": _TYPES[path.suffix]})
