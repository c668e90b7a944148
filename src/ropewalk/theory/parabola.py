"""The parabola: a shallow cable under a load that is even along its chord.

With the chord D at the slope beta and the tension T along it, a cable sags w D^2/(8 T) below its chord
and is longer than it by (w cos(beta))^2 D^3/(24 T^2), which its unstretched length and its stretch
provide:
    D + (w cos(beta))^2 D^3/(24 T^2) = L (1 + T/EA)
a cubic for T with one positive root. Its error is of the order (sag/D)^2.
Source: Irvine, Cable Structures (1981), sec. 2.2 and 2.3.
"""

from __future__ import annotations

import math
from dataclasses import dataclass

import numpy as np
from numpy.typing import ArrayLike, NDArray

from ropewalk.theory.given import need, need_ends, need_stiff
from ropewalk.words.annotations import unquoted

Floats = NDArray[np.float64]


@unquoted
@dataclass(frozen=True)
class Parabola:
    """A shallow cable between two points."""

    length: float  # unstretched [m]
    across: float  # horizontal distance of the ends [m]
    rise: float  # how much higher the second end is [m]
    weight: float  # per unstretched length [N/m]
    EA: float  # [N]
    chord_tension: float  # T, along the chord, at the middle [N]

    @property
    def horizontal(self) -> float:
        """Horizontal part H of the tension [N]."""
        return self.chord_tension * self.across / math.hypot(self.across, self.rise)

    @property
    def sag(self) -> float:
        """Drop of the middle below the chord, along gravity [m]."""
        return self.weight * (self.across**2 + self.rise**2) / (8.0 * self.chord_tension)

    def height(self, x: ArrayLike) -> Floats:
        """Return z over the first end at horizontal places x [m], (m,), the shape of x."""
        share = np.asarray(x, dtype=np.float64) / self.across
        return np.asarray(share * self.rise - 4.0 * self.sag * share * (1.0 - share))

    def tension(self, x: ArrayLike) -> Floats:
        """Return the tension at horizontal places x [m]: H over the cosine of the slope [N], (m,) as x."""
        share = np.asarray(x, dtype=np.float64) / self.across
        slope = (self.rise - 4.0 * self.sag * (1.0 - 2.0 * share)) / self.across
        return np.asarray(self.horizontal * np.hypot(1.0, slope))


def parabola(
    length: float, across: float, rise: float = 0.0, weight: float = 1.0, EA: float = math.inf
) -> Parabola:
    """Return the parabola of a shallow cable between two points.

    Args:
        length: unstretched [m]; with EA = inf more than the distance of the ends.
        across: horizontal distance of the ends [m], not 0.
        rise: how much higher the second end is [m].
        weight: per unstretched length [N/m].
        EA: axial stiffness [N].

    Raises ValueError for an inextensible cable that does not reach, for ends one above the other, and
    for numbers that are not positive and finite.

    Source: Irvine, Cable Structures (1981), sec. 2.2 and 2.3.
    """
    need("length", length, "m")
    need("weight", weight, "N/m")
    need("across", across, "m")
    need_ends(across, rise)
    need_stiff(EA)
    distance = math.hypot(across, rise)
    load = (weight * across) ** 2 * distance / 24.0
    slack = length - distance
    if math.isinf(EA):
        if slack <= 0.0:
            raise ValueError(
                f"length: {length:g} m - must be more than the distance of the ends, "
                f"{distance:g} m: an inextensible cable is not stretched"
            )
        return Parabola(length, across, rise, weight, EA, math.sqrt(load / slack))
    return Parabola(length, across, rise, weight, EA, _root(length / EA, slack, load))


def _root(cubic: float, square: float, load: float) -> float:
    """Return the positive root of cubic T^3 + square T^2 = load, to rounding."""
    T: float = (load / cubic) ** (1.0 / 3.0)
    if square > 0.0:
        T = min(T, math.sqrt(load / square))
    else:
        T = max(T, -square / cubic)
        T += (load / cubic) ** (1.0 / 3.0)
    for _ in range(100):
        value = (cubic * T + square) * T - load / T
        change = value / (2.0 * cubic * T + square + load / T**2)
        T -= change
        if abs(change) <= 1e-16 * T:
            break
    return T
