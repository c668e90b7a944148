"""The stages of ropes side by side, solved as `stage.newton` does where nothing is marked on the way.

The same operations in the same order, lane by lane, and so the same bits: the forces of springs, vector
friction and weight (`laws.stage_forces`, `laws.table`), residuals and merit (`stage`), what is left of forces
and lengths (`stage_report`), and the equations (`newton_step`).
"""

from __future__ import annotations

import numpy as np

from ropewalk.core.jit import kernel, small
from ropewalk.core.lane_rows import (
    ACROSS,
    ALIVE,
    BEND,
    COMPLIANCE,
    DAMPING,
    DIRECTION,
    FORCE,
    FREE,
    INVERSE,
    LENGTH,
    LIGHT,
    MASS,
    MISFIT,
    MOVED,
    ON,
    OVER,
    PULLED,
    SLACK,
    SOFT,
    V_KNOWN,
    WEIGHT,
    A,
    T,
    V,
    X,
    get,
    get3,
    put,
    put3,
)
from ropewalk.core.lane_sweep import lane_sweep
from ropewalk.core.lanes import WIDTH, greater, load, pick, root, size, spread, store
from ropewalk.methods.newton_step import COMPRESSION
from ropewalk.methods.rounding import EPSILON
from ropewalk.methods.stage import CLOSE, DESCENT, MEMORY, NEAR, SHORTEST, shorter_part
from ropewalk.methods.stage_report import (
    HISTORY,
    RESIDUAL,
    ROUNDING,
    SCALE,
    TIGHT,
    is_close,
    is_solved,
    largest_merit,
)
from ropewalk.methods.stage_report import MISFIT as WORST

MOST = 14  # iterations side by side
# Places in `course`, one number a lane each: weight per mass, what an iterate is like, and how it goes on.
(
    GRAVITY,
    TRIAL,
    LEFT,
    LARGEST,
    GAP,
    HELD_BACK,
    MERIT,
    BAR,
    EXACT,
    GOES_ON,
    SOLVED,
    WAITS,
    SIZE,
    PART,
) = (WIDTH * row for row in (0, *range(3, 16)))
COURSE = 16 * WIDTH


@small
def _minus(a, b):
    return a[0] - b[0], a[1] - b[1], a[2] - b[2]


@small
def _plus(a, b):
    return a[0] + b[0], a[1] + b[1], a[2] + b[2]


@small
def _chosen(going, new, old):
    """Return the new numbers in lanes that go on."""
    zero = spread(0.0)
    return (
        pick(zero, going, new[0], old[0]),
        pick(zero, going, new[1], old[1]),
        pick(zero, going, new[2], old[2]),
    )


@small
def _times(number, a):
    return number * a[0], number * a[1], number * a[2]


@small
def _largest(a):
    return greater(greater(size(a[0]), size(a[1])), size(a[2]))


@small
def _pull(work, j):
    """Write the equation of segment `j`; return its pull with the friction, and the friction, three each."""
    zero = spread(0.0)
    d = _minus(get3(work, j + 1, X), get3(work, j, X))
    r = root(d[0] * d[0] + d[1] * d[1] + d[2] * d[2])
    alive, tension = get(work, j, ALIVE), get(work, j, T)
    over = pick(zero, r, alive / r, zero)
    t = _times(over, d)
    stretch = alive * (r - get(work, j, LENGTH))
    c = _times(get(work, j, DAMPING), _minus(get3(work, j + 1, V), get3(work, j, V)))
    on = pick(zero, over, spread(1.0), zero)
    compliance = pick(zero, over, get(work, j, SOFT), get(work, j, SLACK))
    put3(work, j, DIRECTION, t)
    put(work, j, OVER, over)
    put(work, j, ON, on)
    put(work, j, COMPLIANCE, compliance)
    put(work, j, MISFIT, on * stretch - compliance * tension)
    e = _times(tension, t)
    return (e[0] + c[0], e[1] + c[1], e[2] + c[2]), c


@small
def _balance(work, i, pulls, before, gravity, over):
    """Write acceleration and residual of node `i` between two pulls; return the residual, mass and rate."""
    zero = spread(0.0)
    inverse, heavy = get(work, i, INVERSE), get(work, i, MASS) * get(work, i, FREE)
    a0 = (pulls[0] - before[0]) * inverse + pick(zero, inverse, gravity[0], zero)
    a1 = (pulls[1] - before[1]) * inverse + pick(zero, inverse, gravity[1], zero)
    a2 = (pulls[2] - before[2]) * inverse + pick(zero, inverse, gravity[2], zero)
    u = _minus(get3(work, i, V), get3(work, i, V_KNOWN))
    f = (heavy * (a0 - over * u[0]), heavy * (a1 - over * u[1]), heavy * (a2 - over * u[2]))
    put3(work, i, A, (a0, a1, a2))
    put3(work, i, FORCE, f)
    return f, heavy, size(u[0]) + size(u[1]) + size(u[2])


@kernel
def evaluate(work, course, n, c1, c2):
    """Write forces and residuals at the iterates, and what they are like into `course`."""
    zero, over = spread(0.0), 1.0 / c2
    gravity = (
        load(course, GRAVITY),
        load(course, GRAVITY + WIDTH),
        load(course, GRAVITY + 2 * WIDTH),
    )
    pull = _largest(gravity)
    before, total, gaps, scale, worst = (zero, zero, zero), zero, zero, zero, zero
    for i in range(n):
        pulls = (zero, zero, zero)
        if i < n - 1:
            pulls, friction = _pull(work, i)
            gap = get(work, i, MISFIT)
            gaps = gaps + get(work, i, WEIGHT) * gap * gap
            scale = greater(scale, greater(size(get(work, i, T)), _largest(friction)))
        f, heavy, rate = _balance(work, i, pulls, before, gravity, over)
        before = pulls
        square = f[0] * f[0] + f[1] * f[1] + f[2] * f[2]
        total = total + pick(zero, square, square / get(work, i, MASS), square)
        scale = greater(scale, greater(heavy * (over * rate), heavy * pull))
        worst = greater(worst, _largest(f))
    store(course, TRIAL, c1 * c2 * total + gaps)
    store(course, LEFT, worst)
    store(course, LARGEST, scale)


