"""Whether nodes were braked well before an obstacle: a contact's damper takes hold ahead of its surface.

It does so from 2 v sqrt(m / k) on, which is a hair for a rope's own nodes and much for a heavy load on a soft
rope: see *What it does not do* in the theory of contact.
"""

from __future__ import annotations

from typing import TYPE_CHECKING, NamedTuple

import numpy as np

from ropewalk.core.arrays import Floats
from ropewalk.laws.obstacle import Obstacles
from ropewalk.laws.obstacle_places import depths
from ropewalk.lowering.touching import at_rates, contacts_at, within_reach
from ropewalk.record.contacts import model_of
from ropewalk.record.quantities import OBSTACLE_FORCE, PULLEYS
from ropewalk.statics.pressing import rounded

if TYPE_CHECKING:
    from ropewalk.record.result import Result

_PIECE = 64  # frames that are read at once
_LEAST = 0.05  # [m] of what is told, and twice the rope's diameter where that is more


class Reach(NamedTuple):
    """Where a node was braked farthest from what it came at."""

    frame: int
    obstacle: int
    node: int  # index of the arrays
    gap: float  # [m] between the surfaces of rope and obstacle
    wanted: float  # [m] what would go unsaid
    compliance: float  # [m/N] with which the same hit would be braked from there on


def reach_note(result: Result) -> str:
    """Say which node was braked farthest before an obstacle; "" where none was by more than some centimetres.

    Of the recorded frames.
    """
    found = farthest(result)
    if found is None:
        return ""
    (name, number), body = result.layout.rope_of(found.node), result.scene.obstacles[found.obstacle]
    return (
        f"at t = {result.time[found.frame]:.6g} s node {number} of rope {name!r} was braked "
        f"{1e3 * found.gap:.3g} mm before {body.name!r}: the damper of a contact takes hold ahead of it, the "
        "farther the heavier and the faster a node is. What it takes is right, the place is not, and it is "
        f"early; a compliance of {rounded(found.compliance)} m/N or less brings it to "
        f"{1e3 * found.wanted:.3g} mm"
    )


def farthest(result: Result) -> Reach | None:
    """Return where a node was braked farthest from an obstacle by it; None if within some centimetres."""
    if not result.scene.obstacles or "contact_force" not in result.source.names:
        return None
    apart = OBSTACLE_FORCE in result.source.names
    if result.scene.contact is not None and not apart:
        return None  # an old run: whose force it is cannot be told
    model = model_of(result)
    table = model.system.node.obstacle
    turning = result.read(PULLEYS) if result.layout.pulleys else None
    worst: Reach | None = None
    for first in range(0, result.good_frames, _PIECE):
        last = min(first + _PIECE, result.good_frames)
        force = result.read(OBSTACLE_FORCE if apart else "contact_force", first, last)
        places, speeds = (result.read(name, first, last) for name in ("positions", "velocities"))
        for row in np.flatnonzero(force.any(axis=(1, 2))).tolist():
            frame = first + row
            t = float(result.time[frame])
            now = table if turning is None else at_rates(table, turning[frame], t)
            x, v, pushed = (np.ascontiguousarray(one[row].T) for one in (places, speeds, force))
            found = _of_frame(now, frame, x, v, pushed, model.state.stiffness, t)
            if found and found.gap - found.wanted > (worst.gap - worst.wanted if worst else 0.0):
                worst = found
    return None if worst is None else _as_it_came(result, table, worst)


def _as_it_came(result: Result, table: Obstacles, found: Reach) -> Reach:
    """Return it with the compliance for the speed of the frame before: braking began between the two."""
    row, node = found.obstacle, found.node
    before = max(found.frame - 1, 0)
    speed = float(np.linalg.norm(result.read("velocities", before, before + 1)[0, node]))
    stiffness = float(table.stiffness[row, node])
    damping = float(table.ratio[row] * table.damping[row, node])
    reach = max(found.gap, speed * damping / stiffness)
    return found._replace(compliance=(found.wanted / reach) ** 2 / stiffness)


def _of_frame(
    table: Obstacles, frame: int, x: Floats, v: Floats, force: Floats, stiffness: Floats, t: float
) -> Reach | None:
    """Return where a node is braked farthest from what brakes it, at time `t` [s]; None if nowhere.

    Places, velocities and forces of all obstacles are (3, n) [m, m/s, N], `stiffness` (s,) [N/m]. What is
    nearest may brake nothing.
    """
    wanted = np.maximum(4.0 * table.thickness, _LEAST)
    gaps = -depths(table, x, t)
    nodes = np.flatnonzero(force.any(axis=0))
    far = gaps[:, nodes] > wanted[nodes]
    if not far.any():
        return None
    far &= within_reach(table, nodes, x, v, t)[2]
    if not far.any():
        return None
    asked = np.zeros_like(force)
    asked[:, nodes] = force[:, nodes] * far.any(axis=0)
    hits = contacts_at(table, x, v, asked, stiffness, t)
    if not hits.node.size:
        return None
    beyond = gaps[hits.obstacle, hits.node] - wanted[hits.node]
    hit = int(np.argmax(beyond))
    row, node = int(hits.obstacle[hit]), int(hits.node[hit])
    return Reach(frame, row, node, float(gaps[row, node]), float(wanted[node]), 0.0)
