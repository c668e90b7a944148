"""How wheels tie the nodes on them, in Newton's equations: Sherman and Morrison's formula, wheel by wheel.

With A z = f solved, and y = A^-1 u, the solution of (A - u r / s) z = f is z + y (r . z) / (s - r . y).
"""

from __future__ import annotations

import math

from ropewalk.core.jit import deferred, kernel, part
from ropewalk.laws.obstacle_lead import lead_until
from ropewalk.laws.wheel_rows import COLUMN, KEPT, MOVED, PULLED, ROW, TIE
from ropewalk.laws.wheels import aim_wheels, aim_wheels_bdf2, know_rates
from ropewalk.methods.tableaus import DIRK


@part
def has_wheels(system):
    """Tell whether any obstacle turns freely."""
    return system.rare is not None and system.node.obstacle.inertia.shape[0] > 0


@part
def aim_all(system, state, kind, A, b, s, dt, end):
    """Write what is known of a stage of all wheels, and how bodies lead in it, of a step to `end` [s]."""
    lead_until(state, end if kind == DIRK and s == 0 and A[0, 0] > 0.0 else -math.inf)
    if has_wheels(system):
        wheel = state.memory.obstacle.wheel
        if kind == DIRK:
            aim_wheels(wheel, A, b, s, dt)
            know_rates(system.node.obstacle.inertia, wheel)
        else:
            aim_wheels_bdf2(wheel, dt)


@kernel
def put_column(ties, saddle):
    """Exchange the right side of the equations for a wheel's column."""
    for k in range(3):
        for i in range(saddle.force.shape[1]):
            kept = saddle.force[k, i]
            saddle.force[k, i] = ties[COLUMN + k, i]
            ties[COLUMN + k, i] = kept
    for j in range(saddle.misfit.shape[0]):
        ties[KEPT, j] = saddle.misfit[j]
        saddle.misfit[j] = 0.0


@kernel
def take_column(ties, saddle):
    """Keep the solution for a wheel's column, and put the right side back."""
    for k in range(3):
        for i in range(saddle.force.shape[1]):
            kept = saddle.force[k, i]
            saddle.force[k, i] = ties[COLUMN + k, i]
            ties[COLUMN + k, i] = kept
            ties[MOVED + k, i] = saddle.free[i] * saddle.moved[k, i]
    for j in range(saddle.misfit.shape[0]):
        saddle.misfit[j] = ties[KEPT, j]
        ties[PULLED, j] = saddle.pulled[j]


@kernel
def turn_along(ties, saddle):
    """Return r . z of a wheel for the solution in hand."""
    total = 0.0
    for k in range(3):
        for i in range(saddle.free.shape[0]):
            total += ties[ROW + k, i] * saddle.free[i] * saddle.moved[k, i]
    return total


@kernel
def between(ties, other):
    """Return r . y of a wheel's row and another's solution."""
    total = 0.0
    for k in range(3):
        for i in range(ties.shape[1]):
            total += ties[ROW + k, i] * other[MOVED + k, i]
    return total


@deferred()
def tie_wheels(wheel, ties, saddle):
    """Put into the solution, once those for all columns are kept, that nodes turn the wheels."""
    for w in range(wheel.shape[0]):
        if not wheel[w, TIE] > 0.0:
            continue
        left = wheel[w, TIE] - between(ties[w], ties[w])
        for u in range(w + 1, wheel.shape[0]):
            if wheel[u, TIE] > 0.0:
                share = between(ties[w], ties[u]) / left
                for k in range(MOVED, PULLED + 1):
                    for i in range(ties.shape[2]):
                        ties[u, k, i] += share * ties[w, k, i]
        share = turn_along(ties[w], saddle) / left
        for k in range(3):
            for i in range(saddle.free.shape[0]):
                saddle.moved[k, i] += share * ties[w, MOVED + k, i]
        for j in range(saddle.pulled.shape[0]):
            saddle.pulled[j] += share * ties[w, PULLED, j]


@kernel
def along_wheels(wheel, ties, d):
    """Return d . K d of what wheels tie for a direction (3, n) [N m]."""
    total = 0.0
    for w in range(wheel.shape[0]):
        if wheel[w, TIE] > 0.0:
            given, turns = 0.0, 0.0
            for k in range(3):
                for i in range(d.shape[1]):
                    given += ties[w, COLUMN + k, i] * d[k, i]
                    turns += ties[w, ROW + k, i] * d[k, i]
            total -= given * turns / wheel[w, TIE]
    return total
