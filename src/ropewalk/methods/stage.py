"""The stage solve, the heart of every implicit method:

    V = v^ + c2 a(X, V),   X = x^ + c1 V

for positions X, velocities V and the segments' tensions T, by Newton's method on the saddle-point system of
`core.saddle`, with a line search on

    merit = sum m c1 c2 |a - (V - v^) / c2|^2 + sum m_j / (c1 c2) g_j^2     [J]

(m_j the lighter node's mass of a segment), which no spring constant enters. Two safeguards make it converge
from tangled states: a compressed segment's geometric stiffness is held above -0.24 m_j / (c1 c2) far from
the solution, which keeps the matrix definite; and what begins and ends abruptly is decided in the first
iterations only. Where no part of a step brings the merit down, in a local minimum of it, a whole one is taken
with the bends' matrix held definite, too. From where something presses on, `model_slope` has the search.

Sources: Nocedal & Wright, Numerical Optimization, ch. 11 (line search for equations) and 16 (saddle points);
Hairer & Wanner, Solving Ordinary Differential Equations II, IV.8 (implementation).
"""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

from ropewalk.core.arrays import TENSION_ONLY, Floats, Forces, State, blank
from ropewalk.core.jit import kernel, part, small
from ropewalk.core.saddle import Saddle, make_saddle
from ropewalk.core.status import OK, UNSOLVED
from ropewalk.laws.contact import presses_round
from ropewalk.laws.couplings import couples
from ropewalk.laws.inner import begin_inner
from ropewalk.laws.rare import has_bending, limits
from ropewalk.laws.registry import NODE_LAWS
from ropewalk.laws.slip_course import ROWS
from ropewalk.laws.stage_forces import evaluate_stage, mark_stage
from ropewalk.laws.table import accelerate
from ropewalk.methods.model_slope import follow_model
from ropewalk.methods.newton_step import newton_step
from ropewalk.methods.rounding import rounding, rounding_at_last
from ropewalk.methods.stage_report import (
    BEGIN,
    HISTORY,
    ITERATIONS,
    PAUSED,
    PRESSED,
    RESIDUAL,
    ROUNDING,
    SOLVES,
    TIGHT,
    find_worst,
    is_close,
    is_solved,
    keep_course,
    largest_force,
    largest_merit,
    largest_misfit,
    needs_window,
    take_course,
)

MOST_ITERATIONS = 60
DECIDING = 8  # iterations that may still change what rubs and what touches
LOOSE = 1e-8  # [1] the same, where the descent stops, by rounding as a rule
# The same where ropes touch each other, and as they are taken after the last iteration.
TOUCHING, TOUCHING_AT_MOST = 1e-10, 1e-6
TOUCHING_ITERATIONS = 25  # without bending: shorter steps take few
CLOSE_ENOUGH, SOON = 1e-2, 10  # as CLOSE and LATE, where ropes touch
BESIDE_ENOUGH, BESIDE_SOON, BESIDE_ITERATIONS = 0.1, 40, 40  # where an obstacle presses
DESCENT = 1e-4  # Armijo's constant
SHORTEST = 1e-5  # [1] smallest part of a Newton step
NEAR = 1e-2  # [1] a step that brings the merit down to this part is near the solution
CLOSE = 1e-3  # [1] so is one whose forces balance to this part of the largest, and lengths alike
LATE = 15  # iterations after which the solution counts as near
MEMORY = 8  # merits the largest of which a step has to bring down
CAREFUL_LATE, CAREFUL_MEMORY = (
    30,
    1,
)  # the same with bending, bounds or contacts: folded rods are lost else
WARY = 3  # iterations that hold compression back after an exact one that failed
AIDED_ITERATIONS = 20  # where windows of the rope are solved first, see `window`
MOST_LEAPS = 12  # steps that are taken whatever the merit, out of its local minima


class Segments(NamedTuple):
    """What a stage knows of its segments, (s,) each."""

    alive: Floats  # 1, or 0 between ropes and on a drum
    soft: Floats  # compliance 1/k [m/N]; 0 where not alive
    weight: Floats  # inertial stiffness m / (c1 c2) of the lighter node [N/m]
    stretch: Floats  # r - L [m]
    over: Floats  # 1 / r [1/m], 0 where the ends coincide
    tangent: Floats  # tangent compliance of segments with an elastic law [m/N]
    known: Floats  # d^ of what segments remember, d being d^ + c d' [1]; (0,) without, as the next ones
    free: Floats  # strain without tension [1]
    start: Floats  # the d^ that laws are asked for [1]: another at drums, see `laws.fresh`
    follow: Floats  # the c that they are asked for [s]


