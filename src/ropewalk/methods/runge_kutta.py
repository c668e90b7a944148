"""Explicit Runge-Kutta methods whose stages each use the stage before: Euler, Heun, the classical RK4.

    stage s:  x_s = x0 + h c_s u_(s-1),  v_s = v0 + h c_s a_(s-1),  u_s = v_s,  a_s = a(x_s, v_s)
    x1 = x0 + h sum b_s u_s,   v1 = v0 + h sum b_s a_s
Source: Hairer, Norsett & Wanner, Solving Ordinary Differential Equations I, II.1.
"""

from __future__ import annotations

import numpy as np

from ropewalk.core.jit import part
from ropewalk.laws.anchors import move_anchors, place_stage
from ropewalk.laws.inner import end_stages, next_stage
from ropewalk.laws.ledger import account, book_growth
from ropewalk.laws.rare import has_inner, winds
from ropewalk.laws.table import accelerate, evaluate
from ropewalk.laws.winch import wind_to
from ropewalk.laws.winch_books import book_begin, book_end, book_memory
from ropewalk.methods.loop import make_advance
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
            # The last one may end at a kink, just before which `after` is.
            time = after if c == dt and system.kinks.shape[0] > 0 else t + c
            place_stage(system, state, time, c, xs, vs, scratch.point, scratch.speed)
            if winds(system, state):
                wind_to(system, state, time, scratch.turning)
        if has_inner(system, state):
            next_stage(system, state, xs, c, b, s == 0)
        evaluate(system, state, xs, vs, state.forces)
        accelerate(system, state, state.forces, a)
        add_forces(system, state.forces, tableau[1, s], mean)
        add(vs, b, dx)
        add(a, b, dv)
    if winds(system, state):
        book_begin(system, state, state.x, t, after, scratch.turning)
    add(dx, 1.0, state.x)
    axpy(state.v, 0.5, dv, middle)
    add(dv, 1.0, state.v)
    move_anchors(system, state, mean, after, dt, middle, scratch.point, scratch.speed)
    if winds(system, state):
        book_end(system, state, state.x, t, after, scratch.turning)
        book_growth(system, state, mean.friction, dt)
    if ledger:
        account(system, state, mean, middle, dt)
    if has_inner(system, state):
        end_stages(system, state, dt, ledger)
        if winds(system, state):
            book_memory(system, state, t, after, scratch.turning)


advance = make_advance(step)
