"""The stability function of explicit Runge-Kutta methods, and what one step does to one mode by it.

    y' = z y:  y1 = R(z) y0,   R(z) = 1 + z sum b_s P_s,   P_1 = 1,   P_s = 1 + c_s z P_(s-1)
A mode has z1 + z2 = -b and z1 z2 = a (see `characteristic` for what a and b are); its step has the trace
R(z1) + R(z2) and the determinant R(z1) R(z2), which are polynomials in a and b.
Source: Hairer & Wanner, Solving Ordinary Differential Equations II, IV.2.
"""

from __future__ import annotations

from functools import cached_property
from typing import Any

import numpy as np
from numpy.polynomial.polynomial import polyval, polyval2d
from numpy.typing import ArrayLike, NDArray

from ropewalk.core.arrays import Floats
from ropewalk.methods.explicit_methods import RUNGE_KUTTA

_CANCELLED = 1e-14  # a coefficient this small is rounding of one that is zero


class StabilityFunction:
    """R of one method; called with complex numbers z it returns R(z)."""

    def __init__(self, table: Floats) -> None:
        nodes, weights = table
        self.coefficients = np.zeros(len(nodes) + 1)  # the lowest power first
        self.coefficients[0] = 1.0
        stage = np.zeros(len(nodes))
        for node, weight in zip(nodes, weights, strict=True):
            stage[1:] = node * stage[:-1]
            stage[0] = 1.0
            self.coefficients[1:] += weight * stage
        drop, loss = self._drop_and_loss()
        four = np.zeros_like(loss)
        four[0, 0] = 4.0
        self._drop, self._loss = drop, loss
        self._margins = tuple(map(_clean, (drop - loss, loss, four - drop - loss)))

    def __call__(self, z: Any) -> Any:
        """Return R(z)."""
        return polyval(z, self.coefficients)

    def _drop_and_loss(self) -> tuple[Floats, Floats]:
        """Return 2 - trace and 1 - det, coefficients by powers of a (rows) and b (columns)."""
        r, size = self.coefficients, len(self.coefficients)
        sums = np.zeros((size, size, size))  # of z1^k + z2^k
        sums[0, 0, 0], sums[1, 0, 1] = 2.0, -1.0
        for k in range(2, size):
            sums[k, :, 1:] = -sums[k - 1, :, :-1]
            sums[k, 1:] -= sums[k - 2, :-1]
        drop = -np.tensordot(r[1:], sums[1:], 1)
        loss = np.zeros((size, size))
        for j in range(size):
            for k in range(max(j, 1), size):
                share = r[j] * r[k] * (0.5 if j == k else 1.0)
                loss[j:] -= share * sums[k - j, : size - j]
        return _clean(drop), _clean(loss)

    def polynomial(self, a: ArrayLike, b: ArrayLike) -> Floats:
        """Return the characteristic polynomial of a step, monic, highest power first."""
        a, b = np.broadcast_arrays(np.asarray(a, float), np.asarray(b, float))
        trace, det = 2.0 - polyval2d(a, b, self._drop), 1.0 - polyval2d(a, b, self._loss)
        return np.stack([np.ones_like(trace), -trace, det], axis=-1)

    def margins(self, a: Floats, b: Floats) -> tuple[Floats, ...]:
        """Return the Jury conditions of the polynomial, expanded: stable where none is negative."""
        a, b = np.broadcast_arrays(a, b)
        return tuple(np.asarray(polyval2d(a, b, one), float) for one in self._margins)

    @cached_property
    def longest_decay(self) -> float:
        """The largest stable step times a rate of decay [1]."""
        ends = []
        for value in (1.0, -1.0):
            left = self.coefficients.copy()
            left[0] -= value
            roots = np.roots(left[::-1])
            ends += [-z.real for z in roots if abs(z.imag) < 1e-12 and z.real < -1e-12]
        return float(min(ends))

    @cached_property
    def undamped_gain(self) -> tuple[float, int]:
        """Factor and power of y by which motion that nothing damps grows a step, y = frequency x step.

        That of the lowest power; a method whose factor is positive has no stable step without friction.
        """
        alone = self._loss[:, 0]
        power = int(np.flatnonzero(alone)[0])
        return -0.5 * float(alone[power]), 2 * power


def _clean(coefficients: Floats) -> NDArray[np.float64]:
    return np.where(np.abs(coefficients) < _CANCELLED, 0.0, coefficients)


STABILITY = {method.name: StabilityFunction(method.table) for method in RUNGE_KUTTA}

#: Methods that have no stable step where nothing damps.
NEED_DAMPING = tuple(name for name, one in STABILITY.items() if one.undamped_gain[0] > 0.0)
