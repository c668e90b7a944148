"""How far to go along a Newton step where ropes touch each other or a body: by the slope of a model.

The model keeps the rope as it was linearised and lets the laws of nodes decide anew at every trial,
contacts above all. With f what is out of balance, A the rope's matrix, K that of the laws of nodes, R their
force and d the Newton step, (A + K) d = f, its slope along d is
    Q'(a) = -(1 - a) d.f - a d.K d - d.(R(x + a d) - R(x)) .
A step is whole where it does not rise there by more than a tenth of what it fell by at first; else its root
is looked for. A search on residuals stops at each contact that closes.
Source: Nocedal & Wright, Numerical Optimization, ch. 3 (slopes); Dahlquist & Bjorck, Numerical Methods in
Scientific Computing I, 6.2.2 (Illinois rule).
"""

from __future__ import annotations

import math

from ropewalk.core.band import clear_band, clear_diagonal
from ropewalk.core.jit import deferred, kernel, part
from ropewalk.laws.couplings import along_couplings, couples
from ropewalk.laws.nodes import are_local, marked_node_forces, node_tangents
from ropewalk.laws.pairs.table import LATER
from ropewalk.laws.slip_course import keep_slips
from ropewalk.laws.table import accelerate
from ropewalk.methods.newton_step import is_local, is_simple
from ropewalk.methods.wheel_ties import along_wheels, has_wheels

FLAT = 0.1  # [1] slope over that at the start that counts as none
LONGEST = 0.7  # [1] change of a segment's ends against each other in an iteration, over its length
TRIALS = 12


@kernel
def descent(saddle):
    """Return d . f for the Newton step d in `moved` [J]: what is out of balance, lengths included."""
    total, moved, force, direction = 0.0, saddle.moved, saddle.force, saddle.direction
    for k in range(3):
        for i in range(force.shape[1]):
            total += force[k, i] * moved[k, i]
    for j in range(saddle.misfit.shape[0]):
        e = saddle.compliance[j]
        pull = saddle.misfit[j] / e if e > 0.0 else saddle.pulled[j]  # a rigid link stores nothing
        for k in range(3):
            total -= pull * direction[k, j] * (moved[k, j + 1] - moved[k, j])
    return total


@kernel
def longest_part(moved, rest_length, alive):
    """Return the part of the Newton step that no segment is too short for, 1 at most."""
    most = 0.0
    for j in range(rest_length.shape[0]):
        if alive[j] == 0.0 or rest_length[j] == 0.0:  # springs of no length are never too short
            continue
        square = 0.0
        for k in range(3):
            square += (moved[k, j + 1] - moved[k, j]) ** 2
        most = max(most, math.sqrt(square) / rest_length[j])
    return min(1.0, LONGEST / max(most, 1e-300))


@kernel
def along_diagonal(diagonal, d):
    """Return d . B d of the blocks on the diagonal, for d (3, n)."""
    total = 0.0
    for i in range(d.shape[1]):
        for k in range(3):
            row = 0.0
            for m in range(3):
                row += diagonal[i, 3 * k + m] * d[m, i]
            total += d[k, i] * row
    return total


@kernel
def along_band(band, d):
    """Return d . B d of the blocks next to the diagonal, for d (3, n)."""
    total, n = 0.0, d.shape[1]
    for i in range(n):
        for k in range(3):
            row = 0.0
            for m in range(3):
                row += band.diagonal[i, 3 * k + m] * d[m, i]
                if i + 1 < n:
                    row += band.upper1[i, 3 * k + m] * d[m, i + 1]
                if i > 0:
                    row += band.lower1[i - 1, 3 * k + m] * d[m, i - 1]
            total += d[k, i] * row
    return total


@part
def bend_along(system, state, stage, c1):
    """Return d . K d of the laws of nodes for the Newton step d [J]."""
    saddle, x, v = stage.saddle, stage.x, stage.v
    if is_local(system, state) and not is_simple(system):
        bend = along_diagonal(saddle.band.diagonal, saddle.moved)
    elif are_local(system):
        clear_diagonal(saddle.band)
        node_tangents(system, state, x, v, 1.0, 1.0 / c1, saddle.band)
        bend = along_diagonal(saddle.band.diagonal, saddle.moved)
    else:
        clear_band(saddle.band)
        node_tangents(system, state, x, v, 1.0, 1.0 / c1, saddle.band)
        bend = along_band(saddle.band, saddle.moved)
    bend += along_couplings(system, state, x, v, saddle.moved, 1.0, 1.0 / c1)
    if has_wheels(system):
        held = state.memory.obstacle
        bend += along_wheels(held.wheel, held.ties, saddle.moved)
    return bend


@kernel
def power_along(a, mass, d):
    """Return m a . d summed over nodes [J]; `a` and d are (3, n)."""
    total = 0.0
    for k in range(3):
        for i in range(mass.shape[0]):
            total += mass[i] * a[k, i] * d[k, i]
    return total


@kernel
def go(way, c1, x, v, saddle):
    """Go so much of the Newton step, in positions and velocities."""
    moved, free = saddle.moved, saddle.free
    for k in range(3):
        for i in range(x.shape[1]):
            step = way * free[i] * moved[k, i]
            x[k, i] += step
            v[k, i] += step / c1


@part
def slope_after(system, state, stage, way, c1, known):
    """Go on by `way` of the Newton step; return d . R there, less what is `known` [J]."""
    saddle = stage.saddle
    go(way, c1, stage.x, stage.v, saddle)
    marked_node_forces(system, state, stage.x, stage.v, saddle.band, stage.forces)
    accelerate(system, state, stage.forces, stage.a)
    return power_along(stage.a, state.mass, saddle.moved) - known


@deferred("float64")
def follow_model(system, state, stage, c1, exact):
    """Go along the Newton step; return the part of it that was gone, tensions included.

    With `exact` that is 0 where the step leads uphill: there is no minimum that way.
    """
    saddle = stage.saddle
    drop = descent(saddle)
    most = 1.0
    if couples(system, state):
        most = longest_part(saddle.moved, state.rest_length, stage.segments.alive)
    if exact and not drop > 0.0:
        return 0.0
    known = power_along(stage.a, state.mass, saddle.moved)
    bend = bend_along(system, state, stage, c1)
    if couples(system, state):
        keep_slips(saddle.band.slips, LATER)
    low, high, at, side = 0.0, most, 0.0, 0
    low_slope, high_slope, size = -drop, 0.0, most
    for trial in range(TRIALS):
        rise = slope_after(system, state, stage, size - at, c1, known)
        at = size
        slope = -(1.0 - size) * drop - size * bend - rise
        if not drop > 0.0 or abs(slope) <= FLAT * drop or (trial == 0 and slope < 0.0):
            break
        if slope > 0.0:
            low_slope = 0.5 * low_slope if side == 1 else low_slope
            high, high_slope, side = size, slope, 1
        else:
            high_slope = 0.5 * high_slope if side == -1 else high_slope
            low, low_slope, side = size, slope, -1
        size = low + (high - low) * low_slope / (low_slope - high_slope)
        if trial == TRIALS - 1:
            size = at
    for j in range(stage.tension.shape[0]):
        stage.tension[j] += at * saddle.pulled[j]
    return at
