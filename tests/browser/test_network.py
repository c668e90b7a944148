"""Several pages, slow ones, a server that goes and comes back, a reload, and pages of other sites."""

from __future__ import annotations

import threading
import time
from collections.abc import Callable, Iterator
from functools import partial
from http.server import SimpleHTTPRequestHandler, ThreadingHTTPServer
from pathlib import Path
from typing import Any

import pytest

from browser.window import Window
from live.drive import slack_rope
from ropewalk.live.broadcast import Broadcast
from ropewalk.live.serve import ViewServer
from ropewalk.live.session import Session

pytestmark = pytest.mark.browser
Open = Callable[..., Window]
Serve = Callable[..., ViewServer]
ANCHOR = "r.nodeAt(40)"
NEEDS_A_SIMULATION = ["#open-scenes", "#open-compare", "#meter", "#panel", ".legend", "#clock"]


@pytest.fixture
def server(serve: Serve) -> ViewServer:
    """A running rope between two anchors."""
    return serve(Session(slack_rope()), playing=True)


def test_two_pages_see_and_drive_one_rope(server: ViewServer, open_window: Open) -> None:
    first, second = (open_window(server.address).ready() for _ in range(2))
    before = second.node(40)
    first.take(40, (-60.0, -60.0))
    second.until(f"{ANCHOR}[2] > {before[2]} + 0.3")
    first.page.mouse.up()
    second.tell(type="pin", node=20)
    first.until("r.session.layout.variants[0].anchors.length === 3")
    first.until("r.session.status.clients === 2")
    second.tell(type="grab", node=10, target=[1.0, 0.0, 1.0])
    first.until("r.session.frame.parts[0].grabs[0] === 10")
    second.page.context.close()
    first.until("r.session.frame.parts[0].grabs[0] < 0")  # what it held ends with it
    first.until("r.session.status.clients === 1")


def test_a_slow_page_gets_fewer_frames_and_no_queue(server: ViewServer, open_window: Open) -> None:
    window, quick = (open_window(server.address).ready() for _ in range(2))
    window.until("r.time > 0.5")
    begun, first = time.monotonic(), server.broadcast.frame_number
    while server.broadcast.frame_number < first + 30:
        quick.page.wait_for_timeout(25)
    busy = 2000.0 * (time.monotonic() - begun)  # [ms] in which the server makes sixty, or about
    before, quick_before = window.ask("[r.frames, r.frame]"), quick.ask("r.frames")
    made = came = 0
    while made < 60:  # until so many were made while it did nothing, however slow the machine is
        window.page.evaluate(
            "(ms) => { const end = performance.now() + ms; while (performance.now() < end); }", busy
        )
        now = server.broadcast.session.time
        made = server.broadcast.frame_number - before[1]
    window.until(f"r.time >= {now}")
    came, number = window.ask(f"[r.frames - {before[0]}, r.frame]")
    assert came < 0.5 * (
        number - before[1]
    )  # most were never sent to it, and what it shows is of now
    quick.until(f"r.frame >= {number}")
    assert quick.ask("r.frames") - quick_before > 1.5 * came  # the other page did not wait


def test_a_frame_of_the_past_keeps_no_memory(serve: Serve, open_window: Open) -> None:
    window = open_window(serve(Session(slack_rope()), playing=True).address).ready()
    window.ask("(window.kept = r.session.frame.parts[0].positions.buffer) && 0")
    frames = window.ask("r.frames")
    window.until(f"r.frames > {frames} + 2")
    assert window.page.evaluate("() => window.kept.byteLength") == 0
    assert window.ask("r.session.frame.parts[0].positions.length") > 0


KEEP_BANNERS = """() => {
  window.banners = {};
  const banner = document.getElementById("banner");
  window.ropewalk.session.on("connection", ({ state }) => {
    if (!banner.hidden) window.banners[state] = banner.innerText;
  });
}"""


def test_a_lost_server_is_said_and_found_again(serve: Serve, open_window: Open) -> None:
    server = serve(Session(slack_rope()), playing=True)
    window = open_window(server.address).ready()
    window.until("r.time > 0.2")
    window.page.evaluate(KEEP_BANNERS)  # a lost server is found again in half a second
    window.ask("r.session.source.socket.close()")
    window.until("window.banners.lost")
    assert "the run goes on there" in window.page.evaluate("() => window.banners.lost")
    window.until("r.state === 'playing' && document.getElementById('banner').hidden")
    server.stop()
    window.until("window.banners.ended")
    assert "Trying again" in window.page.evaluate("() => window.banners.ended")
    then = window.ask("r.time")
    broadcast = Broadcast(Session(slack_rope(20)), playing=True)
    back = ViewServer(port=server.port, token=server.token)
    back.show(broadcast)
    assert back.port == server.port
    back.start()
    try:
        window.until("r.state === 'playing' && r.session.layout.variants[0].nodes === 21")
        window.until(f"r.time < {then} || r.time > {then} + 1")
        assert not window.page.locator("#banner").is_visible()
    finally:
        back.stop()


