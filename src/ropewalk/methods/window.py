"""What goes wrong in a wild step is often a tenth of a rope: that window is solved first, by itself.

Where a rope whips, the residuals that a whole Newton step leaves are those of a few segments, and all others
would be solved again with them (nonlinear elimination: Cai & Keyes, SIAM J. Sci. Comput. 24, 2002). So these
nodes are copied to arrays of their own, those beside them held where they are, solved to `LOCALLY`, and
copied back. The whole system has the last word, by the residual that it always had.
"""

from __future__ import annotations

from typing import Any, NamedTuple

import numpy as np

from ropewalk.core.arrays import TENSION_ONLY, Floats, State, System
from ropewalk.core.jit import deferred, kernel, part
from ropewalk.core.status import OK
from ropewalk.laws.couplings import couples
from ropewalk.laws.pairs.table import FIRST_LOOK, NO_SOLVE
from ropewalk.laws.slip_course import set_course
from ropewalk.methods.stage import Stage, make_stage, newton
from ropewalk.methods.stage_report import AIDED, BEGIN, FIRST, LAST, PAUSED, SOLVES, TIGHT, UNAIDED

SMALL, LARGE = 64, 256  # nodes of a window
TIMES = 4  # [1] ropes are longer than a window by this factor at least
MOST_AIDS = 4  # in a solve of a stage
MARGIN = 10  # nodes on either side of those that are far from the solution
LOCALLY = 1e-6  # [1] force residual over the largest force, when a window is solved


class Window(NamedTuple):
    """A system of its own, for a run of nodes."""

    system: System
    state: State
    stage: Stage
    floor: Floats  # (s,) `System.slack_floor` of the whole rope


class Windows(NamedTuple):
    """Two lengths of them; in place of one too long for the rope is the rope itself."""

    small: Window
    large: Window


def make_windows(system: System, state: State, stage: Stage) -> Windows | None:
    """Return room for windows of a rope; None where other laws act than springs, friction and weight."""
    if system.rare is not None:
        return None
    nodes, whole = state.x.shape[1], Window(system, state, stage, system.slack_floor)
    nodes = 0 if _rubs_where_taut(system, state) else nodes
    small, large = (
        _make(system, state, size) if TIMES * size <= nodes else whole for size in (SMALL, LARGE)
    )
    return Windows(small, large)


def _rubs_where_taut(system: System, state: State) -> bool:
    """Tell whether friction begins and ends with tension: decided by windows, it takes more solves in all."""
    rubs = state.damping_vector.any() or state.damping_axial.any()
    return bool(system.flags[TENSION_ONLY] == 1 and rubs)


def _make(system: System, state: State, nodes: int) -> Window:
    forces, row, sums = state.forces, np.zeros((3, nodes)), np.zeros((3, nodes + 1))
    own = state._replace(
        x=row.copy(),
        mass=np.zeros(nodes),
        inverse_mass=np.zeros(nodes),
        tension=np.zeros(nodes - 1),
        rest_length=np.zeros(nodes - 1),
        stiffness=np.zeros(nodes - 1),
        damping_vector=np.zeros(nodes - 1),
        damping_axial=np.zeros(nodes - 1),
        forces=forces._replace(
            elastic=sums, friction=sums.copy(), applied=row, node=_nowhere(forces.node)
        ),
    )
    floor = system.slack_floor
    return Window(system._replace(slack_floor=np.zeros(nodes - 1)), own, make_stage(own), floor)


def _nowhere(channels: Any) -> Any:
    """Return forces of laws of nodes that do not act."""
    return type(channels)(*(np.zeros((3, 0)) for _ in channels))


