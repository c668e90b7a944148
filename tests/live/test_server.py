"""The server with real sockets: frames, flow control, several pages, hostile requests, a clean end."""

from __future__ import annotations

import asyncio
import gc
import http.client
import json
import socket
import time
from collections.abc import Iterator
from contextlib import suppress
from pathlib import Path

import numpy as np
import pytest
from websockets.exceptions import ConnectionClosed, InvalidMessage, InvalidStatus

from live.drive import r4, slack_rope
from live.pages import Page, served
from patience import PATIENCE
from ropewalk.live import page_socket
from ropewalk.live.guard import Guard
from ropewalk.live.relive import relive
from ropewalk.live.serve import ViewServer
from ropewalk.live.session import Session


@pytest.fixture
def server(tmp_path: Path) -> Iterator[ViewServer]:
    with served(r4(), tmp_path, folder=tmp_path / "run") as made:
        yield made


def get(server: ViewServer, path: str, **headers: str) -> tuple[int, bytes, dict[str, str]]:
    """Fetch a path below the server's root."""
    connection = http.client.HTTPConnection("127.0.0.1", server.port, timeout=PATIENCE)
    connection.request("GET", path, headers=headers)
    answer = connection.getresponse()
    data = answer.read()
    connection.close()
    return answer.status, data, {key.lower(): value for key, value in answer.getheaders()}


def test_a_page_is_told_everything_and_then_sees_frames(server: ViewServer) -> None:
    with Page(server) as page:
        page.until(lambda: len(page.frames) >= 5)
        kinds = [one["type"] for one in page.messages]
        assert kinds[:5] == ["hello", "layout", "parameters", "presets", "status"]
        page.message("stability")
        layout = page.message("layout")
        head = page.frames[-1]
        assert head[0] == 0x46505752
        assert head[1] == layout["layout"]
        assert len(page.data) == layout["bytes"]
        where = layout["variants"][0]["offsets"]["positions"]
        nodes = layout["variants"][0]["nodes"]
        positions = np.frombuffer(page.data, "<f4", 3 * nodes, where).reshape(nodes, 3)
        assert positions[20] == pytest.approx([20.0, 0.0, 0.0])  # the middle anchor
        assert positions[10, 1] < 0.0
        times = [one[4] for one in page.frames]
        assert times == sorted(times)


def test_commands_are_answered_and_seen(server: ViewServer) -> None:
    with Page(server) as page:
        done = page.ask(1, "set", name="mass", value=4.0)
        assert (done["type"], done["command"]) == ("done", "set")
        page.until(lambda: page.frames and page.frames[-1][2] >= done["frame"])
        told = [one for one in page.messages if one["type"] == "parameters"][-1]["parameters"]
        assert next(one for one in told if one["name"] == "mass")["value"] == pytest.approx(4.0)
        error = page.ask(2, "set", name="mass", value=-4)
        assert error["type"] == "error"
        assert error["faults"][0]["low"] == 1e-12
        assert "must be positive" in error["text"]
        assert page.ask(3, "pause")["type"] == "done"
        assert page.ask(4, "step", count=5)["type"] == "done"
        assert page.ask(5, "seek", time=1)["type"] == "error"
        saved = page.message("saved") if page.ask(6, "save") else {}
        assert saved["folder"] == str(server.keeper.folder)


def test_a_change_of_the_arrays_brings_a_new_layout_before_its_frames(server: ViewServer) -> None:
    with Page(server) as page:
        first = page.message("layout")
        page.ask(1, "pin", node=10)
        page.until(lambda: page.frames and page.frames[-1][1] == first["layout"] + 1)
        layouts = [one for one in page.messages if one["type"] == "layout"]
        assert layouts[-1]["layout"] == first["layout"] + 1
        assert len(page.data) == layouts[-1]["bytes"]


def test_a_page_that_does_not_acknowledge_gets_three_frames(server: ViewServer) -> None:
    with Page(server, acknowledges=False) as slow, Page(server) as quick:
        quick.until(lambda: len(quick.frames) >= 30)
        slow.until(lambda: len(slow.frames) >= 3)
        slow.listen(1.0)
        assert len(slow.frames) == 3
        seen = quick.frames[-1][2]
        slow.send("ack", frame=slow.frames[-1][2])
        slow.until(lambda: len(slow.frames) >= 4)
        assert slow.frames[-1][2] >= seen  # the newest, not the next


