"""Free bodies in small motions whose torque depends on their angle: levers, cams, masses off their axis.

A body leads its contacts along: for a node that stays, turning it by dw is the same as moving the node by
-e dw, e = axis x arm, all turned along (`laws.rotors`). With F the contact's force on the node, K and C how
it falls with the node's place and velocity, and G the torque of the body's weight,

    dF/dw = axis x F + K e,    -dt/dw = sum e . dF/dw - dG/dw,    of rates C e and sum e . C e,

so that K gets the row -dF/dw and that diagonal, all over the radius R, as a wheel does (`turning`). K and C
of a node are differences of the force itself: places within a thousandth of what it is pressed in.
"""

from __future__ import annotations

import math
from typing import NamedTuple

import numpy as np

from ropewalk.core.arrays import Floats, Ints
from ropewalk.laws.contact import contact_forces
from ropewalk.laws.contact_frame import PUSH
from ropewalk.laws.obstacle import Memory, Obstacles
from ropewalk.laws.wheel_rows import ANGLE
from ropewalk.statics.standing import standing_obstacles

_WITHIN = 1e-3  # of the depth of a contact [1]
_SLOW = 1e-6  # [m/s]


class Lever(NamedTuple):
    """What a body adds to a linearised model; c nodes touch it."""

    nodes: Ints  # (c,)
    radius: float  # R [m]; 1 where nothing touches it
    stiff: Floats  # (c, 3) its row of K [N/m]
    viscous: Floats  # (c, 3) of C [N s/m]
    corner: float  # [N/m]
    drag: float  # [N s/m]


def depends_on_angle(table: Obstacles, row: int) -> bool:
    """Tell whether what turns a free body depends on its angle."""
    return bool(table.sweeps[row]) or bool(table.weight[table.wheel[row]].any())


def weight_torque(table: Obstacles, memory: Memory, row: int) -> tuple[float, float]:
    """Return the torque of a free body's weight at its angle [N m], and how that rises with the angle."""
    w = table.wheel[row]
    angle, (p, q) = float(memory.wheel[w, ANGLE]), map(float, table.weight[w])
    c, s = math.cos(angle), math.sin(angle)
    return p * c + q * s, q * c - p * s


def lever_of(table: Obstacles, memory: Memory, row: int, x: Floats) -> Lever:
    """Return what a free body adds about places (3, n) [m], with what its contacts carry there."""
    push = memory.grip[row, PUSH]
    nodes = np.flatnonzero(push > 0.0)
    axis = table.axle[row]
    arms = x.T[nodes] - table.hub[row]
    round_ = np.cross(axis, arms)
    radius = float(np.linalg.norm(round_, axis=1).max(initial=0.0)) or 1.0
    still, zero = standing_obstacles(table, memory), np.zeros_like(x)

    def force(places: Floats, speeds: Floats) -> Floats:
        out = np.zeros((3 + 6 * len(table.kind), x.shape[1]))
        contact_forces(places, speeds, still, memory, np.zeros(2), out, 0, x.shape[1])
        own: Floats = out[3 + 6 * row : 6 + 6 * row] + out[6 + 6 * row : 9 + 6 * row]
        return own.T[nodes]

    near = np.zeros(x.shape[1])
    near[nodes] = _WITHIN * push[nodes] / table.stiffness[row, nodes]
    falls, rubs = np.zeros((nodes.size, 3)), np.zeros((nodes.size, 3))
    for k in range(3):
        moved, moving = zero.copy(), zero.copy()
        moved[k], moving[k] = near, _SLOW
        by_place = force(x + moved, zero) - force(x - moved, zero)
        by_speed = force(x, moving) - force(x, -moving)
        falls -= by_place / (2.0 * near[nodes, None]) * round_[:, k, None]
        rubs -= by_speed / (2.0 * _SLOW) * round_[:, k, None]
    led = np.cross(axis, force(x, zero)) + falls
    corner = float((round_ * led).sum()) - weight_torque(table, memory, row)[1]
    drag = float((round_ * rubs).sum()) + float(table.viscous[table.wheel[row]])
    return Lever(nodes, radius, -led / radius, -rubs / radius, corner / radius**2, drag / radius**2)
