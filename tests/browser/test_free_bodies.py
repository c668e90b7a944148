"""Bodies that turn freely, on the page: each is drawn where the state has it, however many there are."""

from __future__ import annotations

import math
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

pytestmark = pytest.mark.browser
Open = Callable[..., Window]
Serve = Callable[..., ViewServer]
WIDE: dict[str, Any] = {"viewport": {"width": 1000, "height": 700}}
ROPE = """
[run]
duration = 0.4
frame_rate = 20
time_step = 0.005
method = "implicit-euler"
[[rope]]
segments = 4
length = 0.5
diameter = 0.02
made_of = { kind = "material", EA = 1e4, mass_per_length = 0.1, axial_damping = 5.0 }
shape = { kind = "straight", start = [-1, 0, 0.5], end = [-1, 0, 0] }
[[anchor]]
node = 0
"""
BODY = {
    "sphere": "center = [0.05, {y}, 0]\nradius = 0.06\naxis = [1, 0, 0]",
    "box": "center = [0.1, {y}, 0]\nhalf_sizes = [0.1, 0.04, 0.01]\nedge_radius = 0.004\naxis = [0, 1, 0]",
    "capsule": "from = [0, {y}, 0]\nto = [0.2, {y}, 0]\nradius = 0.03",
    "cylinder": "from = [0.05, {y}, -0.05]\nto = [0.05, {y}, 0.05]\nradius = 0.04",
}
AXIS = {"sphere": "", "box": "", "capsule": "axis = [0, 1, 0], ", "cylinder": "axis = [0, 1, 0], "}
AXLE = {"sphere": (1.0, 0.0, 0.0)}


def swinging(count: int) -> Scene:
    """So many bodies whose weight turns them about a pivot beside them, kind after kind, along y."""
    text = ROPE
    for row in range(count):
        kind, y = list(BODY)[row % len(BODY)], 0.2 * row - 0.3
        pivot, middle = (0.0, y, 0.0), (0.05, y + 0.05, 0.0)
        if kind == "sphere":
            pivot = (0.05, y - 0.05, 0.0)
        text += f"""
[[obstacle]]
name = "body{row}"
kind = "{kind}"
{BODY[kind].format(y=y)}
spin = {{ free = true, {AXIS[kind]}pivot = {list(pivot)}, inertia = {0.01 + 0.002 * row}, mass = 0.5, \
center_of_mass = {list(middle)} }}
""".replace("\\\n", "")
    return loads(text)


def turned(place: np.ndarray, pivot: np.ndarray, axle: np.ndarray, angle: float) -> np.ndarray:
    """Return where a place is once it has turned about an axle (Rodrigues)."""
    arm = place - pivot
    along = axle * (arm @ axle)
    return pivot + along + (arm - along) * math.cos(angle) + np.cross(axle, arm) * math.sin(angle)


def same_as(window: Window, scene: Scene, angles: dict[str, float]) -> None:
    """Every body's middle and angle on the page are those of the state."""
    for body in scene.obstacles:
        angle = angles[body.name]
        shown = window.ask(f"r.viewport.solids.angleOf('{body.name}')")
        apart = (shown - angle + math.pi) % (2.0 * math.pi) - math.pi
        assert abs(apart) < 1e-4
        axle = np.array(AXLE.get(body.kind, (0.0, 1.0, 0.0)))
        middle = np.array(
            body.center if hasattr(body, "center") else np.mean([body.start, body.end], 0)
        )
        wanted = turned(middle, np.array(body.spin.pivot), axle, angle)
        seen = window.ask(f"r.viewport.solids.named('{body.name}').center")
        np.testing.assert_allclose(seen, wanted, atol=1e-4)


def test_bodies_are_where_the_state_has_them(open_window: Open, serve: Serve) -> None:
    """Six of four kinds, about a pivot beside them: the fifth and sixth stood still on the page."""
    scene = swinging(6)
    session = Session(scene)
    window = open_window(serve(session).address, **WIDE).ready()
    window.tell(type="step", count=40)
    window.settled()
    time = window.ask("r.time")
    run = rw.Simulation(scene)
    while run.time < time - 1e-9:
        run.advance_steps(1)
    assert run.time == pytest.approx(time)
    angles = {name: run.obstacles[name].angle for name in [body.name for body in scene.obstacles]}
    assert min(map(abs, angles.values())) > 0.1
    assert len({round(one, 3) for one in angles.values()}) == 6
    same_as(window, scene, angles)


def test_a_shared_page_has_them_there_too(open_window: Open, tmp_path: Path) -> None:
    scene, path = swinging(6), tmp_path / "bodies.html"
    result = rw.simulate(scene)
    share_result(result, path)
    window = open_window(path.as_uri(), **WIDE).ready()
    window.tell(type="seek", time=0.4)
    window.settled()
    same_as(
        window, scene, {body.name: result.pulley(body.name).angle[-1] for body in scene.obstacles}
    )
