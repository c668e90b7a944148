"""Obstacles that move: what they do to ropes, against closed forms.

A body that moves at one velocity does to a rope what one at rest does to it in the moving frame; one that is
accelerated adds to gravity; a plane that shakes a rope sideways carries it below mu g and slips beneath it
above; and what it does to the energy is its force times its way.
"""

from __future__ import annotations

import base64
import math
import re
from pathlib import Path
from typing import Any

import numpy as np
import pytest

import ropewalk as rw
from ropewalk.core.arrays import Floats, flatten
from ropewalk.lowering import build
from ropewalk.record.export import export
from ropewalk.scene import (
    Capsule,
    Cylinder,
    Load,
    Material,
    Obstacle,
    Orbit,
    Plane,
    Points,
    Rope,
    RunSettings,
    Scene,
    SceneError,
    Shake,
    Sphere,
    Spin,
    Table,
    Velocity,
)
from ropewalk.simulation import Simulation

g, MU = 9.81, 0.3
SPRINGS = Material(EA=1e3, mass_per_length=0.1)


def lying(body: Obstacle, *, speed: Any = (0.0, 0.0, 0.0), **run: Any) -> Scene:
    """A rope of 0.3 m along x on a level plane, whose nodes move at a speed."""
    settings = {"duration": 1.0, "frame_rate": 60.0, "time_step": 1.0 / 240.0, "method": "esdirk3"}
    shape = Points(points=[(0.05 * i, 0.0, 0.0) for i in range(7)], velocity=speed)
    rope = Rope(segments=6, length=0.3, made_of=SPRINGS, shape=shape)
    return Scene(ropes=[rope], obstacles=[body], run=RunSettings(**(settings | run)))


def share(scene: Scene) -> Floats:
    """What part of the mass each node of the only rope has, (n,)."""
    found = np.ones(scene.ropes[0].nodes)
    found[[0, -1]] = 0.5
    return found / found.sum()


# -- the same in a moving frame ------------------------------------------------------------------


@pytest.mark.parametrize(
    ("method", "step", "within"),
    [("implicit-euler", 1 / 60, 1e-9), ("semi-implicit-euler", 1e-4, 1e-9)],
)
def test_a_body_at_one_velocity_does_what_one_at_rest_does(
    method: str, step: float, within: float
) -> None:
    """A rope falls on a bar that spins, both at rest or both at (0.7, -0.3, 0.2) m/s: the same way."""
    u = np.array([0.7, -0.3, 0.2])
    found = []
    for speed in (np.zeros(3), u):
        points = [(0.05 * i - 0.13, 0.0, 0.06) for i in range(7)]
        shape = Points(points=points, velocity=tuple(map(float, speed)))
        rope = Rope(segments=6, length=0.3, made_of=SPRINGS, shape=shape, diameter=0.01)
        bar = Capsule(
            start=(0, -1, 0), end=(0, 1, 0), radius=0.05, friction=MU, spin=Spin(rate=3.0),
            motion=Velocity(velocity=tuple(map(float, speed))),
        )  # fmt: skip
        run = RunSettings(duration=0.2, frame_rate=60.0, method=method, time_step=step)
        simulation = Simulation(Scene(ropes=[rope], obstacles=[bar], run=run))
        simulation.advance_frames(12)
        found.append(simulation.positions - speed * simulation.time)
        assert np.abs(simulation.arrays.forces.node.obstacle).max() > 0.0
    np.testing.assert_allclose(found[1], found[0], atol=within)


# -- acceleration --------------------------------------------------------------------------------


@pytest.mark.parametrize("share_of_limit", [0.9, 1.2])
def test_a_plane_that_is_pushed_aside_carries_up_to_mu_g(share_of_limit: float) -> None:
    """x = a t^2 / 2 by a table: below mu g the rope goes along, above it at mu g."""
    a = share_of_limit * MU * g
    times = [0.0, *np.linspace(0.3, 0.9, 61)]
    places = [(0.5 * a * max(t - 0.3, 0.0) ** 2, 0.0, 0.0) for t in times]
    motion = Table(times=times, positions=places, interpolation="cubic")
    scene = lying(Plane(friction=MU, motion=motion))
    simulation = Simulation(scene)
    simulation.advance_frames(24)
    before = float(share(scene) @ simulation.velocities[:, 0])
    simulation.advance_frames(24)
    found = (float(share(scene) @ simulation.velocities[:, 0]) - before) / 0.4
    assert found == pytest.approx(min(a, MU * g), rel=2e-3)