def test_two_pages_drive_one_session_and_what_one_held_ends_with_it(server: ViewServer) -> None:
    with Page(server) as stays:
        with Page(server) as goes:
            goes.ask(1, "grab", node=10, target=[10.0, 3.0, 0.0])
            stays.until(lambda: stays.frames and stays.frames[-1][3] & 8)
            assert goes.ask(2, "pause")["type"] == "done"
            stays.until(lambda: not stays.frames[-1][3] & 1)
        stays.ask(3, "play")
        stays.until(lambda: not stays.frames[-1][3] & 8 and stays.frames[-1][3] & 1)


def test_a_page_that_comes_back_finds_the_run(server: ViewServer) -> None:
    with Page(server) as page:
        done = page.ask(1, "set", name="mass", value=4.0)
        page.until(lambda: page.frames and page.frames[-1][2] >= done["frame"])
        time_before = page.frames[-1][4]
    with Page(server) as page:
        page.until(lambda: page.frames)
        assert page.frames[-1][4] >= time_before
        assert page.message("hello")["address"] == "scene=r4&mass=4.0"


def test_a_break_stops_the_play_with_remedies(server: ViewServer) -> None:
    with Page(server) as page:
        page.ask(1, "set", name="spring_constant", value=1e6)
        broken = page.message("broken")
        assert [one["id"] for one in broken["remedies"]] == ["back", "step", "implicit"]
        page.until(lambda: page.frames and page.frames[-1][3] & 2)
        page.ask(2, "remedy", remedy="step")
        page.until(lambda: not page.frames[-1][3] & 2 and page.frames[-1][3] & 1)


def test_without_the_token_there_is_nothing(server: ViewServer) -> None:
    other = "y" if server.token.endswith("x") else "x"
    for path in ("/", "/index.html", "/wrong/", "/socket", f"/{server.token[:-1]}{other}/"):
        status, data, _ = get(server, path)
        assert status == 404
        assert b"a page" not in data
    assert get(server, f"/{server.token}")[0] == 404
    status, data, headers = get(server, f"/{server.token}/")
    assert (status, b"a page" in data) == (200, True)
    assert "default-src 'none'" in headers["content-security-policy"]
    assert "unsafe" not in headers["content-security-policy"]
    assert headers["x-content-type-options"] == "nosniff"
    assert headers["referrer-policy"] == "no-referrer"


def test_only_the_pages_own_files_are_served(server: ViewServer, tmp_path: Path) -> None:
    root = f"/{server.token}"
    assert get(server, f"{root}/bundle.js")[0] == 200
    for name in (
        "secret.key",
        "../run/events.jsonl",
        "..%2frun%2fevents.jsonl",
        "%2e%2e/run/events.jsonl",
        "%00",
        "page/index.html",
        "export/passwd",
        "presets/..%2f..%2fpyproject.svg",
        "presets/none.svg",
    ):
        assert get(server, f"{root}/{name}")[0] == 404, name
    assert get(server, f"{root}/presets/r4.svg")[1].startswith(b"<svg")


def test_other_hosts_and_origins_get_nothing(server: ViewServer) -> None:
    root = f"/{server.token}/"
    own = f"127.0.0.1:{server.port}"
    assert get(server, root, Host=own)[0] == 200
    assert get(server, root, Host=f"localhost:{server.port}")[0] == 200
    for host in ("evil.example", f"evil.example:{server.port}", "127.0.0.1:1", f"x@{own}", ""):
        assert get(server, root, Host=host)[0] in (400, 403), host
    assert get(server, root, Origin=f"http://{own}", Host=own)[0] == 200
    for origin in (
        "http://evil.example",
        "null",
        f"https://{own}",
        f"http://localhost:{server.port}",
    ):
        assert get(server, root, Origin=origin, Host=own)[0] == 403, origin


def test_the_sockets_door_is_the_same(server: ViewServer) -> None:
    for options in (
        {"origin": "http://evil.example"},
        {"origin": "null"},
        {"additional_headers": {"Host": "evil.example"}},
    ):
        with pytest.raises((InvalidStatus, InvalidMessage)):
            Page(server, **options)
    wrong = server.token
    server.token = "x" * len(wrong)
    try:
        with pytest.raises(InvalidStatus):
            Page(server)
    finally:
        server.token = wrong


