"""Obstacles beside all else: what is refused or warned of, and that it holds with every other law."""

from __future__ import annotations

import math
from typing import Any

import numpy as np
import pytest

import ropewalk as rw
from ropewalk.core.arrays import Floats
from ropewalk.core.status import OK
from ropewalk.lowering import build
from ropewalk.scene import (
    Air,
    Box,
    Cylinder,
    Joint,
    Limiter,
    Material,
    Plane,
    Rope,
    RunSettings,
    Scene,
    SceneError,
    Sphere,
    Straight,
    Tie,
    Torus,
)
from ropewalk.simulation import Simulation
from verification.test_touch import incline

# -- refusals --------------------------------------------------------------------------------


def refused(scene: Scene, **run: Any) -> dict[str, str]:
    """Return the rules of the faults that a scene has, by path."""
    with pytest.raises(SceneError) as error:
        build(scene.replace(run=scene.run.replace(**run)))
    return {fault.path: fault.rule for fault in error.value.faults}


def test_what_cannot_be_run_is_refused_by_name() -> None:
    scene, _ = incline(10.0, "esdirk3")
    for method in ("implicit-midpoint", "generalized-alpha"):
        assert "cannot work with obstacles" in refused(scene, method=method)["run.method"]
    deep = scene.replace(obstacles=[scene.obstacles[0].replace(point=(0.0, 0.0, 0.2))])
    assert "mm inside obstacle 'obstacle0'" in refused(deep)["rope[0].shape"]


@pytest.mark.parametrize(
    ("kind", "given", "path"),
    [
        (Sphere, {"center": (0, 0, 0), "radius": 0.0}, "radius"),
        (Plane, {"friction": -0.1}, "friction"),
        (Plane, {"friction": math.inf}, "friction"),
        (Plane, {"normal": (0, 0, 0)}, "normal"),
        (Cylinder, {"start": (0, 0, 0), "end": (0, 0, 0), "radius": 1.0}, "to"),
        (Box, {"center": (0, 0, 0), "half_sizes": (1, 1, 1), "edge_radius": 2.0}, "edge_radius"),
        (Torus, {"center": (0, 0, 0), "radius": 1.0, "bar_radius": 1.0}, "bar_radius"),
    ],
)
def test_faulty_bodies_are_refused(kind: Any, given: dict[str, Any], path: str) -> None:
    with pytest.raises(SceneError) as error:
        kind(**given)
    assert [fault.path for fault in error.value.faults] == [path]


def test_check_warns_of_what_nodes_may_miss() -> None:
    scene, _ = incline(10.0, "esdirk3")
    thin = Sphere(center=(5, 0, 0), radius=0.01)
    warnings = rw.check(scene.replace(obstacles=[thin]), measure=False).warnings
    assert any("longer than 1.4 times its radius" in text for text in warnings)
    assert not any("goes through" in text for text in warnings)  # it is solved again in halves
    explicit = scene.run.replace(method="semi-implicit-euler", time_step=1 / 60)
    warnings = rw.check(scene.replace(obstacles=[thin], run=explicit), measure=False).warnings
    assert any("a run in which one goes through ends there" in text for text in warnings)
    wide = rw.check(scene, measure=False).warnings
    assert not any("longer than" in text or "go through" in text for text in wide)


# -- with other laws -------------------------------------------------------------------------


def laid(direction: Floats, normal: Floats, name: str = "rope", **made_of: Any) -> Rope:
    """A straight rope of 0.6 m just above a plane through the origin."""
    start, end = (tuple(map(float, side * direction + 1e-3 * normal)) for side in (-0.3, 0.3))
    material = Material(**({"EA": 1e4, "mass_per_length": 0.1, "axial_damping": 5.0} | made_of))
    shape = Straight(start=start, end=end)
    return Rope(name=name, segments=6, length=0.6, made_of=material, shape=shape)


@pytest.mark.parametrize("method", ["implicit-euler", "esdirk3"])
@pytest.mark.parametrize(
    "law", ["joint", "rigid links", "limiter", "bending", "tension-only", "air"]
)
def test_it_holds_whatever_else_acts(law: str, method: str) -> None:
    """On an incline of 14 degrees: 0.4 s after the rope has come down nothing moves by 1e-6 mm."""
    slope = math.radians(14.0)
    normal = np.array([math.sin(slope), 0.0, math.cos(slope)])
    down, aside = np.array([math.cos(slope), 0.0, -math.sin(slope)]), np.array([0.0, 1.0, 0.0])
    parts: dict[str, Any] = {"ropes": [laid(down, normal)]}
    if law == "joint":
        parts["ropes"] = [laid(down, normal, "one"), laid(aside, normal, "two")]
        parts["joints"] = [Joint(points=[Tie(rope="one", node=3), Tie(rope="two", node=3)])]
    if law == "rigid links":
        parts["ropes"] = [laid(down, normal, EA=math.inf, axial_damping=0.0)]
    if law == "limiter":
        parts["limiter"] = Limiter(min_stretch=0.99, max_stretch=1.01)
    if law == "bending":
        parts["ropes"] = [laid(down, normal, EI=1e-3)]
    if law == "tension-only":
        parts["ropes"] = [laid(down, normal, tension_only=True)]
    if law == "air":
        parts["air"] = Air(node_drag=1e-3)
    run = RunSettings(duration=1.0, frame_rate=60.0, time_step=1.0 / 60.0, method=method)
    simulation = Simulation(Scene(obstacles=[Plane(normal=tuple(normal))], run=run, **parts))
    assert simulation.advance_frames(24).status == OK
    before = simulation.positions.copy()
    assert simulation.advance_frames(12).status == OK
    assert np.abs(simulation.positions - before).max() < 1e-9
    assert (simulation.positions @ normal).max() < 0.0
