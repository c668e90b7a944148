"""Setting up a live view: session, folder, server. For the command line and for Python alike."""

from __future__ import annotations

from collections.abc import Callable
from importlib.util import find_spec
from pathlib import Path
from typing import TYPE_CHECKING, Any

from ropewalk.record.errors import RunError
from ropewalk.scene import Scene

if TYPE_CHECKING:
    from ropewalk.record.result import Result

NEEDS = ("starlette", "uvicorn", "websockets")


def missing() -> list[str]:
    """Return the packages that a view needs and that are not installed."""
    return [name for name in NEEDS if find_spec(name) is None]


def check_installed() -> None:
    """Raise RunError when a package is missing."""
    absent = missing()
    if absent:
        words, those = " and ".join(absent), " ".join(absent)
        raise RunError(words, f"needed for the live view, and not installed: pip install {those}")


def prepare(
    scene: Scene,
    preset: str | None = None,
    *,
    folder: Path | None = None,
    playing: bool = True,
    host: str = "127.0.0.1",
    port: int | None = None,
    page: Path | None = None,
    listening: Callable[[Any], None] | None = None,
) -> Any:
    """Return a server that plays a scene live and keeps it in `folder` (None: not).

    Ready to start, or started already: `listening` gets it as soon as it serves the page, which waits for
    the simulation. Raises SceneError, RunError for the folder, OSError for the port.
    """
    check_installed()
    from ropewalk.live.serve import ViewServer

    server = ViewServer(host=host, port=port, page=page)
    try:
        if listening is not None:
            server.start()
            listening(server)
        from ropewalk.live.session import Session

        _show(server, Session(scene, preset), folder, False, playing)
    except BaseException as error:
        why = str(error) or "it was interrupted"
        server.stop(f"The simulation could not be set up: {why}.")
        raise
    return server


def serve_session(
    session: Any,
    *,
    folder: Path | None = None,
    go_on: bool = False,
    playing: bool = True,
    host: str = "127.0.0.1",
    port: int | None = None,
    page: Path | None = None,
) -> Any:
    """Return a server, ready to start, for a session that is there already. Raises as `prepare`."""
    from ropewalk.live.serve import ViewServer

    server = ViewServer(host=host, port=port, page=page)
    try:
        _show(server, session, folder, go_on, playing)
    except BaseException:
        server.stop()
        raise
    return server


def serve_run(
    run: Path | Result,
    *,
    playing: bool = True,
    host: str = "127.0.0.1",
    port: int | None = None,
    page: Path | None = None,
) -> Any:
    """Return a server, ready to start, that replays a run. Raises RunError, OSError."""
    from ropewalk.live.replay import ReplayBroadcast
    from ropewalk.live.serve import ViewServer

    broadcast = ReplayBroadcast(run, playing=playing)
    server = ViewServer(host=host, port=port, page=page)
    folder = run if isinstance(run, Path) else None
    server.show(broadcast, title=broadcast.scene.name, folder=folder, play=False)
    return server


def _show(server: Any, session: Any, folder: Path | None, go_on: bool, playing: bool) -> None:
    """Make a session what a server broadcasts."""
    from ropewalk.live.broadcast import Broadcast
    from ropewalk.live.keeper import Keeper
    from ropewalk.simulation.warming import warm_up

    warm_up(session.main.simulation)
    broadcast = Broadcast(session, playing=playing)
    keeper = Keeper(session, folder, go_on=go_on) if folder is not None else None
    if keeper is not None:
        broadcast.on_save = lambda: str(keeper.flush())
    server.show(broadcast, title=session.scene.name, keeper=keeper)
