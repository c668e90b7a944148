"""The loop over frames and steps for steps that take a range of nodes: in tiles that fit the cache."""

from __future__ import annotations

from typing import Any

from ropewalk.core.jit import part
from ropewalk.core.status import OK
from ropewalk.laws.anchors import release_anchors
from ropewalk.laws.limiter import limit_stretch
from ropewalk.laws.rare import acts_after, limits, parts, winds
from ropewalk.laws.table import reaches_neighbours_only
from ropewalk.laws.winch import run_winches
from ropewalk.methods.errors import keep_step_error
from ropewalk.methods.loop import close_frame, named
from ropewalk.methods.partings import part_ropes
from ropewalk.methods.peak_search import search_all
from ropewalk.methods.peaks import DEPTH, looks_at_all, wanted
from ropewalk.methods.scratch import SEEN
from ropewalk.methods.verdict import note_changes
from ropewalk.methods.watch import close_interval, open_interval, watch

TILE = 200  # nodes; all their arrays, some 45 kB, fit the cache next to the processor


@part
def _act_after(system, state, scratch, t, dt, ledger):
    """Turn winches and let the limiter act on the end of a step from `t` [s]."""
    if winds(system, state):
        run_winches(system, state, t, dt, scratch.turning)
    if limits(system):
        limit_stretch(system, state, scratch.limiter, dt, ledger)


def make_tiled_advance(step: Any, before: Any) -> Any:
    """Return the kernel that advances by a method's `step`, a part compiled into it.

    A long rope is cut into tiles that fit the cache, and a tile goes through up to DEPTH steps
    before the next one: from step to step it moves back by one node, so that all neighbours stand where
    they are needed and every node goes through the same arithmetic as in one sweep, to the same bits.
    What a tile needs of the segment before it is in the force arrays: written by the tile before it in the
    same step, and reached by none of the later ones. Steps are not cut at kinks: the order is one.
    The energy error of every step takes whole sweeps, too.
    `step` looks itself at what it begins with, see `peaks`; `before` is called before the first one.
    """

    def advance(system, state, scratch, extras, clock, frames, ledger, out, stop_at_break, tableau):
        """Advance `frames` frames; return the status and the number of good frames. See `make_advance`."""
        dt = clock[1]
        done, steps = int(clock[2]), int(clock[3])
        n, look = state.mass.shape[0], scratch.look
        look.known[SEEN] = 0.0
        before(state, scratch)
        note_changes(system, state)
        watches = looks_at_all(system, extras)
        errs = ledger and wanted(state) and not watches
        width = TILE if not watches and reaches_neighbours_only(system, state) and not errs else n
        for frame in range(frames):
            if frame > 0 or clock[4] == 0.0:
                open_interval(system, state, look, clock[0] + done * dt)
            start, end = done, done + steps
            while start < end:
                first, stop = 0, min(start + DEPTH - start % DEPTH, end)
                while first < n:
                    last = first + width if n - first >= 2 * width else n
                    for s in range(start, stop):
                        lo = first - (s - start) if first > 0 else 0
                        hi = last - (s - start) if last < n else n
                        t, after = clock[0] + s * dt, clock[0] + (s + 1) * dt
                        release_anchors(system, state, t, 1e-6 * dt, lo, hi)
                        step(system, state, scratch, t, after, dt, ledger, tableau, lo, hi)
                        if acts_after(extras):
                            _act_after(system, state, scratch, t, dt, ledger)
                        if watches:
                            watch(system, state, look, after)
                        elif errs:
                            keep_step_error(system, state, look, after)
                        if parts(system):
                            part_ropes(system, state, look, after)
                    first = last
                if not watches and stop % DEPTH == 0 and wanted(state):
                    search_all(system, state, clock[0] + (stop - 1) * dt, look.sums)
                start = stop
            done += steps
            clock[2] = done
            last_look, time = clock[0] + (done - 1) * dt, clock[0] + done * dt
            if frame + 1 < frames or clock[5] == 0.0:
                close_interval(system, state, look, last_look, time)
            status = close_frame(system, state, ledger, time, stop_at_break, look, frame, out)
            if status != OK and stop_at_break:
                return status, frame
        return OK, frames

    return named(advance, step)
