"""Pulleys at rest: they are held while rest is looked for; whether their bearings would hold them, too."""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import Any

import numpy as np

from ropewalk.core.arrays import Floats
from ropewalk.laws.contact_frame import PUSH
from ropewalk.laws.free_torques import rope_torques
from ropewalk.laws.wheel_rows import ANGLE, RATE
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
    angle: float = 0.0  # by which it is turned from how it is drawn [rad]
    close: float = 0.0  # torque that is none beside all that turns it one way or the other [N m]
    tips: bool = False  # whether it stands, but turns on from there once it is pushed

    @property
    def stands(self) -> bool:
        """Whether its bearing holds it: else this is no rest but the start of a motion."""
        return abs(self.torque) <= (1.0 + _ROUNDING) * self.bearing + self.close

    def __str__(self) -> str:
        turn, most = prefixed(abs(self.torque), "N m", 4), prefixed(self.bearing, "N m", 4)
        by = "ropes and its weight" if self.weighs else "ropes"
        said = f"pulley {self.obstacle!r}: {by} turn it with {turn}, its bearing holds {most}"
        if not self.stands:
            return f"{said}: it is held still here, and turns when it is let go"
        if self.angle != 0.0:
            rests = f"rests turned by {math.degrees(self.angle):.4g} degrees from how it is drawn"
            held = f"; its bearing carries {turn} of at most {most}" if self.bearing > 0.0 else ""
            said = f"pulley {self.obstacle!r} {rests}, where {by} balance{held}"
        return f"{said}; it does not stay there if it is pushed" if self.tips else said

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
            angle, bearing = float(memory.obstacle.wheel[w, ANGLE]), float(table.bearing[w])
            p, q = map(float, table.weight[w])
            weight = p * math.cos(angle) + q * math.sin(angle)
            push = np.maximum(memory.obstacle.grip[row, PUSH], 0.0)
            arms = np.linalg.norm(np.cross(table.axle[row], x.T - table.hub[row]), axis=1)
            close = _ROUNDING * (math.hypot(p, q) + float(push @ arms))
            torque = float(torques[row]) + weight
            found.append(Pulley(name, torque, bearing, p != 0.0 or q != 0.0, angle, close))
    return tuple(found)
