"""The legend says what the colours mean, however little room there is, and says so where they end."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path

import pytest

import ropewalk as rw
from browser.window import Window
from ropewalk.live.serve import ViewServer
from ropewalk.live.session import Session
from ropewalk.live.share import share_result
from ropewalk.scene.presets import preset

pytestmark = pytest.mark.browser

Open, Serve = Callable[..., Window], Callable[..., ViewServer]
SCALE = ["#legend-numbers", ".legend .map"]


def test_graphs_leave_the_colour_scale(open_window: Open, serve: Serve) -> None:
    size = {"width": 1024, "height": 760}  # one in which wraps, where there are any, are open
    window = open_window(serve().address, viewport=size).ready()
    parts = [*SCALE, "#colouring"]
    assert all(window.page.locator(part).is_visible() for part in parts)
    assert window.ask("document.querySelector('#wraps').open")
    window.press("g")
    window.until("!document.getElementById('graphs').hidden")
    assert all(window.page.locator(part).is_visible() for part in parts)
    window.page.set_viewport_size({"width": 390, "height": 844})
    window.until("document.getElementById('scene').clientHeight < 400")  # no room for the menu
    assert all(window.page.locator(part).is_visible() for part in SCALE)


def test_past_a_break_the_scale_says_that_there_is_more(tmp_path: Path, open_window: Open) -> None:
    result = rw.simulate(preset("r7"), on_failure="return")
    page = share_result(result, tmp_path / "broken.html")
    window = open_window(page.as_uri(), offline=True)
    window.until("r.frames > 0")
    numbers = window.page.locator("#legend-numbers")
    assert "≥" not in numbers.inner_text()  # the twin
    seek = window.page.locator("#seek")
    seek.fill(seek.get_attribute("max") or "")
    window.until("r.session.frame.flags & 2")
    window.settled()
    assert "≥ " in numbers.inner_text()


def test_wraps_are_told_on_a_phone_that_lies(open_window: Open, serve: Serve) -> None:
    """They were left out; opened, they stand above the row, which stays."""
    server = serve(Session(preset("bollard"), "bollard"))
    window = open_window(server.address, viewport={"width": 844, "height": 390}).ready()
    window.tell(type="step", count=2)
    summary = window.page.locator("#wraps summary")
    assert summary.is_visible()
    summary.click()
    words = window.page.locator("#wrap-list")
    assert words.is_visible()
    assert "slips at" in words.inner_text()
    assert all(window.page.locator(part).is_visible() for part in [*SCALE, "#colouring"])
    row = window.page.locator(".legend").bounding_box()
    above = window.page.locator(".wraps-body").bounding_box()
    assert above["y"] > 0
    assert above["y"] + above["height"] <= row["y"]


def test_on_a_phone_that_stands_stands_can_be_hidden(open_window: Open, serve: Serve) -> None:
    window = open_window(serve().address, viewport={"width": 390, "height": 844}).ready()
    assert window.page.locator("#show-posts").is_visible()


@pytest.mark.parametrize("size", [(390, 844), (360, 640)], ids=["phone", "small"])
def test_nothing_stands_out_of_the_card_on_a_phone(
    open_window: Open, serve: Serve, size: tuple[int, int]
) -> None:
    """The colours, and the newtons of the longest arrow, reached beyond its edge."""
    server = serve(Session(preset("clove-hitch"), "clove-hitch"))
    window = open_window(server.address, viewport=dict(zip(("width", "height"), size, strict=True)))
    window.ready().tell(type="step", count=20)
    window.settled()
    window.page.locator("#wraps summary").click()
    assert window.page.locator("#contact-scale").inner_text().startswith("longest")
    edge, furthest = window.ask(
        """[document.querySelector(".legend").getBoundingClientRect().right,
            Math.max(...[...document.querySelectorAll(".legend *")].map(
              (one) => one.getBoundingClientRect().right))]"""
    )
    assert furthest < edge - 4
