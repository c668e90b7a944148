"""Ropes with a curve of tension against strain, in the quadratic pieces of `theory.curve`, over EA."""

from __future__ import annotations

import math
from itertools import pairwise
from typing import Any, NamedTuple

import numpy as np

from ropewalk.core.arrays import Floats, Ints
from ropewalk.core.jit import part, small
from ropewalk.laws.elastic_law import ElasticLaw
from ropewalk.theory.curve import is_straight, slope_range

START, TENSION, SLOPE, BEND, ENERGY = range(5)  # columns of `Curve.piece`


class Curve(NamedTuple):
    """Curves, and which of them every segment has."""

    which: Ints  # (s,) -1: none
    first: Ints  # (c + 1,) where the pieces of a curve begin
    piece: Floats  # (p, 5) strain, tension, slope, bend and energy per length [1]


@small
def find(piece, first, last, strain):
    """Return the last of the rows `first` to `last - 1` that begins at `strain` or before; else the first."""
    low, high = first, last - 1
    while low < high:
        middle = (low + high + 1) // 2
        if piece[middle, START] <= strain:
            low = middle
        else:
            high = middle - 1
    return low


@small
def at_strain(piece, first, which, strain):
    """Return tension, slope and energy per length, over EA [1]."""
    row = find(piece, first[which], first[which + 1], strain)
    d, T, s, q = (
        strain - piece[row, START],
        piece[row, TENSION],
        piece[row, SLOPE],
        piece[row, BEND],
    )
    return (
        T + d * (s + q * d),
        s + 2.0 * q * d,
        piece[row, ENERGY] + d * (T + d * (0.5 * s + d * q / 3.0)),
    )


@small
def at_tension(piece, first, which, tension, beside):
    """Return strain and slope of a tension over EA [1], of the curve and a straight line `beside` it."""
    low, high = first[which], first[which + 1] - 1
    while low < high:
        middle = (low + high + 1) // 2
        if piece[middle, TENSION] + beside * piece[middle, START] <= tension:
            low = middle
        else:
            high = middle - 1
    row = low
    rise = tension - (piece[row, TENSION] + beside * piece[row, START])
    s = piece[row, SLOPE] + beside
    root = math.sqrt(max(s * s + 4.0 * piece[row, BEND] * rise, 0.0))
    return piece[row, START] + 2.0 * rise / (s + root), root


@part
def pull(curve, j, strain, inner, c):
    """See `ElasticLaw.pull`."""
    return at_strain(curve.piece, curve.first, curve.which[j], strain)


@part
def strain(curve, j, pull, inner, c):
    """See `ElasticLaw.strain`."""
    return at_tension(curve.piece, curve.first, curve.which[j], pull, 0.0)


def pieces_of(rope: Any) -> Floats | None:
    """Return the pieces of a rope's curve [N], (p, 5); None where a straight line, which is EA, will do."""
    if not rope.curved or is_straight(rope.made_of.curve.pieces):
        return None
    pieces: Floats = rope.made_of.curve.pieces
    return pieces


def says(rope: Any) -> Floats | None:
    """Return the pieces of a rope whose tension is its curve alone."""
    return None if rope.relaxes else pieces_of(rope)


def put_together(curves: tuple[tuple[Floats, float] | None, ...], layout: Any) -> Curve:
    """Return the tables of ropes' pieces [N] and of what their largest slopes have besides [N].

    All over the largest; on a drum, too.
    """
    which = np.full(layout.segments, -1, np.int64)
    first, pieces = [0], [np.zeros((0, 5))]
    for curve, span in zip(curves, layout.ropes, strict=True):
        if curve is None:
            continue
        high = slope_range(curve[0])[1] + curve[1]
        which[span.first : span.last] = len(first) - 1
        pieces.append(curve[0] / np.array([1.0, high, high, high, high]))
        first.append(first[-1] + len(curve[0]))
    table = np.ascontiguousarray(np.concatenate(pieces))
    return Curve(which, np.array(first, np.int64), table)


def least(curve: Any) -> Floats:
    """Return the least slope over the largest, (s,) [1]; 1 where there is no curve."""
    slopes = [curve.piece[first:last, SLOPE].min() for first, last in pairwise(curve.first)]
    return of_each(curve.which, np.array(slopes), 1.0)


def of_each(which: Ints, values: Floats, other: float) -> Floats:
    """Return each segment's own of `values`, (s,); `other` where it has none."""
    return np.append(values, other)[which]


CURVE = ElasticLaw(
    name="curve",
    says=says,
    lower=lambda said, layout: put_together(
        tuple(None if one is None else (one, 0.0) for one in said), layout
    ),
    pull=pull,
    strain=strain,
    least=least,
)
