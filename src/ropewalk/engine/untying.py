"""Dampers of obstacles, which are made for what a joint ties to a node, as long as it does."""

from __future__ import annotations

import numpy as np

from ropewalk.core.arrays import State
from ropewalk.laws.contact_frame import DAMP
from ropewalk.laws.obstacle import Obstacles
from ropewalk.lowering import Model
from ropewalk.lowering.dampers import suited


def suit_dampers(model: Model, table: Obstacles, state: State) -> None:
    """Make the dampers of a table for what is tied now, and those that contacts have in the next step.

    Where contacts harden that one is as it was: it depends on how deep they are, and is found after the step.
    """
    if not (state.tied.size and table.kind.size):
        return
    table.damping[:] = suited(table, model.scene, model.layout, model.state.mass, state.tied)
    alike = np.flatnonzero((table.hard == 0.0).all(axis=1))
    state.memory.obstacle.grip[alike, DAMP] = table.damping[alike]
