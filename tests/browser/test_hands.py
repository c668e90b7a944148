"""Hands on the rope: grab, pin, cut, load, kick, menu, double-click."""

from __future__ import annotations

import time
from collections.abc import Callable
from itertools import cycle

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


@pytest.fixture
def server(serve: Serve) -> ViewServer:
    """A paused rope between two anchors."""
    return serve(Session(slack_rope()))


@pytest.fixture
def window(server: ViewServer, open_window: Open) -> Window:
    """Its page, at rest."""
    window = open_window(server.address).ready()
    window.settled()
    return window


def test_a_grab_shows_its_force_in_newtons(window: Window, server: ViewServer) -> None:
    window.press(" ")
    window.page.keyboard.down("Shift")
    # Shift on empty space would shift the view, on the rope it keeps the spring
    window.take(20, (0.0, -80.0))
    window.until(f"{GRABS}[0] === 20")
    window.page.mouse.up()
    window.page.keyboard.up("Shift")
    window.until(f"r.time > 1 && Math.hypot(...{GRABS}.slice(4, 7)) > 0.1")
    window.press(" ")
    window.until("r.state === 'paused'")
    window.settled()
    assert window.ask(f"{GRABS}[0]") == 20  # it stays
    force = np.linalg.norm(window.ask(f"[...{GRABS}.slice(4, 7)]"))
    grab = server.broadcast.session.main.hands.grabs[0]
    assert (grab.node, force > 1e-3) == (20, True)  # it swings: small for moments
    shown = window.page.locator(".labels .grab:visible").inner_text()
    number, unit, *_ = shown.split()  # where the rope fell on while it was taken, "(no more)"
    assert float(number) * {"N": 1.0, "kN": 1e3, "mN": 1e-3}[unit] == pytest.approx(force, rel=0.01)
    _double_click(window)
    window.until(f"{GRABS}[0] < 0")
    assert server.broadcast.session.main.hands.grabs == []


def _double_click(window: Window) -> None:
    """The events say when they were, however slow this machine is."""
    mouse = window.page.context.new_cdp_session(window.page)
    about = {"x": EMPTY[0], "y": EMPTY[1], "button": "left", "buttons": 1, "clickCount": 1}
    for when in (time.time(), time.time() + 0.1):
        for kind in ("mousePressed", "mouseReleased"):
            mouse.send("Input.dispatchMouseEvent", about | {"type": kind, "timestamp": when})


def test_a_node_is_pinned_and_let_go_again(window: Window) -> None:
    window.click("#tool-pin")
    assert window.page.locator("#tool-pin").get_attribute("aria-pressed") == "true"
    window.page.mouse.click(*window.screen(15))
    window.until(f"{VARIANT}.anchors.some((a) => a.pinned && a.index === 15)")
    before = window.node(15)
    window.press(" ")
    window.until("r.time > 0.5")
    assert np.allclose(window.node(15), before, atol=1e-5)
    assert not np.allclose(window.node(25), before, atol=1e-2)
    window.press(" ")
    window.until("r.state === 'paused'")
    window.settled()
    window.page.mouse.click(*window.screen(15))
    window.until(f"{VARIANT}.anchors.length === 2")
    then = window.until("r.time")  # a new layout has none until its first frame
    window.press(" ")
    window.until(f"r.time > {then} + 0.5")
    away = f"r.nodeAt(15).map((x, i) => x - {before.tolist()}[i])"
    window.until(f"Math.hypot(...{away}) > 1e-3")  # however few pictures there are


def test_a_rope_is_cut_where_it_is_clicked(window: Window) -> None:
    a, b = window.screen(12), window.screen(13)
    window.click("#tool-cut")
    window.page.mouse.click((a[0] + b[0]) / 2, (a[1] + b[1]) / 2)
    window.until(f"{VARIANT}.ropes.length === 2")
    first, second = window.ask(f"{VARIANT}.ropes.map((rope) => [rope.first, rope.nodes])")
    assert abs(first[0] + first[1] - 13) <= 1
    end = second[0]
    height = window.node(end)[2]
    window.press(" ")
    window.until(f"r.nodeAt({end})[2] < {height} - 1")  # what was held falls


def test_a_joint_is_named_cut_and_tied_again(open_window: Open, serve: Serve) -> None:
    """At its knot the cut tool cuts the joint, a little away from it the rope; undo ties it again."""
    window = open_window(serve(Session(preset("three-leg-sling"))).address).ready()
    window.settled()
    knot = window.screen(window.ask(f"{VARIANT}.joints[0].nodes[0]"))
    window.page.mouse.move(*knot)
    window.until(
        "[...document.querySelectorAll('.labels span')].some((e) => e.innerText === 'ring')"
    )
    window.page.mouse.click(*knot, button="right")
    window.page.get_by_text("Cut the joint ring").click()
    window.until(f"{VARIANT}.joints.length === 0 && {VARIANT}.ropes.length === 4")
    window.click("#undo")
    window.until(f"{VARIANT}.joints.length === 1")
    window.click("#tool-cut")
    window.page.mouse.click(*knot)
    window.until(f"{VARIANT}.joints.length === 0 && {VARIANT}.ropes.length === 4")


