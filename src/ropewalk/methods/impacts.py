"""Steps in which something is stopped at once: its impulse is not to be carried on as a lasting force."""

from __future__ import annotations

from ropewalk.core.jit import part
from ropewalk.laws.bounds import is_stopped
from ropewalk.laws.nodes import hits
from ropewalk.methods.tableaus import DIRK


@part
def is_struck(system, state, stage, forces, dt):
    """Tell whether something is stopped at once in a step under these `forces`, by a bound or a contact."""
    if is_stopped(system, state, forces, dt):
        return True
    free = stage.saddle.band.frozen[0] == 0
    return free and hits(system, state, forces.node, dt, stage.x, stage.v) > 0.0


@part
def is_soft(kind, A):
    """Tell whether a step is one of implicit Euler, which lets nothing bounce."""
    return kind == DIRK and A.shape[0] == 1 and A[0, 0] == 1.0
