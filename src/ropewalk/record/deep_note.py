"""Whether nodes were pressed so deep into obstacles that their forces are no longer those of ropes.

Nothing passes through a body; but a plane or a trough has no other side, so that an anchor, a load or another
body may press a rope as deep into it as they like. Between two bodies it gives way to both: what they squeeze
is told long before its middle is inside either.
"""

from __future__ import annotations

from typing import TYPE_CHECKING, NamedTuple

import numpy as np

from ropewalk.laws.obstacle_places import depths
from ropewalk.lowering.rooms import Room, tightest
from ropewalk.lowering.touching import at_rates
from ropewalk.record.contacts import model_of
from ropewalk.record.quantities import PULLEYS

_FORCE = "contact_force"  # with that of ropes on ropes
_MORE = 1.0 + 1e-6  # times what a frame before lacks: less more is rounding
_PIECE = 64  # frames that are read at once

if TYPE_CHECKING:
    from ropewalk.record.result import Result


class _Deepest(NamedTuple):
    """What of a run is to be told."""

    frame: int = 0
    row: int = 0  # the obstacle
    node: int = 0
    depth: float = 0.0  # of a node's middle inside it [m]; 0: none is
    room: Room | None = None  # the least that two bodies left a node
    then: int = 0  # the frame


def deep_note(result: Result) -> str:
    """Say which node was squeezed most between two bodies, or whose middle was deepest inside an obstacle.

    "" where none was. Of the recorded frames; of nodes of ropes with a diameter that an obstacle presses on
    and no anchor holds.
    """
    if not result.scene.obstacles or _FORCE not in result.source.names:
        return ""
    found = _deepest(result)
    told = [_squeezed(result, found.room, found.then)] if found.room else []
    if found.depth > 0.0 and not (found.room and found.row in (found.room.one, found.room.other)):
        told.append(_inside(result, found))
    return "; ".join(told)


def _squeezed(result: Result, room: Room, frame: int) -> str:
    (name, number), bodies = result.layout.rope_of(room.node), result.scene.obstacles
    between = room.words(bodies[room.one].name, bodies[room.other].name)
    return (
        f"at t = {result.time[frame]:.6g} s node {number} of rope {name!r} was squeezed by "
        f"{1e3 * room.lacks:.3g} mm between {between}: a rope has no room there, and its forces are those of "
        "springs. Move the bodies apart, let them stop earlier, or take a thinner rope"
    )


def _inside(result: Result, found: _Deepest) -> str:
    (name, number), body = result.layout.rope_of(found.node), result.scene.obstacles[found.row]
    return (
        f"at t = {result.time[found.frame]:.6g} s the middle of node {number} of rope {name!r} was "
        f"{1e3 * found.depth:.3g} mm inside {body.name!r}, where no rope can be: its force is that of a "
        "spring. If no other body and no anchor pressed it in, give the obstacle a smaller compliance"
    )


def _held_throughout(result: Result) -> list[int]:
    """Return the nodes that anchors hold and do not let go."""
    pairs = zip(result.layout.anchor_nodes, result.scene.anchors, strict=True)
    return [node for node, anchor in pairs if anchor.release_time is None]


def _deepest(result: Result) -> _Deepest:
    """Return the deepest middle of a node, and the least room, of all frames."""
    table, turning = None, result.read(PULLEYS) if result.layout.pulleys else None
    worst = _Deepest()
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
            x, able = np.ascontiguousarray(places[frame].T), loose & pressed[frame]
            inside = depths(now, x, t) - table.thickness
            inside[:, ~able] = -np.inf
            row, node = divmod(int(np.argmax(inside)), inside.shape[1])
            if inside[row, node] > worst.depth:
                found = first + frame, row, node, float(inside[row, node])
                worst = _Deepest(*found, worst.room, worst.then)
            room = tightest(now, x, t, able)
            if room and (worst.room is None or room.lacks > _MORE * worst.room.lacks):
                worst = worst._replace(room=room, then=first + frame)
    return worst
