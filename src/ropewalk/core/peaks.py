"""What every step is looked at for: the greatest and least since an interval between two frames began."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from ropewalk.core.jit import small

Floats = NDArray[np.float64]

EXTREMES = (
    *("greatest tension", "least tension", "greatest stretch", "greatest speed"),
    *("highest point", "lowest point", "greatest anchor force", "greatest clamp moment"),
)
TENSION, LEAST_TENSION, STRETCH, SPEED, HIGHEST, LOWEST, FORCE, MOMENT = range(8)
# Rows of `Peaks.found`: the value, its segment, node or anchor, and when [s]: after the one, until the other.
VALUE, PLACE, SINCE, UNTIL = range(4)
BOUNDS = ("least", "greatest")  # rows of `Peaks.error`
LEAST, GREATEST = range(2)
# Columns of `Peaks.pressed`: the square of the greatest force on a surface [N^2], when [s], and the least
# square in the steps before that, WITHIN of them; then the last look [s] and the squares of the last steps.
SQUARE, WHEN, BEFORE, LOOKED, STEPS = range(5)
WITHIN = 3


class Peaks(NamedTuple):
    """The greatest and least of an interval; infinite where nothing was seen. All empty where not wanted."""

    tension_high: Floats  # (s,) [N]
    tension_low: Floats  # (s,)
    square_high: Floats  # (s,) square of the length [m^2], of methods that leave the law for later
    square_low: Floats  # (s,)
    stretch: Floats  # (s,) greatest length over rest length [1]
    speed: Floats  # (n,) square of the greatest speed [m^2/s^2]
    high: Floats  # (n,) greatest height along up [m]
    low: Floats  # (n,) least
    reaction: Floats  # (a,) square of the greatest force [N^2]
    moment: Floats  # (a,) the same of clamps [N^2 m^2]; (0,) where none is clamped
    found: Floats  # (4, 8) the best of all ropes, by EXTREMES; as of yet unrooted where a square is kept
    looked: Floats  # (1,) time of the last look for them [s]
    error: (
        Floats  # (2, 2) least and greatest energy error [J], and when [s]; without a ledger unseen
    )
    error_zero: Floats  # (1,) energy from which errors count [J]; NaN without a ledger
    pressed: Floats  # (b, 7) of all surfaces but ropes, see `Layout.surfaces` and SQUARE


_HIGH, _LOW = -np.inf, np.inf  # what every number lies beyond
START = (_HIGH, _LOW, _HIGH, _LOW, _HIGH, _HIGH, _HIGH, _LOW, _HIGH, _HIGH)


def no_peaks(segments: int, nodes: int, anchors: int, surfaces: int = 0) -> Peaks:
    """Return the extremes of no step at all, without clamps; of no segments and nodes: nothing is wanted."""
    sizes = (*(segments,) * 5, *(nodes,) * 3, anchors, 0)
    rows = [np.full(size, start) for size, start in zip(sizes, START, strict=True)]
    more = ((4, len(EXTREMES)), (1,), (2, 2) if nodes else (0, 2), (1,))
    rows += [np.full(shape, np.nan) for shape in more]
    rows.append(np.tile([_HIGH, *[np.nan] * (STEPS - 1 + WITHIN)], (surfaces, 1)))
    return Peaks(*rows)


def root_of(squares: Floats) -> Floats:
    """Return the roots of greatest squares, no numbers where none was seen."""
    found: Floats = np.sqrt(np.where(squares >= 0.0, squares, np.nan))
    return found


# `+ 0.0` keeps LLVM from writing a maximum as a masked store, which takes three times as long.


@small
def greater(new, kept):
    """Return the greater one; `kept` where `new` is no number."""
    return (new if new > kept else kept) + 0.0


@small
def lesser(new, kept):
    """Return the lesser one; `kept` where `new` is no number."""
    return (new if new < kept else kept) + 0.0
