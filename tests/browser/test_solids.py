"""Bodies that ropes touch, in the live page and in a shared one: seen, turning, before and behind ropes."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path
from typing import Any

import numpy as np
import pytest

import ropewalk as rw
from browser.window import Window
from ropewalk.live.serve import ViewServer
from ropewalk.live.session import Session
from ropewalk.live.share import share_result
from ropewalk.scene import Scene, loads
from ropewalk.scene.presets import preset

pytestmark = pytest.mark.browser
Open = Callable[..., Window]
Serve = Callable[..., ViewServer]
WIDE: dict[str, Any] = {"viewport": {"width": 1000, "height": 700}}


def over_a_drum(spin: str = "") -> Scene:
    """A rope that hangs over a drum whose face looks along y; its far half hangs behind nothing."""
    return loads(f"""
name = "Over a drum"
[run]
duration = 0.2
time_step = 0.01
method = "implicit-euler"
[[rope]]
segments = 24
length = 1.2
diameter = 0.02
made_of = {{ kind = "material", EA = 1e4, mass_per_length = 0.1, axial_damping = 5.0 }}
shape = {{ kind = "polyline", points = [
  [-0.16, 0, -0.36], [-0.16, 0, 0.07],
  [-0.08, 0, 0.17], [0.08, 0, 0.17], [0.16, 0, 0.07], [0.16, 0, -0.36]] }}
