"""A step of equal ropes, looked ahead side by side: where each of its stages has its solution.

A rope that `lane_stage` can solve is given places, velocities and tensions of all stages, in
the bits in which it would find them itself. It takes the step by itself all the same, and begins its stages
there: its own solve finds nothing left to do, and has the last word. Any other rope is given nothing.
"""

from __future__ import annotations

from ropewalk.core.addresses import at
from ropewalk.core.arrays import APPLIED
from ropewalk.core.jit import kernel, part
from ropewalk.core.lane_rows import (
    ALIVE,
    DAMPING,
    FREE,
    INVERSE,
    LENGTH,
    LIGHT,
    MASS,
    SOFT,
    SPAN,
    STAGES,
    V_BEGIN,
    V_KNOWN,
    X_BEGIN,
    X_KNOWN,
    A,
    T,
    V,
    X,
    get,
    get3,
    put3,
)
from ropewalk.core.lanes import WIDTH, pick, spread
from ropewalk.laws.anchors import stage_target
from ropewalk.methods.kinks import near
from ropewalk.methods.lane_stage import (
    GOES_ON,
    GRAVITY,
    SOLVED,
    WAITS,
    begin,
    evaluate,
    find_gaps,
    judge,
    move,
    solve_equations,
)
from ropewalk.methods.stage_report import SOLVES
from ropewalk.methods.starts import BEGIN, END, READY, STEP


@kernel
def fill(values, first, w, work):
    """Write rows (m, n) into lane `w` of fields from `first` on."""
    for k in range(values.shape[0]):
        row, at = values[k], (first + k) * SPAN + w
        for i in range(row.shape[0]):
            work[at + i * WIDTH] = row[i]


@kernel
def take(values, first, w, work):
    """Write lane `w` of fields from `first` on into rows (m, n)."""
    for k in range(values.shape[0]):
        row, at = values[k], (first + k) * SPAN + w
        for i in range(row.shape[0]):
            row[i] = work[at + i * WIDTH]


@kernel
def fill_row(row, field, w, work):
    """Write a row into lane `w` of a field."""
    at = field * SPAN + w
    for i in range(row.shape[0]):
        work[at + i * WIDTH] = row[i]


@kernel
def fill_segments(mass, inverse_mass, stiffness, w, work):
    """Write what follows from masses and stiffness, see `stage.begin`."""
    for i in range(mass.shape[0]):
        work[i * WIDTH + FREE * SPAN + w] = 1.0 if inverse_mass[i] > 0.0 else 0.0
    for j in range(stiffness.shape[0]):
        light = min(mass[j], mass[j + 1])
        if light == 0.0:
            light = max(mass[j], mass[j + 1])
        k, at = stiffness[j], j * WIDTH + w
        work[at + LIGHT * SPAN] = light
        work[at + ALIVE * SPAN] = 1.0 if k > 0.0 else 0.0
        work[at + SOFT * SPAN] = 1.0 / k if k > 0.0 else 0.0


@kernel
def enter(state, w, work):
    """Write where a rope's step begins into lane `w`."""
    fill(state.x, X_BEGIN, w, work)
    fill(state.v, V_BEGIN, w, work)
    fill(state.acceleration, A, w, work)
    fill_row(state.tension, T, w, work)


@kernel
def enter_rope(system, state, w, work, course):
    """Write what stays the same of a rope, but for anchors that let go, into lane `w`."""
    fill_row(state.mass, MASS, w, work)
    fill_row(state.inverse_mass, INVERSE, w, work)
    fill_row(state.rest_length, LENGTH, w, work)
    fill_row(state.damping_vector, DAMPING, w, work)
    fill_segments(state.mass, state.inverse_mass, state.stiffness, w, work)
    for k in range(3):
        course[GRAVITY + k * WIDTH + w] = system.gravity[k]


@kernel
def hold(system, state, scratch, w, time, ahead, end, h, work):
    """Put the held nodes of lane `w` where they are at `time` [s], see `anchors.place_stage`."""
    x, v = scratch.point, scratch.speed
    for row in range(state.held.shape[0]):
        if state.held[row] == 1:
            stage_target(system, state, row, time, ahead, end, h, x, v)
            at = state.anchor_node[row] * WIDTH + w
            for k in range(3):
                work[at + (X + k) * SPAN] = x[k]
                work[at + (V + k) * SPAN] = v[k]


@kernel
def leave(scratch, s, w, work):
    """Give a rope where the solution of its stage `s` is."""
    starts = scratch.starts
    take(starts.x[s], X, w, work)
    take(starts.v[s], V, w, work)
    row, at = starts.tension[s], T * SPAN + w
    for j in range(row.shape[0]):
        row[j] = work[at + j * WIDTH]


