"""Implicit methods: tables of coefficients over the stage solve of `stage`.

One kernel serves all; `tableaus` has the coefficients. A step that finds no solution, or makes up energy,
is taken in halves, and these in halves again, by implicit Euler; but what makes up energy first in halves
by the method itself (`halves`). So are, in one piece, a step in which a contact or a bound of the stretch
stops much (`impacts`), and the next one: else the impulse would be taken for a force that lasts. The work
ledger is exact: every method's change of momentum is the step times a mean of forces,
    DIRK                m (v1 - v0) = h sum b_s F_s
    BDF2                m (v1 - v0) = h (F' / 3 + 2/3 F),   F' the mean of the step before
    generalized-alpha   m (v1 - v0) = h ((1 - gamma) G' + gamma G),   (1 - alpha_m) G + alpha_m G' = F
"""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

from ropewalk.core.arrays import Floats, Forces, State, System, blank
from ropewalk.core.jit import deferred, part
from ropewalk.core.status import GAINED, HIT, OK, UNSOLVED
from ropewalk.laws.anchors import move_anchors, place_stage
from ropewalk.laws.couplings import AGAIN, FINE, brace_couplings, couples, meet_on_way
from ropewalk.laws.elastic import CHANGE
from ropewalk.laws.inner import (
    end_inner,
    know_past,
    know_stages,
    take_ends,
    write_end,
    write_ends,
    write_rates,
)
from ropewalk.laws.ledger import account, book_growth
from ropewalk.laws.rare import has_bending, has_inner, winds
from ropewalk.laws.table import accelerate
from ropewalk.laws.wheels import aim_no_wheels, end_aim
from ropewalk.laws.winch import cut_short, wind_to
from ropewalk.laws.winch_books import book_begin, book_end, book_memory
from ropewalk.methods import tableaus
from ropewalk.methods.gain import makes_up_energy, most_of
from ropewalk.methods.generalized_alpha import end_alpha, prepare_alpha
from ropewalk.methods.halves import LAST, carries_on, halves_of, most_stages
from ropewalk.methods.impacts import is_soft, is_struck, is_struck_early, rest_links, strike
from ropewalk.methods.loop import make_advance, prepare_links
from ropewalk.methods.part_lengths import (
    MOST_HALVINGS,
    MOST_PARTS,
    begin_parts,
    carries_parts,
    keep_parts,
    keeps_parts,
)
from ropewalk.methods.scratch import (
    Look,
    add,
    add_forces,
    axpy,
    clear,
    clear_forces,
    clear_parts,
    clear_row,
    gather,
    half_way,
    make_look,
    make_turning,
    put,
    put_forces,
    put_row,
    settle_reaction,
)
from ropewalk.methods.stage import Stage, make_stage
from ropewalk.methods.stage_report import PRESSED, SPLITS, TIME
from ropewalk.methods.starts import Starts, make_starts, take_start
from ropewalk.methods.tableaus import BDF2, DIRK, GENERALIZED_ALPHA, Tableau
from ropewalk.methods.wheel_ties import aim_all, has_wheels
from ropewalk.methods.window import Windows, make_windows, solve_stage


class ImplicitScratch(NamedTuple):
    """Working arrays of the implicit methods."""

    stage: Stage
    windows: Windows | None
    u: Floats  # (stages, 3, n) velocities of the stages
    k: Floats  # (stages, 3, n) accelerations of the stages
    rates: Floats  # (stages, s) of what segments remember [1/s]; (stages, 0) without
    ends: Floats  # (4, s) the same at the step's end, see `laws.inner`
    middle: Floats  # (3, n)
    mean: Forces
    point: Floats  # (3,)
    speed: Floats  # (3,)
    reaction: Floats  # (a, 3) sum over the parts of a step [N]
    joint_force: Floats  # (p, 3) the same
    turning: Floats  # (w, 7) what winches wind in a step, see `laws.winch`
    look: Look
    starts: Starts  # of the stages of a step that was looked at already
    halves: tuple[Tableau, Tableau, Tableau]  # of the methods that take them, see `halves`
    anew: Tableau  # of the method that BDF2 begins anew by after halves


