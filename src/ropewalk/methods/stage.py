"""The stage solve, the heart of every implicit method:

    V = v^ + c2 a(X, V),   X = x^ + c1 V

for positions X, velocities V and the segments' tensions T, by Newton's method on the saddle-point system of
`core.saddle`, with a line search on

    merit = sum m c1 c2 |a - (V - v^) / c2|^2 + sum m_j / (c1 c2) g_j^2     [J]

(m_j the lighter node's mass of a segment), which no spring constant enters. Two safeguards make it converge
from tangled states: a compressed segment's geometric stiffness is held above -0.24 m_j / (c1 c2) far from
the solution, which keeps the matrix definite; and what begins and ends abruptly is decided in the first
iterations only. Where no part of a step brings the merit down, in a local minimum of it, a whole one is taken
with the bends' matrix held definite, too.

Sources: Nocedal & Wright, Numerical Optimization, ch. 11 (line search for equations) and 16 (saddle points);
Hairer & Wanner, Solving Ordinary Differential Equations II, IV.8 (implementation).
"""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

from ropewalk.core.arrays import Floats, Forces, State, blank
from ropewalk.core.jit import kernel, part
from ropewalk.core.largest import order, ordered
from ropewalk.core.saddle import Saddle, make_saddle
from ropewalk.core.status import OK, UNSOLVED
from ropewalk.laws.couplings import couples
from ropewalk.laws.inner import begin_inner
from ropewalk.laws.rare import has_bending, limits
from ropewalk.laws.registry import NODE_LAWS
from ropewalk.laws.stage_forces import evaluate_stage, mark_stage
from ropewalk.laws.table import accelerate
from ropewalk.methods.model_slope import follow_model
from ropewalk.methods.newton_step import newton_step
from ropewalk.methods.rounding import EPSILON, motion_rounding, rounding

MOST_ITERATIONS = 60
DECIDING = 8  # iterations that may still change what rubs and what touches
TIGHT = 1e-12  # [1] force residual over the largest force, when solved
LOOSE = 1e-8  # [1] the same, where rounding stops the descent
# The same where ropes touch each other, and as they are taken after the last iteration.
TOUCHING, TOUCHING_AT_MOST = 1e-10, 1e-6
TOUCHING_ITERATIONS = 25  # without bending: shorter steps take few
CLOSE_ENOUGH, SOON = 1e-2, 10  # as CLOSE and LATE, where ropes touch
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
FAR = 1e-5  # [1] part of the largest force and length that is left: with less no window is worth it
SHARE = 1e-3  # [1] of the merit's largest density: nodes with less at the ends are in no window
MOST_LEAPS = 12  # steps that are taken whatever the merit, out of its local minima

# Places in `Stage.report`; from HISTORY on the merit before each iteration [J].
ITERATIONS, RESIDUAL, NODE, SCALE, MISFIT, SOLVES, SPLITS, TIME, ROUNDING = range(9)
# Of a solve that has paused: the nodes that are to be solved first, and where it goes on from.
FIRST, LAST, EXACT, WARINESS, HELD_BACK, FAILED, LEAPS, LEAP, MERIT, HISTORY = range(9, 19)
# How a solve begins, or goes on: with or without the aid that it has paused for.
BEGIN, AIDED, UNAIDED = range(3)
PAUSED = -1  # beside OK and UNSOLVED


class Segments(NamedTuple):
    """What a stage knows of its segments, (s,) each but the last."""

    alive: Floats  # 1, or 0 between ropes and on a drum
    soft: Floats  # compliance 1/k [m/N]; 0 where not alive
    weight: Floats  # inertial stiffness m / (c1 c2) of the lighter node [N/m]
    stretch: Floats  # r - L [m]
    over: Floats  # 1 / r [1/m], 0 where the ends coincide
    tangent: Floats  # tangent compliance of segments with an elastic law [m/N]
    known: Floats  # d^ of what segments remember [1]; (0,) without, as the next one
    free: Floats  # strain without tension [1]
    follow: Floats  # (1,) c [s], d being d^ + c d'


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


