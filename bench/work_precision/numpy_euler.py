"""Semi-implicit Euler as one writes it with whole numpy arrays."""

from __future__ import annotations

import numpy as np

from bench.work_precision.equations import Equations, Floats


def numpy_euler(equations: Equations, duration: float, steps: int) -> Floats:
    """Return the positions [m], (n, 3), at `duration` [s], after so many equal steps.

    Laws that do not act are left out, as one would.
    """
    spring, rest, slackens, vector, axial, normal, tangential = equations.segments
    inverse, drag = equations.nodes
    gravity, up = equations.numbers[0:3, None], equations.numbers[3:6]
    height, repulsion, slide, absorption = equations.numbers[6:10]
    state = equations.start.reshape(-1, 6)
    x, v = state[:, :3].T.copy(), state[:, 3:].T.copy()
    free = inverse > 0.0
    weight = gravity * free
    dt = duration / steps
    for s in range(steps):
        d, w = x[:, 1:] - x[:, :-1], v[:, 1:] - v[:, :-1]
        r = np.sqrt((d * d).sum(axis=0))
        pull = spring * (r - rest) / r
        if axial.any():
            pull += axial * (d * w).sum(axis=0) / (r * r)
        f = pull * d
        if vector.any():
            f += vector * w
        if slackens.any():
            f *= r >= rest
        total = np.zeros_like(x)
        total[:, :-1] += f
        total[:, 1:] -= f
        if normal.any() or tangential.any():
            u = 0.5 * (v[:, 1:] + v[:, :-1])
            along = (u * d).sum(axis=0) / (r * r)
            across = u - along * d
            size = np.sqrt((across * across).sum(axis=0))
            f = 0.5 * r * (normal * size * across + tangential * r * abs(along) * along * d)
            total[:, :-1] -= f
            total[:, 1:] -= f
        if drag.any():
            total -= drag * v
        if np.isfinite(height):
            depth, rise = height - up @ x, up @ v
            push = repulsion * depth - absorption * np.minimum(rise, 0.0)
            ground = push * up[:, None] - slide * (v - rise * up[:, None])
            total += np.where(depth > 0.0, ground, 0.0)
        v += dt * (total * inverse + weight)
        x += dt * v
        for node, begin, end, velocity in equations.moves:
            t = (s + 1) * dt
            start = equations.start[6 * node : 6 * node + 3]
            x[:, node] = start + velocity * min(max(t - begin, 0.0), end - begin)
            v[:, node] = velocity * (begin <= t < end)
    return np.ascontiguousarray(x.T)
