"""What the solve of a stage reports: how far it is from the solution, and where it pauses and goes on.

It pauses where a window of the rope would better be solved by itself, see `window`.
"""

from __future__ import annotations

import numpy as np

from ropewalk.core.jit import kernel, part, small
from ropewalk.core.largest import order, ordered
from ropewalk.methods.rounding import EPSILON

TIGHT = 1e-12  # [1] force residual over the largest force, when solved
FAR = 1e-5  # [1] part of the largest force and length that is left: with less no window is worth it
SHARE = 1e-3  # [1] of the merit's largest density: nodes with less at the ends are in no window

# Places in `Stage.report`; from HISTORY on the merit before each iteration [J].
ITERATIONS, RESIDUAL, NODE, SCALE, MISFIT, SOLVES, SPLITS, TIME, ROUNDING = range(9)
# Of a solve that has paused: the nodes that are to be solved first, and where it goes on from.
FIRST, LAST, EXACT, WARINESS, HELD_BACK, FAILED, LEAPS, LEAP, MERIT = range(9, 18)
# How quickly a contact stops what it hits in the last step [1/s]; 1: an obstacle has pressed in the solve.
QUICK, PRESSED, HISTORY = 18, 19, 20
# How a solve begins, or goes on: with or without the aid that it has paused for.
BEGIN, AIDED, UNAIDED = range(3)
PAUSED = -1  # beside OK and UNSOLVED


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
def needs_window(stage, mass, time, most):
    """Tell whether up to `most` nodes would better be solved by themselves, and note them."""
    report, saddle = stage.report, stage.saddle
    if most <= 0 or is_close(report, FAR):
        return False
    first, last = most_dense(saddle.force, saddle.misfit, mass, stage.segments.weight, time)
    report[FIRST], report[LAST] = first, last
    return last - first < most


@small
def keep_course(report, merit, exact, wary, held_back, failed, leaps, leap):
    """Note where a solve goes on from after its pause; the iteration is noted already."""
    report[MERIT], report[EXACT], report[WARINESS] = merit, exact, wary
    report[HELD_BACK], report[FAILED] = held_back, failed
    report[LEAPS], report[LEAP] = leaps, leap


@small
def take_course(report, aid):
    """Return what `keep_course` has noted, and the iteration first; at the beginning what that begins with.

    With aid there is no merit and no failure to go by.
    """
    if aid == BEGIN:
        return 0, np.inf, False, 0, 0, False, 0, False
    merit = report[MERIT] if aid == UNAIDED else 0.0
    failed = aid == UNAIDED and report[FAILED] == 1.0
    exact, wary, held_back = report[EXACT] == 1.0, int(report[WARINESS]), int(report[HELD_BACK])
    at, leaps, leap = int(report[ITERATIONS]), int(report[LEAPS]), report[LEAP] == 1.0
    return at, merit, exact, wary, held_back, failed, leaps, leap
