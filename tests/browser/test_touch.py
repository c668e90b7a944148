"""Contacts of ropes on ropes as arrows; wraps and friction's work in words: live, replayed, shared."""

from __future__ import annotations

import re
from collections.abc import Callable
from contextlib import ExitStack
from pathlib import Path

import numpy as np
import pytest

import ropewalk as rw
from browser.window import Window
from live.test_touch import over_a_drum
from ropewalk.live import touch
from ropewalk.live.launch import serve_run
from ropewalk.live.serve import ViewServer
from ropewalk.live.session import Session
from ropewalk.record.result import Result
from ropewalk.scene.presets import preset

pytestmark = pytest.mark.browser
Open = Callable[..., Window]
Serve = Callable[..., ViewServer]
TALL = {"viewport": {"width": 1200, "height": 800}}
ARROWS = "r.viewport.marks.touches.map(({ from, to }) => [[...from], [...to]])"
# Top and bottom of what stands at the left, the tools and the legend below them [px].
OVERLAP = """[".toolbar", ".legend"].map((name) => {
    const boxes = [...document.querySelectorAll(name)].map((one) => one.getBoundingClientRect());
    const { top, bottom } = boxes.reduce((a, b) => (b.left < a.left ? b : a));
    return [top, bottom];
})"""


def numbers(text: str) -> list[float]:
    """Return the numbers in a text."""
    return [float(one) for one in re.findall(r"\d+(?:\.\d+)?", text)]


def test_either_rope_has_an_arrow_at_each_contact(open_window: Open, serve: Serve) -> None:
    """They begin where the ropes touch and point apart; their scale is told, a switch hides them."""
    server = serve(Session(preset("overhand"), "overhand"))
    window = open_window(server.address, **TALL).ready()
    window.tell(type="step", count=120)
    window.settled()
    simulation = server.broadcast.session.main.simulation
    pairs = simulation.recording().pairs[0]
    pairs = pairs[np.isfinite(pairs[:, 0])]
    size = np.linalg.norm(pairs[:, 5:8], axis=1)
    seen = pairs[size >= 0.03 * size.max()]
    arrows = np.array(window.ask(ARROWS))
    assert len(arrows) == 2 * len(seen) > 8
    starts, ways = arrows[:, 0], arrows[:, 1] - arrows[:, 0]
    x = simulation.positions
    for number, (first, second, at, other, *_) in enumerate(seen):
        here, there = 2 * number, 2 * number + 1
        for row, segment, share in ((here, first, at), (there, second, other)):
            node = int(segment)
            place = (1.0 - share) * x[node] + share * x[node + 1]
            assert starts[row] == pytest.approx(place, abs=1e-4)
        assert ways[here] == pytest.approx(-ways[there], abs=1e-6)
        assert ways[here] @ (starts[here] - starts[there]) > 0.0
    scale = window.page.locator("#contact-scale").inner_text()
    assert numbers(scale)[0] == pytest.approx(size.max(), rel=0.05)
    assert scale.endswith("N")
    assert window.page.locator("#contacts-left-out").is_hidden()
    window.click("#show-contacts")
    window.until("r.viewport.marks.touches.length === 0")
    window.page.locator("#contact-scale").wait_for(state="hidden")


