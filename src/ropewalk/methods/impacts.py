"""Steps in which something is stopped at once: its impulse is not to be carried on as a lasting force."""

from __future__ import annotations

from ropewalk.core.jit import part
from ropewalk.laws.bounds import book_tightening, is_stopped
from ropewalk.laws.ledger import account
from ropewalk.laws.nodes import hits
from ropewalk.methods.stage_report import QUICK
from ropewalk.methods.tableaus import DIRK


@part
def is_struck(system, state, stage, forces, dt):
    """Tell whether something is stopped at once in a step under these `forces`, by a bound or a contact.

    Notes how quickly a contact does it, for the method that shortens steps: there it does not count here.
    """
    quick = hits(system, state, forces.node, dt, stage.x, stage.v)
    stage.report[QUICK] = quick
    free = stage.saddle.band.frozen[0] == 0
    return is_stopped(system, state, forces, dt) or (free and quick > 0.0)


@part
def book_step(system, state, mean, middle, dt, struck, ledger):
    """Book the works of a step with the forces `mean`, and note whether something was `struck` in it."""
    if struck:
        state.jolt[0] = 1.0
    if ledger:
        account(system, state, mean, middle, dt)
        if struck:
            stiffness, floor = state.stiffness, system.slack_floor
            book_tightening(stiffness, floor, mean.elastic, middle, dt, state.work)


@part
def is_soft(kind, A):
    """Tell whether a step is one of implicit Euler, which lets nothing bounce."""
    return kind == DIRK and A.shape[0] == 1 and A[0, 0] == 1.0
