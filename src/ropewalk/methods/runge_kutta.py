"""Explicit Runge-Kutta methods whose stages each use the stage before: Euler, Heun, the classical RK4.

    stage s:  x_s = x0 + h c_s u_(s-1),  v_s = v0 + h c_s a_(s-1),  u_s = v_s,  a_s = a(x_s, v_s)
    x1 = x0 + h sum b_s u_s,   v1 = v0 + h sum b_s a_s
Source: Hairer, Norsett & Wanner, Solving Ordinary Differential Equations I, II.1.
"""

from __future__ import annotations

import numpy as np

from ropewalk.core.jit import kernel, part
from ropewalk.core.status import OK
from ropewalk.laws.anchors import move_anchors, place_stage, release_anchors
from ropewalk.laws.ledger import account
from ropewalk.laws.limiter import limit_stretch
from ropewalk.laws.table import accelerate, evaluate
from ropewalk.laws.winch import run_winches
from ropewalk.methods.loop import close_frame
from ropewalk.methods.scratch import add, add_forces, axpy, clear, clear_forces, put

# nodes c (row 0) and weights b (row 1)
EULER = np.array([[0.0], [1.0]])
HEUN = np.array([[0.0, 1.0], [0.5, 0.5]])
RK4 = np.array([[0.0, 0.5, 0.5, 1.0], [1 / 6, 1 / 3, 1 / 3, 1 / 6]])


@part
def step(system, state, scratch, t, after, dt, ledger, tableau):
    """Advance the state by one step of `dt` from time `t` [s]."""
    xs, vs, a, middle = scratch.x, scratch.v, state.acceleration, scratch.middle
    dx, dv, mean = scratch.dx, scratch.dv, scratch.mean
    clear_forces(system, mean)
    clear(dx)
    clear(dv)
    for s in range(tableau.shape[1]):
        c, b = dt * tableau[0, s], dt * tableau[1, s]
        if s == 0:
            put(state.x, xs)
            put(state.v, vs)
        else:
            axpy(state.x, c, vs, xs)
            axpy(state.v, c, a, vs)
        if s > 0:
            place_stage(system, state, t + c, c, xs, vs, scratch.point, scratch.speed)
        evaluate(system, state, xs, vs, state.forces)
        accelerate(system, state, state.forces, a)
        add_forces(system, state.forces, tableau[1, s], mean)
        add(vs, b, dx)
        add(a, b, dv)
    add(dx, 1.0, state.x)
    axpy(state.v, 0.5, dv, middle)
    add(dv, 1.0, state.v)
    move_anchors(system, state, mean, after, dt, middle, ledger, scratch.point, scratch.speed)
    if ledger:
        account(system, state, mean, middle, dt)


@kernel
def advance(system, state, scratch, extras, clock, frames, ledger, out, stop_at_break, tableau):
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
            step(system, state, scratch, t, after, dt, ledger, tableau)
            if extras is not None:
                run_winches(system, state, t, dt, ledger)
                limit_stretch(system, state, scratch.limiter, dt, ledger)
        status = close_frame(system, state, frame, out)
        if status != OK and stop_at_break:
            return status, frame
    return OK, frames
