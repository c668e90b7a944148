"""Coefficients of the implicit methods.

A diagonally implicit Runge-Kutta method (DIRK) is a table A, b, c:
    X_s = x0 + h sum_r A_sr V_r,   V_s = v0 + h sum_r A_sr a_r,   a_s = a(t + c_s h, X_s, V_s)
    x1  = x0 + h sum_s b_s V_s,    v1  = v0 + h sum_s b_s a_s
Stiffly accurate ones have b equal to A's last row, so that the last stage is the step's end.
`embedded` gives a second result of another order; the difference of both estimates the error.
"""

from __future__ import annotations

import math
from typing import NamedTuple

import numpy as np

from ropewalk.core.arrays import Floats

DIRK, BDF2, GENERALIZED_ALPHA = range(3)


class Tableau(NamedTuple):
    """One implicit method; a multistep method starts with the DIRK method of its table."""

    kind: int
    A: Floats  # (s, s) lower triangular; a zero on the diagonal is an explicit stage
    b: Floats  # (s,)
    c: Floats  # (s,)
    embedded: Floats  # (s,) weights of the embedded method, (0,) where there is none
    numbers: Floats  # (4,) alpha_m, alpha_f, beta, gamma of generalized-alpha

    @property
    def stages(self) -> int:
        """Number of stages."""
        return len(self.b)


class ImplicitMethod(NamedTuple):
    """What the registry, the stability of a step and its cost need to know of one."""

    name: str
    order: int
    tableau: Tableau
    summary: str  # a sentence for those who choose
    holds_links: bool = False  # whether lengths and tensions of rigid links are right
    fixed: bool = True  # steps of one length, as planned


def dirk(
    A: list[list[float]], b: list[float] | None = None, embedded: list[float] | None = None
) -> Tableau:
    """Return a DIRK table; without `b` a stiffly accurate one. Node c is the sum of its row."""
    rows = np.zeros((len(A), len(A)))
    for i, row in enumerate(A):
        rows[i, : len(row)] = row
    weights = rows[-1].copy() if b is None else np.array(b)
    return Tableau(DIRK, rows, weights, rows.sum(axis=1), np.array(embedded or []), np.zeros(4))


IMPLICIT_EULER = dirk([[1.0]])
IMPLICIT_MIDPOINT = dirk([[0.5]], [1.0])

_g = 1.0 - 1.0 / math.sqrt(2.0)
#: Alexander 1977, SIAM J. Numer. Anal. 14:1006, theorem 5: order 2, L-stable.
SDIRK2 = dirk([[_g], [1.0 - _g, _g]])


def _esdirk3() -> Tableau:
    """The implicit part of ARK3(2)4L[2]SA, Kennedy & Carpenter 2003, Appl. Numer. Math. 44:139.

    Explicit first stage, order 3, stage order 2, stiffly accurate, L-stable; embedded order 2.
    """
    g = 1767732205903 / 4055673282236
    rows = [
        [0.0],
        [g, g],
        [2746238789719 / 10658868560708, -640167445237 / 6845629431997, g],
        [
            1471266399579 / 7840856788654,
            -4482444167858 / 7529755066697,
            11266239266428 / 11593286722821,
            g,
        ],
    ]
    embedded = [
        2756255671327 / 12835298489170,
        -10771552573575 / 22201958757719,
        9247589265047 / 10645013368117,
        2193209047091 / 5459859503100,
    ]
    return dirk(rows, None, embedded)


ESDIRK3 = _esdirk3()
BDF_2 = SDIRK2._replace(kind=BDF2)
#: For rigid links, whose tensions SDIRK2 gets wrong in its one step, too.
BDF_2_LINKS = ESDIRK3._replace(kind=BDF2)
SPECTRAL_RADIUS = 0.8


def generalized_alpha(radius: float = SPECTRAL_RADIUS) -> Tableau:
    """Return generalized-alpha with a spectral radius at infinite frequency, 0 to 1.

    Chung & Hulbert 1993, J. Appl. Mech. 60:371, eqs. 17, 18 and 25.
    """
    alpha_m = (2.0 * radius - 1.0) / (radius + 1.0)
    alpha_f = radius / (radius + 1.0)
    gamma = 0.5 - alpha_m + alpha_f
    beta = 0.25 * (1.0 - alpha_m + alpha_f) ** 2
    return SDIRK2._replace(
        kind=GENERALIZED_ALPHA, numbers=np.array([alpha_m, alpha_f, beta, gamma])
    )
