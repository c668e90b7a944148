"""A rope that parts, on the page: told in words, drawn with a gap, live and in recordings."""

from __future__ import annotations

import json
from collections.abc import Callable
from pathlib import Path
from typing import Any

import numpy as np
import pytest

import ropewalk as rw
from browser.window import Window
from ropewalk.live.launch import serve_run
from ropewalk.live.serve import ViewServer
from ropewalk.live.session import Session
from ropewalk.live.share import share_result
from ropewalk.record.result import Result
from ropewalk.scene import Load, Straight

pytestmark = pytest.mark.browser
Open = Callable[..., Window]
Serve = Callable[..., ViewServer]
WIDE: dict[str, Any] = {"viewport": {"width": 1200, "height": 800}}
WEAK = 13  # segment, of 20
TEXT = "document.getElementById('parted').textContent"
DRAWN = "r.viewport.renderer.line.nodes.ropes.map(({ first, count }) => [first, count])"


def pulled_apart(**more: Any) -> rw.Scene:
    """A rope on a table, pulled at one end; a heavy node in it makes the rope give way there."""
    made_of = rw.Material(
        EA=2000.0, mass_per_length=0.1, axial_damping=0.3, breaking_load=24.0, parts=True
    )
    rope = rw.Rope(
        name="line",
        segments=20,
        length=2.0,
        made_of=made_of,
        shape=Straight(start=(0, 0, 0), end=(2, 0, 0)),
        loads=[Load(node=WEAK, mass=1.0)],
    )
    pull = {"kind": "velocity", "velocity": (1.0, 0.0, 0.0)}
    ends = [rw.Anchor(name="wall", node=0), rw.Anchor(name="hand", node=-1, motion=pull)]
    run = rw.RunSettings(
        method="semi-implicit-euler", time_step=1e-4, duration=0.4, frame_rate=60.0
    )
    return rw.Scene(ropes=[rope], anchors=ends, gravity=(0, 0, 0), run=run, **more)


@pytest.fixture(scope="module")
def result() -> Result:
    made = rw.simulate(pulled_apart())
    assert len(made.partings) == 1
    return made


def words(result: Result) -> str:
    """What the page says of the one parting."""
    (one,) = result.partings
    place = (one.segment + 0.5) * 0.1
    where = f"{place:.3g} m from its start" if place <= 1.0 else f"{2 - place:.3g} m from its end"
    assert one.tension > 24.0
    return f"line parted {where}, at {one.tension:.3g} N, t = "


def _drawn_as(window: Window, ropes: list[list[int]]) -> None:
    """Wait until such ropes are drawn, by their first node and their number of nodes."""
    window.until(f"JSON.stringify({DRAWN}) === '{json.dumps(ropes, separators=(',', ':'))}'")


def _has_a_gap(window: Window, result: Result) -> None:
    """There is rope up to the gap and beyond it, and none in its middle."""
    gone = result.partings[0].segment
    _drawn_as(window, [[0, gone + 1], [gone + 1, 20 - gone]])
    window.settled()
    assert window.at_rope(range(1, gone)) == 1.0
    assert window.at_rope(range(gone + 2, 20)) == 1.0
    (x0, y0), (x1, y1) = window.screen(gone), window.screen(gone + 1)
    assert x1 - x0 > 60.0
    picture = window.picture()
    row, column = round(0.5 * (y0 + y1)), round(0.5 * (x0 + x1))
    around = picture[row - 3 : row + 4, column - 3 : column + 4].reshape(-1, 3)
    assert (around.max(axis=1) - around.min(axis=1)).max() < 40  # paper and grid are nearly grey


def test_a_live_rope_parts_in_words_and_is_two_ropes_then(
    open_window: Open, serve: Serve, result: Result
) -> None:
    server = serve(Session(pulled_apart()))
    window = open_window(server.address, **WIDE).ready()
    window.tell(type="speed", value=0.05)
    _drawn_as(window, [[0, 21]])
    assert not window.page.locator("#parted").is_visible()
    window.press(" ")
    window.until("r.session.layout.variants[0].ropes.length === 2")  # it was cut there
    window.press(" ")
    window.until("r.state === 'paused'")
    said = window.ask(TEXT)
    assert said.startswith(words(result))
    window.heard(said)
    gone = result.partings[0].segment
    _drawn_as(window, [[0, gone + 1], [gone + 1, 20 - gone]])
    # Undone with all else, it is told no more.
    window.click("#reset")
    window.until("r.time === 0 && r.session.layout.variants[0].ropes.length === 1")
    assert not window.page.locator("#parted").is_visible()


@pytest.mark.parametrize("kind", ["replay", "shared"])
def test_a_recording_shows_the_gap_from_then_on(
    open_window: Open, result: Result, tmp_path: Path, kind: str
) -> None:
    server = None
    if kind == "shared":
        share_result(result, tmp_path / "parted.html")
        address = (tmp_path / "parted.html").as_uri()
    else:
        server = serve_run(result, playing=False, port=0)
        server.start()
        address = server.address
    try:
        window = open_window(address, **WIDE).ready()
        window.tell(type="pause")
        when = result.partings[0].time
        window.tell(type="seek", time=max(0.0, when - 0.02))
        window.until(f"r.time < {when} && {TEXT} === ''")
        _drawn_as(window, [[0, 21]])
        window.tell(type="seek", time=when + 0.1)
        window.until(f"r.time > {when} && {TEXT} !== ''")
        assert window.ask(TEXT).startswith(words(result))
        _has_a_gap(window, result)
        window.tell(type="seek", time=0.0)  # and it is whole again
        window.until(f"r.time === 0 && {TEXT} === ''")
        _drawn_as(window, [[0, 21]])
    finally:
        if server is not None:
            server.stop()


def test_a_gap_in_a_live_rope_is_drawn_while_it_is_one(
    open_window: Open, serve: Serve, result: Result
) -> None:
    """Until the whole rope has heard of it, it is one rope with a gap."""
    server = serve(Session(pulled_apart()))
    window = open_window(server.address, **WIDE).ready()
    count = round(result.partings[0].time / 1e-4) + 2
    window.tell(type="step", count=count)
    window.until(f"{TEXT} !== ''")
    assert window.ask("r.session.layout.variants[0].ropes.length") == 1
    gone = result.partings[0].segment
    _drawn_as(window, [[0, gone + 1], [gone + 1, 20 - gone]])
    assert np.isfinite(window.node(gone)).all()
