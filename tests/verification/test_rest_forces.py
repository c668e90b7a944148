"""What joints and pulleys carry at rest: an equilibrium holds the forces with which a run from it starts."""

from __future__ import annotations

import math

import numpy as np
import pytest

import ropewalk as rw
from ropewalk.record.result import Result
from ropewalk.scene import (
    Anchor,
    Cylinder,
    Joint,
    Load,
    Material,
    Points,
    Rope,
    Scene,
    Spin,
    Straight,
)
from ropewalk.statics import static_shape
from verification.setups import g

LEGS = [(-3.0, 0.0, 0.0), (2.0, 2.5, 0.0), (1.0, -3.0, 0.5)]


def star(*, held: bool = False, rigid: bool = False) -> Scene:
    """Return three strings from their anchors to a joint that 10 kg hang from, or that is held, too."""
    stuff = Material(EA=math.inf if rigid else 1e4, mass_per_length=0.05)
    ropes = [
        Rope(
            name=f"r{i}",
            segments=4,
            length=1.02 * float(np.linalg.norm(leg)),
            made_of=stuff,
            shape=Straight(start=(0, 0, 0), end=leg),
            loads=[Load(node=0, mass=10.0)] if i == 0 else [],
        )
        for i, leg in enumerate(LEGS)
    ]
    anchors = [Anchor(rope=f"r{i}", node=-1) for i in range(3)]
    anchors += [Anchor(rope="r0", node=0)] if held else []
    ties = Joint(name="hub", points=[{"rope": f"r{i}", "node": 0} for i in range(3)])
    run = {"start": "at-rest", "duration": 1e-3, "frame_rate": 1e3, "method": "implicit-euler"}
    return Scene(ropes=ropes, anchors=anchors, joints=[ties], run=run)


def starts_as(scene: Scene, rest: Result) -> Result:
    """Return a run that starts at rest, the forces of whose joints are those of the equilibrium."""
    run = rw.simulate(scene)
    size = np.abs(run.joint_forces[0]).max()
    assert rest.joint_forces[0] == pytest.approx(run.joint_forces[0], abs=1e-8 * size)
    return run


@pytest.mark.parametrize("rigid", [False, True])
def test_at_rest_a_joint_pulls_its_ropes_together(rigid: bool) -> None:
    """All of them were 0 N, and in joints.csv. Over a joint they add up to nothing."""
    scene = star(rigid=rigid)
    rest = rw.equilibrium(scene)
    hub = rest.joint_force("hub")[0]
    assert np.linalg.norm(hub, axis=1).min() > 50.0
    assert hub.sum(axis=0) == pytest.approx(np.zeros(3), abs=1e-9 * np.abs(hub).max())
    out = rest.positions[0, [6, 11]] - rest.positions[0, [5, 10]]  # of those with nothing but rope
    pull = rest.tension[0, [5, 10]][:, None] * out / np.linalg.norm(out, axis=1)[:, None]
    weights = [0.5 * 0.05 * rope.length_unstretched / 4 * g for rope in scene.ropes[1:]]
    pull[:, 2] -= weights
    assert hub[1:] == pytest.approx(-pull, rel=1e-9, abs=1e-9)
    starts_as(scene, rest)


def test_at_rest_a_joint_that_is_held_adds_up_to_its_anchor() -> None:
    scene = star(held=True)
    rest = rw.equilibrium(scene)
    force = rest.reactions[0, 3]
    assert force[2] > 10.0 * g
    assert rest.joint_force("hub")[0].sum(axis=0) == pytest.approx(force, rel=1e-9, abs=1e-9)
    starts_as(scene, rest)


def test_the_sling_of_the_presets_carries_its_block() -> None:
    """Its ring read 0 N; the chain's node at it bears all that hangs below the ring's."""
    rest = rw.equilibrium("three-leg-sling")
    down = rest.joint_force("ring")[0, 3]
    assert down == pytest.approx([0.0, 0.0, 984.924], abs=1e-3)


def over_a_pulley(rate: float = 0.0) -> Scene:
    """Return a light rope over a pulley whose bearing holds 1.05 kg on one side and 1 kg on the other."""
    outer, side = 0.055, 0.6  # radius of the rope's axis, length of either side [m]
    arc = math.pi * outer
    points = []
    for way in np.linspace(0.0, 2.0 * side + arc, 121):
        angle = math.pi - min(max(way - side, 0.0), arc) / outer
        down = max(side - way, way - side - arc, 0.0)
        points.append((outer * math.cos(angle), 0.0, outer * math.sin(angle) - down))
    rope = Rope(
        segments=120,
        length=(2.0 * side + arc) * 0.9995,
        diameter=0.01,
        made_of=Material(EA=2e4, mass_per_length=0.002),
        shape=Points(points=points),
        loads=[Load(node=0, mass=1.0), Load(node=-1, mass=1.05)],
    )
    spin = Spin(free=True, inertia=1e-3, bearing=0.05, rate=rate)
    drum = Cylinder(
        name="drum", start=(0, -0.3, 0), end=(0, 0.3, 0), radius=0.05, friction=0.5, spin=spin
    )
    run = {"start": "at-rest", "duration": 1e-3, "frame_rate": 1e3, "method": "implicit-euler"}
    return Scene(ropes=[rope], obstacles=[drum], run=run)


def test_at_rest_the_ropes_on_a_pulley_turn_it_with_what_its_bearing_holds() -> None:
    """It was 0 N m."""
    scene = over_a_pulley()
    rest = rw.equilibrium(scene)
    torque = float(rest.pulley("drum").rope_torque[0])
    assert torque == pytest.approx(0.05 * g * 0.055, rel=0.02)
    assert torque == pytest.approx(static_shape(scene).pulleys[0].torque, rel=1e-9)
    assert torque == pytest.approx(float(rw.simulate(scene).pulley("drum").rope_torque[0]))


def test_at_rest_a_pulley_stands_whatever_the_rate_at_which_it_is_to_start() -> None:
    motion = rw.equilibrium(over_a_pulley(rate=2.0)).pulley("drum")
    assert (motion.speed[0], motion.energy[0]) == (0.0, 0.0)
    assert motion.rope_torque[0] == pytest.approx(0.05 * g * 0.055, rel=0.02)
