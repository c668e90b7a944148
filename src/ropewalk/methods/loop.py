"""The loop over frames and steps, one for all methods, and what comes before and after it."""

from __future__ import annotations

from typing import Any

from ropewalk.core.jit import kernel, part
from ropewalk.core.status import OK
from ropewalk.laws.anchors import release_anchors
from ropewalk.laws.limiter import limit_stretch
from ropewalk.laws.links import hold_links
from ropewalk.laws.stretch import segment_tension
from ropewalk.laws.table import accelerate, evaluate, reaches_neighbours_only
from ropewalk.laws.winch import run_winches
from ropewalk.methods.recording import check_state, record_frame
from ropewalk.methods.scratch import clear

TILE = 1024  # nodes; about 250 kB of all their arrays
DEPTH = 32  # steps


@kernel
def prepare(system, state):
    """Evaluate all forces and accelerations at the state itself; what a method kept is void."""
    evaluate(system, state, state.x, state.v, state.forces)
    if system.limiter.active == 1:
        clear(state.forces.limiter)
    accelerate(system, state, state.forces, state.acceleration)
    floor = system.slack_floor
    segment_tension(state.x, state.rest_length, state.stiffness, floor, state.tension)
    state.past[0] = 0.0


@kernel
def prepare_links(system, state, t, saddle):
    """As `prepare`, and hold the lengths of rigid links at time `t` [s]; `saddle` lends its arrays."""
    prepare(system, state)
    hold_links(system, state, t, saddle)


@part
def _prepare_solver(system, state, t, scratch):
    """Prepare for a method that solves."""
    prepare_links(system, state, t, scratch.stage.saddle)


@part
def _prepare_other(system, state, t, scratch):
    """Prepare for a method without equations."""
    prepare(system, state)


@part
def _wind(system, state, scratch, t, dt, ledger):
    """Let winches act on the end of a step; a method that solves has the limiter in its equations."""
    run_winches(system, state, t, dt, ledger)


@part
def _wind_and_limit(system, state, scratch, t, dt, ledger):
    """Let winches and limiter act on the end of a step."""
    run_winches(system, state, t, dt, ledger)
    limit_stretch(system, state, scratch.limiter, dt, ledger)


@kernel
def close_frame(system, state, ledger, sums, frame, out):
    """Record the frame where `out` has it; return the state's status. `sums` is working space."""
    if out.x.shape[0] > frame:
        record_frame(system, state, ledger, sums, frame, out)
    return check_state(state, system.break_stretch)


def _module(step: Any) -> str:
    """Return the module of a part, which is a plain function where numba is switched off."""
    return str(getattr(step, "py_func", step).__module__)


def make_advance(
    step: Any, *, carries: bool = False, solves: bool = False, tiles: bool = False
) -> Any:
    """Return the kernel that advances by a method's `step`, a part compiled into it.

    `carries` says that a step begins with the forces and accelerations that the one before ended with,
    `solves` that it solves equations and returns a status, `tiles` that a step takes a range of nodes.
    Then a long rope is cut into tiles that fit the cache, and a tile goes through up to DEPTH steps
    before the next one: from step to step it moves back by one node, so that all neighbours stand where
    they are needed and every node goes through the same arithmetic as in one sweep, to the same bits.
    What a tile needs of the segment before it is in the force arrays: written by the tile before it in the
    same step, and reached by none of the later ones.
    """
    begin_anew = _prepare_solver if solves else _prepare_other
    act_after = _wind if solves else _wind_and_limit

    def advance(system, state, scratch, extras, clock, frames, ledger, out, stop_at_break, tableau):
        """Advance `frames` frames; return the status and the number of good frames.

        `clock` holds t0, dt, steps done and steps per frame, so that t = t0 + step dt, never a sum.
        `extras` is None or 1: with None winches and limiter are left out of the machine code.
        `tableau` holds the method's coefficients, if it has any.
        """
        dt = clock[1]
        done, steps = int(clock[2]), int(clock[3])
        n = state.mass.shape[0]
        width = TILE if tiles and extras is None and reaches_neighbours_only(system) else n
        for frame in range(frames):
            for start in range(done, done + steps, DEPTH):
                first = 0
                while first < n:
                    last = first + width if n - first >= 2 * width else n
                    for s in range(start, min(start + DEPTH, done + steps)):
                        lo = first - (s - start) if first > 0 else 0
                        hi = last - (s - start) if last < n else n
                        t, after = clock[0] + s * dt, clock[0] + (s + 1) * dt
                        if release_anchors(system, state, t, dt, lo, hi) and carries:
                            begin_anew(system, state, t, scratch)
                        if tiles:
                            step(system, state, scratch, t, after, dt, ledger, tableau, lo, hi)
                        elif solves:
                            status = step(system, state, scratch, t, after, dt, ledger, tableau)
                            if status != OK:
                                return status, frame
                        else:
                            step(system, state, scratch, t, after, dt, ledger, tableau)
                        if extras is not None:
                            act_after(system, state, scratch, t, dt, ledger)
                            if carries:
                                begin_anew(system, state, after, scratch)
                    first = last
            done += steps
            status = close_frame(system, state, ledger, scratch.sums, frame, out)
            if status != OK and stop_at_break:
                return status, frame
        return OK, frames

    # Files of machine code are named after the function: one name for every method.
    advance.__qualname__ = f"advance-{_module(step).rpartition('.')[2]}"
    return kernel(advance)
