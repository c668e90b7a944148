"""The panel: every constant that it lists is changed by hand, on the server too, and goes back."""

from __future__ import annotations

import re
from collections.abc import Callable
from typing import Any

import pytest

from browser.window import Window
from live.drive import slack_rope
from ropewalk.live.parameters import PARAMETERS, named
from ropewalk.live.serve import ViewServer
from ropewalk.live.session import Session
from ropewalk.scene import Air, Ground
from ropewalk.scene.presets import preset

pytestmark = pytest.mark.browser
Open = Callable[..., Window]
Serve = Callable[..., ViewServer]
OF_TOUCH = {"obstacle_friction", "contact_friction"}  # which these scenes have not
THERE = sorted(set(PARAMETERS) - OF_TOUCH)
SIZE = {"width": 1280, "height": 900}
COMPILING = 240.0  # [s] for a method that this machine has not compiled yet


def _row(name: str) -> str:
    return f".panel [data-parameter={name}]"


UNFOLDED = """() => new Promise((done) => {
    let frames = 0;  // a fold begins to move in the second
    const look = () => {
      const moves = ++frames < 3 || document.querySelector(".panel .lil-gui.transition");
      if (moves && frames < 1200) requestAnimationFrame(look); else done();
    };
    look();
})"""


def _folder(window: Window, *names: str) -> None:
    """Open folders of the panel, or close them.

    Each when the one before has ceased to move: a press on what slides away is no click.
    """
    for name in names:
        title = window.page.locator(".panel .lil-title", has_text=re.compile(rf"^{name}$"))
        before = title.get_attribute("aria-expanded")
        title.click()
        assert title.get_attribute("aria-expanded") != before
        window.page.evaluate(UNFOLDED)


def _told(name: str) -> str:
    """The server's description of a constant, as the page has it."""
    return f"r.session.parameters.find((p) => p.name === '{name}')"


def _field(name: str) -> str:
    return f"document.querySelector('{_row(name)} input[type=text]')"


def _value(server: ViewServer, name: str) -> Any:
    found = named(name).get(server.broadcast.session.scene, 0)
    return list(found) if isinstance(found, tuple) else found


def test_every_constant_is_changed_and_goes_back(open_window: Open, serve: Serve) -> None:
    server = serve(Session(slack_rope(ground=Ground(height=-6.0), air=Air(density=1.2))))
    window = open_window(server.address, viewport=SIZE).ready()
    window.until("r.session.parameters.length > 0")
    _folder(window, "More", "Air", "NeHe's ground")
    shown = window.ask(
        "[...document.querySelectorAll('[data-parameter]')].map((e) => e.dataset.parameter)"
    )
    assert sorted(shown) == THERE
    # a rope of `ground` false has no values of the ground, so that is changed last
    for name in sorted(shown, key=lambda one: one == "ground"):
        before = _value(server, name)
        assert window.ask(f"{_told(name)}.enabled"), name
        _change(window, name, PARAMETERS[name].kind)
        window.until(
            f"JSON.stringify({_told(name)}.value) !== JSON.stringify({_told(name)}.default)",
            COMPILING,
        )
        window.until("r.app.tweak.asked.size === 0 && r.app.tweak.queue.size === 0")
        now = _value(server, name)
        assert now != before, name
        told = window.ask(f"{_told(name)}.value")
        assert told == (pytest.approx(now) if not isinstance(now, str) else now)
        window.page.locator(f"{_row(name)} button.back").click()
        window.until(
            f"JSON.stringify({_told(name)}.value) === JSON.stringify({_told(name)}.default)"
        )
        again = _value(server, name)
        assert again == (pytest.approx(before) if isinstance(before, float) else before), name
        assert window.page.locator(f"{_row(name)} button.back").is_disabled()
        assert not window.page.locator(f"{_row(name)} .fault").is_visible()


