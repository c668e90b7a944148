"""Nothing passes through an obstacle, however fast and however long the step; what would is told."""

from __future__ import annotations

import math
from typing import Any

import numpy as np
import pytest

from ropewalk.scene import (
    Anchor,
    Box,
    Cylinder,
    Material,
    Mesh,
    Obstacle,
    Plane,
    Polyline,
    Rope,
    RunSettings,
    Scene,
    SceneError,
    Straight,
    Table,
    Torus,
)
from ropewalk.simulation import Broken, Simulation

IMPLICIT = ("implicit-euler", "esdirk3", "sdirk2", "bdf2")
POST = Cylinder(name="post", start=(0, -2, -0.01), end=(0, 2, -0.01), radius=0.03, friction=0.2)
PLATE = Box(name="plate", center=(0, 0, 0), half_sizes=(1, 1, 0.01), edge_radius=0.005)
RING = Torus(name="ring", center=(0, 0, 0), axis=(0, 0, 1), radius=0.2, bar_radius=0.02)
FRAME = 1.0 / 60.0


def thrown(body: Obstacle, speed: float, method: str, **more: Any) -> Scene:
    """A rope of 1 m along x, 0.3 m above the middle of a body, that flies down at `speed`."""
    stuff = Material(EA=1e4, mass_per_length=0.1, axial_damping=1.0)
    shape = Straight(start=(-0.5, 0.004, 0.3), end=(0.5, 0.004, 0.3), velocity=(0, 0, -speed))
    rope = Rope(segments=40, length=1.0, diameter=0.01, made_of=stuff, shape=shape)
    run = RunSettings(method=method, time_step=FRAME, frame_rate=60.0)
    return Scene(ropes=[rope], obstacles=[body], run=run.replace(**more))


def crossings(x: np.ndarray, side: float) -> int:
    """How often a rope, (n, 3), crosses the plane x = 0 above (1) or below (-1) a post's axis."""
    a, b = x[:-1], x[1:]
    hits = (a[:, 0] < 0.0) != (b[:, 0] < 0.0)
    part = a[hits, 0] / (a[hits, 0] - b[hits, 0])
    height = a[hits, 2] + part * (b[hits, 2] - a[hits, 2])
    return int((side * height > 0.0).sum())


@pytest.mark.parametrize("speed", [5.0, 20.0, 50.0])
@pytest.mark.parametrize("method", IMPLICIT)
def test_a_rope_thrown_at_a_post_hangs_over_it(method: str, speed: float) -> None:
    """At one step a frame the way in a step is up to 28 radii; 5 m/s went through before."""
    simulation = Simulation(thrown(POST, speed, method))
    for _ in range(12):
        simulation.step(FRAME)
        assert crossings(simulation.positions, 1.0) % 2 == 1
        assert (
            crossings(simulation.positions, -1.0) % 2 == 0
        )  # its halves may swing through each other


@pytest.mark.parametrize("speed", [5.0, 50.0])
def test_a_plate_stops_it(speed: float) -> None:
    simulation = Simulation(thrown(PLATE, speed, "implicit-euler"))
    for _ in range(6):
        simulation.step(FRAME)
        assert (simulation.positions[:, 2] > 0.0).all()


def at_ring(speed: float, **more: Any) -> Simulation:
    """A rope of fine segments, as only nodes touch, thrown at a ring."""
    scene = thrown(RING.replace(**more), speed, "implicit-euler")
    return Simulation(scene.replace(ropes=[scene.ropes[0].replace(segments=100)]))


@pytest.mark.parametrize(("speed", "frames"), [(5.0, 6), (50.0, 1)])
def test_a_ring_stops_what_meets_its_bar_and_lets_through_the_rest(
    speed: float, frames: int
) -> None:
    simulation = at_ring(speed, compliance=1e-5)
    for _ in range(frames):
        simulation.step(FRAME)
    for side in (-1.0, 1.0):
        from_bar = simulation.positions - (0.2 * side, 0.0, 0.0)
        assert crossings(from_bar, 1.0) % 2 == 1  # below it the ends are flung round
    assert simulation.positions[0, 2] < 0.0
    assert speed == 50.0 or simulation.positions[50, 2] < 0.0  # what is fast springs back


