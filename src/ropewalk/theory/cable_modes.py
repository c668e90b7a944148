"""Natural frequencies of strings and cables in closed form, all in rad/s.

Taut string: w_n = n (pi/L) sqrt(T/mu) (d'Alembert 1747).
Hanging rope: J0(2 w sqrt(L/g)) = 0 (D. Bernoulli 1733; Lamb, Higher Mechanics); with an end mass M the
tension is (M + mu s) g and J0, Y0 mix; N equal masses on N massless rigid links of length l have
w^2 = (g/l) x with L_N(x) = 0, the Laguerre polynomial.
Sagging cable: Irvine and Caughey, Proc. R. Soc. Lond. A 341 (1974) 299.
"""

from __future__ import annotations

import math
from collections.abc import Callable

import numpy as np
from numpy.typing import NDArray

from ropewalk.theory.given import need

Floats = NDArray[np.float64]


def string_frequencies(length: float, tension: float, line: float, count: int = 10) -> Floats:
    """Return the first sideways frequencies of a taut string [rad/s], (count,).

    Args:
        length: between the fixed ends [m].
        tension: [N].
        line: mass per (stretched) length [kg/m].
        count: how many.

    Raises ValueError for numbers that are not positive.

    Source: d'Alembert 1747: w_n = n (pi/L) sqrt(T/mu).
    """
    for name, value, unit in (("length", length, "m"), ("tension", tension, "N")):
        need(name, value, unit)
    need("line", line, "kg/m")
    return np.asarray(np.arange(1, count + 1) * math.pi / length * math.sqrt(tension / line))


def hanging_frequencies(
    length: float, gravity: float = 9.81, count: int = 10, end_mass: float = 0.0
) -> Floats:
    """Return the sideways frequencies of a rope that hangs from its top [rad/s], (count,).

    Args:
        length: [m].
        gravity: [m/s^2].
        count: how many.
        end_mass: mass at the lower end over the mass of the rope [1].

    Raises ValueError for numbers that are not positive (`end_mass`: negative).

    Source: D. Bernoulli 1733; Lamb, Higher Mechanics: J0(2 w sqrt(L/g)) = 0, with an end mass J0 and Y0.
    """
    from scipy.special import j0, j1, jn_zeros, y0, y1

    need("length", length, "m")
    need("gravity", gravity, "m/s^2")
    if not (math.isfinite(end_mass) and end_mass >= 0.0):
        raise ValueError(f"end_mass: {end_mass!r} - must not be negative")
    scale = math.sqrt(gravity / length)
    if end_mass == 0.0:
        return np.asarray(0.5 * scale * jn_zeros(0, count))
    low, high = 2.0 * math.sqrt(end_mass), 2.0 * math.sqrt(1.0 + end_mass)

    def condition(w: float) -> float:
        # z = 2 w sqrt(s + M/mu L); at the free end dy/dz = -(z/2) y, at the top y = 0
        a, b = w * low, w * high
        free_j, free_y = -j1(a) + 0.5 * a * j0(a), -y1(a) + 0.5 * a * y0(a)
        return float(j0(b) * free_y - y0(b) * free_j)

    # The first one is that of a pendulum, about 1; then neighbours are about pi/(high - low) apart.
    first = _roots(condition, 1e-3, 0.02, 1)
    step = 0.02 * math.pi / (high - low)
    others = _roots(condition, float(first[0]) + 1e-3, step, count - 1)
    return scale * np.concatenate([first, others])[:count]


