"""Ropes that are laid over something round, with masses at their ends."""

from __future__ import annotations

import itertools
import math
from collections.abc import Mapping, Sequence

import numpy as np

import ropewalk as rw

Point = tuple[float, float, float]


def half_round(out: float, bends: int = 40) -> list[Point]:
    """Return corners half round the y axis at `out` [m], with both ends 0.3 m below it."""
    turn = np.linspace(0.0, math.pi, bends + 1)
    arc = [(-out * math.cos(a), 0.0, out * math.sin(a)) for a in turn]
    return [(-out, 0.0, -0.3), *arc, (out, 0.0, -0.3)]


def laid(
    points: Sequence[Point],
    masses: Mapping[int, float],
    *,
    name: str = "rope",
    spacing: float = 0.012,
    mass_per_length: float = 1e-3,
) -> rw.Rope:
    """Return a rope of 10 mm along corners [m], with masses [kg] by node, its nodes `spacing` [m] apart."""
    length = sum(math.dist(a, b) for a, b in itertools.pairwise(points))
    return rw.Rope(
        name=name,
        segments=int(length / spacing),
        length=length,
        diameter=0.01,
        made_of=rw.Material(EA=2e4, mass_per_length=mass_per_length, axial_damping=20.0),
        shape={"kind": "polyline", "points": list(points)},
        loads=[{"node": node, "mass": mass} for node, mass in masses.items()],
    )
