"""What a motion is made of: how a row of numbers tells where something is."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

Floats = NDArray[np.float64]

ORIGIN = slice(0, 3)  # of a row: the place at time zero [m]


class Motion(NamedTuple):
    """One kind of motion. Pieces left out: it stays where it is, without a jump, and never turns."""

    name: str  # the scene's `kind`

    place: Any = None
    """Part (motions, row, t): place [m] and velocity [m/s] at time t [s], six numbers."""

    fill: Callable[[Any, Floats], Floats | None] = lambda motion, row: None
    """Write the scene's motion into a row, (16,); return the rows of a table of its own, (rows, 13)."""

    speed: Callable[[Floats, Floats, float], float] = lambda row, table, until: 0.0
    """Largest speed [m/s] of a row with its table before a time [s]: the bound of the step knows of it."""

    jumps: Callable[[Floats, Floats], Floats] = lambda row, table: np.zeros(0)
    """Times at which the velocity jumps [s]: steps are cut there."""

    turns: Callable[[Floats], float] = lambda row: 0.0
    """Largest angular frequency [rad/s]: implicit steps resolve it."""