def test_the_page_waits_for_the_simulation(open_window: Open, tmp_path: Path) -> None:
    early = ViewServer(port=0)
    early.start()
    try:
        window = open_window(early.address)
        window.until("r.state === 'waiting' && !document.getElementById('banner').hidden")
        assert "Setting up" in window.page.locator("#banner").inner_text()
        window.page.screenshot(path=tmp_path / "waiting.png")
        there = window.page.locator(", ".join(NEEDS_A_SIMULATION))
        assert there.count() == len(NEEDS_A_SIMULATION)
        assert not any(one.is_visible() for one in there.all())
        early.show(Broadcast(Session(slack_rope(20)), playing=True))
        window.until("r.state === 'playing' && r.drawn > 0")
        assert not window.page.locator("#banner").is_visible()
        for one in there.all():
            one.wait_for(state="visible")  # the meter when it has measured
    finally:
        early.stop()


def test_a_reload_finds_the_session(server: ViewServer, open_window: Open) -> None:
    window = open_window(server.address).ready()
    window.tell(type="set", name="mass", value=3.0)
    window.tell(type="pin", node=20)
    window.until("r.time > 1")
    window.page.reload()
    window.ready()
    assert window.ask("r.time") > 1.0
    assert window.ask("r.session.layout.variants[0].anchors.length") == 3
    window.until("r.session.parameters.find((p) => p.name === 'mass').value === 3")
    assert window.ask("r.state") == "playing"


@pytest.fixture
def other_site(tmp_path: Path) -> Iterator[str]:
    """A page of another site."""
    folder = tmp_path / "site"
    folder.mkdir()
    (folder / "index.html").write_text("<!doctype html><title>other</title>")
    handler = partial(_Quiet, directory=str(folder))
    site = ThreadingHTTPServer(("127.0.0.1", 0), handler)
    threading.Thread(target=site.serve_forever, daemon=True).start()
    yield f"http://127.0.0.1:{site.server_port}/"
    site.shutdown()
    site.server_close()


class _Quiet(SimpleHTTPRequestHandler):
    def log_message(self, *_: Any) -> None:
        """Say nothing."""


TRIES = """async (address) => {
    const load = (tag, url) => new Promise((done) => {
        const one = document.createElement(tag);
        one.onload = () => done("loaded");
        one.onerror = () => done("refused");
        one.src = url;
        document.body.append(one);
    });
    return {
        fetch: await fetch(address).then(() => "loaded", () => "refused"),
        blind: await fetch(address, { mode: "no-cors" }).then(() => "loaded", () => "refused"),
        script: await load("script", address + "bundle.js"),
        picture: await load("img", address + "presets/r4.svg"),
        socket: await new Promise((done) => {
            const socket = new WebSocket(address.replace("http", "ws") + "socket", "ropewalk.1");
            socket.onopen = () => done("loaded");
            socket.onerror = () => done("refused");
        }),
    };
}"""


def test_another_sites_page_gets_nothing_even_with_the_token(
    server: ViewServer, browser: Any, other_site: str
) -> None:
    page = browser.new_context().new_page()
    try:
        page.goto(other_site)
        assert set(page.evaluate(TRIES, server.address).values()) == {"refused"}
        # The twin: the server's own page may do all of it.
        page.goto(server.address)
        page.wait_for_timeout(100)
        own = page.evaluate(TRIES, server.address)
        assert (own["fetch"], own["picture"], own["socket"]) == ("loaded",) * 3
    finally:
        page.context.close()


def test_a_name_bound_to_this_computer_gets_nothing(server: ViewServer, browser: Any) -> None:
    page = browser.new_context().new_page()
    try:
        bound = server.address.replace("127.0.0.1", "rebound.test")  # see FLAGS
        answer = page.goto(bound)
        assert answer.status == 403
        assert "ropewalk" not in page.content().lower()
        assert page.goto(server.address.replace(server.token, "x" * 32)).status == 404
        assert page.goto(server.address).status == 200
    finally:
        page.context.close()
