"""The braid of an open trefoil in a thin rope: two strands that wind about each other by three half turns.

D(z) is half the way from one strand's middle line to the other's, over the rope's radius r; z goes along
the braid, over l = sqrt(r R), R the radius of the loop. At both ends one strand goes on into the loop, the
other into a straight end, so that D'' is e_x / 2 beyond the last contact, and -e_x / 2 before the first.
In between D is as little bent as |D| >= 1 lets it: the least of
    int_0^L |D''|^2 dz - D_x'(L),
with D_x odd and D_y even (a braid is its own image, turned by half a turn about y), for L beyond the last
contact. Contacts press by D'''' = p D, p >= 0 in EI r / l^4 per length.
Source: Audoly, Clauvelin & Neukirch 2007, Phys. Rev. Lett. 99:164301, where sigma = int p dz is 0.492;
Clauvelin, Audoly & Neukirch 2009, J. Mech. Phys. Solids 57:1623. Solved here anew.
"""

from __future__ import annotations

import math
from typing import NamedTuple

import numpy as np
from scipy import sparse
from scipy.sparse.linalg import splu

from ropewalk.core.arrays import Floats


class Braid(NamedTuple):
    """Half of a braid, z >= 0."""

    z: Floats  # over sqrt(r R), (n + 1,)
    D: Floats  # over r, (n + 1, 2)
    push: Floats  # of every node, over EI r / l^3, (n + 1,)

    @property
    def sigma(self) -> float:
        """The force of all contacts over EI / R^2 sqrt(R / r)."""
        return float(2.0 * self.push.sum() - self.push[0])


def _bending(z: Floats) -> tuple[sparse.csc_matrix, Floats]:
    """Twice the matrix of int |D''|^2, and the gradient of D_x'(L); unknowns x_1.. and then y_0.. ."""
    n, h = len(z) - 1, z[1]
    inner = sparse.diags([1.0, -2.0, 1.0], [0, 1, 2], shape=(n - 1, n + 1)).tolil() / h**2
    even = sparse.lil_matrix((1, n + 1))
    even[0, 0], even[0, 1] = -math.sqrt(2.0) / h**2, math.sqrt(2.0) / h**2  # y'' at 0, half a step
    x = inner.tocsc()[:, 1:]  # x_0 = 0, and its bend with it
    y = sparse.vstack([even, inner]).tocsc()
    load = np.zeros(2 * n + 1)
    load[n - 1], load[n - 2] = 1.0 / h, -1.0 / h
    return 2.0 * h * sparse.block_diag([x.T @ x, y.T @ y]).tocsc(), load


def _least(K: sparse.csc_matrix, load: Floats, A: sparse.csc_matrix, start: Floats) -> Floats:
    """The least of u K u / 2 - load u with A u >= 1, by inner points; with the multipliers behind it."""
    u, m = start.copy(), A.shape[0]
    slack = np.maximum(A @ u - 1.0, 1e-2)
    force, centre = np.full(m, 1e-2), 0.1
    exact = 1e-14 * float(abs(K).max())  # what rounding leaves of a sum of bends
    for _ in range(100):
        dual, primal = K @ u - load - A.T @ force, A @ u - 1.0 - slack
        gap = float(slack @ force) / m
        if gap < 1e-10 and max(np.abs(dual).max(), np.abs(primal).max()) < max(exact, 1e-9):
            break
        weight = force / slack
        aim = centre * gap / slack - force  # of the force, before the slack goes
        solve = splu((K + A.T @ sparse.diags(weight) @ A + 1e-8 * sparse.eye(len(u))).tocsc())
        du = solve.solve(-dual + A.T @ (aim - weight * primal))
        ds = A @ du + primal
        df = aim - weight * ds
        parts = [1.0] + [
            float((-0.995 * v[dv < 0.0] / dv[dv < 0.0]).min())
            for v, dv in ((slack, ds), (force, df))
            if (dv < 0.0).any()
        ]
        step = min(parts)
        u, slack, force = u + step * du, slack + step * ds, force + step * df
        centre = 0.1 if step > 0.5 else 0.5
    return np.concatenate([u, force])


def braid(pieces: int = 600, length: float = 4.5) -> Braid:
    """The least bent braid; half of it in so many pieces, of a length over sqrt(r R)."""
    z = np.linspace(0.0, length, pieces + 1)
    K, load = _bending(z)
    angle = 2.0 * math.pi - 1.5 * math.pi * np.clip(1.0 - z / (0.5 * length), 0.0, 1.0)
    far = 1.0 + np.clip(z - 0.5 * length, 0.0, None) ** 2
    D = far[:, None] * np.stack((np.cos(angle), np.sin(angle)), axis=1)
    found: Floats = np.empty(0)
    rows = np.arange(pieces)
    for _ in range(200):
        before = D.copy()
        way = D / np.linalg.norm(D, axis=1)[:, None]
        # n . D >= 1 lies within |D| >= 1: each round is a braid, less bent than the last
        A = sparse.hstack(
            [
                sparse.csc_matrix((way[1:, 0], (rows + 1, rows)), shape=(pieces + 1, pieces)),
                sparse.diags(way[:, 1]),
            ]
        ).tocsc()
        found = _least(K, load, A, np.concatenate([D[1:, 0], D[:, 1]]))
        D = np.stack(
            (np.concatenate([[0.0], found[:pieces]]), found[pieces : 2 * pieces + 1]), axis=1
        )
        if np.abs(D - before).max() < 1e-6:
            break
    push = 0.5 * found[2 * pieces + 1 :]
    push[0] *= 2.0  # half of the node at 0 is on this side
    return Braid(z, D, push)
