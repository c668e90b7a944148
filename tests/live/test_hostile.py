"""What somebody may send who means harm: it is refused in words, and nobody else waits for it."""

from __future__ import annotations

import http.client
import json
import re
import socket
import stat
import subprocess
import sys
import threading
import time
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import pytest

from live.drive import r4
from live.pages import Page, served
from patience import PATIENCE
from ropewalk.live import browser, connections, downloads, reading
from ropewalk.live.guard import Guard
from ropewalk.live.reading import read_apart
from ropewalk.live.serve import ViewServer
from ropewalk.scene import SceneError, dumps
from ropewalk.scene.presets import preset

WORDS = {
    "HUGE": "1" + "0" * 400,
    "LONG": "1" + "0" * 5000,
    "HALF": "\\ud800",  # in JSON: half of a surrogate pair
    "DEEP": "[" * 900 + "]" * 900,
    "DEEPER": "[" * 20_000 + "]" * 20_000,
    "NEST": '{"a":' * 900 + "1" + "}" * 900,
}


def written(text: str) -> str:
    """Return a message with the words in it replaced by what they stand for."""
    return re.sub("[A-Z]{4,}", lambda word: WORDS[word[0]], text)


@pytest.fixture
def server(tmp_path: Path) -> Iterator[ViewServer]:
    with served(r4(), tmp_path, folder=tmp_path / "run") as made:
        yield made


@pytest.mark.parametrize(
    ("text", "said"),
    [
        ('{"type": "load", "node": 1, "mass": HUGE, "id": 1}', "finite number"),
        ('{"type": "speed", "value": HUGE, "id": 1}', "finite number"),
        ('{"type": "back", "seconds": HUGE, "id": 1}', "finite number"),
        ('{"type": "kick", "node": 1, "velocity": [0, 0, HUGE], "id": 1}', "finite number"),
        ('{"type": "set", "name": "mass", "value": HUGE, "id": 1}', "finite number"),
        ('{"type": "set", "name": "mass", "value": LONG, "id": 1}', "finite number"),
        ('{"type": "set", "name": "gravity", "value": [0, 0, HUGE], "id": 1}', "three finite"),
        ('{"type": "set", "name": "segments", "value": HUGE, "id": 1}', "whole number"),
        ('{"type": "compare", "variants": [{"changes": {"mass": HUGE}}], "id": 1}', "finite"),
        ('{"type": "scene", "address": "scene=r4&mass=HUGE", "id": 1}', "finite number"),
        ('{"type": "scene", "toml": "name = LONG", "id": 1}', "The toml cannot be read"),
        ('{"type": "pin", "node": HUGE, "id": 1}', "valid integer"),
        ('{"type": "set", "name": "HALF", "value": 1, "id": 1}', "surrogate"),
        ('{"type": "drag", "anchor": "HALF", "target": [0, 0, 0], "id": 1}', "surrogate"),
        ('{"type": "pause", "HALF": 1, "id": 1}', "surrogate"),
        ('{"type": "scene", "toml": "name = \\"HALF\\"", "id": 1}', "surrogate"),
        ('{"type": "scene", "preset": "HALF", "id": 1}', "surrogate"),
        ('{"type": "compare", "variants": [{"label": "HALF", "changes": {}}], "id": 1}', "surro"),
        ('{"type": "set", "name": "mass", "value": DEEP, "id": 1}', "must nest at most"),
        ('{"type": "pause", "x": DEEP, "id": 1}', "must nest at most"),
        ('{"type": "set", "name": "mass", "value": NEST, "id": 1}', "must nest at most"),
        ('{"type": "scene", "address": "scene=r4&mass=DEEP", "id": 1}', "finite number"),
    ],
)  # fmt: skip
def test_it_is_refused_in_words(
    server: ViewServer, capfd: pytest.CaptureFixture[str], text: str, said: str
) -> None:
    with Page(server) as page:
        page.socket.send(written(text))
        answer = page.message("error", id=1)
        assert said in answer["text"]
        assert "Ropewalk itself" not in answer["text"]
        assert page.ask(2, "pause")["type"] == "done"  # the socket still speaks
    assert "Traceback" not in capfd.readouterr().err


def test_what_cannot_be_read_at_all_is_refused_too(server: ViewServer) -> None:
    with Page(server) as page:
        page.socket.send(written('{"type": "set", "value": DEEPER, "id": 1}'))
        assert "must nest at most" in page.message("error")["text"]
        page.socket.send(written('{"type": "pause", "id": HUGE}'))
        assert "id: " in page.message("error", command="pause")["text"]
        assert page.ask(2, "pause")["type"] == "done"


