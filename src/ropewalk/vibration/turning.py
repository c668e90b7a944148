"""Pulleys in small motions: their turning as one unknown more for each, beside the places of the nodes.

A wheel that turns by an angle u / R takes its surface along by u d at a node, d = (axis x arm) / R. Of a
node that sticks there the friction spring, k P with P = I - n n^T, is stretched by what the node moves
beyond that, and the force f that it has at rest turns with the wheel (others: `levers`):

    -df = k P (dx - u d) - (axis x f) u / R,    the wheel's force on u = the same, transposed,

so that K gets the row b = -k P d - (axis x f) / R and the diagonal sum d.k P d, C the same of c, and M the
moment of inertia over R^2. A bearing with dry friction holds its wheel in motions that are small enough.
"""

from __future__ import annotations

from dataclasses import replace
from typing import Any, NamedTuple

import numpy as np

from ropewalk.core.arrays import Floats, Ints
from ropewalk.laws.contact_frame import DAMP, GRIP, PUSH, STIFF
from ropewalk.laws.free_torques import rope_torques
from ropewalk.laws.obstacle import Memory, Obstacles
from ropewalk.laws.obstacle_places import moved_by, reach_of, surface_near
from ropewalk.lowering import Model
from ropewalk.scene import SceneError
from ropewalk.scene.faults import Fault
from ropewalk.vibration.levers import Lever, depends_on_angle, lever_of, weight_torque
from ropewalk.vibration.linear import Linear

_TURNED = 1e-3  # of the largest tension times the radius: a torque beyond the bearing's [1]


class Turns(NamedTuple):
    """A body that turns as an unknown of its own, u = R times its angle [m]."""

    name: str
    bump: float  # what corners of the ropes that leave it add to its stiffness [N/m]


def with_wheels(
    linear: Linear, model: Model, memory: Memory, x: Floats, tension: Floats
) -> tuple[Linear, tuple[Turns, ...]]:
    """Return a model linearised about places (3, n) [m] with the turning of its wheels at the unknowns' end.

    And those that turn, in order.

    Args:
        linear: with wheels that stand.
        model: as it was built, before its wheels were held.
        memory: of the contacts at rest.
        x, tension: places and tensions (s,) [N] there.

    Raises SceneError for a wheel that is not at rest there.
    """
    table, found = model.system.node.obstacle, list[Turns]()
    for row, w in enumerate(table.wheel):
        name = model.scene.obstacles[row].name
        if w >= 0 and depends_on_angle(table, row):
            _refuse_driven(model, memory, x, w, tension)
            if table.bearing[w] == 0.0:
                linear = _with_lever(linear, table, lever_of(table, memory, row, x), w)
                found.append(Turns(name, 0.0))
            continue
        nodes = np.flatnonzero((memory.grip[row, PUSH] > 0.0) & (memory.grip[row, GRIP] > 0.0))
        nodes = nodes[linear.follows[nodes] >= 0]
        if w < 0 or not nodes.size:
            continue
        arms = x.T[nodes] - table.center[row] - moved_by(table, row, 0.0)
        round_ = np.cross(table.axis[row], arms)
        radius = float(np.linalg.norm(round_, axis=1).max())
        force = memory.grip[row, :GRIP, nodes]
        torque = -float((round_ * force).sum())
        over = abs(torque) - float(table.bearing[w])
        if over > _TURNED * radius * float(tension.max()):
            rule = (
                f"is turned by the ropes with {abs(torque):.3g} N m and held by its bearing with "
                f"{table.bearing[w]:.3g}: modes are about a rest; balance what hangs on it, or leave out spin"
            )
            raise SceneError([Fault(f"obstacle[{row}].spin.free", True, rule)])
        if table.bearing[w] == 0.0:
            linear = _with_wheel(
                linear, table, memory, row, nodes, arms, round_ / radius, force, radius
            )
            found.append(
                Turns(name, _bump(model, x, tension, nodes, arms, table.axis[row], radius))
            )
    return linear, tuple(found)


