"""A law of nodes for tests and for whoever writes one: a well that draws every node to a point.

With d a node's place from the point, its force is
    F = -k (1 + s |d|^2) d - c v,   U = k (|d|^2 / 2 + s |d|^4 / 4).
`test_added_law` puts this file into a copy of the package, as `ropewalk/laws/well.py`.
"""

from __future__ import annotations

from typing import Any, NamedTuple

import numpy as np

from ropewalk.core.arrays import Floats
from ropewalk.core.jit import kernel, part
from ropewalk.core.ranges import rows
from ropewalk.laws.node_law import NodeLaw, Rest

TRUE_SHARE = 1.0  # of the stiffness in the tangent; the twin has less


class Well(NamedTuple):
    """The well of all nodes."""

    active: int
    point: Floats  # (3,) [m]
    stiffness: float  # k [N/m]
    stiffening: float  # s [1/m^2]
    friction: float  # c [N s/m]
    reach: float  # [m] no node is farther


def lower(well: Any) -> Well:
    """Return the table of a scene's well."""
    if well is None:
        return Well(0, np.zeros(3), 0.0, 0.0, 0.0, 0.0)
    numbers = well.stiffness, well.stiffening, well.friction, well.reach
    return Well(1, np.array(well.point, dtype=np.float64), *numbers)


def acts(well: Well) -> bool:
    """Tell whether there is a well."""
    return well.active == 1


@part
def force(well, state, x, v, force, lo, hi):
    """Write the force on every node [N], (3, n)."""
    draw(x, v, well, force, lo, hi)


@kernel
def draw(x, v, well, force, lo, hi):
    """Write the force on every node [N], (3, n)."""
    p, q, r = well.point[0], well.point[1], well.point[2]
    x0, x1, x2 = rows(x, lo, hi)
    v0, v1, v2 = rows(v, lo, hi)
    f0, f1, f2 = rows(force, lo, hi)
    for i in range(x0.shape[0]):
        a, b, c = x0[i] - p, x1[i] - q, x2[i] - r
        k = well.stiffness * (1.0 + well.stiffening * (a * a + b * b + c * c))
        f0[i] = -k * a - well.friction * v0[i]
        f1[i] = -k * b - well.friction * v1[i]
        f2[i] = -k * c - well.friction * v2[i]


@part
def tangent(well, state, x, v, weight_x, weight_v, marks, band):
    """Add -(weight_x dF/dx + weight_v dF/dv)."""
    differ(x, well, weight_x, weight_v, band)


@kernel
def differ(x, well, weight_x, weight_v, band):
    """Add -dF/dx = k ((1 + s |d|^2) I + 2 s d d^T) and -dF/dv = c I, weighted."""
    point, s = well.point, well.stiffening
    for i in range(x.shape[1]):
        a, b, c = x[0, i] - point[0], x[1, i] - point[1], x[2, i] - point[2]
        k = TRUE_SHARE * weight_x * well.stiffness
        round_ = k * (1.0 + s * (a * a + b * b + c * c)) + weight_v * well.friction
        for m in range(3):
            band.diagonal[i, 4 * m] += round_
            for n in range(3):
                d = (x[m, i] - point[m]) * (x[n, i] - point[n])
                band.diagonal[i, 3 * m + n] += 2.0 * k * s * d


@part
def energy(well, state, x):
    """Return U of all nodes [J]."""
    return depth(x, well)


@kernel
def depth(x, well):
    """Return U of all nodes [J]."""
    total = 0.0
    for i in range(x.shape[1]):
        a, b, c = x[0, i] - well.point[0], x[1, i] - well.point[1], x[2, i] - well.point[2]
        square = a * a + b * b + c * c
        total += well.stiffness * square * (0.5 + 0.25 * well.stiffening * square)
    return total


def at_rest(well: Well) -> Rest:
    """It has a place for every node."""
    return Rest.HOLDS


def chain(well: Well, chain: Any, lengths: Floats, speed: float) -> Any:
    """Add the largest stiffness within reach, and the friction, to every node."""
    most = well.stiffness * (1.0 + 3.0 * well.stiffening * well.reach**2)
    return chain._replace(
        node_stiffness=chain.node_stiffness + most, node_damping=chain.node_damping + well.friction
    )


WELL = NodeLaw(
    name="well",
    section="well",
    lower=lower,
    inputs=(),
    acts=acts,
    force=force,
    tangent=tangent,
    energy=energy,
    at_rest=at_rest,
    chain=chain,
)
