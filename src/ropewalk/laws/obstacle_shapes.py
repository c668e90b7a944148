"""Surfaces of obstacles: distance, normal, and how the normal turns.

All are bodies of revolution about their axis but box, half-pipe and mesh, so that one that spins stays where
it is. The normal n points out of the solid; it changes with the place by
    dn = H dx,   H = c (I - n n^T - a a^T) + c' a a^T,
where a is tangent to the surface and c, c' are one over the distances from the centres of curvature.
"""

from __future__ import annotations

import math

from ropewalk.core.jit import kernel, small
from ropewalk.laws.triangles import mesh_probe

PLANE, SPHERE, CYLINDER, CAPSULE, BOX, TORUS, HALF_PIPE, MESH = range(8)


@small
def probe(kind, center, axis, size, x, y, z):
    """Return the distance of a point to a surface [m], negative inside, and n, a, c, c'.

    `center` and `axis` (3,); `size` (4,) or more as `obstacle.Obstacles` has it.
    """
    px, py, pz = x - center[0], y - center[1], z - center[2]
    ex, ey, ez = axis[0], axis[1], axis[2]
    along = px * ex + py * ey + pz * ez
    if kind == PLANE:
        return along, ex, ey, ez, 0.0, 0.0, 0.0, 0.0, 0.0
    if kind == SPHERE:
        return _ball(px, py, pz, size[0])
    if kind == BOX:
        return _box(px, py, pz, ex, ey, ez, size)
    if kind == MESH:
        return mesh_probe(size, px, py, pz)
    # from here on about an axis: rho away from it, in the direction u
    ux, uy, uz = px - along * ex, py - along * ey, pz - along * ez
    rho = math.sqrt(ux * ux + uy * uy + uz * uz)
    if rho > 0.0:
        ux, uy, uz = ux / rho, uy / rho, uz / rho
    else:
        ux, uy, uz = _across(ex, ey, ez)
    if kind == HALF_PIPE:
        return _trough(rho, ux, uy, uz, ex, ey, ez, size)
    # around the axis
    wx, wy, wz = ey * uz - ez * uy, ez * ux - ex * uz, ex * uy - ey * ux
    out, far = rho - size[0], 0.0
    if kind == TORUS:
        far = along
        out_of_bar = math.sqrt(out * out + far * far)
        return _rim(out, far, out_of_bar, size[1], rho, ux, uy, uz, ex, ey, ez, wx, wy, wz)
    side = 1.0 if along > 0.0 else -1.0
    beyond = abs(along) - size[1]  # past the flat end, or the begin of the round one
    if kind == CAPSULE:
        if beyond <= 0.0:
            return out, ux, uy, uz, ex, ey, ez, _over(rho), 0.0
        far = side * beyond
        return _ball(rho * ux + far * ex, rho * uy + far * ey, rho * uz + far * ez, size[0])
    if out > 0.0 and beyond > 0.0:
        corner = math.sqrt(out * out + beyond * beyond)
        far = side * beyond
        return _rim(out, far, corner, 0.0, rho, ux, uy, uz, ex, ey, ez, wx, wy, wz)
    if out >= beyond:
        return out, ux, uy, uz, ex, ey, ez, _over(rho), 0.0
    return beyond, side * ex, side * ey, side * ez, 0.0, 0.0, 0.0, 0.0, 0.0


@small
def _over(rho):
    """Return 1 / rho, 0 on the axis."""
    return 1.0 / rho if rho > 0.0 else 0.0


@kernel
def _across(ex, ey, ez):
    """Return some direction across another."""
    if abs(ex) < 0.7:
        x, y, z = 0.0, ez, -ey
    else:
        x, y, z = -ez, 0.0, ex
    size = math.sqrt(x * x + y * y + z * z)
    return x / size, y / size, z / size


@small
def _ball(px, py, pz, radius):
    """Return what `probe` does about a point."""
    d = math.sqrt(px * px + py * py + pz * pz)
    if d == 0.0:
        return -radius, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 0.0, 0.0
    return d - radius, px / d, py / d, pz / d, 0.0, 0.0, 0.0, 1.0 / d, 0.0


