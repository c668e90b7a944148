"""What the page teaches: meter, break and remedies, comparison, scenes, tour."""

from __future__ import annotations

import re
import threading
from collections.abc import Callable
from typing import Any

import numpy as np
import pytest

from browser.window import Window
from live.drive import slack_rope
from patience import PATIENCE
from ropewalk.live import breaks
from ropewalk.live.serve import ViewServer
from ropewalk.live.session import Session
from ropewalk.scene.presets import names as preset_names
from ropewalk.scene.presets import preset

pytestmark = pytest.mark.browser
Open = Callable[..., Window]
Serve = Callable[..., ViewServer]
SIZE = {"width": 1280, "height": 800}
COMPILING = 240.0  # [s] for a method that this machine has not compiled yet
# A slow server tells of a break first, then of its reason.
EXPLAINED = "r.state === 'broken' && r.session.broken.cause"
CONSTANT = ".panel [data-parameter=spring_constant] input[type=text]"


@pytest.fixture
def window(open_window: Open, serve: Serve) -> Window:
    """A page of the report's main scene."""
    return open_window(serve().address, viewport=SIZE).ready()


def _stiffen(window: Window, value: float) -> None:
    window.page.locator(CONSTANT).fill(str(value))
    window.page.locator(CONSTANT).press("Enter")
    window.page.locator(CONSTANT).evaluate("(field) => field.blur()")


def _break(window: Window) -> None:
    """Push the spring constant up until the running rope breaks."""
    window.press(" ")
    window.until("r.time > 0.5")
    _stiffen(window, 40_000.0)
    window.until("r.state === 'broken'")
    window.page.locator("#broken", has_text="above the largest").wait_for()


# The places shown with each word about the steps past a break, which go by in a second.
KEEP_PAST = """() => {
  window.past = {};
  const words = document.getElementById("past");
  new MutationObserver(() => {
    window.past[words.textContent] = [...window.ropewalk.viewport.nodes.to.subarray(0, 164)];
  }).observe(words, { childList: true });
}"""


def test_the_break_can_be_watched(window: Window) -> None:
    _break(window)
    button = window.page.locator("#see-break")
    button.wait_for()
    [*_, last] = window.ask("r.session.broken.past")
    window.page.evaluate(KEEP_PAST)
    button.click()
    places = "[...r.viewport.nodes.to.subarray(0, 164)]"
    seen = window.until(f"window.past['{last['time']:.5f} s: past the last good state']")
    shown = np.array(seen).reshape(41, 4)[:, :3]
    assert np.abs(shown - np.array(last["positions"])).max() < 1e-3
    window.until("document.querySelector('#past').textContent === ''")
    frozen = np.array(window.ask("[...r.session.frame.parts[0].positions]")).reshape(41, 3)
    shown = np.array(window.ask(places)).reshape(41, 4)[:, :3]
    assert np.abs(shown - frozen).max() < 1e-6
    assert np.abs(frozen - np.array(last["positions"])).max() > 0.01  # the twin


def test_the_meter_goes_from_green_over_amber_to_red(window: Window) -> None:
    largest = window.until("r.session.stability[0]?.largest_spring_constant")
    colours = []
    for factor, zone in ((0.5, "green"), (0.9, "amber"), (1.5, "red")):
        _stiffen(window, factor * largest)
        window.until(f"document.querySelector('.meter-row').dataset.zone === '{zone}'")
        one, text, width = window.ask(  # at once: it may still tell of the value before
            "[r.session.stability[0], document.querySelector('.meter').innerText,"
            " document.querySelector('.meter .fill').style.width]"
        )
        assert one["stable"] == (factor < 1.0)
        # a + 2b is the square of step over bound, but for friction
        assert f"{float(format(100.0 * one['ratio'], '.3g')):g} % of the bound" in text
        assert float(width[:-1]) == pytest.approx(100 * min(1, one["ratio"] / 1.25), abs=0.1)
        colours.append(
            window.ask("getComputedStyle(document.querySelector('.meter .fill')).backgroundColor")
        )
    assert len(set(colours)) == 3


