"""Ropes that relax: a spring and a damper in series, the arm, beside the spring or curve of every segment.

    T = EA g(e) + EA1 (e - d),   d' = (e - d) / tau,   energy of the arm  EA1 L (e - d)^2 / 2

e the strain and d that of the arm's damper: the standard linear solid, where g is straight. A tension-only
segment that is slack keeps the strain without tension, and relaxes as one that nothing pulls.
`State.stiffness` is (EA + EA1) / L, that of a sudden stretch; at rest d = e, and EA alone is left.

* Runge-Kutta methods have d among their unknowns.
* Semi-implicit Euler and Verlet take d exactly over the step, with e linear in time: for any tau.
* A stage of an implicit method knows d = d^ + c d', so that e - d = (e - d^) / (1 + c / tau): the arm is a
  spring of EA1 / (1 + c / tau) about d^, and only compliance and length of a segment change.

The damper takes EA1 L tau (d1 - d0)^2 / h in a step of h, the mean force times the way, as the ledger has it;
this is booked as friction, and taken out of what springs did.
Source: Findley, Lai & Onaran, Creep and Relaxation of Nonlinear Viscoelastic Materials, ch. 5.
"""

from __future__ import annotations

import math

from ropewalk.core.jit import kernel, part, small
from ropewalk.laws.curved import (
    CHANGE,
    DAMPER,
    FIRST,
    RATE,
    at_tension,
    held_strain,
    stretched,
)
from ropewalk.laws.rare import relaxes

_SHORT = 1e-3  # [1] a step over the relaxation time below which a series is exact


@small
def arm_of(curves, stiffness, j):
    """Return the curve of a segment whose arm acts, else -1."""
    which = curves.of[j]
    if which >= 0 and not (stiffness[j] > 0.0 and curves.arm[which] > 0.0):
        which = -1
    return which


@kernel
def strains(curves, stiffness, rest_length, floor, x, damper, out):
    """Write the strain of what the segments are made of at places `x`, (s,) [1]."""
    for j in range(out.shape[0]):
        which = arm_of(curves, stiffness, j)
        if which >= 0:
            strain = (stretched(x, j) - rest_length[j]) / rest_length[j]
            out[j] = held_strain(curves, which, floor[j], strain, damper[j])


@kernel
def rates(curves, stiffness, strain, damper, out):
    """Write d' of every segment, (s,) [1/s]; `out` may be `strain`."""
    for j in range(out.shape[0]):
        which = arm_of(curves, stiffness, j)
        out[j] = (strain[j] - damper[j]) / curves.time[which] if which >= 0 else 0.0


@part
def write_rates(system, state, x, out):
    """Write d' of every segment at places `x`, (s,) [1/s], for the d that the state has."""
    curves, k, damper = system.curves, state.stiffness, state.arm[DAMPER]
    strains(curves, k, state.rest_length, system.slack_floor, x, damper, out)
    rates(curves, k, out, damper, out)


@part
def note_strains(system, state):
    """Note what a step begins with."""
    curves, k, first = system.curves, state.stiffness, state.arm[FIRST]
    floor, damper = system.slack_floor, state.arm[DAMPER]
    strains(curves, k, state.rest_length, floor, state.x, damper, first)


@part
def relax(system, state, dt, ledger):
    """Take the dampers through a step of `dt` [s] that has led to the places in `state`."""
    floor = system.slack_floor
    relax_through(system.curves, state.stiffness, state.rest_length, floor, state.x, state.arm, dt)
    if ledger:
        book_heat(system, state, dt)


@kernel
def relax_through(curves, stiffness, rest_length, floor, x, arm, dt):
    """Move the dampers, the strain being linear in time; twice, as one that is slack follows its damper."""
    for j in range(arm.shape[1]):
        which = arm_of(curves, stiffness, j)
        if which < 0:
            continue
        share = dt / curves.time[which]
        gone = -math.expm1(-share)
        late = 1.0 - gone / share
        if share < _SHORT:
            late = share * (0.5 - share * (1.0 / 6.0 - share / 24.0))
        before, first = arm[DAMPER, j], arm[FIRST, j]
        strain = (stretched(x, j) - rest_length[j]) / rest_length[j]
        now = before
        for _ in range(2):
            last = held_strain(curves, which, floor[j], strain, now)
            now = before + gone * (first - before) + late * (last - first)
        arm[DAMPER, j], arm[CHANGE, j] = now, now - before


@kernel
def book_heat(system, state, dt):
    """Book what the dampers took in a step of `dt` [s], from the change of their strain in it."""
    curves, arm, work = system.curves, state.arm, state.work
    for j in range(arm.shape[1]):
        heat = heat_of(curves, state.stiffness, state.rest_length, arm[CHANGE, j], j, dt)
        work.friction[j] -= heat
        work.elastic[j] += heat


@small
def heat_of(curves, stiffness, rest_length, change, j, dt):
    """Return what the damper of segment `j` takes in a step of `dt` [J], as its strain changes [1]."""
    which = arm_of(curves, stiffness, j)
    if which < 0:
        return 0.0
    size = curves.arm[which] * stiffness[j] * rest_length[j] * rest_length[j]
    return size * curves.time[which] * change * change / dt