def test_a_thread_without_thickness_lies_on_a_mesh_that_is_hardly_rounded() -> None:
    """Hardly a thickness to go by: it may press as deep as its contact gives, and does not pass."""
    s = 0.5
    corners = [(x, y, z) for x in (-s, s) for y in (-s, s) for z in (-0.05, 0.05)]
    faces = [(0, 1, 3), (0, 3, 2), (4, 6, 7), (4, 7, 5), (0, 4, 5), (0, 5, 1), (2, 3, 7), (2, 7, 6)]
    slab = Mesh(
        vertices=corners, faces=[*faces, (0, 2, 6), (0, 6, 4), (1, 5, 7), (1, 7, 3)], rounding=1e-4
    )
    for speed in (1.0, 50.0):
        scene = thrown(slab, speed, "implicit-euler")
        rope = scene.ropes[0].replace(
            length=0.8, shape=scene.ropes[0].shape.replace(end=(0.3, 0.004, 0.3))
        )
        bare = Rope(**rope.model_dump(exclude={"diameter"}))
        simulation = Simulation(scene.replace(ropes=[bare]))
        assert simulation.system.node.obstacle.thickness.max() == 0.0
        for _ in range(30):
            simulation.step(FRAME)
        assert (simulation.positions[:, 2] > 0.04).all()


def test_what_is_pressed_half_way_into_a_solid_ends_in_words() -> None:
    """860 N on 2400 N/m: it went round the bar's middle, step by step. A contact that hardens holds it."""
    at_ring(50.0).step(FRAME)
    simulation = at_ring(50.0, compliance=1.0 / 2400.0)
    with pytest.raises(Broken, match="would go through obstacle 'ring', or too deep into it. Try"):
        simulation.step(FRAME)


def test_the_twin_that_does_not_look_passes() -> None:
    simulation = Simulation(thrown(PLATE, 50.0, "implicit-euler"))
    simulation.system.node.obstacle.thin[:] = math.inf
    for _ in range(3):
        simulation.step(FRAME)
    assert (simulation.positions[:, 2] < -1.0).all()


def test_a_plate_that_is_thrown_at_a_rope_does_not_pass_either() -> None:
    """The way is that against the body: 0.19 m of it in a step are nearly its whole allowed speed."""
    fast = PLATE.replace(half_sizes=(1, 1, 0.2), edge_radius=0.2)
    motion = {"kind": "velocity", "velocity": (0, 0, 11.0)}
    still = thrown(fast.replace(center=(0, 0, -0.2), motion=motion), 0.0, "implicit-euler")
    simulation = Simulation(still)
    for step in range(1, 10):
        simulation.step(FRAME)
        assert (simulation.positions[:, 2] > -0.2 + 11.0 * FRAME * step).all()


def test_a_step_that_was_taken_and_passes_is_told() -> None:
    """Explicit steps are looked at when they are done; here nothing holds the rope back."""
    soft = PLATE.replace(compliance=1e9)
    simulation = Simulation(thrown(soft, 50.0, "semi-implicit-euler", time_step="auto"))
    passed = "node 0 of rope 'rope' has gone through obstacle 'plate', or too deep"
    with pytest.raises(Broken, match=passed):
        simulation.step(0.012)


def test_a_step_that_cannot_be_solved_names_the_obstacle() -> None:
    """Anchors stand where they are put: one is drawn through a plate, and what hangs on it cannot follow."""
    scene = thrown(PLATE, 0.0, "implicit-euler")
    way = Table(
        times=[0.0, 0.01, 0.02], positions=[(-0.5, 0, 0.3), (-0.5, 0, 0.02), (-0.5, 0, -0.3)]
    )
    simulation = Simulation(scene.replace(anchors=[Anchor(node=0, motion=way)]))
    with pytest.raises(
        Broken, match="segment 0 of rope 'rope' would go through .* or another way for what is led"
    ):
        simulation.step(1.0)


