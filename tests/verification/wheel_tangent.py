"""The tangent of what presses on a body that turns freely, beside differences of its forces."""

from __future__ import annotations

import numpy as np

from ropewalk.core.arrays import Floats, State
from ropewalk.core.band import make_band
from ropewalk.laws.contact import contact_forces
from ropewalk.laws.contact_tangent import contact_tangent
from ropewalk.laws.registry import NODE_LAWS
from ropewalk.laws.wheel_rows import COLUMN, ROW, TIE
from ropewalk.lowering import build
from ropewalk.scene import Scene


def tangent_and_differences(
    scene: Scene, state: State, ahead: float, size: float, press: float = 0.0, share: float = 0.0
) -> tuple[Floats, Floats, Floats]:
    """Return what a step of the nodes changes in the forces, each (3, n) [N/m].

    By the tangent, by it without what the body ties, and by differences; `ahead` [s] of `state`, off by some
    `size` [m] and a thousand times that in a second, and `press` [m] lower. The state's memory follows.
    With a `share` that is of a step which bodies lead in, see `obstacle_lead`: 1 by implicit Euler.
    """
    table, memory = build(scene).system.node.obstacle, state.memory.obstacle
    rng, n = np.random.default_rng(0), state.x.shape[1]
    now = np.array([state.now[1] + ahead, state.now[1]])
    memory.until[0] = -np.inf if share == 0.0 else state.now[1] + ahead / share
    x = state.x + ahead * state.v + size * rng.normal(size=(3, n)) - [[0.0], [0.0], [press]]
    v = state.v + 1e3 * size * rng.normal(size=(3, n))

    def force(x: Floats, v: Floats) -> Floats:
        found = np.zeros((3, n))
        contact_forces(x, v, table, memory, now, found, 0, n)
        return found

    step, tiny = rng.normal(size=(3, n)), 1e-8
    more, less = (force(x + s * tiny * step, v + s * tiny * step / ahead) for s in (1.0, -1.0))
    band = make_band(n, False, len(NODE_LAWS))
    contact_tangent(x, v, table, memory, now, 1.0, 1.0 / ahead, band)
    alone = np.einsum("nkm,mn->kn", band.diagonal.reshape(n, 3, 3), step)
    tied, tie = alone.copy(), memory.wheel[0, TIE]
    if tie > 0.0:
        turn = (memory.ties[0, ROW : ROW + 3] * step).sum()
        tied -= memory.ties[0, COLUMN : COLUMN + 3] * turn / tie
    return tied, alone, -(more - less) / (2.0 * tiny)
