"""Obstacles: Coulomb friction that sticks, against closed forms.

An incline holds below atan mu and lets slide with g (sin - mu cos) above; a sliding body stops after
v^2 / (2 mu g). Drums: `test_capstan`.
"""

from __future__ import annotations

import math
from typing import Any

import numpy as np
import pytest

import ropewalk as rw
from ropewalk.core import arrays
from ropewalk.core.arrays import Floats, flatten
from ropewalk.core.status import OK
from ropewalk.laws.contact import contact_forces
from ropewalk.laws.contact_tangent import contact_tangent
from ropewalk.laws.polygon import on_polygon, tilted
from ropewalk.laws.tangent import law_band
from ropewalk.lowering import build
from ropewalk.lowering.obstacle_checks import touches
from ropewalk.methods.registry import METHODS
from ropewalk.scene import (
    Box,
    Capsule,
    Cylinder,
    Force,
    Ground,
    HalfPipe,
    Material,
    Mesh,
    Obstacle,
    Plane,
    Points,
    Rope,
    RunSettings,
    Scene,
    Sphere,
    Spin,
    Torus,
)
from ropewalk.simulation import Simulation

g = 9.81
MU = 0.3
ABLE = tuple(name for name in METHODS if touches(name) and name not in ("euler", "heun"))
BODIES: dict[str, Obstacle] = {
    "plane": Plane(normal=(0.3, 0.2, 1), spin=Spin(rate=2.0)),
    "sphere": Sphere(center=(0, 0, 0), radius=1.0, axis=(1, 1, 0), spin=Spin(rate=2.0)),
    "cylinder": Cylinder(start=(0, -1, -0.6), end=(0.2, 1, 0.5), radius=0.6, spin=Spin(rate=-3.0)),
    "endless": Cylinder(start=(0, -1, 0), end=(0, 1, 0.5), radius=0.8, endless=True),
    "capsule": Capsule(start=(0, -0.4, -0.2), end=(0.2, 0.4, 0.5), radius=0.6, spin=Spin(rate=1.0)),
    "box": Box(
        center=(0, 0, 0),
        half_sizes=(0.6, 0.7, 0.8),
        edge_radius=0.5,
        axis=(1, 1, 0),
        spin=Spin(rate=2.0),
    ),
    "mesh": Mesh(
        vertices=[(1, 0, 0), (-1, 1, 0), (-1, -1, 0), (0, 0, 1)],
        faces=[(0, 2, 1), (0, 1, 3), (1, 2, 3), (2, 0, 3)],
        rounding=0.3,
        axis=(0.3, -0.2, 1),
        spin=Spin(rate=-3.0),
    ),
    "half-pipe": HalfPipe(
        start=(0, 0, 0), end=(1, 1, -2), radius=0.7, open_to=(1, 1, 1), spin=Spin(rate=2.0)
    ),
    "torus": Torus(
        center=(0, 0, 0), radius=0.8, bar_radius=0.3, axis=(0, 0.3, 1), spin=Spin(rate=1.0)
    ),
}


def incline(
    degrees: float, method: str, *, speed: float = 0.0, **more: Any
) -> tuple[Scene, Floats]:
    """A straight rope of 0.3 m on an incline, and the direction down it, (3,)."""
    slope = math.radians(degrees)
    down = np.array([math.cos(slope), 0.0, -math.sin(slope)])
    shape = Points(points=[tuple(0.05 * i * down) for i in range(7)], velocity=tuple(speed * down))
    rope = Rope(segments=6, length=0.3, made_of=Material(EA=1e3, mass_per_length=0.1), shape=shape)
    step = {"time_step": 1.0 / 60.0} if METHODS[method].implicit else {}
    run = RunSettings(**({"duration": 5.0, "frame_rate": 60.0, "method": method} | step | more))
    plane = Plane(normal=(math.sin(slope), 0.0, math.cos(slope)), friction=MU)
    return Scene(ropes=[rope], obstacles=[plane], run=run), down


def moved(scene: Scene) -> float:
    """How far any node moves from 1 s to 5 s [m]."""
    simulation = Simulation(scene)
    assert simulation.advance_frames(60).status == OK
    before = simulation.positions.copy()
    assert simulation.advance_frames(240).status == OK
    return float(np.abs(simulation.positions - before).max())


