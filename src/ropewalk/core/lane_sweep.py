"""The solution of `sweep`'s equations for many ropes side by side: the same operations, in the same order."""

from __future__ import annotations

from ropewalk.core.jit import kernel, small
from ropewalk.core.lane_rows import (
    ACROSS,
    BEND,
    COMPLIANCE,
    DIRECTION,
    FACTOR,
    FORCE,
    FREE,
    MASS,
    MISFIT,
    MOVED,
    ON,
    PULLED,
    get,
    get3,
    put,
    put3,
)
from ropewalk.core.lanes import pick, spread
from ropewalk.core.symmetric import add_node, come_back, join, meet, nothing, pass_on, respond


@small
def _inertia(work, i, inertia):
    """Return that of node `i`; `inertia` is 1 / (c1 c2)."""
    zero, one = spread(0.0), spread(1.0)
    return pick(zero, get(work, i, FREE), get(work, i, MASS) * inertia, one)


@small
def _keep(work, i, m, w, y):
    """Write what the way back needs of node `i`, and its solution so far."""
    put3(work, i, FACTOR, (m[0], m[1], m[2]))
    put3(work, i, FACTOR + 3, (m[3], m[4], m[5]))
    put3(work, i, FACTOR + 6, w)
    put3(work, i, MOVED, y)


@small
def _kept(work, i):
    """Return what was kept of node `i`."""
    a, b, w = get3(work, i, FACTOR), get3(work, i, FACTOR + 3), get3(work, i, FACTOR + 6)
    return a[0], a[1], a[2], b[0], b[1], b[2], w[0], w[1], w[2]


@small
def _eliminate(work, passed, i, t, j, before, inertia):
    """Eliminate node `i` with the tension of the segment `before` (-1: none); segment `j` is the next one."""
    stiff, bend = get(work, j, ACROSS), get(work, j, BEND)
    passed = add_node(passed, _inertia(work, i, inertia), get3(work, i, FORCE), t, stiff, bend)
    m, w, y, pull = respond(passed, get(work, i, FREE))
    _keep(work, i, m, w, y)
    if before >= 0:
        put(work, before, PULLED, pull)
    on, e, gap = get(work, j, ON), get(work, j, COMPLIANCE), get(work, j, MISFIT)
    return pass_on(m, y, t, stiff, bend, e, on, gap)


@small
def _return(work, z, i, t, j, before):
    """Put the solution `z` of the node beyond segment `j` into node `i`; return its own."""
    k, stiff, bend = _kept(work, i), get(work, j, ACROSS), get(work, j, BEND)
    change, pull = come_back(k, z, get(work, j, PULLED), t, stiff, bend)
    y = get3(work, i, MOVED)
    z = (y[0] + change[0], y[1] + change[1], y[2] + change[2])
    put3(work, i, MOVED, z)
    if before >= 0:
        put(work, before, PULLED, get(work, before, PULLED) + pull)
    return z


@small
def _turned(t):
    """Return a direction gone through from its other end."""
    return -t[0], -t[1], -t[2]


@kernel
def _eliminate_all(work, n, inertia):
    """Go from both ends to the middle node and solve for it."""
    middle = n // 2
    one = nothing(spread(0.0), spread(1.0))
    other = nothing(spread(0.0), spread(1.0))
    for i in range(n - 1 - middle):
        h, j = n - 1 - i, n - 2 - i
        one = _eliminate(work, one, i, get3(work, i, DIRECTION), i, i - 1, inertia)
        before = h if i > 0 else -1
        other = _eliminate(work, other, h, _turned(get3(work, j, DIRECTION)), j, before, inertia)
    for i in range(n - 1 - middle, middle):  # of an even number of nodes one is left
        one = _eliminate(work, one, i, get3(work, i, DIRECTION), i, i - 1, inertia)
    i = middle
    passed = join(one, other, _inertia(work, i, inertia), get3(work, i, FORCE))
    m, w, y, pull = respond(passed, get(work, i, FREE))
    against, moved = meet(m, y, other)
    p = other[1]
    put(work, i, PULLED, against)
    y = (y[0] - against * moved[0], y[1] - against * moved[1], y[2] - against * moved[2])
    pull = pull - against * (w[0] * p[0] + w[1] * p[1] + w[2] * p[2])
    put3(work, i, MOVED, y)
    put(work, i - 1, PULLED, pull)


@kernel
def _return_all(work, n):
    """Go from the middle node to both ends."""
    middle = n // 2
    z = get3(work, middle, MOVED)
    zz = z
    for i in range(middle - 1, 2 * middle - n, -1):
        h, j = 2 * middle - i, 2 * middle - i - 1
        z = _return(work, z, i, get3(work, i, DIRECTION), i, i - 1)
        before = h if h < n - 1 else -1
        zz = _return(work, zz, h, _turned(get3(work, j, DIRECTION)), j, before)
    for i in range(2 * middle - n, -1, -1):
        z = _return(work, z, i, get3(work, i, DIRECTION), i, i - 1)


@kernel
def lane_sweep(work, n, inertia):
    """Solve the equations of ropes of `n` > 2 nodes; the solution is in MOVED and PULLED.

    `inertia` is 1 / (c1 c2) [1/s^2].
    """
    _eliminate_all(work, n, inertia)
    _return_all(work, n)
