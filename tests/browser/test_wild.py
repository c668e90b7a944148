"""What must not spoil the picture: places that are no numbers, pages without a frame, a lost context."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from typing import Any

import numpy as np
import pytest

import ropewalk as rw
from browser.window import Window
from ropewalk.live.launch import serve_run
from ropewalk.live.serve import ViewServer

pytestmark = pytest.mark.browser
Open = Callable[..., Window]
Serve = Callable[..., ViewServer]
BOTH = pytest.mark.parametrize("renderer", ["webgl", "canvas"])
CAMERA = "[...r.viewport.camera.view, ...r.viewport.camera.projection]"


@pytest.fixture(scope="module")
def beyond() -> Iterator[Any]:
    """A server that replays a run recorded on beyond its break, to infinity and NaN."""
    result = rw.simulate("r7", keep_going=True, on_failure="return")
    assert not np.isfinite(result.positions[-1]).all()
    server = serve_run(result, playing=False, port=0)
    server.start()
    yield server
    server.stop()


@BOTH
def test_places_that_are_no_numbers_do_not_lose_the_view(
    open_window: Open, beyond: Any, renderer: str
) -> None:
    window = open_window(f"{beyond.address}?renderer={renderer}").ready()
    for time in (1.7, 3.0, 10.0, 19.0):
        window.tell(type="seek", time=time)
        window.until(f"Math.abs(r.time - {time}) < 0.02")
        for view in ("fit", "home", "z"):
            window.click(f"#view-{view}")
            window.settled()
            assert np.isfinite(window.ask(CAMERA)).all()
            assert window.painted()
    assert window.at_rope(range(1, 40)) < 0.1  # nothing is there to be shown
    window.tell(type="seek", time=0.3)
    window.until("r.time < 0.4")
    window.click("#view-home")
    window.settled()
    assert window.at_rope(range(1, 40)) > 0.9
    window.click("#view-fit")
    window.settled()
    assert window.at_rope(range(1, 40)) > 0.9
    low, high = window.ask("[r.viewport.range.low, r.viewport.range.high]")
    assert high - low < 1e3  # what broke later does not rule the colours
    assert window.ask("r.viewport.marks.strongest") < 1e3


@BOTH
def test_a_page_that_waits_for_a_frame_is_not_black(
    open_window: Open, serve: Serve, renderer: str
) -> None:
    window = open_window(f"{serve().address}?renderer={renderer}").ready()
    window.settled()
    assert window.painted()
    # a new layout without a frame yet, as while a method is compiled; then the window changes
    window.page.evaluate(
        "() => { const s = window.ropewalk.session; s.take({ ...s.layout, layout: 9999 }); }"
    )
    window.page.set_viewport_size({"width": 700, "height": 500})
    window.until("r.viewport.camera.width <= 700")
    window.page.wait_for_timeout(100)
    assert window.painted()


def test_a_lost_drawing_context_comes_back(open_window: Open, serve: Serve) -> None:
    window = open_window(serve().address).ready()
    window.settled()
    drawn = window.ask("r.drawn")
    window.page.evaluate(
        """() => new Promise((done) => {
            const { canvas } = window.ropewalk.viewport.renderer;
            const lose = canvas.getContext("webgl2").getExtension("WEBGL_lose_context");
            canvas.addEventListener("webglcontextlost", () => setTimeout(() => lose.restoreContext()));
            canvas.addEventListener("webglcontextrestored", () => done());
            lose.loseContext();
        })"""
    )
    window.until(f"r.drawn > {drawn}")
    window.settled()
    assert window.painted()
    assert window.at_rope(range(1, 40)) > 0.9
