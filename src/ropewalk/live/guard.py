"""Who may come in: the token, Host and Origin, and the headers that keep a page safe."""

from __future__ import annotations

import ipaddress
import secrets
from collections.abc import Awaitable, Callable, MutableMapping
from typing import Any
from urllib.parse import urlsplit

Scope = MutableMapping[str, Any]
Receive = Callable[[], Awaitable[MutableMapping[str, Any]]]
Send = Callable[[MutableMapping[str, Any]], Awaitable[None]]
App = Callable[[Scope, Receive, Send], Awaitable[None]]

CSP = (
    "default-src 'none'; script-src 'self'; style-src 'self'; img-src 'self' blob: data:; "
    "connect-src 'self'; media-src blob:; base-uri 'none'; form-action 'none'; "
    "frame-ancestors 'self' http://localhost:* http://127.0.0.1:*"
)
HEADERS = (
    (b"content-security-policy", CSP.encode()),
    (b"x-content-type-options", b"nosniff"),
    (b"referrer-policy", b"no-referrer"),
    (b"cross-origin-resource-policy", b"same-origin"),
    (b"cache-control", b"no-store"),
)
LONGEST_SCENE = 256_000  # bytes of a message, the socket's own limit
_LOCAL = ("127.0.0.1", "localhost", "::1")


def new_token() -> str:
    """Return a random token of 192 bits."""
    return secrets.token_urlsafe(24)


class Guard:
    """Lets in only what has the token, the server's own Host, and its own Origin or none.

    A page of another site has another Origin; one that has bound its name to 127.0.0.1 (DNS rebinding)
    has another Host.
    """

    def __init__(self, app: App, token: str, host: str, port: int) -> None:
        self._app, self._token, self._host, self._port = app, token.encode(), host, port

    async def __call__(self, scope: Scope, receive: Receive, send: Send) -> None:
        if scope["type"] not in ("http", "websocket"):
            return
        headers = dict(scope["headers"])
        hosts = [value for name, value in scope["headers"] if name == b"host"]
        refusal = None
        if len(hosts) != 1 or not self.is_own_host(hosts[0].decode("latin-1")):
            refusal = (403, "this is not the name of this server")
        elif not self.is_own_origin(headers):
            refusal = (403, "other pages may not use this server")
        elif not self._take_token(scope):
            refusal = (404, "there is nothing here; open the whole address that ropewalk printed")
        if refusal is not None:
            await _refuse(scope, send, *refusal)
            return
        await self._app(scope, receive, _with_headers(send))

    def is_own_host(self, host: str) -> bool:
        """Tell whether a Host header names this server: by loopback name, or an address it listens on."""
        try:
            parts = urlsplit(f"//{host}")
            name, port = parts.hostname or "", parts.port
        except ValueError:
            return False
        if (80 if port is None else port) != self._port or parts.username is not None:
            return False
        if name in _LOCAL or name == self._host:
            return True
        if self._host in _LOCAL:
            return False
        try:  # listening on every address: a number cannot be rebound, a name can
            ipaddress.ip_address(name)
        except ValueError:
            return False
        return True

    def is_own_origin(self, headers: dict[bytes, bytes]) -> bool:
        """Tell whether a request comes from a page of this server, or from no page at all."""
        origin = headers.get(b"origin")
        if origin is None:
            return True  # no page's script; a page that only links here still needs the token
        return origin == b"http://" + headers.get(b"host", b"")

    def _take_token(self, scope: Scope) -> bool:
        """Compare the first part of the path with the token and take it off; in constant time."""
        path = str(scope["path"])
        first, slash, rest = path.lstrip("/").partition("/")
        given = first.encode("utf-8", "surrogatepass")
        if not secrets.compare_digest(given, self._token) or not slash:
            return False
        scope["path"] = "/" + rest
        scope["root_path"] = ""
        return True


def _with_headers(send: Send) -> Send:
    async def wrapped(message: MutableMapping[str, Any]) -> None:
        if message["type"] == "http.response.start":
            message["headers"] = [*message.get("headers", []), *HEADERS]
        await send(message)

    return wrapped


async def _refuse(scope: Scope, send: Send, status: int, text: str) -> None:
    if scope["type"] == "websocket":
        await send({"type": "websocket.close", "code": 1008, "reason": text})  # before accept: 403
        return
    body = f"{text}\n".encode()
    headers = [
        (b"content-type", b"text/plain; charset=utf-8"),
        (b"connection", b"close"),  # who has no token holds no connection
        *HEADERS,
    ]
    await send({"type": "http.response.start", "status": status, "headers": headers})
    await send({"type": "http.response.body", "body": body})
