"""The obstacles of a scene as the engine has them: kinds, places, sizes."""

from __future__ import annotations

from ropewalk.laws.obstacle import Obstacles, lower
from ropewalk.lowering import Layout
from ropewalk.scene import Scene


def obstacle_table(scene: Scene, where: Layout) -> Obstacles | None:
    """Return the table of the obstacles, None where there are none; its stiffness is of no use."""
    if not scene.obstacles:
        return None
    masses = [rope.total_mass for rope in scene.ropes]
    return lower(scene.obstacles, where, scene.ropes, masses)
