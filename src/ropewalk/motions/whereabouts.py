"""Where an anchor or an obstacle is at a time: all motions, folded into one part as the laws of nodes are.

Places are absolute; `origin`, the first numbers of a row, is the start of the node, or of the body's middle.
"""

from __future__ import annotations

from typing import Any

from ropewalk.core.jit import kernel, part
from ropewalk.motions.kind import Motion
from ropewalk.motions.registry import HAND, MOTIONS


@part
def _at_origin(motions, row, t):
    p = motions.params[row]
    return p[0], p[1], p[2], 0.0, 0.0, 0.0


def _moving(motion: Motion, code: int, rest: Any) -> Any:
    place = motion.place

    @part
    def _whereabouts(motions, row, t):
        if motions.kind[row] == code:
            found = place(motions, row, t)
        else:
            found = rest(motions, row, t)
        return found

    return _whereabouts


def _folded() -> Any:
    found = _at_origin
    for code in reversed(range(len(MOTIONS))):
        if MOTIONS[code].place is not None:
            found = _moving(MOTIONS[code], code, found)
    return found


whereabouts = _folded()
"""whereabouts(motions, row, t): return the place [m] and the velocity [m/s] of what moves by `row` at time
`t` [s], six numbers. `motions` has the columns of `Motions`. A hand is where it began, at rest."""


@part
def place(anchors, row, t, x, v):
    """Write position and velocity of anchor `row` at time `t` [s]; a hand's place is left alone."""
    if anchors.kind[row] != HAND:
        x[0], x[1], x[2], v[0], v[1], v[2] = whereabouts(anchors, row, t)


@kernel
def place_now(motions, row, t):
    """Return what `whereabouts` does, for the host."""
    return whereabouts(motions, row, t)
