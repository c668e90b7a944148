"""Tension against strain as a smooth rising curve of quadratic pieces.

    T = T0 + s d + q d^2,   dT/de = s + 2 q d,   energy per length U = U0 + T0 d + s d^2/2 + q d^3/3

d the strain e beyond where a piece begins. Tension and slope have no jump; force, tangent, energy and the
strain of a tension are closed forms. Between two points with slopes a and b and the secant D a knot is put
in, where the slope is 2 D - w a - (1 - w) b, w the knot's share of the way: in the middle, or where the
slope goes from a to b without going beyond them. Slopes at the points are those of the parabola through
three of them, held below `_STEEP` times the lesser secant, so that the curve rises everywhere: nowhere by
less than half the least secant, nor by more than twice the largest. Points of a quadratic give that
quadratic. A compressed rope and one beyond the last point go on straight.
Source: Schumaker, SIAM J. Numer. Anal. 20 (1983) 853; for the limits Fritsch and Carlson,
ibid. 17 (1980) 238.
"""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

if TYPE_CHECKING:
    from ropewalk.core.arrays import Floats


_STEEP = 1.5  # [1] slope at a point over the lesser secant beside it, at most
_ENDS = 2.0 / 3.0, 4.0 / 3.0  # [1] slope at the first and last point over the secant there
_ROOM = 0.2, 0.8  # shares of the way within which a knot lies: no slope changes in a moment [1]
STRAIN, TENSION, SLOPE, BEND, ENERGY = range(5)  # columns of pieces


def slopes_of(strain: Floats, tension: Floats) -> Floats:
    """Return slopes at the points of a table [N], (m,), from strains [1] and tensions [N] that rise, (m,)."""
    h, secant = np.diff(strain), np.diff(tension) / np.diff(strain)
    found = np.empty_like(strain)
    if secant.size == 1:
        found[:] = secant[0]
        return found
    parabola = (h[1:] * secant[:-1] + h[:-1] * secant[1:]) / (h[1:] + h[:-1])
    found[1:-1] = np.minimum(parabola, _STEEP * np.minimum(secant[:-1], secant[1:]))
    for end, beside, D in ((0, 1, secant[0]), (-1, -2, secant[-1])):
        found[end] = np.clip(2.0 * D - found[beside], _ENDS[0] * D, _ENDS[1] * D)
    return found


def pieces_of(strain: Floats, tension: Floats, slope: Floats | None = None) -> Floats:
    """Return the pieces of the curve through points, (p, 5): strain, T0 [N], s [N], q [N] and U0 [J/m].

    The first one is for compression, the last one for what lies beyond the last point.

    Args:
        strain: of the points [1], rising from 0, (m,).
        tension: [N], rising from 0, (m,).
        slope: at the points [N], (m,); by default `slopes_of` these.

    Raises ValueError for points that do not rise from zero.
    """
    strain, tension = np.asarray(strain, float), np.asarray(tension, float)
    if strain.size < 2 or strain[0] != 0.0 or tension[0] != 0.0:
        raise ValueError("strain, tension: must have two points or more, the first one 0 and 0")
    if not (np.all(np.diff(strain) > 0.0) and np.all(np.diff(tension) > 0.0)):
        raise ValueError("strain, tension: must rise from point to point")
    slope = slopes_of(strain, tension) if slope is None else np.asarray(slope, float)
    rows = [[0.0, 0.0, slope[0], 0.0, 0.0]]
    energy = 0.0
    for i in range(strain.size - 1):
        h = strain[i + 1] - strain[i]
        a, b, D = slope[i], slope[i + 1], (tension[i + 1] - tension[i]) / h
        share = _knot(a, b, D)
        at, middle = share * h, 2.0 * D - share * a - (1.0 - share) * b
        q = 0.5 * (middle - a) / at
        rows.append([strain[i], tension[i], a, q, energy])
        energy += at * (tension[i] + at * (0.5 * a + at * q / 3.0))
        T, rest = tension[i] + at * (a + q * at), h - at
        q = 0.5 * (b - middle) / rest
        rows.append([strain[i] + at, T, middle, q, energy])
        energy += rest * (T + rest * (0.5 * middle + rest * q / 3.0))
    rows.append([strain[-1], tension[-1], slope[-1], 0.0, energy])
    return np.array(rows)


def _knot(a: float, b: float, D: float) -> float:
    """Return the share of the way at which the knot between two points lies [1]."""
    middle = 2.0 * D - 0.5 * (a + b)
    if (a - D) * (b - D) >= 0.0 or min(a, b) <= middle <= max(a, b):
        return 0.5
    share = 2.0 * (D - b) / (a - b)  # the slope at the knot is b
    beyond_b = (middle > max(a, b)) == (b > a)
    return float(np.clip(share if beyond_b else share - 1.0, *_ROOM))


def at_strain(pieces: Floats, strain: Floats) -> tuple[Floats, Floats, Floats]:
    """Return tension [N], slope [N] and energy per length [J/m] at strains [1], arrays of one shape."""
    strain = np.asarray(strain, float)
    row = np.maximum(np.searchsorted(pieces[:, STRAIN], strain, side="right") - 1, 0)
    row = np.where(strain < 0.0, 0, row)
    start, T, s, q, energy = np.moveaxis(pieces[row], -1, 0)
    d = strain - start
    tension = T + d * (s + q * d)
    return tension, s + 2.0 * q * d, energy + d * (T + d * (0.5 * s + d * q / 3.0))


def at_tension(pieces: Floats, tension: Floats) -> tuple[Floats, Floats]:
    """Return strain [1] and slope [N] at tensions [N], arrays of one shape."""
    tension = np.asarray(tension, float)
    row = np.maximum(np.searchsorted(pieces[:, TENSION], tension, side="right") - 1, 0)
    row = np.where(tension < 0.0, 0, row)
    start, T, s, q, _ = np.moveaxis(pieces[row], -1, 0)
    rise = tension - T
    root = np.sqrt(np.maximum(s * s + 4.0 * q * rise, 0.0))
    return start + 2.0 * rise / (s + root), root


def is_straight(pieces: Floats) -> bool:
    """Tell whether a curve is a straight line, within rounding."""
    least, largest = slope_range(pieces)
    return largest - least <= 1e-12 * largest


def slope_range(pieces: Floats) -> tuple[float, float]:
    """Return least and largest slope of a curve [N]: both are at the ends of pieces."""
    return float(pieces[:, SLOPE].min()), float(pieces[:, SLOPE].max())


def steepest_chord(pieces: Floats, tension: float) -> float:
    """Return the largest slope [N] of a chord from a tension [N] down to a lower one of 0 or more.

    A tension that falls runs along a rope as a shock where the curve softens, by the chord's slope, and
    spreads where it stiffens, with the slope there at its head: its news is no faster than either. Taken of
    a thousand strains.
    """
    strain, slope = (float(one) for one in at_tension(pieces, np.array(tension)))
    below = np.concatenate([np.linspace(0.0, strain, 1000), pieces[1:, STRAIN]])
    below = below[below < strain * (1.0 - 1e-9)]
    chords = (tension - at_strain(pieces, below)[0]) / (strain - below)
    return max(slope, float(chords.max()))
