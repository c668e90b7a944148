"""What is said of a run that cannot go on because two bodies leave a rope no room."""

from __future__ import annotations

import numpy as np

from ropewalk.core.arrays import State, System
from ropewalk.lowering import Layout
from ropewalk.lowering.rooms import tightest
from ropewalk.scene import Scene
from ropewalk.scene.obstacles import name_of


def no_room(system: System, state: State, layout: Layout, scene: Scene) -> str:
    """Say which node two bodies squeeze, where one would go through an obstacle, or has gone; "" for none."""
    memory = state.memory.obstacle
    if not (np.any(memory.through) or np.any(memory.fault)):
        return ""
    free = (state.inverse_mass > 0.0) & (memory.held == 0)
    found = tightest(system.node.obstacle, state.x, float(state.now[1]), free)
    if found is None:
        return ""
    rope, node = layout.rope_of(found.node)
    one, other = (name_of(scene.obstacles[row], row) for row in (found.one, found.other))
    return (
        f"node {node} of rope {rope!r} has no room between obstacles {found.words(one, other)}: move them "
        "apart, let them stop earlier, or take a thinner rope"
    )
