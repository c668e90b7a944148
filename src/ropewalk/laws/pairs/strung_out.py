"""A rope that is strung out touches nothing of itself: one look at its nodes tells, and no pair is listed."""

from __future__ import annotations

import math

from ropewalk.core.jit import kernel

CLEAR = 1.2  # [1] so far apart are segments that are no neighbours, over the sum of their radii; above REACH


@kernel
def is_strung_out(x, y, table, memory):
    """Tell whether one rope, all there is, goes on along its chord with all segments, on the way from x to y.

    So far that between any two that are no neighbours CLEAR times the diameter lies along it, and more than
    REACH: no contact begins. What moves straight is as far along as it is at one of both ends, at least.
    """
    rope, s = memory.rope, table.rope.shape[0]
    c0, c1, c2 = x[0, s] - x[0, 0], x[1, s] - x[1, 0], x[2, s] - x[2, 0]
    chord = math.sqrt(c0 * c0 + c1 * c1 + c2 * c2)
    least = 2.0 * CLEAR * table.radius[0] / table.skip[0] * chord
    x0, x1, x2, y0, y1, y2 = x[0], x[1], x[2], y[0], y[1], y[2]
    one, bad = rope[0], 0
    for j in range(s):
        a = c0 * (x0[j + 1] - x0[j]) + c1 * (x1[j + 1] - x1[j]) + c2 * (x2[j + 1] - x2[j])
        b = c0 * (y0[j + 1] - y0[j]) + c1 * (y1[j + 1] - y1[j]) + c2 * (y2[j + 1] - y2[j])
        bad += 0 if (a > least) & (b > least) & (rope[j] == one) else 1
    return bad == 0 and one >= 0