@pytest.mark.parametrize("method", ABLE)
def test_an_incline_below_the_angle_of_friction_holds(method: str) -> None:
    """atan 0.3 = 16.70 degrees: at 16.5 nothing moves by 1e-6 mm in four seconds."""
    assert moved(incline(16.5, method)[0]) < 1e-9


def test_viscous_friction_creeps_where_a_plane_holds() -> None:
    """The twin: 0.28 of the weight moves a rope on NeHe's ground, and none on a plane of mu = 0.3."""
    scene, _ = incline(0.0, "esdirk3")
    rope = scene.ropes[0]
    share = np.array([0.5, *[1.0] * 5, 0.5]) * rope.total_mass / 6.0
    forces = [Force(node=i, force=(0.28 * g * m, 0.0, 0.0)) for i, m in enumerate(share)]
    pushed = scene.replace(ropes=[rope.replace(forces=forces)])
    assert moved(pushed) < 1e-9
    assert moved(pushed.replace(obstacles=[], ground=Ground())) > 1e-2


@pytest.mark.parametrize("degrees", [16.9, 25.0])
@pytest.mark.parametrize("method", ABLE)
def test_an_incline_above_it_lets_slide(degrees: float, method: str) -> None:
    """a = g (sin - mu cos), to 1e-5."""
    scene, down = incline(degrees, method)
    simulation = Simulation(scene)
    share = (
        simulation.arrays.mass / simulation.arrays.mass.sum()
    )  # all is at one speed but for waves
    simulation.advance_frames(30)
    first = float(share @ simulation.velocities @ down)
    simulation.advance_frames(30)
    slope = math.radians(degrees)
    expected = g * (math.sin(slope) - MU * math.cos(slope))
    found = (float(share @ simulation.velocities @ down) - first) / 0.5
    assert found == pytest.approx(expected, rel=1e-5)


@pytest.mark.parametrize(("method", "within"), [("implicit-euler", 0.06), ("esdirk3", 0.006)])
def test_sliding_stops_where_it_should(method: str, within: float) -> None:
    """From 1 m/s after v^2 / (2 mu g) = 169.89 mm; friction then has taken m v^2 / 2."""
    scene, down = incline(0.0, method, speed=1.0, duration=1.0)
    result = rw.simulate(scene)
    way = float(((result.positions[-1] - result.positions[0]) @ down).mean())
    assert way == pytest.approx(1.0 / (2.0 * MU * g), rel=within)
    energy = 0.5 * scene.ropes[0].total_mass
    assert float(result.work["obstacle"][-1]) == pytest.approx(-energy, rel=2e-3)
    assert np.abs(result.velocities[-1]).max() < 1e-9


def zigzag(degrees: float, method: str, **more: Any) -> Scene:
    """A rope of 0.8 m, laid out on an incline with a right angle at every node."""
    slope = math.radians(degrees)
    down, up = (
        np.array([math.cos(slope), 0, -math.sin(slope)]),
        (math.sin(slope), 0, math.cos(slope)),
    )
    leg, steps = 0.1 / math.sqrt(2.0), np.arange(9)
    places = leg * np.outer(steps, down)
    places[:, 1] += leg * (steps % 2)
    rope = Rope(
        segments=8,
        length=0.8,
        diameter=0.01,
        made_of=Material(EA=1e4, mass_per_length=0.1, axial_damping=5.0),
        shape=Points(points=(places + 0.005 * np.array(up)).tolist()),
    )
    step = {"time_step": 1.0 / 240.0} if METHODS[method].implicit else {}
    run = RunSettings(**({"duration": 1.0, "frame_rate": 60.0, "method": method} | step | more))
    return Scene(ropes=[rope], obstacles=[Plane(normal=up, friction=MU)], run=run)


@pytest.mark.parametrize("method", ["semi-implicit-euler", "esdirk3", "bdf2"])
@pytest.mark.parametrize("slope", [0.295, 0.305])
def test_friction_on_a_slope_is_that_of_a_straight_rope(slope: float, method: str) -> None:
    """Bends within the surface take nothing of it: below mu nothing slides, above all of it as a body.

    They were taken for turns about it: 0.77 mu at a right angle, at every other node, as rounding had it.
    """
    angle = math.atan(slope)
    simulation = Simulation(zigzag(math.degrees(angle), method))
    before = simulation.positions.copy()
    assert simulation.advance_frames(60).status == OK
    way = np.linalg.norm(simulation.positions - before, axis=1)
    slides = 0.5 * g * (math.sin(angle) - MU * math.cos(angle))
    assert way == pytest.approx(max(slides, 0.0), abs=1e-4)  # it sinks in by 0.05 mm


