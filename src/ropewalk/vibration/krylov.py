"""The largest eigenvalues of a real operator that is known by what it does to vectors.

Block Krylov-Schur: a Krylov space from several vectors at once, so that eigenvalues that are equal are found
as often as they are there, cut back to its best part when it is full. Without the blocks it is what ARPACK
does, which finds equal ones only by rounding.
Source: Stewart, SIAM J. Matrix Anal. Appl. 23 (2001) 601; Zhou and Saad, Numer. Algorithms 47 (2008) 341.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from ropewalk.core.arrays import Floats

Complex = NDArray[np.complex128]
Apply = Callable[[Floats], Floats]

_SAME = 1e-9  # relative difference from a known eigenvalue of one that is equal [1]


@dataclass
class Space:
    """A space V with A V = V H + R E, R the next block."""

    basis: Floats  # (n, p + b): V and R, orthonormal
    small: Floats  # H (p, p)
    coupling: Floats  # E (b, p)
    known: int  # how many of the first vectors of V are an invariant space of their own

    @property
    def size(self) -> int:
        """Number of vectors of V."""
        return len(self.small)


def begin(apply: Apply, known: Floats, block: Floats) -> Space:
    """Return the space of known invariant vectors (n, p), orthonormal, which goes on with a block (n, b)."""
    block = _orthonormal(known, _orthonormal(known, block)[0])[0]
    small = known.T @ apply(known) if known.size else np.zeros((0, 0))
    coupling = np.zeros((block.shape[1], known.shape[1]))
    return Space(np.hstack([known, block]), small, coupling, known.shape[1])


def grow(space: Space, apply: Apply, steps: int) -> Space:
    """Return the space with some blocks more."""
    basis, small, coupling = space.basis, space.small, space.coupling
    for _ in range(steps):
        block = len(coupling)
        image = apply(basis[:, -block:])
        new, part, rest = _next(basis, image)
        size = len(small) + block
        wide = np.zeros((size, size))
        wide[: len(small), : len(small)] = small
        wide[len(small) :, : len(small)] = coupling
        wide[:, len(small) :] = part
        coupling = np.hstack([np.zeros((block, len(small))), rest])
        basis, small = np.hstack([basis, new]), wide
    return Space(basis, small, coupling, space.known)


def cut(space: Space, keep: int) -> Space:
    """Return the part of the space with all that is known and its `keep` other largest eigenvalues."""
    from scipy.linalg import schur

    known, size = space.known, space.size
    tail = space.small[known:, known:]
    sizes = np.sort(np.abs(np.linalg.eigvals(tail)))[::-1]
    if keep >= len(sizes):
        return space
    least = sizes[keep - 1] * (1.0 - 1e-13)  # so that no pair is cut in two
    try:
        tail, turn, kept = schur(
            tail, output="real", sort=lambda re, im=0.0: np.hypot(re, im) >= least
        )
    except np.linalg.LinAlgError:  # too many are equal to be put in order
        return space
    turn = turn[:, :kept]
    basis = space.basis
    part = basis[:, known:size] @ turn
    small = np.zeros((known + kept, known + kept))
    small[:known, :known] = space.small[:known, :known]
    small[:known, known:] = space.small[:known, known:] @ turn
    small[known:, known:] = tail[:kept, :kept]
    coupling = np.hstack([space.coupling[:, :known], space.coupling[:, known:] @ turn])
    return Space(np.hstack([basis[:, :known], part, basis[:, size:]]), small, coupling, known)


def pairs(space: Space) -> tuple[Complex, Complex, Floats]:
    """Return all eigenvalues that were not known (m,), their vectors (n, m), and errors relative to them."""
    known, size = space.known, space.size
    values, parts = np.linalg.eig(space.small[known:, known:])
    rest = np.linalg.norm(space.coupling[:, known:] @ parts, axis=0)
    vectors = space.basis[:, known:size] @ parts
    if known:
        old, turn = np.linalg.eig(space.small[:known, :known])
        mixed = np.linalg.solve(turn, space.small[:known, known:] @ parts)
        apart = values - old[:, None]
        equal = np.abs(apart) <= _SAME * np.abs(values)
        mixed = np.where(equal, 0.0, mixed / np.where(equal, 1.0, apart))
        vectors = vectors + space.basis[:, :known] @ (turn @ mixed)
    return values, vectors, rest / np.maximum(np.abs(values), 1e-300)


def _next(basis: Floats, image: Floats) -> tuple[Floats, Floats, Floats]:
    """Return the next block and what the image of the last is made of: basis @ part + block @ rest."""
    part = basis.T @ image
    image = image - basis @ part
    block, rest = np.linalg.qr(image)
    for _ in range(2):  # rounding, and the directions that a deficient block leaves open
        block, again, turn = _orthonormal(basis, block)
        part, rest = part + again @ rest, turn @ rest
    return block, part, rest


def _orthonormal(basis: Floats, block: Floats) -> tuple[Floats, Floats, Floats]:
    """Return the block orthonormal and at right angles to the basis; block = basis @ part + new @ turn."""
    part = basis.T @ block
    new, turn = np.linalg.qr(block - basis @ part)
    return new, part, turn