def make_stage(state: State) -> Stage:
    """Return working arrays that fit `state`."""
    s = state.rest_length.shape[0]
    x, v, x_known, v_known, a = (np.zeros_like(state.x) for _ in range(5))
    forces = blank(state.forces)._replace(applied=state.forces.applied)
    inner = state.inner.shape[1]
    sizes = (*(6 * (s,)), inner, inner, 1)
    segments = Segments(*(np.zeros(size) for size in sizes))
    saddle = make_saddle(state.x.shape[1], state.bending_stiffness.shape[0] > 0, len(NODE_LAWS))
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
def largest_force(v, known, mass, free, gravity, c2, force, report):
    """Note the largest residual [N], and the largest force of inertia and weight [N]."""
    worst, scale, over = 0, 0, 1.0 / c2
    pull = max(abs(gravity[0]), abs(gravity[1]), abs(gravity[2]))
    v0, v1, v2, k0, k1, k2 = v[0], v[1], v[2], known[0], known[1], known[2]
    f0, f1, f2 = force[0], force[1], force[2]
    for i in range(mass.shape[0]):
        rate = abs(v0[i] - k0[i]) + abs(v1[i] - k1[i]) + abs(v2[i] - k2[i])
        heavy = mass[i] * free[i]
        scale = max(scale, order(heavy * (over * rate)), order(heavy * pull))
        worst = max(worst, order(abs(f0[i])), order(abs(f1[i])), order(abs(f2[i])))
    report[RESIDUAL], report[SCALE] = ordered(worst), ordered(scale)


@kernel
def find_worst(force, report):
    """Note the node with the largest residual."""
    worst = order(report[RESIDUAL])
    for i in range(force.shape[1]):
        size = max(order(abs(force[0, i])), order(abs(force[1, i])), order(abs(force[2, i])))
        if size >= worst:
            report[NODE] = i
            return


@kernel
def largest_misfit(x, tension, rest_length, friction, saddle, report):
    """Put tensions and friction into the force scale; note the largest misfit over what is allowed."""
    most, worst = order(report[SCALE]), 0
    x0, x1, x2, e, g = x[0], x[1], x[2], saddle.compliance, saddle.misfit
    r0, r1, r2 = friction[0], friction[1], friction[2]
    for j in range(tension.shape[0]):
        rub = max(order(abs(r0[j + 1])), order(abs(r1[j + 1])), order(abs(r2[j + 1])))
        most = max(most, order(abs(tension[j])), rub)
    scale = ordered(most)
    for j in range(tension.shape[0]):
        size = max(order(abs(x0[j])), order(abs(x1[j])), order(abs(x2[j])), order(rest_length[j]))
        allowed = TIGHT * scale * e[j] + 1e-13 * rest_length[j]
        worst = max(worst, order(abs(g[j]) / (allowed + 8.0 * EPSILON * ordered(size) + 1e-300)))
    report[SCALE], report[MISFIT] = scale, ordered(worst)


@kernel
def is_solved(report, tolerance):
    """Tell whether the forces balance to `tolerance` [1], or to rounding, and the lengths fit."""
    bound = tolerance * report[SCALE] + report[ROUNDING] + 1e-300
    return report[RESIDUAL] <= bound and report[MISFIT] <= tolerance / TIGHT


@kernel
def is_close(report, part):
    """Tell whether the solution is near: so large a part is left of forces and lengths at most [1]."""
    return report[RESIDUAL] <= part * report[SCALE] and report[MISFIT] <= part / TIGHT


@kernel
def largest_merit(report, first, iteration, memory):
    """Return the largest of the last `memory` merits, back to that of iteration `first` at most [J]."""
    largest = 0.0
    for k in range(max(first, iteration - memory + 1), iteration + 1):
        largest = max(largest, report[HISTORY + k])
    return largest


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


@kernel
def most_dense(force, misfit, mass, weight, time):
    """Return the nodes between which the merit lies dense, (first, last); `time` is c1 c2 [s^2].

    A node counts as what it adds to the merit, with half of what its segments do.
    """
    largest, first, last = 0.0, 0, -1
    for again in range(2):
        beside = 0.0
        for i in range(mass.shape[0]):
            square = force[0, i] ** 2 + force[1, i] ** 2 + force[2, i] ** 2
            after = weight[i] * misfit[i] ** 2 if i < misfit.shape[0] else 0.0
            density = time * square / mass[i] if square > 0.0 else 0.0
            density, beside = density + 0.5 * (beside + after), after
            if again == 0:
                largest = max(largest, density)
            elif density > SHARE * largest:
                first, last = first if last >= 0 else i, i
    return first, last


@part
def is_smooth(system):
    """Tell whether stretch, air and ground are all there is: a line search that looks back pays then."""
    touches = system.rare is not None and system.node.obstacle.kind.shape[0] > 0
    return not (touches or has_bending(system) or limits(system) or couples(system))


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


