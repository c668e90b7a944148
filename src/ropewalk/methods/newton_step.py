"""One step of Newton's method of a stage: its equations assembled and solved."""

from __future__ import annotations

import numpy as np

from ropewalk.core.arrays import AXIAL
from ropewalk.core.band import clear_diagonal
from ropewalk.core.band_sweep import band_sweep
from ropewalk.core.jit import deferred, kernel, part
from ropewalk.core.network import gather, soften, solve_gathered
from ropewalk.core.sweep import leaning_sweep, sweep
from ropewalk.laws.couplings import add_couplings, couples, order_couplings
from ropewalk.laws.nodes import add_diagonals, are_diagonal, are_local, node_tangents
from ropewalk.laws.rare import are_tied, has_bending, winds
from ropewalk.laws.stretch_tangent import axial_lean
from ropewalk.laws.tangent import add_tangents, begin_tangent
from ropewalk.laws.wheel_rows import TIE
from ropewalk.methods.wheel_ties import has_wheels, put_column, take_column, tie_wheels

COMPRESSION = -0.24  # [1] least geometric stiffness far from the solution, over m / (c1 c2)


@kernel
def stiffen(tension, over, weight, exact, across):
    """Write the geometric stiffness of all segments; return 1 where it was held back, else 0."""
    held_back = 0
    for j in range(tension.shape[0]):
        bend = tension[j] * over[j]
        if bend < COMPRESSION * weight[j] and not exact:
            bend, held_back = COMPRESSION * weight[j], 1
        across[j] = bend
    return held_back


@kernel
def rub_along(damping, rubs, over_c1, mass, free, inertia, saddle):
    """Put inertia and vector friction into the simple system's coefficients."""
    across, along, diagonal = saddle.across, saddle.along, saddle.inertia
    for j in range(damping.shape[0]):
        c = damping[j] * rubs[j] * over_c1
        across[j] += c
        along[j] = c
    for i in range(mass.shape[0]):
        diagonal[i] = mass[i] * inertia if free[i] == 1.0 else 1.0


@part
def is_local(system, state):
    """Tell whether all laws but those of the segments' own stretch act on nodes each by itself."""
    bound = has_bending(system) or are_tied(system) or couples(system, state) or has_wheels(system)
    return not bound and are_local(system) and not winds(system, state)


@part
def is_simple(system):
    """Tell whether all that is local are numbers for every node, and of velocities only."""
    return system.flags[AXIAL] == 0 and are_diagonal(system)


@part
def solve_local(system, state, stage, c1):
    """Assemble and solve the equations of a rope whose laws are local."""
    saddle, x, v, over_c1 = stage.saddle, stage.x, stage.v, 1.0 / c1
    if is_simple(system):
        add_diagonals(system, over_c1, saddle.free, saddle.inertia)
        sweep(saddle)
    else:
        clear_diagonal(saddle.band)
        node_tangents(system, state, x, v, 1.0, over_c1, saddle.band)
        axial, over = state.damping_axial, stage.segments.over
        axial_lean(x, v, axial, over_c1, saddle.band.rubs, over, saddle)
        leaning_sweep(saddle)


@part
def solve_assembled(system, state, stage, c1, coupled):
    """Solve the assembled equations, but for what wheels tie."""
    saddle = stage.saddle
    if coupled:
        if order_couplings(system, state, stage.x, saddle.network):
            gather(saddle, saddle.network)
            add_couplings(system, state, stage.x, stage.v, 1.0, 1.0 / c1, saddle.network)
            solve_gathered(saddle)
        else:  # no room for its blocks: no solution
            saddle.moved[0, 0] = np.inf
    else:
        band_sweep(saddle)


@deferred()
def solve_wheels(system, state, stage, c1, coupled):
    """Solve the assembled equations for the columns of all wheels, see `wheel_ties`."""
    saddle, wheel, ties = stage.saddle, state.memory.obstacle.wheel, state.memory.obstacle.ties
    for w in range(wheel.shape[0]):
        if wheel[w, TIE] > 0.0:
            put_column(ties[w], saddle)
            solve_assembled(system, state, stage, c1, coupled)
            take_column(ties[w], saddle)


@part
def newton_step(system, state, stage, c1, c2, exact, leap):
    """Assemble the equations and solve them; return 1 where compression was held back, else 0.

    With `leap` the tangent of bending has no negative eigenvalue.
    """
    saddle, segments, inertia = stage.saddle, stage.segments, 1.0 / (c1 * c2)
    rubs = saddle.band.rubs
    held_back = stiffen(stage.tension, segments.over, segments.weight, exact, saddle.across)
    coupled = are_tied(system) or couples(system, state)
    if is_local(system, state):
        rub_along(state.damping_vector, rubs, 1.0 / c1, state.mass, saddle.free, inertia, saddle)
        solve_local(system, state, stage, c1)
    else:
        rub_along(state.damping_vector, rubs, 0.0, state.mass, saddle.free, inertia, saddle)
        begin_tangent(system, state, stage.x, stage.v, 1.0, 1.0 / c1, leap, saddle.band)
        add_tangents(system, state, stage.x, stage.v, 1.0, 1.0 / c1, saddle.band)
        if coupled:
            soften(segments.weight, saddle.carries, saddle.compliance)
        if has_wheels(system):
            solve_wheels(system, state, stage, c1, coupled)
        solve_assembled(system, state, stage, c1, coupled)
        if has_wheels(system):
            tie_wheels(state.memory.obstacle.wheel, state.memory.obstacle.ties, saddle)
    return held_back