@pytest.mark.parametrize("share_of_limit", [0.9, 2.0])
def test_a_plane_that_shakes_slips_above_mu_g(share_of_limit: float) -> None:
    """Below mu g the rope goes with it; above it rubs with mu m g all the time where it slips.

    With the largest acceleration a, friction holds mu g at most: nodes never get more than that.
    """
    frequency = 2.0
    amplitude = share_of_limit * MU * g / (2.0 * math.pi * frequency) ** 2
    motion = Shake(axis=(1, 0, 0), amplitude=amplitude, frequency=frequency, phase=0.5 * math.pi)
    result = rw.simulate(lying(Plane(friction=MU, motion=motion), duration=2.0))
    late = result.time > 0.5
    plane = result.obstacle_positions()[:, 0, 0]
    over = result.positions[:, 3, 0] - plane
    if share_of_limit < 1.0:
        assert np.ptp(over[late]) < 1e-4  # the springs of contacts give, 0.02 mm each way
    else:
        assert np.ptp(over[late]) > 0.1 * amplitude
        rate = np.diff(result.velocities[late] @ np.array([1.0, 0, 0]) @ share(result.scene))
        assert np.abs(rate * 60.0).max() == pytest.approx(MU * g, rel=0.02)


def test_a_floor_that_rises_faster_and_faster_adds_to_gravity() -> None:
    """z = b t^2 / 2: the floor carries m (g + b); the work is that force times the way of the floor."""
    b = 3.0
    times = np.linspace(0.0, 1.0, 101)
    places = [(0.0, 0.0, float(0.5 * b * t * t)) for t in times]
    floor = Plane(
        friction=MU, motion=Table(times=tuple(times), positions=places, interpolation="cubic")
    )
    result = rw.simulate(lying(floor))
    mass = result.scene.ropes[0].total_mass
    late = result.time > 0.5
    push = result.contact_force[late][:, :, 2].sum(axis=1)
    np.testing.assert_allclose(push[:-4], mass * (g + b), rtol=2e-3)
    way = result.obstacle_positions()[:, 0, 2]
    work = result.work["obstacle"]
    done = np.diff(work[late])[:-4]
    np.testing.assert_allclose(done, mass * (g + b) * np.diff(way[late])[:-4], rtol=5e-3)
    assert np.abs(result.energy_error).max() < 0.01 * work[-1]
    assert np.abs(result.balance_residual).max() < 1e-12 * work[-1] + 1e-15


def test_an_incline_that_is_accelerated_holds_what_would_slide() -> None:
    """At 25 degrees and mu = 0.3 a rope slides; pushed at g tan(25) uphill it would stay without friction."""
    slope = math.radians(25.0)
    normal = (math.sin(slope), 0.0, math.cos(slope))
    down = np.array([math.cos(slope), 0.0, -math.sin(slope)])
    a = g * math.tan(slope)
    ways = {}
    for push in (0.0, a):
        times = np.linspace(0.0, 1.0, 51)
        places = [(float(0.5 * push * t * t), 0.0, 0.0) for t in times]
        motion = Table(times=tuple(times), positions=places, interpolation="cubic")
        scene = lying(Plane(normal=normal, friction=MU, motion=motion), duration=0.5)
        points = [tuple(map(float, 0.05 * i * down)) for i in range(7)]
        scene = scene.replace(ropes=[scene.ropes[0].replace(shape=Points(points=points))])
        result = rw.simulate(scene)
        over = result.positions - result.obstacle_positions()
        ways[push] = float(((over[-1] - over[0]) @ down).mean())
    assert ways[0.0] == pytest.approx(
        0.5 * g * (math.sin(slope) - MU * math.cos(slope)) * 0.25, rel=0.02
    )
    assert abs(ways[a]) < 1e-4


# -- turning by a table ----------------------------------------------------------------------------


def hanging(**more: Any) -> Scene:
    """Two weights over a drum: 0.3 kg and 0.2 kg, which mu = 1 holds."""
    circle = [
        (0.055 * math.cos(a), 0.0, 0.055 * math.sin(a)) for a in np.linspace(math.pi, 0.0, 25)
    ]
    points = [(-0.055, 0.0, -0.3), *circle, (0.055, 0.0, -0.3)]
    length = 0.6 + 24 * 0.11 * math.sin(math.pi / 48)
    rope = Rope(
        segments=60, length=length, diameter=0.01, shape=rw.scene.Polyline(points=points),
        made_of=Material(EA=1e4, mass_per_length=1e-3, axial_damping=10.0),
        loads=[Load(node=0, mass=0.2), Load(node=-1, mass=0.3)],
    )  # fmt: skip
    drum = Cylinder(start=(0, -1, 0), end=(0, 1, 0), radius=0.05, friction=1.0, **more)
    run = RunSettings(duration=1.0, frame_rate=60.0, method="esdirk3", time_step=1 / 240)
    return Scene(ropes=[rope], obstacles=[drum], run=run)


