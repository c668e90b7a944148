"""Serving a broadcast: port, token, event loop and threads, from start to a clean end."""

from __future__ import annotations

import asyncio
import errno
import socket
import threading
from collections.abc import Callable
from concurrent.futures import Future
from contextlib import suppress
from functools import partial
from pathlib import Path
from typing import TYPE_CHECKING, Any

from ropewalk.live.door import Door
from ropewalk.live.guard import LONGEST_SCENE, Guard, new_token
from ropewalk.live.hub import Hub
from ropewalk.live.player import Player

if TYPE_CHECKING:
    from ropewalk.live.keeper import Keeper
    from ropewalk.scene import Scene

PORT = 8712
TRIES = 20
_BACKLOG = 32


class PortError(OSError):
    """No port to listen on."""


def listen(host: str, port: int) -> tuple[socket.socket, bool]:
    """Return a listening socket on the port or, when that is busy, on one of the next ones.

    The second value tells whether it is the port asked for; port 0 means any. Raises OSError.
    """
    family = socket.AF_INET6 if ":" in host else socket.AF_INET
    for number in [port, *range(port + 1, port + TRIES), 0] if port else [0]:
        # Only with the protocol named does asyncio set TCP_NODELAY; without it frames wait 40 ms.
        made = socket.socket(family, socket.SOCK_STREAM, socket.IPPROTO_TCP)
        try:
            made.setsockopt(socket.SOL_SOCKET, socket.SO_REUSEADDR, 1)
            made.bind((host, min(number, 65535)))
            made.listen(_BACKLOG)
        except OSError as error:
            made.close()
            if error.errno != errno.EADDRINUSE:
                raise
            continue
        return made, number == port
    raise PortError(errno.EADDRINUSE, "no free port")


QUEUE = 1024  # connections that wait to be taken up
AT_ONCE = (
    16  # connections that are taken up before the oldest of them are looked at and may be given up
)


class ViewServer:
    """A broadcast behind a web server, in threads of its own; the page's files are there before it is."""

    def __init__(
        self,
        *,
        host: str = "127.0.0.1",
        port: int | None = None,
        page: Path | None = None,
        token: str | None = None,
    ) -> None:
        """Take a port, by default PORT or one of the next. Raises OSError when there is none."""
        self.broadcast: Any = None
        self.keeper: Keeper | None = None
        self.player: Player | None = None
        self.hub, self.door = Hub(), Door(page)
        self.socket, self.port_was_free = listen(host, PORT if port is None else port)
        self.host, self.port = host, int(self.socket.getsockname()[1])
        self.token = token or new_token()
        self._server: Any = None
        self._thread: threading.Thread | None = None
        # Not the thread's own join: Python 3.11 takes a thread for ended once Ctrl-C interrupts that.
        self._ended = threading.Event()

    def show(
        self,
        broadcast: Any,
        *,
        title: str = "",
        keeper: Keeper | None = None,
        folder: Path | None = None,
        play: bool = True,
    ) -> None:
        """Let the pages see a broadcast, and keep it going unless its program does that."""
        from ropewalk.live.app import Live, make_app
        from ropewalk.live.exports import Exports

        self.broadcast, self.keeper = broadcast, keeper
        self.player = Player(broadcast) if play else None
        exports = Exports(self._scene_now(), self._run_folder(folder), title)
        wake = self.player.wake if self.player is not None else _nothing
        broadcast.wake = wake
        where = keeper.folder if keeper is not None else folder
        self.live = Live(broadcast, self.hub, exports, wake=wake, folder=where, title=title)
        self.door.open(make_app(self.live))
        if self._thread is not None:
            self._begin()

    @property
    def address(self) -> str:
        """The address to open, with the token."""
        host = "127.0.0.1" if self.host in ("0.0.0.0", "::") else self.host
        name = f"[{host}]" if ":" in host else host
        return f"http://{name}:{self.port}/{self.token}/"

    def _scene_now(self) -> Callable[[], Scene] | None:
        if not hasattr(self.broadcast, "session"):
            scene = getattr(self.broadcast, "scene", None)
            return None if scene is None else (lambda: scene)

        def ask() -> Scene:
            from ropewalk.live.as_it_stands import Standing

            found: Future[Standing] = Future()

            def answer(broadcast: Any) -> None:
                try:
                    found.set_result(Standing.of(broadcast.session))
                except BaseException as error:
                    found.set_exception(error)

            self.live.do(answer)
            return found.result(10.0).scene()

        return ask

    def _run_folder(self, folder: Path | None) -> Callable[[], Path] | None:
        if self.keeper is not None:
            return self.keeper.flush
        return None if folder is None else (lambda: folder)

    def start(self) -> None:
        """Begin to serve, and to play once there is a broadcast; the second call does nothing."""
        if self._thread is not None:
            return
        import uvicorn

        from ropewalk.live.connections import Connection, Waiting

        app = Guard(self.door, self.token, self.host, self.port)
        config = uvicorn.Config(
            app,
            log_config=None,
            access_log=False,
            lifespan="off",
            http=partial(Connection, waiting=Waiting()),  # type: ignore[arg-type]
            ws="websockets-sansio",
            ws_max_size=LONGEST_SCENE,
            ws_per_message_deflate=False,
            ws_ping_interval=20.0,
            proxy_headers=False,
            server_header=False,
            timeout_graceful_shutdown=2,
            h11_max_incomplete_event_size=32_000,
            backlog=AT_ONCE,
        )
        self._server = uvicorn.Server(config)
        ready = threading.Event()
        self._thread = threading.Thread(
            target=self._serve, args=(ready,), name="ropewalk-server", daemon=True
        )
        self._thread.start()
        ready.wait(10.0)
        if self.broadcast is not None:
            self._begin()

    def _begin(self) -> None:
        self.broadcast.audience = self.hub
        if self.player is not None:
            self.player.start()

    def _serve(self, ready: threading.Event) -> None:
        async def main() -> None:
            self.hub.attach(asyncio.get_running_loop())
            ready.set()
            serving = asyncio.create_task(self._server.serve(sockets=[self.socket]))
            while not (self._server.started or serving.done()):
                await asyncio.sleep(0.01)
            with suppress(OSError):
                self.socket.listen(QUEUE)  # in the system: these cost no descriptor
            await serving

        try:
            asyncio.run(main())
        finally:
            self._ended.set()

    @property
    def error(self) -> BaseException | None:
        """What ended the player, if it ended by an error."""
        return self.player.error if self.player is not None else None

    def wait(self, seconds: float) -> bool:
        """Wait so long; tell whether server and player still work."""
        if self._thread is None:
            return False
        ended = self._ended.wait(seconds)
        playing = self.player is None or self.player.alive
        return not ended and playing

    def stop(self, text: str = "The server has ended.") -> None:
        """End: the player first, then the run is saved, the pages are told, the server ends."""
        if self.player is not None:
            self.player.end()
        if self.keeper is not None:
            self.keeper.close()
        where = str(self.keeper.folder) if self.keeper is not None else None
        self.hub.tell({"type": "bye", "text": text, "folder": where})
        self.door.close(text)
        if self.broadcast is not None:
            self.broadcast.close()
        if self._server is not None:
            self._server.should_exit = True
        if self._thread is not None:
            self._ended.wait(6.0)
        with suppress(OSError):
            self.socket.close()


def _nothing() -> None:
    """Wake nobody."""
