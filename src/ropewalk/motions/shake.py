"""To and fro along an axis e: x = origin + A e (sin(2 pi f t + phase) - sin(phase))."""

from __future__ import annotations

import math
from typing import Any

import numpy as np

from ropewalk.core.jit import kernel, part
from ropewalk.motions.kind import Floats, Motion

WAY, FREQUENCY, PHASE = slice(3, 6), 6, 7  # of a row: A e; f [Hz]; phase [rad]


def fill(motion: Any, row: Floats) -> None:
    """Write amplitude, axis, frequency and phase."""
    row[WAY] = motion.amplitude * (np.array(motion.axis) / math.hypot(*motion.axis))
    row[FREQUENCY], row[PHASE] = motion.frequency, motion.phase


@kernel
def place_shake(p, t):
    """Return place and velocity of a point that shakes harmonically along an axis."""
    rate = 2.0 * math.pi * p[6]
    offset = math.sin(rate * t + p[7]) - math.sin(p[7])
    speed = rate * math.cos(rate * t + p[7])
    return (
        p[0] + p[3] * offset,
        p[1] + p[4] * offset,
        p[2] + p[5] * offset,
        p[3] * speed,
        p[4] * speed,
        p[5] * speed,
    )


@part
def place(motions, row, t):
    """Return place and velocity."""
    return place_shake(motions.params[row], t)


SHAKE = Motion(
    name="shake",
    place=place,
    fill=fill,
    speed=lambda row, table, until: float(
        2.0 * math.pi * row[FREQUENCY] * np.linalg.norm(row[WAY])
    ),
    turns=lambda row: 2.0 * math.pi * abs(float(row[FREQUENCY])),
)
