"""The web application: the presets' pictures, exports, a replay's numbers, the socket."""

from __future__ import annotations

from collections.abc import Callable
from functools import partial
from pathlib import Path
from typing import Any

from starlette.applications import Starlette
from starlette.concurrency import run_in_threadpool
from starlette.requests import Request
from starlette.responses import PlainTextResponse, Response
from starlette.routing import Route, WebSocketRoute
from starlette.websockets import WebSocket

from ropewalk import __version__
from ropewalk.live.commands import Command
from ropewalk.live.downloads import Downloads
from ropewalk.live.exports import Exports, NothingToExport
from ropewalk.live.guard import LONGEST_SCENE
from ropewalk.live.hands import FASTEST, MOST_GRABS
from ropewalk.live.hub import UNACKNOWLEDGED, Hub, Mailbox, as_text
from ropewalk.live.page_socket import PER_SECOND, PROTOCOL, serve_socket
from ropewalk.live.preset_pictures import svg
from ropewalk.live.replay_routes import replay_routes

MOST_CLIENTS = 8


class Live:
    """What the routes have in common: the broadcast, the pages, the exports."""

    def __init__(
        self,
        broadcast: Any,
        hub: Hub,
        exports: Exports,
        *,
        wake: Callable[[], None] = lambda: None,
        folder: Path | None = None,
        title: str = "",
        most_clients: int = MOST_CLIENTS,
    ) -> None:
        self.broadcast, self.hub, self.exports = broadcast, hub, exports
        self.wake, self.run_folder, self.title = wake, folder, title
        self.most_clients = most_clients

    def submit(self, command: Command, box: Mailbox) -> None:
        """Hand a page's command to the broadcast."""
        self.broadcast.submit(command, box.number, lambda message: self.hub.tell_one(box, message))
        self.wake()

    def join(self, box: Mailbox) -> None:
        """Have a new page told everything; at once where a program may not come back for long."""

        def tell(message: dict[str, Any]) -> None:
            self.hub.tell_one(box, message)

        def join(broadcast: Any) -> None:
            broadcast.join(tell)
            self.hub.admit(box)

        latest = getattr(self.broadcast, "latest", None)
        if latest is None:
            self.do(join)
        else:
            join(self.broadcast)
            box.put_frame(*latest)

    def do(self, what: Callable[[Any], None]) -> None:
        """Have something done in the broadcast."""
        self.broadcast.submit(what, 0, lambda message: None)
        self.wake()

    def hello(self, client: int) -> str:
        """Return the first message to a page."""
        return as_text(
            {
                "type": "hello",
                "protocol": PROTOCOL,
                "ropewalk": __version__,
                "client": client,
                "mode": self.broadcast.mode,
                "can": self.broadcast.can,
                "limits": {
                    "message_bytes": LONGEST_SCENE,
                    "messages_per_second": PER_SECOND,
                    "unacknowledged": UNACKNOWLEDGED,
                    "clients": self.most_clients,
                    "anchor_speed": FASTEST,  # [m/s] of one that is led, in the rope's time
                },
                "title": self.title,
                "folder": str(self.run_folder) if self.run_folder else None,
                "address": self.broadcast.address,
                "speeds": [0.01, 4.0],
                "grabs": MOST_GRABS,
                "exports": self.exports.names(),
            }
        )


def make_app(live: Live) -> Starlette:
    """Return the application behind the page's own files, which the `Door` serves."""

    downloads = Downloads()

    async def picture(request: Request) -> Response:
        made = await run_in_threadpool(svg, request.path_params["name"], live.broadcast)
        if made is None:
            return PlainTextResponse("no such preset\n", 404)
        return Response(made, media_type="image/svg+xml")

    async def export(request: Request) -> Response:
        name = request.path_params["name"]
        try:
            return await downloads.make(
                partial(live.exports.make, name), live.exports.file_name(name)
            )
        except NothingToExport as error:
            return PlainTextResponse(f"{error}\n", 404)
        except TimeoutError:  # it is compiling
            return PlainTextResponse("the simulation is busy; try again\n", 503)

    async def socket(websocket: WebSocket) -> None:
        await serve_socket(websocket, live)

    return Starlette(
        routes=[
            Route("/presets/{name}.svg", picture),
            Route("/export/{name}", export),
            *replay_routes(live.broadcast),
            WebSocketRoute("/socket", socket),
        ]
    )