def test_a_break_stays_while_the_slider_is_dragged_on(window: Window) -> None:
    _break(window)
    card = window.page.locator("#broken")
    slider = window.page.locator(".panel [data-parameter=spring_constant] input[type=range]")
    for _ in range(3):  # dragged on, in small steps
        slider.evaluate(
            "(e) => { e.value = Number(e.value) + 8; e.dispatchEvent(new Event('input')); }"
        )
        window.until("r.app.tweak.asked.size === 0 && r.app.tweak.queue.size === 0")
        assert card.is_visible()
        assert window.ask("r.state") == "broken"
    slider.evaluate("(e) => e.dispatchEvent(new Event('change'))")
    on = card.get_by_role("button", name="Go on with these values")
    on.wait_for()
    assert "Each step was too long for so stiff" in card.inner_text()
    _stiffen(window, 10_000.0)
    window.until("document.querySelector('#broken .main').dataset.remedy === 'on'")
    time = window.ask("r.time")
    on.click()
    card.wait_for(state="hidden")
    window.until(f"r.state === 'playing' && r.time > {time} + 0.3")


def test_the_reason_of_a_break_closes_nothing_and_loses_no_press(
    open_window: Open, serve: Serve, monkeypatch: pytest.MonkeyPatch
) -> None:
    """The card was made anew with it."""
    gate, answer = threading.Event(), breaks.Question.answer

    def slowly(self: breaks.Question) -> dict[str, Any]:
        gate.wait(PATIENCE)
        return answer(self)

    monkeypatch.setattr(breaks.Question, "answer", slowly)
    window = open_window(serve().address, viewport=SIZE).ready()
    window.press(" ")
    window.until("r.time > 0.5")
    _stiffen(window, 40_000.0)
    window.until("r.state === 'broken'")
    window.click("#broken summary")
    button, mouse = window.page.locator("#broken [data-remedy=step]"), window.page.mouse
    button.hover()
    mouse.down()
    gate.set()
    window.until(EXPLAINED)
    card = window.page.locator("#broken")
    card.locator("#see-break").wait_for()
    assert "above the largest stable one" in card.inner_text()
    assert card.locator("details").evaluate("(part) => part.open")
    button.hover()  # more words may have moved it
    mouse.up()
    window.until("r.state === 'playing'")


def test_a_break_freezes_says_why_and_goes_back(window: Window) -> None:
    _break(window)
    words = window.page.locator("#broken").inner_text()
    assert "Each step was too long for so stiff" in words
    assert "zigzag" not in words  # the theory is a click away
    window.click("#broken summary")
    words = window.page.locator("#broken").inner_text()
    assert "Broke after t = " in words
    assert "a + 2b = " in words
    assert "zigzag" in words
    assert "above the largest stable one" in words
    assert window.page.locator("#play").is_disabled()
    window.settled()
    assert all(np.isfinite(window.node(node)).all() for node in range(41))
    window.page.get_by_role("button", name="Back to before").click()
    window.until("r.state === 'paused'")
    window.page.locator("#broken").wait_for(state="hidden")
    window.until(f"document.querySelector('{CONSTANT}').value === '10000'")


@pytest.mark.parametrize(
    ("width", "height", "graphs"),
    [(1280, 800, True), (900, 640, True), (844, 390, False), (390, 844, False), (1280, 800, False)],
)
def test_the_card_of_a_break_leaves_the_rope_in_sight(
    open_window: Open, serve: Serve, width: int, height: int, graphs: bool
) -> None:
    """Where there is little room its words are behind a click; with room they are there at once."""
    served = serve(Session(preset("r6"), "r6"))
    window = open_window(served.address, viewport={"width": width, "height": height}).ready()
    window.press(*("g" if graphs else ""), " ")
    window.until(EXPLAINED)
    window.settled()
    card = window.page.locator("#broken")
    box = card.bounding_box()
    for node in range(21):
        x, y = window.screen(node)
        over = box["x"] <= x <= box["x"] + box["width"]
        assert not (over and box["y"] <= y <= box["y"] + box["height"])
    roomy = height == 800 and not graphs
    assert card.locator("p.why").is_visible() == roomy
    assert all(button.is_visible() for button in card.locator("button").all())
    window.click("#broken summary")
    assert card.locator("p.why").is_visible()
    assert "a + 2b = " in card.inner_text()


