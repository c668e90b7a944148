"""A rope that starts fast and near a surface is thrown back, from farther out it is not: `check` says so."""

from __future__ import annotations

import math
import re

import numpy as np
import pytest

import ropewalk as rw
from ropewalk.analysis.near_starts import thrown_back
from ropewalk.laws.obstacle import Obstacles
from ropewalk.laws.striking import HARD
from ropewalk.lowering import build
from ropewalk.scene import Anchor, Box, Kick, Material, Plane, Rope, Scene, Spin, Straight

SPEED, HALF = 5.0, 0.005  # [m/s], and half of the rope's diameter [m]


def falling(gap: float, speed: float = SPEED, **more: object) -> Scene:
    """Return a level rope without weight at a gap [m] over a plane, that comes at it with a speed [m/s]."""
    shape = Straight(
        start=(0, 0, gap + HALF), end=(0.4, 0, gap + HALF), velocity=(0.0, 0.0, -speed)
    )
    stuff = Material(EA=2e4, mass_per_length=0.5, axial_damping=20.0)
    rope = Rope(segments=4, length=0.4, diameter=2.0 * HALF, made_of=stuff, shape=shape)
    floor = Plane(name="floor", point=(0, 0, 0), normal=(0, 0, 1), friction=0.3)
    run = {"duration": 0.1, "frame_rate": 100, "method": "implicit-euler", "time_step": 2e-4}
    return Scene(gravity=(0, 0, 0), ropes=[rope], obstacles=[floor], run=run | more)


def told(scene: Scene) -> list[str]:
    return [note for note in rw.check(scene, measure=False).warnings if "thrown back" in note]


RESOLVED = {"method": "esdirk3", "time_step": 2e-5, "duration": 0.01}


@pytest.mark.parametrize(
    ("gap", "share"), [(1e-5, 0.50), (2e-4, 0.49), (2e-3, 0.39), (5e-3, 0.26), (9e-3, 0.12)]
)
def test_it_is_told_with_the_share_that_resolved_steps_throw_back(gap: float, share: float) -> None:
    """It said "up to 0.4 of that", where resolved steps gave 0.5 from a gap of 0.01 mm."""
    scene = falling(gap, **RESOLVED)
    after = float(rw.simulate(scene).velocities[-1, :, 2].max()) / SPEED
    assert after == pytest.approx(share, abs=0.01)
    (note,) = told(scene)
    assert note.startswith("obstacle 'floor': node 1 of rope 'rope' starts ")
    assert f"{1e3 * gap:g} mm off it and comes at it with 5 m/s" in note
    assert f"with about {share:g} of that" in note


def test_long_steps_throw_back_less() -> None:
    after = rw.simulate(falling(1e-5)).velocities[-1, :, 2].max() / SPEED
    assert 0.2 < after < 0.5


def test_from_the_gap_that_is_told_nothing_is_thrown_back() -> None:
    (note,) = told(falling(1e-3))
    enough = re.search(r"let it start (\S+) mm off, or more slowly", note)
    assert enough is not None
    scene = falling(1.01e-3 * float(enough[1]), **RESOLVED)
    assert not told(scene)
    assert rw.simulate(scene).velocities[-1, :, 2].max() < 0.012 * SPEED


def on_its_own(hardness: float) -> Obstacles:
    """Return a contact of a node of 1 kg, critically damped, that gets so many times as hard when pressed."""
    table = build(falling(0.1)).system.node.obstacle
    ones = np.ones_like(table.stiffness)
    return table._replace(stiffness=ones, damping=2.0 * ones, hard=hardness * ones)


def test_a_node_on_its_own_is_thrown_back_as_closed_forms_say() -> None:
    soft = on_its_own(0.0)
    for s in (0.0, 0.3, 0.7):  # critically damped, and linear
        share = (1.0 - s) * math.exp(-2.0 - s / (1.0 - s))
        assert thrown_back(soft, 0, 1, 1.0, s) == pytest.approx(share, rel=1e-3)
    z = HARD  # far beyond the skin of a hard one
    across = math.sqrt(1.0 - z * z)
    share = math.exp(-z / across * (math.pi - math.atan(2.0 * z * across / (1.0 - 2.0 * z * z))))
    assert share == pytest.approx(0.451, abs=1e-3)
    assert thrown_back(on_its_own(1e4), 0, 1, 1e3, 0.0) == pytest.approx(share, rel=0.01)