@pytest.mark.parametrize(
    "host", ["[::1", "[", "[]", "a]", "[zz]", "[::1]:x", "127.0.0.1:" + "9" * 5000, "//", "\xff"]
)
def test_a_host_that_is_none_is_not_ours(host: str) -> None:
    assert Guard(None, "t", "127.0.0.1", 80).is_own_host(host) is False  # type: ignore[arg-type]


def test_a_scene_that_is_too_much_to_read_holds_nobody(
    server: ViewServer, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(reading, "PATIENCE", 1.5)
    run, seen = subprocess.run, threading.Event()

    def read(*args: Any, **options: Any) -> Any:
        try:
            return run(*args, **options)
        finally:
            seen.wait(PATIENCE)  # a slow computer shows few frames in that time

    monkeypatch.setattr(reading.subprocess, "run", read)
    with Page(server) as page:
        page.until(lambda: page.frames)
        page.send("scene", id=1, toml=".".join("a" * 12_000) + " = 1")
        before = len(page.frames)
        page.until(lambda: len(page.frames) >= before + 20)
        assert not any(one.get("id") == 1 for one in page.messages)  # still at it
        seen.set()
        assert "takes more than" in page.message("error", id=1)["text"]


def test_a_scene_read_apart_is_the_scene() -> None:
    made = preset("r4").replace(name="Seil – 绳")
    assert read_apart(dumps(made)) == made
    with pytest.raises(SceneError, match="unknown key") as caught:
        read_apart("".join(f"a{i} = 1\n" for i in range(50)))
    assert len(caught.value.faults) == reading.MOST_FAULTS


def test_memory_to_read_a_scene_is_bounded(monkeypatch: pytest.MonkeyPatch) -> None:
    pytest.importorskip("resource")
    with pytest.raises(SceneError, match="takes more than"):
        read_apart("a." * 40_000 + "b = 1\n")  # some 6 GB


def connect(server: ViewServer, text: str = "") -> socket.socket:
    """Return a connection on which a text was sent."""
    made = socket.create_connection(("127.0.0.1", server.port), PATIENCE)
    made.sendall(text.encode())
    return made


def is_ended(one: socket.socket) -> bool:
    """Wait for a connection's end; False when the server keeps it."""
    try:
        while one.recv(65_536):
            pass
    except TimeoutError:
        return False
    except OSError:
        return True
    return True


@pytest.mark.parametrize("text", ["", "GET ", "GET /TOKEN/ HTTP/1.1\r\nHost: 127.0.0.1\r\n"])
def test_half_open_connections_end(
    server: ViewServer, monkeypatch: pytest.MonkeyPatch, text: str
) -> None:
    monkeypatch.setattr(connections, "PATIENCE", 0.3)
    with connect(server, text.replace("TOKEN", server.token)) as one:
        assert is_ended(one)


def test_a_connection_that_drips_ends(server: ViewServer, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(connections, "PATIENCE", 0.5)
    with connect(server) as one:
        one.settimeout(0.1)
        end = time.monotonic() + PATIENCE
        while time.monotonic() < end:
            try:
                one.sendall(b"G")
                if one.recv(1) == b"":
                    return
            except TimeoutError:
                continue
            except OSError:
                return
    raise AssertionError("the server has waited all the time")


def test_idle_connections_starve_nobody(
    server: ViewServer, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(connections, "MOST", 8)
    with Page(server) as page:
        idle = [connect(server) for _ in range(60)]
        try:
            ended = [is_ended(one) for one in idle[:-8]]  # the oldest gave way
            assert all(ended)
            asked = http.client.HTTPConnection("127.0.0.1", server.port, timeout=PATIENCE)
            asked.request("GET", f"/{server.token}/")
            assert asked.getresponse().status == 200
            with Page(server) as other:
                other.message("hello")
            before = len(page.frames)
            page.until(lambda: len(page.frames) > before + 5)
        finally:
            for one in idle:
                one.close()


_MANY = """
import resource, socket, sys
resource.setrlimit(resource.RLIMIT_NOFILE, (int(sys.argv[2]), int(sys.argv[2])))
made = [socket.create_connection(("127.0.0.1", int(sys.argv[1])), 60.0) for _ in range(600)]
print("there", flush=True)
sys.stdin.read()
"""


def test_a_rush_of_connections_leaves_files_to_open(
    server: ViewServer, caplog: pytest.LogCaptureFixture
) -> None:
    """The run's folder is written to meanwhile: a process without a free descriptor would lose it."""
    resource = pytest.importorskip("resource")
    soft, hard = resource.getrlimit(resource.RLIMIT_NOFILE)
    if hard < 1000:
        pytest.skip("so many files may not be opened here")
    probe = [socket.socket() for _ in range(2)]
    here = probe[-1].fileno()
    for one in probe:
        one.close()
    resource.setrlimit(resource.RLIMIT_NOFILE, (here + 400, hard))
    try:
        command = [sys.executable, "-c", _MANY, str(server.port), str(hard)]
        with subprocess.Popen(
            command, stdin=subprocess.PIPE, stdout=subprocess.PIPE, text=True
        ) as rush:
            assert rush.stdout is not None
            assert rush.stdout.readline() == "there\n"
            with Page(server) as page:
                page.until(lambda: len(page.frames) > 5)
            rush.communicate("")
    finally:
        resource.setrlimit(resource.RLIMIT_NOFILE, (soft, hard))
    assert "Too many open files" not in caplog.text


def test_downloads_are_made_one_at_a_time(
    server: ViewServer, monkeypatch: pytest.MonkeyPatch, tmp_path: Path
) -> None:
    lock, now, most = threading.Lock(), 0, 0
    make = server.live.exports.make

    def slowly(*args: Any) -> Any:
        nonlocal now, most
        with lock:
            now += 1
            most = max(most, now)
        end = time.monotonic() + PATIENCE
        while answers.count(503) < 30 - downloads.MOST and time.monotonic() < end:
            time.sleep(0.01)  # so that all of them have asked before the first is made
        with lock:
            now -= 1
        return make(*args)

    monkeypatch.setattr(server.live.exports, "make", slowly)
    monkeypatch.setattr(downloads.tempfile, "tempdir", str(tmp_path))
    answers: list[int] = []

    def get() -> None:
        asked = http.client.HTTPConnection("127.0.0.1", server.port, timeout=PATIENCE)
        asked.request("GET", f"/{server.token}/export/scene.toml")
        answer = asked.getresponse()
        answer.read()
        answers.append(answer.status)

    threads = [threading.Thread(target=get) for _ in range(30)]
    for one in threads:
        one.start()
    for one in threads:
        one.join()
    assert most == 1
    assert answers.count(200) == downloads.MOST
    assert answers.count(503) == 30 - downloads.MOST
    get()
    assert answers[-1] == 200
    end = time.monotonic() + PATIENCE
    while list(tmp_path.glob("ropewalk-*")):  # goes when the server knows that all is sent
        assert time.monotonic() < end
        time.sleep(0.01)


def test_the_browser_is_started_without_the_token(monkeypatch: pytest.MonkeyPatch) -> None:
    opened: list[str] = []
    seen: list[tuple[int, str]] = []

    def look(address: str) -> bool:
        opened.append(address)
        path = Path(address.removeprefix("file://"))
        seen.append((stat.S_IMODE(path.stat().st_mode), path.read_text()))
        assert stat.S_IMODE(path.parent.stat().st_mode) == 0o700
        return True

    monkeypatch.setattr(browser.webbrowser, "open", look)
    monkeypatch.setattr(browser, "shows_command_lines", lambda: True)
    monkeypatch.setattr(browser, "SECONDS", 0.0)
    browser.open_browser("http://127.0.0.1:8712/SECRET&/").join()
    assert opened[0].startswith("file:///")
    assert "SECRET" not in opened[0]
    assert seen[0][0] == 0o600
    assert "url=http://127.0.0.1:8712/SECRET&amp;/" in seen[0][1]
    assert not Path(opened[0].removeprefix("file://")).exists()
    monkeypatch.setattr(browser, "shows_command_lines", lambda: False)
    monkeypatch.setattr(browser.webbrowser, "open", opened.append)
    browser.open_browser("http://127.0.0.1:8712/SECRET/").join()
    assert opened[1] == "http://127.0.0.1:8712/SECRET/"


def test_errors_hold_no_text_that_a_socket_refuses() -> None:
    from ropewalk.live.hub import as_text

    said = as_text({"type": "error", "text": "half: \ud800"})
    assert json.loads(said.encode())["text"] == "half: \ud800"