@pytest.mark.parametrize(
    ("text", "said"),
    [
        ("no json", "must be JSON"),
        ("[" * 5000, "must nest at most 8 deep"),
        ("[1]", "must be a JSON object"),
        ("{}", "This command must be one of "),
        ('{"type": "hack"}', "must be one of"),
        ('{"type": "set", "name": "mass"}', "value"),
        ('{"type": "play", "x": 1}', "Unknown key"),
        ('{"type": "grab", "node": 1, "target": [0, 0, NaN]}', "must be JSON"),
        ('{"type": "grab", "node": 1, "target": [0, 0, 1e400]}', "target[2]"),
        ('{"type": "grab", "node": 1, "target": [0, 0, 1e7]}', "at most 1e+06"),
        ('{"type": "grab", "node": 1.5, "target": [0, 0, 0]}', "node"),
        ('{"type": "grab", "node": -1, "target": [0, 0, 0]}', "must be at least 0"),
        ('{"type": "grab", "node": true, "target": [0, 0, 0]}', "node"),
        ('{"type": "speed", "value": 5}', "must be at most 4"),
        ('{"type": "step", "count": 1000000}', "must be at most 10000"),
        ('{"type": "scene", "toml": "[[rope]]\\nsegments = 0"}', "must be at least 1"),
        (json.dumps({"type": "set", "name": "x" * 70_000, "value": 1}), "name"),
    ],
)
def test_what_is_malformed_is_answered(server: ViewServer, text: str, said: str) -> None:
    with Page(server) as page:
        page.socket.send(text)
        assert said in page.message("error")["text"]
        assert page.ask(9, "pause")["type"] == "done"


def test_a_scene_from_a_page_names_no_files(server: ViewServer, tmp_path: Path) -> None:
    (tmp_path / "points.csv").write_text("0,0,0\n1,0,0\n")
    text = (
        "[[rope]]\nsegments = 1\nshape = { kind = 'points', file = '"
        + str(tmp_path / "points.csv")
        + "' }\n[rope.made_of]\nkind = 'springs'\nspring_constant = 1.0\nnode_mass = 1.0\n"
        "segment_length = 1.0\n"
    )
    with Page(server) as page:
        assert "may name no files" in page.ask(1, "scene", toml=text)["text"]
        huge = text.replace("segments = 1", "segments = 9999999").replace("shape =", "#")
        assert "at most 200000" in page.ask(2, "scene", toml=huge)["text"]


def test_floods_and_giants_are_cut_off(server: ViewServer, monkeypatch: pytest.MonkeyPatch) -> None:
    with Page(server) as page, monkeypatch.context() as patch:
        # a server that is slow itself takes in no more in a second than it allows
        patch.setattr(page_socket, "PER_SECOND", 1.0)
        with suppress(ConnectionClosed):
            for _ in range(3000):
                page.send("pause")
        assert page.ended() == 4429
    with Page(server) as page:
        page.socket.send("x" * 300_000)
        assert page.ended() == 1009
    with Page(server) as page:
        with suppress(ConnectionClosed):
            for _ in range(30):
                page.socket.send("no json")
        assert page.ended() == 4400
    with Page(server) as page:  # the run has lived through it all
        page.until(lambda: page.frames)


def test_only_so_many_pages_at_once(server: ViewServer) -> None:
    pages = [Page(server) for _ in range(server.live.most_clients)]
    for page in pages:
        page.message("hello")
    assert Page(server).ended() == 4503
    for page in pages:
        page.close()


def test_a_link_opens_the_same_set_up(tmp_path: Path) -> None:
    with served(Session(slack_rope(12)), tmp_path) as server, Page(server) as page:
        page.ask(1, "set", name="wind", value=[1.0, 2.0, 0.0])
        page.until(lambda: any(o.get("address", "").endswith("]") for o in page.messages))
        address = next(o for o in page.messages if o.get("address", "").endswith("]"))["address"]
        assert address.startswith("toml=")
        page.ask(2, "scene", preset="r4")
        assert page.ask(3, "scene", address=address)["type"] == "done"
        scene = server.broadcast.session.scene
        assert scene.ropes[0].segments == 12
        assert scene.air is not None
        assert tuple(scene.air.wind) == (1.0, 2.0, 0.0)
        assert "as scene=r4" in page.ask(4, "scene", address="x")["text"]
        assert "no scene that" in page.ask(5, "scene", address="toml=AAAA")["text"]