def _bump(
    model: Model,
    x: Floats,
    tension: Floats,
    nodes: Ints,
    arms: Floats,
    axis: Floats,
    radius: float,
) -> float:
    """Return how stiff corners of ropes hold a wheel that they leave at these nodes [N/m], see `Turns`.

    A rope leaves it along t from a node at the arm a, which the wheel takes along: its torque, that of T t at
    a, falls by T t . a for each radian. A smooth rope leaves it where t . a = 0, however it stands.
    """
    pull = np.where(model.state.stiffness > 0.0, tension, 0.0)
    pull, total = np.concatenate([[0.0], pull, [0.0]]), 0.0  # pull[i]: of the segment before node i
    breaks = np.flatnonzero(np.diff(nodes) > 2)
    for at, step in ((np.append(0, breaks + 1), -1), (np.append(breaks, nodes.size - 1), 1)):
        for k in at:
            node = int(nodes[k])
            force = float(pull[node + (step > 0)])
            if force > 0.0:
                way = x[:, node + step] - x[:, node]
                level = arms[k] - (arms[k] @ axis) * axis
                total += force * float(way @ level) / float(np.linalg.norm(way))
    return total / radius**2


def _refuse_driven(model: Model, memory: Memory, x: Floats, w: int, tension: Floats) -> None:
    """Raise SceneError for a body whose torque depends on its angle and that is not at rest."""
    table = model.system.node.obstacle
    row = int(np.flatnonzero(table.wheel == w)[0])
    ropes = float(rope_torques(table, memory, x, np.zeros_like(x))[row])
    weight, _ = weight_torque(table, memory, row)
    most = reach_of(table, row) * float(tension.max(initial=0.0)) + float(
        np.hypot(*table.weight[w])
    )
    if abs(ropes + weight) - float(table.bearing[w]) > _TURNED * most:
        rule = (
            f"is turned with {abs(ropes + weight):.3g} N m and held by its bearing with "
            f"{table.bearing[w]:.3g}, and no angle was found at which it rests: modes are about a rest; "
            "balance what turns it, or leave out spin"
        )
        raise SceneError([Fault(f"obstacle[{row}].spin.free", True, rule)])


def _with_lever(linear: Linear, table: Obstacles, lever: Lever, w: int) -> Linear:
    """Return the same with one body more whose torque depends on its angle."""
    moves = linear.follows[lever.nodes] >= 0
    columns = (3 * linear.follows[lever.nodes[moves]][:, None] + np.arange(3)).ravel()
    return replace(
        linear,
        mass=np.append(linear.mass, float(table.inertia[w]) / lever.radius**2),
        other=_bordered(linear.other, columns, lever.stiff[moves], lever.corner),
        friction=_bordered(linear.friction, columns, lever.viscous[moves], lever.drag),
        lengths=_wider(linear.lengths),
    )


def _with_wheel(
    linear: Linear,
    table: Obstacles,
    memory: Memory,
    row: int,
    nodes: Ints,
    arms: Floats,
    along: Floats,
    force: Floats,
    radius: float,
) -> Linear:
    """Return the same with one wheel more; `along` are the d of its nodes, (c, 3), `arms` their places."""
    places = arms + table.center[row] + moved_by(table, row, 0.0)
    normal = np.array([surface_near(table, row, p)[1:4] for p in places])
    across = along - (along * normal).sum(axis=1)[:, None] * normal  # P d
    w, grip = table.wheel[row], memory.grip[row]
    k, c = grip[STIFF, nodes][:, None], grip[DAMP, nodes][:, None]
    stiff = -k * across - np.cross(table.axis[row], force) / radius
    square = (across**2).sum(axis=1)[:, None]
    columns = (3 * linear.follows[nodes][:, None] + np.arange(3)).ravel()
    viscous = float(table.viscous[w]) / radius**2
    return replace(
        linear,
        mass=np.append(linear.mass, float(table.inertia[w]) / radius**2),
        other=_bordered(linear.other, columns, stiff, float((k * square).sum())),
        friction=_bordered(
            linear.friction, columns, -c * across, float((c * square).sum()) + viscous
        ),
        lengths=_wider(linear.lengths),
    )


def _bordered(matrix: Any, columns: Ints, values: Floats, corner: float) -> Any:
    """Return a symmetric matrix with one row and column more."""
    from scipy.sparse import block_array, coo_array

    size = matrix.shape[0]
    row = coo_array((values.ravel(), (np.zeros(columns.size, int), columns)), shape=(1, size))
    return block_array([[matrix, row.T], [row, coo_array([[corner]])]]).tocsc()


def _wider(matrix: Any) -> Any:
    """Return a matrix with a column of zeros more."""
    from scipy.sparse import coo_array, hstack

    return hstack([matrix, coo_array((matrix.shape[0], 1))]).tocsr()
