"""Air drag, linear and quadratic, relative to a uniform wind.

Linear per node:     F = -c (v - w)                              (NeHe lesson 40)
Quadratic per node:  F = -a |v - w| (v - w)                      (Habrador's rope)
Quadratic per line:  F = -rho d / 2 (Cn |un| un + pi Ct |ut| ut) per unit stretched length,
                     u the relative velocity of the segment's middle, split along and across the segment
                     (Morison's form for a slender cylinder, normal and tangential parts independent;
                     e.g. Sumer & Fredsoe, Hydrodynamics around Cylindrical Structures). The factor pi,
                     in the tangential table already, refers Ct to the wetted surface pi d.
"""

from __future__ import annotations

import math

from ropewalk.core.jit import deferred
from ropewalk.core.ranges import ALL, rows


@deferred()
def linear_drag(v, node_drag, wind, force, lo=0, hi=ALL):
    """Write the linear drag of every node [N], (3, n)."""
    v0, v1, v2 = rows(v, lo, hi)
    f0, f1, f2 = rows(force, lo, hi)
    node_drag = node_drag[lo:hi]
    wx, wy, wz = wind[0], wind[1], wind[2]
    for i in range(node_drag.shape[0]):
        f0[i] = -node_drag[i] * (v0[i] - wx)
        f1[i] = -node_drag[i] * (v1[i] - wy)
        f2[i] = -node_drag[i] * (v2[i] - wz)


@deferred()
def quadratic_node_drag(v, coefficient, wind, force, lo=0, hi=ALL):
    """Add the isotropic quadratic drag of every node [N], (3, n)."""
    v0, v1, v2 = rows(v, lo, hi)
    f0, f1, f2 = rows(force, lo, hi)
    coefficient = coefficient[lo:hi]
    wx, wy, wz = wind[0], wind[1], wind[2]
    for i in range(coefficient.shape[0]):
        ux, uy, uz = v0[i] - wx, v1[i] - wy, v2[i] - wz
        drag = coefficient[i] * math.sqrt(ux * ux + uy * uy + uz * uz)
        f0[i] -= drag * ux
        f1[i] -= drag * uy
        f2[i] -= drag * uz


@deferred()
def quadratic_line_drag(x, v, stiffness, normal, tangential, wind, force, lo=0, hi=ALL):
    """Add the drag of every segment, half to each end [N], (3, n); one without `stiffness` is no rope."""
    for j in range(lo, min(hi, normal.shape[0])):
        if (normal[j] == 0.0 and tangential[j] == 0.0) or stiffness[j] == 0.0:
            continue
        dx = x[0, j + 1] - x[0, j]
        dy = x[1, j + 1] - x[1, j]
        dz = x[2, j + 1] - x[2, j]
        r = math.sqrt(dx * dx + dy * dy + dz * dz)
        if r == 0.0:
            continue
        ux = 0.5 * (v[0, j] + v[0, j + 1]) - wind[0]
        uy = 0.5 * (v[1, j] + v[1, j + 1]) - wind[1]
        uz = 0.5 * (v[2, j] + v[2, j + 1]) - wind[2]
        along = (ux * dx + uy * dy + uz * dz) / (r * r)
        ax, ay, az = along * dx, along * dy, along * dz
        nx, ny, nz = ux - ax, uy - ay, uz - az
        across = 0.5 * r * normal[j] * math.sqrt(nx * nx + ny * ny + nz * nz)
        down = 0.5 * r * tangential[j] * abs(along) * r
        for i in (j, j + 1):
            force[0, i] -= across * nx + down * ax
            force[1, i] -= across * ny + down * ay
            force[2, i] -= across * nz + down * az
