"""Semi-implicit (symplectic) Euler, the method of the report and of NeHe's lessons.

    v1 = v0 + h a(x0, v0),   x1 = x0 + h v1
All forces first, then all nodes move: an in-place sweep is another, unstable scheme.
Source: Hairer, Lubich & Wanner, Geometric Numerical Integration, I.1.2.
"""

from __future__ import annotations

from ropewalk.core.arrays import Forces
from ropewalk.core.jit import deferred, kernel, part, small
from ropewalk.core.ranges import rows
from ropewalk.laws.anchors import move_anchors
from ropewalk.laws.inner import note_strains, relax
from ropewalk.laws.ledger import account, book_growth
from ropewalk.laws.rare import any_acts, has_inner, winds
from ropewalk.laws.table import (
    accelerate,
    add_up_and_look,
    add_up_springs,
    evaluate,
    has_plain_forces,
    has_plain_springs,
)
from ropewalk.methods.peaks import (
    adds_to_springs,
    heights,
    keep_anchors,
    keep_last,
    keep_nodes,
    keep_pressed,
    keep_springs,
    wanted,
)
from ropewalk.methods.scratch import axpy, clear_nodes, push
from ropewalk.methods.tiles import make_tiled_advance


@small
def swing(x, v, elastic, friction, inverse_mass, gravity, dt, middle, lo, hi):
    """Move nodes under springs, friction and weight: `accelerate`, `axpy` and `push` in one sweep.

    The same arithmetic and so the same bits, but half the memory traffic. Without a ledger `friction`
    (then a part of `elastic`) and `middle` are None.
    """
    inverse_mass = inverse_mass[lo:hi]
    gx, gy, gz = gravity[0], gravity[1], gravity[2]
    x0, x1, x2 = rows(x, lo, hi)
    v0, v1, v2 = rows(v, lo, hi)
    e0, e1, e2 = rows(elastic, lo, hi + 1)
    if middle is None:
        _swing(x0, v0, e0, None, inverse_mass, gx, dt, None)
        _swing(x1, v1, e1, None, inverse_mass, gy, dt, None)
        _swing(x2, v2, e2, None, inverse_mass, gz, dt, None)
    else:
        c0, c1, c2 = rows(friction, lo, hi + 1)
        m0, m1, m2 = rows(middle, lo, hi)
        _swing(x0, v0, e0, c0, inverse_mass, gx, dt, m0)
        _swing(x1, v1, e1, c1, inverse_mass, gy, dt, m1)
        _swing(x2, v2, e2, c2, inverse_mass, gz, dt, m2)


@part
def _swing(x, v, e, c, inverse_mass, g, dt, middle):
    for i in range(inverse_mass.shape[0]):
        force = e[i + 1] - e[i] if c is None else e[i + 1] + c[i + 1] - (e[i] + c[i])
        a = force * inverse_mass[i] + (g if inverse_mass[i] > 0.0 else 0.0)
        if middle is not None:
            middle[i] = v[i] + 0.5 * dt * a
        new = v[i] + dt * a
        v[i] = new
        x[i] += dt * new


@kernel
def look_ahead(state, over, about):
    """Write 1 / (k L) of every segment, (s,), and whether any has friction, and that needs no more, (2,)."""
    rub, more = 0, 0
    for j in range(over.shape[0]):
        rubs = state.damping_vector[j] + state.damping_axial[j] > 0.0
        product = state.stiffness[j] * state.rest_length[j]
        over[j] = 1.0 / product if product > 0.0 else 0.0
        rub += 1 if rubs else 0
        more += 1 if rubs and not product > 0.0 else 0
    about[0], about[1] = (1.0 if rub > 0 else 0.0), (1.0 if more == 0 else 0.0)


@part
def prepare(state, scratch):
    """Prepare for steps."""
    look_ahead(state, scratch.over, scratch.about)
    scratch.about[2] = 0.0


@deferred()
def swing_under_springs(system, state, about, over, heights_at, dt, looks, lo, hi):
    """Move nodes under springs, friction and weight alone, without a ledger; see `step`."""
    x, v, elastic = state.x, state.v, state.forces.elastic
    rubs, quick = about[0] == 1.0, about[1] == 1.0
    if looks and (quick or not rubs):
        height = heights(x, system.up, heights_at, lo, hi)
        add_up_and_look(system, state, x, v, elastic, rubs, over, height, lo, hi)
        keep_last(state, height, hi)
    else:
        if looks:
            keep_nodes(system, state, lo, hi)
            keep_springs(system, state, rubs, lo, hi)
        add_up_springs(system, state, x, v, elastic, lo, hi)
    swing(x, v, elastic, None, state.inverse_mass, system.gravity, dt, None, lo, hi)


@part
def step(system, state, scratch, t, after, dt, ledger, tableau, lo, hi):
    """Advance nodes `lo` to `hi - 1` by one step of `dt` from time `t` [s].

    Most ropes have springs, friction and weight alone. For them the sweeps over the nodes are fewer;
    without a ledger both forces of a segment are one sum, in the place of the elastic ones. What the step
    begins with is looked at by the way, where `watch` does not.
    """
    x, v, a, middle = state.x, state.v, state.acceleration, scratch.middle
    elastic, friction = state.forces.elastic, state.forces.friction
    w, g = state.inverse_mass, system.gravity
    plain = has_plain_forces(system, state)
    looks = wanted(state) and not adds_to_springs(system, state)
    if has_inner(system, state):
        note_strains(system, state)
    rubs = scratch.about[0] == 1.0
    if plain and any_acts(system) and scratch.about[2] == 0.0:  # ropes that touch nothing now
        clear_nodes(system, state.forces.node, state.forces.node, 0.0, 0.0, lo, hi)
    scratch.about[2] = 1.0 if plain else 0.0
    if plain and not ledger and has_plain_springs(system, state):
        swing_under_springs(
            system, state, scratch.about, scratch.over, scratch.dx[0], dt, looks, lo, hi
        )
        friction = scratch.mean.friction  # zero
    else:
        if looks:
            keep_nodes(system, state, lo, hi)
            keep_springs(system, state, rubs, lo, hi)
        evaluate(system, state, x, v, state.forces, lo, hi)
        if plain and ledger:
            swing(x, v, elastic, friction, w, g, dt, middle, lo, hi)
        else:
            accelerate(system, state, state.forces, a, lo, hi)
            if ledger:
                axpy(v, 0.5 * dt, a, middle, lo, hi)
            push(x, v, a, dt, lo, hi)
    node, applied = state.forces.node, state.forces.applied
    bending, limiter = state.forces.bending, state.forces.limiter
    forces = Forces(elastic, friction, node, applied, bending, limiter)
    point, speed = scratch.point, scratch.speed
    move_anchors(system, state, forces, after, dt, middle, point, speed, lo, hi)
    if looks:
        keep_anchors(system, state, lo, hi)
        keep_pressed(system, state, after)  # where there are obstacles no rope is cut into tiles
    if winds(system, state):
        book_growth(system, state, friction, dt, lo, hi)
    if ledger:
        account(system, state, forces, middle, dt, lo, hi)
    if has_inner(system, state):
        relax(system, state, dt, ledger)


advance = make_tiled_advance(step, prepare)