def test_exports(server: ViewServer) -> None:
    root = f"/{server.token}/export"
    with Page(server) as page:
        page.until(lambda: len(page.frames) > 20)
        assert page.ask(1, "pause")["type"] == "done"
        place = server.broadcast.session.main.simulation.positions[10].copy()
        status, data, headers = get(server, f"{root}/scene.toml")
        assert status == 200
        assert "attachment" in headers["content-disposition"]
        from ropewalk.scene import loads

        scene = loads(data.decode())
        assert Session(scene).main.simulation.positions[10] == pytest.approx(place, abs=1e-12)
        status, data, _ = get(server, f"{root}/nodes.csv")
        assert (status, data[:4]) == (200, b"time")
        assert get(server, f"{root}/energies.csv")[0] == 200


def test_stopping_keeps_the_run_and_says_goodbye(tmp_path: Path) -> None:
    session = r4()
    with served(session, tmp_path, folder=tmp_path / "run") as server:
        page = Page(server)
        page.ask(1, "kick", node=10, velocity=[0, 3, 0])
        page.until(lambda: len(page.frames) > 10)
        server.stop("The end.")
        assert page.message("bye")["folder"] == str(tmp_path / "run")
        assert page.ended() in (1001, 1012, 1000)
    again = relive(tmp_path / "run")
    assert np.array_equal(again.main.simulation.positions, session.main.simulation.positions)


def test_a_busy_port_is_said_and_another_taken(tmp_path: Path) -> None:
    with socket.socket() as busy:
        busy.bind(("127.0.0.1", 0))
        busy.listen()
        port = busy.getsockname()[1]
        server = ViewServer(port=port)
        try:
            assert not server.port_was_free
            assert server.port != port
        finally:
            server.socket.close()


@pytest.mark.parametrize(
    ("host", "name", "allowed"),
    [
        ("127.0.0.1", "127.0.0.1:80", True),
        ("127.0.0.1", "LOCALHOST:80", True),
        ("127.0.0.1", "[::1]:80", True),
        ("127.0.0.1", "192.168.0.7:80", False),
        ("127.0.0.1", "rebound.example:80", False),
        ("0.0.0.0", "192.168.0.7:80", True),
        ("0.0.0.0", "rebound.example:80", False),
        ("pi.example", "pi.example:80", True),
    ],
)
def test_which_hosts_are_own(host: str, name: str, allowed: bool) -> None:
    assert Guard(None, "t", host, 80).is_own_host(name) is allowed  # type: ignore[arg-type]


def test_frames_do_not_wait_for_more_to_send(server: ViewServer) -> None:
    # Without TCP_NODELAY a frame that follows a message waits for its acknowledgement: 40 ms. asyncio
    # sets it on what a socket accepts that names its protocol.
    with Page(server) as page:
        page.until(lambda: page.frames)
        # by type(): to ask a proxy of what is gone for its class raises
        ends = [one for one in gc.get_objects() if issubclass(type(one), asyncio.Transport)]
        sockets = [one.get_extra_info("socket") for one in ends if not one.is_closing()]
        accepted = [one for one in sockets if one.getsockname()[1] == server.port]
        assert accepted
        for one in accepted:
            assert one.getsockopt(socket.IPPROTO_TCP, socket.TCP_NODELAY) != 0


def test_play_keeps_to_the_clock(server: ViewServer) -> None:
    with Page(server) as page:
        page.ask(1, "set", name="time_step", value=0.002)
        begun = time.monotonic()  # before what is counted was simulated, however late it comes
        done = page.ask(2, "speed", value=0.5)
        page.until(lambda: page.frames and page.frames[-1][2] >= done["frame"])
        first, end = page.frames[-1][4], time.monotonic() + 1.5
        page.until(lambda: time.monotonic() > end)
        rate = (page.frames[-1][4] - first) / (time.monotonic() - begun)
        assert 0.0 < rate < 0.6  # never faster than asked, slower only on a busy computer