def test_a_load_is_hung_and_taken_off(window: Window) -> None:
    window.click("#tool-load")
    window.page.locator("#load-mass").fill("2.5")
    window.page.locator("#load-mass").press("Enter")
    window.page.mouse.click(*window.screen(20))
    window.until(f"{VARIANT}.loads.length === 1")
    assert window.ask(f"[{VARIANT}.loads[0].index, {VARIANT}.loads[0].mass]") == [20, 2.5]
    window.page.mouse.click(*window.screen(20), button="right")
    window.page.get_by_role("menuitem", name="Take the load off (2.5 kg)").click()
    window.until(f"{VARIANT}.loads.length === 0")


def test_a_kick_gives_the_velocity_that_is_drawn(window: Window, server: ViewServer) -> None:
    window.click("#tool-kick")
    window.drag(window.screen(20), (0.0, -100.0))
    window.until("document.querySelector('.labels .kick')?.innerText.endsWith('m/s')")
    shown = float(window.page.locator(".labels .kick").inner_text().split()[0])
    window.page.mouse.up()
    window.until("r.session.frame.parts[0].speed[20] === 65535")
    window.settled()
    velocity = server.broadcast.session.main.simulation.velocities[20]
    assert np.linalg.norm(velocity) == pytest.approx(shown, rel=0.01)
    assert velocity[2] > 0.9 * shown  # upwards


def test_the_menu_of_a_node_does_what_it_says(window: Window, server: ViewServer) -> None:
    def choose(node: int, name: str) -> None:
        window.settled()
        window.page.mouse.click(*window.screen(node), button="right")
        window.page.get_by_role("menuitem", name=name).click()

    choose(10, "Pin it here")
    window.until(f"{VARIANT}.anchors.length === 3")
    choose(10, "Let this node go")
    window.until(f"{VARIANT}.anchors.length === 2")
    choose(20, "Hang 10 kg here")
    window.until(f"{VARIANT}.loads[0]?.mass === 10")
    choose(25, "Kick it up (5 m/s)")
    window.until("r.session.frame.parts[0].speed[25] === 65535")
    assert np.allclose(server.broadcast.session.main.simulation.velocities[25], [0.0, 0.0, 5.0])
    choose(30, "Follow: trail and graphs")
    window.until("!document.getElementById('graphs').hidden")
    window.settled()
    choose(30, "Stop following")
    window.until("r.viewport.marks.followed.size === 0")
    choose(12, "Cut here")  # away from the end, which a small picture would take it for
    window.until(f"{VARIANT}.ropes.length === 2")
    window.page.mouse.click(450, 170, button="right")
    window.page.get_by_role("menuitem", name="Show everything").wait_for()
    window.press("Escape")
    assert window.page.locator(".popup").count() == 0


def test_the_ring_goes_with_a_rope_that_falls(open_window: Open, serve: Serve) -> None:
    window = open_window(serve(playing=True).address).ready()
    window.until("r.time > 0.3")
    window.tell(type="speed", value=0.02)  # it falls on, slowly enough to be pointed at
    away = """(() => {
        const { marks, nodes, starts } = r.viewport;
        if (marks.hover === null) return null;
        const at = 4 * (starts[0] + marks.hover.node);
        const place = marks.ringPlace();
        return Math.hypot(...[0, 1, 2].map((k) => place[k] - nodes.shown[at + k]));
    })()"""
    seen: list[float] = []
    end = time.monotonic() + PATIENCE
    for node in cycle((6, 8, 10, 12, 14, 16)):
        window.page.mouse.move(*window.screen(node))
        for _ in range(5):
            found = window.ask(away)
            seen += [] if found is None else [found]
            window.page.wait_for_timeout(20)
        if len(seen) > 5 and node == 16:
            break
        assert time.monotonic() < end, "no ring"
    assert max(seen) < 1e-9


def test_a_near_miss_shifts_the_view_and_does_not_turn_it(open_window: Open, serve: Serve) -> None:
    window = open_window(serve().address).ready()
    window.settled()
    x, y = window.screen(10)
    pose = "(({azimuth, elevation, target}) => [azimuth, elevation, ...target])(r.viewport.camera.pose)"
    before = np.array(window.ask(pose))
    window.drag((x, y + 30), (40.0, 30.0))
    window.page.mouse.up()
    shifted = np.array(window.ask(pose))
    assert (shifted[:2] == before[:2]).all()
    assert np.abs(shifted[2:] - before[2:]).max() > 0.1
    x, y = window.screen(10)
    window.drag((x, y + 120), (40.0, 30.0))  # the twin: far from the rope the view turns
    window.page.mouse.up()
    assert np.abs(np.array(window.ask(pose))[:2] - shifted[:2]).max() > 0.05


