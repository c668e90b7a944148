"""Sweeps keep what obstacles bear, and what a wrap does: neither hangs on how a rope is cut into segments."""

from __future__ import annotations

import itertools
import math

import numpy as np
import pytest

import ropewalk as rw
from ropewalk.scene import Cylinder, Scene, SceneError
from ropewalk.sweeps.derived import DERIVED
from ropewalk.sweeps.fit_residuals import NotFitted

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


def test_a_wrap_beside_which_nothing_pulls_has_no_ratio() -> None:
    """The end of a rope that lies on the bar, which an anchor holds: 0 was told, and entered the least."""
    points = [(0.056, 0, -0.2), (0.056, 0, 0.0235), (0.0235, 0, 0.056), (-0.0235, 0, 0.056)]
    rope = rw.Rope(
        segments=20,
        length=sum(math.dist(a, b) for a, b in itertools.pairwise(points)),
        diameter=0.01,
        made_of=rw.Material(EA=1e4, mass_per_length=0.1, axial_damping=5.0),
        shape={"kind": "polyline", "points": points},
    )
    bar = over_bar(12).obstacles[0]
    run = {"method": "esdirk3", "duration": 0.04, "time_step": 0.002, "frame_rate": 100}
    scene = Scene(ropes=[rope], anchors=[rw.Anchor(node=0)], obstacles=[bar], run=run)
    data = rw.sweep(scene, {"obstacle.friction": [0.3]}, keep=["wrap_ratio.min", "wrap_angle.max"])
    assert float(data.wrap_angle_max.squeeze()) > 0.5
    assert np.isnan(data.wrap_ratio_min).all()


def test_a_fit_to_what_has_no_value_says_so() -> None:
    """All runs ended well, and were said to have broken."""
    below = Cylinder(name="bar", start=(0, -0.1, -5), end=(0, 0.1, -5), radius=0.05, friction=0.3)
    scene = over_bar(12, duration=0.02, time_step=0.005).replace(obstacles=[below])
    measured = [rw.calibrate.kept("wrap_ratio[-1, bar]", 1.9, error=0.02)]
    rule = r"wrap_ratio\[-1, bar\] has no value in runs that ended well"
    with pytest.raises(NotFitted, match=rule):
        rw.calibrate(scene, measured, {"obstacle.friction": (0.1, 0.5)}, starts=2)


@pytest.mark.parametrize("start", ["shape", "at-rest"])
def test_the_largest_load_of_a_bar_is_of_every_step(start: str) -> None:
    """As drawn a rope drops on its bar: 25.3 N in one of two frames, 42.4 N on the way. The twin rests."""
    run = {"duration": 0.1, "time_step": 0.001, "start": start}
    few = over_bar(12, frame_rate=10, **run)
    data = rw.sweep(few, {"obstacle.friction": [0.3]}, keep=["obstacle_load.max", "obstacle_load"])
    every = rw.simulate(over_bar(12, frame_rate=1000, **run))
    most = DERIVED["obstacle_load"].of(every).max()
    assert data.obstacle_load_max.dims == ("friction", "obstacle")
    assert data.obstacle_load_max.long_name.endswith("does), over all steps")
    np.testing.assert_allclose(data.obstacle_load_max, most, rtol=1e-4)
    assert (most > 1.5 * data.obstacle_load.max()) == (start == "shape")


def test_friction_is_found_from_what_is_borne() -> None:
    """What a calibration measures is anything that a sweep keeps."""
    scene = over_bar(12)
    measured = [rw.calibrate.kept("obstacle_load.max", 24.6, error=0.1, rest=True)]
    fit = rw.calibrate(scene, measured, {"rope.load[1].mass": (1.0, 2.0)})
    assert fit.values["rope.load[1].mass"] == pytest.approx(24.6 / 9.81 - LIGHT, rel=2e-3)
