"""The lab's page: its kernel is the Python one, its bound is the theory's, and a visitor can break it."""

from __future__ import annotations

import time
from pathlib import Path
from typing import Any

import numpy as np
import pytest

import ropewalk as rw
from patience import PATIENCE
from ropewalk.lessons import lesson_scenes
from ropewalk.live.lab import METHODS, PRESETS, lab_scene, write_lab
from ropewalk.scene import Anchor
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
@pytest.mark.parametrize("method", METHODS)
def test_an_anchor_that_lets_go_inside_a_step(
    tmp_path: Path, open_window: Any, method: str
) -> None:
    """As in Python, to 1e-12; the twin lets go at the step's end."""
    dt, steps = 0.001, 200
    ends = [Anchor(node=0), Anchor(node=-1, release_time=0.0504)]
    scene = preset("r4").replace(anchors=ends)
    run = scene.run.replace(
        method=method, time_step=dt, steps="exact", frame_rate=1.0 / dt, duration=steps * dt
    )
    page = open_window(write_lab(tmp_path / "let-go.html", [scene]).as_uri()).page
    found = np.array(page.evaluate(RUN, [0, method, steps, dt]))
    for moment, same in ((0.0504, True), (0.0524, False)):
        anchors = [ends[0], ends[1].replace(release_time=moment)]
        own = rw.Simulation(scene.replace(run=run, anchors=anchors))
        own.advance_frames(steps)
        error = np.abs(found - np.array([own.arrays.x, own.arrays.v])).max()
        assert bool(error < 1e-11) is same, (moment, error)


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
    end = time.monotonic() + PATIENCE
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
    # Slow motion: the scene's own anchor, which makes the rope slack, hardly moves meanwhile.
    page.select_option("#pace", value=page.locator("#pace option").last.get_attribute("value"))
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
    assert page.inner_text("#play") == "Pause"  # else nothing would follow the hand
    page.evaluate("window.ropewalkLab.lab.play(false)")
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


def place_of(page: Any, node: int) -> tuple[float, float]:
    """Where a node is in the window [px]."""
    box = page.locator("#rope").bounding_box()
    x, y = page.evaluate(
        "(node) => { const { rope, drawing } = window.ropewalkLab.lab;"
        " const place = [drawing.across, drawing.up].map((way) =>"
        "   way.reduce((sum, part, k) => sum + part * rope.x[k][node], 0));"
        " const [left, top] = drawing.place(0, 0), [right, bottom] = drawing.place(drawing.canvas.width,"
        "   drawing.canvas.height);"
        " return [(place[0] - left) / (right - left), (place[1] - top) / (bottom - top)]; }",
        node,
    )
    return box["x"] + x * box["width"], box["y"] + y * box["height"]


@pytest.fixture
def lessons(tmp_path: Path, open_window: Any) -> Any:
    path = write_lab(tmp_path / "lessons.html", lesson_scenes())
    return open_window(f"{path.as_uri()}#far-swing", viewport={"width": 1280, "height": 800}).page


@pytest.mark.browser
def test_the_address_chooses_a_scene(lessons: Any) -> None:
    shown = "document.getElementById('scene').selectedOptions[0].text"
    assert lessons.evaluate(shown) == "2b far swing"
    lessons.evaluate("() => { location.hash = '#4 chain at rest'; }")
    until(lessons, "lab.scene.name === '4 chain at rest'")
    assert lessons.evaluate(shown) == "4 chain at rest"


@pytest.mark.browser
def test_a_rope_that_nothing_pulls_yet_says_zero(lab: Any) -> None:
    page = lab.page
    page.select_option("#scene", index=PRESETS.index("r3"))
    assert page.evaluate("window.ropewalkLab.lab.rope.time") == 0.0
    assert page.inner_text("#hottest") == "0 N"
    page.click("#play")
    until(page, "lab.rope.time > 0.1")
    assert page.inner_text("#hottest") != "0 N"


@pytest.mark.browser
def test_a_click_measures_and_does_not_pull(lessons: Any) -> None:
    lessons.select_option("#scene", label="4 chain at rest")
    before = lessons.evaluate("window.ropewalkLab.lab.rope.x.map((row) => [...row])")
    lessons.mouse.click(*place_of(lessons, 8))
    assert lessons.input_value("#node") == "8"
    assert lessons.evaluate("window.ropewalkLab.lab.rope.x.map((row) => [...row])") == before
    height = float(lessons.inner_text("#reading").split()[0])
    assert height == pytest.approx(before[2][8], abs=1e-3)
    lessons.fill("#node", "900")
    lessons.press("#node", "Enter")
    assert lessons.input_value("#node") == "40"  # there are no more


