"""Coefficients of friction are changed while it runs, where a scene has one number of them."""

from __future__ import annotations

import math
from pathlib import Path

import numpy as np
import pytest

from live.drive import do, r4, refused
from ropewalk.live.describe import parameters
from ropewalk.live.keeper import QUIET, Keeper, parts
from ropewalk.live.session import Session
from ropewalk.record.result import Result
from ropewalk.scene import Contact, Material, Plane, Points, Rope, RunSettings, Scene
from ropewalk.scene.presets import preset
from ropewalk.scene.rubbing import Pair

SLOPE = math.radians(20.0)
DOWN = np.array([math.cos(SLOPE), 0.0, -math.sin(SLOPE)])
UP = np.array([math.sin(SLOPE), 0.0, math.cos(SLOPE)])


def on_a_slope(**more: object) -> Scene:
    """A straight rope of 0.3 m down an incline of 20 degrees, which friction of 0.5 holds."""
    rope = Rope(
        segments=6,
        length=0.3,
        diameter=0.01,
        made_of=Material(EA=1e3, mass_per_length=0.1),
        shape=Points(points=[tuple(0.05 * i * DOWN + 0.005 * UP) for i in range(7)]),
    )
    plane = Plane(normal=tuple(UP), friction=0.5)
    run = RunSettings(method="implicit-euler", time_step=2.5e-4)
    return Scene(**({"ropes": [rope], "obstacles": [plane], "run": run} | more))


def told(session: Session) -> dict[str, object]:
    """Return the values of what the page can change, by name."""
    return {one["name"]: one["value"] for one in parameters(session)["parameters"]}


def test_with_less_friction_a_rope_slides_by_coulombs_law_and_with_more_it_stops() -> None:
    session = Session(on_a_slope())
    session.advance(400)
    assert np.abs(session.main.simulation.velocities).max() < 1e-3
    do(session, "set", name="obstacle_friction", value=0.1)
    assert told(session)["obstacle_friction"] == 0.1
    session.advance(200)
    before = session.main.simulation.velocities @ DOWN
    session.advance(400)  # 0.1 s
    gained = session.main.simulation.velocities @ DOWN - before
    slides = 9.81 * (math.sin(SLOPE) - 0.1 * math.cos(SLOPE)) * 0.1
    assert gained == pytest.approx(slides, rel=0.01)
    do(session, "set", name="obstacle_friction", value=0.9)
    session.advance(1000)
    assert np.abs(session.main.simulation.velocities @ DOWN).max() < 1e-3
    do(session, "set", name="obstacle_friction", value=None)
    assert told(session)["obstacle_friction"] == 0.5


def test_a_replay_has_the_last_friction_of_a_drag_soon_after_it(tmp_path: Path) -> None:
    """For half a second it told a rope that slid that friction of before held it."""
    session = Session(on_a_slope())
    keeper = Keeper(session, tmp_path / "run")
    for friction in (0.4, 0.1):
        session.advance(2 * session.frame_steps)
        do(session, "set", name="obstacle_friction", value=friction)
    changed = session.time
    session.advance(round(1.5 * QUIET / session.main.dt))
    keeper.close()
    found = [Result.open(folder) for folder in parts(tmp_path / "run")]
    assert [one.scene.obstacles[0].friction for one in found] == [0.5, 0.4, 0.1]
    last = found[-1].time[0] - changed
    assert last < QUIET + 2.0 * session.loaded.run.frame_interval


def test_ropes_on_ropes_have_a_number_of_their_own() -> None:
    session = Session(on_a_slope(contact=Contact(friction=0.2)))
    do(session, "set", name="contact_friction", value=0.7)
    assert session.scene.contact is not None
    assert session.scene.contact.friction == 0.7
    assert session.scene.obstacles[0].friction == 0.5
    assert told(session)["contact_friction"] == 0.7


def test_where_a_scene_has_no_such_number_it_says_so() -> None:
    assert not {"obstacle_friction", "contact_friction"} & set(told(r4()))
    assert "no obstacle" in refused(r4(), "set", name="obstacle_friction", value=0.1)
    scene = on_a_slope()
    plane = scene.obstacles[0]
    own = plane.replace(pairs=[Pair(rope=scene.ropes[0].name, friction=0.3)])
    paired = Session(scene.replace(obstacles=[own]))
    assert "obstacle_friction" not in told(paired)
    assert "pairs" in refused(paired, "set", name="obstacle_friction", value=0.1)
    other = plane.replace(name="other", point=(0.0, 0.0, -5.0), friction=0.1)
    assert "obstacle_friction" not in told(Session(scene.replace(obstacles=[plane, other])))


def test_scenes_of_wraps_have_it_at_the_first_level() -> None:
    for name in ("capstan", "prusik"):
        scene = preset(name)
        drawn = scene.replace(run=scene.run.replace(start="shape"))
        found = parameters(Session(drawn))
        one = next(one for one in found["parameters"] if one["name"] == "obstacle_friction")
        assert not one["more"]
        assert one["high"] == 1.0
