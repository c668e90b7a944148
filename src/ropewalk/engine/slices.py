"""Long calls of a kernel in slices by the clock on the wall: in between, the host hears Ctrl-C.

A kernel never looks at signals, and Python's handlers run in no other thread than the one that waits for it.
So no call may last long. Where a call ends changes no bit: a kernel takes step after step, by their numbers.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator
from contextlib import contextmanager

from ropewalk.core.deferred import clock
from ropewalk.core.status import OK, PAUSED
from ropewalk.methods.recording import Recording

SLICE = 0.05  # [s] about so long a kernel runs without returning
NODE_STEP = 4e-9  # [s] rough cost of one node, step and evaluation of the forces
GROWTH = 4.0  # [1] a slice has at most so many times the steps of the one before

#: Whether the first frame of a call is begun already, and whether its last one is not ended.
Edges = tuple[bool, bool]
#: Takes steps per frame, frames, buffers, whether a break ends it, and edges.
#: Returns status, good frames and steps.
Call = Callable[[int, int, Recording, bool, Edges], tuple[int, int, int]]
#: Returns what brings back the present state.
Keep = Callable[[], Callable[[], None]]


class Slices:
    """How many steps a kernel may take in one call, by what the last ones cost."""

    def __init__(
        self,
        nodes: int,
        cost: float,
        fixed: bool = True,
        clock: Callable[[], float] = clock,
        span: float = SLICE,
    ) -> None:
        """Begin with a guess for steps of so many nodes; `cost` of a step in force evaluations.

        Without `fixed` steps the calls bound themselves to `most` steps. A call takes about `span` [s].
        """
        self._span = span
        self.most = max(1, int(span / (NODE_STEP * max(cost, 1.0) * max(nodes, 1))))
        self.asked: Callable[[], bool] | None = None  # whether to stop at the last whole frame
        self._fixed, self._clock = fixed, clock

    def run(
        self, call: Call, keep: Keep, steps: int, frames: int, out: Recording, stop: bool
    ) -> tuple[int, int]:
        """Advance frames of so many steps each; return the status and the number of good frames.

        Fewer than `frames` with status OK: `asked` said so.
        """
        good, begun = 0, False
        while True:
            left = frames - good
            count = _even(left, self.most // steps) if self._fixed else left
            if count > 0 or left == 0:
                room, edges = out.part(good, good + count), (begun, False)
                status, done = self._timed(call, steps, count, room, stop, edges)
            else:
                status, done = self._cut_frame(call, keep, steps, out.part(good, good + 1), stop)
            good += done
            begun = status == PAUSED
            if status not in (OK, PAUSED) or good >= frames:
                return status, good
            if self.is_asked():
                return OK, good

    def holds(self, steps: int) -> bool:
        """Tell whether a call may have so many steps, of one length."""
        return self._fixed and steps <= self.most

    def _cut_frame(
        self, call: Call, keep: Keep, steps: int, out: Recording, stop: bool
    ) -> tuple[int, int]:
        """Advance by one frame in several calls; whether it is broken is told at its end, as ever."""
        nothing = out.part(0, 0)
        back = keep() if self.asked is not None else None
        begun = False
        while steps > self.most:
            taken = self.most
            status, done = self._timed(call, taken, 1, nothing, False, (begun, True))
            if status != OK:
                return status, 0
            begun = True
            steps -= taken
            if back is not None and (done == 0 or self.is_asked()):
                back()
                return OK, 0
        status, done = self._timed(call, steps, 1, out, stop, (begun, False))
        if back is not None and status == OK and done == 0:  # asked to stop within the call
            back()
        return status, done

    def _timed(
        self, call: Call, steps: int, frames: int, out: Recording, stop: bool, edges: Edges
    ) -> tuple[int, int]:
        begun = self._clock()
        status, good, taken = call(steps, frames, out, stop, edges)
        self.note(taken, self._clock() - begun)
        return status, good

    @contextmanager
    def unasked(self) -> Iterator[None]:
        """Ask nobody whether to stop."""
        asked, self.asked = self.asked, None
        try:
            yield
        finally:
            self.asked = asked

    def is_asked(self) -> bool:
        """Tell whether to stop at the last whole frame."""
        return self.asked is not None and self.asked()

    def note(self, steps: int, seconds: float) -> None:
        """Take up that so many steps have taken so long [s]."""
        if steps > 0:
            wish = self._span * steps / max(seconds, 1e-9)
            self.most = max(1, int(min(wish, GROWTH * max(self.most, steps))))


def _even(left: int, most: int) -> int:
    """Return how many of the frames that are left go into the next call, where it may have `most`.

    All calls are about as long: of a short one at the end too little would be learned, and the buffers of
    islands have room for as many frames as before.
    """
    return -(-left // -(-left // most)) if 0 < most < left else min(most, left)
