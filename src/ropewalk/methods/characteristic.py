"""What one step of each method does to one mode of vibration.

A mode with stiffness k, friction c and mass m obeys ``m x'' + c x' + k x = 0``. One step of
length dt multiplies its state by a matrix that depends on two numbers without a unit:

    a = k dt^2 / m        b = c dt / m

The functions here return the characteristic polynomial of that matrix, monic, highest power
first, along the last axis; a and b are arrays that broadcast. ``MARGINS`` holds, for each method,
the Jury conditions of the same polynomial written out: the mode is stable exactly when none of
the numbers is negative. They are kept in expanded form because the friction that decides the
stability of `euler` and `heun` is lost to rounding in ``1 - det``.

Source: E. I. Jury, Theory and Application of the z-Transform Method (1964); Hairer, Norsett,
Wanner, Solving Ordinary Differential Equations I and II (stability functions).
"""

from __future__ import annotations

from collections.abc import Callable

import numpy as np
from numpy.typing import ArrayLike, NDArray

from ropewalk.methods.implicit_characteristic import implicit_characteristics
from ropewalk.methods.stability_function import STABILITY

Array = NDArray[np.float64]
Characteristic = Callable[[ArrayLike, ArrayLike], Array]
Margins = Callable[[Array, Array], tuple[Array, ...]]


def _polynomial(*coefficients: ArrayLike) -> Array:
    return np.stack(np.broadcast_arrays(*coefficients), axis=-1).astype(np.float64)


def _pair(a: ArrayLike, b: ArrayLike) -> tuple[Array, Array]:
    return np.asarray(a, dtype=np.float64), np.asarray(b, dtype=np.float64)


def semi_implicit_euler(a: ArrayLike, b: ArrayLike) -> Array:
    """Semi-implicit Euler: v1 = v + dt f(x, v), x1 = x + dt v1."""
    a, b = _pair(a, b)
    return _polynomial(1.0, -(2.0 - a - b), 1.0 - b)


def verlet(a: ArrayLike, b: ArrayLike) -> Array:
    """Velocity Verlet whose new force uses the predicted velocity v + dt f0.

    The force is carried to the next step, so the state is (x, v, f) and the polynomial cubic;
    without friction one root is zero and the others are those of `semi_implicit_euler`.
    """
    a, b = _pair(a, b)
    return _polynomial(1.0, -(2.0 - a - 1.5 * b), 1.0 - 2.0 * b, 0.5 * b)


def _semi_implicit_euler_margins(a: Array, b: Array) -> tuple[Array, ...]:
    return a, b, 4.0 - a - 2.0 * b, 2.0 - b


def _verlet_margins(a: Array, b: Array) -> tuple[Array, ...]:
    return a, b, 4.0 - a - 4.0 * b, 2.0 - b - 0.5 * a * b - b * b


CHARACTERISTIC: dict[str, Characteristic] = {
    **implicit_characteristics(),
    **{name: one.polynomial for name, one in STABILITY.items()},
    "semi-implicit-euler": semi_implicit_euler,
    "verlet": verlet,
}


def _positive_margins(a: Array, b: Array) -> tuple[Array, ...]:
    return a, b


#: Methods that are stable at any step: A-stable ones.
UNCONDITIONAL = frozenset(implicit_characteristics())

MARGINS: dict[str, Margins] = {
    **dict.fromkeys(UNCONDITIONAL, _positive_margins),
    **{name: one.margins for name, one in STABILITY.items()},
    "semi-implicit-euler": _semi_implicit_euler_margins,
    "verlet": _verlet_margins,
}

# A mode on the unit circle is stable; this much, relative to a + b, is rounding.
_ROUNDING = 1e-12


def is_stable(method: str, a: ArrayLike, b: ArrayLike) -> NDArray[np.bool_]:
    """Whether one step leaves the modes (a, b) bounded; elementwise. KeyError for no method."""
    a, b = np.broadcast_arrays(*_pair(a, b))
    lowest = np.minimum.reduce(np.broadcast_arrays(*MARGINS[method](a, b)))
    return np.asarray(lowest >= -_ROUNDING * (np.abs(a) + np.abs(b)))


def growth(method: str, a: ArrayLike, b: ArrayLike) -> Array:
    """Factor by which the modes (a, b) grow per step: the spectral radius; elementwise."""
    polynomial = CHARACTERISTIC[method](a, b)
    degree = polynomial.shape[-1] - 1
    companion = np.zeros((*polynomial.shape[:-1], degree, degree))
    companion[..., 0, :] = -polynomial[..., 1:]
    companion[..., np.arange(1, degree), np.arange(degree - 1)] = 1.0
    return np.asarray(np.abs(np.linalg.eigvals(companion)).max(axis=-1))
