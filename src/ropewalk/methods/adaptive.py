"""Steps of varying length by ESDIRK3, to a tolerance.

The method walks at its own pace, whatever is recorded: from state `begin` to state `ahead`, a step whose
error estimate was accepted. A frame inside it is made by a step of the same method from `begin` to the
frame's time, which the walk does not see. So the order, the ledger and the tensions of a frame are those of
any step (a polynomial through positions would not do: a micrometre is tonnes in a steel wire), and the walk
is the same at every recording rate. When the state was changed from outside, the walk begins anew from it.

A step ends where the scene changes by itself (`controller.break_times`), and is cut where a law begins or
ceases to act on a node, as a ground or an obstacle does, or a segment goes taut or slack (`crossings`).
"""

from __future__ import annotations

import math
from typing import NamedTuple

import numpy as np

from ropewalk.core.arrays import Floats, State, System, pooled
from ropewalk.core.jit import kernel, part
from ropewalk.core.status import HIT, OK, PAUSED, UNSOLVED
from ropewalk.laws.anchors import release_anchors
from ropewalk.laws.bounds import is_stopped, time_to_bounds, time_to_taut
from ropewalk.laws.contact_frame import STOPS
from ropewalk.laws.links import hold_links, note_reactions
from ropewalk.laws.obstacle_places import reaches_of_wheels
from ropewalk.laws.rare import acts_after, limits, parts, winds
from ropewalk.laws.winch import end_turns, plan_turns, wind_to
from ropewalk.methods.controller import (
    BEGIN,
    BEGUN,
    END,
    ERROR,
    EVENT_STEP,
    NODE,
    REJECTED,
    SHORTEST_STEP,
    UNSOLVED_SHARE,
    WISH,
    break_times,
    count_step,
    first_step,
    largest_error,
    largest_inner_error,
    largest_turning_error,
    longest_step,
    make_control,
    shorter,
)
from ropewalk.methods.crossings import crossings, mark_sides
from ropewalk.methods.halves import LAST
from ropewalk.methods.impacts import rest_links
from ropewalk.methods.implicit import (
    ImplicitScratch,
    make_implicit_scratch,
    step,
    take_step,
)
from ropewalk.methods.kinks import JUST_BELOW, next_break, take_up_laws, take_up_rates
from ropewalk.methods.loop import close_frame, prepare_links
from ropewalk.methods.part_lengths import MOST_HALVINGS
from ropewalk.methods.partings import part_ropes
from ropewalk.methods.scratch import SEEN, put_row
from ropewalk.methods.stage import Stage
from ropewalk.methods.stage_report import QUICK
from ropewalk.methods.tableaus import ESDIRK3
from ropewalk.methods.verdict import note_changes
from ropewalk.methods.watch import close_interval, open_interval, watch
from ropewalk.methods.wheel_ties import has_wheels

SNAP = 1e-9  # [1] a frame this close to an end of a step, over its length, is at that end


class Walk(NamedTuple):
    """What evolves besides the state that is shown; empty arrays for methods of fixed steps."""

    begin: Floats  # all numbers of the state at the last step's begin, see `arrays.pooled`
    ahead: Floats  # the same at its end
    shown: Floats  # the same of the last frame, to tell whether it was changed since
    control: Floats  # see `controller`


class AdaptiveScratch(NamedTuple):
    """Working arrays of the adaptive method."""

    solver: ImplicitScratch
    stage: Stage  # the solver's
    walk: Walk
    here: Floats  # all numbers of the state that is shown
    begin: State  # views of the walk's arrays
    ahead: State
    breaks: Floats  # times at which a step must end [s]
    limits: Floats  # (2,) tolerance [m], longest step [s]
    reach: Floats  # (w,) of what turns freely, from its axle [m]
    strides: Floats  # (1,) tries of a step, and frames, that are left to the present call


def no_walk() -> Walk:
    """Return the walk of a method of fixed steps."""
    return Walk(*(np.zeros(0) for _ in Walk._fields))


