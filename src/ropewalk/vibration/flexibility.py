"""The inverse of a model's stiffness, and the rates that it sets."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import numpy as np

from ropewalk.core.arrays import Floats
from ropewalk.vibration.linear import Linear

_ROUNDING = 1e-14  # of the largest stiffness beside that of segments: what is less is none [1]
_SINGULAR = (
    1e14  # flexibility, in units of the model's own, beyond which something moves freely [1]
)
_STIFF = 1e6  # stiffness of a segment, over that of its tension, that counts for the rate [1]
_SHIFT = 1e-6  # shift that is then taken, in units of the model's rate [1]


class NoModes(ArithmeticError):  # noqa: N818 - it is what happened, not a mistake
    """The modes of a model were not found."""


def find_inverse(linear: Linear) -> tuple[Callable[[Any], Any], float]:
    """Return the solution of (K + s C + s^2 M) u = f, and the shift s that was needed [1/s]."""
    from scipy.sparse.csgraph import structural_rank
    from scipy.sparse.linalg import splu

    size = linear.mass.size
    shift = 0.0
    for _ in range(2):
        matrix = linear.saddle(shift)
        matrix.eliminate_zeros()
        try:
            if structural_rank(matrix) < matrix.shape[0]:  # SuperLU may crash on it
                raise RuntimeError
            factors = splu(matrix)
            probe = factors.solve(np.append(start(size), np.zeros(linear.soft.size)))[:size]
            sound = bool(np.abs(probe).max() * linear.mass.max() * rate(linear) ** 2 < _SINGULAR)
        except RuntimeError:  # exactly singular
            sound = False
        if sound:
            break
        shift = _SHIFT * rate(linear)
    if not sound:
        raise NoModes("the stiffness of this shape is singular: its modes cannot be found")

    return solution(factors, size), shift


def solution(factors: Any, size: int) -> Callable[[Any], Any]:
    """Return the solution for forces on the nodes, (3 f, ...), of the factors of a saddle matrix."""

    def inverse(force: Any) -> Any:
        right = np.zeros((factors.shape[0], *force.shape[1:]))
        right[:size] = force
        return factors.solve(right)[:size]

    return inverse


def rate(linear: Linear) -> float:
    """Return a middle frequency of the model, from its diagonals [1/s].

    The slow modes of stiff ropes must not count as free: of stiff segments no more than `_STIFF` times
    their tension counts, of rigid links nothing, nor stiffness that is rounding: of a rope that lies there
    it is what most nodes have sideways.
    """
    soft, other = linear.soft, np.abs(linear.other.diagonal())
    other[other <= _ROUNDING * other.max(initial=0.0)] = 0.0
    hard = np.divide(1.0, soft, out=np.zeros_like(soft), where=soft > 0.0)
    if other.any():
        hard = np.minimum(hard, _STIFF * np.median(other[other > 0.0]))
    diagonal = other + linear.lengths.multiply(linear.lengths).T @ hard
    if not diagonal.any():
        return 1.0
    return float(np.sqrt(np.median((diagonal / linear.mass)[diagonal > 0.0])))


def start(size: int) -> Floats:
    """A vector to begin with, the same at every call."""
    return np.random.default_rng(1).normal(size=size)
