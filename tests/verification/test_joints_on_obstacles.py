"""What a joint ties to the node that touches an obstacle stops with it."""

from __future__ import annotations

import numpy as np
import pytest

import ropewalk as rw
from ropewalk.core.arrays import Floats
from ropewalk.laws.obstacle import Obstacles
from ropewalk.lowering import build
from ropewalk.scene import Joint, Material, Rope, RunSettings, Scene, Sphere, Straight, Tie
from ropewalk.simulation import Simulation

METHODS = [
    ("semi-implicit-euler", None),
    ("verlet", None),
    ("sdirk2", 1e-3),
    ("sdirk2", 1.0 / 240.0),
    ("adaptive", None),
]


def falls(
    method: str, step: float | None, speed: float = 1.0, heavy: float = 5.0, wide: float = 0.005
) -> Scene:
    """A cord of 20 g whose first node comes at a ball, with a link of so many kg/m tied to it."""
    frames = round((0.05 / speed + 0.03) * 500.0)
    settings = {"method": method} | ({"time_step": step} if step else {})
    ropes = [
        Rope(
            name=name, segments=segments, length=length, diameter=thick,
            made_of=Material(EA=1e4, mass_per_length=line),
            shape=Straight(start=(0, 0.05, 0), direction=(0, 0, way), velocity=(0, -speed, 0)),
        )
        for name, segments, length, thick, line, way in (
            ("cord", 4, 0.4, 0.01, 0.05, 1.0), ("link", 1, 0.2, wide, heavy, -1.0),
        )
    ]  # fmt: skip
    return Scene(
        ropes=ropes,
        joints=[Joint(name="knot", points=[Tie(rope="cord", node=0), Tie(rope="link", node=0)])],
        obstacles=[Sphere(center=(0, -0.05, 0), radius=0.05, friction=0.0)],
        gravity=(0, 0, 0),
        run=RunSettings(**settings, duration=frames / 500.0, frame_rate=500.0),
    )


@pytest.mark.parametrize("speed", [0.2, 1.0])
@pytest.mark.parametrize(("method", "step"), METHODS)
def test_nothing_is_thrown_back(method: str, step: float | None, speed: float) -> None:
    """With the damper of the cord's own nodes 0.44 to 0.87 of 0.2 m/s came back, 0.15 to 0.3 of 1 m/s."""
    result = rw.simulate(falls(method, step, speed))
    assert result.rope("cord").velocities[:, 0, 1].max() < 0.02 * speed


def made_for(table: Obstacles) -> Floats:
    """The masses that dampers are made for [kg], (n,)."""
    found: Floats = (0.5 * table.damping[0]) ** 2 / table.stiffness[0]
    return found


def drawn(scene: Scene) -> Floats:
    return made_for(build(scene).system.node.obstacle)


@pytest.mark.parametrize(("line", "wide"), [(0.05, 0.01), (5.0, 0.02)])
def test_what_is_not_much_heavier_changes_no_damper(line: float, wide: float) -> None:
    """Nor does what is thicker, and presses in place of the cord."""
    scene = falls("verlet", None, heavy=line, wide=wide)
    alone = drawn(scene.replace(joints=[]))
    assert drawn(scene) == pytest.approx(alone, rel=1e-12)
    heavy = drawn(falls("verlet", None))  # the twin
    assert heavy[0] == pytest.approx(0.5025)
    assert heavy[1:5] == pytest.approx(np.full(4, 0.004))


@pytest.mark.parametrize("method", ["verlet", "sdirk2"])
def test_what_a_joint_has_let_go_counts_no_more(method: str) -> None:
    """Its damper took hold of the cord's end fourteen times as far out; `restore` ties it again."""
    simulation = Simulation(falls(method, None))
    table, before = simulation.system.node.obstacle, simulation.state
    tied = table.damping.copy()
    simulation.cut_joint("knot")
    assert made_for(table)[0] == pytest.approx(0.0025)
    simulation.advance_frames(1)
    simulation.restore(before)
    simulation.advance_frames(1)
    assert np.array_equal(table.damping, tied)