def test_it_says_when_not_all_contacts_have_arrows(
    open_window: Open, serve: Serve, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(touch, "MOST_PAIRS", 5)
    server = serve(Session(preset("overhand"), "overhand"))
    window = open_window(server.address, **TALL).ready()
    window.tell(type="step", count=120)
    window.settled()
    pairs = server.broadcast.session.main.simulation.recording().pairs[0]
    size = np.sort(np.linalg.norm(pairs[np.isfinite(pairs[:, 0]), 5:8], axis=1))
    told = numbers(window.page.locator("#contacts-left-out").inner_text())
    assert told[:2] == [5.0, float(len(size))]
    assert told[2] == pytest.approx(100.0 * size[-5:].sum() / size.sum(), abs=0.6)
    assert len(window.ask(ARROWS)) <= 10


def test_a_wrap_is_told_in_words_and_numbers(open_window: Open, serve: Serve) -> None:
    server = serve(Session(preset("capstan"), "capstan"))
    window = open_window(server.address, **TALL).ready()
    window.tell(type="step", count=10)
    window.settled()
    text = window.page.locator("#wrap-list").inner_text()
    angle, light, heavy, ratio, slip, share = numbers(text)
    assert text.startswith("drum: ")
    assert angle == pytest.approx(540.0, abs=4.0)
    assert light == pytest.approx(9.81 + 0.2, rel=0.1)
    assert heavy == pytest.approx(12 * 9.81, rel=0.1)
    assert ratio == pytest.approx(heavy / light, rel=0.02)
    assert slip == pytest.approx(np.exp(0.3 * np.radians(angle)), rel=0.05)
    assert share == pytest.approx(100.0 * np.log(ratio) / np.log(slip), abs=1.0)
    assert "Friction" in window.page.locator("#friction-taken").inner_text()
    (_, tools), (legend, _) = window.ask(OVERLAP)
    assert legend >= tools
    # The twin: where nothing is touched nothing is told.
    window.tell(type="scene", preset="r4")
    window.until(
        "r.session.layout.obstacles.length === 0 && document.querySelector('#wraps').hidden"
    )


def test_a_short_window_has_them_folded_away(open_window: Open, serve: Serve) -> None:
    server = serve(Session(preset("capstan"), "capstan"))
    window = open_window(server.address).ready()
    window.settled()
    assert not window.page.locator("#wrap-list").is_visible()
    for _ in range(2):
        (_, tools), (legend, _) = window.ask(OVERLAP)
        assert legend >= tools - 1.0
        window.click("#wraps summary")
        window.settled()
    window.click("#wraps summary")
    assert "drum: " in window.page.locator("#wrap-list").inner_text()


def test_a_line_on_constant_forces_takes_its_room_from_the_wraps(
    open_window: Open, serve: Serve
) -> None:
    """The legend lay over the lowest tool."""
    server = serve(Session(preset("clove-hitch"), "clove-hitch"))
    window = open_window(server.address, viewport={"width": 1280, "height": 800}).ready()
    window.tell(type="step", count=40)
    window.settled()
    if not window.page.locator("#wrap-list").is_visible():
        window.click("#wraps summary")
    window.settled()
    window.page.evaluate(
        "() => { for (let k = 0; k < 9; k++) {"
        " const line = document.createElement('p'); line.textContent = `wrap ${k}`;"
        " document.querySelector('#wraps').append(line); } }"
    )
    window.page.evaluate("() => { document.querySelector('.balance').hidden = true; }")
    assert "constant forces" in window.page.locator("#given").inner_text()
    (_, tools), (legend, _) = window.ask(OVERLAP)
    assert legend >= tools


@pytest.mark.parametrize("shared", [True, False])
def test_replays_tell_what_the_run_has(open_window: Open, tmp_path: Path, shared: bool) -> None:
    run = rw.run(over_a_drum(), tmp_path / "run")
    with ExitStack() as stack:
        if shared:
            address = run.share(tmp_path / "page.html").as_uri()
        else:
            server = serve_run(run, port=0, playing=False)
            server.start()
            stack.callback(server.stop)
            address = server.address
        tells_what_it_has(open_window(address, **TALL).ready(), run)


def tells_what_it_has(window: Window, run: Result) -> None:
    """Seek a time, and compare what the page says with the run's tables."""
    if window.ask("r.state") == "playing":
        window.page.keyboard.press("Space")
    window.until("r.state === 'paused'")
    for time in (0.14, 0.2):  # 0.14 was told as it was at 0.1 s
        window.page.locator("#seek").fill(str(time))
        window.until(f"Math.abs(r.time - {time}) < 1e-6")
        window.settled()
        told = numbers(window.page.locator("#wrap-list").inner_text())
        every = run.to_pandas("wraps", times=[time])
        (table,) = every[every["obstacle"] == "drum"].to_dict("records")
        assert told[0] == pytest.approx(np.degrees(table["angle [rad]"]), abs=1.0)
        assert told[3] == pytest.approx(table["ratio [1]"], rel=0.01)
        assert told[4] == pytest.approx(table["ratio at slip [1]"], rel=0.02)
    took = -run.contact_work["drum"]["friction"][-1]
    text = window.page.locator("#friction-taken").inner_text()
    assert "on drum" in text
    per = {"J": 1.0, "mJ": 1e-3}[text.split(" on drum")[0].split()[-1]]
    assert numbers(text)[0] * per == pytest.approx(took, rel=0.01)