@kernel
def heat(curves, stiffness, rest_length, change, dt):
    """Return what all dampers take in a step of `dt` [J]; `change` (s,) of their strain in it [1]."""
    total = 0.0
    for j in range(change.shape[0]):
        total += heat_of(curves, stiffness, rest_length, change[j], j, dt)
    return total


@kernel
def next_stage(system, state, x, c, b, first):
    """Bring the dampers to a stage of an explicit Runge-Kutta method, at places `x`.

    It is `c` [s] along the rate of the stage before, of which `first` has none; its own counts for `b` [s].
    """
    arm = state.arm
    for j in range(arm.shape[1]):
        if first:
            arm[FIRST, j], arm[CHANGE, j] = arm[DAMPER, j], 0.0
        else:
            arm[DAMPER, j] = arm[FIRST, j] + c * arm[RATE, j]
    write_rates(system, state, x, arm[RATE])
    for j in range(arm.shape[1]):
        arm[CHANGE, j] += b * arm[RATE, j]


@part
def end_stages(system, state, dt, ledger):
    """Bring the dampers to the end of a step of an explicit Runge-Kutta method."""
    arm = state.arm
    for j in range(arm.shape[1]):
        arm[DAMPER, j] = arm[FIRST, j] + arm[CHANGE, j]
    if ledger:
        book_heat(system, state, dt)


@part
def know_past(state, share, row, known):
    """Write what a stage knows of the dampers, (s,) [1]: now, and `share` of a row of `State.arm`."""
    if state.arm.shape[1] > 0:
        arm = state.arm
        for j in range(known.shape[0]):
            known[j] = arm[DAMPER, j] + share * arm[row, j]


@part
def know_stages(state, table, s, dt, known_rates, known):
    """Write what stage `s` of a DIRK method knows of the dampers, (s,) [1], from rates (stages, s)."""
    if state.arm.shape[1] > 0:
        for j in range(known.shape[0]):
            total = state.arm[DAMPER, j]
            for r in range(s):
                total += dt * table[s, r] * known_rates[r, j]
            known[j] = total


@part
def begin_arms(system, state, work, c):
    """Write what stays the same of the arms while a stage is solved, d = d^ + c d'."""
    if relaxes(system, state):
        _begin_arms(system.curves, state.stiffness, work.known, work.arm, work.free, c)


@kernel
def _begin_arms(curves, stiffness, known, arm, free, c):
    for j in range(arm.shape[0]):
        which = arm_of(curves, stiffness, j)
        arm[j], free[j] = 0.0, 0.0
        if which >= 0:
            arm[j] = curves.arm[which] / (1.0 + c / curves.time[which])
            free[j], _ = at_tension(curves, which, arm[j] * known[j], arm[j])


@part
def end_arms(system, state, work, tension, c, out):
    """Write d' of a stage that is solved, from its tensions, (s,) [1/s]."""
    if relaxes(system, state):
        _end_arms(system.curves, state.stiffness, state.rest_length, work, tension, c, out)


@kernel
def _end_arms(curves, stiffness, rest_length, work, tension, c, out):
    for j in range(out.shape[0]):
        which = arm_of(curves, stiffness, j)
        out[j] = 0.0
        if which >= 0:
            pull = tension[j] / (stiffness[j] * rest_length[j]) + work.arm[j] * work.known[j]
            strain, _ = at_tension(curves, which, pull, work.arm[j])
            out[j] = (strain - work.known[j]) / (curves.time[which] + c)


@part
def write_ends(state, ends, weights, stage_rates, dt):
    """Write the end of a DIRK step, rows as in `State.arm`, from rates (stages, s)."""
    for j in range(state.arm.shape[1]):
        total = 0.0
        for s in range(weights.shape[0]):
            total += dt * weights[s] * stage_rates[s, j]
        ends[DAMPER, j] = state.arm[DAMPER, j] + total
        ends[CHANGE, j], ends[RATE, j] = total, stage_rates[weights.shape[0] - 1, j]


@part
def write_end(state, ends, share, row, c, rate, kept):
    """Write the end of a multistep method's step, rows as in `State.arm`.

    The dampers change by `share` of a row and `c` [s] of the `rate` (s,) that is kept, which is
    (rate - kept RATE) / (1 - kept): filtered where `kept` is not 0.
    """
    for j in range(state.arm.shape[1]):
        now = (rate[j] - kept * state.arm[RATE, j]) / (1.0 - kept)
        change = share * state.arm[row, j] + c * now
        ends[DAMPER, j] = state.arm[DAMPER, j] + change
        ends[CHANGE, j], ends[RATE, j] = change, now


@part
def take_ends(system, state, ends, dt, ledger):
    """Bring the dampers to the end of a step of an implicit method."""
    if relaxes(system, state):
        for j in range(ends.shape[1]):
            for row in range(ends.shape[0]):
                state.arm[row, j] = ends[row, j]
        if ledger:
            book_heat(system, state, dt)