@pytest.mark.browser
def test_what_is_measured_first_moves(lab: Any) -> None:
    """No anchor; and the value of one that stands is told once, not as 1e-9 above and below."""
    for name in PRESETS:
        lab.page.select_option("#scene", index=PRESETS.index(name))
        held = lab.page.evaluate("window.ropewalkLab.lab.rope.anchors.map(({ node }) => node)")
        assert int(lab.page.input_value("#node")) not in held, name
    lab.page.fill("#node", "20")
    lab.page.press("#node", "Enter")
    told = lab.page.evaluate(
        "() => { const { lab } = window.ropewalkLab, { strip } = lab.probe, told = [];"
        " strip.pen.fillText = (text) => told.push(text); lab.advance(100); lab.note(); strip.draw();"
        " return told; }"
    )
    assert [text for text in told if "s" not in text] == ["0"]


@pytest.mark.browser
def test_keys_choose_a_node_pull_it_and_let_go(lessons: Any) -> None:
    hand, node = "window.ropewalkLab.lab.rope.hand", "#node"
    lessons.select_option("#scene", label="4 chain at rest")
    lessons.focus("#rope")
    lessons.keyboard.press("ArrowRight")
    assert lessons.input_value(node) == "21"
    assert lessons.is_visible("#keys")
    for _ in range(3):
        lessons.keyboard.press("Shift+ArrowUp")
    assert lessons.evaluate(f"{hand}.node") == 21
    assert lessons.inner_text("#play") == "Pause"
    before = lessons.evaluate("window.ropewalkLab.lab.base.x[2][21]")
    until(lessons, f"lab.rope.x[2][21] > {before} + 0.6")  # 3 times 3 % of the drawing's 8 m
    lessons.keyboard.press("Enter")
    assert lessons.evaluate(hand) is None
    lessons.keyboard.press("Space")
    assert lessons.inner_text("#play") == "Play"


@pytest.mark.browser
def test_runge_kutta_thrashes_before_it_flies_apart(lessons: Any) -> None:
    """As the first lesson says: energy out of nothing a tenth above its limit, torn apart far above."""
    lessons.select_option("#scene", label="1 step by step")
    lessons.select_option("#method", "rk4")
    for factor, gains, breaks in ((0.97, False, False), (1.1, True, True), (1.4, True, True)):
        lessons.fill("#k-shown", f"{factor * 8201.0:.1f}")
        lessons.press("#k-shown", "Enter")
        lessons.click("#restart")
        lessons.evaluate("window.ropewalkLab.lab.advance(2000)")
        kept = "window.ropewalkLab.lab.energy.kept.map(({ values }) => values[3])"
        assert (max(lessons.evaluate(kept)) > 1.0) is gains, factor
        assert lessons.is_visible("#broken") is breaks, factor


@pytest.mark.browser
def test_the_graph_measures_the_period_of_a_far_swing(lessons: Any) -> None:
    """Two crests, 2.153 s apart, as the pointer reads them; a small swing's 2.006 s would fail."""
    lessons.select_option("#quantity", "sideways")
    lessons.fill("#node", "1")
    lessons.press("#node", "Enter")
    for _ in range(240):  # as pictures do, of 20 ms each
        lessons.evaluate(
            "() => { const { lab } = window.ropewalkLab; lab.advance(10); lab.note(); }"
        )
    lessons.evaluate("window.ropewalkLab.lab.draw()")
    box = lessons.locator("#graph").bounding_box()
    read = {}
    for share in range(16, 100):  # of the graph's width
        lessons.mouse.move(box["x"] + share / 100 * box["width"], box["y"] + 40)
        value, _, _, when, _ = lessons.inner_text("#reading").split()
        read[float(when)] = float(value)
    table = lessons.evaluate("window.ropewalkLab.lab.probe.table()").splitlines()
    assert table[0] == "time [s],sideways of node 1 [m]"
    kept = {round(float(t), 3): float(x) for t, x in (row.split(",") for row in table[1:])}
    assert len(kept) == 241  # t = 0 among them
    assert read.items() <= {t: float(f"{x:.5g}") for t, x in kept.items()}.items()
    crests = [
        max((t for t in kept if a < t < b), key=kept.__getitem__) for a, b in ((1, 3), (3, 5))
    ]
    assert crests[1] - crests[0] == pytest.approx(2.153, abs=0.021)
    with lessons.expect_download() as saved:
        lessons.click("#save")
    assert Path(saved.value.path()).read_text().splitlines() == table


