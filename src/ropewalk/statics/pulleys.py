"""Pulleys at rest: they are held while rest is looked for; whether their bearings would hold them, too."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

import numpy as np

from ropewalk.core.arrays import Floats
from ropewalk.laws.free_torques import rope_torques
from ropewalk.laws.wheel_rows import RATE
from ropewalk.lowering import Model
from ropewalk.words.prefixes import prefixed

_ROUNDING = 1e-6  # of a torque [1]


@dataclass(frozen=True)
class Pulley:
    """An obstacle that turns freely, and what ropes at rest turn it with."""

    obstacle: str
    torque: float  # of the ropes about its axis, and of its own weight [N m]
    bearing: float  # what its bearing holds [N m]
    weighs: bool = False  # whether its own weight turns it, too

    @property
    def stands(self) -> bool:
        """Whether its bearing holds it: else this is no rest but the start of a motion."""
        return abs(self.torque) <= (1.0 + _ROUNDING) * self.bearing

    def __str__(self) -> str:
        turn, most = prefixed(abs(self.torque), "N m", 4), prefixed(self.bearing, "N m", 4)
        by = "ropes and its weight" if self.weighs else "ropes"
        said = f"pulley {self.obstacle!r}: {by} turn it with {turn}, its bearing holds {most}"
        if self.stands:
            return said
        return f"{said}: it is held still here, and turns when it is let go"

    def as_dict(self) -> dict[str, Any]:
        """Plain values, with whether it stands."""
        return vars(self) | {"stands": self.stands}


def _torques(table: Any, memory: Any, x: Floats) -> Floats:
    """Return the torques of ropes at rest on bodies that stand, whatever the rate at which they start."""
    rates = memory.wheel[:, RATE].copy()
    memory.wheel[:, RATE] = 0.0
    found = rope_torques(table, memory, x, np.zeros_like(x))
    memory.wheel[:, RATE] = rates
    return found


def pulleys(model: Model, memory: Any, x: Floats) -> tuple[Pulley, ...]:
    """Return what turns every pulley at places (3, n) [m], with what `State.memory` carries there."""
    table, found = model.system.node.obstacle, []
    torques = _torques(table, memory.obstacle, x) if len(table.inertia) else ()
    for row, w in enumerate(table.wheel):
        if w >= 0:
            name = model.scene.obstacles[row].name
            weight, bearing = float(table.weight[w, 0]), float(table.bearing[w])
            found.append(Pulley(name, float(torques[row]) + weight, bearing, weight != 0.0))
    return tuple(found)
