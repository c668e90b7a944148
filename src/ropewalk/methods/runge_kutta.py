"""Explicit Runge-Kutta methods whose stages each use the stage before; their tables: `explicit_methods`.

    stage s:  x_s = x0 + h c_s u_(s-1),  v_s = v0 + h c_s a_(s-1),  u_s = v_s,  a_s = a(x_s, v_s)
    x1 = x0 + h sum b_s u_s,   v1 = v0 + h sum b_s a_s
Source: Hairer, Norsett & Wanner, Solving Ordinary Differential Equations I, II.1.
"""

from __future__ import annotations

from ropewalk.core.jit import apart, part
from ropewalk.laws.anchors import move_anchors, place_stage
from ropewalk.laws.inner import end_stages, next_stage
from ropewalk.laws.ledger import account, book_growth
from ropewalk.laws.rare import has_inner, winds
from ropewalk.laws.table import accelerate, evaluate
from ropewalk.laws.winch import wind_to
from ropewalk.laws.winch_books import book_begin, book_end, book_memory
from ropewalk.methods.loop import make_advance
from ropewalk.methods.means import add_to_mean, begin_mean


@apart
def begin(x, v, xs, vs):
    """Begin a step: the first stage is the state; all (3, n)."""
    for k in range(3):
        xk, vk, places, speeds = x[k], v[k], xs[k], vs[k]
        for i in range(xk.shape[0]):
            places[i], speeds[i] = xk[i], vk[i]


@apart
def go_on(x, v, a, c, b, first, xs, vs, dx, dv):
    """Add `b` [s] of a stage, the `first`, to what the step brings; write the next, at `c` [s] in it."""
    for k in range(3):
        xk, vk, ak, places, speeds, moved, pushed = x[k], v[k], a[k], xs[k], vs[k], dx[k], dv[k]
        for i in range(xk.shape[0]):
            moved[i] = (0.0 if first else moved[i]) + b * speeds[i]
            pushed[i] = (0.0 if first else pushed[i]) + b * ak[i]
            places[i] = xk[i] + c * speeds[i]
            speeds[i] = vk[i] + c * ak[i]


@apart
def finish(x, v, a, b, first, vs, dx, dv, middle, ledger):
    """Add `b` [s] of the last stage, and all that the step brings to the state; `first` if no other was."""
    for k in range(3):
        xk, vk, ak, speeds, moved, pushed, mid = x[k], v[k], a[k], vs[k], dx[k], dv[k], middle[k]
        for i in range(xk.shape[0]):
            xk[i] += (0.0 if first else moved[i]) + b * speeds[i]
            push = (0.0 if first else pushed[i]) + b * ak[i]
            if ledger:
                mid[i] = vk[i] + 0.5 * push
            vk[i] += push


@part
def step(system, state, scratch, t, after, dt, ledger, tableau):
    """Advance the state by one step of `dt` from time `t` [s]."""
    xs, vs, a, middle = scratch.x, scratch.v, state.acceleration, scratch.middle
    dx, dv, mean = scratch.dx, scratch.dv, scratch.mean
    last = tableau.shape[1] - 1
    begin(state.x, state.v, xs, vs)
    for s in range(last + 1):
        c, b = dt * tableau[0, s], dt * tableau[1, s]
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
        if s == 0:
            begin_mean(system, state, tableau[1, s], mean, ledger)
        else:
            add_to_mean(system, state, tableau[1, s], mean, ledger)
        if s < last:
            go_on(state.x, state.v, a, dt * tableau[0, s + 1], b, s == 0, xs, vs, dx, dv)
        else:
            if winds(system, state):
                book_begin(system, state, state.x, t, after, scratch.turning)
            finish(state.x, state.v, a, b, s == 0, vs, dx, dv, middle, ledger)
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
