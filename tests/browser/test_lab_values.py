"""What a visitor of the lab changes: by number and slider, back by one; it is what Python simulates."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import numpy as np
import pytest

import ropewalk as rw
from browser.test_lab import METHODS, RUN, STEPS, set_slider
from ropewalk.lessons import lesson_scene, lesson_scenes
from ropewalk.live.lab import write_lab
from ropewalk.scene.presets import preset
from ropewalk.scene.toml_text import loads

pytestmark = pytest.mark.browser

EVERYTHING = """
schema_version = 1
name = "everything that the lab has"
gravity = [0.0, 0.0, -9.81]

[run]
duration = 1.0

[[rope]]
name = "material"
segments = 12
length = 3.0
made_of = {kind = "material", EA = 900.0, mass_per_length = 0.2, axial_damping = 3.0, tension_only = true}
shape = {kind = "slack", start = [0.0, 0.3, 0.0], end = [2.2, -0.4, 0.5]}

[[rope.load]]
node = 5
mass = 0.7

[[rope.kick]]
node = 8
velocity = [1.0, -2.0, 3.0]

[[rope]]
name = "springs"
segments = 7
shape = {kind = "straight", start = [0.0, 2.0, 0.0], end = [0.0, 2.0, -1.6]}

[rope.made_of]
kind = "springs"
spring_constant = 700.0
node_mass = 0.06
spring_friction = 0.4
segment_length = 0.2
friction = "vector"

[[anchor]]
rope = "material"
node = 0

[[anchor]]
rope = "material"
node = -1
motion = {kind = "velocity", velocity = [0.6, 0.0, -0.3], start = 0.0503, stop = 0.1907}

