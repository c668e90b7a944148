"""Pictures: the rope is where the data says, nothing covers anything, and the docs' pictures.

With ROPEWALK_PICTURES=docs/images the pictures of README and docs are written there.
"""

from __future__ import annotations

import os
import time
from collections.abc import Callable
from itertools import combinations
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from PIL import Image

from browser.window import Window
from live.drive import slack_rope
from patience import PATIENCE
from ropewalk.live.serve import ViewServer
from ropewalk.live.session import Session
from ropewalk.scene import Ground, Straight
from ropewalk.scene.presets import preset

pytestmark = pytest.mark.browser
Open = Callable[..., Window]
Serve = Callable[..., ViewServer]
WIDE: dict[str, Any] = {"viewport": {"width": 1200, "height": 760}}
PHONE: dict[str, Any] = {
    "viewport": {"width": 390, "height": 844},
    "device_scale_factor": 2,
    "has_touch": True,
    "is_mobile": True,
}
LYING = PHONE | {"viewport": {"width": 844, "height": 390}}
DARK = {"color_scheme": "dark"}
LIGHT = {"color_scheme": "light"}
SHAPES = {
    "light": WIDE | LIGHT,
    "dark": WIDE | DARK,
    "phone": PHONE | LIGHT,
    "phone-dark": PHONE | DARK,
    "phone-lying": LYING | LIGHT,
}
# The pictures that README and docs show; each is below 200 kB.
SHOWN = {"light-graphs", "dark", "dark-broken", "phone", "phone-dark-graphs"}
# What lies over the scene; of these none may cover another.
CARDS = ".toolbar, .legend, .difference, .tour, .broken, .slow-note"
BOXES = f"""[...document.querySelectorAll("{CARDS}")]
    .filter((e) => e.getClientRects().length)
    .map((e) => [e.className, ...Object.values(e.getBoundingClientRect().toJSON()).slice(0, 4)])"""

LABELS = """[...document.querySelectorAll(".labels span:not([hidden])")]
    .map((e) => Object.values(e.getBoundingClientRect().toJSON()).slice(0, 4))"""


@pytest.mark.parametrize("renderer", ["webgl", "canvas"])
def test_the_rope_is_where_the_data_says(open_window: Open, serve: Serve, renderer: str) -> None:
    server = serve(Session(slack_rope()))
    window = open_window(f"{server.address}?renderer={renderer}", **WIDE).ready()
    assert window.ask("r.renderer").startswith(renderer)
    window.tell(type="kick", node=20, velocity=[0.0, 4.0, 3.0])
    window.tell(type="step", count=1500)
    window.click("#show-posts")  # seen along x an anchor's post stands before the rope
    for view in ("home", "x", "z", "y"):
        window.click(f"#view-{view}")
        window.page.mouse.move(600, 20)
        window.settled()
        assert window.at_rope(range(2, 39)) > 0.9
    window.press("t")
    window.settled()
    assert window.at_rope(range(2, 39)) > 0.9
    # The twin: 16 pixels below the rope, which is 8 wide, there is none of it.
    assert window.at_rope(range(2, 39), down=16) < 0.1


@pytest.mark.parametrize("renderer", ["webgl", "canvas"])
def test_colours_go_with_the_tension(open_window: Open, serve: Serve, renderer: str) -> None:
    server = serve(Session(slack_rope()))
    window = open_window(f"{server.address}?renderer={renderer}", **WIDE).ready()
    window.tell(type="load", node=10, mass=3.0)
    window.tell(type="step", count=5000)  # a second
    window.settled()
    tension = np.array(window.ask("[...r.session.frame.parts[0].tension]"))[1:38]
    picture = window.picture()
    places = [window.screen(node) for node in range(1, 38)]
    warm = np.array([_warmth(picture, x, y) for x, y in places])  # from blue over red to yellow
    order = np.argsort(tension)
    # medians: the load's mark may lie over a node
    assert np.median(warm[order[-6:]]) > np.median(warm[order[:6]]) + 0.1


def _warmth(picture: np.ndarray, x: float, y: float) -> float:
    """How yellow, and how little blue, the most coloured pixel at a place is."""
    around = picture[round(y) - 2 : round(y) + 3, round(x) - 2 : round(x) + 3].reshape(-1, 3)
    red, green, blue = around[np.argmax(around.max(axis=1) - around.min(axis=1))]
    return float(red + green - 2 * blue) / max(red, green, blue, 1)


