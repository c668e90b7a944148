"""What Ropewalk is measured against: a bare numba loop and a vectorised numpy version."""

from __future__ import annotations

import math
from collections.abc import Callable

import numba
import numpy as np


@numba.njit(nogil=True, error_model="numpy")
def bare_steps(x, v, force, k, c, length, mass, dt, g, steps):
    """Semi-implicit Euler of one uniform rope, ends held: the arithmetic and nothing else."""
    x0, x1, x2 = x[0], x[1], x[2]
    v0, v1, v2 = v[0], v[1], v[2]
    f0, f1, f2 = force[0], force[1], force[2]
    n = x.shape[1]
    for _ in range(steps):
        for j in range(n - 1):
            dx, dy, dz = x0[j + 1] - x0[j], x1[j + 1] - x1[j], x2[j + 1] - x2[j]
            r = math.sqrt(dx * dx + dy * dy + dz * dz)
            q = k * (r - length) / r
            f0[j + 1] = q * dx + c * (v0[j + 1] - v0[j])
            f1[j + 1] = q * dy + c * (v1[j + 1] - v1[j])
            f2[j + 1] = q * dz + c * (v2[j + 1] - v2[j])
        w = dt / mass
        for a in range(3):
            xa, va, fa, ga = x[a], v[a], force[a], dt * g[a]
            for i in range(1, n - 1):
                u = va[i] + w * (fa[i + 1] - fa[i]) + ga
                va[i] = u
                xa[i] += dt * u


def bare_loop(nodes: int, dt: float) -> Callable[[int], None]:
    """Return a function that runs a number of bare steps on the report's rope."""
    x, v, force, g = _rope(nodes)
    bare_steps(x, v, force, 1e4, 0.05, 1.0, 0.05, dt, g, 1)
    return lambda steps: bare_steps(x, v, force, 1e4, 0.05, 1.0, 0.05, dt, g, steps)


def numpy_loop(nodes: int, dt: float) -> Callable[[int], None]:
    """Return a function that runs a number of steps written with whole numpy arrays, (n, 3)."""
    x, v, _, g = _rope(nodes)
    x, v = np.ascontiguousarray(x.T), np.ascontiguousarray(v.T)

    def run(steps: int) -> None:
        for _ in range(steps):
            d = x[1:] - x[:-1]
            r = np.linalg.norm(d, axis=1, keepdims=True)
            f = 1e4 * (r - 1.0) * d / r + 0.05 * (v[1:] - v[:-1])
            total = 0.05 * np.tile(g, (nodes, 1))
            total[:-1] += f
            total[1:] -= f
            v[1:-1] += dt / 0.05 * total[1:-1]
            x[1:-1] += dt * v[1:-1]

    return run


def _rope(nodes: int) -> tuple[np.ndarray, ...]:
    x = np.zeros((3, nodes))
    x[0] = np.arange(nodes)
    return x, np.zeros((3, nodes)), np.zeros((3, nodes + 1)), np.array([0.0, -9.81, 0.0])
