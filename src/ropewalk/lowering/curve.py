"""Initial places of a rope's nodes."""

from __future__ import annotations

import math
from collections.abc import Sequence

import numpy as np

from ropewalk.core.arrays import Floats
from ropewalk.scene import Hanging, Points, Polyline, Slack, Straight
from ropewalk.scene.shapes import Shape
from ropewalk.theory.catenary import parameter


def initial_points(
    shape: Shape, segments: int, length: float, segment_length: float, up: Sequence[float]
) -> Floats:
    """Return the initial place of every node of a rope [m], (segments + 1, 3).

    From its shape, its unstretched length and a segment's [m], and the unit vector upward.
    """
    down = -np.array(up)
    share = np.arange(segments + 1) / segments
    match shape:
        case Points():
            return np.array(shape.points, dtype=np.float64)
        case Polyline():
            return along_polyline(np.array(shape.points, dtype=np.float64), share)
        case Hanging():
            along = share[:, None] * length * down
            return np.asarray(shape.start + along, dtype=np.float64)
        case Slack():
            start, end = np.array(shape.start, float), np.array(shape.end, float)
            return catenary_points(start, end, length, down, share)
    assert isinstance(shape, Straight)
    start = np.array(shape.start, dtype=np.float64)
    if shape.end is not None:
        return np.asarray(start + share[:, None] * (np.array(shape.end) - start))
    way = np.array(shape.direction or (1.0, 0.0, 0.0), dtype=np.float64)
    way /= np.linalg.norm(way)
    # node by node, so that a rope at rest length has no stretch from rounding
    return start + np.arange(segments + 1)[:, None] * (segment_length * way)


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
