"""How curves are linked and knotted, from their places alone: nothing of it knows what a contact is."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

Floats = NDArray[np.float64]


def linking_number(one: Floats, other: Floats) -> float:
    """Return the linking number of two closed polygons, (p, 3) and (q, 3), before it is rounded.

    The sum of the solid angles that pairs of edges span, over 4 pi. Source: Klenin & Langowski, Biopolymers
    54 (2000) 307, method 1a.
    """
    a, b = one[:, None], np.roll(one, -1, axis=0)[:, None]
    c, d = other[None], np.roll(other, -1, axis=0)[None]
    ac, ad, bc, bd = c - a, d - a, c - b, d - b

    def unit(v: Floats) -> Floats:
        size = np.linalg.norm(v, axis=-1, keepdims=True)
        return np.divide(v, size, out=np.zeros_like(v), where=size > 0.0)

    n = [unit(np.cross(p, q)) for p, q in ((ac, ad), (ad, bd), (bd, bc), (bc, ac))]
    angle = sum(np.arcsin(np.clip((n[k] * n[(k + 1) % 4]).sum(-1), -1.0, 1.0)) for k in range(4))
    sign = np.sign((np.cross(d - c, b - a) * ac).sum(-1))
    return float((angle * sign).sum() / (4.0 * np.pi))


def determinant(curve: Floats, turn: float = 0.3) -> int:
    """Return the determinant of a closed polygon as a knot, (p, 3): 1 of a ring, 3 of a trefoil.

    Each crossing of a projection says that twice the arc above equals the sum of the two below (Fox).
    Source: Livingston, Knot Theory, 1993, ch. 3.
    """
    rng = np.random.default_rng(int(1000 * turn))
    basis = np.linalg.qr(rng.normal(size=(3, 3)))[0]
    x = curve @ basis
    ends = np.roll(x, -1, axis=0)
    count, under = len(x), list[tuple[float, float]]()
    for i in range(count):
        for j in range(i + 2, count - (i == 0)):
            e, f, r = ends[i] - x[i], ends[j] - x[j], x[j] - x[i]
            flat = e[0] * f[1] - e[1] * f[0]
            if flat == 0.0:
                continue
            s, t = (r[0] * f[1] - r[1] * f[0]) / flat, (r[0] * e[1] - r[1] * e[0]) / flat
            if 0.0 <= s < 1.0 and 0.0 <= t < 1.0:
                higher = x[i][2] + s * e[2] > x[j][2] + t * f[2]
                under.append((j + t, i + s) if higher else (i + s, j + t))
    if len(under) < 3:
        return 1
    under.sort()
    places = np.array([below for below, _ in under])
    matrix = np.zeros((len(under), len(under)))
    for row, (_, above) in enumerate(under):
        over = int(np.searchsorted(places, above)) % len(under)
        matrix[row, over] += 2.0
        matrix[row, row] -= 1.0
        matrix[row, (row + 1) % len(under)] -= 1.0
    return round(abs(float(np.linalg.det(matrix[1:, 1:]))))
