"""The force of the ropes on obstacles, from what was recorded of their nodes."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING

import numpy as np

from ropewalk.core.arrays import Floats
from ropewalk.record.quantities import OBSTACLE_FORCE, PULLEYS, has_rope, rest_length_at_start

if TYPE_CHECKING:
    from ropewalk.lowering import Model
    from ropewalk.record.result import Result

_PIECE = 256  # frames that are read at once


def body_loads(result: Result, frames: range, names: Sequence[str]) -> Floats:
    """Return the force of the ropes on each obstacle named, (frames, names) [N]; without its own weight.

    A node within reach of no other gives all its force to one; of others each contact is looked at.
    Friction that cannot be told, where a rope touches another on it, is left out.
    """
    from ropewalk.record.contacts import model_of

    found, model = np.zeros((len(frames), len(names))), None
    for start in range(0, len(frames), _PIECE):
        part = frames[start : start + _PIECE]
        # NaN: of a rope that broke, where others go on
        force = np.nan_to_num(result.read(of_nodes(result), part.start, part.stop))
        if len(result.scene.obstacles) == 1 and is_apart(result):
            found[start : start + len(part)] = np.linalg.norm(force.sum(axis=1), axis=1)[:, None]
        elif force.any():
            model = model or model_of(result)
            loads = _of_several(result, model, part, force, names)
            found[start : start + len(part)] = np.linalg.norm(loads, axis=2)
    return found


def is_apart(result: Result) -> bool:
    """Tell whether the force of obstacles is known apart from that of ropes on ropes."""
    return OBSTACLE_FORCE in result.source.names or result.scene.contact is None


def of_nodes(result: Result) -> str:
    """Return the quantity that has the force of obstacles on nodes, alone where that is known."""
    return OBSTACLE_FORCE if OBSTACLE_FORCE in result.source.names else "contact_force"


def _of_several(
    result: Result, model: Model, part: range, force: Floats, names: Sequence[str]
) -> Floats:
    """Return the forces on the obstacles named, (frames, names, 3) [N], of those on nodes (frames, n, 3)."""
    from ropewalk.lowering.touching import at_rates, contacts_at, within_reach
    from ropewalk.record.contacts import without_ropes

    scene, found = result.scene, np.zeros((len(part), len(names), 3))
    where = [[body.name for body in scene.obstacles].index(name) for name in names]
    x, v = (result.read(name, part.start, part.stop) for name in ("positions", "velocities"))
    turning = result.read(PULLEYS, part.start, part.stop) if result.layout.pulleys else None
    lengths = [rope.segment_length for rope in scene.ropes]
    rest, apart = rest_length_at_start(result.layout, lengths)[None], is_apart(result)
    if "rest_length" in result.source.names:
        rest = result.read("rest_length", part.start, part.stop)
    for k in np.flatnonzero(force.any(axis=(1, 2))).tolist():
        place, rate, push = (np.ascontiguousarray(one[k].T) for one in (x, v, force))
        t, table = float(result.time[part[k]]), model.system.node.obstacle
        table = table if turning is None else at_rates(table, turning[k], t)
        nodes = np.flatnonzero(push.any(axis=0))
        near = within_reach(table, nodes, place, rate, t)[2]
        alone = (near.sum(axis=0) == 1) & apart
        for column, o in enumerate(where):
            found[k, column] = push[:, nodes[alone & near[o]]].sum(axis=1)
        push[:, nodes[alone]] = 0.0
        if not (near[where] & ~alone).any():
            continue
        there = has_rope(result.layout, rest[min(k, len(rest) - 1)], lengths).astype(float)
        contacts = contacts_at(table, place, rate, push, there, t, where)
        contacts = contacts if apart else without_ropes(model, place, contacts)
        each = contacts.push[:, None] * contacts.normal + np.nan_to_num(contacts.rub)
        for column, o in enumerate(where):
            found[k, column] += each[contacts.obstacle == o].sum(axis=0)
    return found
