"""Whether nodes were braked well before an obstacle: a contact's damper takes hold ahead of its surface.

It does so from 2 v sqrt(m / k) on, which is a hair for a rope's own nodes and much for a heavy load on a soft
rope: see *What it does not do* in the theory of contact.
"""

from __future__ import annotations

from typing import TYPE_CHECKING, NamedTuple

import numpy as np
from numpy.typing import NDArray

from ropewalk.core.arrays import Floats
from ropewalk.laws.obstacle import Obstacles
from ropewalk.laws.obstacle_places import depths
from ropewalk.lowering.touching import at_rates
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
    """Return where a node was braked farthest from the nearest obstacle; None if within some centimetres."""
    if not result.scene.obstacles or "contact_force" not in result.source.names:
        return None
    apart = OBSTACLE_FORCE in result.source.names
    if result.scene.contact is not None and not apart:
        return None  # an old run: whose force it is cannot be told
    table = model_of(result).system.node.obstacle
    turning = result.read(PULLEYS) if result.layout.pulleys else None
    worst: Reach | None = None
    for first in range(0, result.good_frames, _PIECE):
        last = min(first + _PIECE, result.good_frames)
        force = result.read(OBSTACLE_FORCE if apart else "contact_force", first, last)
        places = result.read("positions", first, last)
        for row in np.flatnonzero(force.any(axis=(1, 2))).tolist():
            frame, braked = first + row, force[row].any(axis=1)
            t = float(result.time[frame])
            now = table if turning is None else at_rates(table, turning[frame], t)
            gaps = -depths(now, np.ascontiguousarray(places[row].T), t)
            found = _of_frame(table, frame, gaps, braked)
            if found.gap - found.wanted > (worst.gap - worst.wanted if worst else 0.0):
                worst = found
    return None if worst is None else _as_it_came(result, table, worst)


def _as_it_came(result: Result, table: Obstacles, found: Reach) -> Reach:
    """Return it with the compliance for the speed of the frame before: braking began between the two."""
    row, node = found.obstacle, found.node
    before = max(found.frame - 1, 0)
    speed = float(np.linalg.norm(result.read("velocities", before, before + 1)[0, node]))
    stiffness = float(table.stiffness[row, node])
    reach = max(found.gap, speed * float(table.damping[row, node]) / stiffness)
    return found._replace(compliance=(found.wanted / reach) ** 2 / stiffness)


def _of_frame(table: Obstacles, frame: int, gaps: Floats, braked: NDArray[np.bool_]) -> Reach:
    """Return where one of the nodes that are braked, (n,), is farthest from what is nearest to it.

    `gaps` (k, n) [m] are those between all obstacles and all nodes.
    """
    wanted = np.maximum(4.0 * table.thickness, _LEAST)
    node = int(np.argmax(np.where(braked, gaps.min(axis=0) - wanted, -np.inf)))
    row = int(np.argmin(gaps[:, node]))
    gap, room = float(gaps[row, node]), float(wanted[node])
    return Reach(frame, row, node, gap, room, 0.0)
