"""Distance to a closed surface of triangles: the nearest place on it, and on which side of it a point is.

Near a flat part the normal is the triangle's, about an edge it turns as about a line, about a corner as
about a point. Boxes in boxes hold the triangles; those farther away than what was found are passed over.
Sources: Ericson, Real-Time Collision Detection, 2005, 5.1.5 (nearest place of a triangle); Baerentzen &
Aanaes 2005, IEEE Trans. Vis. Comput. Graph. 11:243 (the side, by normals of edges and corners).
"""

from __future__ import annotations

import math

from ropewalk.core.jit import deferred, small

# A mesh as a row of numbers: how much it is rounded [m], how many boxes, where triangles and normals begin;
# then the boxes: low and high corner [m], the box after all that are in it, its first triangle and how many
# (0: it holds boxes); then the corners of the triangles [m]; then their normals, in the order of FACE to C.
ROUNDING, BOXES, TRIANGLES, NORMALS, HEAD = range(5)
BOX_WIDTH, TRIANGLE_WIDTH, NORMAL_WIDTH = 9, 9, 21
FACE, AB, BC, CA, A, B, C = range(7)


@deferred("float64", 9)
def mesh_probe(mesh, x, y, z):
    """Return what `obstacle_shapes.probe` does of a mesh; x, y, z in its own frame [m]."""
    triangle, feature, px, py, pz, square = nearest(mesh, x, y, z)
    at = int(mesh[NORMALS]) + NORMAL_WIDTH * triangle + 3 * feature
    nx, ny, nz = mesh[at], mesh[at + 1], mesh[at + 2]
    dx, dy, dz = x - px, y - py, z - pz
    far = math.sqrt(square)
    side = 1.0 if dx * nx + dy * ny + dz * nz >= 0.0 else -1.0
    gap, over = side * far - mesh[ROUNDING], 0.0
    if far > 0.0 and feature != FACE:
        nx, ny, nz, over = side * dx / far, side * dy / far, side * dz / far, side / far
    if feature == FACE:
        return gap, nx, ny, nz, 0.0, 0.0, 0.0, 0.0, 0.0
    if feature >= A:
        return gap, nx, ny, nz, 0.0, 0.0, 0.0, over, 0.0
    first = int(mesh[TRIANGLES]) + TRIANGLE_WIDTH * triangle
    p, q = first + 3 * (feature - AB), first + 3 * ((feature - AB + 1) % 3)
    ax, ay, az = mesh[q] - mesh[p], mesh[q + 1] - mesh[p + 1], mesh[q + 2] - mesh[p + 2]
    size = math.sqrt(ax * ax + ay * ay + az * az)
    return gap, nx, ny, nz, ax / size, ay / size, az / size, over, 0.0


@small
def nearest(mesh, x, y, z):
    """Return the triangle, its feature, the place on it [m] and the squared distance [m^2]."""
    boxes, corners = int(mesh[BOXES]), int(mesh[TRIANGLES])
    triangle, feature, px, py, pz, best = in_box(mesh, corners, likely(mesh, x, y, z), x, y, z)
    box = 0
    while box < boxes:
        at = HEAD + BOX_WIDTH * box
        if to_box(mesh, at, x, y, z) >= best:
            box = int(mesh[at + 6])
            continue
        t, f, qx, qy, qz, square = in_box(mesh, corners, box, x, y, z)
        if square < best:
            triangle, feature, px, py, pz, best = t, f, qx, qy, qz, square
        box += 1
    return triangle, feature, px, py, pz, best


@small
def likely(mesh, x, y, z):
    """Return a box of triangles near a point: from it on most others are known to be farther."""
    box = 0
    while mesh[HEAD + BOX_WIDTH * box + 8] == 0.0:
        one = HEAD + BOX_WIDTH * (box + 1)
        second = int(mesh[one + 6])
        other = HEAD + BOX_WIDTH * second
        near, far = to_box(mesh, one, x, y, z), to_box(mesh, other, x, y, z)
        if near == far:  # in both
            near, far = to_middle(mesh, one, x, y, z), to_middle(mesh, other, x, y, z)
        box = box + 1 if near <= far else second
    return box


