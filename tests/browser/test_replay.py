"""A page that replays what a server has: plays by itself, fetches frames as it goes, tells of faults."""

from __future__ import annotations

import shutil
from collections.abc import Callable, Iterator
from contextlib import ExitStack
from pathlib import Path

import numpy as np
import pytest

import ropewalk as rw
from browser.window import Window
from live.drive import do, r4, slack_rope
from live.test_seen import catch
from ropewalk.live.keeper import Keeper
from ropewalk.live.launch import serve_run
from ropewalk.live.serve import ViewServer
from ropewalk.record.result import Result

pytestmark = pytest.mark.browser
Open = Callable[..., Window]
Serving = Callable[..., ViewServer]
FRAMES = "r.session.source.frames"


@pytest.fixture
def serving() -> Iterator[Serving]:
    """Serve runs."""
    with ExitStack() as stack:

        def make(run: Path | Result, *, playing: bool = False) -> ViewServer:
            server: ViewServer = serve_run(run, playing=playing, port=0)
            server.start()
            stack.callback(server.stop)
            return server

        yield make


def two_seconds() -> Result:
    scene = slack_rope()
    return rw.simulate(scene.replace(run=scene.run.replace(duration=2.0)))


def test_every_page_plays_by_itself(open_window: Open, serving: Serving) -> None:
    server = serving(two_seconds())
    one, other = (open_window(server.address).ready() for _ in range(2))
    one.tell(type="seek", time=1.5)
    one.until("Math.abs(r.time - 1.5) < 0.02")
    other.tell(type="speed", value=0.1)  # it is looked at long before its end
    other.press(" ")
    other.until("r.state === 'playing' && r.time > 0.1")
    assert one.ask("r.state") == "paused"
    assert one.ask("Math.abs(r.time - 1.5) < 0.02")
    assert other.ask("r.time") < 1.5
    server.stop("Enough of this.")
    other.page.get_by_text("Enough of this.").first.wait_for()


KEEP_BANNER = """() => {
  window.ropewalk.session.on("connection", ({ state }) => {
    if (state !== "open") window.firstWords ??= document.getElementById("banner").innerText;
  });
}"""


def test_a_lost_server_is_no_run_that_goes_on(open_window: Open, serving: Serving) -> None:
    server = serving(two_seconds())
    window = open_window(server.address).ready()
    text = "The connection to the server is lost."
    window.page.evaluate(KEEP_BANNER)  # it says something else as soon as it has tried again
    window.page.context.set_offline(True)
    server.hub.tell = lambda message: None  # no farewell
    server.stop()
    said = window.until("window.firstWords")
    assert "goes on there" not in said
    assert said.startswith((text, "The server has ended"))


def test_peaks_of_frames_passed_over_are_shown(open_window: Open, serving: Serving) -> None:
    result = rw.simulate(catch(1000.0))
    peak = float(result.greatest_tension.max())
    assert peak > 1.1 * float(result.tension[::16].max())  # the twin: frames alone miss it
    window = open_window(serving(result).address).ready()
    window.page.evaluate(
        """() => {
          const r = window.ropewalk;
          const at = r.session.layout.scalars.indexOf("tension_max");
          r.steps = [];
          r.session.on("frame", ({ steps, parts: [part] }) => r.steps.push([steps, part.scalars[at]]));
        }"""
    )
    window.tell(type="play")
    window.until(f"r.steps.at(-1)?.[0] === {result.frames - 1} && r.state === 'paused'")
    shown = np.array(window.ask("r.steps"))
    assert shown[-1, 0] == result.frames - 1
    assert len(shown) < result.frames / 8
    assert shown[:, 1].max() == pytest.approx(peak, rel=1e-6)


def test_a_cut_up_session_is_played_across_its_parts(
    open_window: Open, serving: Serving, tmp_path: Path
) -> None:
    session = r4()
    keeper = Keeper(session, tmp_path / "run")
    session.advance(180)
    do(session, "pin", node=10)
    session.advance(90)
    keeper.close()
    window = open_window(serving(tmp_path / "run").address).ready()
    anchors = "r.session.layout.variants[0].anchors.length"
    before = window.ask(anchors)
    window.tell(type="play")
    window.until(f"{anchors} === {before + 1} && r.state === 'paused'")
    assert window.ask("r.time") == pytest.approx(270 * session.main.dt)
    assert window.ask(f"{FRAMES}.kept.size") <= 32
    window.tell(type="seek", time=0.0)
    window.until(f"r.time === 0 && {anchors} === {before}")
    window.press("g")
    window.tell(type="seek", time=270 * session.main.dt)
    window.until("r.app.graphs.history.first === 0 && r.app.graphs.history.last === r.time")


def test_a_run_that_is_damaged_meanwhile_is_told_of(
    open_window: Open, serving: Serving, tmp_path: Path
) -> None:
    rw.run(slack_rope().replace(run=slack_rope().run.replace(duration=0.5)), tmp_path / "run")
    window = open_window(serving(tmp_path / "run").address).ready()
    for path in (tmp_path / "run").rglob("positions"):
        shutil.rmtree(path)
    window.page.evaluate("() => window.ropewalk.session.tell({ type: 'seek', time: 0.4 }) && 0")
    window.heard(str(tmp_path / "run"))
    window.faults.clear()  # the browser's own words for an answer that is a fault
