"""By how much a rope turns on an obstacle once it has slipped sideways as far as it would."""

from __future__ import annotations

import math

import numpy as np

from ropewalk.core.arrays import Floats


def turn_about(axis: Floats, x: Floats, first: int, last: int) -> float:
    """Return the largest turn of a stretch that slips sideways on a cylinder [rad].

    A rope that crosses the surface's circles at an angle b turns by cos(b) times the angle by which it goes
    about the axis, which slipping leaves alone, as its ends go on where they did. Slipping evens b out: it
    comes to the least of it along the stretch and beside it at most, to none where that lies to both sides.

    Args:
        axis: (3,) of the cylinder, of length 1.
        x: (3, n) places of the nodes [m].
        first, last: nodes of the stretch, with a segment before and after it.
    """
    ways = np.diff(x[:, first - 1 : last + 2], axis=1).T
    sines = ways @ axis / np.linalg.norm(ways, axis=1)
    about = ways - np.outer(ways @ axis, axis)
    into, out = about[:-1], about[1:]
    angles = np.arctan2(np.cross(into, out) @ axis, (into * out).sum(axis=1))
    least = 0.0 if sines.min() <= 0.0 <= sines.max() else float(np.abs(sines).min())
    return abs(float(angles.sum())) * math.sqrt(1.0 - least**2)
