"""The page to share: opened from disk, with the network off, scrubbed; and what it says it holds."""

from __future__ import annotations

import re
from collections.abc import Callable
from pathlib import Path

import numpy as np
import pytest

import ropewalk as rw
import runs
from browser.window import Window
from live.drive import slack_rope
from ropewalk.record.result import Result

pytestmark = pytest.mark.browser
NAME = '<img src=x onerror="window.bad=1"></script><script>window.bad=2</script>'
Open = Callable[..., Window]


@pytest.fixture(scope="module")
def result(tmp_path_factory: pytest.TempPathFactory) -> Result:
    """Two seconds of a rope of which one end falls, under a name made of markup."""
    scene = slack_rope(name=NAME)
    free = scene.model_copy(update={"anchors": scene.anchors[:1]})
    folder = tmp_path_factory.mktemp("share") / "run"
    return rw.run(
        free.model_copy(update={"run": free.run.model_copy(update={"duration": 2.0})}), folder
    )


@pytest.fixture
def window(result: Result, tmp_path: Path, open_window: Open) -> Window:
    """The page, from disk, offline."""
    page = result.share(tmp_path / "page.html")
    return open_window(page.as_uri(), offline=True).ready()


def test_opens_from_disk_without_network(window: Window) -> None:
    asked: list[str] = []
    window.page.on("request", lambda request: asked.append(request.url))
    window.page.reload()
    window.ready()
    assert [url for url in asked if not url.startswith(("file:", "data:", "blob:"))] == []
    window.until("r.time > 0.1")  # it plays by itself


def test_name_is_text(window: Window) -> None:
    assert window.page.locator(".scene-name").inner_text() == NAME
    assert window.page.title().startswith(NAME)
    assert window.page.evaluate("() => window.bad") is None
    assert window.page.locator("img").count() == 0


def test_there_is_no_empty_panel_to_open(window: Window) -> None:
    window.press("p")
    assert window.page.locator(".panel").is_hidden()


def test_scrubbed_to_what_the_run_says(window: Window, result: Result) -> None:
    window.page.keyboard.press("Space")
    window.until("r.state === 'paused'")
    longest = 10.0
    allowed = max(1e-4, 1e-5 * longest) * np.sqrt(3.0)
    for time in (1.5, 0.25, 1.0):
        window.page.locator("#seek").fill(str(time))
        window.until(f"Math.abs(r.time - {time}) < 0.02")
        now = window.ask("r.time")
        frame = result.frame_at(now)
        assert result.time[frame] == pytest.approx(now, abs=1e-6)
        wanted = result.read("positions", frame, frame + 1)[0]
        there = np.array([window.node(node) for node in range(0, 41, 5)])
        assert np.abs(there - wanted[::5]).max() < allowed
        # The twin: the frames beside it are other ones.
        other = result.read("positions", frame + 3, frame + 4)[0]
        assert np.abs(there - other[::5]).max() > 10.0 * allowed
    window.settled()
    assert window.at_rope(range(1, 40)) > 0.9


def test_keys_speed_and_colours_work(window: Window) -> None:
    window.page.keyboard.press("Space")
    window.until("r.state === 'paused'")
    window.page.locator("#seek").fill("0.5")
    window.until("Math.abs(r.time - 0.5) < 0.02")
    before = window.ask("r.time")
    window.page.locator("#view").focus()  # a slider in focus keeps its keys
    window.page.keyboard.press(".")
    window.until(f"r.time > {before}")
    window.page.locator("#speed").fill("3")
    window.until("r.session.status.speed === 0.1")
    for colouring, unit in (("strain", "%"), ("speed", "m/s"), ("tension", "N")):
        window.page.locator("#colouring").select_option(colouring)
        window.page.locator("#legend-numbers").get_by_text(unit).first.wait_for()
    window.page.locator("#view").focus()
    window.page.keyboard.press("g")
    assert window.page.locator("#graphs canvas").count() >= 3
    window.page.keyboard.press("r")
    window.until("r.time === 0")


def test_plays_to_the_end_and_again(window: Window) -> None:
    window.page.locator("#seek").fill("1.9")
    window.until("r.state === 'paused' && Math.abs(r.time - 2) < 0.02")
    window.page.locator("#speed").fill("3")  # a tenth: its first second is seen on any computer
    window.page.locator("#view").focus()
    window.page.keyboard.press("Space")
    window.until("r.state === 'playing' && r.time < 1")


def test_a_broken_run_ends_in_its_break_marked_as_such(tmp_path: Path, open_window: Open) -> None:
    broken = rw.simulate(runs.breaking(), on_failure="return")
    assert broken.beyond is not None
    page = broken.share(tmp_path / "page.html")
    window = open_window(page.as_uri(), offline=True).ready()
    card = window.page.locator("#broken")
    window.until(f"r.time > {broken.time[-1] + 1e-3}")
    card.wait_for()
    text = card.inner_text()
    assert "The run broke" in text
    assert broken.diagnosis[:40] in text
    assert "past the last good frame" in text
    there = np.array([window.node(node) for node in range(11)])
    assert np.abs(there - broken.beyond.positions[0]).max() < 1e-3
    assert window.ask("r.app.graphs.history.last") <= broken.time[-1] + 1e-6
    window.page.locator("#seek").fill("0.05")
    window.until("r.time < 0.06")
    card.wait_for(state="hidden")


def test_a_damaged_page_says_so(result: Result, tmp_path: Path, open_window: Open) -> None:
    page = result.share(tmp_path / "page.html")
    whole = page.read_text()
    at = whole.index('id="recording-data">') + 4000
    page.write_text(whole[:at] + "A" * 200 + whole[at + 200 :])
    window = open_window(page.as_uri(), offline=True)
    window.until("r.state === 'damaged'")
    banner = window.page.locator("#banner")
    assert banner.is_visible()
    assert "This page cannot be shown" in banner.inner_text()
    assert "again" not in banner.inner_text()


def test_says_how_true_it_is(window: Window) -> None:
    window.page.keyboard.press("h")
    text = window.page.locator("#about").inner_text()
    assert "tension to within" in text
    assert re.search(r"positions are rounded to within \d{2} µm", text)


def test_graphs_hold_all_up_to_the_place_sought(window: Window) -> None:
    window.press("g")
    window.tell(type="pause")  # it may have come to its end: the key would begin it anew
    window.page.locator("#graph-window").select_option("2")
    window.page.locator("#seek").fill("1.9")
    window.until("Math.abs(r.time - 1.9) < 0.02")
    window.page.locator("#graph-window").select_option("all")
    columns = "r.app.graphs.history.between(0, 2, ['kinetic', 'tension_max'])"
    window.until(f"{columns}[0].length > 100 && {columns}[0][0] < 0.02")
    kinetic = np.array(window.ask(f"[...{columns}[1]]"))
    assert np.isfinite(kinetic).all()
    assert kinetic.max() > kinetic[0]  # it falls
    window.page.locator("#seek").fill("0.5")
    window.until("Math.abs(r.app.graphs.history.last - 0.5) < 0.02")
    assert window.ask("r.app.graphs.history.first") < 0.02  # at once: it was known already