[[anchor]]
rope = "springs"
node = 0
release_time = 0.1511
"""


def of_python(scene: rw.Scene, method: str, dt: float) -> np.ndarray:
    """Places and velocities after the steps, (2, 3, nodes)."""
    run = scene.run.replace(
        method=method, time_step=dt, steps="exact", frame_rate=1.0 / dt, duration=STEPS * dt
    )
    own = rw.Simulation(scene.replace(run=run))
    own.advance_frames(STEPS)
    return np.array([own.arrays.x, own.arrays.v])


def apart(found: np.ndarray, exact: np.ndarray) -> float:
    """The larger of the errors of places and velocities, each over its largest value."""
    return float(
        max(np.abs(a - b).max() / np.abs(b).max() for a, b in zip(found, exact, strict=True))
    )


def of_page(page: Any) -> np.ndarray:
    """Places and velocities of the rope that is seen."""
    script = "() => { const { x, v } = window.ropewalkLab.lab.rope; return [x, v].map((rows) =>"
    return np.array(page.evaluate(f"{script} rows.map((row) => [...row])); }}"))


def write(page: Any, name: str, value: float) -> None:
    """Write a number into the field of a value."""
    page.fill(f"#{name}-shown", repr(value))
    page.press(f"#{name}-shown", "Enter")


@pytest.mark.parametrize("method", METHODS)
def test_whatever_the_lab_has_is_as_in_python(
    tmp_path: Path, open_window: Any, method: str
) -> None:
    """Every lesson without posts, and two ropes with all else, to 1e-12 after a thousand steps.

    The twin: with a thousandth more gravity they are far off.
    """
    every = loads(EVERYTHING, "everything")
    scenes = [*(one for one in lesson_scenes() if not one.obstacles), every]
    page = open_window(write_lab(tmp_path / "all.html", scenes).as_uri()).page
    for index, scene in enumerate(scenes):
        largest = rw.check(scene, measure=False).stability.largest_step[method]
        dt = 0.4 * largest if scene is not every else 2.5e-4
        found = np.array(page.evaluate(RUN, [index, method, STEPS, dt]))
        assert apart(found, of_python(scene, method, dt)) <= 1e-12, scene.name
    more = every.replace(gravity=(0.0, 0.0, -9.82))
    assert apart(found, of_python(more, method, 2.5e-4)) > 1e-6


@pytest.mark.parametrize("method", METHODS)
def test_what_is_changed_is_what_python_simulates(
    tmp_path: Path, open_window: Any, method: str
) -> None:
    """k, friction, step, method, gravity by hand: after a thousand steps as the scene with them, to 1e-12."""
    page = open_window(write_lab(tmp_path / "lab.html").as_uri()).page
    page.select_option("#method", method)
    whole = page.evaluate("window.ropewalkLab.lab.values.own.m")
    assert whole == pytest.approx(preset("r4").ropes[0].total_mass)
    # twice to the last bit: what rounding leaves of another factor grows to 5e-12
    changes = ("k", 3217.0), ("c", 0.31), ("m", 2.0 * whole), ("step", 1.234), ("g", 1.62)
    for name, value in changes:
        write(page, name, value)
    page.evaluate(f"window.ropewalkLab.lab.advance({STEPS})")
    made_of = {"spring_constant": 3217.0, "spring_friction": 0.31}
    made_of["node_mass"] = 2.0 * preset("r4").ropes[0].made_of.node_mass
    scene = preset("r4").replace(
        gravity=(0.0, -1.62, 0.0),
        **{f"rope.made_of.{name}": value for name, value in made_of.items()},
    )
    exact = of_python(scene, method, 1.234e-3)
    assert apart(of_page(page), exact) <= 1e-12
    other = scene.replace(**{"rope.made_of.spring_friction": 0.3101})
    assert apart(of_python(other, method, 1.234e-3), exact) > 1e-9


def test_a_scene_without_friction_gets_some(tmp_path: Path, open_window: Any) -> None:
    scene = lesson_scene("step-by-step")
    page = open_window(write_lab(tmp_path / "lab.html", [scene]).as_uri()).page
    assert page.input_value("#c-shown") == "0"
    set_slider(page, "c", 0.0)
    assert page.input_value("#c-shown") == "0.2"  # a hundredth of the critical: 0.02 sqrt(1000 0.1)
    page.evaluate(f"window.ropewalkLab.lab.advance({STEPS})")
    rubbed = scene.replace(**{"rope.made_of.spring_friction": 0.2})
    assert apart(of_page(page), of_python(rubbed, "semi-implicit-euler", 0.005)) <= 1e-12


def test_a_rope_with_friction_keeps_it_beside_a_first_one_without(
    tmp_path: Path, open_window: Any
) -> None:
    """Along its segments or of the whole velocity; by the slider only the first gets some."""
    every = loads(EVERYTHING, "everything")
    smooth, rough = every.ropes[0].replace(**{"made_of.axial_damping": 0.0}), every.ropes[1]
    along = rough.made_of.replace(friction="axial")
    for made_of in (rough.made_of, along):
        scene = every.replace(ropes=[smooth, rough.replace(made_of=made_of)])
        page = open_window(write_lab(tmp_path / "lab.html", [scene]).as_uri()).page
        own = [0.4 * (made_of is not along), 0.4 * (made_of is along)]
        have = "[3, 12, 15].map((j) => ['vector', 'axial'].map((way) => window.ropewalkLab.lab.rope[way][j]))"
        assert page.evaluate(have) == [[0.0, 0.0], [0.0, 0.0], own]
        write(page, "c", 0.25)
        assert page.evaluate(have) == [[0.25, 0.0], [0.0, 0.0], own]


def test_a_number_is_taken_as_it_is_written(tmp_path: Path, open_window: Any) -> None:
    """Sliders are too coarse for 16401 N/m or 1.62 m/s^2; a number beyond the slider's end stays at it."""
    scene = lesson_scene("step-by-step")
    page = open_window(write_lab(tmp_path / "lab.html", [scene]).as_uri()).page
    values = "['k', 'c', 'step', 'g'].map((name) => window.ropewalkLab.lab.values.now[name])"
    write(page, "k", 16400.0)
    write(page, "step", 2.5)
    write(page, "g", 1.62)
    assert page.evaluate(values) == [16400.0, 0.0, 0.0025, 1.62]
    assert "Stable: 100 %" in page.inner_text("#verdict")
    write(page, "k", 16403.0)
    assert "Unstable: the step is just too long" in page.inner_text("#verdict")
    write(page, "k", 1e9)
    assert page.input_value("#k-shown") == "100000"
    write(page, "g", -3.0)
    assert page.input_value("#g-shown") == "0"
    page.fill("#k-shown", "")
    page.press("#k-shown", "Enter")  # no number: what was stays
    assert page.input_value("#k-shown") == "100000"


def test_undo_and_the_scenes_own_values(tmp_path: Path, open_window: Any) -> None:
    page = open_window(write_lab(tmp_path / "lab.html").as_uri()).page
    values = "(() => ({ ...window.ropewalkLab.lab.values.now }))()"
    own = page.evaluate(values)
    assert page.is_disabled("#undo")
    assert page.is_disabled("#own")
    page.focus("#k")
    page.press("#k", "ArrowRight")  # as a hand moves the slider
    first = page.evaluate(values)
    assert first["k"] == 10200.0  # three figures, as shown
    page.select_option("#method", "rk4")
    second = page.evaluate(values)
    page.click("#own")
    assert page.evaluate(values) == own
    assert page.is_disabled("#own")
    for before in (second, first, own):
        page.click("#undo")
        assert page.evaluate(values) == before
        assert page.input_value("#method") == before["method"]
        assert float(page.input_value("#k-shown")) == before["k"]
    assert page.is_disabled("#undo")
    write(page, "k", 5.0e4)
    page.select_option("#scene", "1")
    assert page.is_disabled("#undo")  # another scene