def make_implicit_scratch(system: System, state: State, tableau: Tableau) -> ImplicitScratch:
    """Return working arrays that fit `state` and the method."""
    rigid = bool(np.isinf(state.stiffness).any()) or state.forces.limiter.size > 0
    most = most_stages(tableau)
    stage = make_stage(state, bool(system.node.contact.friction.any()))
    return ImplicitScratch(
        stage=stage,
        windows=make_windows(system, state, stage),
        u=np.zeros((most, *state.x.shape)),
        k=np.zeros((most, *state.x.shape)),
        rates=np.zeros((most, state.inner.shape[1])),
        ends=np.zeros_like(state.inner),
        middle=np.zeros_like(state.x),
        mean=blank(state.forces),
        point=np.zeros(3),
        speed=np.zeros(3),
        reaction=np.zeros_like(state.reaction),
        joint_force=np.zeros_like(state.joint_force),
        turning=make_turning(state),
        look=make_look(state),
        starts=make_starts(state, tableau.stages),
        halves=halves_of(tableau, rigid),
        anew=tableaus.ESDIRK3,
    )


@part
def prepare_dirk(state, scratch, A, s, dt):
    """Write what is known of stage `s` of a DIRK method; return its c1 and c2."""
    stage = scratch.stage
    put(state.x, stage.x_known)
    put(state.v, stage.v_known)
    for r in range(s):
        add(scratch.u[r], dt * A[s, r], stage.x_known)
        add(scratch.k[r], dt * A[s, r], stage.v_known)
    know_stages(state, A, s, dt, scratch.rates, stage.segments.known)
    if s == 0:
        put(state.acceleration, stage.a)
    return dt * A[s, s], dt * A[s, s]


@part
def prepare_bdf2(system, state, scratch, dt):
    """Write what is known of BDF2's stage, from the last step's drift and mean forces."""
    stage, before = scratch.stage, scratch.k[0]
    accelerate(system, state, state.forces, before)
    axpy(state.x, 1.0 / 3.0, state.drift, stage.x_known)
    axpy(state.v, dt / 3.0, before, stage.v_known)
    know_past(state, 1.0 / 3.0, CHANGE, stage.segments.known)
    put(state.acceleration, stage.a)
    return 2.0 / 3.0 * dt, 2.0 / 3.0 * dt


@part
def end_dirk(state, scratch, A, b, dt):
    """Write the end of a DIRK step: the last stage, or the sum over all where it is not the end.

    Returns whether it is the last stage.
    """
    stage, last, same = scratch.stage, b.shape[0] - 1, True
    for r in range(b.shape[0]):
        same = same and A[last, r] == b[r]
    if not same:
        put(state.x, stage.x)
        put(state.v, stage.v)
        for s in range(b.shape[0]):
            add(scratch.u[s], dt * b[s], stage.x)
            add(scratch.k[s], dt * b[s], stage.v)
    return same


@part
def end_stages(system, state, scratch, t, after, dt, level, kind, A, b, struck):
    """Write the end of a DIRK or BDF2 step, its forces and accelerations; return OK where it may stand.

    But for the smallest parts one that makes up energy may not, nor one in which something is `struck`, but
    by implicit Euler, and but for steps as short as their error asks for.
    """
    stage, mean, ends_here, watch = scratch.stage, scratch.mean, True, level < MOST_HALVINGS
    if kind == BDF2:
        add_forces(system, state.forces, 1.0 / 3.0, mean)
        add_forces(system, stage.forces, 2.0 / 3.0, mean)
        rate, c = scratch.rates[0], 2.0 / 3.0 * dt
        write_end(state, scratch.ends, 1.0 / 3.0, CHANGE, c, rate, 0.0)
    else:
        ends_here = end_dirk(state, scratch, A, b, dt)
        write_ends(state, scratch.ends, b, scratch.rates, dt)
        if has_wheels(system) and not ends_here:
            aim_no_wheels(state.memory.obstacle.wheel)
    if winds(system, state):  # what the ends store is compared at the mean length
        wind_to(system, state, 0.5 * (t + after), scratch.turning)
    if watch and ends_here:
        most = most_of(system, level, is_soft(kind, A))
        if makes_up_energy(system, state, stage, scratch.ends, mean, dt, most):
            return GAINED
    free = stage.saddle.band.frozen[0] == 0 and not is_soft(kind, A)
    if watch and free and struck:
        return HIT
    met = meet_on_way(system, state, stage.x)
    if met != FINE:
        return HIT if met == AGAIN else UNSOLVED
    if kind == BDF2:
        put_forces(system, mean, state.forces)
    else:
        put_forces(system, stage.forces, state.forces)
    put(stage.a, state.acceleration)
    return OK