@kernel
def enter(window, state, stage, lo):
    """Copy the nodes from `lo` on into a window; its ends are held where the rope goes on."""
    own, inner = window.state, window.stage
    n = own.mass.shape[0]
    for k in range(3):
        for i in range(n):
            inner.x[k, i], inner.v[k, i] = stage.x[k, lo + i], stage.v[k, lo + i]
            inner.x_known[k, i] = stage.x_known[k, lo + i]
            inner.v_known[k, i] = stage.v_known[k, lo + i]
            own.forces.applied[k, i] = state.forces.applied[k, lo + i]
    for i in range(n):
        inside = (i > 0 or lo == 0) and (i < n - 1 or lo + n == state.mass.shape[0])
        own.mass[i] = state.mass[lo + i]
        own.inverse_mass[i] = state.inverse_mass[lo + i] if inside else 0.0
    for j in range(n - 1):
        inner.tension[j] = stage.tension[lo + j]
        own.rest_length[j], own.stiffness[j] = state.rest_length[lo + j], state.stiffness[lo + j]
        own.damping_vector[j] = state.damping_vector[lo + j]
        own.damping_axial[j] = state.damping_axial[lo + j]
        window.system.slack_floor[j] = window.floor[lo + j]
        inner.saddle.band.rubs[j] = stage.saddle.band.rubs[lo + j]
    inner.saddle.band.frozen[0] = stage.saddle.band.frozen[0]


@kernel
def leave(inner, stage, lo, c1):
    """Copy what a window has found back to the rope, its velocities so that X = x^ + c1 V."""
    free = inner.saddle.free
    for k in range(3):
        for i in range(free.shape[0]):
            if free[i] != 0.0:
                stage.x[k, lo + i] = inner.x[k, i]
                stage.v[k, lo + i] = (inner.x[k, i] - inner.x_known[k, i]) / c1
    for j in range(inner.tension.shape[0]):
        stage.tension[lo + j] = inner.tension[j]
        stage.saddle.band.rubs[lo + j] = inner.saddle.band.rubs[j]


@part
def solve_window(window, state, stage, c1, c2):
    """Solve in a window around the nodes that the stage has paused for; return whether it has a solution."""
    n, inner, report = window.state.mass.shape[0], window.stage, stage.report
    lo = (int(report[FIRST]) + int(report[LAST]) + 1 - n) // 2
    lo = min(max(lo, 0), state.mass.shape[0] - n)
    enter(window, state, stage, lo)
    before = inner.report[SOLVES]
    status = newton(window.system, window.state, inner, c1, c2, LOCALLY, 0, BEGIN)
    report[SOLVES] += (inner.report[SOLVES] - before) * n / state.mass.shape[0]
    if status == OK:
        leave(inner, stage, lo, c1)
    return status == OK


@part
def fits(window, state):
    """Tell whether a window is much shorter than the rope."""
    return TIMES * window.state.mass.shape[0] <= state.mass.shape[0]


@part
def widest(windows, state):
    """Return how many nodes may be solved first; none where other laws act, or the rope is short."""
    if windows is None or not fits(windows.small, state):
        return 0
    return (LARGE if fits(windows.large, state) else SMALL) - 2 * MARGIN


@deferred("int64")
def solve_stage(system, state, stage, windows, c1, c2):
    """Solve the stage as `stage.newton` does, with windows where that pauses; return OK or UNSOLVED."""
    slips = stage.saddle.band.slips
    touching = couples(system, state)
    if touching:
        set_course(state, slips, FIRST_LOOK)
    most, aid, aids = widest(windows, state), BEGIN, 0
    while True:
        window = most if aids < MOST_AIDS else -most
        status = newton(system, state, stage, c1, c2, TIGHT, window, aid)
        if windows is None or status != PAUSED:
            if touching:
                set_course(state, slips, NO_SOLVE)
            return status
        nodes, aids = stage.report[LAST] - stage.report[FIRST], aids + 1
        if nodes < SMALL - 2 * MARGIN:
            solved = solve_window(windows.small, state, stage, c1, c2)
        else:
            solved = solve_window(windows.large, state, stage, c1, c2)
        aid = AIDED if solved else UNAIDED