def test_a_floor_is_not_looked_at() -> None:
    """It has no other side: its column is inf, and nothing is walked along."""
    simulation = Simulation(
        thrown(Plane(point=(0, 0, 0), normal=(0, 0, 1)), 50.0, "implicit-euler")
    )
    assert simulation.system.node.obstacle.thin[0] == math.inf
    for _ in range(3):
        simulation.step(FRAME)
    assert (simulation.positions[:, 2] > 0.0).all()


# -- between two nodes -----------------------------------------------------------------------

WIRE = Cylinder(name="wire", start=(0.0125, -2, 0), end=(0.0125, 2, 0), radius=0.001)  # half way


def go_on(simulation: Simulation) -> None:
    for _ in range(24):
        simulation.step(FRAME)


def over_wire(speed: float, method: str, segments: int = 40, **more: Any) -> Scene:
    """A rope that flies at a wire; of 40 segments each is 25 mm long, four times as the wire with it."""
    scene = thrown(WIRE, speed, method, **more)
    return scene.replace(ropes=[scene.ropes[0].replace(segments=segments, diameter=0.004)])


@pytest.mark.parametrize("speed", [1.0, 50.0])
@pytest.mark.parametrize("method", [*IMPLICIT, "adaptive", "semi-implicit-euler"])
def test_no_segment_slips_over_a_wire_between_its_nodes(method: str, speed: float) -> None:
    """Nothing pushes there: the run ends in words, and says what would do. It went through, silently."""
    auto = {"time_step": "auto"} if method in ("adaptive", "semi-implicit-euler") else {}
    simulation = Simulation(over_wire(speed, method, **auto))
    words = r"segment 20 of rope 'rope' .* go(ne)? through obstacle 'wire' between .*at most 4.2 mm"
    with pytest.raises(Broken, match=words):
        go_on(simulation)
    if method != "semi-implicit-euler":  # explicit steps are looked at when they are done
        assert simulation.positions[20:22, 2].max() > 0.0


def test_with_the_segments_that_are_asked_for_it_hangs_over_the_wire() -> None:
    simulation = Simulation(over_wire(1.0, "implicit-euler", segments=240))
    for _ in range(24):
        simulation.step(FRAME)
        assert crossings(simulation.positions - (0.0125, 0.0, 0.0), 1.0) % 2 == 1


def test_a_corner_that_a_segment_cuts_is_no_way_through() -> None:
    """It lies on a shelf and hangs over the edge, with segments longer than the shelf is thick."""
    stuff = Material(EA=1e4, mass_per_length=0.1, axial_damping=1.0)
    shape = Polyline(points=[(-0.31, 0, 0.015), (0.04, 0, 0.015), (0.04, 0, -0.235)])
    rope = Rope(segments=20, length=0.6, diameter=0.01, made_of=stuff, shape=shape)
    shelf = PLATE.replace(center=(-0.968, 0, 0), friction=0.5)
    run = RunSettings(method="implicit-euler", time_step=1 / 240, frame_rate=60.0)
    anchors = [Anchor(node=0)]
    simulation = Simulation(Scene(ropes=[rope], anchors=anchors, obstacles=[shelf], run=run))
    for _ in range(60):
        simulation.step(FRAME)
    hangs = simulation.positions[:, 2] < -0.05
    assert 0 < hangs.sum() < 21


def test_a_rope_that_is_drawn_through_a_bar_is_refused() -> None:
    scene = over_wire(1.0, "implicit-euler")
    through = scene.ropes[0].replace(
        shape=Straight(start=(-0.5, 0.004, 0.0), end=(0.5, 0.004, 0.001))
    )
    with pytest.raises(
        SceneError, match="rope.0..shape: .segment 20. - goes through obstacle 'wire'"
    ):
        Simulation(scene.replace(ropes=[through]))
    beside = through.replace(shape=Straight(start=(-0.5, 0.004, 0.01), end=(0.5, 0.004, 0.01)))
    Simulation(scene.replace(ropes=[beside]))