def test_the_energies_are_read_and_a_break_leaves_them(tmp_path: Path, open_window: Any) -> None:
    """The tone's energy, from the straight string's, halves in a second; the springs' pull is not in it."""
    scenes = [lesson_scene("tone"), lesson_scene("step-by-step")]
    page = open_window(write_lab(tmp_path / "lab.html", scenes).as_uri()).page
    page.evaluate("window.ropewalkLab.lab.advance(8000)")
    page.evaluate("window.ropewalkLab.lab.draw()")
    kept = page.evaluate(
        "window.ropewalkLab.lab.energy.kept.map(({ t, values }) => [t, values[3]])"
    )
    t, total = np.array(kept).T
    assert np.diff(t) == pytest.approx(np.full(200, 0.02))  # whatever the machine's pictures are
    assert total[0] == pytest.approx(40.0 * (0.1 * np.pi) ** 2 / (4.0 * 10.1), rel=0.02)
    rate = -np.polyfit(t[total > 0.0], np.log(total[total > 0.0]), 1)[0]
    assert rate == pytest.approx(2.0 * np.log(2.0) / 2.008, rel=0.03)
    box = page.locator("#energy").bounding_box()
    page.mouse.move(box["x"] + 0.5 * box["width"], box["y"] + 30)
    when = float(page.inner_text("#energy-time").split()[1])
    told = float(page.inner_text("#total-shown"))
    assert told == pytest.approx(total[np.abs(t - when).argmin()], rel=1e-3)
    page.select_option("#scene", "1")
    write(page, "k", 5000.0)
    write(page, "g", 3.0)  # before it begins: what is counted from the start, is
    first = page.evaluate(
        "window.ropewalkLab.lab.energy.kept.map(({ t, values }) => [t, ...values])"
    )
    assert np.abs(first).max() < 1e-12
    assert len(first) == 1
    page.evaluate("window.ropewalkLab.lab.advance(4000)")
    assert page.is_visible("#broken")
    page.evaluate("window.ropewalkLab.lab.draw()")
    largest = page.evaluate(
        "Math.max(...window.ropewalkLab.lab.energy.kept.flatMap(({ values }) => values))"
    )
    assert 0.1 < largest < 1e6


@pytest.mark.parametrize("method", METHODS)
def test_it_breaks_where_python_says_so(tmp_path: Path, open_window: Any, method: str) -> None:
    """Looked at every eight steps; a little below the bound both are whole."""
    scene = lesson_scene("step-by-step")
    page = open_window(write_lab(tmp_path / "lab.html", [scene]).as_uri()).page
    page.select_option("#method", method)
    limit = 8201.0 if method == "rk4" else 4100.0
    for factor in (0.97, 1.1, 1.4):
        k = factor * limit
        run = scene.run.replace(
            method=method, steps="exact", frame_rate=1.0 / (8 * 0.005), duration=4000 * 0.005
        )
        stiff = scene.replace(run=run, **{"rope.made_of.spring_constant": k})
        own = rw.Simulation(stiff)
        own.advance_frames(500)  # ends at its last good frame
        write(page, "k", k)
        page.click("#restart")
        page.evaluate("window.ropewalkLab.lab.advance(4000)")
        end = page.evaluate("window.ropewalkLab.lab.rope.time")
        broke = page.is_visible("#broken")
        assert broke is (factor > 1.0), factor
        assert end == pytest.approx(own.time + (8 * 0.005 if broke else 0.0)), factor
        if method == "rk4" and broke:
            assert "nothing gave it so much" in page.inner_text("#why")


def test_energy_that_anchors_and_hands_give_is_no_break(tmp_path: Path, open_window: Any) -> None:
    """A rope pulled along by its anchor without weight, a stiffer one while it runs: both are whole."""
    scene = preset("r4")
    page = open_window(write_lab(tmp_path / "lab.html", [scene]).as_uri()).page
    write(page, "g", 0.0)
    page.click("#restart")
    page.evaluate("window.ropewalkLab.lab.advance(2000)")
    work = page.evaluate("[...window.ropewalkLab.lab.verdict.most]")
    assert max(work) > 0.0
    write(page, "m", 3.0 * scene.ropes[0].total_mass)
    write(page, "k", 1.1e4)
    page.evaluate("window.ropewalkLab.lab.advance(500)")
    assert page.is_hidden("#broken")


def test_a_theme_that_changes_changes_the_colours(tmp_path: Path, open_window: Any) -> None:
    page = open_window(write_lab(tmp_path / "lab.html").as_uri(), color_scheme="light").page
    ramp = "[window.ropewalkLab.lab.drawing.map[0], document.getElementById('ramp').style.backgroundImage]"
    light = page.evaluate(ramp)
    page.emulate_media(color_scheme="dark")  # the page hears of it a little later
    page.wait_for_function("(was) => window.ropewalkLab.lab.drawing.map[0] !== was", arg=light[0])
    dark = page.evaluate(ramp)
    assert dark[0].replace(" ", ", ") in dark[1]


