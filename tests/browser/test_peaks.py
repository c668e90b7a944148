"""A force that comes and goes between two pictures is seen: in graphs, the legend and at the anchor."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path

import numpy as np
import pytest

import ropewalk as rw
from browser.window import Window
from live.drive import slack_rope
from live.test_seen import FRAME, catch
from ropewalk.live.serve import ViewServer
from ropewalk.live.session import Session
from ropewalk.live.share import share_result
from ropewalk.scene import Anchor
from ropewalk.simulation import Simulation

pytestmark = pytest.mark.browser

Open, Serve = Callable[..., Window], Callable[..., ViewServer]
COLUMN = "[...r.app.graphs.history.between(0, 1, ['{}'])[1]]"
NOW = (
    "(() => { const [p] = r.session.frame.parts; const { scalars } = r.session.layout;"
    " const at = (n) => p.scalars[scalars.indexOf(n)];"
    " return Math.max(...[...p.tension].slice(0, 8).map((q) => at('tension_low')"
    " + q / 65535 * (at('tension_high') - at('tension_low')))); })()"
)


def test_a_catch_between_two_frames_is_seen(open_window: Open, serve: Serve) -> None:
    simulation = Simulation(catch())
    true = simulation.advance_frames(1).recording
    pull, force = float(true.tension_high.max()), float(true.reaction_high.max())
    window = open_window(serve(Session(catch())).address).ready()
    window.press("g")
    window.page.locator("[data-graph=forces]").click()
    window.page.evaluate("() => window.ropewalk.viewport.marks.toggleTrail(1)")
    assert window.tell(type="step", count=FRAME)
    window.until(f"r.session.frame.steps === {FRAME}")
    assert window.ask(NOW) < 0.5 * pull  # the twin: what a picture by itself shows
    for name, most in (("tension_max", pull), ("force 0", force)):
        column = np.array(window.ask(COLUMN.format(name)), float)
        assert np.nanmax(column) == pytest.approx(most, rel=1e-4)
    band = [
        np.array(window.ask(COLUMN.format(name)), float) for name in ("low tension 1", "tension 1")
    ]
    assert np.nanmax(band[1] - band[0]) > 0.5 * pull
    assert window.ask("r.viewport.range.high") == pytest.approx(pull, rel=1e-4)
    assert window.page.locator("[data-kind=forces]").is_visible()
    shown = "document.querySelector('.labels .reaction').innerText"
    window.until(f"/^[\\d.]+ m?N, max {force:.0f} N$/.test({shown})")  # what it is now comes first
    window.page.locator(".u-legend .bound").first.wait_for(state="hidden")


def test_a_shared_page_sees_it_too(tmp_path: Path, open_window: Open) -> None:
    result = rw.simulate(catch(1000.0))
    page = share_result(result, tmp_path / "catch.html", frame_rate=1000.0)
    window = open_window(page.as_uri(), offline=True)
    window.until("r.frames > 0")
    window.press("g", " ")
    peak = float(result.greatest_tension.max())
    window.page.locator("#seek").fill("0.19")
    highest = f"Math.max(...{COLUMN.format('tension_max')}.filter(Number.isFinite))"
    window.until(f"{highest} > {0.999 * peak}")
    assert window.ask(highest) == pytest.approx(peak, rel=1e-3)


def test_of_many_anchors_the_largest_have_numbers(open_window: Open, serve: Serve) -> None:
    scene = slack_rope()
    held = [Anchor(name=f"a{node}", node=node) for node in range(0, 41, 4)]  # 11 of like forces
    window = open_window(serve(Session(scene.replace(anchors=held))).address).ready()
    assert window.tell(type="step", count=2000)
    window.settled(anew=False)
    words = window.page.locator("#crowd")
    large = window.ask("r.viewport.marks.arrowed.size")
    assert 8 < large < 11  # one at an end holds less than half of the largest
    said = f"The {large} larger of 11 forces. Point at others."
    assert words.inner_text() == said
    numbers = window.page.locator(".labels .reaction:not([hidden])")
    assert 4 <= numbers.count() <= 8  # some find no room
    without = next(
        a for a in range(11) if not window.ask(f"r.viewport.marks.numbered.has('0 {a}')")
    )
    window.page.mouse.move(*window.screen(4 * without))
    window.until("r.viewport.marks.numbered.size === 9")
    assert window.ask(f"r.viewport.marks.numbered.has('0 {without}')")
    window.settled(anew=False)
    assert words.inner_text() == said  # what is pointed at is not counted
