"""The obstacles of a scene as the engine has them: kinds, places, sizes."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from ropewalk.core.arrays import Floats
from ropewalk.laws.contact_frame import surface_at
from ropewalk.laws.obstacle import Obstacles, lower
from ropewalk.laws.obstacle_places import middle_turned
from ropewalk.lowering import Layout
from ropewalk.lowering.touching import at_rates
from ropewalk.scene import Scene

if TYPE_CHECKING:
    from ropewalk.record.result import Result


def obstacle_table(scene: Scene, where: Layout) -> Obstacles | None:
    """Return the table of the obstacles, None where there are none; its stiffness is of no use."""
    if not scene.obstacles:
        return None
    masses = [rope.total_mass for rope in scene.ropes]
    return lower(scene.obstacles, where, scene.ropes, masses, 0.0)


def table_then(result: Result, table: Obstacles, time: float) -> Obstacles:
    """Return obstacles with those that turn freely as they lay at the frame nearest to a time [s]."""
    if not result.layout.pulleys:
        return table
    frame = int(np.abs(result.time - time).argmin())
    return at_rates(table, result.read("pulleys", frame, frame + 1)[0], time)


def obstacle_angles(scene: Scene, where: Layout, times: Floats) -> Floats:
    """Return how far obstacles are turned at some times [s], (times, obstacles) [rad]; 0 of free ones."""
    found = np.zeros((len(times), len(scene.obstacles)))
    table = obstacle_table(scene, where)
    for row in range(len(scene.obstacles)):
        assert table is not None
        found[:, row] = [surface_at(table, row, float(t))[6] for t in times]
    return found


def swings(scene: Scene, where: Layout) -> bool:
    """Tell whether the middle of any obstacle goes about as it turns, its axle beside it."""
    table = obstacle_table(scene, where)
    if table is None:
        return False
    turn = np.array([body.spin is not None for body in scene.obstacles])
    arms = np.cross(table.axle, table.center - table.hub)
    return bool(arms[turn].any())


def obstacle_places(scene: Scene, where: Layout, times: Floats, angles: Floats) -> Floats:
    """Return where the middles of all obstacles are at some times [s], (times, obstacles, 3) [m].

    `angles` (times, obstacles) is how far they have turned then [rad].
    """
    found = np.zeros((len(times), len(scene.obstacles), 3))
    table = obstacle_table(scene, where)
    for row in range(len(scene.obstacles)):
        assert table is not None
        each = zip(times, angles[:, row], strict=True)
        found[:, row] = [middle_turned(table, row, float(t), float(angle)) for t, angle in each]
    return found
