"""`ropewalk view`: a rope in the browser, live or from a run."""

from __future__ import annotations

import signal
from collections.abc import Callable
from contextlib import ExitStack, suppress
from pathlib import Path
from types import FrameType
from typing import TYPE_CHECKING, Any

import click

from ropewalk.cli.console import say, tell, warn
from ropewalk.cli.failures import Refusal
from ropewalk.cli.output_files import claimed
from ropewalk.cli.progress import tell_compiling
from ropewalk.cli.run_argument import is_sweep
from ropewalk.cli.scene_argument import load_scene, run_options, short_name
from ropewalk.cli.startup import without_scipy

if TYPE_CHECKING:
    from ropewalk.scene import Scene

Announce = Callable[[Any], None]  # of a server that listens

DEFAULT = "r4"
RUNS = Path("runs")
_LOCAL = ("127.0.0.1", "localhost", "::1")


@click.command()
@click.argument("source", metavar="[SCENE|DIR]", required=False)
@run_options
@click.option(
    "--port", type=click.IntRange(0, 65535), help="Port; default: 8712, or the next free."
)
@click.option("--host", default="127.0.0.1", show_default=True, help="Address to listen on.")
@click.option(
    "--at",
    "link",
    metavar="LINK",
    help="A set-up copied from the page (Keep), in place of SCENE: 'scene=r4&mass=2'.",
)
@click.option("--no-browser", is_flag=True, help="Print the address, open nothing.")
@click.option("--paused", is_flag=True, help="Wait for the page's play button.")
@click.option(
    "-o",
    "--output",
    type=click.Path(path_type=Path),
    metavar="DIR",
    help="The session's run folder; default: runs/NAME-live-1, -2 and so on.",
)
@click.option("--no-save", is_flag=True, help="Keep nothing on disk.")
@click.option(
    "--run", "number", type=click.IntRange(0), metavar="N", help="Which run of the sweep in DIR."
)
@click.option("--continue", "go_on", is_flag=True, help="Go on with the live session in DIR.")
def view(
    source: str | None,
    overrides: tuple[str, ...],
    duration: str | None,
    time_step: str | None,
    method: str | None,
    port: int | None,
    host: str,
    link: str | None,
    no_browser: bool,
    paused: bool,
    output: Path | None,
    no_save: bool,
    number: int | None,
    go_on: bool,
) -> int:
    """Show a scene live in the browser, or replay the run in DIR (or one of a sweep's) there.

    The rope can be grabbed, pinned, cut and tweaked while it moves. The session is kept as a run folder,
    from which the same commands give the same bits again. Ctrl-C ends it. Without SCENE the report's
    three-anchor rope is shown. Only this computer can reach the page, unless --host says otherwise.
    """
    with without_scipy(), ExitStack() as stack:
        from ropewalk.live.launch import check_installed

        check_installed()
        settings = {"duration": duration, "time_step": time_step, "method": method}
        options: dict[str, Any] = {"host": host, "port": port}
        if source is not None and is_sweep(Path(source)):
            if overrides or any(settings.values()) or output or go_on:
                raise Refusal(f"{source}: is a sweep; only --run says what of it is shown")
            made, playing = _run_of_sweep(Path(source), number), not paused
            return _serve(lambda _: _replay(made, playing, options), no_browser, port)
        linked = _linked(link, source, *overrides, *settings.values(), go_on)
        if number is not None:
            raise Refusal(f"--run: {source or DEFAULT} is no sweep; leave it out")
        if source is not None and _is_run(Path(source)):
            if overrides or any(settings.values()):
                raise Refusal(f"{source}: is a run; values of a run cannot be changed by flags")
            if not go_on:
                run, playing = Path(source), not paused
                return _serve(lambda _: _replay(run, playing, options), no_browser, port)
        elif go_on:
            raise Refusal(f"{source or DEFAULT}: --continue needs the folder of a live session")
        options["playing"] = not paused
        if go_on:
            folder = Path(str(source))
            return _serve(lambda _: _continued(folder, no_save, options), no_browser, port)
        name = short_name(linked.name if linked else source or DEFAULT)
        if not no_save:
            if output is not None and output.exists():
                from ropewalk.record.place import check_free

                check_free(output, overwrite=False)
            options["folder"] = stack.enter_context(claimed(output, RUNS, f"{name}-live"))
        scene = linked or load_scene(source or DEFAULT, overrides, **settings)
        start = _preset_of(scene, source or DEFAULT, bool(overrides or linked))
        return _serve(lambda early: _live(scene, start, early, options), no_browser, port)


