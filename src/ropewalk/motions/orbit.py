"""Round a centre, about an axis: x = centre + R(axis, 2 pi f t) (origin - centre)."""

from __future__ import annotations

import math
from typing import Any

import numpy as np

from ropewalk.core.jit import kernel, part
from ropewalk.motions.kind import ORIGIN, Floats, Motion

CENTRE, AXIS, FREQUENCY = slice(3, 6), slice(6, 9), 9  # of a row; the axis has length 1


def fill(motion: Any, row: Floats) -> None:
    """Write centre, axis and frequency."""
    row[CENTRE] = motion.center
    row[AXIS] = np.array(motion.axis) / math.hypot(*motion.axis)
    row[FREQUENCY] = motion.frequency


def speed(row: Floats, table: Floats, until: float) -> float:
    """Return the speed on the circle [m/s]."""
    arm = np.cross(row[AXIS], row[ORIGIN] - row[CENTRE])
    return float(2.0 * math.pi * abs(row[FREQUENCY]) * np.linalg.norm(arm))


@kernel
def place_orbit(p, t):
    """Return place and velocity of a point on its circle about an axis (Rodrigues' rotation)."""
    rate = 2.0 * math.pi * p[9]
    c, s = math.cos(rate * t), math.sin(rate * t)
    ex, ey, ez = p[6], p[7], p[8]
    rx, ry, rz = p[0] - p[3], p[1] - p[4], p[2] - p[5]
    along = (ex * rx + ey * ry + ez * rz) * (1.0 - c)
    qx = c * rx + s * (ey * rz - ez * ry) + along * ex
    qy = c * ry + s * (ez * rx - ex * rz) + along * ey
    qz = c * rz + s * (ex * ry - ey * rx) + along * ez
    return (
        p[3] + qx,
        p[4] + qy,
        p[5] + qz,
        rate * (ey * qz - ez * qy),
        rate * (ez * qx - ex * qz),
        rate * (ex * qy - ey * qx),
    )


@part
def place(motions, row, t):
    """Return place and velocity."""
    return place_orbit(motions.params[row], t)


ORBIT = Motion(
    name="orbit",
    place=place,
    fill=fill,
    speed=speed,
    turns=lambda row: 2.0 * math.pi * abs(float(row[FREQUENCY])),
)
