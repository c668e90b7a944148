"""Obstacles in the hand of a page: led by pointer and keys, turned, undone; every kind is seen."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import numpy as np
import pytest

from browser.test_solids import over_a_drum, spot
from browser.window import Window
from ropewalk.live.serve import ViewServer
from ropewalk.live.session import Session
from ropewalk.scene import loads

pytestmark = pytest.mark.browser
Open = Callable[..., Window]
Serve = Callable[..., ViewServer]
WIDE: dict[str, Any] = {"viewport": {"width": 1000, "height": 700}}
MIDDLE = "r.viewport.solids.base('drum')"
TROUGH = """
[run]
duration = 1.0
time_step = 0.01
method = "implicit-euler"
[[rope]]
segments = 8
length = 1.0
diameter = 0.02
made_of = { kind = "material", EA = 1e4, mass_per_length = 0.1, axial_damping = 5.0 }
shape = { kind = "straight", start = [-0.1, -0.5, 0.1], end = [0.1, 0.5, 0.1] }
"""
GUTTER = """
[[obstacle]]
kind = "half-pipe"
from = [0, -1, 0]
to = [0, 1, 0]
radius = 0.4
"""


def on_drum(window: Window) -> tuple[float, float]:
    """A pixel of the drum's face that no rope is near."""
    x, y = window.ask(
        "(() => { const { renderer, camera } = r.viewport; "
        "const box = renderer.canvas.getBoundingClientRect();"
        "const [x, y] = camera.project(-0.08, -0.2, -0.05); return [x + box.left, y + box.top]; })()"
    )
    return x, y


CURTAIN = """
[run]
duration = 1.0
time_step = 0.01
method = "implicit-euler"
[[rope]]
segments = 20
length = 1.05
diameter = 0.01
made_of = { kind = "material", EA = 1e4, mass_per_length = 0.1, axial_damping = 5.0 }
shape = { kind = "slack", start = [-0.5, 0, 0], end = [0.5, 0, 0] }
[[anchor]]
node = 0
[[anchor]]
node = -1
[[obstacle]]
name = "screen"
kind = "box"
center = [0, AWAY, -0.1]
half_sizes = [0.2, 0.03, 0.2]
edge_radius = 0.01
"""


@pytest.mark.parametrize(("away", "taken"), [(-0.3, "body"), (0.3, "rope")])
def test_what_is_in_front_is_taken(
    open_window: Open, serve: Serve, away: float, taken: str
) -> None:
    """The eye looks along y: a screen before the rope is led in its place, one behind it lets it be taken."""
    scene = loads(CURTAIN.replace("AWAY", str(away)))
    window = open_window(serve(Session(scene)).address, **WIDE).ready()
    window.click("#view-y")
    window.settled()
    x, y = window.screen(10)
    window.page.mouse.move(x, y)
    window.until("r.viewport.marks.hover !== null")
    ringed = window.ask("Array.isArray(r.viewport.marks.hover) ? 'body' : 'rope'")
    window.drag((x, y), (30, -20))
    held = window.ask("[...r.app.pointer.hands.values()][0].way === 'body' ? 'body' : 'rope'")
    window.page.mouse.up()
    assert [ringed, held] == [taken, taken]
    assert window.ask("r.app.pointer.hit?.node ?? -1") == (10 if taken == "rope" else -1)


def test_a_drum_is_led_turned_and_put_back(open_window: Open, serve: Serve) -> None:
    window = open_window(serve(Session(over_a_drum())).address, **WIDE).ready()
    window.settled()
    pose = "JSON.stringify(r.viewport.camera.pose)"
    before = window.ask(pose)
    window.drag(on_drum(window), (0, -40))
    window.page.mouse.up()
    assert window.ask(pose) == before  # it is not the view that moves
    window.press(" ")  # while time is paused, hands wait
    window.until(f"{MIDDLE}[2] > 0.02")
    window.until("r.session.status.undo === 'moving the obstacle'")
    window.press("Control+z")
    window.until(f"Math.abs({MIDDLE}[2]) < 1e-9")
    canvas = window.page.locator("#view canvas, canvas").first
    canvas.focus()
    for _ in range(60):
        window.press("Tab")
        if "Obstacle drum" in (canvas.get_attribute("aria-valuetext") or ""):
            break
    assert "Page Up and Page Down turn it" in canvas.get_attribute("aria-valuetext")
    window.press("PageUp")
    window.until("r.viewport.solids.angleOf('drum') > 0.1")
    window.press("ArrowUp")
    window.until(f"{MIDDLE}[2] > 0.005")
    assert window.ask("r.session.frame.parts[0].anchors[2]") == pytest.approx(
        -0.36
    )  # not the anchor


def test_a_floor_is_led_by_keys(open_window: Open, serve: Serve) -> None:
    """They moved the first anchor in its place."""
    floor = """
[[obstacle]]
name = "floor"
kind = "plane"
point = [0, 0, -0.6]
normal = [0, 0, 1]
"""
    scene = loads(CURTAIN.replace("AWAY", "0.3") + floor)
    window = open_window(serve(Session(scene)).address, **WIDE).ready()
    canvas = window.page.locator("#view canvas, canvas").first
    canvas.focus()
    for _ in range(60):
        window.press("Tab")
        if "Obstacle floor" in (canvas.get_attribute("aria-valuetext") or ""):
            break
    assert "at 0 m, 0 m, −0.6 m" in canvas.get_attribute("aria-valuetext")
    window.press(" ", "ArrowUp")
    window.until("r.viewport.solids.base('floor')[2] > -0.599")
    assert window.ask("r.session.frame.parts[0].anchors[2]") == pytest.approx(0.0)


def test_a_drum_is_left_alone_by_another_tool(open_window: Open, serve: Serve) -> None:
    window = open_window(serve(Session(over_a_drum())).address, **WIDE).ready()
    window.click("#tool-pin")
    window.drag(on_drum(window), (0, -40))
    window.page.mouse.up()
    assert window.ask(f"Math.abs({MIDDLE}[2])") < 1e-9
    assert window.ask("r.session.status.undo") == ""


@pytest.mark.parametrize("renderer", ["webgl", "canvas"])
def test_a_half_pipe_is_seen_and_hides_no_rope(
    open_window: Open, serve: Serve, tmp_path: Any, renderer: str
) -> None:
    shown = []
    for text in (TROUGH + GUTTER, TROUGH):
        server = serve(Session(loads(text)), folder=tmp_path / str(len(shown)))
        window = open_window(f"{server.address}?renderer={renderer}", **WIDE).ready()
        window.settled()
        assert window.at_rope(range(1, 8)) > 0.9
        pose = "s.setPose({ ...s.camera.pose, azimuth: -0.9, elevation: 0.7 })"
        window.page.evaluate(f"() => {{ const s = window.ropewalk.viewport; {pose}; }}")
        window.settled()
        shown.append(np.median(spot(window, (-0.28, 0.0, -0.28)), axis=0))
        assert window.at_rope(range(1, 8)) > 0.9
    assert np.abs(shown[0] - shown[1]).max() > 15
