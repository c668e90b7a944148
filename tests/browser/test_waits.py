"""What the page says while the server looks for rest, and what may be done meanwhile."""

from __future__ import annotations

import threading
from collections.abc import Callable, Iterator
from typing import Any

import pytest

from browser.window import Window
from live.drive import slack_rope
from patience import PATIENCE
from ropewalk.live.anew import Anew
from ropewalk.live.session import Session
from ropewalk.live.track import Track

pytestmark = pytest.mark.browser
Open = Callable[..., Window]
Serve = Callable[..., Any]


@pytest.fixture
def gate(monkeypatch: pytest.MonkeyPatch) -> Iterator[threading.Event]:
    """What a search for rest waits for."""
    made, tracks = threading.Event(), Anew.tracks

    def slowly(self: Anew) -> list[Track]:
        made.wait(PATIENCE)
        return tracks(self)

    monkeypatch.setattr(Anew, "tracks", slowly)
    yield made
    made.set()


def test_that_rest_is_looked_for_is_said_and_the_page_may_be_used(
    open_window: Open, serve: Serve, gate: threading.Event
) -> None:
    session = Session(slack_rope().replace(**{"run.start": "at-rest"}))
    server = serve(session, playing=True)
    window, other = open_window(server.address).ready(), open_window(server.address).ready()
    window.until("r.time > 0.05")
    window.click("#reset")
    window.click("#reset")  # out of patience: it is one
    for one in (window, other):
        one.until("document.getElementById('slow').innerText.includes('Looking for the ropes')")
        one.page.locator("#slow .spinner").wait_for()
    time = other.ask("r.time")
    other.until(f"r.time > {time}")
    window.press(" ")
    window.until("r.state === 'paused'")
    gate.set()
    for one in (window, other):
        one.until("r.time === 0 && document.getElementById('slow').hidden")
    assert window.ask("r.state") == "paused"
    window.settled()
    assert window.ask("r.time") == 0.0
