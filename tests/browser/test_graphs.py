"""The graphs of the page: which are there, what they show, how far back, on which scales."""

from __future__ import annotations

import time
from collections.abc import Callable

import pytest

from browser.window import Window
from patience import PATIENCE

pytestmark = pytest.mark.browser
Open = Callable[..., Window]
Serve = Callable[..., object]


def test_graphs_open_choose_and_scroll_back(window: Window) -> None:
    window.click("#toggle-graphs")
    window.page.locator("#speed").fill("8")
    window.press(" ")
    window.until("r.time > 3.2")
    assert window.page.locator("#graph-scroll").is_disabled()
    kinds = {"energies", "tension", "motion"}
    assert set(_graphs(window)) == kinds
    for kind in ("energies", "tension", "motion"):
        _wait_for_ink(window, kind, 100)
    window.click(".chip[data-graph=tension]")
    assert set(_graphs(window)) == kinds - {"tension"}
    window.page.locator("#graph-quantity").select_option("speed")
    window.until("document.querySelector('[data-kind=motion]').innerText.includes('fastest')")
    window.page.locator("#graph-window").select_option("2")
    window.press(" ")
    window.until("r.state === 'paused' && !document.getElementById('graph-scroll').disabled")
    ends = "(({min, max}) => [min, max])(r.app.graphs.panels.get('energies').plot.uplot.scales.x)"
    low, high = window.ask(ends)
    assert high - low == pytest.approx(2.0)
    window.settled()
    low, high = window.ask(ends)
    assert high == pytest.approx(window.ask("r.time"), abs=1e-6)  # up to the very last frame
    window.page.locator("#graph-scroll").fill("0")
    assert window.ask(ends) == pytest.approx([0.0, 2.0], abs=0.2)
    box = window.page.locator("[data-kind=energies] .u-over").bounding_box()
    window.page.mouse.move(box["x"] + box["width"] / 2, box["y"] + box["height"] / 2)
    window.until(
        r"/kinetic\s*[\d.]+ m?J/.test(document.querySelector('[data-kind=energies]').innerText)"
    )


def _graphs(window: Window) -> list[str]:
    kinds: list[str] = window.ask(
        "[...document.querySelectorAll('.plot')].map((p) => p.dataset.kind)"
    )
    return kinds


def _inked(window: Window, kind: str) -> int:
    """Count the coloured pixels of a graph."""
    found: int = window.page.evaluate(
        """(kind) => {
            const canvas = document.querySelector(`[data-kind=${kind}] canvas`);
            const { data } = canvas.getContext("2d").getImageData(0, 0, canvas.width, canvas.height);
            let found = 0;
            for (let i = 0; i < data.length; i += 4) {
                const [r, g, b] = data.slice(i, i + 3);
                found += data[i + 3] > 100 && Math.max(r, g, b) - Math.min(r, g, b) > 60;
            }
            return found;
        }""",
        kind,
    )
    return found


def _wait_for_ink(window: Window, kind: str, least: int) -> None:
    """Wait until a graph has more coloured pixels than so many: a slow computer draws late."""
    end = time.monotonic() + PATIENCE
    while _inked(window, kind) <= least:
        assert time.monotonic() < end, f"nothing is drawn: {kind}"
        window.page.wait_for_timeout(25)


def test_a_followed_node_has_a_trail_graphs_and_a_phase_plane(window: Window) -> None:
    window.settled()
    window.click("#tool-follow")
    window.page.mouse.click(*window.screen(10))
    window.until("!document.getElementById('graphs').hidden")
    window.press(" ")
    window.until("r.time > 0.5")
    window.click(".chip[data-graph=phase]")
    then = window.ask("r.time")
    window.until(f"r.time > {then} + 0.5")
    _wait_for_ink(window, "phase", 50)
    assert "node 10" in window.page.locator("[data-kind=tension]").inner_text()
    assert window.ask("r.viewport.marks.trails !== null")
    window.press(" ")
    window.until("r.state === 'paused'")
    window.settled()
    # before it was followed there is nothing of it; the range is that of what there is
    strongest = window.until(
        "Math.max(...r.app.graphs.history.between(0, 99, ['tension 10'])[1].filter(isFinite))"
    )
    plot = "r.app.graphs.panels.get('tension').plot.uplot"
    assert window.ask(f"{plot}.scales.y.max") > strongest
    assert window.ask(f"{plot}.data.some((column) => column.some(isNaN))")
    window.page.mouse.click(*window.screen(10))
    window.until("r.viewport.marks.followed.size === 0")


RANGE = "(({min, max}) => [min, max])(r.app.graphs.panels.get('energies').plot.uplot.scales.x)"


def test_no_future_is_on_the_axis_of_a_graph(window: Window) -> None:
    window.press("g", " ")
    window.until("r.time > 0.5")
    window.press(" ")
    window.until("r.state === 'paused'")
    window.settled()
    last = window.ask("r.app.graphs.history.last")
    assert window.ask(RANGE)[1] == pytest.approx(last)
    assert window.ask("r.app.graphs.window") > last  # the twin: there is room for more


def test_lines_of_a_graph_may_have_scales_of_their_own(window: Window) -> None:
    window.press("g", " ")
    window.until("r.time > 0.5")
    window.press(" ")
    window.until("r.state === 'paused'")
    window.settled()
    scales = "Object.entries(r.app.graphs.panels.get('energies').plot.uplot.scales)"
    ends = f"{scales}.filter(([key, {{ min }}]) => key !== 'x' && min !== null)"
    ends += ".map(([, { min, max }]) => max - min)"
    (common,) = window.ask(ends)
    window.click("#own-scales")
    window.until(f"{ends}.length === 4 && {ends}.every(Number.isFinite)")
    spans = window.ask(ends)
    columns = "['kinetic', 'gravity', 'elastic', 'lost'].map((name) => "
    columns += "[...r.app.graphs.history.between(0, 99, [name])[1]])"
    for span, column in zip(spans, window.ask(columns), strict=True):
        assert 1.0 <= span / (max(column) - min(column)) < 1.5  # it fills the height
    assert min(spans) < 0.5 * common  # the twin: on one scale it did not
