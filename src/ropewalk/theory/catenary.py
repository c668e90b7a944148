"""The inextensible catenary between two points.

    sqrt(L^2 - Y^2) = 2 a sinh(X / 2a),  H = w a,  lowest point X/2 - a atanh(Y/L) from the first end
Source: J. Bernoulli, Leibniz and Huygens 1691; Irvine, Cable Structures (1981), sec. 1.2.
"""

from __future__ import annotations

import math

from ropewalk.theory.cable import Cable
from ropewalk.theory.given import need, need_ends


def catenary(length: float, across: float, rise: float = 0.0, weight: float = 1.0) -> Cable:
    """Return the catenary of an inextensible cable between two points.

    Args:
        length: of the cable [m], more than the distance of its ends.
        across: horizontal distance of the ends [m]; 0 hangs it as two plumb lines.
        rise: how much higher the second end is [m].
        weight: per length [N/m].

    Raises ValueError for a cable that does not reach, and for numbers that are not positive and
    finite.

    Source: Irvine, Cable Structures (1981), sec. 1.2.
    """
    need("length", length, "m")
    need("weight", weight, "N/m")
    need_ends(across, rise)
    distance = math.hypot(across, rise)
    if length <= distance:
        raise ValueError(
            f"length: {length:g} m - must be more than the distance of the ends, {distance:g} m: "
            "an inextensible cable is not stretched"
        )
    if across == 0.0:
        return Cable(length, across, rise, weight, math.inf, 0.0, 0.5 * weight * (length - rise))
    a = parameter(length, across, rise)
    vertical = weight * a * math.sinh(0.5 * across / a - math.atanh(rise / length))
    return Cable(length, across, rise, weight, math.inf, weight * a, vertical)


def parameter(length: float, across: float, rise: float = 0.0) -> float:
    """Return a = H/w [m] of the catenary of a length between two points that are `across` > 0 apart."""
    distance = math.hypot(across, rise)
    chord = math.sqrt((length - rise) * (length + rise))
    # sinh(u)/u - 1 = chord/across - 1, written without cancellation for a nearly taut cable
    excess = (length - distance) * (length + distance) / (across * (chord + across))
    return 0.5 * across / inverse_sinhc(excess)


def inverse_sinhc(excess: float) -> float:
    """Return u > 0 with sinh(u)/u = 1 + excess, for excess > 0, to rounding."""
    if excess < 1.0:  # sinh(u)/u - 1 = u^2/6 (1 + u^2/20 (1 + u^2/42 (1 + ...)))
        square = 6.0 * excess
        for _ in range(60):
            value, slope = _sinhc_less_one(square)
            change = (value - excess) / slope
            square -= change
            if abs(change) <= 1e-16 * square:
                break
        return math.sqrt(square)
    target, u = math.log1p(excess), math.log1p(excess) + 2.0
    for _ in range(100):  # log(sinh(u)/u) grows and is convex: Newton from above goes straight down
        value = u + math.log(-math.expm1(-2.0 * u) / (2.0 * u)) - target
        change = value / (1.0 / math.tanh(u) - 1.0 / u)
        u -= change
        if abs(change) <= 1e-16 * u:
            break
    return u


def _sinhc_less_one(square: float) -> tuple[float, float]:
    """Return sinh(u)/u - 1 and its derivative by u^2, from the series in u^2."""
    value, slope, term = 0.0, 0.0, 1.0
    for j in range(1, 30):
        slope += j * term / ((2 * j) * (2 * j + 1))
        term *= square / ((2 * j) * (2 * j + 1))
        value += term
        if term <= 1e-18 * value:
            break
    return value, slope
