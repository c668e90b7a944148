"""A view in a notebook: a frame in a page of another origin on this computer, as Jupyter's is."""

from __future__ import annotations

import threading
from collections.abc import Callable, Iterator
from http.server import BaseHTTPRequestHandler, ThreadingHTTPServer
from typing import Any

import pytest

import ropewalk as rw
from live.drive import slack_rope
from patience import PATIENCE

pytestmark = pytest.mark.browser
Notebook = Callable[..., Any]


@pytest.fixture
def notebook(browser: Any) -> Iterator[Notebook]:
    """Open a page that shows views as the outputs of its cells."""
    shown: list[str] = []

    class Page(BaseHTTPRequestHandler):
        def do_GET(self) -> None:
            self.send_response(200)
            self.send_header("content-type", "text/html; charset=utf-8")
            # what JupyterLab sends with its pages
            self.send_header("content-security-policy", "frame-ancestors 'self'")
            self.end_headers()
            self.wfile.write(("<!doctype html><body>" + "<hr>".join(shown)).encode())

        def log_message(self, *_: Any) -> None:
            pass

    server = ThreadingHTTPServer(("127.0.0.1", 0), Page)
    threading.Thread(target=server.serve_forever, daemon=True).start()
    context = browser.new_context(viewport={"width": 900, "height": 1400})

    def make(host: str, *outputs: str) -> Any:
        shown[:] = outputs
        page = context.new_page()
        page.set_default_timeout(PATIENCE * 1000.0)
        page.goto(f"http://{host}:{server.server_port}/lab", wait_until="commit")
        page.wait_for_selector("iframe")
        return page

    yield make
    context.close()
    server.shutdown()
    server.server_close()


def _frame(page: Any, address: str) -> Any:
    """Return the frame of an address, once it has come there."""
    for _ in range(int(PATIENCE * 10)):
        for frame in page.frames[1:]:
            if frame.url.split("#")[0] == address:
                return frame
        page.wait_for_timeout(100)
    raise AssertionError(f"no frame came to {address}, only {[one.url for one in page.frames]}")


def _until(page: Any, frame: Any, condition: str) -> bool:
    """Wait until an expression of `r`, the hook of the page in a frame, holds."""
    script = f"() => {{ const r = window.ropewalk; return Boolean(r && ({condition})); }}"
    for _ in range(int(PATIENCE * 10)):
        if frame.evaluate(script):
            return True
        page.wait_for_timeout(100)
    return False


@pytest.mark.parametrize("host", ["localhost", "127.0.0.1"])
def test_views_live_in_the_cells_of_a_notebook(notebook: Notebook, host: str) -> None:
    options: dict[str, Any] = {"open_browser": False, "port": 0}
    simulation, scene = rw.Simulation(slack_rope(20)), slack_rope(20)
    result = rw.simulate(scene.replace(run=scene.run.replace(duration=0.5)))
    with (
        simulation.view(**options) as program,
        scene.view(**options) as live,
        result.view(**options) as replay,
    ):
        for _ in range(30):
            simulation.step()
            program.update()
        # the browser comes only after the cell has run
        page = notebook(host, *(one._repr_html_() for one in (program, live, replay)))
        shown, playing, replayed = (_frame(page, one.address) for one in (program, live, replay))
        assert _until(page, shown, f"r.drawn > 0 && r.time === {simulation.time}")
        assert _until(page, playing, "r.drawn > 0 && r.time > 0.2")
        assert _until(page, replayed, "r.drawn > 0 && r.time > 0.4")
        before = shown.evaluate("() => window.ropewalk.frames")
        simulation.step()
        program.update()  # another cell
        assert _until(page, shown, f"r.frames > {before} && r.time === {simulation.time}")


def test_a_page_of_another_site_shows_no_view(notebook: Notebook) -> None:
    with slack_rope(20).view(open_browser=False, port=0) as view:
        page = notebook("rebound.test", view._repr_html_())
        frame = _frame(page, "chrome-error://chromewebdata/")
        assert frame.evaluate("() => window.ropewalk") is None
