"""Tying two points on the page: with the tool, by one stroke, from the keyboard's menu; undone, refused."""

from __future__ import annotations

from collections.abc import Callable

import pytest

from browser.window import Window
from live.test_ties import A_END, B_END, two
from ropewalk.live.serve import ViewServer
from ropewalk.live.session import Session

pytestmark = pytest.mark.browser
Open = Callable[..., Window]
Serve = Callable[..., ViewServer]
VARIANT = "r.session.layout.variants[0]"
SAID = "[...document.querySelectorAll('.notice')].map((e) => e.innerText).join(' ')"


@pytest.fixture
def window(serve: Serve, open_window: Open) -> Window:
    """Two ropes that hang side by side, paused."""
    wide = {"width": 1200, "height": 860}  # no card lies over a rope's end
    window = open_window(serve(Session(two(apart=0.3))).address, viewport=wide).ready()
    window.settled()
    return window


def _play_until_tied(window: Window) -> None:
    window.until(f"{VARIANT}.anchors.some((a) => a.name === 'tie1')")
    window.press(" ")
    window.until(f"{VARIANT}.joints.length === 1 && {VARIANT}.anchors.length === 2", seconds=240)
    assert window.ask(f"{VARIANT}.joints[0]") == {"name": "knot1", "nodes": [A_END, B_END]}
    window.until(f"r.nodeAt({A_END}).every((x, k) => x === r.nodeAt({B_END})[k])")


def test_two_presses_with_the_tool_tie_and_undo_unties(window: Window) -> None:
    window.click("#tool-tie")
    window.page.mouse.click(*window.screen(A_END))
    window.until(f"r.viewport.marks.tying?.node === {A_END}")
    window.heard("Node 10 of a: choose")
    window.page.keyboard.press("Escape")
    assert window.ask("r.viewport.marks.tying") is None
    window.page.mouse.click(*window.screen(A_END))
    window.heard("choose the point")
    window.page.mouse.click(*window.screen(B_END))
    window.heard("0.3 m apart: hands bring them together")
    assert "choose the point" not in window.ask(SAID)
    _play_until_tied(window)
    assert window.page.locator("#undo").get_attribute("title") == "Undo the tie (Ctrl+Z)"
    window.click("#undo")
    window.until(f"{VARIANT}.joints.length === 0")


def test_a_stroke_from_one_point_to_the_other_ties_them(window: Window) -> None:
    window.click("#tool-tie")
    a, b = window.screen(A_END), window.screen(B_END)
    pose = window.ask("({...r.viewport.camera.pose})")
    window.page.mouse.move(*a)
    window.page.mouse.down()
    window.page.mouse.move(0.5 * (a[0] + b[0]), a[1] - 40.0, steps=4)
    window.until("r.viewport.marks.line !== null")
    window.page.mouse.move(*b, steps=4)
    window.page.mouse.up()
    assert window.ask("({...r.viewport.camera.pose})") == pose  # the view was not turned
    _play_until_tied(window)


def test_the_keyboards_menu_ties_and_says_what_cannot_be(window: Window) -> None:
    keys = window.page.keyboard

    def menu_at(words: str) -> None:
        window.page.evaluate("() => document.activeElement.blur()")  # a closed menu leads back
        window.page.locator("#view").focus()
        for _ in range(60):
            keys.press("Tab")
            if words in str(window.page.locator("#view").get_attribute("aria-valuetext")):
                break
        else:
            raise AssertionError(f"Tab never came to {words}")
        keys.press("Enter")

    menu_at("Anchor a0")
    window.page.get_by_text("Tie it to another point").click()
    menu_at("Anchor b0")
    window.page.get_by_text("Tie Anchor a0 to it").click()
    said = "The two points are held by anchors 'a0' and 'b0'; let one of the two go first (nodes: "
    window.heard(said)
    menu_at("Node 10 of a")
    window.page.get_by_text("Tie it to another point").click()
    menu_at("Node 10 of b")
    window.page.get_by_text("Tie Node 10 of a to it").click()
    _play_until_tied(window)
    menu_at("tied by joint knot1")
    window.page.get_by_text("Cut the joint knot1").click()
    window.until(f"{VARIANT}.joints.length === 0")