@part
def begin_step(system, state, stage, mean, dt, last, warm):
    """Get ready for a step of `dt` [s]; `last` and `warm` as in `take_step`."""
    clear_forces(system, mean)
    if not warm:
        put_row(state.tension, stage.tension)
    shortens = stage.saddle.band.frozen[0] == 1  # for what they hit
    brace_couplings(system, state, dt if shortens else last, shortens)


@part
def take_beginning(system, state, scratch, t, weight, s):
    """Make the step's beginning at `t` [s] its stage `s`."""
    put(state.v, scratch.u[s])
    put(state.acceleration, scratch.k[s])
    if has_inner(system, state):
        if winds(system, state):
            wind_to(system, state, t, scratch.turning)  # a try before may have left others
        write_rates(system, state, state.x, scratch.rates[s])
    put(state.acceleration, scratch.stage.a)
    add_forces(system, state.forces, weight, scratch.mean)


@part
def keep_stage(system, scratch, weight, s):
    """Keep what stage `s` has found."""
    put(scratch.stage.v, scratch.u[s])
    put(scratch.stage.a, scratch.k[s])
    add_forces(system, scratch.stage.forces, weight, scratch.mean)


@deferred("int64")
def take_step(
    system, state, scratch, t, after, dt, ledger, level, kind, A, b, c, numbers, warm, last
):
    """Take one step from time `t` [s]; return OK, or UNSOLVED, GAINED or HIT with the state as it was.

    It is one of 2^level parts. But for the smallest, one that makes up energy or hits something is told.
    `warm` begins with the last solution of the same step. `last` [s] is the part before, or the whole.
    """
    stage, mean, watch = scratch.stage, scratch.mean, level < MOST_HALVINGS
    begin_step(system, state, stage, mean, dt, last, warm)
    for s in range(b.shape[0] if kind == DIRK else 1):
        aim_all(system, state, kind, A, b, s, dt, after)
        if kind == DIRK and A[s, s] == 0.0:
            take_beginning(system, state, scratch, t, b[s], s)
            continue
        share = c[s]
        if kind == DIRK:
            c1, c2 = prepare_dirk(state, scratch, A, s, dt)
        elif kind == BDF2:
            c1, c2 = prepare_bdf2(system, state, scratch, dt)
            share = 1.0
        else:
            c1, c2 = prepare_alpha(state, scratch, numbers, dt)
            share = 1.0 - numbers[1]
        time, ahead = after if share == 1.0 else t + share * dt, share * dt
        whole = dt if kind == DIRK and s == 0 and b.shape[0] == 2 else 0.0
        status, held, point, speed = UNSOLVED, couples(system, state), scratch.point, scratch.speed
        # With accelerations and tensions as before; if that fails, none, but not in parts or by obstacles.
        twice = not watch or (not held and (level == 0 or has_bending(system)))
        for attempt in range(2 if twice else 1):
            if attempt == 1 or held:  # what is held by contacts may leap at the start
                clear(stage.a)
            if attempt == 1 or not warm:
                axpy(stage.v_known, c2, stage.a, stage.v)
                axpy(stage.x_known, c1, stage.v, stage.x)
            place_stage(system, state, time, ahead, stage.x, stage.v, point, speed, after, whole)
            if winds(system, state):
                wind_to(system, state, time, scratch.turning)
            if attempt == 1:
                clear_row(stage.tension)
            elif level == 0 and kind == DIRK:
                take_start(scratch.starts, s, t, after, dt, stage)
            status = solve_stage(system, state, stage, scratch.windows, c1, c2)
            if status == OK or (watch and stage.report[PRESSED] == 1.0):
                break
        if status != OK:
            stage.report[TIME] = time
            return UNSOLVED
        end_inner(system, state, stage.segments, stage.tension, scratch.rates[s])
        if has_wheels(system):
            end_aim(state.memory.obstacle.wheel, s, kind != DIRK or s == b.shape[0] - 1)
        if kind == DIRK:
            keep_stage(system, scratch, b[s], s)
            if watch and s + 1 < b.shape[0] and is_struck_early(system, state, stage):
                return HIT
    struck = is_struck(system, state, stage, mean if kind == DIRK else stage.forces, dt)
    if kind == GENERALIZED_ALPHA:
        end_alpha(system, state, scratch, numbers, dt)
    else:
        status = end_stages(system, state, scratch, t, after, dt, level, kind, A, b, struck)
        if status != OK:
            stage.report[TIME] = after
            return status
    if winds(system, state):
        book_begin(system, state, state.x, t, after, scratch.turning)
        book_end(system, state, stage.x, t, after, scratch.turning)
    strike(system, state, stage, mean, dt, struck and ledger)
    middle = scratch.middle
    half_way(state.x, state.v, stage.x, stage.v, state.inverse_mass, middle, state.drift)
    move_anchors(system, state, mean, after, dt, middle, scratch.point, scratch.speed)
    state.jolt[0] = 1.0 if struck else state.jolt[0]
    if ledger:
        account(system, state, mean, middle, dt)
    take_ends(system, state, scratch.ends, dt, ledger)
    if winds(system, state):
        book_growth(system, state, mean.friction, dt)
        book_memory(system, state, t, after, scratch.turning)
    put_row(stage.tension, state.tension)
    return OK