@small
def to_box(mesh, at, x, y, z):
    """Return the squared distance to a box [m^2], 0 inside."""
    dx = max(mesh[at] - x, 0.0, x - mesh[at + 3])
    dy = max(mesh[at + 1] - y, 0.0, y - mesh[at + 4])
    dz = max(mesh[at + 2] - z, 0.0, z - mesh[at + 5])
    return dx * dx + dy * dy + dz * dz


@small
def to_middle(mesh, at, x, y, z):
    """Return the squared distance to the middle of a box [m^2]."""
    dx = 0.5 * (mesh[at] + mesh[at + 3]) - x
    dy = 0.5 * (mesh[at + 1] + mesh[at + 4]) - y
    dz = 0.5 * (mesh[at + 2] + mesh[at + 5]) - z
    return dx * dx + dy * dy + dz * dz


@small
def in_box(mesh, corners, box, x, y, z):
    """Return what `nearest` does of the triangles right in a box; inf as the distance where it has none."""
    at = HEAD + BOX_WIDTH * box
    first = int(mesh[at + 7])
    triangle, feature, px, py, pz, best = first, FACE, 0.0, 0.0, 0.0, math.inf
    for t in range(first, first + int(mesh[at + 8])):
        f, qx, qy, qz = on_triangle(mesh, corners + TRIANGLE_WIDTH * t, x, y, z)
        square = (x - qx) ** 2 + (y - qy) ** 2 + (z - qz) ** 2
        if square < best:
            triangle, feature, px, py, pz, best = t, f, qx, qy, qz, square
    return triangle, feature, px, py, pz, best


@small
def on_triangle(mesh, at, x, y, z):
    """Return the feature and the place [m] of a triangle that are nearest to a point."""
    ax, ay, az = mesh[at], mesh[at + 1], mesh[at + 2]
    bx, by, bz = mesh[at + 3] - ax, mesh[at + 4] - ay, mesh[at + 5] - az
    cx, cy, cz = mesh[at + 6] - ax, mesh[at + 7] - ay, mesh[at + 8] - az
    ux, uy, uz = x - ax, y - ay, z - az
    d1, d2 = bx * ux + by * uy + bz * uz, cx * ux + cy * uy + cz * uz
    if d1 <= 0.0 and d2 <= 0.0:
        return A, ax, ay, az
    bb, cc, bc = (
        bx * bx + by * by + bz * bz,
        cx * cx + cy * cy + cz * cz,
        bx * cx + by * cy + bz * cz,
    )
    d3, d4 = d1 - bb, d2 - bc  # of the point from b
    if d3 >= 0.0 and d4 <= d3:
        return B, ax + bx, ay + by, az + bz
    vc = d1 * d4 - d3 * d2
    if vc <= 0.0 and d1 >= 0.0 and d3 <= 0.0:
        s = d1 / bb
        return AB, ax + s * bx, ay + s * by, az + s * bz
    d5, d6 = d1 - bc, d2 - cc  # ... from c
    if d6 >= 0.0 and d5 <= d6:
        return C, ax + cx, ay + cy, az + cz
    vb = d5 * d2 - d1 * d6
    if vb <= 0.0 and d2 >= 0.0 and d6 <= 0.0:
        s = d2 / cc
        return CA, ax + s * cx, ay + s * cy, az + s * cz
    va = d3 * d6 - d5 * d4
    if va <= 0.0 and d4 >= d3 and d5 >= d6:
        s = (d4 - d3) / ((d4 - d3) + (d5 - d6))
        return BC, ax + bx + s * (cx - bx), ay + by + s * (cy - by), az + bz + s * (cz - bz)
    over = 1.0 / (va + vb + vc)
    s, r = vb * over, vc * over
    return FACE, ax + s * bx + r * cx, ay + s * by + r * cy, az + s * bz + r * cz
