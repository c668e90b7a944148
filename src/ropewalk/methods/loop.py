"""The loop over frames and steps, one for all methods, and what comes before and after it."""

from __future__ import annotations

from typing import Any

from ropewalk.core.jit import kernel, part, seldom
from ropewalk.core.status import OK
from ropewalk.laws.anchors import release_anchors
from ropewalk.laws.elastic import RATE, tensions
from ropewalk.laws.inner import write_rates
from ropewalk.laws.limiter import clear_pulls, limit_stretch, note_bounds
from ropewalk.laws.links import hold_links
from ropewalk.laws.rare import acts_after, has_inner, limits, parts, winds
from ropewalk.laws.table import accelerate, evaluate
from ropewalk.laws.winch import end_turns, plan_turns
from ropewalk.methods.errors import look_at_step
from ropewalk.methods.kinks import near, next_piece, take_up_hands
from ropewalk.methods.partings import part_ropes
from ropewalk.methods.peaks import any_rubs, looks_at_all, wanted
from ropewalk.methods.recording import record_frame
from ropewalk.methods.scratch import SEEN, clear
from ropewalk.methods.starts import forget_starts
from ropewalk.methods.tableaus import BDF2
from ropewalk.methods.verdict import judge, note_changes, note_energy
from ropewalk.methods.watch import close_interval, open_interval, watch


@seldom
def prepare(system, state):
    """Evaluate all forces and accelerations at the state itself; what a method kept is void."""
    state.now[0] = state.now[1]
    evaluate(system, state, state.x, state.v, state.forces)
    if limits(system):
        clear(state.forces.limiter)
    accelerate(system, state, state.forces, state.acceleration)
    if has_inner(system, state):
        write_rates(system, state, state.x, state.inner[RATE])
    tensions(system, state, state.tension)
    state.past[0] = 0.0


@seldom
def prepare_links(system, state, t, saddle):
    """As `prepare`, and hold the lengths of rigid links at time `t` [s]; `saddle` lends its arrays."""
    prepare(system, state)
    hold_links(system, state, t, saddle)


@part
def _prepare_solver(system, state, t, scratch):
    """Prepare for a method that solves: the forces are those of now, and no step's."""
    prepare_links(system, state, t, scratch.stage.saddle)
    if limits(system):
        clear_pulls(state.limited)
    forget_starts(scratch.starts)


@part
def _prepare_other(system, state, t, scratch):
    """Prepare for a method without equations."""
    prepare(system, state)


@kernel
def nodes_out(exits):
    """Return the sum of the nodes at the winches' exits, which tells whether any has changed."""
    total = 0.0
    for row in range(exits.shape[0]):
        total += exits[row]
    return total


@part
def _renew_solver(system, state, t, scratch, tableau):
    """Prepare for the step after winches have turned.

    What BDF2 keeps of the step before stays true; but where it is to begin anew, as a node has come off a
    drum, the pull of bounds on the segment before that is not known yet. What bounds have held in the step,
    the impulses of impacts, is not among the forces that it goes on with, and is kept beside them.
    """
    changed = state.past[2] != nodes_out(state.winch_exit)
    if tableau.kind != BDF2 or (limits(system) and changed):
        prepare_links(system, state, t, scratch.stage.saddle)
        if limits(system):
            stage = scratch.stage
            note_bounds(system, state, stage.forces.limiter, stage.tension, changed)
    elif limits(system):
        clear_pulls(state.limited)


@part
def _renew_other(system, state, t, scratch, tableau):
    """Prepare for the step after winches have turned."""
    prepare(system, state)


@part
def _wind(system, state, scratch, t, dt, ledger):
    """End the turns of winches; a method that solves has the limiter in its equations."""
    if winds(system, state):
        end_turns(system, state, scratch.turning)


@part
def _wind_and_limit(system, state, scratch, t, dt, ledger):
    """End the turns of winches, and let the limiter act on the end of a step."""
    if winds(system, state):
        end_turns(system, state, scratch.turning)
    if limits(system):
        limit_stretch(system, state, scratch.limiter, dt, ledger)


_SOLVER = _prepare_solver, _renew_solver, _wind
_OTHER = _prepare_other, _renew_other, _wind_and_limit