def test_the_suggested_step_and_the_implicit_method_mend_it(window: Window) -> None:
    _break(window)
    broken = window.ask("r.session.status.dt")
    window.click("#broken [data-remedy=step]")
    window.until(f"r.state === 'playing' && r.session.status.dt < {broken}")
    window.until("r.session.stability[0].stable")
    time = window.ask("r.time")
    window.until(f"r.time > {time} + 1")
    assert window.ask("r.session.parameters.find((p) => p.name === 'spring_constant').value") == 4e4
    _stiffen(window, 4_000_000.0)
    window.until(EXPLAINED)
    window.click("#broken [data-remedy=implicit]")
    window.until("r.state === 'playing'", COMPILING)
    window.until("r.session.stability[0].bound === null", COMPILING)
    assert window.page.locator(".meter-ratio").inner_text() == "no bound"
    assert (
        window.page.locator(".meter-bar > *").count() == 0
    )  # no red zone where nothing is unstable
    assert "has no largest step here" in window.page.locator(".meter").inner_text()
    time = window.ask("r.time")
    window.until(f"r.time > {time} + 0.3", COMPILING)
    assert window.ask("r.state") == "playing"


def test_two_copies_follow_one_hand_and_their_difference_is_shown(
    open_window: Open, serve: Serve
) -> None:
    window = open_window(serve(Session(slack_rope())).address, viewport=SIZE).ready()
    window.click("#open-compare")
    rows = window.page.locator(".compare-rows select")
    rows.first.select_option("mass")
    window.page.locator(".compare-rows input").fill("8")
    window.click("#compare-start")
    window.until("r.session.layout.variants.length === 2")
    window.page.locator("#difference").wait_for()
    window.settled()
    window.click("#play")
    window.tell(type="drag", anchor="right", target=[6.0, 0.0, 2.0])
    for variant in (0, 1):  # both come to the hand
        window.until(
            f"Math.hypot(r.nodeAt(40, {variant})[0] - 6, r.nodeAt(40, {variant})[2] - 2) < 0.1"
        )
    window.until("/differs by [1-9]/.test(document.getElementById('difference').innerText)")
    window.press(" ")
    window.until("r.state === 'paused'")
    window.settled()
    ropes = [np.array([window.node(i, v) for i in range(41)]) for v in (0, 1)]
    rms = np.sqrt(((ropes[0] - ropes[1]) ** 2).sum(axis=1).mean())
    told = window.ask(
        "r.session.frame.parts[1].scalars[r.session.layout.scalars.indexOf('difference')]"
    )
    assert told == pytest.approx(rms, rel=1e-4)
    window.page.locator("#compare-way").select_option("apart")
    window.settled()
    first, second = (window.ask(f"r.screenOf(20, {v}).x") for v in (0, 1))
    assert abs(first - second) > 100
    window.page.locator("#difference").get_by_role("button", name="End").click()
    window.until("r.session.layout.variants.length === 1")
    window.page.locator("#difference").wait_for(state="hidden")