@part
def step(system, state, scratch, t, after, dt, ledger, tableau):
    """Advance the state by one step of `dt` from time `t` [s]; return OK or UNSOLVED.

    The step is part `place` of 2^level parts; one without solution is halved. For how parts grow again see
    `part_lengths`, for one that makes up energy `halves`. What hits, and the next, is by implicit Euler.
    """
    rescue, among_obstacles = scratch.halves[LAST], state.memory.obstacle.grip.shape[0] > 0
    kind, A, b, c, numbers = tableau.kind, tableau.A, tableau.b, tableau.c, tableau.numbers
    follows, after_halves = carries_on(dt, state.held, state.winch_exit, state.past)
    if not follows and kind == BDF2:
        kind = DIRK
        if after_halves:
            A, b, c = scratch.anew.A, scratch.anew.b, scratch.anew.c
        if A[0, 0] == 0.0:  # it begins with the forces at the start; those kept are means
            prepare_links(system, state, t, scratch.stage.saddle)
            state.past[0] = dt
    fixed = scratch.stage.saddle.band.frozen[0] == 0
    struck = fixed and state.jolt[0] > 0.0
    carried = carries_parts(system, state, dt, is_soft(kind, A), struck)
    level, run, need, climbed = begin_parts(state.past, dt, carried)
    place, last, turn = 0, dt, -1
    status = HIT if struck and not is_soft(kind, A) else OK
    while True:
        warm = status == HIT and is_soft(kind, A)
        if status == HIT and fixed:  # its impulse is not to be carried on as a force
            kind, A, b, c = DIRK, rescue.A, rescue.b, rescue.c
            state.past[0] = 0.0
        h = dt / 2.0**level
        begin = t + place * h
        end = after if place + 1 == 2**level else begin + h
        status = take_step(
            system, state, scratch, begin, end, h, ledger, level, kind, A, b, c, numbers, warm, last
        )
        if status == OK:
            last = h
            if level == 0:
                break
            scratch.stage.report[SPLITS] += 1.0
            gather(state.reaction, 1.0 / 2.0**level, scratch.reaction)
            gather(state.joint_force, 1.0 / 2.0**level, scratch.joint_force)
            place, run = place + 1, run + 1
            if place == 2**level:
                settle_reaction(scratch.reaction, state.reaction)
                settle_reaction(scratch.joint_force, state.joint_force)
                break
            climbed = run >= need and place % 2 == 0
            if climbed:
                level, place, run = level - 1, place // 2, 0
            while has_bending(system) and not carried and place % 2 == 0:  # rods are lost else
                level, place = level - 1, place // 2
        elif status == HIT:
            continue
        elif not is_soft(kind, A):  # halves by the next method
            turn = turn + 1 if status == GAINED and not among_obstacles else LAST
            one = scratch.halves[turn]
            level, kind, A, b, c = 1, DIRK, one.A, one.b, one.c
            state.past[0] = 0.0 if is_soft(kind, A) else 0.5 * dt
        elif level == MOST_HALVINGS:
            clear_parts(scratch.reaction)  # the run may go on from an earlier state
            clear_parts(scratch.joint_force)
            break
        else:
            need = min(2 * need, MOST_PARTS) if climbed else need
            level, place, run, climbed = level + 1, 2 * place, 0, False
    carried = carried or keeps_parts(system, state, dt, is_soft(kind, A))
    keep_parts(state.past, dt, carried and status == OK, level, run, need)
    if status != OK and winds(system, state):  # the state is as it was before the part that failed
        cut_short(system, state, begin, scratch.turning)
    if kind == DIRK and tableau.kind == BDF2:
        put_forces(system, scratch.mean, state.forces)
    if status == OK and is_soft(kind, A) and not is_soft(tableau.kind, tableau.A):
        rest_links(system, state, scratch.stage, dt, ledger)
    return status


advance = make_advance(step, carries=True, solves=True)