@small
def _rim(out, far, d, radius, rho, ux, uy, uz, ex, ey, ez, wx, wy, wz):
    """Return what `probe` does about a circle: `out` of it, `far` along its axis, `d` from it."""
    if d == 0.0:
        return -radius, ux, uy, uz, wx, wy, wz, 0.0, 0.0
    p, q = out / d, far / d
    nx, ny, nz = p * ux + q * ex, p * uy + q * ey, p * uz + q * ez
    around = p / rho if rho > 0.0 else 0.0
    return d - radius, nx, ny, nz, wx, wy, wz, 1.0 / d, around


@kernel
def _trough(rho, ux, uy, uz, ex, ey, ez, size):
    """Return what `probe` does in a trough that is open to a side: round below, upright walls above."""
    fx, fy, fz = size[1], size[2], size[3]
    if ux * fx + uy * fy + uz * fz <= 0.0:
        return size[0] - rho, -ux, -uy, -uz, ex, ey, ez, -_over(rho), 0.0
    sx, sy, sz = fy * ez - fz * ey, fz * ex - fx * ez, fx * ey - fy * ex
    beside = rho * (ux * sx + uy * sy + uz * sz)
    side = -1.0 if beside > 0.0 else 1.0
    return size[0] - abs(beside), side * sx, side * sy, side * sz, 0.0, 0.0, 0.0, 0.0, 0.0


@small
def _box(px, py, pz, ex, ey, ez, size):
    """Return what `probe` does for a box, whose third edge is along its axis; see `obstacle.Obstacles`."""
    fx, fy, fz = size[4], size[5], size[6]
    gx, gy, gz = ey * fz - ez * fy, ez * fx - ex * fz, ex * fy - ey * fx
    d, nx, ny, nz, ax, ay, az, over, other = _upright_box(
        px * fx + py * fy + pz * fz,
        px * gx + py * gy + pz * gz,
        px * ex + py * ey + pz * ez,
        size[0],
        size[1],
        size[2],
        size[3],
    )
    return (
        d,
        nx * fx + ny * gx + nz * ex,
        nx * fy + ny * gy + nz * ey,
        nx * fz + ny * gz + nz * ez,
        ax * fx + ay * gx + az * ex,
        ax * fy + ay * gy + az * ey,
        ax * fz + ay * gz + az * ez,
        over,
        other,
    )


@small
def _upright_box(px, py, pz, hx, hy, hz, edge):
    """Return what `probe` does for a box along the axes; its half sizes are less the edges' radius."""
    sx, sy, sz = (
        1.0 if px >= 0.0 else -1.0,
        1.0 if py >= 0.0 else -1.0,
        1.0 if pz >= 0.0 else -1.0,
    )
    qx, qy, qz = abs(px) - hx, abs(py) - hy, abs(pz) - hz
    if qx <= 0.0 and qy <= 0.0 and qz <= 0.0:  # inside: the nearest face
        if qx >= qy and qx >= qz:
            return qx - edge, sx, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0
        if qy >= qz:
            return qy - edge, 0.0, sy, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0
        return qz - edge, 0.0, 0.0, sz, 0.0, 0.0, 0.0, 0.0, 0.0
    ax, ay, az = (
        1.0 if qx <= 0.0 else 0.0,
        1.0 if qy <= 0.0 else 0.0,
        1.0 if qz <= 0.0 else 0.0,
    )
    qx, qy, qz = sx * max(qx, 0.0), sy * max(qy, 0.0), sz * max(qz, 0.0)
    d = math.sqrt(qx * qx + qy * qy + qz * qz)
    flat = ax + ay + az  # along how many axes its surface is straight here
    if flat == 2.0:
        return d - edge, qx / d, qy / d, qz / d, 0.0, 0.0, 0.0, 0.0, 0.0
    return d - edge, qx / d, qy / d, qz / d, ax, ay, az, 1.0 / d, 0.0
