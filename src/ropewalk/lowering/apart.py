"""What anchors do to the rope between them by their motions alone, which are known beforehand."""

from __future__ import annotations

import itertools
import math
from typing import NamedTuple

import numpy as np

from ropewalk.core.arrays import Floats, State, System
from ropewalk.laws.anchors import anchor_places


class Span(NamedTuple):
    """Two anchors that are neighbours on a rope for some time."""

    rows: tuple[int, int]
    first: int  # node
    last: int
    length: float  # of rope between them, unstretched [m]
    end: float  # [s] when the first of the two lets go


def spans(system: System, state: State) -> list[Span]:
    """Return the pairs of anchors with rope between them: neighbours, and those that stay when others let go.

    Without what a winch winds, whose length changes.
    """
    release = system.anchors.release
    order = [int(row) for row in np.argsort(state.anchor_node, kind="stable")]
    kept = [row for row in order if release[row] == math.inf]
    found = []
    for one, other in sorted({*itertools.pairwise(order), *itertools.pairwise(kept)}):
        first, last = int(state.anchor_node[one]), int(state.anchor_node[other])
        length, live = state.rest_length[first:last], state.stiffness[first:last] > 0.0
        wound = {one, other} & {int(row) for row in system.winches.anchor}
        end = float(min(release[one], release[other]))
        if first < last and live.all() and length.sum() > 0.0 and not wound and end > 0.0:
            found.append(Span((one, other), first, last, float(length.sum()), end))
    return found


def stretch_of(system: System, state: State, span: Span, times: Floats) -> Floats:
    """Return how far apart two anchors are at times [s], over the length of rope between them, (t,) [1]."""
    one, other = (_places(system, state, row, times) for row in span.rows)
    return np.asarray(np.linalg.norm(other - one, axis=1) / span.length)


def recoil_of_releases(system: System, state: State) -> float:
    """Return the speed at which stretched ropes fly back when anchors let go [m/s]; see `chains.recoil`."""
    found = 0.0
    for span in spans(system, state):
        if span.end < math.inf:
            stretch = float(stretch_of(system, state, span, np.array([span.end]))[0])
            found = max(found, 2.0 * max(stretch - 1.0, 0.0) * wave_speed(state, span))
    return found


def wave_speed(state: State, span: Span) -> float:
    """Return the fastest speed of waves along the rope between two anchors [m/s], by its lighter nodes."""
    segments = slice(span.first, span.last)
    inverse = state.inverse_mass[span.first : span.last + 1]
    lightest = np.maximum(inverse[:-1], inverse[1:])
    soft = np.where(np.isfinite(state.stiffness[segments]), state.stiffness[segments], 0.0)
    return float((state.rest_length[segments] * np.sqrt(soft * lightest)).max())


def _places(system: System, state: State, row: int, times: Floats) -> Floats:
    """Return where an anchor is at these times, (t, 3) [m]."""
    places, last = np.zeros((len(times), 3)), np.zeros((2, 3))
    anchor_places(system, state, row, times, *last, places)
    return places