def test_tab_goes_from_place_to_place_and_enter_opens_the_menu(
    open_window: Open, serve: Serve
) -> None:
    window = open_window(serve().address).ready()
    window.settled()
    words = "document.querySelector('#view').getAttribute('aria-valuetext')"
    window.page.locator("#view").focus()
    found = []
    for _ in range(40):
        window.press("Tab")
        if window.ask("document.activeElement.id") != "view":
            break
        found.append(window.ask(words))
    else:
        raise AssertionError("Tab never leaves the scene")
    anchors = [one for one in found if one.startswith("Anchor ")]
    assert len(anchors) == 3
    assert len(set(found)) == len(found) > 8
    assert all(" N" in one for one in found)
    window.page.locator("#view").focus()
    window.press("Tab", "Tab", "Enter")
    assert "Node " in window.page.locator(".popup .popup-title").inner_text()
    focused = "document.activeElement.textContent"
    first = window.ask(focused)
    window.press("ArrowDown")
    second = window.ask(focused)
    window.press("ArrowUp")
    assert window.ask(focused) == first != second
    window.press("ArrowUp")  # round to the last
    assert window.ask(focused).startswith("Follow")
    window.press("Escape")
    assert window.ask("document.activeElement.id") == "view"
    assert window.ask(words) == found[1]  # where it was
    assert "paused" in window.page.locator("#voice").inner_text()
    assert "3 anchors hold" in window.page.locator("#voice").inner_text()


def test_what_was_done_is_undone_by_button_and_key(window: Window) -> None:
    undo = window.page.locator("#undo")
    assert undo.is_disabled()
    window.click("#tool-cut")
    window.page.mouse.click(*window.screen(12))
    window.until(f"{VARIANT}.ropes.length === 2")
    window.until("document.getElementById('undo').getAttribute('aria-label') === 'Undo the cut'")
    undo.click()
    window.until(f"{VARIANT}.ropes.length === 1")
    window.until("document.getElementById('undo').disabled")
    window.settled()
    window.click("#tool-pin")
    window.page.mouse.click(*window.screen(15))
    window.until(f"{VARIANT}.anchors.length === 3")
    window.until("!document.getElementById('undo').disabled")
    window.press("Control+z")
    window.until(f"{VARIANT}.anchors.length === 2")


def test_a_rope_let_go_in_motion_is_thrown(window: Window) -> None:
    """The events say when they were, however slow this machine is."""
    window.press(" ")
    window.until("r.state === 'playing'")
    window.page.evaluate(
        """() => { window.sent = []; const { source } = window.ropewalk.session;
            const send = source.send.bind(source);
            source.send = (command) => {
              if (command.type === "let_go") window.sent.push(command);
              send(command);
            }; }"""
    )
    mouse = window.page.context.new_cdp_session(window.page)
    for rest in (0.01, 0.5):  # [s] before the release
        x = y = now = 0.0

        def tell(kind: str, way: float, after: float) -> None:
            about = {"type": kind, "x": x, "y": y - way, "timestamp": now + after}  # noqa: B023
            pressed = {"button": "left", "buttons": 1, "clickCount": 1}
            mouse.send("Input.dispatchMouseEvent", about | pressed)

        while not window.ask("r.app.pointer.hands.size"):  # the rope may have gone on
            tell("mouseReleased", 0.0, 0.0)
            (x, y), now = window.screen(20), time.time()
            tell("mousePressed", 0.0, 0.0)
        window.ask("(window.sent.length = 0)")
        for part in range(1, 9):
            tell("mouseMoved", 8.0 * part, 0.01 * part)
        tell("mouseReleased", 64.0, 0.08 + rest)
        window.until("window.sent.length > 0")
        velocity = window.page.evaluate("() => window.sent.pop().velocity")
        if rest < 0.1:
            assert velocity[2] > 1.0  # upwards, as the hand was
        else:
            assert velocity is None  # the twin: a hand that rested throws nothing


def test_a_pull_is_limited_and_says_so(window: Window, server: ViewServer) -> None:
    window.page.locator("#pull-limit").fill("5")
    window.page.locator("#pull-limit").press("Enter")
    window.press(" ")
    window.take(20, (0.0, -150.0))
    window.until("document.querySelector('.labels .grab')?.innerText === '5 N (no more)'")
    window.until(f"Math.abs(Math.hypot(...{GRABS}.slice(4, 7)) - 5) < 1e-5")
    window.page.mouse.up()
