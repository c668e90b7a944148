"""What a page keeps: the run, bit for bit; files; the link; and the page that replays a run."""

from __future__ import annotations

import shlex
from collections.abc import Callable, Iterator
from pathlib import Path

import numpy as np
import pytest
from PIL import Image

from browser.window import Window
from live.drive import slack_rope
from ropewalk.live.keeper import parts
from ropewalk.live.launch import serve_run
from ropewalk.live.relive import relive
from ropewalk.live.serve import ViewServer
from ropewalk.live.session import Session
from ropewalk.live.sources import scene_at
from ropewalk.record.result import Result
from ropewalk.scene import loads
from ropewalk.scene.presets import preset

pytestmark = pytest.mark.browser
Open = Callable[..., Window]
Serve = Callable[..., ViewServer]


def _lively(window: Window) -> None:
    """Do a bit of everything, and pause."""
    window.press(" ")
    window.take(20, (0.0, -60.0))
    window.until("r.time > 0.4")
    window.page.mouse.up()
    window.tell(type="set", name="mass", value=3.0)
    window.page.keyboard.down("ArrowUp")
    window.until("r.time > 0.7")
    window.page.keyboard.up("ArrowUp")
    window.tell(type="pin", node=30)
    window.until("r.time > 1")
    window.press(" ")
    window.until("r.state === 'paused'")


def _keep(window: Window, item: str) -> Path:
    """Take something from the menu of what can be kept."""
    window.click("#open-keep")
    with window.page.expect_download() as got:
        window.click(f"#keep-{item}")
    return Path(got.value.path())


def test_a_session_is_saved_and_replays_to_the_same_bits(
    open_window: Open, serve: Serve, tmp_path: Path
) -> None:
    server = serve(Session(slack_rope()))
    window = open_window(server.address).ready()
    _lively(window)
    session, folder = server.broadcast.session, tmp_path / "run"
    window.tell(type="step", count=session.frame_steps - session.count % session.frame_steps)
    window.click("#open-keep")
    window.click("#keep-save")
    window.heard(f"Saved in {folder}")
    last = Result.open(parts(folder)[-1])
    shown = np.array([window.node(node) for node in range(41)])
    assert np.array_equal(last.positions[-1], session.main.simulation.positions)
    assert np.allclose(last.positions[-1], shown, atol=1e-6)
    server.stop()
    again = relive(folder)
    assert again.count == session.count
    for name in ("positions", "velocities"):
        mine, other = (getattr(one.main.simulation, name) for one in (session, again))
        assert np.array_equal(mine, other)
    assert again.scene == session.scene


def test_pictures_tables_and_scenes_are_downloaded(open_window: Open, serve: Serve) -> None:
    server = serve(Session(slack_rope()))
    window = open_window(server.address).ready()
    _lively(window)
    picture = np.asarray(Image.open(_keep(window, "png")).convert("RGB")).astype(int)
    assert picture.shape[1] >= window.ask("r.viewport.camera.width")
    assert (picture.max(axis=2) - picture.min(axis=2) > 60).sum() > 200  # a rope is on it
    scene = loads(_keep(window, "scene-toml").read_text())
    assert scene.ropes[0].own_mass == pytest.approx(3.0)
    place = Session(scene).main.simulation.positions
    assert np.allclose(place, server.broadcast.session.main.simulation.positions, atol=1e-9)
    for item in ("nodes-csv", "energies-csv", "tension-csv"):
        lines = _keep(window, item).read_text().splitlines()
        assert lines[0].startswith("time")
        assert len(lines) > 10
    page = _keep(window, "page-html")
    shared = open_window(page.rename(page.with_suffix(".html")).as_uri(), offline=True).ready()
    shared.until("r.time > 0.1")


