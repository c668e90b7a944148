"""Points along the lines that initial shapes are made of."""

from __future__ import annotations

import math

import numpy as np

from ropewalk.core.arrays import Floats
from ropewalk.theory.catenary import catenary, parameter


def along_polyline(corners: Floats, share: Floats) -> Floats:
    """Return points at shares (0..1) of the arc length of a polyline, (m, 3)."""
    lengths = np.concatenate([[0.0], np.cumsum(np.linalg.norm(np.diff(corners, axis=0), axis=1))])
    return np.stack(
        [np.interp(share * lengths[-1], lengths, corners[:, k]) for k in range(3)], axis=1
    )


def catenary_points(
    start: Floats, end: Floats, length: float, down: Floats, share: Floats
) -> Floats:
    """Return points at shares of the arc length of a catenary of given length, (m, 3).

    sqrt(L^2 - Y^2) = 2 a sinh(X / 2a) for the parameter a (Irvine 1981, sec. 1.2). With ends above
    each other the rope hangs as a plumb loop; a rope no longer than the span is straight.
    """
    step = end - start
    drop = float(step @ down)
    across = step - drop * down
    span = float(np.linalg.norm(across))
    if length <= math.hypot(span, drop) * (1.0 + 1e-12):
        return start + share[:, None] * step
    s = share * length
    if span < 1e-9 * length:
        bottom = 0.5 * (length + drop)
        depth = np.where(s <= bottom, s, 2.0 * bottom - s)
        return start + depth[:, None] * down + share[:, None] * across
    a = parameter(length, span, drop)
    low = 0.5 * span - a * math.atanh(-drop / length)  # x of the lowest point
    # arc length from the start: s = a (sinh((x - low)/a) + sinh(low/a))
    x = low + a * np.arcsinh(s / a - math.sinh(low / a))
    height = a * (np.cosh((x - low) / a) - math.cosh(low / a))
    points: Floats = start + (x / span)[:, None] * across - height[:, None] * down
    points[-1] = end
    return points


def length_of_sag(start: Floats, end: Floats, sag: float, down: Floats) -> float:
    """Return the arc length [m] of the catenary that drops by so much below the line between two points."""
    step = end - start
    drop = float(step @ down)
    across = float(np.linalg.norm(step - drop * down))
    low = math.hypot(across, drop) * (1.0 + 1e-13)
    high = low + 2.0 * sag  # down and up again
    for _ in range(100):
        middle = 0.5 * (low + high)
        if not low < middle < high:
            break
        if catenary(middle, across, -drop).sag < sag:
            low = middle
        else:
            high = middle
    return 0.5 * (low + high)