def adapt(
    system: System, shown: State, here: Floats, tolerance: float, longest: float
) -> AdaptiveScratch:
    """Return working arrays for a state to show, whose arrays lie in `here`, see `arrays.pooled`.

    `tolerance` [m] and `longest` step [s] are the run's.
    """
    (begin, first), (ahead, second) = pooled(shown), pooled(shown)
    walk = Walk(first, second, here.copy(), make_control())
    solver = make_implicit_scratch(system, shown, ESDIRK3)
    solver.stage.saddle.band.frozen[0] = 1
    limits = np.array([tolerance, longest])
    breaks = break_times(system)
    reach = reaches_of_wheels(system.node.obstacle, shown.x)
    rest = breaks, limits, reach, np.zeros(1)
    return AdaptiveScratch(solver, solver.stage, walk, here, begin, ahead, *rest)


@kernel
def differ(one, other):
    """Tell whether two arrays (m,) differ in any bit: whole numbers are among them, and -1 is no float."""
    first, second, count = one.view(np.int64), other.view(np.int64), 0
    for j in range(first.shape[0]):
        count += 0 if first[j] == second[j] else 1
    return count > 0


@part
def begin_walk(state, scratch, t):
    """Begin anew at time `t` [s] from the state that is shown."""
    control = scratch.walk.control
    put_row(scratch.here, scratch.walk.ahead)
    put_row(scratch.here, scratch.walk.shown)
    control[BEGIN], control[END], control[BEGUN] = t, t, 1.0


@part
def open_step(system, state, t, solver, breaks):
    """Let go of anchors and take up all rates after time `t` [s]; a jump is booked as work."""
    anew = release_anchors(system, state, t, 0.0)
    if next_break(breaks, t * JUST_BELOW) <= t and take_up_laws(system, state, t) > 0:
        anew = True
    return take_up_rates(system, state, t, solver.point, solver.speed) > 0 or anew


@part
def try_once(system, state, solver, t, after, dt, ledger, tableau):
    """Take a step of `dt` from `t` [s]; return OK or UNSOLVED."""
    if winds(system, state):
        if plan_turns(system, state, t, dt, solver.turning):
            prepare_links(system, state, t, solver.stage.saddle)
    status = HIT
    while status == HIT:  # with the contacts that the last solution has met
        status = take_step(
            system,
            state,
            solver,
            t,
            after,
            dt,
            ledger,
            MOST_HALVINGS,
            tableau.kind,
            tableau.A,
            tableau.b,
            tableau.c,
            tableau.numbers,
            False,
            dt,
        )
    if status != OK and winds(system, state):
        wind_to(system, state, t, solver.turning)
    return status


@kernel
def try_step(system, state, before, scratch, t, after, dt, ledger, tableau):
    """Take a step of `dt` from `t` [s]; return the length to try next [s], 0 where it was accepted, and how
    many nodes and segments have changed sides, negative where that is why it was not."""
    solver, control, tolerance = scratch.solver, scratch.walk.control, scratch.limits[0]
    if try_once(system, state, solver, t, after, dt, ledger, tableau) != OK:
        control[ERROR] = np.inf
        return UNSOLVED_SHARE * dt, 0
    if is_stopped(system, before, solver.mean, dt):
        return land(system, state, before, scratch, t, after, dt, ledger)
    quick = solver.stage.report[QUICK]
    b, other = tableau.b, tableau.embedded
    largest_error(solver.u, b, other, dt, state.inverse_mass, control)
    largest_inner_error(solver.rates, b, other, dt, state.rest_length, control)
    if has_wheels(system):
        wheel, segments = state.memory.obstacle.wheel, state.rest_length.shape[0]
        largest_turning_error(wheel, b, other, dt, scratch.reach, segments, control)
    wrong = not control[ERROR] <= tolerance
    if wrong and quick == 0.0:
        return dt * shorter(control[ERROR] / tolerance), 0
    end, changes = crossings(system, before, state, dt, tolerance)
    if end < dt and dt > 2.0 * EVENT_STEP:  # rounding makes a step of it a little longer
        return max(end, EVENT_STEP), -changes
    if quick * dt > 1.5 * STOPS and dt > EVENT_STEP:
        return max(0.5 * dt, STOPS / quick, EVENT_STEP), 0
    if wrong:
        return dt * shorter(control[ERROR] / tolerance), 0
    return 0.0, changes


