"""Views from Python: of a simulation that the caller steps, of a scene that plays, of a result."""

from __future__ import annotations

import sys
from html import escape
from pathlib import Path
from types import TracebackType
from typing import Any

from ropewalk.live.browser import open_browser as show_in_browser
from ropewalk.live.launch import check_installed
from ropewalk.record.result import Result
from ropewalk.scene import Scene
from ropewalk.simulation import Simulation
from ropewalk.words.annotations import unquoted

_HEIGHT = 640


@unquoted
class View:
    """A page that shows something, and the server behind it.

    In a notebook it shows itself. It ends with `close`, with the program, or as a context manager.
    """

    def __init__(self, server: Any, *, open_browser: bool) -> None:
        self._server = server
        server.start()
        self._open = True
        if open_browser and not in_notebook():
            show_in_browser(server.address)

    @property
    def address(self) -> str:
        """The address of the page; whoever has it on this computer can see and drive."""
        return str(self._server.address)

    @property
    def folder(self) -> Path | None:
        """The run folder that the session is kept in, if it is kept."""
        keeper = self._server.keeper
        return keeper.folder if keeper is not None else None

    def update(self) -> None:
        """Show the simulation as it is now, and let hands on the page pull it from now on.

        Call it once a frame when your program steps the simulation. Does nothing where the view plays
        by itself, or is closed.
        """
        if self._open and self._server.player is None:
            self._server.broadcast.tick()

    def wait(self) -> None:
        """Wait until the view ends or Ctrl-C is pressed (which ends it)."""
        try:
            while self._open and self._server.wait(0.5):
                pass
        except KeyboardInterrupt:
            pass
        finally:
            self.close()

    def close(self) -> None:
        """End the view; a session that is kept is saved."""
        if self._open:
            self._open = False
            self._server.stop("The view was closed.")

    def __enter__(self) -> View:
        return self

    def __exit__(
        self,
        kind: type[BaseException] | None,
        value: BaseException | None,
        trace: TracebackType | None,
    ) -> None:
        self.close()

    def _repr_html_(self) -> str:
        address = escape(self.address, quote=True)
        return (
            f'<iframe src="{address}" width="100%" height="{_HEIGHT}" '
            'style="border: 1px solid #8884; border-radius: 6px" allow="fullscreen"></iframe>'
        )

    def __repr__(self) -> str:
        return f"<View at {self.address}>" if self._open else "<View, closed>"


def in_notebook() -> bool:
    """Tell whether this is a notebook's kernel."""
    shell = getattr(sys.modules.get("IPython"), "get_ipython", lambda: None)()
    return shell is not None and "IPKernelApp" in getattr(shell, "config", {})


def view_simulation(
    simulation: Simulation,
    *,
    open_browser: bool = True,
    port: int | None = None,
    page: Path | None = None,
) -> View:
    """Show a simulation that the caller steps; see `Simulation.view`."""
    check_installed()
    from ropewalk.live.program import ProgramBroadcast
    from ropewalk.live.serve import ViewServer

    server = ViewServer(port=port, page=page)
    server.show(ProgramBroadcast(simulation), title=simulation.scene.name, play=False)
    return View(server, open_browser=open_browser)


def view_scene(
    scene: Scene,
    *,
    folder: str | Path | None = None,
    open_browser: bool = True,
    playing: bool = True,
    port: int | None = None,
    page: Path | None = None,
) -> View:
    """Play a scene live; see `Scene.view`."""
    from ropewalk.live.launch import prepare

    where = None if folder is None else Path(folder)
    server = prepare(scene, folder=where, playing=playing, port=port, page=page)
    return View(server, open_browser=open_browser)


def view_result(
    result: Result,
    *,
    open_browser: bool = True,
    playing: bool = True,
    port: int | None = None,
    page: Path | None = None,
) -> View:
    """Replay a result; see `Result.view`."""
    check_installed()
    from ropewalk.live.launch import serve_run

    server = serve_run(result.folder or result, playing=playing, port=port, page=page)
    return View(server, open_browser=open_browser)