@pytest.mark.parametrize("shape", SHAPES)
def test_nothing_covers_anything(open_window: Open, serve: Serve, shape: str) -> None:
    window = open_window(serve(playing=True).address, **SHAPES[shape]).ready()
    window.tell(type="speed", value=0.5)  # more frames for the graphs, whatever the computer
    window.until("r.time > 2.2")
    _tidy(window)
    _keep(window, shape)
    window.click("#toggle-graphs")
    window.until("r.time > 3.2")
    _tidy(window)
    _keep(window, f"{shape}-graphs")
    window.click("#toggle-graphs")
    window.tell(type="compare", variants=[{"label": "rk4", "changes": {"method": "rk4"}}])
    window.until("r.session.layout.variants.length === 2")
    _tidy(window)
    window.click("#open-tour")
    _tidy(window)
    window.click("#open-tour")
    window.tell(type="compare", variants=[])
    window.tell(type="set", name="spring_constant", value=40_000.0)
    window.until("r.state === 'broken' && r.session.broken.cause")  # all that its card says
    window.settled()
    _tidy(window)
    _keep(window, f"{shape}-broken")
    window.click("#broken [data-remedy=back]")
    window.until("r.state === 'paused'")
    for opener in ("#open-scenes", "#open-help", "#open-compare"):
        if window.page.locator(opener).is_visible():
            window.click(opener)
            _inside(window, "dialog[open]")
            _keep(window, f"{shape}-{opener[6:]}")
            window.press("Escape")


COPIES = [
    {"label": "Mass 8 kg", "changes": {"mass": 8}},
    {"label": "rk4", "changes": {"method": "rk4"}},
]


# What a slow computer says, on any computer.
TOO_SLOW = """() => {
  const note = document.getElementById("slow");
  note.textContent = "0.0081 of real time: this computer is too slow for 41 nodes in steps of 1.85 ms";
  note.hidden = false;
}"""


@pytest.mark.parametrize("shape", SHAPES)
def test_the_card_of_copies_covers_no_rope(open_window: Open, serve: Serve, shape: str) -> None:
    window = open_window(serve(Session(slack_rope())).address, **SHAPES[shape]).ready()
    window.settled()
    window.page.evaluate(  # the rope to where the card will come
        """() => {
            const { camera } = ropewalk.viewport;
            camera.pan(0.12 * camera.width, (camera.height > 400 ? -0.25 : 0.25) * camera.height);
        }"""
    )
    before = window.screen(20)
    window.tell(type="compare", variants=COPIES)
    window.until("r.session.layout.variants.length === 3")
    _clear_of_the_card(window, 1)
    window.page.evaluate(TOO_SLOW)
    _apart(window)
    window.page.evaluate("() => { document.getElementById('slow').hidden = true; }")
    assert np.hypot(*np.subtract(window.screen(20), before)) > 30.0  # it had to make room
    window.page.locator("#compare-way").select_option("apart")
    _clear_of_the_card(window, 3)
    window.click("#toggle-graphs")
    _clear_of_the_card(window, 3)
    window.click("#view-fit")
    _clear_of_the_card(window, 3)


def _clear_of_the_card(window: Window, ropes: int) -> None:
    """Check that all ropes are in the scene and none is under the card of copies."""
    window.until(
        "r.viewport.starts.length === 3 && !r.viewport.lookPending && !r.app.compare.fresh"
    )
    window.settled()
    card = [one for one in _cards(window) if "difference" in one[0]]
    scene = window.page.locator("#scene").bounding_box()
    assert len(card) == (scene["height"] > 130)  # in less there is no room for it
    for rope in range(ropes):
        places = window.ask(f"[...Array(41).keys()].map((i) => r.screenOf(i, {rope}))")
        boxes = [[one["x"], one["y"], 0.0, 0.0] for one in places]
        assert not any(_under_a_card(box, card) for box in boxes), f"{boxes} under {card}"
        for x, y, *_ in boxes:
            assert scene["x"] < x < scene["x"] + scene["width"]
            assert scene["y"] < y < scene["y"] + scene["height"]