def _linked(link: str | None, *others: object) -> Scene | None:
    """Return the scene of a copied link, if there is one. Raises SceneError.

    Refused where anything else says what is shown, too.
    """
    if link is None:
        return None
    if any(others):
        raise Refusal("--at: says all that is shown; leave out SCENE, --set and --continue")
    from ropewalk.live.sources import scene_at
    from ropewalk.scene.presets import preset

    return scene_at(link, (preset(DEFAULT), DEFAULT))


def _is_run(path: Path) -> bool:
    with suppress(OSError):
        if path.is_dir():
            from ropewalk.record.place import is_run

            return is_run(path)
    return False


def _run_of_sweep(folder: Path, number: int | None) -> Any:
    """Make a run of a sweep again."""
    from ropewalk.sweeps.rerun import replay

    if number is None:
        raise Refusal(f"{folder}: is a sweep; say which run of it: --run 0")
    return replay(folder, number)


def _preset_of(scene: Scene, source: str, changed: bool) -> str | None:
    """Return the name of the preset that the scene is, unchanged."""
    from ropewalk.scene.presets import names, preset

    named = source in names() and not changed and scene == preset(source)
    return source if named else None


def _live(scene: Scene, start: str | None, early: Announce, options: dict[str, Any]) -> Any:
    from ropewalk.live.launch import prepare

    def listening(server: Any) -> None:
        early(server)
        tell_compiling(scene.run.method, scene, live=True)

    return prepare(scene, start, listening=listening, **options)


def _continued(folder: Path, no_save: bool, options: dict[str, Any]) -> Any:
    from ropewalk.live.launch import serve_session
    from ropewalk.live.relive import relive

    tell(f"playing {folder} again up to its end")
    session = relive(folder)
    if not no_save:
        options |= {"folder": folder, "go_on": True}
    return serve_session(session, **options)


def _replay(run: Any, playing: bool, options: dict[str, Any]) -> Any:
    from ropewalk.live.launch import serve_run

    return serve_run(run, playing=playing, **options)


def _serve(make: Callable[[Announce], Any], no_browser: bool, port: int | None) -> int:
    """Serve what `make` makes until Ctrl-C or SIGTERM; say where, and what was kept.

    `make` may announce its server while the simulation is still being set up.
    """
    server: Any = None
    announced = False

    def announce(made: Any) -> None:
        nonlocal announced
        announced = True
        _announce(made, no_browser, port)

    before = signal.signal(signal.SIGTERM, _as_interrupt)
    try:
        server = make(announce)
        server.start()
        if not announced:
            announce(server)
        while server.wait(0.5):
            pass
    except KeyboardInterrupt:
        if server is None:
            raise
        tell("ending")
    finally:
        signal.signal(signal.SIGTERM, before)
        if server is not None:
            server.stop("The program was ended.")
    if server.keeper is not None:
        if server.keeper.failure:
            warn(server.keeper.failure)
        say(f"run folder: {server.keeper.folder}")
    return 0 if server.error is None else 1


def _announce(server: Any, no_browser: bool, port: int | None) -> None:
    """Say where the page is, and open it."""
    if not server.port_was_free and port != 0:
        tell(f"port {port or 'in use'} is busy: taking {server.port}")
    if server.host not in _LOCAL:
        warn(
            f"listening on {server.host}: whoever can reach this computer and knows the address "
            "can watch and drive the simulation"
        )
    say(server.address)
    tell("Ctrl-C ends")
    if not no_browser:
        from ropewalk.live.browser import open_browser

        open_browser(server.address)


def _as_interrupt(number: int, frame: FrameType | None) -> None:
    raise KeyboardInterrupt
