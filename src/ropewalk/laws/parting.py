"""Ropes that part: which segments do, at what tension, and which have.

A segment that has parted is like one between two ropes: no stiffness, no friction, no rest length, no bend at
its ends. So all laws know it already, and it is a part of the state. What it stored is booked as the work of
this law, a loss. `methods.partings` looks for what is to part, after every step.
"""

from __future__ import annotations

import math
from typing import TYPE_CHECKING, NamedTuple

import numpy as np

from ropewalk.core.arrays import Floats, Ints
from ropewalk.core.jit import kernel
from ropewalk.laws.node_law import NodeLaw, Rest

if TYPE_CHECKING:
    from ropewalk.lowering.layout import Layout

NAME = "parting"


class Parting(NamedTuple):
    """What parts; segments by their first node. All (0,) where no rope does."""

    strength: Floats  # (n,) [N], inf where a segment does not part
    passing: Floats  # (n,) [s] of a wave from the rope's first segment to it, 0 of rigid links
    rope: Ints  # (n,) number of the rope, -1 where no segment parts


class Parted(NamedTuple):
    """What has parted; segments by their first node. (0,) where nothing can."""

    time: Floats  # (n,) [s], inf: it is whole
    tension: Floats  # (n,) at which it parted [N]


def lower(
    any_parts: bool, layout: Layout, parts: tuple[tuple[float, tuple[float, ...]], ...]
) -> Parting:
    """Return the table; `parts` are the tension [N] at which every rope parts, and its `passing`."""
    if all(math.isinf(strength) for strength, _ in parts):
        return Parting(np.zeros(0), np.zeros(0), np.zeros(0, np.int64))
    strengths, passings = np.full(layout.nodes, math.inf), np.zeros(layout.nodes)
    rope = np.full(layout.nodes, -1, np.int64)
    for number, ((strength, passing), span) in enumerate(zip(parts, layout.ropes, strict=True)):
        if math.isfinite(strength):
            segments = slice(span.first, span.last)
            strengths[segments], passings[segments], rope[segments] = strength, passing, number
    return Parting(strengths, passings, rope)


def acts(table: Parting) -> bool:
    """Tell whether any rope can part."""
    return table.strength.size > 0


def memory(table: Parting, x: Floats, stiffness: Floats, _held: Ints) -> Parted:
    """Return that nothing has parted."""
    n = table.strength.size
    return Parted(np.full(n, math.inf), np.zeros(n))


@kernel
def has_parted(time, low, high):
    """Tell whether a segment from `low` to before `high` has parted."""
    for j in range(low, high):
        if time[j] < math.inf:
            return True
    return False


PARTING = NodeLaw(
    name=NAME,
    section="parts",
    lower=lower,
    inputs=("layout", "parts"),
    acts=acts,
    force=None,
    tangent=None,
    memory=memory,
    at_rest=lambda table: Rest.NOTHING,
)
