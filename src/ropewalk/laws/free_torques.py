"""What ropes turn the obstacles with that turn freely, from what their contacts carry."""

from __future__ import annotations

from typing import Any

import numpy as np

from ropewalk.core.arrays import Floats
from ropewalk.laws.contact import contact_forces
from ropewalk.laws.contact_frame import GRIP


def rope_torques(obstacles: Any, memory: Any, x: Floats, v: Floats) -> Floats:
    """Return the torque of the ropes on every obstacle as it starts [N m], (k,); 0 of those not free.

    For nodes at places with velocities (3, n) [m, m/s] and bodies at the rates that `memory` has: on what is
    round by what friction remembers alone.
    """
    count, found = len(obstacles.kind), np.zeros(len(obstacles.kind))
    force = np.zeros((3 + 6 * count, x.shape[1]))
    if (obstacles.sweeps[obstacles.wheel >= 0] != 0).any():
        contact_forces(x, v, obstacles, memory, np.zeros(2), force, 0, x.shape[1])
    for row in np.flatnonzero(obstacles.wheel >= 0):
        arms = np.cross(obstacles.axle[row], x.T - obstacles.hub[row])
        own = memory.grip[row, :GRIP]
        if obstacles.sweeps[row]:
            own = force[3 + 6 * row : 6 + 6 * row] + force[6 + 6 * row : 9 + 6 * row]
        found[row] = -float((arms * own.T).sum())
    return found