@pytest.mark.slow
def test_a_drum_lifts_by_turning_and_by_going_up() -> None:
    """By 2 rad it winds 2 R of rope over; lifted by 0.1 m both weights rise by 0.1 m."""
    spin = Spin(times=(0.2, 0.7), angles=(0.0, -2.0), interpolation="cubic")
    up = Table(times=(0.2, 0.7), positions=((0, 0, 0), (0, 0, 0.1)))
    still, turned, lifted = (
        rw.simulate(hanging(**more)).positions[-1, [0, -1], 2]
        for more in ({}, {"spin": spin}, {"motion": up})
    )
    np.testing.assert_allclose(turned - still, [-2 * 0.055, 2 * 0.055], rtol=0.05)
    np.testing.assert_allclose(lifted - still, [0.1, 0.1], rtol=0.02)


def test_turning_by_a_table_is_turning_at_its_rate() -> None:
    """A straight table of angles and the rate give the same run on a turntable."""
    ends = []
    for spin in (Spin(rate=-3.0, start=0.1, stop=0.4), Spin(times=(0.1, 0.4), angles=(0.0, -0.9))):
        table = Plane(friction=MU, spin=spin)
        run = {"method": "implicit-euler", "duration": 0.5, "time_step": 1 / 60}
        ends.append(rw.simulate(lying(table, **run)).positions[-1])
    np.testing.assert_allclose(ends[1], ends[0], atol=1e-9)
    assert np.linalg.norm(ends[0][-1] - (0.3, 0.0, 0.0)) > 0.1


# -- going on, and refusals ------------------------------------------------------------------------


def test_a_snapshot_beside_a_moving_body_goes_on_to_the_same_bits() -> None:
    motion = Orbit(center=(0, 0, 0.02), axis=(0, 1, 0), frequency=1.0)
    simulation = Simulation(
        lying(Sphere(center=(0.15, 0, -0.1), radius=0.1, motion=motion), method="implicit-euler")
    )
    simulation.advance_frames(12)
    kept = simulation.state
    simulation.advance_frames(6)
    first = {name: part.copy() for name, part in flatten(simulation.arrays).items()}
    simulation.restore(kept)
    simulation.advance_frames(6)
    for name, part in flatten(simulation.arrays).items():
        assert np.array_equal(part, first[name], equal_nan=True), name


def refused(body: Obstacle, **run: Any) -> dict[str, str]:
    """The rules of the faults of a scene, by path."""
    with pytest.raises(SceneError) as error:
        build(lying(body, **run))
    return {fault.path: fault.rule for fault in error.value.faults}


def test_a_body_that_is_too_fast_is_refused() -> None:
    """100 m/s is 1.7 m in a step of 1/60 s."""
    fast = Sphere(center=(0, 0, -1), radius=0.5, motion=Velocity(velocity=(100, 0, 0)))
    found = refused(fast, time_step=1 / 60)
    assert "run.time_step of at most 0.005 s" in found["obstacle[0].motion"]
    build(lying(fast, time_step=0.004, frame_rate=50.0))
    build(lying(Plane(motion=Velocity(velocity=(100, 0, 0)))))


@pytest.mark.parametrize(
    ("given", "path"),
    [
        ({}, "rate"),
        ({"rate": 1.0, "angles": (0, 1)}, "angles"),
        ({"times": (0, 1)}, "angles"),
        ({"times": (0, 1), "angles": (0, 1, 2)}, "angles"),
        ({"times": (1, 1), "angles": (0, 1)}, "times[1]"),
        ({"times": (0, 1), "angles": (0, 1), "start": 1.0}, "start"),
    ],
)
def test_a_spin_that_says_too_little_or_too_much_is_refused(given: Any, path: str) -> None:
    with pytest.raises(SceneError) as error:
        Spin(**given)
    assert [fault.path for fault in error.value.faults] == [path]


def test_nobody_holds_an_obstacle_in_a_hand() -> None:
    with pytest.raises(SceneError, match="hand"):
        Plane(motion={"kind": "hand"})


# -- what is recorded ------------------------------------------------------------------------------


def test_places_are_in_the_dataset_and_in_vtk(tmp_path: Path) -> None:
    motion = Velocity(velocity=(0, 0, 0.5), start=0.5)
    scene = lying(Plane(motion=motion), method="implicit-euler")
    result = rw.simulate(scene)
    expected = 0.5 * np.maximum(result.time - 0.5, 0.0)
    places = result.dataset["obstacle_position"]
    np.testing.assert_allclose(places.values[:, 0, 2], expected, atol=1e-12)
    assert places.dims == ("time", "obstacle", "axis")
    export(result, "vtk", tmp_path / "vtk", every=30)
    text = (tmp_path / "vtk" / "frames" / "frame_000060.vtp").read_text()
    packed = re.search(
        r'<FieldData>\s*<DataArray [^>]*Name="obstacle_position"[^>]*>([^<]*)<', text
    )
    assert packed is not None
    found = np.frombuffer(base64.b64decode(packed[1])[8:], "<f8")
    np.testing.assert_allclose(found, [0.0, 0.0, 0.25], atol=1e-12)
    still = rw.simulate(lying(Plane(), method="implicit-euler"))
    assert "obstacle_position" not in still.dataset