@pytest.mark.browser
def test_heights_can_be_drawn_higher(lessons: Any) -> None:
    lessons.select_option("#scene", label="3a pulse")
    lessons.evaluate("window.ropewalkLab.lab.draw()")
    top, ground = (place_of(lessons, node)[1] for node in (20, 60))
    lessons.select_option("#tall", "20")
    high = place_of(lessons, 20)[1], place_of(lessons, 60)[1]
    assert high[1] - high[0] == pytest.approx(20.0 * (ground - top), rel=1e-6)
    lessons.mouse.click(*place_of(lessons, 20))
    assert lessons.input_value("#node") == "20"


@pytest.mark.browser
def test_the_largest_tension_misses_no_step(lessons: Any) -> None:
    """It is that of every step, compared with a walk step by step of a rope of its own."""
    lessons.select_option("#scene", label="1 step by step")
    lessons.evaluate("window.ropewalkLab.lab.advance(403)")
    own = lessons.evaluate(
        "() => { const { lab, Rope } = window.ropewalkLab; const rope = new Rope(lab.scene); let top = 0;"
        " for (let i = 0; i < 403; i++) { rope.step(lab.method, lab.step);"
        "  for (let j = 0; j < rope.n - 1; j++) { const r = Math.hypot(...[0, 1, 2].map("
        "   (k) => rope.x[k][j + 1] - rope.x[k][j]));"
        "   top = Math.max(top, rope.stiffness[j] * (r - rope.length[j])); } } return top; }"
    )
    assert lessons.evaluate("window.ropewalkLab.lab.largest") == pytest.approx(own, rel=1e-9)


PITCH = """([index, seconds, rate]) => {
  const { scenes, Rope, Resampler, bridge, tensions } = window.ropewalkLab;
  const scene = scenes[index], rope = new Rope(scene), tension = new Float64Array(rope.n);
  const [sampler, samples] = [new Resampler(rate), []];
  for (let i = 0; i * scene.step < seconds; i++) {
    rope.step("semi-implicit-euler", scene.step);
    tensions(rope, tension);
    sampler.add(bridge(rope, tension, scene.up), scene.step, samples);
  }
  return samples;
}"""


@pytest.mark.browser
def test_a_string_sounds_at_its_pitch(lessons: Any) -> None:
    """The greatest line of what is played is the string's sqrt(T/mu)/(2 L), and its overtones die first."""
    rate, seconds = 48000, 0.5
    index = lessons.evaluate(
        "window.ropewalkLab.scenes.findIndex((scene) => scene.name === '5c guitar string')"
    )
    samples = np.array(lessons.evaluate(PITCH, [index, seconds, rate]))
    assert len(samples) == pytest.approx(rate * seconds, abs=2)
    first, last = samples[: len(samples) // 4], samples[-(len(samples) // 4) :]

    def lines(part: np.ndarray) -> np.ndarray:
        shape = np.abs(np.fft.rfft(part * np.hanning(len(part)), 8 * len(part)))
        step = rate / (8 * len(part))
        return np.array([shape[int(f * 0.9 / step) : int(f * 1.1 / step)].max() for f in pitches])

    pitches = 201.7 * np.arange(1, 5)
    whole = np.abs(np.fft.rfft(samples * np.hanning(len(samples)), 8 * len(samples)))
    assert whole.argmax() * rate / (8 * len(samples)) == pytest.approx(201.7, rel=0.01)
    brightness = [lines(part)[3] / lines(part)[0] for part in (first, last)]
    assert brightness[1] < 0.5 * brightness[0]


@pytest.mark.browser
def test_the_sound_is_off_until_it_is_wanted(lessons: Any) -> None:
    lessons.select_option("#scene", label="5c guitar string")
    assert not lessons.is_checked("#sound")
    lessons.click("#play")
    until(lessons, "lab.rope.time > 0.05")
    assert lessons.evaluate("window.ropewalkLab.lab.sound.next") == 0
    lessons.check("#sound")
    until(lessons, "lab.sound.next > 0.1 && lab.sound.loudest > 0")
    lessons.uncheck("#sound")
    assert not lessons.evaluate("window.ropewalkLab.lab.sound.on")
