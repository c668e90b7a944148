"""What islands keep: how they began, what hands do to them, copies of them, and where obstacles are now."""

from __future__ import annotations

import copy
import pickle
from collections.abc import Callable

import numpy as np
import pytest

from ropewalk.core.arrays import flatten
from ropewalk.scene import (
    Anchor,
    Material,
    Plane,
    Rope,
    Scene,
    Slack,
    Straight,
    Velocity,
)
from ropewalk.simulation import Simulation


def hung(method: str, ropes: int) -> Simulation:
    """Cords of four segments that swing from one end each."""
    made_of = Material(EA=1e3, mass_per_length=0.1)
    shapes = [Slack(start=(0, k, 0), end=(0.3, k, 0)) for k in range(ropes)]
    made = [
        Rope(name=f"rope{k}", segments=4, length=0.4, made_of=made_of, shape=shape)
        for k, shape in enumerate(shapes)
    ]
    anchors = [Anchor(name=f"end{k}", rope=f"rope{k}", node=0) for k in range(ropes)]
    return Simulation(Scene(ropes=made, anchors=anchors, run={"method": method, "time_step": 1e-3}))


def bits(simulation: Simulation) -> bytes:
    state = simulation.state
    return b"".join(part.tobytes() for part in (*flatten(state.state).values(), state.inner))


def test_an_island_keeps_how_it_began() -> None:
    """Breaks are explained from there."""
    simulation = hung("rk4", 2)
    begun = simulation.alone(0).model.state.x.copy()
    simulation.advance_frames(2)
    assert np.array_equal(simulation.alone(0).model.state.x, begun)
    assert not np.array_equal(simulation.alone(0).positions.T, begun)


@pytest.mark.parametrize("method", ["sdirk2", "adaptive", "verlet"])
@pytest.mark.parametrize("ropes", [1, 2])
def test_islands_go_back_to_time_zero(ropes: int, method: str) -> None:
    """A model keeps the start, whatever its simulation does. Twin: where it stands is not the start."""
    simulation = hung(method, ropes)
    start = bits(simulation)
    simulation.step(0.005)
    stands = bits(simulation)
    assert stands != start
    other = Simulation(simulation.model)
    assert bits(other) == start
    other.step(0.002)
    assert bits(simulation) == stands  # what the steps were looked at for, too
    simulation.reset()
    assert bits(simulation) == start


@pytest.mark.parametrize("ropes", [1, 2])
def test_a_force_on_an_island_takes_the_place_of_the_one_before(ropes: int) -> None:
    simulation = hung("sdirk2", ropes)
    for force in (2.0, 0.5):
        simulation.apply_force(3, (force, 0.0, 0.0), "rope0")
    assert simulation.applied_forces[3].tolist() == [0.5, 0.0, 0.0]
    assert simulation.applied_forces.sum() == 0.5


@pytest.mark.parametrize(
    "again", [copy.copy, copy.deepcopy, lambda one: pickle.loads(pickle.dumps(one))]
)
@pytest.mark.parametrize(("method", "ropes"), [("sdirk2", 1), ("sdirk2", 2), ("verlet", 2)])
def test_a_copy_goes_its_own_way_to_the_same_bits(
    method: str, ropes: int, again: Callable[[Simulation], Simulation]
) -> None:
    simulation = hung(method, ropes)
    simulation.step(0.003)
    simulation.anchors["end0"].move_to((0.0, 0.0, 0.1))
    stood = bits(simulation)
    other = again(simulation)
    assert bits(other) == stood
    other.step(0.002)
    assert bits(simulation) == stood
    assert bits(other) != stood
    simulation.step(0.002)
    assert bits(other) == bits(simulation)
    assert other.positions[0].tolist() == [0.0, 0.0, 0.1]


def on_floor(motion: Velocity, ropes: int = 2, friction: float = 0.3) -> Scene:
    """Ropes of 30 cm that lie beside each other on a floor that moves."""
    made_of = Material(EA=2000.0, mass_per_length=0.2, axial_damping=0.5)
    shapes = [Straight(start=(0, k, 0.006), end=(0.3, k, 0.006)) for k in range(ropes)]
    lying = [
        Rope(name=f"rope{k}", segments=3, length=0.3, diameter=0.01, made_of=made_of, shape=shape)
        for k, shape in enumerate(shapes)
    ]
    run = {"method": "esdirk3", "time_step": 5e-3, "frame_rate": 200.0}
    return Scene(ropes=lying, obstacles=[Plane(friction=friction, motion=motion)], run=run)


def test_a_frame_is_read_with_obstacles_where_they_are_now() -> None:
    """Of ropes on a floor that rises what contacts press was read with the floor of the start: 0 N."""
    simulation = Simulation(on_floor(Velocity(velocity=(0.0, 0.0, 0.5)), ropes=2))
    block = simulation.advance_frames(5)
    assert np.array_equal(simulation.recording().recording.contact[-1], block.recording.contact[-1])
    assert simulation.recording().recording.contact[-1, 2].min() > 0.05  # N
