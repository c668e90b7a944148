"""A rope whose anchor is accelerated has g + a in place of g, and carries what lies on it.

The first stage of `sdirk2` takes a node's way for its velocity. With an anchor where it is then, nodes would
come to the step's end with 3.4 times its acceleration.
"""

from __future__ import annotations

import numpy as np
import pytest

import ropewalk as rw
from ropewalk.record.result import Result
from ropewalk.scene import (
    Anchor,
    Contact,
    Load,
    Material,
    Rope,
    RunSettings,
    Scene,
    Straight,
    Table,
)
from verification.test_accelerated_obstacles import FRAME, MU, g, speeding

METHODS = ("implicit-euler", "sdirk2", "esdirk3")


def from_there(motion: Table, place: tuple[float, float, float]) -> Table:
    """The same motion from another place [m]."""
    places = [tuple(float(c) for c in np.add(place, way)) for way in motion.positions]
    return motion.replace(positions=places)


@pytest.mark.parametrize("method", METHODS)
@pytest.mark.parametrize("friction", [50.0, 500.0])
def test_a_load_that_is_hoisted_faster_and_faster_pulls_by_g_and_a(
    friction: float, method: str
) -> None:
    """Half a kilogram on a metre of ten segments; each carries what is below, with half of its own."""
    a, line, load = 3.0, 0.05, 0.5
    times = np.linspace(0.0, 1.0, 81)
    rises = a * np.clip(times / 0.5, 0.0, 1.0)
    for _ in range(2):
        rises = np.concatenate([[0.0], np.cumsum(0.5 * (rises[1:] + rises[:-1])) / 80.0])
    motion = Table(
        times=tuple(map(float, times)),
        positions=[(0.0, 0.0, 1.0 + float(z)) for z in rises],
        interpolation="cubic",
    )
    rope = Rope(
        segments=10, length=1.0, diameter=0.01, loads=[Load(node=-1, mass=load)],
        made_of=Material(EA=1e5, mass_per_length=line, axial_damping=friction),
        shape=Straight(start=(0, 0, 1), end=(0, 0, 0)),
    )  # fmt: skip
    anchors = [Anchor(name="top", node=0, motion=motion)]
    run = RunSettings(
        duration=0.8, frame_rate=60.0, method=method, time_step=FRAME, start="at-rest"
    )
    result = rw.simulate(Scene(ropes=[rope], anchors=anchors, run=run))
    below = load + line * (0.95 - 0.1 * np.arange(10))
    tension = result.tension[result.time > 0.6]
    np.testing.assert_allclose(tension, np.broadcast_to(below * (g + a), tension.shape), rtol=1e-5)


def carried(share: float, method: str) -> Result:
    """A rod across two rails that are moved at their ends, along themselves, at a share of mu g."""
    motion = speeding(share * MU * g * np.array([1.0, 0.0, 0.0]))
    made = Material(EA=1e5, mass_per_length=0.1, axial_damping=50.0)
    ropes, anchors = [], []
    for name, y in (("near", -0.1), ("far", 0.1)):
        shape = Straight(start=(-0.3, y, 0), end=(0.3, y, 0))
        ropes.append(
            Rope(name=name, segments=1, length=0.6, diameter=0.01, made_of=made, shape=shape)
        )
        for node, x in ((0, -0.3), (1, 0.3)):
            there = from_there(motion, (x, y, 0.0))
            anchors.append(Anchor(name=f"{name}-{node}", rope=name, node=node, motion=there))
    shape = Straight(start=(0.01, -0.2, 0.01), end=(0.01, 0.2, 0.01))
    ropes.append(Rope(name="rod", segments=1, length=0.4, diameter=0.01, made_of=made, shape=shape))
    run = RunSettings(duration=0.6, frame_rate=60.0, method=method, time_step=FRAME)
    return rw.simulate(Scene(ropes=ropes, anchors=anchors, contact=Contact(friction=MU), run=run))


@pytest.mark.parametrize("method", METHODS)
def test_ropes_that_are_accelerated_take_along_what_lies_on_them(method: str) -> None:
    result = carried(0.8, method)
    late = result.time > 0.3
    over = (result.positions[:, -2:] - result.positions[:, :1])[late][..., 0]
    assert np.ptp(over, axis=0).max() < 1e-6


@pytest.mark.parametrize("method", METHODS)
def test_above_the_limit_it_is_left_behind_by_what_is_beyond(method: str) -> None:
    result = carried(1.05, method)
    late = result.time > 0.3
    over = (result.positions[:, -2:] - result.positions[:, :1])[late][..., 0].mean(axis=1)
    found = np.diff(over, n=2).mean() / FRAME**2
    assert found == pytest.approx(-0.05 * MU * g, rel=0.02)