class Stage(NamedTuple):
    """Unknowns, equations and working arrays of one stage."""

    x: Floats  # (3, n) X
    v: Floats  # (3, n) V
    tension: Floats  # (s,) T [N]
    x_known: Floats  # (3, n) x^
    v_known: Floats  # (3, n) v^
    a: Floats  # (3, n) acceleration from the forces at X, V, T
    forces: Forces  # at X, V, T; `applied` is the state's own
    segments: Segments
    saddle: Saddle
    report: Floats  # of the last solve, see ITERATIONS to HISTORY; SOLVES and SPLITS add up


def make_stage(state: State, watches_slip: bool = False) -> Stage:
    """Return working arrays that fit `state`; with `watches_slip` those of `laws.slip_course`, too."""
    s = state.rest_length.shape[0]
    x, v, x_known, v_known, a = (np.zeros_like(state.x) for _ in range(5))
    forces = blank(state.forces)._replace(applied=state.forces.applied)
    inner = state.inner.shape[1]
    sizes = (*(6 * (s,)), *(4 * (inner,)))
    segments = Segments(*(np.zeros(size) for size in sizes))
    saddle = make_saddle(state.x.shape[1], state.bending_stiffness.shape[0] > 0, len(NODE_LAWS))
    if watches_slip:
        slips = np.zeros((state.memory.obstacle.grip.shape[0], ROWS, state.x.shape[1]))
        saddle = saddle._replace(band=saddle.band._replace(slips=slips))
    known, report = (x_known, v_known), np.zeros(HISTORY + MOST_ITERATIONS + 1)
    return Stage(x, v, np.zeros(s), *known, a, forces, segments, saddle, report)


@kernel
def begin(mass, inverse_mass, stiffness, segments, saddle, inertia):
    """Write what stays the same during a solve; `inertia` is 1 / (c1 c2) [1/s^2]."""
    free, rubs, frozen = saddle.free, saddle.band.rubs, saddle.band.frozen[0]
    for i in range(mass.shape[0]):
        free[i] = 1.0 if inverse_mass[i] > 0.0 else 0.0
    for j in range(stiffness.shape[0]):
        light = min(mass[j], mass[j + 1])
        if light == 0.0:
            light = max(mass[j], mass[j + 1])
        segments.weight[j] = light * inertia if light > 0.0 else 1.0
        segments.alive[j] = 1.0 if stiffness[j] > 0.0 else 0.0
        segments.soft[j] = 1.0 / stiffness[j] if stiffness[j] > 0.0 else 0.0
        rubs[j] = rubs[j] if frozen == 1 else 1.0


@kernel
def balance(a, v, known, mass, free, c1, c2, force):
    """Write the nodes' residuals m (a - (V - v^) / c2) [N]; return their part of the merit [J]."""
    total, over = 0.0, 1.0 / c2
    for k in range(3):
        row, ak, vk, v0 = force[k], a[k], v[k], known[k]
        for i in range(mass.shape[0]):
            row[i] = mass[i] * free[i] * (ak[i] - over * (vk[i] - v0[i]))
    f0, f1, f2 = force[0], force[1], force[2]
    for i in range(mass.shape[0]):
        square = f0[i] * f0[i] + f1[i] * f1[i] + f2[i] * f2[i]
        total += square / mass[i] if square > 0.0 else square
    return c1 * c2 * total


@kernel
def misfit_merit(misfit, weight):
    """Return the segments' part of the merit [J]."""
    total = 0.0
    for j in range(misfit.shape[0]):
        total += weight[j] * misfit[j] * misfit[j]
    return total


@kernel
def move(part_of_step, c1, stage_x, stage_v, tension, saddle):
    """Go a part of the Newton step, in positions, velocities and tensions."""
    over, free, pulled = part_of_step / c1, saddle.free, saddle.pulled
    for k in range(3):
        x, v, z = stage_x[k], stage_v[k], saddle.moved[k]
        for i in range(x.shape[0]):
            x[i] += part_of_step * free[i] * z[i]
            v[i] += over * free[i] * z[i]
    for j in range(tension.shape[0]):
        tension[j] += part_of_step * pulled[j]


