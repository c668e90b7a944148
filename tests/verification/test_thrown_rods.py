"""Rods that are thrown at bodies which stand, or kicked: steps that are far too long may lose energy, and
make none.
"""

from __future__ import annotations

import os

import pytest

from ropewalk.laws.obstacle_pose import all_stand
from ropewalk.lowering import build
from ropewalk.scene import Cylinder, Scene, SceneError, Shake, Spin
from ropewalk.simulation.simulation import Broken
from verification.thrown_rods import METHODS, kicked_rod, most_risen, thrown_rod

MOST = 0.01  # [1] of the energy that there is
SCENES = int(os.environ.get("ROPEWALK_THROWN_RODS", "150"))
#: Seeds of the worst of 4500, which rose by 1.8 to 12 % of their energy, and of all forms of body.
WORST = (898, 3232, 3016, 246, 2057, 2643, 914, 1890, 2257, 1696, 2404, 121, 3613, 415)
KICKED = (462, 427, 315, 980, 123, 186, 295, 1362)  # of 1500: 33 % and 4.8 to 8 %


@pytest.mark.parametrize("seed", WORST)
def test_what_thrown_rods_made_up_is_made_no_more(seed: int) -> None:
    assert most_risen(thrown_rod(seed)) < MOST


@pytest.mark.parametrize("seed", KICKED)
def test_what_kicked_rods_made_up_is_made_no_more(seed: int) -> None:
    assert most_risen(kicked_rod(seed)) < MOST


def test_no_rod_makes_energy_of_a_body_that_stands() -> None:
    risen, methods = {}, set()
    for seed in range(SCENES):
        scene = thrown_rod(seed)
        try:
            risen[seed] = most_risen(scene)
        except (SceneError, Broken):  # drawn into itself, or segments that would go through an edge
            continue
        methods.add(scene.run.method)
    assert {seed: rise for seed, rise in risen.items() if rise > MOST} == {}
    assert len(risen) > 0.9 * SCENES
    assert methods == set(METHODS)


def test_bodies_that_may_give_are_told_from_those_that_stand() -> None:
    bar = {"start": (0, -1, 0), "end": (0, 1, 0), "radius": 0.1}
    still = Cylinder(**bar)
    base = thrown_rod(0)
    for body, stands in (
        (still, True),
        (still.replace(motion=Shake(axis=(0, 0, 1), amplitude=0.01, frequency=5.0)), False),
        (still.replace(spin=Spin(rate=2.0)), False),
    ):
        scene: Scene = base.replace(obstacles=[still, body])
        assert all_stand(build(scene).system.node.obstacle) == stands