@part
def land(system, state, before, scratch, t, after, dt, ledger):
    """As `try_step`, for a step that runs into bounds, or gets strings taut: first up to there, then a short
    one of implicit Euler, in which none that is stopped moves by more than half the tolerance.
    """
    solver = scratch.solver
    length, x, v, old, new = before.rest_length, before.x, before.v, before.forces, solver.mean
    stiffness, floor = before.stiffness, system.slack_floor
    first, rate = time_to_taut(stiffness, floor, length, x, v, new.elastic, dt)
    if limits(system):
        other, fast = time_to_bounds(system.limiter, old.limiter, new.limiter, length, x, v)
        first, rate = min(first, other), max(rate, fast)
    first = first if first < math.inf else 0.0
    short = max(0.5 * scratch.limits[0] / rate, EVENT_STEP)
    if first > short:
        return (first - 0.5 * short if first < dt else 0.5 * dt), -1
    if dt > 1.5 * short:
        return short, -1
    put_row(scratch.walk.begin, scratch.walk.ahead)
    scratch.walk.control[ERROR] = 0.0
    status = try_once(system, state, solver, t, after, dt, ledger, solver.halves[LAST])
    if status == OK:
        rest_links(system, state, solver.stage, dt, ledger)
    return (0.0, 1) if status == OK else (UNSOLVED_SHARE * dt, 0)


@kernel
def stride(system, scratch, extras, ledger, tableau):
    """Take one accepted step from `ahead`; return OK, or UNSOLVED where none is short enough."""
    state, before, solver, control = (
        scratch.ahead,
        scratch.begin,
        scratch.solver,
        scratch.walk.control,
    )
    t, look = control[END], solver.look
    if parts(system) and part_ropes(system, state, look, t) > 0:
        control[WISH] = 0.0
    if open_step(system, state, t, solver, scratch.breaks) or control[WISH] == 0.0:
        prepare_links(system, state, t, solver.stage.saddle)
    put_row(scratch.walk.ahead, scratch.walk.begin)
    mark_sides(system, state, solver.stage.saddle.band)
    longest = longest_step(system.winches, scratch.limits[1])
    if control[WISH] == 0.0:
        control[WISH] = first_step(state.acceleration, system.gravity, scratch.limits[0], longest)
    dt, cut, retried, changes = min(control[WISH], longest), False, False, 0
    most = math.inf  # [s] of the next step, where something begins to touch
    stop = next_break(scratch.breaks, t)
    while True:
        end, after = t + dt, t + dt
        if end >= stop - 1e-6 * dt:
            end, after, cut = stop, stop * JUST_BELOW, True
        elif end + dt > stop:  # two equal steps rather than a tiny second one
            end, cut = t + 0.5 * (stop - t), True
            after = end
        dt = end - t
        scratch.strides[0] -= 1.0
        again, changes = try_step(system, state, before, scratch, t, after, dt, ledger, tableau)
        if again == 0.0:
            break
        control[REJECTED] += 1.0
        short = again < SHORTEST_STEP or t + again == t
        if short:
            put_row(scratch.walk.ahead, scratch.here)  # it tells the host why
        put_row(scratch.walk.begin, scratch.walk.ahead)
        if short:
            return UNSOLVED
        if changes < 0:
            cut, quick = True, solver.stage.report[QUICK]
            most = 0.5 * STOPS / quick if quick > 0.0 else most
        else:
            control[WISH], retried, cut = again, True, False
        dt = again
    if winds(system, state):
        end_turns(system, state, solver.turning)
    if acts_after(extras) or changes > 0:
        prepare_links(system, state, end, solver.stage.saddle)
    control[BEGIN], control[END] = t, end
    count_step(control, dt, control[ERROR] / scratch.limits[0], cut, retried)
    control[WISH] = min(control[WISH], most)
    return OK


