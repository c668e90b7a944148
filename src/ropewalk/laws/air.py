"""Air as a law of nodes: linear and quadratic drag in a uniform wind. See `air_drag` and `air_tangent`."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING, NamedTuple

import numpy as np

from ropewalk.core.arrays import Floats
from ropewalk.core.jit import deferred, kernel, part
from ropewalk.laws.air_drag import linear_drag, quadratic_line_drag, quadratic_node_drag
from ropewalk.laws.air_tangent import (
    line_drag_tangent,
    linear_drag_tangent,
    quadratic_node_tangent,
)
from ropewalk.laws.node_law import NodeLaw, Rest

if TYPE_CHECKING:
    from ropewalk.lowering.layout import Layout
    from ropewalk.methods.bound import Chain
    from ropewalk.scene import Air as AirInScene

# A wind w against a node that moves at u puts in at most 4/27 a |w|^3 (quadratic drag), c |w|^2 / 4 (linear).
_QUADRATIC, _LINEAR = 4.0 / 27.0, 0.25


class Air(NamedTuple):
    """Air drag. All arrays per node, shape (n,), unless said otherwise."""

    linear: int  # 1 when the linear law acts
    quadratic: int  # 1 when a quadratic law acts
    node_drag: Floats  # [N s/m]
    node_drag_quadratic: Floats  # [N s^2/m^2]
    normal: Floats  # (s,) density * normal coefficient * diameter / 2 [N s^2/m^3]
    tangential: Floats  # (s,) density * tangential coefficient * diameter / 2 [N s^2/m^3]
    wind: Floats  # (3,) [m/s]


def lower(air: AirInScene | None, layout: Layout, diameters: tuple[float, ...]) -> Air:
    """Return the table of a scene's air; `diameters` are those of its ropes [m]."""
    n = layout.nodes
    normal, tangential = np.zeros(layout.segments), np.zeros(layout.segments)
    drag, quadratic = np.zeros(n), np.zeros(n)
    if air is None:
        return Air(0, 0, drag, quadratic, normal, tangential, np.zeros(3))
    for diameter, span in zip(diameters, layout.ropes, strict=True):
        segments = slice(span.first, span.last)
        normal[segments] = 0.5 * air.density * air.normal_coefficient * diameter
        tangential[segments] = 0.5 * math.pi * air.density * air.tangential_coefficient * diameter
        nodes = slice(span.first, span.last + 1)  # those still on a drum, too
        drag[nodes], quadratic[nodes] = air.node_drag, air.node_drag_quadratic
    curved = bool(quadratic.any() or normal.any() or tangential.any())
    linear = int(air.node_drag > 0.0)
    wind = np.array(air.wind, dtype=np.float64)
    return Air(linear, int(curved), drag, quadratic, normal, tangential, wind)


def acts(air: Air) -> bool:
    """Tell whether there is any drag."""
    return air.linear == 1 or air.quadratic == 1


@part
def drag(air, state, x, v, force, lo, hi):
    """Write the drag on every node [N], (3, n)."""
    # The segment before a node has added its drag to it already.
    ahead, end = lo + (1 if lo > 0 else 0), hi + 1
    linear_drag(v, air.node_drag, air.wind, force, ahead, end)
    if air.quadratic == 1:
        quadratic_node_drag(v, air.node_drag_quadratic, air.wind, force, ahead, end)
        quadratic_line_drag(
            x, v, state.stiffness, air.normal, air.tangential, air.wind, force, lo, hi
        )


@part
def tangent(air, state, x, v, weight_x, weight_v, marks, band):
    """Add the derivatives of the drag."""
    linear_drag_tangent(air.node_drag, weight_v, band)
    if air.quadratic == 1:
        quadratic_node_tangent(v, air.node_drag_quadratic, air.wind, weight_v, band)
        alive = state.stiffness
        line_drag_tangent(
            x, v, alive, air.normal, air.tangential, air.wind, weight_x, weight_v, band
        )


@part
def is_linear(air):
    """Tell whether the drag of a node is a number times its velocity against the wind."""
    return air.quadratic == 0


@part
def add_diagonal(air, weight_v, free, diagonal):
    """Add that number for every free node, (n,)."""
    add_drag(air.node_drag, weight_v, free, diagonal)


@kernel
def add_drag(node_drag, weight_v, free, diagonal):
    """Add `weight_v` times the linear drag of every free node, (n,)."""
    for i in range(diagonal.shape[0]):
        diagonal[i] += weight_v * node_drag[i] * free[i]


@part
def power(air, state, x):
    """Return the most that the wind can put in per time [W]."""
    return wind_power(x, state.stiffness, air)


@deferred("float64")
def wind_power(x, stiffness, air):
    """Return the most that the wind can put in per time [W]."""
    wind = math.sqrt(air.wind[0] ** 2 + air.wind[1] ** 2 + air.wind[2] ** 2)
    if wind == 0.0:
        return 0.0
    total = 0.0
    for i in range(x.shape[1]):
        total += _LINEAR * air.node_drag[i] * wind**2
        total += _QUADRATIC * air.node_drag_quadratic[i] * wind**3
    for j in range(air.normal.shape[0]):
        if stiffness[j] == 0.0:
            continue
        dx, dy, dz = x[0, j + 1] - x[0, j], x[1, j + 1] - x[1, j], x[2, j + 1] - x[2, j]
        r = math.sqrt(dx * dx + dy * dy + dz * dz)
        total += _QUADRATIC * r * (air.normal[j] + air.tangential[j]) * wind**3
    return total


def at_rest(air: Air) -> Rest:
    """A wind carries nodes along; still air does nothing to those at rest."""
    return Rest.CARRIES if np.any(air.wind) else Rest.NOTHING


def flow(air: Air) -> Floats:
    """Return the wind [m/s], (3,)."""
    return air.wind


def chain(air: Air, chain: Chain, lengths: Floats, speed: float) -> Chain:
    """Add drag per speed of every node [N s/m]: d(a v^2)/dv = 2 a v, a segment's shared by its ends."""
    per_segment = speed * np.maximum(air.normal, air.tangential) * lengths
    damping = air.node_drag + 2.0 * speed * air.node_drag_quadratic
    damping[:-1] += per_segment
    damping[1:] += per_segment
    return chain._replace(node_damping=chain.node_damping + damping)


AIR = NodeLaw(
    name="air",
    section="air",
    lower=lower,
    inputs=("layout", "diameters"),
    acts=acts,
    force=drag,
    tangent=tangent,
    is_diagonal=is_linear,
    is_local=is_linear,
    add_diagonal=add_diagonal,
    power=power,
    at_rest=at_rest,
    flow=flow,
    chain=chain,
)