def test_the_menu_of_scenes_shows_and_opens_them(window: Window) -> None:
    window.click("#open-scenes")
    cards = window.page.locator(".scene-card")
    names = [name for name in window.ask("r.session.presets.map((p) => p.name)") if name != "start"]
    assert sorted(names) == sorted(preset_names())
    themes = window.page.locator(".scene-themes h3").all_inner_texts()
    assert themes[0] == "Look and play"
    assert "report" in themes[-1]
    titles = cards.locator("strong").all_inner_texts()
    assert "Three anchors (R4)" in titles
    assert [bool(re.search(r" [(]R\d[)]$", one)) for one in titles[-9:]] == [True] * 9
    for i in range(cards.count()):
        assert len(cards.nth(i).locator("span").inner_text()) > 20
    pictures = window.ask(
        "[...document.querySelectorAll('.picture')].map((e) => e.style.maskImage)"
    )
    for picture in pictures:
        address = picture.removeprefix('url("').removesuffix('")')
        answer = window.page.request.get(address)
        assert answer.ok
        assert "<svg" in answer.text()
    window.click(".scene-card[data-preset=r3]")
    window.until("r.session.layout.scene.preset === 'r3' && r.state === 'paused'")  # as it was
    window.press(" ")
    window.until("r.time > 0.2 && location.hash === '#scene=r3'")
    assert window.page.locator(".scene-name").inner_text().startswith("R3")


def test_the_tour_to_its_end(window: Window) -> None:
    window.click("#open-tour")

    def done(step: int) -> None:
        window.until(f"document.querySelector('#tour small').innerText === 'Step {step} of 5'")
        window.until("document.getElementById('tour').classList.contains('done')", COMPILING)
        window.click("#tour-next")

    window.click("#tour-act")
    done(1)
    window.page.keyboard.down("ArrowUp")
    window.until("document.getElementById('tour').classList.contains('done')")
    window.page.keyboard.up("ArrowUp")
    done(2)
    while window.ask("r.state") != "broken":
        window.click("#tour-act")
        time = window.ask("r.time")
        window.until(f"r.state === 'broken' || r.time > {time} + 0.5")
    done(3)
    window.click("#tour-act")
    done(4)
    window.click("#tour-act")
    done(5)
    window.page.locator("#tour").wait_for(state="hidden")
    assert window.ask("r.session.stability[0].bound") is None
    window.until("r.state === 'playing'")  # not before there is a frame of the new method


def test_the_words_about_a_break_hide_no_rope(
    open_window: Callable[..., Window], serve: Callable[..., ViewServer]
) -> None:
    """On a phone with graphs open the card is half of the scene: the ropes move above it."""
    phone = {"viewport": {"width": 390, "height": 844}, "has_touch": True, "is_mobile": True}
    server = serve(Session(preset("r4"), "r4"), playing=True)
    window = open_window(server.address, **phone).ready()
    window.press("g")
    window.until("r.time > 0.3")
    window.tell(type="set", name="time_step", value=0.004)
    window.until(EXPLAINED)
    window.settled()
    card = window.page.locator("#broken").bounding_box()
    scene = window.page.locator("#scene").bounding_box()
    places = window.ask("[...Array(41).keys()].map((i) => r.screenOf(i))")
    said = window.page.locator("#broken .short")
    assert said.is_visible()  # also where there is no room for all of the words
    assert said.inner_text() == "Each step was too long for so stiff and light a rope."
    assert card["y"] - scene["y"] > 100.0
    for place in places:
        assert scene["y"] < place["y"] < card["y"] or place["y"] > card["y"] + card["height"]


def test_an_arrow_that_a_resize_of_a_broken_run_leaves_outside_is_fetched_back(
    window: Window,
) -> None:
    _break(window)
    window.settled()
    rightmost = (
        "Math.max(...r.viewport.marks.labels.filter(({ kind }) => kind === 'reaction')"
        ".map(({ at }) => r.viewport.camera.project(...at)[0])) - r.viewport.camera.width"
    )
    window.page.evaluate(
        f"""() => {{
            const r = window.ropewalk;
            const {{ camera }} = r.viewport;
            r.viewport.card = () => null; // the words about a break can bring a rope back, too
            const metres = camera.pose.distance / camera.focal;
            const away = metres * ({rightmost} - 20);
            const target = camera.pose.target.map((x, k) => x + away * camera.right[k]);
            r.viewport.setPose({{ ...camera.pose, target }});
        }}"""
    )
    window.settled()
    assert window.ask(rightmost) > 0.0
    window.ask("(r.app.resize(), true)")
    window.settled()
    assert window.ask(rightmost) < 0.0
