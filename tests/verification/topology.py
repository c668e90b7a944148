"""How curves are linked and knotted, from their places alone: nothing of it knows what a contact is."""

from __future__ import annotations

import math
from collections.abc import Sequence
from typing import NamedTuple

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


class Crossing(NamedTuple):
    """Two passes of a projected curve: the places of both along all curves, and its sign."""

    over: float
    under: float
    sign: int


def crossings(curves: Sequence[Floats], turn: float = 0.3) -> tuple[list[Crossing], list[int]]:
    """Return the crossings of closed polygons in a projection, and where each polygon's points end."""
    rng = np.random.default_rng(int(1000 * turn))
    x = np.vstack([*curves]) @ np.linalg.qr(rng.normal(size=(3, 3)))[0]
    bounds = list(np.cumsum([len(curve) for curve in curves]))
    after = np.arange(1, len(x) + 1)
    after[np.array(bounds) - 1] = [0, *bounds[:-1]]
    step = x[after] - x
    r = x[None] - x[:, None]
    flat = step[:, None, 0] * step[None, :, 1] - step[:, None, 1] * step[None, :, 0]
    with np.errstate(divide="ignore", invalid="ignore"):
        s = (r[..., 0] * step[None, :, 1] - r[..., 1] * step[None, :, 0]) / flat
        t = (r[..., 0] * step[:, None, 1] - r[..., 1] * step[:, None, 0]) / flat
    size = np.linalg.norm(step, axis=1)
    crossed = np.abs(flat) > 1e-12 * size[:, None] * size[None]  # straight ends run on in one line
    hit = crossed & (s >= 0.0) & (s < 1.0) & (t >= 0.0) & (t < 1.0)
    hit[np.arange(len(x)), after] = hit[after, np.arange(len(x))] = False
    found = []
    for i, j in zip(*np.nonzero(np.triu(hit, 1)), strict=True):
        a, b = i + s[i, j], j + t[i, j]
        higher = x[i, 2] + s[i, j] * step[i, 2] > x[j, 2] + t[i, j] * step[j, 2]
        sign = int(np.sign(flat[i, j])) * (1 if higher else -1)
        found.append(Crossing(a, b, sign) if higher else Crossing(b, a, sign))
    return found, bounds


def alexander(curves: Sequence[Floats], turn: float = 0.3) -> tuple[int, ...]:
    """Return the coefficients of the Alexander polynomial of a knot or link, the first one positive.

    From the Wirtinger presentation by Fox's calculus, all variables alike; by values on the unit circle.
    Source: Livingston, Knot Theory, 1993, ch. 3.
    """
    found, bounds = crossings(curves, turn)
    starts = [0, *bounds[:-1]]
    order: list[float] = sorted(c.under for c in found)

    def arc(place: float) -> int:
        """Number of the arc on which a place lies: that which begins at the last crossing below before it."""
        k = next(i for i, end in enumerate(bounds) if place < end)
        own = [i for i, under in enumerate(order) if starts[k] <= under < bounds[k]]
        assert own, "a curve that lies above all others: turn it"
        before = [i for i in own if order[i] < place]
        return before[-1] if before else own[-1]

    n = len(found)
    if n < 3:
        return (1,) if len(curves) == 1 else (0,)
    size = 2 * n + 1
    values = np.empty(size, complex)
    rows = [(arc(c.over), arc(c.under), order.index(c.under), c.sign) for c in found]
    for k in range(size):
        t = np.exp(2j * np.pi * k / size)
        matrix = np.zeros((n, n), complex)
        for row, (over, into, out, sign) in enumerate(rows):
            low, high = (into, out) if sign > 0 else (out, into)
            matrix[row, over] += 1.0 - t
            matrix[row, low] += t
            matrix[row, high] -= 1.0
        values[k] = np.linalg.det(matrix[1:, 1:])
    parts = np.fft.fft(values) / size
    whole = np.round(parts.real).astype(int)
    assert np.abs(parts - whole).max() < 1e-6
    at = np.flatnonzero(whole)
    if not len(at):
        return (0,)
    first, last = int(at[0]), int(at[-1])
    return tuple(int(c) for c in whole[first : last + 1] * np.sign(whole[first]))


def jones(curve: Floats, turn: float = 0.3) -> dict[int, int]:
    """Return the Jones polynomial of a closed polygon, power of t to coefficient.

    By Kauffman's bracket, summed over all states. Source: Kauffman, Topology 26 (1987) 395.
    """
    found, _ = crossings([curve], turn)
    n = len(found)
    assert n <= 14, "too many crossings to sum over all states: turn it"
    places = sorted([c.over for c in found] + [c.under for c in found])
    into = {
        place: k for k, place in enumerate(places)
    }  # the arc that ends there; the next one begins
    quads = []
    for c in found:
        o, u = into[c.over], into[c.under]
        oo, uu = (o + 1) % (2 * n), (u + 1) % (2 * n)
        # anticlockwise from the lower one that comes in
        quads.append((u, oo, uu, o) if c.sign > 0 else (u, o, uu, oo))
    bracket: dict[int, int] = {}
    for state in range(2**n):
        root = list(range(2 * n))

        def find(k: int, root: list[int] = root) -> int:
            while root[k] != k:
                k = root[k]
            return k

        power = 0
        for k, (a, b, c2, d) in enumerate(quads):
            one = state >> k & 1
            power += 1 - 2 * one
            pairs = ((a, d), (b, c2)) if one else ((a, b), (c2, d))
            for p, q in pairs:
                root[find(p)] = find(q)
        loops = sum(find(k) == k for k in range(2 * n))
        for j in range(loops):  # (-A^2 - A^-2)^(loops - 1)
            if loops - 1 >= j:
                add = math.comb(loops - 1, j) * (-1) ** (loops - 1)
                at = power + 2 * (loops - 1) - 4 * j
                bracket[at] = bracket.get(at, 0) + add
    writhe = sum(c.sign for c in found)
    shifted = {k - 3 * writhe: v * (-1) ** (writhe % 2) for k, v in bracket.items() if v}
    assert all(k % 4 == 0 for k in shifted)
    return {-k // 4: v for k, v in sorted(shifted.items(), reverse=True)}
