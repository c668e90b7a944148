"""Steps in which something is stopped at once: its impulse is not to be carried on as a lasting force."""

from __future__ import annotations

from ropewalk.core.jit import part
from ropewalk.laws.bounds import book_tightening, is_stopped
from ropewalk.laws.contact import presses_anew
from ropewalk.laws.links import still_links
from ropewalk.laws.nodes import hits
from ropewalk.laws.rare import are_tied
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
def is_struck_early(system, state, stage):
    """Tell whether a stage presses what was open as the step began: it is struck, whatever later ones do."""
    if system.rare is None or stage.saddle.band.frozen[0] == 1:
        return False
    grip = state.memory.obstacle.grip
    return grip.shape[0] > 0 and presses_anew(stage.forces.node.obstacle, grip) > 0


@part
def strike(system, state, stage, mean, dt, ledger):
    """Book what strings lose that get taut in a step where something is struck; `state` is its beginning."""
    if ledger:
        book_tightening(system, state, mean.elastic, stage.v, dt)


@part
def rest_links(system, state, stage, dt, ledger):
    """Take what a step of implicit Euler leaves rigid links of rates, where another method goes on."""
    if not are_tied(system):
        still_links(system, state, stage.saddle, dt, ledger)


@part
def is_soft(kind, A):
    """Tell whether a step is one of implicit Euler, which lets nothing bounce."""
    return kind == DIRK and A.shape[0] == 1 and A[0, 0] == 1.0