def test_a_link_opens_the_same_set_up(open_window: Open, serve: Serve, tmp_path: Path) -> None:
    window = open_window(serve().address).ready()
    window.page.context.grant_permissions(["clipboard-read", "clipboard-write"])
    window.tell(type="set", name="mass", value=3.5)
    window.until("location.hash.includes('mass')")
    window.click("#open-keep")
    window.click("#keep-link")
    window.heard("The link is copied")
    link = window.page.evaluate("() => navigator.clipboard.readText()")
    assert link == window.page.url
    other = serve(Session(slack_rope()), folder=tmp_path / "other")
    second = open_window(f"{other.address}#{link.split('#')[1]}").ready()
    second.until("r.session.layout.scene.preset === 'r4'")
    second.until(
        "r.session.parameters.find((p) => p.name === 'mass').value.toFixed(9) === '3.500000000'"
    )
    assert other.broadcast.session.scene.ropes[0].own_mass == pytest.approx(3.5)
    window.click("#open-keep")
    window.click("#keep-command")
    window.heard("The command is copied")
    command = window.page.evaluate("() => navigator.clipboard.readText()")
    program, view, at, address = shlex.split(command)
    assert [program, view, at] == ["ropewalk", "view", "--at"]
    assert scene_at(address, (preset("r3"), "r3")).ropes[0].own_mass == pytest.approx(3.5)


@pytest.fixture
def recorded(tmp_path: Path) -> Iterator[tuple[ViewServer, Result]]:
    """A run of two seconds, replayed."""
    import ropewalk as rw

    scene = slack_rope()
    scene = scene.replace(anchors=scene.anchors[:1], run=scene.run.replace(duration=2.0))
    result = rw.run(scene, tmp_path / "recorded")
    server = serve_run(tmp_path / "recorded", port=0, playing=False)
    server.start()
    yield server, result
    server.stop()


def _whole_run_in_graphs(window: Window, result: Result) -> None:
    """Check that the graphs hold the run from its start to the place sought, also of a new node."""
    window.tell(type="seek", time=2.0)
    window.until("Math.abs(r.time - 2) < 0.02 && r.app.graphs.history.last === r.time")
    window.page.locator("#graph-window").select_option("2")
    window.page.evaluate("() => window.ropewalk.app.follow(20)")
    heights = "r.app.graphs.history.between(0, 2, ['height 20', 'kinetic'])"
    window.until(f"{heights}[1]?.length > 100 && {heights}[1].every(Number.isFinite)")
    times, height, kinetic = (np.array(one) for one in window.ask(f"{heights}.map((c) => [...c])"))
    assert times[0] < 0.02
    assert np.diff(times).max() < 0.05
    assert np.allclose(height, np.interp(times, result.time, result.positions[:, 20, 2]), atol=1e-4)
    energy = result.read("energy")[:, 0]
    assert np.allclose(kinetic, np.interp(times, result.time, energy), atol=1e-4 * energy.max())
    window.page.locator("#graph-window").select_option("all")
    ends = "(({min, max}) => [min, max])(r.app.graphs.panels.get('energies').plot.uplot.scales.x)"
    window.until(f"{ends}[0] < 0.02 && {ends}[1] > 1.98")


def test_a_run_is_replayed_sought_and_exported(
    recorded: tuple[ViewServer, Result], open_window: Open
) -> None:
    server, result = recorded
    window = open_window(server.address).ready()
    window.tell(type="speed", value=0.1)  # it is paused long before its end
    window.press(" ")
    window.until("r.state === 'playing' && r.time > 0.1")
    window.press(" ")
    window.until("r.state === 'paused'")
    for time in (1.5, 0.25, 1.0):
        window.page.locator("#seek").fill(str(time))
        window.until(f"Math.abs(r.time - {time}) < 0.02")
        frame = result.frame_at(window.ask("r.time"))
        there = np.array([window.node(node) for node in range(0, 41, 5)])
        assert np.allclose(there, result.read("positions", frame, frame + 1)[0][::5], atol=1e-5)
    window.settled()
    assert window.at_rope(range(1, 40)) > 0.9
    for hidden in ("#open-compare", "#open-tour", "#toggle-panel", "#tool-pin", "#tool-cut"):
        assert not window.page.locator(hidden).is_visible()
    window.press(".")
    window.until("r.time > 1.01")
    window.click("#toggle-graphs")
    window.until("r.app.graphs.history.first < 0.1")  # what was before the place sought
    _whole_run_in_graphs(window, result)
    window.press("r")
    window.until("r.time === 0")
    lines = _keep(window, "nodes-csv").read_text().splitlines()
    assert len(lines) == 1 + result.frames * result.nodes
    assert loads(_keep(window, "scene-toml").read_text()).anchors == result.scene.anchors
    Image.open(_keep(window, "png")).verify()