def test_an_axis_says_no_number_twice(tmp_path: Path, open_window: Any) -> None:
    """A chain that trembles by a millimetre about -2.659 m: not -2.66 above and below."""
    scene = lesson_scene("chain-at-rest")
    page = open_window(write_lab(tmp_path / "lab.html", [scene]).as_uri()).page
    told = page.evaluate(
        "() => { const { lab } = window.ropewalkLab, { strip } = lab.probe, told = [];"
        " strip.pen.fillText = (text) => told.push(text); lab.advance(4000); strip.draw();"
        " return told; }"
    )
    numbers = [text for text in told if "s" not in text]
    assert len(set(numbers)) == len(numbers) == 2


def test_a_break_by_friction_is_told_as_one(tmp_path: Path, open_window: Any) -> None:
    page = open_window(write_lab(tmp_path / "lab.html").as_uri()).page
    page.select_option("#method", "verlet")
    for name, value, friction in (("c", 5.0, True), ("k", 1e5, False)):
        write(page, name, value)
        page.evaluate("window.ropewalkLab.lab.advance(4000)")
        assert page.is_visible("#broken")
        assert ("Friction is to slow" in page.inner_text("#why")) is friction
        assert ("the springs push a node" in page.inner_text("#why")) is not friction
        page.click("#own")
        page.click("#again")


SMALL = """() => [...document.querySelectorAll('button, select, input')]
  .filter((one) => one.getClientRects().length)
  .map((one) => [one.id, (one.type === 'checkbox' ? one.closest('label') : one).getBoundingClientRect()])
  .filter(([, box]) => box.width < 44 || box.height < 44).map(([id]) => id)"""


@pytest.mark.parametrize("size", [(390, 844), (844, 390), (360, 640)])
def test_a_phone_has_the_rope_and_targets_for_fingers(
    tmp_path: Path, open_window: Any, size: tuple[int, int]
) -> None:
    """Nothing smaller than 44 px; the rope stays in sight, and a break's card does not lie on it."""
    window = open_window(
        write_lab(tmp_path / "lab.html").as_uri(),
        viewport={"width": size[0], "height": size[1]},
        has_touch=True,
        is_mobile=True,
    )
    page = window.page
    assert page.evaluate("matchMedia('(pointer: coarse)').matches")
    assert page.evaluate(SMALL) == []
    assert page.evaluate("document.documentElement.scrollWidth <= innerWidth")
    write(page, "k", 2e5)
    page.evaluate("window.ropewalkLab.lab.advance(4000)")
    assert page.is_visible("#broken")
    assert page.evaluate(SMALL) == []
    card, rope = (page.locator(name).bounding_box() for name in ("#broken", "main"))
    assert rope["height"] > 0.36 * size[1]
    assert rope["y"] >= 0
    assert card["y"] >= rope["y"] + rope["height"] or card["x"] >= rope["x"] + rope["width"]
    page.evaluate("scrollTo(0, 1e5)")
    assert page.locator("main").bounding_box()["y"] >= 0  # still in sight


def test_what_cannot_be_had_is_told_beside_its_field(tmp_path: Path, open_window: Any) -> None:
    """An empty field went back to its number, and one too large to the largest, without a word."""
    page = open_window(write_lab(tmp_path / "lab.html").as_uri()).page
    held = page.input_value("#k-shown")
    assert page.is_hidden("#typed")
    for written, said in (
        ("", f"Spring constant k needs a number; it stays {held} N/m."),
        ("1e99", "Spring constant k: 1e+99 N/m is more than the most here, "),
        ("-3", "Spring constant k: -3 N/m is less than the least here, "),
    ):
        page.fill("#k-shown", written)
        page.press("#k-shown", "Enter")
        assert page.inner_text(".value:has(#k) #typed").startswith(said)
    page.fill("#k-shown", held)
    page.press("#k-shown", "Enter")
    assert page.is_hidden("#typed")  # the twin: what can be had is not told
    page.fill("#node", "3")
    page.press("#node", "Enter")
    assert page.is_hidden("#typed")
    page.fill("#node", "")
    page.press("#node", "Enter")
    assert page.inner_text(".measure #typed") == "The node needs a number; it stays 3."
    assert page.input_value("#node") == "3"  # it was node 0 then
    page.fill("#node", "900")
    page.press("#node", "Enter")
    assert "900 is more than the most here, " in page.inner_text(".measure #typed")
    page.click("#restart")
    write(page, "g", 3.0)
    assert page.is_hidden("#typed")
