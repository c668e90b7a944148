"""The solution that errors are measured against.

Dormand and Prince's method of order 8 (Hairer, Norsett & Wanner, Solving Ordinary Differential Equations
I, II.5) in scipy's implementation, on `equations`: neither method nor laws are those that compete. Solved
twice, the second time to a hundredth of the tolerance; the distance of the two, which is the error of the
first, is taken as that of the second.
"""

from __future__ import annotations

from typing import NamedTuple

import numpy as np
from scipy.integrate import solve_ivp

from bench.work_precision.equations import Equations, Floats, rates

TOLERANCE = 1e-11


class Reference(NamedTuple):
    """Positions [m], (n, 3), at the end, and how far they are off at most."""

    positions: Floats
    error: float  # [m], rms over nodes


def distance(a: Floats, b: Floats) -> float:
    """Return the root mean square over the nodes of the distance between positions [m], (n, 3)."""
    return float(np.sqrt(((a - b) ** 2).sum(axis=1).mean()))


def solve(equations: Equations, duration: float, tolerance: float) -> Floats:
    """Return the positions [m], (n, 3), at `duration` [s]."""
    y = equations.start
    for begin, end in equations.pieces(duration):
        y = equations.enter(y, begin)
        found = solve_ivp(
            rates,
            (begin, end),
            y,
            "DOP853",
            t_eval=[end],
            args=equations.arguments,
            rtol=tolerance,
            atol=tolerance,
        )
        if not found.success:
            raise RuntimeError(f"no reference: {found.message}")
        y = found.y[:, -1]
    return equations.places(y)


def reference(equations: Equations, duration: float, tolerance: float = TOLERANCE) -> Reference:
    """Return the converged solution and an estimate of its error."""
    rough = solve(equations, duration, 100.0 * tolerance)
    fine = solve(equations, duration, tolerance)
    return Reference(fine, distance(rough, fine))
