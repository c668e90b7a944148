"""What a small window leaves in sight: one graph with its names, and the ways out of a break."""

from __future__ import annotations

from collections.abc import Callable

import pytest

from browser.window import Window
from ropewalk.live.serve import ViewServer

pytestmark = pytest.mark.browser

Open, Serve = Callable[..., Window], Callable[..., ViewServer]


def test_a_window_made_low_keeps_one_graph(window: Window) -> None:
    window.press("g")
    window.until("document.querySelectorAll('.plot').length === 3")
    window.page.set_viewport_size({"width": 844, "height": 390})
    window.until("document.querySelectorAll('.plot').length === 1")
    names = window.page.locator(".u-legend .u-series:not(:first-child)")
    box = window.page.locator(".u-legend").bounding_box()
    low = [one.bounding_box() for one in names.all()]
    assert len(low) == 4
    assert all(one["y"] + one["height"] <= box["y"] + box["height"] + 1.0 for one in low)


def test_opened_words_about_a_break_leave_its_buttons(open_window: Open, serve: Serve) -> None:
    window = open_window(serve().address, viewport={"width": 390, "height": 600}).ready()
    assert window.tell(type="set", name="spring_constant", value=40000.0)
    window.press(" ")
    window.until("r.state === 'broken'")
    window.until("document.querySelectorAll('.broken .row button').length >= 2")
    window.click(".broken summary")
    card = window.page.locator(".broken")
    assert window.ask(
        "(({ scrollHeight: all, clientHeight: seen }) => all > seen)"
        "(document.querySelector('.broken'))"
    )  # the twin: there is more than is seen
    box = card.bounding_box()
    for button in card.locator(".row button").all():
        one = button.bounding_box()
        assert one["y"] >= box["y"]
        assert one["y"] + one["height"] <= box["y"] + box["height"]