def test_on_a_lying_phone_with_graphs_no_tool_covers_the_rope(
    open_window: Open, serve: Serve
) -> None:
    window = open_window(serve(playing=True).address, **(LYING | LIGHT)).ready()
    window.until("r.time > 0.2")
    window.click("#toggle-graphs")
    window.until("r.time > 1.5")
    window.press(" ")
    window.until("r.state === 'paused'")
    window.settled()
    bars = [one for one in _cards(window) if "toolbar" in one[0]]
    assert len(bars) == 2
    places = window.ask("[...Array(41).keys()].map((i) => r.screenOf(i))")
    assert not any(_under_a_card([one["x"], one["y"], 0.0, 0.0], bars) for one in places)


def test_on_an_upright_phone_with_graphs_copies_have_one_line_each(
    open_window: Open, serve: Serve
) -> None:
    window = open_window(serve().address, **(PHONE | LIGHT)).ready()
    window.tell(type="compare", variants=COPIES)
    window.until("r.session.layout.variants.length === 3")
    window.click("#toggle-graphs")
    window.settled()
    card = window.page.locator("#difference").bounding_box()
    assert card["height"] < 0.4 * window.page.locator("#scene").bounding_box()["height"]


@pytest.mark.parametrize("shape", ["phone", "phone-lying"])
def test_nothing_lies_over_a_rope_on_the_ground(
    open_window: Open, serve: Serve, shape: str
) -> None:
    """With the panel open a phone's scene is low, and a rope that fell lies low in it."""
    held = slack_rope(ground=Ground(height=-2.0))
    straight = held.ropes[0].replace(shape=Straight(start=(0.0, 0.0, 0.0)))
    session = Session(held.replace(anchors=(), ropes=(straight,)))
    session.advance(7500)
    window = open_window(serve(session).address, **SHAPES[shape]).ready()
    assert window.node(20)[2] < -1.9
    window.click("#toggle-panel")
    for copies in ([], COPIES):
        window.tell(type="compare", variants=copies)
        rows = "document.querySelectorAll('.meter-row').length"  # each is there when it is measured
        window.until(f"{rows} === {1 + len(copies)} && r.viewport.starts.length === {rows}")
        for view in ("home", "fit", "y"):
            if not window.page.locator(f"#view-{view}").is_visible():
                window.click(".views .fold")
            window.click(f"#view-{view}")
            window.settled()
            places = window.ask("[...Array(41).keys()].map((i) => r.screenOf(i))")
            boxes = [[one["x"], one["y"], 0.0, 0.0] for one in places]
            assert [box for box in boxes if _under_a_card(box, _cards(window))] == []
            _tidy(window)


def test_labels_keep_clear_of_what_lies_over_the_scene(open_window: Open, serve: Serve) -> None:
    window = open_window(serve().address, **PHONE, **LIGHT).ready()
    boxes = _cards(window)
    seen = 0
    for right in range(-200, 201, 50):  # the anchors pass below tool bars and legend
        for down in range(-350, 351, 50):
            window.page.evaluate(
                """async ([right, down]) => {
                    const { viewport } = window.ropewalk;
                    viewport.camera.set({ target: [20, 0, 0] });
                    viewport.camera.pan(right, down);
                    viewport.draw(true);
                }""",
                [right, down],
            )
            labels = window.ask(LABELS)
            seen += len(labels)
            assert [box for box in labels if _under_a_card(box, boxes)] == []
    assert seen > 150
    # The twin: there are places in the scene that are under a card.
    assert any(_under_a_card([x, 120.0, 50.0, 20.0], boxes) for x in range(0, 390, 20))


@pytest.mark.parametrize("shape", SHAPES)
def test_the_panel_of_constants_leaves_the_rope_in_sight(
    open_window: Open, serve: Serve, shape: str
) -> None:
    window = open_window(serve().address, **SHAPES[shape]).ready()
    if window.page.locator("#panel").is_hidden():
        window.click("#toggle-panel")
    scene, panel = (window.page.locator(one).bounding_box() for one in ("#scene", "#panel"))
    beside = scene["x"] + scene["width"] <= panel["x"] + 1
    assert beside or scene["y"] + scene["height"] <= panel["y"] + 1
    window.settled()
    _tidy(window)
    assert window.at_rope(range(1, 40)) > 0.7


