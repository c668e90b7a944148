"""Normal modes of uniform straight chains in closed form: frequencies, shapes and decay.

N equal masses m and springs k; mode j = 1 .. N has the stiffness k mu_j and the friction c mu_j with
mu_j = 4 sin^2(theta_j). Sideways modes of a chain stretched to segments of length l by the tension T
are the same with k -> T / l. Source: Lagrange 1788; Kittel, Introduction to Solid State Physics, ch. 4.
"""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

Floats = NDArray[np.float64]

ENDS = ("fixed-fixed", "fixed-free", "fixed-half", "free-free")


def _half_angles(masses: int, ends: str) -> Floats:
    j = np.arange(1, masses + 1, dtype=np.float64)
    match ends:
        case "fixed-fixed":
            return np.asarray(j * np.pi / (2 * (masses + 1)))
        case "fixed-free":
            return np.asarray((2 * j - 1) * np.pi / (2 * (2 * masses + 1)))
        case "fixed-half":
            return np.asarray((2 * j - 1) * np.pi / (4 * masses))
        case "free-free":
            return np.asarray((j - 1) * np.pi / (2 * masses))
    raise ValueError(f"ends: {ends!r} - must be one of {', '.join(ENDS)}")


def chain_factors(masses: int, ends: str = "fixed-fixed") -> Floats:
    """Return mu_j of all modes [1], (masses,), slowest first.

    `ends`: "fixed-fixed"; "fixed-free"; "fixed-half", the free end with half a mass (a lumped rod);
    "free-free", whose first mode is 0. Raises ValueError for another word.

    Source: Lagrange 1788; Kittel, Introduction to Solid State Physics, ch. 4.
    """
    return np.asarray(4.0 * np.sin(_half_angles(masses, ends)) ** 2)


def chain_frequencies(
    masses: int, stiffness: float, mass: float, ends: str = "fixed-fixed"
) -> Floats:
    """Return the angular frequencies of all modes [rad/s], (masses,), without friction.

    Source: Lagrange 1788; Kittel, Introduction to Solid State Physics, ch. 4.
    """
    return np.asarray(np.sqrt(stiffness / mass * chain_factors(masses, ends)))


def chain_decay_times(
    masses: int, friction: float, mass: float, ends: str = "fixed-fixed"
) -> Floats:
    """Return the times in which modes fall to 1/e, tau_j = 2 m / (c mu_j) [s], (masses,).

    For underdamped modes; inf without friction. Source: m x'' + c mu x' + k mu x = 0.
    """
    rate = 0.5 * friction / mass * chain_factors(masses, ends)
    times: Floats = np.divide(1.0, rate, out=np.full(masses, np.inf), where=rate > 0.0)
    return times


def chain_shape(masses: int, mode: int, ends: str = "fixed-fixed") -> Floats:
    """Return the displacements of the masses in a mode counted from 1 [1], largest about 1.

    Source: Lagrange 1788; Kittel, Introduction to Solid State Physics, ch. 4.
    """
    angle = 2.0 * _half_angles(masses, ends)[mode - 1]
    place = np.arange(1, masses + 1)
    if ends == "free-free":
        return np.asarray(np.cos((place - 0.5) * angle))
    return np.asarray(np.sin(place * angle))