def _change(window: Window, name: str, kind: str) -> None:
    """Change a constant as a hand would."""
    row = window.page.locator(_row(name))
    if kind in ("number", "whole"):
        slider = row.locator("input[type=range]")
        slider.focus()
        # a fifth of the way to the left: nothing breaks and nothing is refused
        slider.fill(str(max(0, round(float(slider.input_value()) - 200)) or 100))
    elif kind == "vector":
        row.locator("input").nth(0).fill("1.5")
        row.locator("input").nth(0).press("Tab")
    elif kind == "choice":
        value = {"method": ["verlet"]}.get(name, ["axial", "vector"])
        index = window.ask(
            f"(({{choices, value}}) => choices.findIndex((c) => c.value !== value"
            f" && {value}.includes(c.value)))({_told(name)})"
        )
        row.locator("select").select_option(index=index)
    else:
        row.locator("input[type=checkbox]").click()


@pytest.mark.parametrize(
    ("scene", "stiffness"), [(preset("r4"), "spring_constant"), (slack_rope(), "EA")]
)
def test_first_comes_what_everybody_asks_for(
    open_window: Open, serve: Serve, scene: Any, stiffness: str
) -> None:
    window = open_window(serve(Session(scene)).address, viewport=SIZE).ready()
    window.until("r.session.parameters.length > 0")
    seen = (
        "[...document.querySelectorAll('[data-parameter]')].filter((e) => e.offsetHeight)"
        ".map((e) => e.dataset.parameter)"
    )
    assert window.ask(seen) == [stiffness, "spring_friction", "mass", "length", "gravity"]
    assert "a + 2b" not in window.page.locator("body").inner_text()
    _folder(window, "More", "Air", "NeHe's ground")
    window.until(f"{seen}.length === {len(THERE)}")
    window.tell(type="scene", preset="r3")
    window.until("r.session.layout.scene.preset === 'r3'")
    assert window.ask(f"{seen}.length") == len(THERE)  # open folders stay open
    _folder(window, "More")
    window.until(f"{seen}.length === 5")


def test_what_is_out_of_range_is_refused_with_the_range(open_window: Open, serve: Serve) -> None:
    server = serve(Session(slack_rope()))
    window = open_window(server.address, viewport=SIZE).ready()
    _folder(window, "More")
    field = window.page.locator(f"{_row('segments')} input[type=text]")
    field.fill("0")
    field.press("Enter")
    fault = window.page.locator(f"{_row('segments')} .fault")
    fault.wait_for()
    assert "must be from 1 to" in fault.inner_text()
    assert _value(server, "segments") == 40
    field.fill("50")
    field.press("Enter")
    fault.wait_for(state="hidden")
    window.until("r.session.layout.variants[0].nodes === 51")
    assert _value(server, "segments") == 50


def test_what_is_no_number_is_said_at_its_field(open_window: Open, serve: Serve) -> None:
    """It was put back without a word."""
    server = serve(Session(preset("capstan"), "capstan"))
    window = open_window(server.address, viewport=SIZE).ready()
    _folder(window, "More")
    for row in ("obstacle_friction", "mass", "segments", "gravity", "time_step"):
        field = window.page.locator(f"{_row(row)} input[type=text]").first
        fault = window.page.locator(f"{_row(row)} .fault")
        before = field.input_value()
        for typed, said in (("abc", "abc: is no number"), ("nan", "finite"), ("30 %", "0.3")):
            field.fill(typed)
            field.press("Enter")
            fault.wait_for()
            assert said in fault.inner_text()
        field.blur()
        assert field.input_value() == before
        field.fill("0.3 N")
        field.blur()
        assert "write the number alone" in fault.inner_text()
        assert field.input_value() == before
        field.fill(before)
        field.press("Enter")
        fault.wait_for(state="hidden")
    assert _value(server, "obstacle_friction") == 0.3
    window.page.locator("#pull-limit").fill("-3")
    window.page.locator("#pull-limit").press("Enter")
    window.heard("-3: must be positive")
    window.click("#tool-load")
    window.page.locator("#load-mass").fill("2 kg")
    window.page.locator("#load-mass").press("Enter")
    window.heard("2 kg: write the number alone, in kg")


