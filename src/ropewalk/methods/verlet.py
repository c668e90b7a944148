"""Velocity Verlet for forces that depend on velocity, one evaluation per step.

    x1 = x0 + h v0 + h^2 a0 / 2,   a1 = a(x1, v0 + h a0),   v1 = v0 + h (a0 + a1) / 2
a1 serves the next step as its a0. The predicted velocity v0 + h a0 keeps second order with friction.
Source: Swope, Andersen, Berens & Wilson 1982, J. Chem. Phys. 76:637; predictor as in Groot & Warren 1997
(J. Chem. Phys. 107:4423) with lambda = 1.
"""

from __future__ import annotations

from ropewalk.core.jit import apart, part
from ropewalk.laws.anchors import move_anchors, place_stage
from ropewalk.laws.inner import note_strains, relax_while_winding
from ropewalk.laws.ledger import account, book_growth
from ropewalk.laws.rare import has_inner, winds
from ropewalk.laws.table import accelerate, evaluate
from ropewalk.laws.winch_books import book_begin, book_end, book_memory
from ropewalk.methods.loop import make_advance
from ropewalk.methods.means import add_to_mean, begin_mean


@apart
def drift(x, v, a, dt, old, predicted):
    """Keep the acceleration, predict the velocity, and move all nodes, in one sweep, (3, n)."""
    for k in range(3):
        xk, vk, ak, kept, ahead = x[k], v[k], a[k], old[k], predicted[k]
        for i in range(xk.shape[0]):
            kept[i] = ak[i]
            ahead[i] = vk[i] + dt * ak[i]
            xk[i] = xk[i] + dt * vk[i] + 0.5 * dt * dt * ak[i]


@apart
def kick(v, old, a, dt, middle, ledger):
    """Write velocities of the end, and for a ledger of the middle, of accelerations at both ends, (3, n)."""
    for k in range(3):
        vk, before, ak, mid = v[k], old[k], a[k], middle[k]
        for i in range(vk.shape[0]):
            both = before[i] + ak[i]
            if ledger:
                mid[i] = vk[i] + 0.25 * dt * both
            vk[i] += 0.5 * dt * both


@part
def step(system, state, scratch, t, after, dt, ledger, tableau):
    """Advance the state by one step of `dt` from time `t` [s]."""
    x, v, a, middle = state.x, state.v, state.acceleration, scratch.middle
    old, predicted, mean = scratch.x, scratch.v, scratch.mean
    begin_mean(system, state, 0.5, mean, ledger)
    if has_inner(system, state):
        note_strains(system, state)
    if winds(system, state):
        book_begin(system, state, x, t, after, scratch.turning)
    drift(x, v, a, dt, old, predicted)
    place_stage(system, state, after, dt, x, predicted, scratch.point, scratch.speed)
    if has_inner(system, state):
        relax_while_winding(system, state, dt, ledger)
    evaluate(system, state, x, predicted, state.forces)
    accelerate(system, state, state.forces, a)
    add_to_mean(system, state, 0.5, mean, ledger)
    kick(v, old, a, dt, middle, ledger)
    move_anchors(system, state, mean, after, dt, middle, scratch.point, scratch.speed)
    if winds(system, state):
        book_end(system, state, x, t, after, scratch.turning)
        book_growth(system, state, mean.friction, dt)
        book_memory(system, state, t, after, scratch.turning)
    if ledger:
        account(system, state, mean, middle, dt)


advance = make_advance(step, carries=True)
