"""Friction of the first and the last node on a round is more than none, however much there is."""

from __future__ import annotations

import math

import numpy as np
import pytest

from ropewalk.laws.contact_frame import GROWS, friction_at
from ropewalk.laws.polygon import FINE, counting, on_polygon, tilted
from ropewalk.scene import Cylinder, Load, Material, Points, Rope, RunSettings, Scene
from ropewalk.simulation import Simulation


@pytest.mark.parametrize("friction", [0.01, 0.3, 1.0, 5.7, 20.0, 100.0])
@pytest.mark.parametrize("side", [-1.0, 1.0])
@pytest.mark.parametrize("ahead", [-1.0, 1.0])
def test_friction_never_turns_round(friction: float, side: float, ahead: float) -> None:
    """Beyond a right angle it were less than none in every other step: the node would let go."""
    for step in (0.01, 0.13, 0.98 * FINE):
        middle = on_polygon(friction, 0.5 * step)  # the first turns by less than a segment
        most = counting(step, middle)
        assert 0.0 < most <= 0.5 * step
        found = tilted(middle, side * most, ahead)
        assert 0.0 < found < math.inf
        assert (found > middle) == (side * ahead > 0.0)


def test_nothing_counts_on_the_inside_of_a_ring_nor_with_long_segments() -> None:
    for step in (-0.1, 0.0, 1.05 * FINE):
        assert counting(step, 0.3) == 0.0
    assert counting(0.1, 0.3) > 0.0


@pytest.mark.parametrize("method", ["implicit-euler", "esdirk3"])
def test_friction_stays_that_of_some_place_however_long_the_next_step(method: str) -> None:
    """A rope that runs over a drum: what its first and last node rub with grows from step to step.

    Half a segment's angle off the middle is the most. Steps of adaptive may be several times the one before.
    """
    radius, friction = 0.1, 0.3
    angle = np.linspace(0.0, math.pi, 25)
    round_it = np.array([-radius * np.cos(angle), 0.0 * angle, radius * np.sin(angle)]).T
    length = float(np.linalg.norm(round_it[1] - round_it[0]))
    down = -length * np.arange(1, 21)
    left = np.array([np.full(20, -radius), np.zeros(20), down]).T[::-1]
    right = np.array([np.full(30, radius), np.zeros(30), -length * np.arange(1, 31)]).T
    points = np.vstack([left, round_it, right])
    rope = Rope(
        segments=len(points) - 1,
        length=length * (len(points) - 1),
        diameter=0.01,
        made_of=Material(EA=1e5, mass_per_length=0.1),
        shape=Points(points=points),
        loads=[Load(node=-1, mass=5.0)],
    )
    drum = Cylinder(start=(0, -1, 0), end=(0, 1, 0), radius=radius - 0.005, friction=friction)
    run = RunSettings(duration=1.0, frame_rate=1000.0, time_step=1e-4, method=method)
    simulation = Simulation(Scene(ropes=rope, obstacles=[drum], run=run))
    half, met = 0.5 * length / radius, 0
    for _ in range(20):
        simulation.step()
        grip = simulation.arrays.memory.obstacle.grip[0]
        for i in np.flatnonzero(grip[GROWS]):
            met += 1
            for since in (1e-4, 1e-3, 0.1):
                found = friction_at(grip, i, since)
                assert 0.0 < found < math.tan(math.atan(friction) + 1.001 * half)
    assert met > 20
