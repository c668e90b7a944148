"""Equal ropes that advance side by side: every step of all of them is looked ahead together."""

from __future__ import annotations

from typing import Any, NamedTuple

import numpy as np

from ropewalk.core.addresses import at
from ropewalk.core.arrays import Floats
from ropewalk.core.jit import kernel
from ropewalk.core.lane_rows import FIELDS, MOST_STAGES, SPAN
from ropewalk.core.lanes import WIDTH, room
from ropewalk.core.status import BROKEN, OK
from ropewalk.methods.implicit import advance
from ropewalk.methods.lane_stage import COURSE
from ropewalk.methods.lane_steps import enter_rope, look_ahead
from ropewalk.methods.starts import READY, USED
from ropewalk.methods.tableaus import DIRK, Tableau
from ropewalk.methods.verdict import note_changes

FEWEST_NODES = 3


class Beside(NamedTuple):
    """What ropes side by side need besides what each has."""

    work: Floats  # (FIELDS SPAN,) see `core.lane_rows`
    course: Floats  # see `lane_stage`
    able: Floats  # (WIDTH,)
    clock: Floats  # (8,) of a call for one rope and one step
    ends: Floats  # (3, WIDTH) status, good frames and steps done of every rope


def make_beside() -> Beside:
    """Return working arrays."""
    return Beside(
        room(FIELDS * SPAN), room(COURSE), np.zeros(WIDTH), np.zeros(8), np.zeros((3, WIDTH))
    )


def goes_beside(kernel: Any, tableau: Any) -> bool:
    """Tell whether steps of a method, which has this kernel and what it takes, can be looked ahead."""
    if kernel is not advance or not isinstance(tableau, Tableau):
        return False
    return tableau.kind == DIRK and tableau.stages <= MOST_STAGES


@kernel
def advance_beside(
    system, state, scratch, out, ropes, count, beside, now, frames, ledger, stop, tableau
):
    """Advance `count` of WIDTH ropes as `advance` does each; write how each ends.

    `ropes`, (4, WIDTH), has the addresses of their systems, states, scratches and recordings, `system` to
    `out` are those of one of them. `now` is the clock of `advance` for all.
    """
    clock, ends, able = beside.clock, beside.ends, beside.able
    dt, first, steps = now[1], int(now[2]), int(now[3])
    clock[0], clock[1], clock[3] = now[0], dt, 1.0
    for w in range(WIDTH):
        ends[0, w], ends[1, w], ends[2, w] = OK, frames, first + frames * steps
        rope, own = at(system, ropes[0, w]), at(state, ropes[1, w])
        enter_rope(rope, own, w, beside.work, beside.course)
        if frames == 0 and w < count:
            note_changes(rope, own)
    for frame in range(frames):
        for s in range(steps):
            begun = s > 0 or (frame == 0 and now[4] == 1.0)
            unfinished = s + 1 < steps or (frame + 1 == frames and now[5] == 1.0)
            done, going = first + frame * steps + s, 0
            for w in range(WIDTH):
                able[w] = 0.0
                if w < count and ends[0, w] == OK:
                    able[w], going = 1.0, going + 1
            t, after = now[0] + done * dt, now[0] + (done + 1) * dt
            if going > 1:
                work, course, A, c = beside.work, beside.course, tableau.A, tableau.c
                look_ahead(system, state, scratch, ropes, able, work, course, t, after, dt, A, c)
            clock[2], clock[4], clock[5] = done, 1.0 if begun else 0.0, 1.0 if unfinished else 0.0
            clock[6] = frame if not unfinished else frames
            clock[7] = 1.0 if frame > 0 or s > 0 else 0.0
            for w in range(count):
                if ends[0, w] != OK:
                    continue
                clock[2] = done
                own, rope, recorded = (
                    at(state, ropes[1, w]),
                    at(system, ropes[0, w]),
                    at(out, ropes[3, w]),
                )
                mine = at(scratch, ropes[2, w])
                known = mine.starts.known
                before = known[USED]
                status, _ = advance(
                    rope,
                    own,
                    mine,
                    None,
                    clock,
                    1,
                    ledger,
                    recorded,
                    stop and not unfinished,
                    tableau,
                )
                known[READY] = 0.0
                if known[USED] == before:  # an anchor may have let go
                    enter_rope(rope, own, w, beside.work, beside.course)
                if status != OK:
                    ends[0, w], ends[1, w] = status, frame
                    ends[2, w] = first + (frame + (1 if status == BROKEN else 0)) * steps