@kernel
def show(system, state, scratch, extras, time, ledger, tableau):
    """Bring the state that is shown to `time` [s], inside the last step; return OK or UNSOLVED.

    Rigid links get the tensions, and anchors the reactions, of that very instant: what a short step says of
    them is the error of its beginning over its length.
    """
    status = go_to(system, state, scratch, extras, time, ledger, tableau)
    saddle = scratch.stage.saddle
    if status == OK and hold_links(system, state, time, saddle) > 0:
        note_reactions(system, state, time, saddle)
    return status


@part
def go_to(system, state, scratch, extras, time, ledger, tableau):
    """Bring the state that is shown to `time` [s]; return OK or UNSOLVED."""
    walk = scratch.walk
    begin, end = walk.control[BEGIN], walk.control[END]
    if time >= end - SNAP * (end - begin):
        put_row(walk.ahead, scratch.here)
        return OK
    put_row(walk.begin, scratch.here)
    if time <= begin + SNAP * (end - begin):
        return OK
    mark_sides(system, state, scratch.stage.saddle.band)
    dt = time - begin
    if winds(system, state):
        if plan_turns(system, state, begin, dt, scratch.solver.turning):
            prepare_links(system, state, begin, scratch.stage.saddle)
    status = step(system, state, scratch.solver, begin, time, dt, ledger, tableau)
    if status != OK:
        walk.control[ERROR] = np.inf
    if acts_after(extras):
        if winds(system, state):
            end_turns(system, state, scratch.solver.turning)
        prepare_links(system, state, time, scratch.stage.saddle)
    return status


@kernel
def advance(system, state, scratch, extras, clock, frames, ledger, out, stop_at_break, tableau):
    """Advance `frames` frames; return the status and the number of good frames. See `loop.make_advance`.

    `clock` holds t0, time between two frames, frames done and, for a frame, how many of them. PAUSED after
    as many tries as `scratch.strides` says: the walk may then be part of the way to the next frame.
    """
    control, walk = scratch.walk.control, scratch.walk
    look, done = scratch.solver.look, int(clock[2])
    look.known[SEEN] = 0.0
    note_changes(system, state)
    if control[BEGUN] == 0.0 or differ(scratch.here, walk.shown):
        begin_walk(state, scratch, clock[0] + done * clock[1])
    for frame in range(frames):
        if frame > 0 or clock[4] == 0.0:
            open_interval(system, state, look, clock[0] + done * clock[1])
        done += int(clock[3])
        time = clock[0] + done * clock[1]
        while control[END] < time:
            if scratch.strides[0] <= 0.0:
                return PAUSED, frame
            watch(system, scratch.ahead, look, control[END])
            status = stride(system, scratch, extras, ledger, tableau)
            if status != OK:
                return status, frame
        if scratch.strides[0] <= 0.0:
            return PAUSED, frame
        scratch.strides[0] -= 1.0
        status = show(system, state, scratch, extras, time, ledger, tableau)
        if status == OK:
            clock[2] = done
            close_interval(system, state, look, time, time)
            status = close_frame(system, state, ledger, time, stop_at_break, look, frame, out)
            put_row(state.balance, scratch.begin.balance)
            put_row(state.balance, scratch.ahead.balance)
            put_row(scratch.here, walk.shown)
        if status != OK and (stop_at_break or status == UNSOLVED):
            return status, frame
    return OK, frames


def failure(scratch: AdaptiveScratch) -> tuple[float, int, float]:
    """Return time [s], place (see `controller.NODE`) and error [m] of the step that failed; inf: unsolved."""
    control = scratch.walk.control
    return float(control[END]), int(control[NODE]), float(control[ERROR])