# -- the law ---------------------------------------------------------------------------------


@pytest.mark.parametrize("turn", [1e-8, 0.1, 0.5, math.pi / 2])
def test_a_nodes_friction_is_that_of_its_arc(turn: float) -> None:
    for mu in (0.2, 0.5, 0.9):
        slope = on_polygon(mu, turn) * math.tan(0.5 * turn)
        assert (1.0 + slope) / (1.0 - slope) == pytest.approx(math.exp(mu * turn), rel=1e-12)


@pytest.mark.parametrize(("rise", "fall"), [(0.0, 0.1), (0.05, 0.05), (0.1, -0.06), (-0.02, 0.1)])
def test_off_the_middle_of_its_turn_it_is_so_too(rise: float, fall: float) -> None:
    """Whichever way tension grows; without, it errs by the turn times the angle off the middle."""
    mu, turn, off = 0.3, rise + fall, (rise - fall) / 2.0
    middle = on_polygon(mu, turn)
    for ahead in (1.0, -1.0):
        for counts, within in ((off, 1e-12), (0.0, 1.2 * turn * abs(off) + 1e-12)):
            q = ahead * math.atan(tilted(middle, counts, ahead))
            grows = math.log(math.cos(rise - q) / math.cos(fall + q))
            assert abs(grows - ahead * mu * turn) <= within
            assert counts != 0.0 or off == 0.0 or abs(grows - ahead * mu * turn) > 0.5 * within


@pytest.mark.parametrize("share", [0.0, 0.4])
@pytest.mark.parametrize("name", BODIES)
def test_tangents_are_the_derivatives_of_the_forces(name: str, share: float) -> None:
    """Central differences, for contacts that stick, slip and throw back, on bodies at rest and turning.

    With velocities of the time, with means of an implicit Euler step, and of a first stage of a longer one.
    """
    rng = np.random.default_rng(1)
    body = BODIES[name].replace(friction=0.4, compliance=0.02, restitution=share)
    rope = Rope(segments=4, length=4.0, made_of=Material(EA=1.0, mass_per_length=0.1), diameter=0.3)
    far = rope.replace(shape=Points(points=[(9.0, 9.0, 9.0 + i) for i in range(5)]))
    model = build(Scene(ropes=[far], obstacles=[body], run=RunSettings(method="adaptive")))
    system, state = model.system, arrays.copy(model.state)
    table, memory = system.node.obstacle, state.memory.obstacle
    now, touched = np.array([0.35, 0.3]), 0
    band = law_band(5)

    def force(x: Floats, v: Floats) -> Floats:
        found = np.zeros((3, 5))
        contact_forces(x, v, table, memory, now, found, 0, 5)
        return found

    for draw in range(30):
        memory.until[0] = (0.0, now[0], 0.42)[draw % 3]
        x = rng.normal(size=(3, 5))
        x *= rng.uniform(0.5, 1.1, 5) / np.linalg.norm(x, axis=0)
        v = 0.5 * rng.normal(size=(3, 5))
        memory.place[:] = x + 0.05 * rng.normal(size=(3, 5))
        memory.grip[:, :3] = 2.0 * rng.normal(size=(1, 3, 5))
        touched += int(np.count_nonzero(np.abs(force(x, v)).max(axis=0)))
        for weights in ((1.0, 0.0), (0.0, 1.0)):
            band.diagonal[:] = 0.0
            contact_tangent(x, v, table, memory, now, *weights, band)
            for c in range(3):
                step = np.zeros((3, 5))
                step[c] = 1e-6
                dx, dv = weights[0] * step, weights[1] * step
                slope = (force(x - dx, v - dv) - force(x + dx, v + dv)) / 2e-6
                found = band.diagonal.reshape(5, 3, 3)[:, :, c].T
                assert np.abs(slope - found).max() < 1e-5 * max(np.abs(slope).max(), 1.0)
    assert touched > 50


