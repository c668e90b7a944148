"""Closed forms that the claims are held against. m node mass, k spring constant, L rest length,
c spring friction, g gravity; all SI."""

from __future__ import annotations

import math

from ropewalk.theory.chain_modes import chain_decay_times, chain_factors


def scheme_frequency(k: float, m: float, c: float, dt: float) -> float:
    """Angular frequency of one mass under semi-implicit Euler [rad/s].

    From z^2 - (2 - a - b) z + (1 - b) = 0 with a = k dt^2/m, b = c dt/m.
    """
    a, b = k * dt * dt / m, c * dt / m
    return math.acos((2.0 - a - b) / (2.0 * math.sqrt(1.0 - b))) / dt


def scheme_factor(m: float, c: float, dt: float) -> float:
    """Amplitude left after one step, sqrt(1 - c dt/m) [1]; the root of the product of both z."""
    return math.sqrt(1.0 - c * dt / m)


def mode(j: int, free: int) -> float:
    """4 sin^2(j pi / (2 (n + 1))): mode j of n free masses between two pins [1]."""
    return float(chain_factors(free)[j - 1])


def decay_time(j: int, free: int, m: float, c: float) -> float:
    """Time in which mode j falls to 1/e under vector friction, 2 m / (c mu_j) [s]."""
    return float(chain_decay_times(free, c, m)[j - 1])


def hanging_stretch(n: int, k: float, m: float, g: float) -> float:
    """Stretch of n springs hanging by their own masses, m g n (n + 1) / (2 k) [m]."""
    return m * g * n * (n + 1) / (2.0 * k)


def shallow_sag(k: float, m: float, L: float, g: float, span: float) -> tuple[float, float]:
    """Sag [m] and horizontal pull [N] of a rope as long as its span.

    Parabola: H^3 = k L (m g / L)^2 S^2 / 24, sag = (m g / L) S^2 / (8 H) (Irvine 1981, ch. 2).
    """
    w = m * g / L
    pull = (k * L * w * w * span * span / 24.0) ** (1.0 / 3.0)
    return w * span * span / (8.0 * pull), pull


def bounce_strain(k: float, m: float, L: float, g: float, span: float) -> float:
    """Largest mean strain of a straight rope that is let go, one-arch energy balance [1].

    A parabola of depth d has lost (2/3) m g N d of weight energy and holds k N (e L)^2 / 2, with e
    from its arc length; both are equal at the turning point. Good to some 20 %: the strain is not
    even, and other waves take part.
    """
    low, high = 1e-9 * span, 100.0 * span
    for _ in range(200):
        depth = 0.5 * (low + high)
        if 0.5 * k * (arc_strain(depth, span) * L) ** 2 < (2.0 / 3.0) * m * g * depth:
            low = depth
        else:
            high = depth
    return arc_strain(low, span)


def arc_strain(depth: float, span: float) -> float:
    """Arc length over span, less 1, of a parabola: s = 4 d / S,
    (sqrt(1 + s^2) + asinh(s) / s) / 2 - 1 [1]."""
    slope = 4.0 * depth / span
    if slope < 1e-4:
        return slope * slope / 6.0
    return 0.5 * (math.sqrt(1.0 + slope * slope) + math.asinh(slope) / slope) - 1.0


def largest_spring(m: float, c: float, rate: float) -> float:
    """Largest spring constant of a long chain at `rate` steps a second, m f^2 - 2 c f [N/m]."""
    return m * rate * rate - 2.0 * c * rate


def swing_period(pull: float, m: float, L: float, span: float) -> float:
    """Period of the longest wave on a taut rope, 2 S / sqrt(H L / m) [s]."""
    return 2.0 * span / math.sqrt(pull * L / m)
