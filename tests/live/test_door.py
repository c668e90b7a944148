"""The page is served before the simulation is there, and told when it never will be."""

from __future__ import annotations

import threading
import urllib.error
import urllib.request
from collections.abc import Iterator

import pytest

from live.drive import slack_rope
from live.pages import Page
from patience import PATIENCE
from ropewalk.live.broadcast import Broadcast
from ropewalk.live.launch import prepare
from ropewalk.live.serve import ViewServer
from ropewalk.live.session import Session
from ropewalk.scene import SceneError


@pytest.fixture
def server() -> Iterator[ViewServer]:
    made = ViewServer(port=0)
    made.start()
    yield made
    made.stop()


def test_the_page_comes_first_and_its_socket_when_there_is_something_to_see(
    server: ViewServer,
) -> None:
    with urllib.request.urlopen(server.address, timeout=PATIENCE) as answer:
        assert b"<script" in answer.read()
    came: list[Page] = []
    waiting = threading.Thread(target=lambda: came.append(Page(server, open_timeout=PATIENCE)))
    waiting.start()
    waiting.join(0.5)
    assert waiting.is_alive()
    server.show(Broadcast(Session(slack_rope(20)), playing=False), title="late")
    waiting.join(PATIENCE)
    with came[0] as page:
        assert page.message("hello")["title"] == "late"
        assert page.message("layout")["variants"][0]["nodes"] == 21


def test_a_page_is_told_why_nothing_comes(server: ViewServer) -> None:
    server.door.close("There is no rope.")
    with Page(server) as page:
        assert page.message("bye")["text"] == "There is no rope."
        assert page.ended() == 1001
    with pytest.raises(urllib.error.HTTPError) as refused:
        urllib.request.urlopen(server.address + "export/scene.toml", timeout=PATIENCE)
    assert refused.value.code == 503
    assert refused.value.read() == b"There is no rope.\n"


def test_what_cannot_be_set_up_ends_the_server() -> None:
    heard: list[ViewServer] = []
    with pytest.raises(SceneError, match="nodes"):
        prepare(slack_rope(1_000_000), port=0, listening=heard.append)
    (server,) = heard
    assert not server.wait(PATIENCE)
    with pytest.raises(urllib.error.URLError, match="refused"):
        urllib.request.urlopen(server.address, timeout=5)