@pytest.mark.parametrize("size", [SIZE, {"width": 390, "height": 844}], ids=["wide", "phone"])
def test_every_number_fits_into_its_field(open_window: Open, serve: Serve, size: Any) -> None:
    server = serve(Session(slack_rope()))
    window = open_window(server.address, viewport=size).ready()
    if window.page.locator("#panel").is_hidden():
        window.click("#toggle-panel")
    _folder(window, "More")
    step = window.page.locator(f"{_row('time_step')} input[type=text]")
    for value, shown in (
        (1.0 / 5400.0, "0.000185185"),
        (1.234567e-5, "1.23457e-5"),
        (0.000123456, "0.000123456"),
    ):
        window.tell(type="set", name="time_step", value=value)
        window.until(f"{_told('time_step')}.value === {value!r}")
        window.until(f"document.activeElement.blur() || {_field('time_step')}.value === '{shown}'")
        title = step.get_attribute("title")
        assert title is None if float(shown) == value else float(title or "") == value
    window.tell(type="set", name="gravity", value=[-1.2345678, 1.2345678e-17, -123.45678])
    window.until(f"{_field('gravity')}.value === '-1.23457'")
    fields = (
        "[...document.querySelectorAll('.panel input[type=text]')].filter((e) => e.offsetWidth)"
    )
    assert window.ask(f"{fields}.length") > 10
    # a width that is no whole number of pixels is rounded up for the one, down for the other
    assert (
        window.ask(f"{fields}.filter((e) => e.scrollWidth > e.clientWidth + 1).map((e) => e.value)")
        == []
    )
    # The twin: a longer number does not fit.
    assert window.ask(
        f"((e) => (e.value = '0.00012345678') && e.scrollWidth > e.clientWidth + 1)({_field('time_step')})"
    )


def test_a_rounded_number_is_kept_as_it_is(open_window: Open, serve: Serve) -> None:
    server = serve(Session(slack_rope()))
    window = open_window(server.address, viewport=SIZE).ready()
    window.tell(type="set", name="mass", value=8.0 / 3.0)
    window.until(f"{_field('mass')}.value === '2.66667'")
    window.page.locator(f"{_row('mass')} input[type=text]").press("Enter")
    window.tell(type="set", name="gravity", value=[0.0, -1.0 / 3.0, -9.0])
    window.until(f"{_field('gravity')}.value === '0'")
    _change(window, "gravity", "vector")
    window.until(f"{_told('gravity')}.value[0] === 1.5")
    assert _value(server, "mass") == 8.0 / 3.0
    assert _value(server, "gravity") == [1.5, -1.0 / 3.0, -9.0]


def test_one_rope_of_several_is_changed(open_window: Open, serve: Serve) -> None:
    server = serve(Session(preset("r5"), "r5"))
    window = open_window(server.address, viewport=SIZE).ready()
    names = window.ask("r.session.layout.variants[0].ropes.map((rope) => rope.name)")
    friction = window.page.locator(f"{_row('spring_friction')} input[type=text]")
    assert friction.get_attribute("placeholder") == "differ"
    window.page.locator(".panel select").first.select_option(label=names[2])
    window.until(
        f"document.querySelector(\"{_row('spring_friction')} input[type=text]\").value !== ''"
    )
    friction.fill("0.7")
    friction.press("Enter")
    window.until(f"{_told('spring_friction')}.values['{names[2]}'] === 0.7")
    found = [rope.segment_friction for rope in server.broadcast.session.scene.ropes]
    assert found == [0.01, 0.05, 0.7, 1.0]


