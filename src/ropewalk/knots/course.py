"""A curve through points with straight ends, and points on it that are equally far apart."""

from __future__ import annotations

import math
from bisect import bisect_left
from functools import cached_property
from itertools import pairwise
from typing import TYPE_CHECKING

import numpy as np

from ropewalk.theory.borrowed import load_scipy

if TYPE_CHECKING:
    from ropewalk.core.arrays import Floats

_SAMPLES = 16  # per span between two of the points, for lengths and bends


def unit(vector: Floats) -> Floats:
    """Return a vector at length one."""
    found: Floats = vector / np.linalg.norm(vector)
    return found


class Curve:
    """A cubic spline through points [m], (m, 3), that goes on straight for ever at both ends.

    It has a continuous tangent everywhere, and a continuous bend between its first and its last point.
    """

    def __init__(self, points: Floats, first: Floats, last: Floats) -> None:
        """Take the points [m], (m, 3), and the directions in which it goes at both ends."""
        load_scipy("interpolate")
        from scipy.interpolate import CubicSpline

        self._first, self._last = unit(np.asarray(first, float)), unit(np.asarray(last, float))
        knots = np.concatenate([[0.0], np.cumsum(np.linalg.norm(np.diff(points, axis=0), axis=1))])
        ends = ((1, self._first), (1, self._last))
        self._spline = CubicSpline(knots, points, bc_type=ends)
        self._slope = self._spline.derivative()
        # the same for one place at a time: numbers of Python, of which scipy would make arrays
        self._starts: list[float] = knots.tolist()
        self._pieces: list[list[list[float]]] = self._spline.c.transpose(1, 2, 0).tolist()
        # arc length by Gauss's rule on every piece between samples
        self._at = np.concatenate(
            [np.linspace(a, b, _SAMPLES, endpoint=False) for a, b in pairwise(knots)] + [knots[-1:]]
        )
        nodes, weights = np.polynomial.legendre.leggauss(6)
        half = 0.5 * np.diff(self._at)
        middle = 0.5 * (self._at[:-1] + self._at[1:])
        speed = np.linalg.norm(self._slope(middle[:, None] + half[:, None] * nodes), axis=2)
        arc = np.concatenate([[0.0], np.cumsum(half * (speed @ weights))])
        self._arc: list[float] = arc.tolist()
        self._parameter: list[float] = self._at.tolist()

    @property
    def length(self) -> float:
        """Length between the straight ends [m]."""
        return self._arc[-1]

    @cached_property
    def least_radius(self) -> float:
        """Least radius to which it is bent [m]."""
        slope, bend = self._slope(self._at), self._spline(self._at, 2)
        size = np.linalg.norm(np.cross(slope, bend), axis=1)
        speed = np.linalg.norm(slope, axis=1)
        return float(np.min(speed**3 / np.maximum(size, 1e-300)))

    def at(self, s: float) -> Floats:
        """Return the place at an arc length [m] from its first point on, (3,); on a straight end outside."""
        if s <= 0.0:
            return np.asarray(self._place(0.0) + s * self._first)
        if s >= self.length:
            return np.asarray(self._place(self.length) + (s - self.length) * self._last)
        return np.array(self._place(s))

    def _place(self, s: float) -> tuple[float, ...]:
        """Return the place at an arc length [m] on the curve itself, (3,)."""
        k = min(max(bisect_left(self._arc, s) - 1, 0), len(self._arc) - 2)
        low, high = self._parameter[k], self._parameter[k + 1]
        u = low + (high - low) * (s - self._arc[k]) / (self._arc[k + 1] - self._arc[k])
        piece = k // _SAMPLES
        u -= self._starts[piece]
        return tuple([((a * u + b) * u + c) * u + d for a, b, c, d in self._pieces[piece]])

    def chain(
        self, segments: int, length: float, first_end: float | None = None, more: float = 0.0
    ) -> Floats:
        """Return the nodes of a chain of equal straight segments along the curve [m], (segments + 1, 3).

        Args:
            segments: how many [1].
            length: of the chain [m], all segments together.
            first_end: what of it lies before the curve's first point [m]; by default as much as
                after its last one, and `more`.
            more: by which both parts differ from their mean [m].
        """
        one = length / segments
        if first_end is not None:
            return self._walk(-first_end, segments, one)[0]
        start = -0.5 * (length - self.length)
        _, end = self._walk(start, segments, one)  # chords cut corners: it ends a little later
        return self._walk(start - 0.5 * (end - self.length + start) - more, segments, one)[0]

    def _walk(self, start: float, segments: int, one: float) -> tuple[Floats, float]:
        """Return nodes that are `one` apart, from an arc length on, and the arc length of the last."""
        places, s = np.empty((segments + 1, 3)), start
        places[0] = self.at(s)
        for i in range(segments):
            here, s = s, s + one
            if here < 0.0 < s or 0.0 <= here < self.length:
                s = self._next(places[i], here, one)
            places[i + 1] = self.at(s)
            step = places[i + 1] - places[i]
            places[i + 1] = places[i] + one * unit(step)  # to the last bit
        return places, s

    def _next(self, place: Floats, here: float, one: float) -> float:
        """Return the first arc length after `here` at which the curve is `one` from a place on it."""
        load_scipy("optimize")
        from scipy.optimize import brentq

        low, high = here, here + one

        start = tuple(place.tolist())

        def beyond(s: float) -> float:
            there = self._place(s) if 0.0 < s < self.length else self.at(s)
            return math.dist(there, start) - one

        while beyond(high) < 0.0:
            low, high = high, high + 0.1 * one
        return high if beyond(low) >= 0.0 else float(brentq(beyond, low, high, xtol=1e-14 * one))