[[anchor]]
node = 0
[[anchor]]
node = -1
[[obstacle]]
name = "drum"
kind = "cylinder"
from = [0, -0.2, 0]
to = [0, 0.2, 0]
radius = 0.15
{spin}
""")


def spot(window: Window, place: tuple[float, float, float], size: int = 6) -> np.ndarray:
    """Return the pixels around where a place of the scene is shown, (n, 3)."""
    x, y = window.ask(
        "(() => { const box = r.viewport.renderer.canvas.getBoundingClientRect();"
        f"const [x, y] = r.viewport.camera.project({place[0]}, {place[1]}, {place[2]});"
        "return [x + box.left, y + box.top]; })()"
    )
    row, column = round(y), round(x)
    seen = window.picture()[row - size : row + size, column - size : column + size]
    return seen.reshape(-1, 3)


@pytest.mark.parametrize("renderer", ["webgl", "canvas"])
@pytest.mark.parametrize("scheme", ["light", "dark"])
def test_a_drum_is_seen(
    open_window: Open, serve: Serve, tmp_path: Path, renderer: str, scheme: str
) -> None:
    """Its face is of its own grey; without it there is sky or floor at that place."""
    shown = []
    for scene in (over_a_drum(), over_a_drum().replace(obstacles=[])):
        server = serve(Session(scene), folder=tmp_path / str(len(shown)))
        window = open_window(f"{server.address}?renderer={renderer}", **WIDE, color_scheme=scheme)
        window.ready().settled()
        assert window.ask("r.renderer") == renderer
        shown.append(np.median(spot(window, (0.05, -0.2, 0.05)), axis=0))
    assert np.abs(shown[0] - shown[1]).max() > 25


@pytest.mark.parametrize("renderer", ["webgl", "canvas"])
def test_a_drum_hides_the_rope_behind_it_only(
    open_window: Open, serve: Serve, renderer: str
) -> None:
    server = serve(Session(over_a_drum()))
    window = open_window(f"{server.address}?renderer={renderer}", **WIDE).ready()
    top = range(10, 15)  # nodes on the drum

    def look(direction: str) -> float:
        window.page.evaluate(
            f"() => {{ const s = window.ropewalk.viewport; s.setPose({{ ...s.camera.pose, {direction} }}); }}"
        )
        window.settled()
        return window.at_rope(top)

    from_above = look("azimuth: -1.57, elevation: 1.2")
    from_below = look("azimuth: -1.57, elevation: -1.2")
    assert from_above == 1.0
    assert from_below < 0.3


@pytest.mark.parametrize("renderer", ["webgl", "canvas"])
def test_a_drum_that_turns_is_seen_to_turn(
    open_window: Open, serve: Serve, tmp_path: Path, renderer: str
) -> None:
    """Its marks move with time; those of a drum at rest, which has none, do not."""

    def change(spin: str) -> float:
        server = serve(Session(over_a_drum(spin)), folder=tmp_path / f"run{len(spin)}")
        window = open_window(f"{server.address}?renderer={renderer}", **WIDE).ready()
        window.settled()
        before = spot(window, (0.0, -0.2, 0.0), 30)
        window.tell(type="step", count=8)
        window.settled()
        return float((np.abs(spot(window, (0.0, -0.2, 0.0), 30) - before).max(axis=1) > 20).mean())

    assert change("spin = { rate = 5.0 }") > 0.05
    assert change("") == 0.0


def test_a_shared_page_shows_them(open_window: Open, tmp_path: Path) -> None:
    path = tmp_path / "drum.html"
    result = rw.simulate(over_a_drum())
    share_result(result, path)
    window = open_window(path.as_uri(), **WIDE).ready()
    window.settled()
    assert window.ask("r.viewport.solids.all.map((one) => one.name)") == ["drum"]
    window.tell(type="seek", time=0.2)
    window.settled()
    pressed = np.array(window.ask("[...r.session.frame.parts[0].contact]")).reshape(-1, 3)
    known = result.contact_force[-1]
    assert np.abs(pressed - known).max() < 0.01 * np.abs(known).max()
    face = np.median(spot(window, (0.05, -0.2, 0.05)), axis=0)
    sky = np.median(spot(window, (0.05, -0.2, 0.6)), axis=0)
    assert np.abs(face - sky).max() > 25


def test_contact_forces_are_arrows_with_their_scale(open_window: Open, serve: Serve) -> None:
    """As many as nodes touch, the longest as long as its force says; a switch hides them."""
    server = serve(Session(over_a_drum()))
    window = open_window(server.address, **WIDE).ready()
    window.tell(type="step", count=10)
    window.settled()
    simulation = server.broadcast.session.main.simulation
    there = simulation.recording().recording.contact[0].T
    sizes = np.linalg.norm(there, axis=1)
    shown = np.array(window.ask("[...r.session.frame.parts[0].contact]")).reshape(-1, 3)
    assert shown == pytest.approx(there, rel=1e-6, abs=1e-6)
    arrows = window.ask("r.viewport.marks.touches.map(({ from, to }) => [from, to])")
    assert len(arrows) == (sizes > 0.03 * sizes.max()).sum() > 3
    lengths = np.linalg.norm(np.diff(np.array(arrows), axis=1)[:, 0], axis=1)
    assert lengths / lengths.max() == pytest.approx(
        sizes[sizes > 0.03 * sizes.max()] / sizes.max(), rel=1e-4
    )
    number, unit = window.page.locator("#contact-scale").inner_text().split()[-2:]
    told = float(number) * {"N": 1.0, "kN": 1e3, "mN": 1e-3}[unit]
    assert told == pytest.approx(sizes.max(), rel=0.05)
    window.click("#show-contacts")
    window.until("r.viewport.marks.touches.length === 0")
    # The twin: where there is nothing to touch there is no switch.
    window.tell(type="scene", preset="r4")
    window.until("r.session.layout.obstacles.length === 0")
    assert not window.page.locator("#show-contacts").is_visible()


def test_a_resting_picture_has_all_pixels(open_window: Open, serve: Serve) -> None:
    """Software draws with fewer while the camera moves; the picture at rest is as the first one was."""
    server = serve(Session(over_a_drum()))
    window = open_window(server.address, **WIDE).ready()
    window.page.locator("#scene .card").evaluate_all(
        "(cards) => cards.forEach((card) => { card.style.visibility = 'hidden'; })"
    )

    def rests() -> np.ndarray:
        window.settled()
        return window.picture()

    first, again = rests(), rests()
    while not np.array_equal(first, again):  # the camera may still make room for the legend
        first, again = again, rests()
    turned = window.page.evaluate(
        """() => new Promise((done) => {
            const { viewport } = window.ropewalk;
            const { pose } = viewport.camera;
            viewport.setPose({ ...pose, azimuth: pose.azimuth + 0.1 });
            requestAnimationFrame(() => requestAnimationFrame(() => {
              const { rough } = viewport.renderer;
              viewport.setPose(pose);
              done(rough);
            }));
        })"""
    )
    assert turned
    assert np.abs(rests() - first).max() <= 2
    # a label that just went elsewhere comes back, though nothing else is drawn
    window.page.evaluate(
        """() => {
            const { labels } = window.ropewalk.app;
            for (const one of labels.known.values())
              Object.assign(one, { since: performance.now(), taken: 5 });
            labels.viewport.dirty = true;
        }"""
    )
    assert np.abs(rests() - first).max() <= 2


def test_all_of_a_body_is_in_the_first_picture(open_window: Open, serve: Serve) -> None:
    server = serve(Session(over_a_drum()))
    window = open_window(server.address, **WIDE).ready()
    window.settled()
    corners = window.ask(
        "r.viewport.solids.places({ low: [-9, -9, -9], high: [9, 9, 9] })"
        ".map((one) => r.viewport.camera.project(...one))"
    )
    size = window.ask("[r.viewport.camera.width, r.viewport.camera.height]")
    assert len(corners) == 8
    assert all(0 < x < size[0] and 0 < y < size[1] and z > 0 for x, y, z in corners)


def test_a_hitch_is_looked_at_so_that_both_its_ends_are_seen(
    open_window: Open, serve: Serve
) -> None:
    """The hand's end of the clove hitch lay behind its post, and its arrow came out of that."""
    server = serve(Session(preset("clove-hitch"), "clove-hitch"))
    window = open_window(server.address, **WIDE).ready()
    eye = np.array(window.ask("[...r.viewport.camera.eye]"))
    ends = server.broadcast.session.main.simulation.positions[[0, -1]]

    def clear(eye: np.ndarray) -> list[bool]:
        """Whether the way from the eye to each end keeps clear of the post, which stands on the z axis."""
        ways = np.linspace(eye, ends, 2000)[:, :, :2]
        return (np.hypot(ways[..., 0], ways[..., 1]).min(axis=0) > 0.02).tolist()

    assert clear(eye) == [True, True]
    far, azimuth = np.hypot(eye[0], eye[1]), -0.5 * np.pi + 0.55
    usual = np.array([far * np.cos(azimuth), far * np.sin(azimuth), eye[2]])
    assert clear(usual) == [False, True]  # the twin: from where other scenes are looked at