@kernel
def close_frame(system, state, ledger, time, stop_at_break, look, frame, out):
    """Record the frame at `time` [s] where `out` has it; return the state's status.

    Part of a frame, which is neither recorded nor to stop, is not judged: where calls end changes nothing.
    """
    if out.x.shape[0] > frame:
        record_frame(system, state, ledger, look, frame, out)
    elif not stop_at_break:
        note_energy(system, state)
        return OK
    return judge(system, state, time)


@kernel
def first_row(clock):
    """Return the row of the recording for the first frame, 0 unless the clock has it."""
    return int(clock[6]) if clock.shape[0] > 6 else 0


@kernel
def open_call(system, state, look, clock):
    """Forget what the call before has left, unless this one goes on with it, which only the clock can say."""
    if clock.shape[0] < 8 or clock[7] != 1.0:
        look.known[SEEN] = 0.0
        note_changes(system, state)


def _always(step: Any) -> Any:
    """Return a step without equations, which ends well, as one that says so."""

    @part
    def take(system, state, scratch, t, after, dt, ledger, tableau):
        """Take a step; return OK."""
        step(system, state, scratch, t, after, dt, ledger, tableau)
        return OK

    return take


def _module(step: Any) -> str:
    """Return the module of a part, which is a plain function where numba is switched off."""
    return str(getattr(step, "py_func", step).__module__)


def make_advance(step: Any, *, carries: bool = False, solves: bool = False) -> Any:
    """Return the kernel that advances by a method's `step`, a part compiled into it, cut at kinks.

    With `carries` a step begins with the forces that the one before ended with; `solves`: it has a status.
    """
    begin_anew, renew, act_after = _SOLVER if solves else _OTHER
    take = step if solves else _always(step)

    def advance(system, state, scratch, extras, clock, frames, ledger, out, stop_at_break, tableau):
        """Advance `frames` frames; return the status and the number of good frames.

        `clock`: t0, dt, steps done and steps per frame (t = t0 + step dt, never a sum); 1 where the first one
        is begun already, 1 where the last is not ended; first row of `out`; 1 where the call before goes on.
        """
        dt, done, steps = clock[1], int(clock[2]), int(clock[3])
        point, speed, look = scratch.point, scratch.speed, scratch.look
        rubs, r = any_rubs(state.damping_vector, state.damping_axial), first_row(clock)
        open_call(system, state, look, clock)
        for frame in range(frames):
            t, parted = clock[0] + done * dt, False
            if frame > 0 or clock[4] == 0.0:
                open_interval(system, state, look, t)
            if frame == 0 and take_up_hands(system, state, t, point, speed) > 0 and carries:
                begin_anew(system, state, t, scratch)
            for s in range(done, done + steps):
                t, begin, after = clock[0] + s * dt, clock[0] + s * dt, clock[0] + (s + 1) * dt
                while begin < after:  # once, but for kinks
                    anew = release_anchors(system, state, begin, near(begin, dt))
                    h, end, to, jumps = next_piece(system, state, t, begin, after, dt, point, speed)
                    if winds(system, state):
                        anew = plan_turns(system, state, begin, h, scratch.turning) or anew
                    if (anew or jumps > 0) and carries:
                        begin_anew(system, state, begin, scratch)
                    status = take(system, state, scratch, begin, end, h, ledger, tableau)
                    if status != OK:
                        return status, frame
                    if acts_after(extras):
                        act_after(system, state, scratch, begin, h, ledger)
                        if carries:
                            renew(system, state, end, scratch, tableau)
                    begin = to
                    if begin < after:  # the end of a pull, often its peak
                        close_interval(system, state, look, t, begin)
                if solves or looks_at_all(system, extras):
                    watch(system, state, look, after)
                elif wanted(state):
                    look_at_step(system, state, rubs, s + 1, look, after)
                parted = parts(system) and part_ropes(system, state, look, after) > 0
                if parted and carries:
                    begin_anew(system, state, after, scratch)
            done, clock[2] = done + steps, done + steps
            watched = not parted and (solves or looks_at_all(system, extras))
            if not watched and (frame + 1 < frames or clock[5] == 0.0):
                close_interval(system, state, look, after, after)
            status = close_frame(system, state, ledger, after, stop_at_break, look, r + frame, out)
            if status != OK and stop_at_break:
                return status, frame
        return OK, frames

    return named(advance, step)


def named(advance: Any, step: Any) -> Any:
    """Return the kernel of `advance`, named after the method: files of machine code carry the name."""
    advance.__qualname__ = f"advance-{_module(step).rpartition('.')[2]}"
    return kernel(advance)