def test_harder_contacts_throw_back_more_and_there_is_no_bound_for_all() -> None:
    speeds = np.geomspace(1e-5, 1.0, 40)
    most = [
        max(thrown_back(on_its_own(hardness), 0, 1, u, 0.0) for u in speeds)
        for hardness in (10.0, 100.0, 1000.0)
    ]
    assert most == pytest.approx([0.45, 0.53, 0.60], abs=0.01)


def test_what_its_own_weight_holds_down_is_not_told_of() -> None:
    """The plank of docs/how-to/obstacles.md: "starts 1.73e-15 mm off it [...]: it is thrown back"."""
    rope = Rope(
        segments=20,
        length=0.3,
        diameter=0.01,
        made_of=Material(EA=1e4, mass_per_length=0.1, axial_damping=5.0),
        shape=Straight(start=(-0.15, 0, 0.025), end=(0.15, 0, 0.025)),
    )
    plank = Box(center=(0, 0, 0), half_sizes=(0.5, 0.1, 0.02), edge_radius=0.005, axis=(0, 1, 0))
    run = {"method": "esdirk3", "duration": 0.01, "frame_rate": 5000, "time_step": 5e-5}

    def tilted(rate: float) -> Scene:
        return Scene(ropes=[rope], obstacles=[plank.replace(spin=Spin(rate=rate))], run=run)

    assert not told(tilted(0.1))
    force = rw.simulate(tilted(0.1)).contact_force[1:, 0, 2]
    assert force.min() > 0.0  # it stays on it
    (note,) = told(tilted(10.0))
    assert "of rope 'rope' starts on it and comes at it with 1.5 m/s" in note


def test_what_goes_along_a_surface_or_stands_is_not_told_of() -> None:
    assert not told(falling(1e-3, 0.0))
    along = falling(0.0)
    shape = along.ropes[0].shape.replace(velocity=(5.0, 0.0, -0.1))
    assert not told(along.replace(ropes=[along.ropes[0].replace(shape=shape)]))


def at_rest(kick: float = 0.0, rises: float = 0.0) -> Scene:
    """Return a line at rest on a floor, held at its ends: kicked down, or the floor rises [m/s]."""
    stuff = Material(EA=2e4, mass_per_length=0.5, axial_damping=20.0)
    rope = Rope(
        segments=8,
        length=0.4001,
        diameter=2.0 * HALF,
        made_of=stuff,
        shape=Straight(start=(0, 0, 0), end=(0.4, 0, 0)),
        kicks=[Kick(node=node, velocity=(0, 0, -kick)) for node in range(1, 8) if kick],
    )
    motion = {"kind": "velocity", "velocity": (0.0, 0.0, rises)}
    floor = Plane(name="floor", point=(0, 0, -HALF - 1e-3), normal=(0, 0, 1), motion=motion)
    run = {"duration": 0.01, "frame_rate": 1000, "method": "implicit-euler", "time_step": 2e-4}
    ends = [Anchor(node=0), Anchor(node=-1)]
    return Scene(ropes=[rope], anchors=ends, obstacles=[floor], run=run | {"start": "at-rest"})


@pytest.mark.parametrize(("kick", "rises"), [(5.0, 0.0), (0.0, 1.0)])
def test_what_is_at_rest_and_is_struck_is_thrown_back(kick: float, rises: float) -> None:
    """A kick of 5 m/s threw it up with 1.1: `check` said nothing, as what starts at rest has no speed."""
    scene, comes = at_rest(kick, rises), kick + rises
    leaves = rw.simulate(scene).velocities[:, 4, 2].max() - rises
    assert 0.2 * comes < leaves < 0.4 * comes
    (note,) = told(scene)
    assert f"comes at it with {comes:g} m/s" in note
    assert note.endswith("let it start more slowly")  # where it starts statics says
    assert not told(at_rest())
