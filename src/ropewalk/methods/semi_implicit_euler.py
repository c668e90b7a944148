"""Semi-implicit (symplectic) Euler, the method of the report and of NeHe's lessons.

    v1 = v0 + h a(x0, v0),   x1 = x0 + h v1
All forces first, then all nodes move: an in-place sweep is another, unstable scheme.
Source: Hairer, Lubich & Wanner, Geometric Numerical Integration, I.1.2.
"""

from __future__ import annotations

from ropewalk.core.jit import kernel, part
from ropewalk.core.status import OK
from ropewalk.laws.anchors import move_anchors, release_anchors
from ropewalk.laws.ledger import account
from ropewalk.laws.limiter import limit_stretch
from ropewalk.laws.table import accelerate, evaluate
from ropewalk.laws.winch import run_winches
from ropewalk.methods.loop import close_frame
from ropewalk.methods.scratch import axpy, push


@part
def step(system, state, scratch, t, after, dt, ledger):
    """Advance the state by one step of `dt` from time `t` [s]."""
    x, v, a, middle = state.x, state.v, state.acceleration, scratch.middle
    evaluate(system, state, x, v, state.forces)
    accelerate(system, state, state.forces, a)
    if ledger:
        axpy(v, 0.5 * dt, a, middle)
    push(x, v, a, dt)
    move_anchors(
        system, state, state.forces, after, dt, middle, ledger, scratch.point, scratch.speed
    )
    if ledger:
        account(system, state, state.forces, middle, dt)


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
        status = close_frame(system, state, frame, out)
        if status != OK and stop_at_break:
            return status, frame
    return OK, frames
