"""The lab's page: its kernel is the Python one, its bound is the theory's, and a visitor can break it."""

from __future__ import annotations

import time
from pathlib import Path
from typing import Any

import numpy as np
import pytest

import ropewalk as rw
from browser.window import SECONDS
from ropewalk.live.lab import METHODS, PRESETS, lab_scene, write_lab
from ropewalk.scene.presets import preset

STEPS = 1000
RUN = """([index, method, steps, dt]) => {
  const { scenes, Rope } = window.ropewalkLab;
  const rope = new Rope(scenes[index]);
  for (let i = 1; i <= steps; i++) rope.step(method, dt, i * dt);
  return [rope.x.map((row) => [...row]), rope.v.map((row) => [...row])];
}"""


@pytest.fixture
def lab(tmp_path: Path, open_window: Any) -> Any:
    path = write_lab(tmp_path / "lab.html")
    return open_window(path.as_uri(), viewport={"width": 1200, "height": 760})


@pytest.mark.browser
@pytest.mark.parametrize("method", METHODS)
def test_a_thousand_steps_are_those_of_python(lab: Any, method: str) -> None:
    """To 1e-12 of the largest place and speed; the twin, ten steps fewer, is far off."""
    for index, name in enumerate(PRESETS):
        dt = 0.6 * rw.check(name, measure=False).stability.largest_step[method]
        scene = preset(name)
        run = scene.run.replace(
            method=method, time_step=dt, steps="exact", frame_rate=1.0 / dt, duration=STEPS * dt
        )
        own = rw.Simulation(scene.replace(run=run))
        own.advance_frames(STEPS)
        x, v = own.arrays.x, own.arrays.v
        found = np.array(lab.page.evaluate(RUN, [index, method, STEPS, dt]))
        errors = [np.abs(a - b).max() / np.abs(b).max() for a, b in zip(found, (x, v), strict=True)]
        assert max(errors) <= 1e-12, (name, errors)
        if name != "r4":
            continue
        short = np.array(lab.page.evaluate(RUN, [index, method, STEPS - 10, dt]))
        assert np.abs(short[0] - x).max() / np.abs(x).max() > 1e-9, name


@pytest.mark.browser
def test_the_largest_steps_are_those_of_the_theory(lab: Any) -> None:
    for index, name in enumerate(PRESETS):
        steps = rw.check(name, measure=False).stability.largest_step
        for method in METHODS:
            found = lab.page.evaluate(
                "([index, method]) => { const { scenes, Rope, largestStep } = window.ropewalkLab;"
                " return largestStep(new Rope(scenes[index]), method); }",
                [index, method],
            )
            assert found == pytest.approx(steps[method], rel=2e-3), (name, method)


def until(page: Any, expression: str) -> None:
    """Wait until an expression of `lab` holds; the page's policy allows no `eval`, so it is asked."""
    end = time.monotonic() + SECONDS
    while not page.evaluate(
        f"() => {{ const {{ lab }} = window.ropewalkLab; return {expression}; }}"
    ):
        assert time.monotonic() < end, expression
        page.wait_for_timeout(25)


def set_slider(page: Any, name: str, value: float) -> None:
    page.evaluate(
        "([name, value]) => { const slider = document.getElementById(name);"
        " slider.value = value; slider.dispatchEvent(new Event('input')); }",
        [name, value],
    )


@pytest.mark.browser
def test_a_visitor_breaks_a_rope_and_takes_a_step_that_holds(lab: Any) -> None:
    page = lab.page
    assert "Stable" in page.inner_text("#verdict")
    page.click("#play")
    until(page, "lab.rope.time > 0.3")
    set_slider(page, "k", 1.0)  # ten times as stiff
    assert "Unstable" in page.inner_text("#verdict")
    page.wait_for_selector("#broken:not([hidden])")
    assert "In one step the springs push a node past" in page.inner_text("#why")
    assert page.inner_text("#play") == "Play"
    page.click("#shorten")
    assert "Stable: 80 %" in page.inner_text("#verdict")
    until(page, "lab.rope.time > 0.3")
    assert page.is_hidden("#broken")


@pytest.mark.browser
def test_a_node_is_pulled_and_let_go(lab: Any) -> None:
    page = lab.page
    page.click("#once")
    box = page.locator("#rope").bounding_box()
    places = page.evaluate(
        "() => { const { rope, drawing } = window.ropewalkLab.lab;"
        " const middle = [0.5 * (drawing.box.left + drawing.box.right),"
        " 0.5 * (drawing.box.low + drawing.box.high)];"
        " const { width, height } = drawing.canvas, ratio = devicePixelRatio;"
        " return [(0.5 * width + drawing.scale * (rope.x[0][10] - middle[0])) / ratio,"
        " (0.5 * height - drawing.scale * (rope.x[1][10] - middle[1])) / ratio]; }"
    )
    page.mouse.move(box["x"] + places[0], box["y"] + places[1])
    page.mouse.down()
    page.mouse.move(box["x"] + places[0], box["y"] + places[1] + 80, steps=4)
    page.evaluate("window.ropewalkLab.lab.advance(200)")
    held = page.evaluate("window.ropewalkLab.lab.rope.hand.node")
    assert held == 10
    assert page.evaluate("window.ropewalkLab.lab.rope.x[1][10]") < -2.0
    page.mouse.up()
    assert page.evaluate("window.ropewalkLab.lab.rope.hand") is None
    least = page.evaluate("window.ropewalkLab.lab.rope.x[1][10]")
    page.evaluate("window.ropewalkLab.lab.advance(400)")
    assert page.evaluate("window.ropewalkLab.lab.rope.x[1][10]") > least + 1.0  # it springs back


@pytest.mark.browser
@pytest.mark.parametrize("size", [(1200, 760), (390, 844)])
def test_everything_has_its_room(tmp_path: Path, open_window: Any, size: tuple[int, int]) -> None:
    path = write_lab(tmp_path / "lab.html")
    page = open_window(path.as_uri(), viewport={"width": size[0], "height": size[1]}).page
    for scene in range(len(PRESETS)):
        page.select_option("#scene", str(scene))
        assert page.evaluate("document.documentElement.scrollWidth <= innerWidth")
        assert page.locator("#rope").bounding_box()["height"] > 250


def test_what_the_lab_does_not_know_is_refused() -> None:
    for name, what in (
        ("n40", "the lab has no air"),
        ("h1", "the lab has no limiter"),
        ("wave-on-a-string", "no motion of the kind 'shake'"),
        ("fishing-rod", "the lab has no bending stiffness"),
        ("h3", "the lab has no winches"),
    ):
        with pytest.raises(rw.SceneError, match=what):
            lab_scene(preset(name))
