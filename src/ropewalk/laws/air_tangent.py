"""Derivatives of air drag; see `air_drag` for the laws.

With u the velocity relative to the wind, on a segment that of its middle, r its length, t its direction,
s = u . t, n = u - s t, P = I - t t^T and q the force taken from either end,
    linear, node      -dF/dv = c I
    quadratic, node   -dF/dv = a (|u| I + u u^T / |u|)
    quadratic, line   q = r/2 (N |n| n + S |s| s t)
                      dq/du = r/2 (N (|n| P + n n^T / |n|) + 2 S |s| t t^T)
                      dq/dd = q t^T / r + 1/2 (-N (s (|n| P + n n^T / |n|) + |n| t n^T)
                              + S |s| (2 t n^T + s P)),     d = x_(j+1) - x_j
"""

from __future__ import annotations

import math

from ropewalk.core.jit import deferred, kernel


@deferred()
def linear_drag_tangent(node_drag, weight_v, band):
    """Add `weight_v` times the linear drag of every node."""
    for i in range(node_drag.shape[0]):
        c = weight_v * node_drag[i]
        band.diagonal[i, 0] += c
        band.diagonal[i, 4] += c
        band.diagonal[i, 8] += c


@deferred()
def quadratic_node_tangent(v, coefficient, wind, weight_v, band):
    """Add `weight_v` times the derivatives of the quadratic drag of every node."""
    for i in range(coefficient.shape[0]):
        ux, uy, uz = v[0, i] - wind[0], v[1, i] - wind[1], v[2, i] - wind[2]
        speed = math.sqrt(ux * ux + uy * uy + uz * uz)
        if coefficient[i] == 0.0 or speed == 0.0:
            continue
        a = weight_v * coefficient[i]
        ax, ay, az = a * ux / speed, a * uy / speed, a * uz / speed
        band.diagonal[i, 0] += a * speed + ax * ux
        band.diagonal[i, 1] += ax * uy
        band.diagonal[i, 2] += ax * uz
        band.diagonal[i, 3] += ay * ux
        band.diagonal[i, 4] += a * speed + ay * uy
        band.diagonal[i, 5] += ay * uz
        band.diagonal[i, 6] += az * ux
        band.diagonal[i, 7] += az * uy
        band.diagonal[i, 8] += a * speed + az * uz


@kernel
def add_middle(band, j, k, m, by_place, by_speed):
    """Add entry (k, m) of dq/dd and of dq/du of a drag q taken from both ends of segment j."""
    at = 3 * k + m
    half = 0.5 * by_speed
    band.diagonal[j, at] += half - by_place
    band.lower1[j, at] += half - by_place
    band.diagonal[j + 1, at] += half + by_place
    band.upper1[j, at] += half + by_place


@deferred()
def line_drag_tangent(x, v, stiffness, normal, tangential, wind, weight_x, weight_v, band):
    """Add the derivatives of the drag of every segment."""
    for j in range(normal.shape[0]):
        if (normal[j] == 0.0 and tangential[j] == 0.0) or stiffness[j] == 0.0:
            continue
        dx, dy, dz = x[0, j + 1] - x[0, j], x[1, j + 1] - x[1, j], x[2, j + 1] - x[2, j]
        r = math.sqrt(dx * dx + dy * dy + dz * dz)
        if r == 0.0:
            continue
        t = (dx / r, dy / r, dz / r)
        ux = 0.5 * (v[0, j] + v[0, j + 1]) - wind[0]
        uy = 0.5 * (v[1, j] + v[1, j + 1]) - wind[1]
        uz = 0.5 * (v[2, j] + v[2, j + 1]) - wind[2]
        s = ux * t[0] + uy * t[1] + uz * t[2]
        n = (ux - s * t[0], uy - s * t[1], uz - s * t[2])
        add_line_drag(band, j, t, n, s, r, normal[j], tangential[j], weight_x, weight_v)


@kernel
def add_line_drag(band, j, t, n, s, r, normal, tangential, weight_x, weight_v):
    """Add the derivatives of one segment's drag; t its direction, n and s the flow across and along."""
    size = math.sqrt(n[0] * n[0] + n[1] * n[1] + n[2] * n[2])
    over = 1.0 / size if size > 0.0 else 0.0
    for k in range(3):
        q = 0.5 * (normal * size * n[k] + tangential * abs(s) * s * t[k])  # force over r
        for m in range(3):
            across = (1.0 if k == m else 0.0) - t[k] * t[m]
            turned = size * across + n[k] * n[m] * over
            by_speed = 0.5 * r * (normal * turned + 2.0 * tangential * abs(s) * t[k] * t[m])
            by_place = q * t[m] + 0.5 * (
                tangential * abs(s) * (2.0 * t[k] * n[m] + s * across)
                - normal * (s * turned + size * t[k] * n[m])
            )
            add_middle(band, j, k, m, weight_x * by_place, weight_v * by_speed)
