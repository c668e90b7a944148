"""Every button, key, choice and view of the page has its effect."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np
import pytest

from browser.window import Window
from live.drive import slack_rope
from ropewalk.live.session import Session

pytestmark = pytest.mark.browser
Open = Callable[..., Window]
Serve = Callable[..., object]
SPEEDS = [0.01, 0.02, 0.05, 0.1, 0.2, 0.5, 1, 2, 4]
# By the key: what it does, with what tells it. `before` is what `watch` said first.
SHORTCUTS = {
    "f": ("r.viewport.camera.pose.distance", "was !== now"),
    "g": ("document.getElementById('graphs').hidden", "was !== now"),
    "p": ("document.getElementById('panel').hidden", "was !== now"),
    "t": ("document.documentElement.dataset.theme", "was !== now"),
    " ": ("r.session.status.playing", "was !== now"),
}
# Keys of the three hands: left, right, up, down, away, near; and the axis and sign of each.
HANDS = [
    ["ArrowLeft", "ArrowRight", "ArrowUp", "ArrowDown", "Home", "End"],
    ["a", "d", "w", "s", "q", "e"],
    ["j", "l", "i", "k", "u", "o"],
]
WAYS = [(0, -1), (0, 1), (2, 1), (2, -1), (1, 1), (1, -1)]


def test_buttons_play_pause_step_and_reset(window: Window) -> None:
    window.click("#play")
    window.until("r.state === 'playing' && r.time > 0.05")
    assert window.page.locator("#step").is_disabled()
    window.click("#play")
    window.until("r.state === 'paused'")
    window.settled()
    time = window.ask("r.time")
    window.click("#step")
    window.until(f"Math.abs(r.time - {time} - r.session.status.dt) < 1e-9")
    window.click("#reset")
    window.until("r.time === 0")
    window.until("document.getElementById('clock').innerText === '0.00 s'")


def test_every_speed_is_reached_by_its_notch(window: Window) -> None:
    for notch, speed in enumerate(SPEEDS):
        window.page.locator("#speed").fill(str(notch))
        window.until(f"r.session.status.speed === {speed}")
    assert window.page.locator("#speed-text").inner_text() == "4×"
    window.page.locator("#speed").fill("3")  # a tenth: the factor reached is the one asked for
    window.press(" ")
    window.until("Math.abs(r.session.status.realtime / 0.1 - 1) < 0.1")


def test_every_key_of_the_help_has_an_effect(window: Window) -> None:
    window.page.mouse.move(640, 300)
    _zoom(window, 300)
    done = {".", "r", "h", "?", *SHORTCUTS}
    for key, (watch, effect) in SHORTCUTS.items():
        window.page.evaluate(f"() => {{ const r = window.ropewalk; window.was = {watch}; }}")
        window.press(key)
        window.until(f"((was, now) => {effect})(window.was, {watch})")
        if key != "f":
            window.press(key)
            window.until(f"window.was === {watch}")
    _press_steps(window)
    for key in ("h", "?"):
        window.press(key)
        window.page.locator("dialog.help[open]").wait_for()
        told = window.page.locator("dialog.help kbd").all_inner_texts()
        window.press("Escape")
        window.page.locator("dialog.help[open]").wait_for(state="detached")
    done |= _press_hands(window) | _press_places(window)
    names = {"←": "ArrowLeft", "→": "ArrowRight", "↑": "ArrowUp", "↓": "ArrowDown", "Space": " "}
    keys = {key for text in told for key in text.replace(",", " ").split() if key != "or"}
    listed = {names.get(key, key.lower() if len(key) == 1 else key) for key in keys}
    elsewhere = {"Ctrl", "z", "Page", "Up", "Down"}  # pressed in test_hands and test_bodies
    assert listed == done | elsewhere  # no key is listed that was not pressed, and none left out


def _zoom(window: Window, by: int) -> None:
    """Turn the wheel, and wait until the page has heard of it."""
    distance = window.ask("r.viewport.camera.pose.distance")
    window.page.mouse.wheel(0, by)
    window.until(f"r.viewport.camera.pose.distance !== {distance}")
    window.settled()


def _press_places(window: Window) -> set[str]:
    """Go to a place on the ropes and open its menu."""
    window.page.locator("#view").focus()
    window.press("Tab", "Enter")
    window.page.locator(".popup .popup-title").wait_for()
    window.press("Escape")
    window.page.locator(".popup").wait_for(state="hidden")
    return {"Tab", "Enter"}


def _press_steps(window: Window) -> None:
    window.until("r.state === 'paused'")
    window.press("r")
    window.until("r.time === 0")
    window.press(".")
    window.until("Math.abs(r.time - r.session.status.dt) < 1e-9")


def _press_hands(window: Window) -> set[str]:
    """Hold every movement key for a moment: its anchor, and no other, gets 3 m/s its way."""
    for hand, keys in enumerate(HANDS):
        at = f"r.session.frame.parts[0].anchors.slice({10 * hand + 3}, {10 * hand + 6})"
        for key, (axis, sign) in zip(keys, WAYS, strict=True):
            window.page.keyboard.down(key)
            window.until(f"Math.abs({at}[{axis}] - {3 * sign}) < 1e-3")
            moving = window.ask(f"[0, 1, 2].filter((a) => {_fast('a')})")
            assert moving == [hand]
            window.page.keyboard.up(key)
            window.until(f"!({_fast(str(hand))})")
    return {key for keys in HANDS for key in keys}


def _fast(anchor: str) -> str:
    part = f"r.session.frame.parts[0].anchors.slice(10 * {anchor} + 3, 10 * {anchor} + 6)"
    return f"Math.hypot(...{part}) > 0.01"


def test_every_colouring_has_its_unit_and_its_picture(window: Window) -> None:
    window.press(" ")
    window.until("r.time > 0.3")
    window.press(" ")
    window.until("r.state === 'paused'")
    seen = []
    for colouring, unit in (("tension", "N"), ("strain", "%"), ("speed", "m/s"), ("plain", "")):
        window.page.locator("#colouring").select_option(colouring)
        window.settled()
        numbers = window.page.locator("#legend-numbers")
        if unit:
            assert numbers.inner_text().endswith(unit)
        else:
            assert not numbers.is_visible()
            assert window.page.locator(".rope-names").inner_text() == "rope"
        assert window.at_rope(range(2, 19)) > 0.9
        if colouring != "strain":  # of one rope that is like tension but for the unit
            seen.append(_middle(window))
    for i, one in enumerate(seen):
        for other in seen[:i]:
            assert np.abs(one - other).max() > 40


def _middle(window: Window) -> np.ndarray:
    """The colours along the first half of the rope."""
    picture = window.picture()
    places = [window.screen(node) for node in range(2, 19)]
    return np.array([picture[round(y), round(x)] for x, y in places])


def test_arrows_and_nodes_can_be_shown_and_hidden(window: Window) -> None:
    window.settled()
    assert window.page.locator(".labels .reaction:visible").count() >= 1
    window.page.locator("#show-forces").uncheck()
    window.settled()
    assert window.page.locator(".labels .reaction:visible").count() == 0
    before = window.picture()
    window.page.locator("#show-nodes").check()
    window.page.mouse.move(640, 10)
    window.settled()
    assert (np.abs(window.picture() - before).max(axis=2) > 60).sum() > 38


def test_every_view_looks_its_way(window: Window) -> None:
    toward = "[...r.viewport.camera.toward]"
    window.settled()
    first = window.ask(toward)
    for k, name in enumerate("xyz"):
        window.click(f"#view-{name}")
        window.settled()
        one = np.array(window.ask(toward))
        assert abs(one[k]) > 0.99
        window.click(f"#view-{name}")
        window.settled()
        assert np.dot(one, window.ask(toward)) < -0.99  # from the other side
    window.click("#view-home")
    window.settled()
    assert np.allclose(window.ask(toward), first, atol=1e-3)
    window.page.mouse.move(640, 300)
    _zoom(window, 500)
    far = window.ask("r.viewport.camera.pose.distance")
    window.click("#view-fit")
    window.settled()
    assert window.ask("r.viewport.camera.pose.distance") < 0.9 * far
    assert window.at_rope(range(2, 39)) > 0.9


def test_the_hand_turns_shifts_and_zooms_the_view(window: Window) -> None:
    window.settled()
    pose = (
        "(({azimuth, target, distance}) => [azimuth, ...target, distance])(r.viewport.camera.pose)"
    )
    empty = (500.0, 150.0)
    before = np.array(window.ask(pose))
    window.drag(empty, (80.0, 20.0))
    window.page.mouse.up()
    turned = np.array(window.ask(pose))
    assert abs(turned[0] - before[0]) > 0.1
    assert np.allclose(turned[1:], before[1:])
    window.page.keyboard.down("Shift")
    window.drag(empty, (80.0, 20.0))
    window.page.mouse.up()
    window.page.keyboard.up("Shift")
    shifted = np.array(window.ask(pose))
    assert shifted[0] == turned[0]
    assert np.linalg.norm(shifted[1:4] - turned[1:4]) > 0.1
    window.page.mouse.wheel(0, -300)
    window.until(f"r.viewport.camera.pose.distance < {0.9 * shifted[4]}")


def test_panel_and_theme_by_their_buttons(window: Window) -> None:
    width = window.ask("r.viewport.camera.width")
    window.click("#toggle-panel")
    window.until(f"r.viewport.camera.width > {width}")
    window.settled()
    assert window.picture()[400, 400].sum() > 600
    window.click("#toggle-theme")
    window.settled()
    assert window.picture()[400, 400].sum() < 200
    assert window.at_rope(range(2, 39)) > 0.9


def test_opening_graphs_and_panel_keeps_the_camera(open_window: Open, serve: Serve) -> None:
    window = open_window(serve().address, viewport={"width": 1100, "height": 620}).ready()
    window.settled()
    window.drag((700.0, 150.0), (60.0, 20.0))  # to another side
    window.page.mouse.up()
    for following in (False, True):
        window.page.evaluate(
            f"() => {{ window.ropewalk.viewport.following = {str(following).lower()}; }}"
        )
        pose = "(({azimuth, elevation}) => [azimuth, elevation])(r.viewport.camera.pose)"
        before = window.ask(pose)
        for key in "gg":
            window.press(key)
            window.settled()
            assert window.ask(pose) == before


def test_the_colours_may_tell_how_near_a_rope_is_to_breaking(
    open_window: Open, serve: Serve
) -> None:
    scene = slack_rope()
    strong = scene.ropes[0].made_of.replace(breaking_load=100.0)
    scene = scene.replace(ropes=[scene.ropes[0].replace(made_of=strong)])
    window = open_window(serve(Session(scene)).address).ready()
    window.settled()
    window.page.locator("#colouring").select_option("utilisation")
    window.until("r.viewport.range.high === 1")
    window.press(" ")
    window.until("r.time > 0.5")
    window.press(" ")
    window.until("r.state === 'paused'")
    window.settled()
    most = window.ask("r.viewport.tensions[0][0]")
    parts = "r.session.frame.parts[0].scalars[r.session.layout.scalars.indexOf('tension_max')]"
    assert most == pytest.approx(window.ask(parts), rel=1e-3)
    text = window.page.locator("#margin").inner_text()
    assert text.startswith("Most now: ")
    assert "safety factor" in text
    numbers = window.page.locator("#legend-numbers").inner_text()
    assert numbers.split()[-2:] == ["100", "%"]
    # where no breaking load is known it cannot be chosen
    window.tell(type="scene", preset="r4")
    window.until("r.viewport.colouring === 'tension' && r.session.layout.scene.preset === 'r4'")
    assert window.ask("document.querySelector('#colouring [value=utilisation]').disabled")


@pytest.mark.parametrize("size", [(390, 844), (360, 640), (844, 390)])
def test_whatever_a_finger_presses_is_large_enough_and_in_reach(
    open_window: Open, serve: Serve, size: tuple[int, int]
) -> None:
    phone = {"viewport": {"width": size[0], "height": size[1]}, "has_touch": True}
    window = open_window(serve().address, **phone, is_mobile=True).ready()
    _fits_fingers(window)
    window.press("p")
    _fits_fingers(window)
    window.press("p", "g")
    window.until(
        "document.querySelector('.u-over') && !document.getElementById('graph-scroll').hidden"
    )
    _fits_fingers(window)
    if size[0] > size[1]:
        return  # lying, all tools have their row
    # what has no room in the small scene is one press away, and folded again once chosen
    pin = window.page.locator("#tool-pin")
    assert not pin.is_visible()
    window.click(".toolbar:not(.views) .fold")
    _fits_fingers(window)
    pin.click()
    window.until("r.app.pointer.tool === 'pin'")
    assert pin.is_visible()
    assert not window.page.locator("#tool-kick").is_visible()
    window.click(".views .fold")
    _fits_fingers(window)
    window.click("#view-x")
    window.until("!document.querySelector('.unfolded')")


def test_a_phone_has_a_menu_of_graphs(open_window: Open, serve: Serve) -> None:
    phone = {"viewport": {"width": 390, "height": 844}, "has_touch": True}
    window = open_window(serve().address, **phone, is_mobile=True).ready()
    window.press("g")
    assert window.page.locator(".chips").is_hidden()
    for name in ("tension", "forces", "height", "speed", "phase", "energies"):
        window.page.select_option("#graph-choice", name)
        kind = "motion" if name in ("height", "speed") else name
        assert window.ask("[...r.app.graphs.panels.keys()]") == [kind]
        assert window.page.locator("#graph-choice").input_value() == name
    window.page.select_option("#graph-choice", "speed")
    assert window.ask("r.app.graphs.quantity") == "speed"


def _fits_fingers(window: Window) -> None:
    """Check sizes of all that can be pressed, and that it is in the window or can be scrolled up to."""
    found = window.page.evaluate(
        """() => [...document.querySelectorAll("button, input, select, summary")]
            .filter((e) => e.checkVisibility({ visibilityProperty: true }) && e.offsetWidth)
            .map((e) => {
              if (e.closest(".panel")) e.scrollIntoView();
              const box = (e.type === "checkbox" ? e.closest("label") : e).getBoundingClientRect();
              const { x, y, width, height, right, bottom } = box;
              return { name: e.id || e.className, width, height,
                       away: Math.max(-x, -y, right - innerWidth, bottom - innerHeight) };
            })"""
    )
    assert len(found) > 15
    for one in found:
        assert one["height"] >= 44, one
        assert one["width"] >= 44, one
        assert one["away"] < 1, one
    sideways = """[...document.querySelectorAll("*")].filter((e) => e.clientWidth
        && /auto|scroll/.test(getComputedStyle(e).overflowX) && e.scrollWidth > e.clientWidth + 1
        && e.checkVisibility()).map((e) => e.id || e.className)"""
    assert window.ask(sideways) == []
