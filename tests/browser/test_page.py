"""The live page: first frame, keys, hands."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np
import pytest

from browser.window import Window
from ropewalk.live.session import Session
from ropewalk.scene.presets import preset

pytestmark = pytest.mark.browser
Open = Callable[..., Window]
Serve = Callable[..., object]


@pytest.fixture
def window(open_window: Open, serve: Serve) -> Window:
    """A paused page of the report's main scene."""
    return open_window(serve().address).ready()


def test_first_frame_shows_the_rope_where_the_data_says(window: Window) -> None:
    assert window.ask("r.state") == "paused"
    assert "R4" in window.page.title()
    window.settled()
    nodes = window.ask("r.session.layout.variants[0].nodes")
    assert window.at_rope(range(1, nodes - 1)) > 0.9
    # The twin: with the ropes not drawn, nothing is there.
    window.page.evaluate("() => { document.getElementById('view').style.visibility = 'hidden'; }")
    assert window.at_rope(range(1, nodes - 1)) < 0.1


def test_space_plays_and_pauses(window: Window) -> None:
    window.page.keyboard.press("Space")
    window.until("r.state === 'playing' && r.time > 0.2")
    window.page.keyboard.press("Space")
    window.until("r.state === 'paused'")
    window.settled()
    assert window.page.locator("#play").get_attribute("aria-label") == "Play"


def test_full_stop_makes_one_step_and_r_resets(window: Window) -> None:
    dt = window.ask("r.session.status.dt")
    for count in (1, 2, 3):
        window.page.keyboard.press(".")
        window.until(f"Math.abs(r.time - {count * dt}) < 1e-9")
    window.page.keyboard.press("r")
    window.until("r.time === 0")


def test_speed_slider_sets_the_speed(window: Window) -> None:
    window.page.locator("#speed").fill("0")
    window.until("r.session.status.speed === 0.01")
    window.page.locator("#speed").fill("8")
    window.until("r.session.status.speed === 4")


@pytest.mark.parametrize(
    ("key", "axis", "sign"),
    [("ArrowRight", 0, 1), ("ArrowLeft", 0, -1), ("ArrowUp", 2, 1), ("ArrowDown", 2, -1)],
)
def test_arrow_keys_move_the_first_anchor_at_3_m_per_s(
    open_window: Open, serve: Serve, key: str, axis: int, sign: int
) -> None:
    window = open_window(serve(_two_anchors(), playing=True).address).ready()
    node = window.ask("r.session.layout.variants[0].anchors[0].index")
    before, start = window.node(node), window.ask("r.time")
    window.page.keyboard.down(key)
    window.until(f"{sign} * (r.nodeAt({node})[{axis}] - {before[axis]}) > 0.3")
    found = window.ask(
        f"[r.nodeAt({node}), [...r.session.frame.parts[0].anchors.slice(3, 6)], r.time]"
    )
    window.page.keyboard.up(key)
    place, velocity, now = np.array(found[0]), found[1], found[2]
    assert velocity[axis] == pytest.approx(3.0 * sign, rel=0.02)
    moved = sign * (place - before)[axis]
    assert moved <= 3.0 * (now - start) * 1.02
    others = [i for i in range(3) if i != axis]
    assert np.abs((place - before)[others]).max() < 0.05 * moved
    window.until("r.session.frame.parts[0].anchors.slice(3, 6).every((v) => Math.abs(v) < 1e-6)")


def _two_anchors():  # type: ignore[no-untyped-def]
    from live.drive import slack_rope
    from ropewalk.live.session import Session

    return Session(slack_rope(), None)


def test_dragged_anchor_takes_the_rope_along(open_window: Open, serve: Serve) -> None:
    window = open_window(serve(_two_anchors(), playing=True).address).ready()
    anchor = window.ask("r.session.layout.variants[0].anchors[0].index")
    before = [window.node(anchor), window.node(10)]
    start = window.take(anchor, (60.0, 90.0))
    target = window.ask(
        f"r.viewport.camera.inPlane({start[0] + 60}, {start[1] + 90}, [0, 0, 0]) && 1"
    )
    assert target == 1
    window.until(
        f"(([x, y]) => Math.hypot(r.screenOf({anchor}).x - x, r.screenOf({anchor}).y - y) < 6)"
        f"([{start[0] + 60}, {start[1] + 90}])"
    )
    window.until(f"Math.hypot(...r.nodeAt(10).map((v, i) => v - {before[1].tolist()}[i])) > 0.2")
    window.page.mouse.up()
    assert np.linalg.norm(window.node(anchor) - before[0]) > 0.3
    window.page.keyboard.press("Space")
    window.until("r.state === 'paused'")
    window.settled()
    assert window.at_rope(range(2, 39)) > 0.85  # a label or a ring may lie on some


def test_node_is_grabbed_by_a_soft_spring(open_window: Open, serve: Serve) -> None:
    window = open_window(serve(_two_anchors(), playing=True).address).ready()
    before = window.node(20)
    window.take(20, (0.0, -60.0))
    window.until("r.session.frame.parts[0].grabs[0] >= 0")
    window.until("Math.hypot(...r.session.frame.parts[0].grabs.slice(4, 7)) > 0")
    window.until(f"r.nodeAt(20)[2] > {before[2]} + 0.1 || r.nodeAt(19)[2] > {before[2]} + 0.1")
    # A rope that lies in a plane is drawn about in it, though the camera looks at it aslant.
    assert abs(window.node(20)[1]) < 1e-9
    window.until("/^[\\d.]+ m?N$/.test(document.querySelector('.labels .grab')?.innerText)")
    window.page.mouse.up()
    window.until("r.session.frame.parts[0].grabs[0] < 0")


def test_the_anchors_force_is_played_when_it_is_asked_for(window: Window) -> None:
    sound = window.page.locator("#sound")
    assert sound.get_attribute("aria-pressed") == "false"
    window.press(" ")
    window.until("r.time > 0.2")
    hearing = "r.app.controls.hearing"
    assert window.ask(f"[{hearing}.sound.on, {hearing}.heard]") == [False, 0]
    sound.click()
    assert sound.get_attribute("aria-pressed") == "true"
    window.until(f"{hearing}.heard > 50 && {hearing}.sound.loudest > 0")
    sound.click()
    assert window.ask(f"{hearing}.sound.on") is False


def test_what_flies_freely_has_a_trail_from_the_start(open_window: Open, serve: Serve) -> None:
    window = open_window(serve(Session(preset("n39-gravity"), "n39-gravity")).address).ready()
    assert window.ask("[...r.viewport.marks.followed]") == [0]
    window.tell(type="scene", preset="r4")
    window.until("r.session.layout.scene.preset === 'r4'")
    assert window.ask("r.viewport.marks.followed.size") == 0