def pile(seed: int, **more: Any) -> Scene:
    """A random rope that falls over random bodies."""
    rng = np.random.default_rng(seed)
    steps = rng.normal(size=(31, 3)) * (1.0, 1.0, 0.1)
    steps *= 0.03 / np.linalg.norm(steps, axis=1)[:, None]
    points = np.cumsum(steps, axis=0)
    points -= points.mean(axis=0) - (0.0, 0.0, 0.45)
    rope = Rope(
        segments=30,
        length=0.9,
        diameter=0.01,
        made_of=Material(EA=float(10 ** rng.uniform(3, 5)), mass_per_length=0.1, EI=1e-4),
        shape=Points(points=[tuple(map(float, point)) for point in points]),
    )
    mu = float(rng.uniform(0.0, 0.8))
    bodies: list[Obstacle] = [
        Plane(friction=mu),
        Sphere(center=(0.1, 0, 0.1), radius=0.15, friction=mu),
        Capsule(start=(-0.2, -0.3, 0.2), end=(-0.1, 0.3, 0.15), radius=0.08, friction=mu),
    ]
    run = RunSettings(**({"duration": 1.0, "frame_rate": 60.0, "method": "esdirk3"} | more))
    return Scene(ropes=[rope], obstacles=bodies, run=run)


@pytest.mark.parametrize("method", ["implicit-euler", "esdirk3", "bdf2"])
@pytest.mark.parametrize("seed", range(4))
def test_friction_never_puts_energy_in(seed: int, method: str) -> None:
    """Bodies at rest only take work, but for what they have stored; all of it is booked."""
    result = rw.simulate(pile(seed, method=method))
    assert np.isfinite(result.positions).all()
    work = result.work["obstacle"]
    scale = float(np.ptp(result.energy["gravity"]))
    assert work[-1] < 0.0
    assert np.diff(work).max() < 0.02 * scale
    assert np.abs(result.contact_force).max() > 0.0


def test_a_snapshot_goes_on_to_the_same_bits() -> None:
    """With contacts that stick, slip and close."""
    simulation = Simulation(pile(1))
    simulation.advance_frames(25)
    kept = simulation.state
    simulation.advance_frames(10)
    first = {name: part.copy() for name, part in flatten(simulation.arrays).items()}
    simulation.restore(kept)
    simulation.advance_frames(10)
    last = flatten(simulation.arrays)
    assert [
        n for n, part in last.items() if not np.array_equal(part, first[n], equal_nan=True)
    ] == []
    assert simulation.arrays.memory.obstacle.grip[:, 4].max() > 0.0


def test_beside_another_rope_it_moves_as_alone() -> None:
    scene = pile(1)
    other = pile(2).ropes[0].replace(name="other")
    alone, both = (
        Simulation(scene),
        Simulation(scene.replace(ropes=[scene.ropes[0].replace(name="one"), other])),
    )
    for simulation in (alone, both):
        simulation.advance_frames(40)
    assert np.array_equal(alone.positions, both.positions[:31])
    one, two = alone.arrays.memory.obstacle, both.arrays.memory.obstacle
    assert np.array_equal(one.grip, two.grip[:, :, :31])


@pytest.mark.parametrize("surface", [None, 0.1, 0.4])
def test_adaptive_steps_end_where_slipping_ends(surface: float | None) -> None:
    """From 1 m/s; and on a plane that moves at 0.1 or 0.4 m/s for a quarter of a second: u t1 / 2 while the
    rope is not as fast, the plane's way, u^2 / (2 mu g) after it stopped. 2 mm were missing where a step went
    on beyond the stop.
    """
    scene, down = incline(0.0, "adaptive", speed=0.0 if surface else 1.0, time_step=0.1)
    slows = MU * g
    expected = 1.0 / (2.0 * slows)
    if surface:
        motion = {"kind": "velocity", "velocity": (surface, 0, 0), "start": 0.05, "stop": 0.3}
        plane = Plane(normal=(0, 0, 1), friction=MU, motion=motion)
        scene = scene.replace(obstacles=[plane])
        late = surface / slows
        expected = surface * (0.5 * late + 0.25 - late + 0.5 * late)
    simulation = Simulation(scene)
    first = simulation.positions.copy()
    simulation.advance_frames(36)
    way = float(((simulation.positions - first) @ down).mean())
    assert way == pytest.approx(expected, abs=2e-5)