@kernel
def find_gaps(work, course, n):
    """Write the largest misfit over what is allowed; infinite where the forces are far from balance."""
    far = 0
    for w in range(WIDTH):
        close = course[LEFT + w] <= CLOSE * course[LARGEST + w] or course[LEFT + w] <= 1e-300
        far += 0 if close and course[GOES_ON + w] > 0.0 else 1
    if far == WIDTH:
        store(course, GAP, spread(np.inf))
        return
    worst, allowance = spread(0.0), TIGHT * load(course, LARGEST)
    for j in range(n - 1):
        length = get(work, j, LENGTH)
        allowed = allowance * get(work, j, COMPLIANCE) + 1e-13 * length
        far = greater(_largest(get3(work, j, X)), length)
        gap = size(get(work, j, MISFIT)) / (allowed + 8.0 * EPSILON * far + 1e-300)
        worst = greater(worst, gap)
    store(course, GAP, worst)


@kernel
def judge(course, w, iteration, report):
    """Judge the iterate of lane `w`; return 1 where its line search goes on, else 0.

    It then WAITS for the next iteration, is SOLVED, or is left to others.
    """
    trial, exact, size = course[TRIAL + w], course[EXACT + w] == 1.0, course[SIZE + w]
    if size > 0.0 and not trial <= (1.0 - DESCENT * size) * course[BAR + w]:
        shorter = shorter_part(size, trial, course[MERIT + w])
        course[SIZE + w], course[PART + w] = shorter, shorter - size
        if shorter >= SHORTEST:
            return 1
        course[GOES_ON + w], course[PART + w] = 0.0, 0.0
        return 0
    course[GOES_ON + w], course[PART + w] = 0.0, 0.0
    report[RESIDUAL], report[SCALE] = course[LEFT + w], course[LARGEST + w]
    report[WORST], report[ROUNDING], report[HISTORY + iteration] = course[GAP + w], 0.0, trial
    if is_solved(report, TIGHT):
        course[SOLVED + w] = 1.0
    elif iteration < MOST and trial < np.inf:
        quick = trial < NEAR * course[MERIT + w] or is_close(report, CLOSE)
        near = exact or (course[HELD_BACK + w] > 0.0 and quick)
        course[EXACT + w], course[GOES_ON + w], course[WAITS + w] = 1.0 if near else 0.0, 1.0, 1.0
        course[MERIT + w], course[BAR + w] = trial, largest_merit(report, 0, iteration, MEMORY)
    return 0


@kernel
def stiffen(work, course, n, over_c1):
    """Write the segments' stiffness; held back where compressed, but for lanes that are EXACT."""
    zero, one, held_back = spread(0.0), spread(1.0), spread(0.0)
    exact, least = load(course, EXACT), spread(-1e308)
    for j in range(n - 1):
        bend = get(work, j, T) * get(work, j, OVER)
        floor = pick(zero, exact, least, COMPRESSION * get(work, j, WEIGHT))
        held_back = pick(bend, floor, one, held_back)
        bend = pick(bend, floor, floor, bend)
        c = get(work, j, DAMPING) * over_c1
        across = bend + c
        put(work, j, ACROSS, across)
        put(work, j, BEND, c - across)
    store(course, HELD_BACK, held_back)


@kernel
def move(work, course, n, c1):
    """Go the PART of the Newton step in each lane; those with none stay as they are."""
    zero, part = spread(0.0), load(course, PART)
    going, over = size(part), part / c1
    for i in range(n):
        free, z = get(work, i, FREE), get3(work, i, MOVED)
        x, v, tension = get3(work, i, X), get3(work, i, V), get(work, i, T)
        put3(work, i, X, _chosen(going, _plus(x, _times(part * free, z)), x))
        put3(work, i, V, _chosen(going, _plus(v, _times(over * free, z)), v))
        pulled = part * get(work, i, PULLED)
        put(work, i, T, pick(zero, going, tension + pulled, tension))


@kernel
def begin(work, course, n, inertia):
    """Write what stays the same while the stage is solved; `inertia` is 1 / (c1 c2) [1/s^2]."""
    zero, one, none = spread(0.0), spread(1.0), spread(np.inf)
    for j in range(n):
        light = get(work, j, LIGHT)
        weight = pick(zero, light, light * inertia, one)
        put(work, j, WEIGHT, weight)
        put(work, j, SLACK, 1.0 / weight)
    store(course, HELD_BACK, zero)
    store(course, EXACT, zero)
    store(course, SOLVED, zero)
    store(course, MERIT, none)
    store(course, BAR, none)
    store(course, WAITS, zero)
    store(course, SIZE, zero)
    store(course, PART, zero)


@kernel
def solve_equations(work, course, n, c1, c2):
    """Solve the equations of a step of Newton's method, which all that wait then go."""
    stiffen(work, course, n, 1.0 / c1)
    lane_sweep(work, n, 1.0 / (c1 * c2))
    one, waits = spread(1.0), load(course, WAITS)
    store(course, PART, waits)
    store(course, SIZE, one)
    store(course, WAITS, spread(0.0))
