"""The loop over frames and steps for steps that take a range of nodes: in tiles that fit the cache."""

from __future__ import annotations

from typing import Any

from ropewalk.core.status import OK
from ropewalk.laws.anchors import release_anchors
from ropewalk.laws.table import reaches_neighbours_only
from ropewalk.methods.loop import close_frame, named, wind_and_limit
from ropewalk.methods.verdict import note_changes

TILE = 1024  # nodes; about 250 kB of all their arrays
DEPTH = 32  # steps


def make_tiled_advance(step: Any) -> Any:
    """Return the kernel that advances by a method's `step`, a part compiled into it.

    A long rope is cut into tiles that fit the cache, and a tile goes through up to DEPTH steps
    before the next one: from step to step it moves back by one node, so that all neighbours stand where
    they are needed and every node goes through the same arithmetic as in one sweep, to the same bits.
    What a tile needs of the segment before it is in the force arrays: written by the tile before it in the
    same step, and reached by none of the later ones. Steps are not cut at kinks: the order is one.
    """

    def advance(system, state, scratch, extras, clock, frames, ledger, out, stop_at_break, tableau):
        """Advance `frames` frames; return the status and the number of good frames. See `make_advance`."""
        dt = clock[1]
        done, steps = int(clock[2]), int(clock[3])
        n = state.mass.shape[0]
        note_changes(system, state)
        width = TILE if extras is None and reaches_neighbours_only(system) else n
        for frame in range(frames):
            for start in range(done, done + steps, DEPTH):
                first = 0
                while first < n:
                    last = first + width if n - first >= 2 * width else n
                    for s in range(start, min(start + DEPTH, done + steps)):
                        lo = first - (s - start) if first > 0 else 0
                        hi = last - (s - start) if last < n else n
                        t, after = clock[0] + s * dt, clock[0] + (s + 1) * dt
                        release_anchors(system, state, t, dt, lo, hi)
                        step(system, state, scratch, t, after, dt, ledger, tableau, lo, hi)
                        if extras is not None:
                            wind_and_limit(system, state, scratch, t, dt, ledger)
                    first = last
            done += steps
            clock[2] = done
            time, sums = clock[0] + done * dt, scratch.sums
            status = close_frame(system, state, ledger, time, stop_at_break, sums, frame, out)
            if status != OK and stop_at_break:
                return status, frame
        return OK, frames

    return named(advance, step)
