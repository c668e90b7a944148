"""How far a body may be turned at a time so that its surface passes no node, and whether it did."""

from __future__ import annotations

import numpy as np

from ropewalk.core.arrays import Floats
from ropewalk.laws.obstacle import Obstacles
from ropewalk.laws.obstacle_places import depths, reach_of, rotation_by, surface_near
from ropewalk.laws.wheel_rows import ANGLE
from ropewalk.lowering import Model
from ropewalk.statics.standing import standing_obstacles

_HALF = 0.5  # of the way to where a node might leave on the other side [1]
_TOUCH = 1e-3  # of a rope's radius: so near it touches [1]
_BACK = -0.5  # cosine between a node's sides of a body before and after: it is on the other one [1]


def clear_turn(model: Model, row: int) -> float:
    """Return by how much a body may be turned [rad] from how the model has it, with its ropes at rest.

    Half of what takes the point of it that is farthest from its axle to the middle of the nearest rope, and
    on by half of how thick the body is at least (`Obstacles.thin`); inf where turning moves no surface.
    """
    table = _standing(model)
    reach = reach_of(table, row) if table.sweeps[row] else 0.0
    if not reach > 0.0:
        return np.inf
    gap = table.thickness - depths(table, model.state.x)[row]
    return _HALF * max(float(table.thin[row] + gap.min(initial=np.inf)), 0.0) / reach


def passes(before: Model, after: Model, row: int) -> bool:
    """Tell whether a body that turned a little is past a node that lay on it, on its other side."""
    one, other = _standing(before), _standing(after)
    near = depths(one, before.state.x)[row] > -_TOUCH * one.thickness
    if not one.sweeps[row] or not near.any():
        return False
    turn = rotation_by(other, row, _angle(after, row) - _angle(before, row))
    for node in np.flatnonzero(near):
        was = _normal(one, row, before.state.x[:, node])
        now = _normal(other, row, after.state.x[:, node])
        if float(now @ turn @ was) < _BACK:
            return True
    return False


def _standing(model: Model) -> Obstacles:
    found: Obstacles = standing_obstacles(model.system.node.obstacle, model.state.memory.obstacle)
    return found


def _angle(model: Model, row: int) -> float:
    w = model.system.node.obstacle.wheel[row]
    return float(model.state.memory.obstacle.wheel[w, ANGLE])


def _normal(table: Obstacles, row: int, place: Floats) -> Floats:
    return np.array(surface_near(table, row, place)[1:4])
