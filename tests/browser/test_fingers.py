"""Fingers on a touch screen: an anchor dragged, the menu, two ropes held at once, the view."""

from __future__ import annotations

import time
from collections.abc import Callable

import numpy as np
import pytest

from browser.window import Window
from live.drive import slack_rope
from patience import PATIENCE
from ropewalk.live.serve import ViewServer
from ropewalk.live.session import Session
from ropewalk.scene.presets import preset

pytestmark = pytest.mark.browser
Open = Callable[..., Window]
Serve = Callable[..., ViewServer]
EMPTY = (450.0, 420.0)
GRABS = "r.session.frame.parts[0].grabs"
VARIANT = "r.session.layout.variants[0]"


class _Fingers:
    """Touches by the browser's own protocol."""

    def __init__(self, window: Window) -> None:
        self.window = window
        self.session = window.page.context.new_cdp_session(window.page)

    def _send(self, kind: str, places: list[tuple[float, float]]) -> None:
        points = [{"x": x, "y": y, "id": i} for i, (x, y) in enumerate(places)]
        self.session.send("Input.dispatchTouchEvent", {"type": kind, "touchPoints": points})

    def down(self, places: list[tuple[float, float]]) -> None:
        self._send("touchStart", places)

    def move(self, places: list[tuple[float, float]]) -> None:
        self._send("touchMove", places)

    def up(self) -> None:
        self._send("touchEnd", [])

    def until_held(self, count: int, press: Callable[[], str]) -> str:
        """Press until so many things are held, and return what `press` does: where half a second goes by
        before a finger moves its press is a long one, which opens a menu."""
        end = time.monotonic() + PATIENCE
        while time.monotonic() < end:
            made = press()
            if self.window.ask("r.viewport.marks.held.size") == count:
                return made
            self.up()
            self.window.press("Escape")
        raise AssertionError(f"not held: {count}\n{self.window.situation()}")

    def take(self, node: str, by: tuple[float, float]) -> None:
        """Drag a node, which may move."""

        def press() -> str:
            x, y = self.window.screen(node)
            self.down([(x, y)])
            for part in (0.3, 0.6, 1.0):
                self.move([(x + part * by[0], y + part * by[1])])
            return node

        self.until_held(1, press)


def test_fingers_drag_an_anchor_open_the_menu_and_zoom(open_window: Open, serve: Serve) -> None:
    server = serve(Session(slack_rope()))
    window = open_window(server.address, has_touch=True, is_mobile=True).ready()
    window.settled()
    touch = _Fingers(window)
    window.page.locator("#play").tap()
    window.until("r.state === 'playing'")
    before = window.node(40)
    touch.take(f"{VARIANT}.anchors[1].index", by=(-70.0, -50.0))
    window.until(f"r.nodeAt(40)[2] > {before[2]} + 0.3 && r.nodeAt(40)[0] < {before[0]} - 0.3")
    touch.up()
    window.press(" ")
    window.until("r.state === 'paused'")
    window.settled()
    touch.down([window.screen(20)])
    window.page.get_by_role("menuitem", name="Pin it here").wait_for()
    touch.up()
    window.page.get_by_role("menuitem", name="Pin it here").tap()
    window.until(f"{VARIANT}.anchors.length === 3")
    far = window.ask("r.viewport.camera.pose.distance")
    x, y = EMPTY
    touch.down([(x - 40, y), (x + 40, y)])
    touch.move([(x - 120, y), (x + 120, y)])
    touch.up()
    assert window.ask("r.viewport.camera.pose.distance") < 0.6 * far


def test_two_fingers_hold_two_ropes_at_once(open_window: Open, serve: Serve) -> None:
    """Each has its own spring, follows its own finger, and lets go alone; the view stays as it is."""
    session = Session(preset("three-leg-sling"))
    server = serve(session)
    window = open_window(server.address, has_touch=True, is_mobile=True).ready()
    window.settled()
    first, second = (f"({VARIANT}.ropes[{rope}].first + 4)" for rope in (0, 2))
    touch = _Fingers(window)

    def press() -> str:
        pose: str = window.ask("JSON.stringify(r.viewport.camera.pose)")
        (ax, ay), (bx, by) = places = [window.screen(first), window.screen(second)]
        touch.down(places[:1])
        touch.down(places)
        for part in (0.5, 1.0):
            touch.move([(ax - 40 * part, ay), (bx + 40 * part, by + 20 * part)])
        return pose

    pose = touch.until_held(2, press)
    window.until(f"{GRABS}[0] >= 0 && {GRABS}[8] >= 0")
    held = set(window.ask(f"[{GRABS}[0], {GRABS}[8]]"))  # of one frame: their order may change
    assert held == {window.ask(first), window.ask(second)}
    targets = np.array(window.ask(f"[[...{GRABS}.slice(1, 4)], [...{GRABS}.slice(9, 12)]]"))
    assert np.linalg.norm(targets[1] - targets[0]) > 0.1
    assert window.ask("JSON.stringify(r.viewport.camera.pose)") == pose
    touch.up()
    window.until(f"{GRABS}[0] < 0 && {GRABS}[8] < 0")
