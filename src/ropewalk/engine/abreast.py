"""Equal ropes that nothing ties together move side by side, a register's width of them in one call.

What a rope does has the same bits alone and abreast of others (`methods.lane_steps`), so that it does not
matter who goes with whom, nor where one that breaks leaves the others.
"""

from __future__ import annotations

from collections.abc import Sequence
from threading import local

import numpy as np

from ropewalk.core.addresses import Kept
from ropewalk.core.arrays import Floats
from ropewalk.core.lanes import WIDTH
from ropewalk.core.status import BROKEN, OK, PAUSED
from ropewalk.engine.crews import Mate
from ropewalk.engine.engine import Asked, Moved
from ropewalk.engine.slices import Edges, Slices
from ropewalk.methods.recording import Recording
from ropewalk.methods.side_by_side import advance_beside, make_beside

_here = local()  # working arrays, a thread's own


class Outs:
    """What several ropes record."""

    def __init__(self, outs: Sequence[Recording]) -> None:
        self.outs = tuple(outs)

    def part(self, first: int, last: int) -> Outs:
        """Return the buffers of frames `first` to `last - 1`."""
        if first == 0 and last >= len(self.outs[0].x):
            return self  # at the same addresses
        return Outs([out.part(first, last) for out in self.outs])


def go_abreast(
    mates: Sequence[Mate],
    slices: Slices,
    now: Floats,
    frames: int,
    outs: Sequence[Recording],
    stop: bool,
    asked: Asked,
) -> list[Moved]:
    """Move up to WIDTH equal ropes by so many frames; PAUSED where it was asked to stop."""
    falls: dict[int, Moved] = {}
    (begun, unfinished), good = now[4:].copy(), 0  # of the call for all islands

    def call(
        steps: int, count: int, found: Recording, halt: bool, edges: Edges
    ) -> tuple[int, int, int]:
        nonlocal good
        now[3:] = steps, begun or edges[0], unfinished or edges[1]
        going = [k for k in range(len(mates)) if k not in falls]
        buffers: Outs = found  # type: ignore[assignment]
        room = [buffers.outs[k] for k in going]
        for k, moved in zip(
            going, _call([mates[k] for k in going], now, count, room, halt), strict=True
        ):
            if moved.status != OK:
                falls[k] = moved._replace(good=good + moved.good)
        now[2] += steps * count
        good += 0 if edges[1] else count
        status = BROKEN if len(falls) == len(mates) else OK
        return status, count, steps * count

    slices.asked = asked
    together: Recording = Outs(outs)  # type: ignore[assignment]
    status, reached = slices.run(call, lambda: lambda: None, int(now[3]), frames, together, stop)
    rest = Moved(PAUSED if status == OK and reached < frames else OK, reached, 0)
    return [falls.get(k, rest) for k in range(len(mates))]


def _call(
    mates: Sequence[Mate], now: Floats, frames: int, outs: Sequence[Recording], stop: bool
) -> list[Moved]:
    """Call the kernel once; `now` is that of `Engine.call`, and left as it is."""
    if not hasattr(_here, "beside"):
        _here.beside = make_beside()
    beside, engine, count = _here.beside, mates[0].engine, len(mates)
    recordings, size = list[tuple[Kept, int]](), 0
    for mate, out in zip(mates, outs, strict=True):
        recordings.append(mate.keep(out, size))
        size = len(recordings[-1][0].words)
    marks = {(*mate.types, out.mark) for mate, (out, _) in zip(mates, recordings, strict=True)}
    if len(marks) > 1:
        raise RuntimeError("ropes side by side are not of one kind")
    places = [(*mate.addresses, at) for mate, (_, at) in zip(mates, recordings, strict=True)]
    ropes = np.array(places + places[:1] * (WIDTH - count)).T.copy()
    like = *mates[0].kept(), recordings[0][0]
    args = *(one.value for one in like), ropes, count, beside, now, frames, engine.ledger, stop
    advance_beside(*args, engine.tableau)
    moved = []
    for w, mate in enumerate(mates):
        status, good, done = map(int, beside.ends[:, w])
        clock = now.copy()
        clock[2] = done
        moved.append(mate.engine.moved(status, good, int(now[3]) * good, clock))
    return moved
