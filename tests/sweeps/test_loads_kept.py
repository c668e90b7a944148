"""Sweeps keep what obstacles bear, and what a wrap does: neither hangs on how a rope is cut into segments."""

from __future__ import annotations

import math

import numpy as np
import pytest

import ropewalk as rw
from ropewalk.scene import Cylinder, Scene, SceneError

LIGHT, HEAVY = 1.0, 1.5  # [kg] at the two ends
KEPT = ("contact_force.max", "obstacle_load.max", "wrap_angle[-1]", "wrap_ratio[-1]")


def over_bar(segments: int, spin: dict[str, object] | None = None, **run: object) -> Scene:
    """A rope over a bar, with so many segments in its half turn, and a weight at each end."""
    radius = 0.055
    turn = np.linspace(math.pi, 0.0, segments + 1)
    step = 2.0 * radius * math.sin(0.5 * math.pi / segments)
    tail = step * np.arange(1, 1 + round(0.3 / step))
    arc = np.stack([radius * np.cos(turn), 0.0 * turn, radius * np.sin(turn)], axis=1)
    left, right = (np.stack([0 * tail + x, 0 * tail, -tail], axis=1) for x in (-radius, radius))
    points = np.concatenate([left[::-1], arc, right])
    rope = rw.Rope(
        segments=len(points) - 1,
        length=step * (len(points) - 1),
        diameter=0.01,
        made_of=rw.Material(EA=1e5, mass_per_length=1e-3, axial_damping=20.0),
        shape={"kind": "points", "points": points.tolist()},
        loads=[{"node": 0, "mass": LIGHT}, {"node": -1, "mass": HEAVY if spin is None else LIGHT}],
    )
    bar = Cylinder(
        name="bar", start=(0, -0.1, 0), end=(0, 0.1, 0), radius=0.05, friction=0.3, spin=spin
    )
    return Scene(ropes=[rope], obstacles=[bar], run={"method": "esdirk3", **run})


def test_what_a_bar_bears_and_the_ratio_of_a_wrap_are_those_of_the_rope() -> None:
    """The force on one node, which alone could be kept, is half as large with segments half as long."""
    found = [
        rw.sweep(over_bar(n), {"obstacle.friction": [0.2, 0.3]}, keep=KEPT, what="rest")
        for n in (12, 24)
    ]
    for data in found:
        assert data.obstacle_load_max.dims == ("friction", "obstacle")
        assert data.wrap_ratio_last.sel(wrap="bar").dims == ("friction",)
        bears = (LIGHT + HEAVY) * 9.81
        np.testing.assert_allclose(data.obstacle_load_max, bears, rtol=1e-3)
        np.testing.assert_allclose(data.wrap_ratio_last, HEAVY / LIGHT, rtol=1e-3)
        np.testing.assert_allclose(data.wrap_angle_last, math.pi, rtol=1e-3)
    ratio = (found[0].contact_force_max / found[1].contact_force_max).to_numpy()
    np.testing.assert_allclose(ratio, 2.0, rtol=0.1)
    assert "on one node (it goes with the length of" in found[0].contact_force_max.long_name


def test_the_load_on_an_axle_is_kept() -> None:
    """Of a pulley at rest the weight of all that hangs on it; by its name, as an anchor's force."""
    spin = {"free": True, "inertia": 1e-4}
    scene = over_bar(12, spin, duration=0.02, time_step=0.005, frame_rate=200, start="at-rest")
    data = rw.sweep(
        scene, {"obstacle.friction": [0.3]}, keep=["axle_load.max", "axle_load[-1,bar]"]
    )
    np.testing.assert_allclose(data.axle_load_max.sel(pulley="bar"), 2 * LIGHT * 9.81, rtol=2e-3)
    assert data.axle_load_last_bar.dims == ("friction",)
    with pytest.raises(SceneError, match="no obstacle that turns freely"):
        rw.sweep(over_bar(12), {"obstacle.friction": [0.3]}, keep="axle_load.max", what="rest")


def test_friction_is_found_from_what_is_borne() -> None:
    """What a calibration measures is anything that a sweep keeps."""
    scene = over_bar(12)
    measured = [rw.calibrate.kept("obstacle_load.max", 24.6, error=0.1, rest=True)]
    fit = rw.calibrate(scene, measured, {"rope.load[1].mass": (1.0, 2.0)})
    assert fit.values["rope.load[1].mass"] == pytest.approx(24.6 / 9.81 - LIGHT, rel=2e-3)
