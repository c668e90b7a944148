"""Whether nodes were pressed so deep into obstacles that their forces are no longer those of ropes.

Nothing passes through a body; but a plane or a trough has no other side, so that an anchor, a load or another
body may press a rope as deep into it as they like.
"""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from ropewalk.laws.obstacle_places import depths
from ropewalk.lowering.touching import at_rates
from ropewalk.record.contacts import model_of
from ropewalk.record.quantities import PULLEYS

_FORCE = "contact_force"  # with that of ropes on ropes
_PIECE = 64  # frames that are read at once

if TYPE_CHECKING:
    from ropewalk.record.result import Result


def deep_note(result: Result) -> str:
    """Say which node's middle was deepest inside an obstacle; "" where none was.

    Of the recorded frames; of nodes of ropes with a diameter that an obstacle presses on and no anchor holds.
    """
    if not result.scene.obstacles or _FORCE not in result.source.names:
        return ""
    frame, row, node, depth = _deepest(result)
    if not depth > 0.0:
        return ""
    (name, number), body = result.layout.rope_of(node), result.scene.obstacles[row]
    return (
        f"at t = {result.time[frame]:.6g} s the middle of node {number} of rope {name!r} was "
        f"{1e3 * depth:.3g} mm inside {body.name!r}, where no rope can be: its force is that of a spring. If "
        "no other body and no anchor pressed it in, give the obstacle a smaller compliance"
    )


def _held_throughout(result: Result) -> list[int]:
    """Return the nodes that anchors hold and do not let go."""
    pairs = zip(result.layout.anchor_nodes, result.scene.anchors, strict=True)
    return [node for node, anchor in pairs if anchor.release_time is None]


def _deepest(result: Result) -> tuple[int, int, int, float]:
    """Return frame, obstacle and node of the deepest middle, and how far inside it is [m]; 0: none is."""
    table, turning = None, result.read(PULLEYS) if result.layout.pulleys else None
    worst = (0, 0, 0, 0.0)
    for first in range(0, result.good_frames, _PIECE):
        last = min(first + _PIECE, result.good_frames)
        pressed = np.asarray(np.any(result.read(_FORCE, first, last) != 0.0, axis=2))
        if not pressed.any():
            continue
        if table is None:
            table = model_of(result).system.node.obstacle
            loose = table.thickness > 0.0
            loose[_held_throughout(result)] = False
        places = result.read("positions", first, last)
        for frame in np.flatnonzero(pressed.any(axis=1)).tolist():
            t = float(result.time[first + frame])
            now = table if turning is None else at_rates(table, turning[first + frame], t)
            inside = depths(now, np.ascontiguousarray(places[frame].T), t) - table.thickness
            inside[:, ~(loose & pressed[frame])] = -np.inf
            row, node = divmod(int(np.argmax(inside)), inside.shape[1])
            if inside[row, node] > worst[3]:
                worst = (first + frame, row, node, float(inside[row, node]))
    return worst
