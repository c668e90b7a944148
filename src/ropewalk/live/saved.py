"""What a track is put back to."""

from __future__ import annotations

from typing import Any, NamedTuple

from ropewalk.core.peaks import Peaks
from ropewalk.live.energy_off import Balance
from ropewalk.live.hands import Hands
from ropewalk.scene import Scene
from ropewalk.simulation import Simulation, Snapshot


class Saved(NamedTuple):
    """All that a track needs to go on from there to the same bits."""

    scene: Scene
    simulation: Simulation
    snapshot: Snapshot
    hands: Hands
    steps: int
    first_energy: float
    edited: float
    first_gravity: float
    balance: Balance
    seen: tuple[Peaks | None, Peaks | None]  # by `shown` and `recorded`
    label: str
    changes: dict[str, Any]