@kernel
def is_finite(moved, pulled):
    """Tell whether the Newton step is finite."""
    z0, z1, z2 = moved[0], moved[1], moved[2]
    a, b, c, d = 0.0, 0.0, 0.0, 0.0
    for j in range(pulled.shape[0]):
        a += abs(z0[j])
        b += abs(z1[j])
        c += abs(z2[j])
        d += abs(pulled[j])
    n = pulled.shape[0]
    return a + b + c + d + abs(z0[n]) + abs(z1[n]) + abs(z2[n]) < np.inf


@kernel
def shorter_part(size, trial, merit):
    """Return the next part of the step to try: the least of the parabola with slope -2 merit."""
    if not trial < np.inf:
        return 0.1 * size
    best = size * size * merit / (trial + (2.0 * size - 1.0) * merit)
    return min(max(best, 0.1 * size), 0.5 * size)


@part
def is_smooth(system, state):
    """Tell whether stretch, air and ground are all there is: a line search that looks back pays then."""
    touches = system.rare is not None and system.node.obstacle.kind.shape[0] > 0
    return not (touches or has_bending(system) or limits(system) or couples(system, state))


@kernel
def finish(v_known, a, free, c2, v):
    """Let momentum have the last word: V follows from the forces, so that works add up exactly.

    X stays, where lengths and bends are those that were solved for.
    """
    for k in range(3):
        v0, ak, vk = v_known[k], a[k], v[k]
        for i in range(free.shape[0]):
            if free[i] != 0.0:
                vk[i] = v0[i] + c2 * ak[i]


@part
def comes_to_press(system, stage):
    """Note where an obstacle presses from now on; tell whether it does so, and did not before in the solve.

    One that is no plane: on planes alone merits come down. Steps that follow contacts are short, and of slack
    with a bound on the stretch the model sees neither end.
    """
    if system.rare is None or stage.saddle.band.frozen[0] == 1 or stage.report[PRESSED] == 1.0:
        return False
    if limits(system) and system.flags[TENSION_ONLY] == 1:
        return False
    if presses_round(system.node.obstacle, stage.forces.node.obstacle):
        stage.report[PRESSED] = 1.0
    return stage.report[PRESSED] == 1.0


@small
def most_iterations(heaps, window):
    """Return after how many iterations a solve is given up; `heaps` are of ropes without bending."""
    if window != 0:
        return AIDED_ITERATIONS
    return TOUCHING_ITERATIONS if heaps else MOST_ITERATIONS


@small
def is_close_by_model(report, touching, iteration):
    """Tell whether the solution counts as near where `model_slope` has the search."""
    if touching:
        return is_close(report, CLOSE_ENOUGH) or iteration > SOON
    return is_close(report, BESIDE_ENOUGH) or iteration > BESIDE_SOON


@part
def is_all_done(system, state, stage, c2, touching, at_last, last, size):
    """Tell whether a solve has what rounding leaves of it: the residual hardly falls from `last` [N].

    In a step of `size` [1], which beside obstacles has to be a whole one.
    """
    report, stays = stage.report, touching or size >= 1.0
    if not at_last and (report[RESIDUAL] <= 0.5 * last or not stays):
        return False
    if touching:
        return is_solved(report, TOUCHING_AT_MOST if at_last else LOOSE)
    report[ROUNDING] += rounding_at_last(system, state, stage, c2)
    return is_solved(report, LOOSE if at_last else TOUCHING)


@part
def begin_solve(system, state, stage, c1, c2):
    """Write what stays the same during a solve."""
    k, segments, saddle = state.stiffness, stage.segments, stage.saddle
    begin(state.mass, state.inverse_mass, k, segments, saddle, 1.0 / (c1 * c2))
    begin_inner(system, state, segments, c2)


