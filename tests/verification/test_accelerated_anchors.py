"""A rope whose anchor is accelerated has g + a in place of g, and carries what lies on it.

The first stage of `sdirk2` takes a node's way for its velocity. With an anchor where it is then, nodes would
come to the step's end with 3.4 times its acceleration.
"""

from __future__ import annotations

import numpy as np
import pytest

import ropewalk as rw
from ropewalk.lowering import build
from ropewalk.record.result import Result
from ropewalk.scene import (
    Anchor,
    Contact,
    Fixed,
    Joint,
    Load,
    Material,
    Orbit,
    Rope,
    RunSettings,
    Scene,
    Shake,
    Straight,
    Table,
    Tie,
    Velocity,
)
from ropewalk.scene.motions import Motion
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


@pytest.mark.parametrize("where", ["both ends", "one end"])
def test_a_rope_whose_ends_go_round_each_other_pulls_by_its_stretch(where: str) -> None:
    """Held by who is led towards the middle of the circle it pulled its anchors by 166 N for 199."""
    length, EA, line, f = 1.0, 1e5, 0.01, 1.0
    middle = (0.5, 0.0, 0.0) if where == "both ends" else (0.0, 0.0, 0.0)
    round_it = Orbit(center=middle, axis=(0, 0, 1), frequency=f)
    rope = Rope(
        segments=1, length=length, made_of=Material(EA=EA, mass_per_length=line),
        shape=Straight(start=(0, 0, 0), end=(1.002, 0, 0)),
    )  # fmt: skip
    first = Anchor(name="first", node=0, motion=round_it if where == "both ends" else Fixed())
    anchors = [first, Anchor(name="last", node=1, motion=round_it)]
    run = RunSettings(duration=1.0, method="sdirk2", time_step=FRAME, frame_rate=60.0)
    result = rw.simulate(Scene(ropes=[rope], anchors=anchors, gravity=(0, 0, 0), run=run))
    pull = np.linalg.norm(result.reactions[result.time > 0.2], axis=2).mean(axis=0)
    arm = 1.002 * (0.5 if where == "both ends" else 1.0)
    inertia = 0.5 * line * length * arm * (2.0 * np.pi * f) ** 2
    assert pull[1] == pytest.approx(0.002 * EA - inertia, rel=0.01)
    assert abs(result.energy_error).max() < 0.02  # [J]; 4.6 in a second when led


@pytest.mark.parametrize(
    ("motions", "alike"),
    [
        ((Shake(axis=(1, 0, 0), amplitude=0.1, frequency=1.0),) * 2, True),
        ((Shake(axis=(1, 0, 0), amplitude=0.1, frequency=1.0), Fixed()), False),
        ((Orbit(center=(0, 1, 0), axis=(0, 0, 1), frequency=1.0),) * 2, False),
        ((Velocity(velocity=(1, 0, 0)), Velocity(velocity=(1, 0, 0))), True),
        ((Velocity(velocity=(1, 0, 0)), Velocity(velocity=(0, 1, 0))), False),
    ],
)
def test_who_goes_alike(motions: tuple[Motion, Motion], alike: bool) -> None:
    """By ropes that hang together; what holds another rope does not count."""
    ropes = [
        Rope(
            name=name, segments=1, length=1.0, made_of=Material(EA=1e4, mass_per_length=0.1),
            shape=Straight(start=(x, 0, 0), end=(x + 1.0, 0, 0)),
        )
        for name, x in (("a", 0.0), ("b", 1.0), ("c", 5.0))
    ]  # fmt: skip
    places = (("a", 0, motions[0]), ("b", 1, motions[1]), ("c", 0, Fixed()))
    anchors = [Anchor(rope=rope, node=node, motion=motion) for rope, node, motion in places]
    joint = Joint(points=[Tie(rope="a", node=1), Tie(rope="b", node=0)])
    apart = build(Scene(ropes=ropes, anchors=anchors))
    tied = build(Scene(ropes=ropes, anchors=anchors, joints=[joint]))
    assert apart.system.anchors.alike.tolist() == [1, 1, 1]
    assert tied.system.anchors.alike.tolist() == [alike, alike, 1]
