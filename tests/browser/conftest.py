"""A real Chromium and pages in it. Without one the tests are skipped, but not where CI is set."""

from __future__ import annotations

import os
import shutil
from collections.abc import Callable, Iterator
from contextlib import ExitStack
from pathlib import Path
from typing import Any

import pytest

from browser.window import FLAGS, Window
from live.drive import slack_rope
from ropewalk.live.launch import serve_session
from ropewalk.live.serve import ViewServer
from ropewalk.live.session import Session
from ropewalk.scene import Anchor
from ropewalk.scene.presets import preset

_NAMES = ("chromium", "chromium-browser", "google-chrome")


def _chromium() -> str | None:
    return os.environ.get("ROPEWALK_CHROMIUM") or next(
        filter(None, map(shutil.which, _NAMES)), None
    )


def _missing(reason: str) -> None:
    if os.environ.get("CI"):
        pytest.fail(f"{reason}; CI must run the browser tests")
    pytest.skip(reason)


@pytest.fixture(scope="session")
def browser() -> Iterator[Any]:
    """One browser for all tests."""
    try:
        from playwright.sync_api import sync_playwright
    except ImportError:
        _missing("playwright is not installed: make dev")
    program = _chromium()
    if program is None:
        _missing("there is no Chromium; on Debian and Ubuntu: apt install chromium")
    with sync_playwright() as playwright:
        made = playwright.chromium.launch(executable_path=program, headless=True, args=FLAGS)
        yield made
        made.close()


def pytest_addoption(parser: pytest.Parser) -> None:
    parser.addoption(
        "--slow-page",
        type=float,
        default=1.0,
        metavar="TIMES",
        help="slow the pages' scripts so many times, to find tests that need a fast machine",
    )


@pytest.fixture
def open_window(browser: Any, request: pytest.FixtureRequest) -> Iterator[Callable[..., Window]]:
    """Open addresses, each in a window of its own; fails when a page reported an error."""
    times = request.config.getoption("--slow-page", 1.0)
    with ExitStack() as stack:
        opened: list[Window] = []

        def make(address: str, **options: Any) -> Window:
            settings = {"viewport": {"width": 900, "height": 640}, "color_scheme": "light"}
            context = browser.new_context(**(settings | options))
            stack.callback(context.close)
            page = context.new_page()
            slowed = context.new_cdp_session(page)
            slowed.send("Emulation.setCPUThrottlingRate", {"rate": times})
            window = Window(page)
            opened.append(window)
            window.page.goto(address)
            return window

        yield make
        for window in opened:
            assert window.faults == []


@pytest.fixture
def serve(tmp_path: Path) -> Iterator[Callable[..., ViewServer]]:
    """Serve sessions, paused and kept in a folder unless told otherwise."""
    with ExitStack() as stack:

        def make(session: Session | None = None, **options: Any) -> ViewServer:
            settings: dict[str, Any] = {"port": 0, "playing": False, "folder": tmp_path / "run"}
            made = session or Session(preset("r4"), "r4")
            server: ViewServer = serve_session(made, **(settings | options))
            server.start()
            stack.callback(server.stop)
            return server

        yield make


@pytest.fixture
def window(open_window: Callable[..., Window], serve: Callable[..., ViewServer]) -> Window:
    """A paused page of a rope on three anchors; a file of tests may have one of its own."""
    scene = slack_rope()
    scene = scene.replace(anchors=[*scene.anchors, Anchor(name="middle", node=20)])
    size = {"width": 1280, "height": 800}
    return open_window(serve(Session(scene)).address, viewport=size).ready()