def test_a_switch_on_which_ropes_differ_is_neither_on_nor_off(
    open_window: Open, serve: Serve
) -> None:
    """Without a value for it the panel was left half made, and the page told of an error."""
    scene = preset("r5")
    slack = scene.ropes[1]
    made_of = slack.made_of.replace(tension_only=True)
    ropes = [rope if rope is not slack else rope.replace(made_of=made_of) for rope in scene.ropes]
    server = serve(Session(scene.replace(ropes=ropes)))
    window = open_window(server.address, viewport=SIZE).ready()
    _folder(window, "More", "Rope")
    switch = f"document.querySelector('{_row('tension_only')} input[type=checkbox]')"
    window.until(f"{switch}.indeterminate")
    names = window.ask("r.session.layout.variants[0].ropes.map((rope) => rope.name)")
    for name, on in ((names[1], True), (names[0], False)):
        window.page.locator(".panel select").first.select_option(label=name)
        window.until(f"!{switch}.indeterminate && {switch}.checked === {str(on).lower()}")


def test_a_change_makes_no_jump_while_it_runs(open_window: Open, serve: Serve) -> None:
    window = open_window(serve(Session(slack_rope()), playing=True).address, viewport=SIZE).ready()
    window.until("r.time > 0.5")
    _folder(window, "More")
    window.page.evaluate(
        """() => {
            const r = window.ropewalk;
            const fastest = r.session.layout.scalars.indexOf("speed_high");
            let [last, time] = [null, 0];
            r.way = r.jump = 0;
            r.session.on("frame", (frame) => {
                const now = r.nodeAt(20);
                const speed = frame.parts[0].scalars[fastest]; // the greatest since the last frame
                const way = last ? Math.hypot(...now.map((v, i) => v - last[i])) : 0;
                if (last) r.jump = Math.max(r.jump, way - speed * (frame.time - time));
                r.way += way;
                [last, time] = [now, frame.time];
            });
        }"""
    )
    for name in ("mass", "spring_friction", "spring_constant", "spring_constant"):
        _change(window, name, "number")
        time = window.ask("r.time")
        window.until(f"r.time > {time} + 0.2")
    assert window.ask("r.way") > 1e-2  # it moves: by how much depends on when the changes come
    assert window.ask("r.jump") < 1e-3  # no way but what its speed makes, however few frames came


def test_up_follows_gravity(open_window: Open, serve: Serve) -> None:
    window = open_window(serve().address).ready()
    window.settled()
    assert window.ask("r.viewport.camera.up") == pytest.approx([0.0, 1.0, 0.0])
    for gravity, up in (
        ([9.81, 0.0, 0.0], [-1.0, 0.0, 0.0]),
        ([0.0, 0.0, 0.0], [-1.0, 0.0, 0.0]),  # without any it stays
        ([0.0, 0.0, -9.81], [0.0, 0.0, 1.0]),
    ):
        window.tell(type="set", name="gravity", value=gravity)
        window.tell(type="step")
        value = "r.session.parameters.find((p) => p.name === 'gravity').value"
        window.until(f"{value}.every((one, k) => one === {gravity}[k])")
        window.settled()
        assert window.ask("r.viewport.camera.up") == pytest.approx(up)
        foot = window.ask("r.viewport.camera.project(20, 0, 0)")
        head = window.ask(f"r.viewport.camera.project(20 + {up[0]}, {up[1]}, {up[2]})")
        assert head[1] < foot[1] - 3  # up points up on the screen
        if up[0] == 0.0:  # along gravity all nodes are in one line with the view's up
            assert window.at_rope(range(1, 40)) > 0.9


def test_what_would_not_be_felt_cannot_be_changed(open_window: Open, serve: Serve) -> None:
    """Wind waits for a drag, and says so; it can be changed as soon as there is one."""
    server = serve(Session(slack_rope()))
    window = open_window(server.address, viewport=SIZE).ready()
    _folder(window, "More")
    _folder(window, "Air")
    wind = window.page.locator(f"{_row('wind')} input[type=text]").first
    assert wind.is_disabled()
    assert "drag" in (window.page.locator(_row("wind")).get_attribute("title") or "")
    drag = window.page.locator(f"{_row('air_drag')} input[type=text]")
    drag.fill("0.1")
    drag.press("Enter")
    window.until("r.session.parameters.find((p) => p.name === 'wind').enabled")
    assert wind.is_enabled()
