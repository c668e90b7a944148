"""Velocity Verlet for forces that depend on velocity, one evaluation per step.

    x1 = x0 + h v0 + h^2 a0 / 2,   a1 = a(x1, v0 + h a0),   v1 = v0 + h (a0 + a1) / 2
a1 serves the next step as its a0. The predicted velocity v0 + h a0 keeps second order with friction.
Source: Swope, Andersen, Berens & Wilson 1982, J. Chem. Phys. 76:637; predictor as in Groot & Warren 1997
(J. Chem. Phys. 107:4423) with lambda = 1.
"""

from __future__ import annotations

from ropewalk.core.jit import kernel, part
from ropewalk.core.status import OK
from ropewalk.laws.anchors import move_anchors, place_stage, release_anchors
from ropewalk.laws.ledger import account
from ropewalk.laws.limiter import limit_stretch
from ropewalk.laws.table import accelerate, evaluate
from ropewalk.laws.winch import run_winches
from ropewalk.methods.loop import close_frame, prepare
from ropewalk.methods.scratch import add, add_forces, axpy, clear_forces, put


@part
def step(system, state, scratch, t, after, dt, ledger):
    """Advance the state by one step of `dt` from time `t` [s]."""
    x, v, a, middle = state.x, state.v, state.acceleration, scratch.middle
    old, predicted, mean = scratch.x, scratch.v, scratch.mean
    clear_forces(system, mean)
    add_forces(system, state.forces, 0.5, mean)
    put(a, old)
    axpy(v, dt, a, predicted)
    add(v, dt, x)
    add(a, 0.5 * dt * dt, x)
    place_stage(system, state, after, dt, x, predicted, scratch.point, scratch.speed)
    evaluate(system, state, x, predicted, state.forces)
    accelerate(system, state, state.forces, a)
    add_forces(system, state.forces, 0.5, mean)
    add(a, 1.0, old)
    axpy(v, 0.25 * dt, old, middle)
    add(old, 0.5 * dt, v)
    move_anchors(system, state, mean, after, dt, middle, ledger, scratch.point, scratch.speed)
    if ledger:
        account(system, state, mean, middle, dt)


@kernel
def advance(system, state, scratch, extras, clock, frames, ledger, out, stop_at_break):
    """Advance `frames` frames; return the status and the number of good frames.

    `clock` holds t0, dt, steps done and steps per frame, so that t = t0 + step dt, never a sum.
    `extras` is None or 1: with None winches and limiter are left out of the machine code.
    """
    dt = clock[1]
    done, steps = int(clock[2]), int(clock[3])
    for frame in range(frames):
        for s in range(frame * steps, frame * steps + steps):
            t, after = clock[0] + (done + s) * dt, clock[0] + (done + s + 1) * dt
            release_anchors(system, state, t, dt)
            step(system, state, scratch, t, after, dt, ledger)
            if extras is not None:
                run_winches(system, state, t, dt, ledger)
                limit_stretch(system, state, scratch.limiter, dt, ledger)
                prepare(system, state)  # the carried acceleration no longer fits
        status = close_frame(system, state, frame, out)
        if status != OK and stop_at_break:
            return status, frame
    return OK, frames
