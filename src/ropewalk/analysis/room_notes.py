"""What `check` says of bodies that come together where a rope starts between them."""

from __future__ import annotations

import numpy as np

from ropewalk.core.arrays import Floats
from ropewalk.laws.obstacle_places import gaps, moves, turning_rate
from ropewalk.lowering import Model
from ropewalk.lowering.rooms import Room, tightest
from ropewalk.scene.motions import Table

# How often in a run bodies are looked at: between two looks one may come and go unseen. At even times, and
# at uneven ones, for what swings may be at the same place at all even ones.
_LOOKS, _UNEVEN = 64, 192


def room_warnings(model: Model) -> list[str]:
    """Return a sentence where bodies that are led leave a rope less room than it is thick.

    Of the places where its free nodes start, at times all over the run: a rope that has moved on is not
    squeezed. Bodies that all stand, and what turns freely, are left out.
    """
    table, until = model.system.node.obstacle, model.scene.run.duration
    led = [
        row
        for row in range(len(table.kind))
        if moves(table, row) or (table.sweeps[row] and turning_rate(table, row, until) > 0.0)
    ]
    if not led or len(table.kind) < 2:
        return []
    x, state = model.state.x, model.state
    able = (state.inverse_mass > 0.0) & (gaps(table, x) > 0.0).all(axis=0)
    able[list(model.layout.anchor_nodes)] = False
    if not able.any():
        return []
    begins, worst, when = tightest(table, x, 0.0, able, touching=False), None, 0.0
    for t in _times(model):
        room = tightest(table, x, t, able, touching=False)
        if room and (worst is None or room.lacks > worst.lacks):
            worst, when = room, t
    if worst is None or (begins and begins.lacks >= worst.lacks):  # told of how it starts
        return []
    return [_words(model, worst, when)]


def _times(model: Model) -> Floats:
    """Return the times at which bodies are looked at [s], (m,): those of their tables, too."""
    until = model.scene.run.duration
    given = [one.motion.times for one in model.scene.obstacles if isinstance(one.motion, Table)]
    uneven = (np.arange(_UNEVEN) + np.random.default_rng(0).random(_UNEVEN)) / _UNEVEN
    even = np.linspace(0.0, until, _LOOKS)
    times = np.concatenate([even, until * uneven, *map(np.asarray, given)])
    found: Floats = np.unique(times[(times > 0.0) & (times <= until)])
    return found


def _words(model: Model, room: Room, t: float) -> str:
    rope, node = model.layout.rope_of(room.node)
    one, other = (model.scene.obstacles[row].name for row in (room.one, room.other))
    return (
        f"node {node} of rope {rope!r} starts between obstacles {room.words(one, other)} at t = {t:.4g} s: "
        "if it is still between them then, it has no room and gives way as a spring does; let them "
        "stop earlier or farther apart, or take a thinner rope"
    )