def test_a_rope_that_sinks_below_the_legend_is_followed(open_window: Open, serve: Serve) -> None:
    """On a lying phone the legend is a bar below the ropes; the report's falls by a third of the view."""
    lying = {"width": 844, "height": 390}
    window = open_window(serve().address, viewport=lying).ready()
    window.press(" ")
    window.until("r.time > 2")
    window.press(" ")
    window.until("r.state === 'paused'")
    window.settled()
    legend = window.page.locator(".legend").bounding_box()
    for node in range(21):
        x, y = window.screen(node)
        over = legend["x"] <= x <= legend["x"] + legend["width"]
        assert not (over and legend["y"] <= y <= legend["y"] + legend["height"])


def _cards(window: Window) -> list[tuple[str, np.ndarray]]:
    """Names and edges (left, top, right, bottom) of what lies over the scene."""
    return [(name, np.array([x, y, x + w, y + h])) for name, x, y, w, h in window.ask(BOXES)]


def _tidy(window: Window) -> None:
    """Check that cards lie in the scene, none over another, and that no bar runs over its end."""
    window.until(f"({BOXES}).length >= 1")
    _apart(window)
    _inside(window, ".scene :is(" + CARDS + ")", ".scene")
    _inside(window, ".labels span:not([hidden])", ".scene")
    window.until("!r.viewport.dirty")
    assert window.painted()
    _wait_for_clear_labels(window)
    for bar in ("bar", "meter", "graphs", "controls"):
        wide = window.ask(f"(({{scrollWidth: a, clientWidth: b}}) => a - b)({bar_of(bar)})")
        assert wide <= 0, f"{bar} is {wide} pixels too wide"


def _apart(window: Window) -> None:
    """Check that no card lies over another."""
    boxes = _cards(window)
    for (one, a), (other, b) in combinations(boxes, 2):
        apart = max(a[0], b[0]) >= min(a[2], b[2]) or max(a[1], b[1]) >= min(a[3], b[3])
        assert apart, f"{one} covers {other}: {a}, {b}"


def _wait_for_clear_labels(window: Window, seconds: float = PATIENCE) -> None:
    """Check that no label is under a card, once the page has seen that one has opened."""
    end = time.monotonic() + seconds
    while covered := [one for one in window.ask(LABELS) if _under_a_card(one, _cards(window))]:
        assert time.monotonic() < end, f"labels under cards: {covered}"
        window.page.wait_for_timeout(100)


def _under_a_card(label: list[float], cards: list[tuple[str, np.ndarray]]) -> bool:
    x, y, width, height = label
    return any(
        x < card[2] and card[0] < x + width and y < card[3] and card[1] < y + height
        for _, card in cards
    )


def bar_of(name: str) -> str:
    """The element of one part of the page."""
    return f"document.querySelector('.app > .{name}')"


def _inside(window: Window, what: str, where: str = "html") -> None:
    """Check that elements lie in another."""
    out = window.page.evaluate(
        """([what, where]) => {
            const room = document.querySelector(where).getBoundingClientRect();
            return [...document.querySelectorAll(what)].filter((e) => {
                const box = e.getBoundingClientRect();
                return e.getClientRects().length && (box.left < room.left - 1 || box.top < room.top - 1
                    || box.right > room.right + 1 || box.bottom > room.bottom + 1);
            }).map((e) => `${e.className}: ${e.innerText}`);
        }""",
        [what, where],
    )
    assert out == []


def _keep(window: Window, name: str) -> None:
    """Write a picture where that is asked for."""
    folder = os.environ.get("ROPEWALK_PICTURES")
    if not folder or name not in SHOWN:
        return
    window.page.mouse.move(2, 2)
    path = Path(folder) / f"live-{name}.png"
    window.page.screenshot(path=path)
    Image.open(path).convert("RGB").save(path, optimize=True)
    assert path.stat().st_size < 300_000


def test_a_net_is_drawn_finer_than_a_rope(open_window: Open, serve: Serve, tmp_path: Path) -> None:
    """Else it is a plate of thick ropes and of rings as wide as its meshes."""
    eyes = "r.viewport.marks.collect().markers.filter(({ kind }) => kind === 'eye').map((one) => one.pixels)"
    widths = []
    for name in ("net", "r4"):
        server = serve(Session(preset(name), name), folder=tmp_path / name)
        window = open_window(server.address).ready()
        window.settled()
        widths.append((window.ask("r.viewport.leastWidth"), max(window.ask(eyes))))
        mesh = np.hypot(*np.subtract(window.screen(1), window.screen(2)))
        if name == "net":
            assert widths[0][0] < 0.5 * mesh
    assert widths == [(5, 12), (8, 19)]
