"""Curves of tension against strain as tables for the kernels."""

from __future__ import annotations

from collections.abc import Iterator
from itertools import pairwise

import numpy as np

from ropewalk.core.arrays import Curves, Floats, Ints, State, System
from ropewalk.lowering.layout import Layout
from ropewalk.scene import Rope, Springs
from ropewalk.theory.curve import at_strain, at_tension, is_straight, slope_range


def curve_of(rope: Rope) -> Floats | None:
    """Return the pieces of a rope's curve, (p, 5); None where a straight line, which is EA, will do."""
    if isinstance(rope.made_of, Springs) or rope.made_of.curve is None:
        return None
    pieces = rope.made_of.curve.pieces
    return None if is_straight(pieces) else pieces


def curve_tables(layout: Layout, curves: tuple[Floats | None, ...]) -> Curves:
    """Return the tables of the curves of all ropes, over their largest slopes; on a drum, too."""
    of = np.full(layout.segments, -1)
    first, pieces = [0], [np.zeros((0, 5))]
    least: list[float] = []
    for curve, span in zip(curves, layout.ropes, strict=True):
        if curve is None:
            continue
        low, high = slope_range(curve)
        of[span.first : span.last] = len(least)
        pieces.append(curve / np.array([1.0, high, high, high, high]))
        first.append(first[-1] + len(curve))
        least.append(low / high)
    table = np.ascontiguousarray(np.concatenate(pieces))
    return Curves(of.astype(np.int64), np.array(first, np.int64), table, np.array(least))


def put_under_tension(
    system: System, state: State, tension: Floats, stretch: Floats, soft: Floats
) -> None:
    """Write stretch [m] and compliance [m/N] of segments with a curve under tensions [N], (s,) each."""
    for k, pieces, mine in _each(system.curves, state):
        strain, slope = at_tension(pieces, tension[mine] / k)
        stretch[mine] = strain * state.rest_length[mine]
        soft[mine] = 1.0 / (state.stiffness[mine] * slope)


def put_tension(system: System, state: State, stretch: Floats, tension: Floats) -> None:
    """Write the tension [N] of segments with a curve at stretches [m], (s,) each, pressed ones too."""
    for k, pieces, mine in _each(system.curves, state):
        tension[mine] = k * at_strain(pieces, stretch[mine] / state.rest_length[mine])[0]


def _each(curves: Curves, state: State) -> Iterator[tuple[Floats, Floats, Ints]]:
    """Yield for every curve EA [N] of its segments, its pieces and its live segments."""
    for which, (first, last) in enumerate(pairwise(curves.first)):
        mine = np.flatnonzero((curves.of == which) & (state.stiffness > 0.0))
        yield state.stiffness[mine] * state.rest_length[mine], curves.piece[first:last], mine


def softest(curves: Curves, stiffness: Floats) -> Floats:
    """Return the least slope of every segment's tension by its length [N/m], (s,), from the largest."""
    if not curves.least.size:
        return stiffness
    return np.where(curves.of >= 0, curves.least[curves.of], 1.0) * stiffness
