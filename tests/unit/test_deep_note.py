"""Where an obstacle, an anchor or a load presses a rope into another, the result says so."""

from __future__ import annotations

import re

import numpy as np
import pytest

import ropewalk as rw
from ropewalk.scene import Box, Plane, Scene, Spin, Straight, Velocity

ABOUT = "about the obstacles"
D = 0.01
BED = Plane(name="bed")


def lying(height: float = 0.5 * D, **more: object) -> Scene:
    """A rope of 10 mm along x."""
    made_of = rw.Material(EA=2e4, mass_per_length=0.1, axial_damping=20.0)
    ends = [(x, 0.0, height) for x in (-0.25, 0.25)]
    shape = Straight(start=ends[0], end=ends[1])
    rope = rw.Rope(segments=10, length=0.5, diameter=D, made_of=made_of, shape=shape)
    run = {"method": "esdirk3", "time_step": 0.004, "duration": 1.0, "frame_rate": 50.0}
    return Scene(ropes=[rope], run=run, **more)


def ram(speed: float) -> Plane:
    """A plate above the rope that comes down on it, 20 mm above the bed at first."""
    down = Velocity(velocity=(0, 0, -speed))
    return Plane(name="ram", point=(0, 0, 2.0 * D), normal=(0, 0, -1), motion=down)


def test_a_rope_pressed_flat_is_told() -> None:
    """Between plates that meet 10 mm below the surface of one: 5.97 kN a node, and not a word of it."""
    result = rw.simulate(lying(obstacles=[BED, ram(0.04)]))
    told = result.table[ABOUT]
    found = re.match(
        r"at t = 1 s the middle of node \d+ of rope 'rope' was (\S+) mm inside '(\w+)'", told
    )
    assert found
    assert float(found[1]) == pytest.approx(1e3 * D, rel=0.01)
    assert found[2] in ("bed", "ram")
    assert -1e3 * result.positions[-1, :, 2].min() == pytest.approx(float(found[1]), rel=0.01)
    half = rw.simulate(lying(obstacles=[BED, ram(0.0149)]))  # to 5.1 mm: its middle is between
    assert ABOUT not in half.table


def test_an_anchor_that_goes_into_a_plane_is_told_by_its_neighbour() -> None:
    down = rw.Anchor(node=-1, motion=Velocity(velocity=(0, 0, -0.5)))
    result = rw.simulate(lying(height=0.1, obstacles=[BED], anchors=[down]))
    assert "node 9 of rope 'rope'" in result.table[ABOUT]
    still = rw.simulate(lying(obstacles=[BED], anchors=[rw.Anchor(node=-1)]))
    assert ABOUT not in still.table


def test_a_heavy_node_that_an_anchor_lets_go_inside_is_refused() -> None:
    """300 kg from 20 mm below a floor; while the anchor holds it nothing presses it, and nothing is told."""
    rope = rw.Rope(
        segments=6,
        length=0.6,
        diameter=D,
        made_of=rw.Material(EA=2e4, mass_per_length=0.1, axial_damping=20.0),
        shape=Straight(start=(0, 0, -2.0 * D), end=(0.4, 0, 0.4)),
        loads=[rw.scene.Load(node=0, mass=300.0)],
    )
    run = {"method": "esdirk3", "time_step": 0.004, "duration": 0.06, "frame_rate": 250.0}
    held = [rw.Anchor(node=0), rw.Anchor(node=-1)]
    assert (
        ABOUT not in rw.simulate(Scene(ropes=[rope], anchors=held, obstacles=[BED], run=run)).table
    )
    held = [rw.Anchor(node=0, release_time=0.03), rw.Anchor(node=-1)]
    with pytest.raises(
        rw.SceneError, match="release_time: 0.03 - lets go 25 mm inside obstacle 'bed'"
    ):
        rw.simulate(Scene(ropes=[rope], anchors=held, obstacles=[BED], run=run))


def test_a_body_is_where_it_has_turned_to() -> None:
    """A free plank is upright as a rope lands beside it, 20 mm inside where it was drawn."""
    plank = Box(
        name="plank",
        center=(0, 0, 0),
        half_sizes=(0.5, 0.5, 0.02),
        edge_radius=0.005,
        axis=(1, 0, 0),
        spin=Spin(free=True, inertia=10.0, rate=3.3),
    )
    floor = Plane(name="floor", point=(0, 0, -0.5 * D))
    scene = lying(height=1.0, obstacles=[plank, floor])
    rope = scene.ropes[0]
    aside = Straight(start=(-0.25, -0.2, 1.0), end=(0.25, -0.2, 1.0))
    run = scene.run.replace(duration=0.5)
    result = rw.simulate(scene.replace(ropes=[rope.replace(shape=aside)], run=run))
    assert result.obstacle_force[-1].any()
    assert np.abs(result.positions[-1, :, 2]).max() < 0.1 * D
    assert result.pulley("plank").angle[-1] == pytest.approx(1.65, rel=0.01)
    assert ABOUT not in result.table