def rigid_chain_frequencies(masses: int, link: float, gravity: float = 9.81) -> Floats:
    """Return all sideways frequencies of equal masses on massless rigid links [rad/s], (masses,).

    Args:
        masses: how many; the chain hangs from the top of the first link.
        link: length of each link [m].
        gravity: [m/s^2].

    Exact for every number of masses. Raises ValueError for numbers that are not positive.

    Source: w^2 = (g/l) x with L_N(x) = 0, the Laguerre polynomial; Lamb, Higher Mechanics.
    """
    need("masses", masses, "masses")
    need("link", link, "m")
    need("gravity", gravity, "m/s^2")
    # The zeros of L_N are the eigenvalues of its recurrence's Jacobi matrix (Golub and Welsch 1969).
    j = np.arange(masses)
    matrix = np.diag(2.0 * j + 1.0) + np.diag(j[1:] * 1.0, 1) + np.diag(j[1:] * 1.0, -1)
    return np.asarray(np.sqrt(gravity / link * np.linalg.eigvalsh(matrix)))


def cable_parameter(
    length: float, across: float, horizontal: float, weight: float, EA: float
) -> float:
    """Return Irvine's parameter lambda^2 of a shallow cable with level ends [1].

    lambda^2 = (w X/H)^2 X / (H Le/EA), Le = X (1 + 8 (sag/X)^2) with sag = w X^2/8H; below about 1 the
    cable is a taut string, above 4 pi^2 the first antisymmetric mode is the slowest in the plane.

    Args:
        length: unstretched [m]; w and Le refer to the span, as in the source.
        across: distance of the ends [m].
        horizontal: H [N].
        weight: per unstretched length [N/m].
        EA: [N].

    Raises ValueError for a span or a horizontal force that is not positive.

    Source: Irvine and Caughey, Proc. R. Soc. Lond. A 341 (1974) 299.
    """
    need("across", across, "m")
    need("horizontal", horizontal, "N")
    load = weight * length / across
    sag = load * across**2 / (8.0 * horizontal)
    path = across * (1.0 + 8.0 * (sag / across) ** 2)
    return (load * across / horizontal) ** 2 * across * EA / (horizontal * path)


def cable_frequencies(
    across: float, horizontal: float, line: float, parameter: float, count: int = 10
) -> dict[str, Floats]:
    """Return the frequencies of a shallow cable with level ends [rad/s], each (count,).

    "across": out of the plane of its sag, n (pi/X) sqrt(H/mu); "antisymmetric": in the plane, 2 n of
    the same; "symmetric": in the plane, the roots of tan(q/2) = q/2 - (4/lambda^2) (q/2)^3,
    q = w X sqrt(mu/H).

    Args:
        across: distance of the ends X [m].
        horizontal: H [N].
        line: mass per length of the span [kg/m].
        parameter: lambda^2 (`cable_parameter`).
        count: how many of each.

    Raises ValueError for numbers that are not positive.

    Source: Irvine and Caughey, Proc. R. Soc. Lond. A 341 (1974) 299.
    """
    need("across", across, "m")
    need("horizontal", horizontal, "N")
    need("line", line, "kg/m")
    need("parameter", parameter, "1")
    unit = math.sqrt(horizontal / line) / across
    n = np.arange(1, count + 1)

    def condition(half: float) -> float:
        # divided by half^3, so that the root 0 goes away for every parameter
        cosine = math.cos(half)
        value = math.sin(half) - cosine * half + 4.0 / parameter * half**3 * cosine
        return value / half**3

    half = _roots(condition, 1e-3, 0.02, count)
    return {
        "across": np.asarray(n * math.pi * unit),
        "antisymmetric": np.asarray(2 * n * math.pi * unit),
        "symmetric": 2.0 * half * unit,
    }


def _roots(function: Callable[[float], float], low: float, step: float, count: int) -> Floats:
    """Return the first simple zeros above `low`, by steps and bisection."""
    found: list[float] = []
    before = function(low)
    while len(found) < count:
        high = low + step
        value = function(high)
        if before * value <= 0.0:
            found.append(_bisect(function, low, high, before))
        low, before = high, value
    return np.array(found)


def _bisect(function: Callable[[float], float], low: float, high: float, before: float) -> float:
    for _ in range(200):
        middle = 0.5 * (low + high)
        if not low < middle < high:
            break
        if before * function(middle) > 0.0:
            low = middle
        else:
            high = middle
    return 0.5 * (low + high)
