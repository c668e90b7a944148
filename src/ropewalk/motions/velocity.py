"""At a constant velocity u from a start to a stop: x = origin + u clamp(t - start, 0, stop - start)."""

from __future__ import annotations

from typing import Any

import numpy as np

from ropewalk.core.jit import kernel, part
from ropewalk.motions.kind import Floats, Motion

WAY, INTERVAL = slice(3, 6), slice(6, 8)  # of a row: u; start and stop


def fill(motion: Any, row: Floats) -> None:
    """Write velocity, start and stop."""
    row[WAY] = motion.velocity
    row[INTERVAL] = motion.start, motion.stop


def speed(row: Floats, table: Floats, until: float) -> float:
    """Return the speed from the start on [m/s]."""
    return float(np.linalg.norm(row[WAY])) if row[INTERVAL][0] < until else 0.0


@kernel
def place_velocity(p, t):
    """Return place and velocity of a point that moves during an interval (velocity right-continuous)."""
    elapsed = min(max(t - p[6], 0.0), p[7] - p[6])
    moving = 1.0 if p[6] <= t < p[7] else 0.0
    return (
        p[0] + p[3] * elapsed,
        p[1] + p[4] * elapsed,
        p[2] + p[5] * elapsed,
        p[3] * moving,
        p[4] * moving,
        p[5] * moving,
    )


@part
def place(motions, row, t):
    """Return place and velocity."""
    return place_velocity(motions.params[row], t)


VELOCITY = Motion(
    name="velocity",
    place=place,
    fill=fill,
    speed=speed,
    jumps=lambda row, table: row[INTERVAL],
)