@kernel
def newton(system, state, stage, c1, c2, tight, window, aid):
    """Solve the stage from the guess in `x`, `v`, `tension`; held nodes are in place already.

    `c1` and `c2` [s], `x_known` and `v_known` say what the stage is, `tight` [1] is the force residual over
    the largest force, when solved. Returns OK, UNSOLVED, or PAUSED where up to `window` nodes (below 0: it
    has had them) would better be solved by themselves; then it goes on by `aid`, see `stage_report`.
    """
    saddle, segments, report = stage.saddle, stage.segments, stage.report
    x, v, tension, known = stage.x, stage.v, stage.tension, stage.v_known
    mass, free = state.mass, saddle.free
    if aid == BEGIN:
        begin_solve(system, state, stage, c1, c2)
    iteration, merit, exact, wary, held_back, failed, leaps, leap = take_course(report, aid)
    size, bar, first, whole, gone_to = 0.0, np.inf, iteration, False, False
    calm, touching, last = not has_bending(system), couples(system, state), np.inf
    most, report[PRESSED] = most_iterations(touching and calm, window), 0.0
    late, memory = (LATE, MEMORY) if is_smooth(system, state) else (CAREFUL_LATE, CAREFUL_MEMORY)
    while True:
        evaluate_stage(system, state, x, v, tension, segments, saddle, stage.forces, gone_to)
        accelerate(system, state, stage.forces, stage.a)
        trial = balance(stage.a, v, known, mass, free, c1, c2, saddle.force)
        trial += misfit_merit(saddle.misfit, segments.weight)
        if not touching and comes_to_press(system, stage) and calm:
            most = min(most, BESIDE_ITERATIONS)
        by_model = touching or report[PRESSED] == 1.0
        if not by_model and size > 0.0 and not trial <= (1.0 - DESCENT * size) * bar:
            before, size = size, shorter_part(size, trial, merit)
            failed = size < SHORTEST
            size = 0.0 if failed else size
            move(size - before, c1, x, v, tension, saddle)
            continue
        open_marks = iteration < DECIDING and saddle.band.frozen[0] == 0
        if open_marks and mark_stage(system, x, segments, saddle) > 0.0:
            size, gone_to = 0.0, False
            continue
        largest_force(v, known, mass, free, system.gravity, c2, saddle.force, report)
        largest_misfit(x, tension, state.rest_length, stage.forces.friction, saddle, report)
        report[ROUNDING] = rounding(system, state, stage)
        report[ITERATIONS], report[HISTORY + iteration] = iteration, trial
        if is_solved(report, TOUCHING if touching else tight):
            break
        at_last = iteration >= most
        if by_model and is_all_done(system, state, stage, c2, touching, at_last, last, size):
            break
        last = report[RESIDUAL]
        if whole and not at_last and needs_window(stage, mass, c1 * c2, window):
            keep_course(report, merit, exact, wary, held_back, failed, leaps, leap)
            return PAUSED
        stuck = failed and not exact
        if stuck or at_last:
            if touching or not by_model:
                report[ROUNDING] += rounding_at_last(system, state, stage, c2)
            if is_solved(report, LOOSE if stuck else TIGHT):
                break
        leaps, leap = leaps + (1 if stuck else 0), stuck or (leap and wary > 1)
        if at_last or leaps > MOST_LEAPS:
            find_worst(saddle.force, report)
            return UNSOLVED
        wary = WARY if failed else wary - 1
        close = trial < NEAR * merit or (calm and is_close(report, CLOSE)) or iteration > late
        by_now = is_close_by_model(report, touching, iteration)
        exact = (by_now if by_model else exact or (held_back == 1 and close)) and wary <= 0
        leap = leap or (by_model and not exact)
        saddle.band.definite[0] = 1 if by_model and not touching and not exact else 0
        held_back = newton_step(system, state, stage, c1, c2, exact, leap)
        report[SOLVES] += 1.0
        if not is_finite(saddle.moved, saddle.pulled):
            find_worst(saddle.force, report)
            return UNSOLVED
        if by_model:
            size, iteration = follow_model(system, state, stage, c1, exact), iteration + 1
            failed, wary, gone_to = False, WARY if size == 0.0 else wary, size > 0.0
            continue
        move(1.0, c1, x, v, tension, saddle)
        first = iteration + 1 if leap else first
        merit = np.inf if leap else trial
        bar = np.inf if leap else largest_merit(report, first, iteration, memory)
        size, failed, whole, iteration = 1.0, False, True, iteration + 1
    finish(known, stage.a, free, c2, v)
    return OK