@kernel
def newton(system, state, stage, c1, c2, tight, window, aid):
    """Solve the stage from the guess in `x`, `v`, `tension`; held nodes are in place already.

    `c1` and `c2` [s], `x_known` and `v_known` say what the stage is; `tight` [1] is the force residual over
    the largest force, when solved. Returns OK or UNSOLVED, and PAUSED where up to `window` nodes, from
    report[FIRST] to report[LAST], would better be solved by themselves. It goes on then, by `aid`: BEGIN,
    AIDED or UNAIDED. `report` says how it went.
    """
    saddle, segments, report = stage.saddle, stage.segments, stage.report
    x, v, tension, known = stage.x, stage.v, stage.tension, stage.v_known
    mass, free = state.mass, saddle.free
    if aid == BEGIN:
        begin(mass, state.inverse_mass, state.stiffness, segments, saddle, 1.0 / (c1 * c2))
        begin_inner(system, state, segments, c2)
    merit, size, exact, wary, held_back, failed = np.inf, 0.0, False, 0, 0, False
    iteration, leaps, leap, bar, first, whole = 0, 0, False, np.inf, 0, False
    if aid != BEGIN:
        iteration, leaps, leap = int(report[ITERATIONS]), int(report[LEAPS]), report[LEAP] == 1.0
        exact, wary, held_back = report[EXACT] == 1.0, int(report[WARINESS]), int(report[HELD_BACK])
        first, merit = iteration, 0.0
        if aid == UNAIDED:
            failed, merit = report[FAILED] == 1.0, report[MERIT]
    calm, touching, last = not has_bending(system), couples(system), np.inf
    most = TOUCHING_ITERATIONS if touching and calm else MOST_ITERATIONS
    most = AIDED_ITERATIONS if window > 0 else most
    late, memory = (LATE, MEMORY) if is_smooth(system) else (CAREFUL_LATE, CAREFUL_MEMORY)
    while True:
        evaluate_stage(system, state, x, v, tension, segments, saddle, stage.forces)
        accelerate(system, state, stage.forces, stage.a)
        trial = balance(stage.a, v, known, mass, free, c1, c2, saddle.force)
        trial += misfit_merit(saddle.misfit, segments.weight)
        if not touching and size > 0.0 and not trial <= (1.0 - DESCENT * size) * bar:
            shorter = shorter_part(size, trial, merit)
            failed = shorter < SHORTEST
            shorter = 0.0 if failed else shorter
            move(shorter - size, c1, x, v, tension, saddle)
            size = shorter
            continue
        open_marks = iteration < DECIDING and saddle.band.frozen[0] == 0
        if open_marks and mark_stage(system, x, saddle) > 0.0:
            size = 0.0
            continue
        largest_force(v, known, mass, free, system.gravity, c2, saddle.force, report)
        largest_misfit(x, tension, state.rest_length, stage.forces.friction, saddle, report)
        report[ROUNDING] = rounding(system, state, stage)
        report[ITERATIONS], report[HISTORY + iteration] = iteration, trial
        if is_solved(report, TOUCHING if touching else tight):
            break
        if touching:
            enough = TOUCHING_AT_MOST if iteration == most else LOOSE
            if (iteration == most or report[RESIDUAL] > 0.5 * last) and is_solved(report, enough):
                break
            last = report[RESIDUAL]
        if window > 0 and whole and not is_close(report, FAR):
            weight = segments.weight
            start, end = most_dense(saddle.force, saddle.misfit, mass, weight, c1 * c2)
            if end - start < window:
                report[FIRST], report[LAST], report[LEAPS], report[LEAP] = start, end, leaps, leap
                report[EXACT], report[WARINESS], report[HELD_BACK] = exact, wary, held_back
                report[FAILED], report[MERIT] = failed, merit
                return PAUSED
        stuck = failed and not exact
        if stuck or iteration == most:
            report[ROUNDING] += motion_rounding(v, known, mass, free, state.damping_vector, c2)
            if is_solved(report, LOOSE if stuck else TIGHT):
                break
        leaps, leap = leaps + (1 if stuck else 0), stuck or (leap and wary > 1)
        if iteration == most or leaps > MOST_LEAPS:
            find_worst(saddle.force, report)
            return UNSOLVED
        wary = WARY if failed else wary - 1
        near = exact or (
            held_back == 1
            and (trial < NEAR * merit or (calm and is_close(report, CLOSE)) or iteration > late)
        )
        by_now = is_close(report, CLOSE_ENOUGH) or iteration > SOON
        exact = (by_now if touching else near) and wary <= 0
        leap = leap or (touching and not exact)
        held_back = newton_step(system, state, stage, c1, c2, exact, leap)
        report[SOLVES] += 1.0
        if not is_finite(saddle.moved, saddle.pulled):
            find_worst(saddle.force, report)
            return UNSOLVED
        if touching:
            size, iteration = follow_model(system, state, stage, c1, exact), iteration + 1
            wary = WARY if size == 0.0 else wary
            continue
        move(1.0, c1, x, v, tension, saddle)
        first = iteration + 1 if leap else first
        merit = np.inf if leap else trial
        bar = np.inf if leap else largest_merit(report, first, iteration, memory)
        size, failed, whole, iteration = 1.0, False, True, iteration + 1
    finish(known, stage.a, free, c2, v)
    return OK