@kernel
def know(work, n, A_table, s, dt):
    """Write what is known of stage `s`, and where it begins, see `implicit.prepare_dirk`."""
    c = dt * A_table[s, s]
    for i in range(n):
        x, v = get3(work, i, X_BEGIN), get3(work, i, V_BEGIN)
        for r in range(s):
            u, k, weight = (
                get3(work, i, STAGES + 6 * r),
                get3(work, i, STAGES + 6 * r + 3),
                dt * A_table[s, r],
            )
            x = (x[0] + weight * u[0], x[1] + weight * u[1], x[2] + weight * u[2])
            v = (v[0] + weight * k[0], v[1] + weight * k[1], v[2] + weight * k[2])
        put3(work, i, X_KNOWN, x)
        put3(work, i, V_KNOWN, v)
        a = get3(work, i, A)
        v = (v[0] + c * a[0], v[1] + c * a[1], v[2] + c * a[2])
        put3(work, i, V, v)
        put3(work, i, X, (x[0] + c * v[0], x[1] + c * v[1], x[2] + c * v[2]))


@kernel
def keep_begin(work, n, s):
    """Keep velocity and acceleration of the step's beginning as those of stage `s`."""
    for i in range(n):
        put3(work, i, STAGES + 6 * s, get3(work, i, V_BEGIN))
        put3(work, i, STAGES + 6 * s + 3, get3(work, i, A))


@kernel
def finish(work, n, s, c):
    """Let V follow from the forces, see `stage.finish`; keep both as those of stage `s`."""
    zero = spread(0.0)
    for i in range(n):
        a, v, known, free = (
            get3(work, i, A),
            get3(work, i, V),
            get3(work, i, V_KNOWN),
            get(work, i, FREE),
        )
        v = (
            pick(zero, free, known[0] + c * a[0], v[0]),
            pick(zero, free, known[1] + c * a[1], v[1]),
            pick(zero, free, known[2] + c * a[2], v[2]),
        )
        put3(work, i, STAGES + 6 * s, v)
        put3(work, i, STAGES + 6 * s + 3, a)


@kernel
def lets_go(anchors, held, t, dt):
    """Tell whether a rope is let go of by an anchor as the step begins, see `anchors.release_anchors`."""
    for row in range(held.shape[0]):
        if held[row] == 1 and anchors.release[row] <= t + near(t, dt):
            return True
    return False


@part
def solve_stages(scratch, scratches, able, work, course, n, c):
    """Solve a stage in all lanes that can be; those that cannot are not `able` any more."""
    begin(work, course, n, 1.0 / (c * c))
    for w in range(WIDTH):
        course[GOES_ON + w] = able[w]
    iteration = 0
    while True:
        evaluate(work, course, n, c, c)
        find_gaps(work, course, n)
        searching, waiting = 0, 0
        for w in range(WIDTH):
            if course[GOES_ON + w] > 0.0 and course[WAITS + w] == 0.0:
                report = at(scratch, scratches[w]).stage.report
                searching += judge(course, w, iteration, report)
                report[SOLVES] += course[WAITS + w]
            waiting += 1 if course[WAITS + w] > 0.0 else 0
        if searching == 0 and waiting == 0:
            break
        if searching == 0:
            solve_equations(work, course, n, c, c)
            iteration += 1
        move(work, course, n, c)
    for w in range(WIDTH):
        able[w] *= course[SOLVED + w]


@part
def begin_lanes(system, state, systems, states, able, work, course, t, dt):
    """Take up the ropes that are `able`; not able are those that are let go of now, or pushed."""
    for w in range(WIDTH):
        if able[w] > 0.0:
            rope, own = at(system, systems[w]), at(state, states[w])
            if rope.flags[APPLIED] == 1 or lets_go(rope.anchors, own.held, t, dt):
                able[w] = 0.0
            else:
                enter(own, w, work)


@part
def tell(scratch, scratches, able, t, after, dt):
    """Say for which step ropes have the starts of all stages."""
    for w in range(WIDTH):
        if able[w] > 0.0:
            known = at(scratch, scratches[w]).starts.known
            known[READY], known[BEGIN], known[END], known[STEP] = 1.0, t, after, dt


@kernel
def look_ahead(system, state, scratch, ropes, able, work, course, t, after, dt, A_table, c):
    """Find the stages of a step of all ropes that are `able` (1, else 0), and give each its own.

    `ropes` has the addresses of their systems, states and scratches, of the types of those of one of them.
    """
    systems, states, scratches, n = ropes[0], ropes[1], ropes[2], state.x.shape[1]
    begin_lanes(system, state, systems, states, able, work, course, t, dt)
    for s in range(c.shape[0]):
        if A_table[s, s] == 0.0:
            keep_begin(work, n, s)
            continue
        time, ahead, own = after if c[s] == 1.0 else t + c[s] * dt, c[s] * dt, dt * A_table[s, s]
        know(work, n, A_table, s, dt)
        whole = dt if s == 0 and c.shape[0] == 2 else 0.0
        for w in range(WIDTH):
            if able[w] > 0.0:
                rope, begun = at(system, systems[w]), at(state, states[w])
                hold(rope, begun, at(scratch, scratches[w]), w, time, ahead, after, whole, work)
        solve_stages(scratch, scratches, able, work, course, n, own)
        for w in range(WIDTH):
            if able[w] > 0.0:
                leave(at(scratch, scratches[w]), s, w, work)
        finish(work, n, s, own)
    tell(scratch, scratches, able, t, after, dt)
