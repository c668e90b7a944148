"""Curves of tension against strain as tables for the kernels."""

from __future__ import annotations

import math
from collections.abc import Iterator
from itertools import pairwise
from typing import NamedTuple

import numpy as np

from ropewalk.core.arrays import Curves, Floats, Ints, State, System
from ropewalk.laws.curved import DAMPER
from ropewalk.lowering.layout import Layout
from ropewalk.scene import Rope, Springs
from ropewalk.theory.curve import at_strain, at_tension, is_straight, slope_range


class RopeCurve(NamedTuple):
    """A rope's tension at rest against its strain, and what relaxes beside it."""

    pieces: Floats  # (p, 5), see `theory.curve`
    relaxing_EA: float  # [N]
    time: float  # [s]


def curve_of(rope: Rope) -> RopeCurve | None:
    """Return a rope's curve; None where a straight line, which is EA, will do and nothing relaxes."""
    made_of = rope.made_of
    if isinstance(made_of, Springs) or not (rope.curved or rope.relaxes):
        return None
    if made_of.curve is not None and not is_straight(made_of.curve.pieces):
        pieces = made_of.curve.pieces
    else:
        pieces = np.array([[0.0, 0.0, made_of.EA, 0.0, 0.0]])
    if made_of.relaxing_EA is not None and made_of.relaxation_time is not None:
        return RopeCurve(pieces, made_of.relaxing_EA, made_of.relaxation_time)
    return None if is_straight(pieces) else RopeCurve(pieces, 0.0, math.inf)


def curve_tables(layout: Layout, curves: tuple[RopeCurve | None, ...]) -> Curves:
    """Return the tables of the curves of all ropes, over their largest stiffness; on a drum, too."""
    of = np.full(layout.segments, -1)
    first, pieces = [0], [np.zeros((0, 5))]
    least: list[float] = []
    arms: list[tuple[float, float]] = []
    for curve, span in zip(curves, layout.ropes, strict=True):
        if curve is None:
            continue
        low, high = slope_range(curve.pieces)
        high += curve.relaxing_EA
        of[span.first : span.last] = len(least)
        pieces.append(curve.pieces / np.array([1.0, high, high, high, high]))
        first.append(first[-1] + len(curve.pieces))
        least.append(low / high)
        arms.append((curve.relaxing_EA / high, curve.time))
    table, numbers = np.concatenate(pieces), np.array(arms).reshape(-1, 2).T.copy()
    of, starts = of.astype(np.int64), np.array(first, np.int64)
    return Curves(of, starts, np.ascontiguousarray(table), np.array(least), *numbers)


def let_relax(system: System, state: State) -> None:
    """Bring the arms of segments that relax to rest in the state's places: where the rope has long been."""
    if not state.arm.shape[1]:
        return
    stretch = np.sqrt((np.diff(state.x, axis=1) ** 2).sum(axis=0)) - state.rest_length
    state.arm[...] = 0.0
    for which in np.flatnonzero(system.curves.arm > 0.0):
        mine = np.flatnonzero((system.curves.of == which) & (state.stiffness > 0.0))
        strain = stretch[mine] / state.rest_length[mine]
        slack = system.slack_floor[mine] == 0.0
        state.arm[DAMPER, mine] = np.where(slack, np.maximum(strain, 0.0), strain)


def stored_at_rest(system: System, state: State, tension: Floats) -> float:
    """Return the elastic energy of all segments under tensions at rest [J], (s,) [N]."""
    k = state.stiffness
    stored = np.divide(tension**2, 2.0 * k, out=np.zeros_like(k), where=k > 0.0)
    for EA, pieces, mine in _each(system.curves, state):
        strain, _ = at_tension(pieces, tension[mine] / EA)
        stored[mine] = EA * state.rest_length[mine] * at_strain(pieces, strain)[2]
    return float(stored.sum())


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
