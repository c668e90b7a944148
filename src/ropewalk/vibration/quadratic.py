"""The slowest eigenvalues of P(l) u = (l^2 M + l C + K) u = 0 for large models.

The inverse of the companion matrix at a shift has its largest eigenvalues where l is nearest to the shift.
The first shift is 0; where so many eigenvalues crowd that they do not part from there (strong friction
makes all short waves creep alike), the next one is put in front of the crowd. What is given back is
checked twice: every pair by its residual, and the whole by counting the eigenvalues in a disk.
Source: Tisseur and Meerbergen, SIAM Review 43 (2001) 235, sec. 3 and 6.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

from ropewalk.core.arrays import Floats
from ropewalk.vibration import krylov
from ropewalk.vibration.flexibility import NoModes, find_inverse, rate, solution
from ropewalk.vibration.linear import Linear
from ropewalk.vibration.winding import missing

Complex = NDArray[np.complex128]

_EPSILON = float(np.finfo(np.float64).eps)
_BLOCK = 8  # vectors that a Krylov space begins with at least: so many equal ones are found at once
_WIDEST = 64  # vectors that it begins with at most
_STEPS = 8  # blocks by which it grows at least before it is cut back
_CYCLES = 8  # times that a space is grown before another shift is tried
_TRIES = 8  # shifts, and beginnings, that are tried
_SETTLED = 1e-11  # residual of a pair that is found [1]
_NEARLY = 1e-10  # the same behind another shift, where rounding is larger [1]
_PLAUSIBLE = 0.1  # the same of one that is on its way [1]
_CROWD = 0.05  # distance of a shift from the crowd behind it at most, over its size [1]
_NEAREST = 1e-12  # the same at least [1]
_PARALLEL = 1e-6  # part of a shape that others do not have: less is none [1]
_CHECKED = 1e-8  # residual of a pair that is given back [1]
_ZERO = 1e-4  # of the shift, where one is needed: a smaller eigenvalue is 0 but for rounding [1]
_REAL = 1e-9  # of the size: a smaller imaginary part is rounding [1]
_ROUNDING = 8.0  # times the rounding that is estimated: what a residual may be [1]
_GAP = 1.03  # of sizes, between which eigenvalues can be counted [1]
_BEHIND = 4  # more than are wanted, behind which such a gap is sought at most
_APART = 1e-7  # of a shift: eigenvalues nearer to it are not counted [1]
_NOISE = 1e-13  # of the largest stiffness: rounding of the shape [1]


@dataclass(frozen=True)
class Shifted:
    """The inverse of the companion matrix, l counted from a shift; velocities in units of `scale`."""

    linear: Linear
    shift: float  # [1/s]
    scale: float  # [1/s]
    inverse: Callable[[Any], Any]  # of P(shift)

    def apply(self, both: Floats) -> Floats:
        """Return the product with displacements and velocities, (6 f, ...)."""
        size = self.linear.mass.size
        u, v = both[:size], both[size:] * self.scale
        mass = self.linear.mass[:, None]
        force = mass * (v + 2.0 * self.shift * u) + self.linear.friction @ u
        return np.concatenate([-self.inverse(force), u / self.scale])

    def basis(self, values: Complex, shapes: Complex) -> Floats:
        """Return the real space of eigenvectors, orthonormal, of eigenvalues with shapes (3 f, m)."""
        from scipy.linalg import qr

        both = np.concatenate([shapes, shapes * ((values - self.shift) / self.scale)])
        both = both / np.linalg.norm(both, axis=0)
        parts = np.hstack([both.real, both.imag])
        space, sizes, _ = qr(parts, mode="economic", pivoting=True)
        return np.asarray(space[:, np.abs(sizes.diagonal()) > _PARALLEL])

    def residuals(self, values: Complex, shapes: Complex) -> Floats:
        """Return |P(shift)^-1 P(l) u| / |u|, (m,)."""
        mass, shift = self.linear.mass[:, None], self.shift
        force = (values**2 - shift**2) * (mass * shapes)
        force += (values - shift) * (self.linear.friction @ shapes)
        back = self.inverse(force.real) + 1j * self.inverse(force.imag)
        size = np.maximum(np.linalg.norm(shapes, axis=0), 1e-300)
        return np.asarray(np.linalg.norm(shapes + back, axis=0) / size)

    def rounding(self, values: Complex, shapes: Complex) -> float:
        """Return what rounding leaves of such residuals: much in stiff ropes and finely cut rods."""
        if not values.size:
            return 0.0
        signs = np.random.default_rng(4).choice([-1.0, 1.0], size=shapes.shape)
        sizes, rates = np.abs(shapes), np.abs(values)
        force = abs(self.linear.other) @ sizes + rates * (abs(self.linear.friction) @ sizes)
        force += rates**2 * (self.linear.mass[:, None] * sizes)
        left = np.linalg.norm(self.inverse(_EPSILON * signs * force), axis=0)
        return float((left / np.maximum(np.linalg.norm(shapes, axis=0), 1e-300)).max())


@dataclass(frozen=True)
class Found:
    """Eigenvalues, the smallest first, with shapes (3 f, m) and what is known of them."""

    values: Complex
    shapes: Complex
    settled: Any  # (m,) whether they are found
    plausible: Any  # (m,) whether they are, or on their way

    def settle(self, count: int) -> bool:
        """Whether more than `count` of the smallest, of a pair one, are found and none before is not."""
        values, settled = self.values[self.plausible], self.settled[self.plausible]
        first = len(settled) if settled.all() else int(np.argmin(settled))
        return bool((values[:first].imag >= 0.0).sum() > count)

    def with_more(self, more: Found) -> Found:
        """Return them and others in order."""
        values = np.concatenate([self.values, more.values])
        shapes = np.hstack([self.shapes, more.shapes])
        settled = np.concatenate([self.settled, more.settled])
        plausible = np.concatenate([self.plausible, more.plausible])
        return Found(values, shapes, settled, plausible).only(
            np.argsort(np.abs(values), kind="stable")
        )

    def only(self, kept: Any) -> Found:
        """Return a part of them."""
        parts = self.values[kept], self.shapes[:, kept], self.settled[kept], self.plausible[kept]
        return Found(*parts)


def slowest(linear: Linear, count: int) -> tuple[Complex, Complex, float]:
    """Return the `count` slowest eigenvalues, both of a pair, shapes (3 f, m), and their rounding [1].

    Some larger ones may come with them. Raises NoModes when they are not found.
    """
    _, singular = find_inverse(linear)
    base = shifted(linear, rate(linear) / linear.nodes.size if singular else 0.0)
    zero = _ZERO * base.shift
    operator, found = base, _nothing(linear)
    for attempt in range(_TRIES):
        found = _search(operator, base, found, count, zero, attempt)
        done, shift = found.settle(count), _in_front(found, count)
        found = found.only(found.settled)
        rounding = base.rounding(found.values, found.shapes)
        bound = max(_CHECKED, _ROUNDING * rounding)
        found = found.only(base.residuals(found.values, found.shapes) <= bound)
        if done and found.settle(count) and not _lost(operator, base, found.values, count, zero):
            return found.values, found.shapes, rounding
        if not done:
            operator = base if shift is None else shifted(linear, shift)
    raise NoModes(
        f"the modes were not found in {_TRIES} tries: too many are nearly alike, or rounding is too "
        "large; ask for more or fewer modes, or take fewer segments"
    )


def noise(linear: Linear) -> float:
    """Return the size of eigenvalues that come from the rounding of the shape [1/s]."""
    push = _NOISE * float(np.abs(linear.other.diagonal()).max())
    drag, mass = float(linear.friction.diagonal().mean()), float(linear.mass.mean())
    return 2.0 * push / (drag + np.sqrt(drag**2 + 4.0 * mass * push)) if push else 0.0


def shifted(linear: Linear, shift: float) -> Shifted:
    """Return the inverse for a shift [1/s], its scale about the slowest rate there."""
    from scipy.sparse.linalg import splu

    size = linear.mass.size
    inverse = solution(splu(linear.saddle(shift)), size)
    scale = abs(shift)
    if scale == 0.0:
        probe = np.random.default_rng(3).normal(size=size)
        for _ in range(4):
            probe = inverse(linear.mass * (probe / np.linalg.norm(probe)))
        scale = float(1.0 / np.sqrt(np.linalg.norm(probe)))
    return Shifted(linear, shift, scale, inverse)


def _nothing(linear: Linear) -> Found:
    none = np.zeros(0, bool)
    return Found(np.zeros(0, complex), np.zeros((linear.mass.size, 0), complex), none, none)


def _search(
    operator: Shifted, base: Shifted, known: Found, count: int, zero: float, seed: int
) -> Found:
    """Return the eigenvalues near a shift, with those that are found already."""
    size = operator.linear.mass.size
    width = _width(operator.linear)
    block = np.random.default_rng(seed).normal(size=(2 * size, width))
    block = operator.apply(
        block
    )  # without what is far from the shift, that would stay in the space
    space = krylov.begin(operator.apply, operator.basis(known.values, known.shapes), block)
    keep = 2 * count + count // 2 + width
    for _ in range(_CYCLES):
        space = krylov.grow(krylov.cut(space, keep), operator.apply, max(_STEPS, keep // width))
        values, vectors, errors = krylov.pairs(space)
        values, shapes = _cleaned(operator.shift + 1.0 / values, zero), vectors[:size]
        plausible = errors <= _PLAUSIBLE
        if operator is not base:
            near, some = values[plausible], shapes[:, plausible]
            errors[plausible] = base.residuals(near, some) - _ROUNDING * base.rounding(near, some)
        settled = errors <= (_SETTLED if operator is base else _NEARLY)
        found = known.with_more(Found(values, shapes, settled, plausible))
        if found.settle(count):
            break
    return found


def _width(linear: Linear) -> int:
    """Return how many vectors to begin with: several for every rope, for ropes may be alike."""
    from scipy.sparse.csgraph import connected_components

    joined = linear.lengths.T @ linear.lengths
    ropes = connected_components(joined, directed=False)[0] - int((joined.diagonal() == 0.0).sum())
    return int(np.clip(3 * ropes + 2, _BLOCK, _WIDEST))


def _cleaned(values: Complex, zero: float) -> Complex:
    """Return eigenvalues without the rounding that makes two equal real ones a pair, or 0 something."""
    size = np.abs(values)
    values = np.where(np.abs(values.imag) <= _REAL * size, values.real, values)
    return np.where(size <= zero, 0.0, values)


def _in_front(found: Found, count: int) -> float | None:
    """Return a shift in front of the eigenvalues that do not part; None where they are not real."""
    crowd = found.values[found.plausible & ~found.settled & (found.values != 0.0)][: count + 1]
    if not len(crowd) or abs(crowd[0].imag) > _PLAUSIBLE * abs(crowd[0]):
        return None
    size = abs(crowd[0])
    gap = np.clip(0.5 * (abs(crowd[-1]) - size), _NEAREST * size, _CROWD * size)
    return float(np.sign(crowd[0].real) * (size - gap))


def _lost(operator: Shifted, base: Shifted, values: Complex, count: int, zero: float) -> int:
    """Return how many eigenvalues among those wanted are missing, as far as they can be counted."""
    linear, place = base.linear, int(np.flatnonzero(values.imag >= 0.0)[count - 1])
    wanted = float(np.abs(values[place])) * (1.0 + _REAL)
    behind = (
        int((np.abs(values) <= wanted).sum()) <= place + _BEHIND
    )  # else they are cut from a crowd
    lost = _lost_about(0.0, linear, values, wanted, behind, max(zero, noise(linear)))
    if not lost and operator is not base:
        least = _APART * abs(operator.shift)
        lost = _lost_about(operator.shift, linear, values, wanted, behind, least)
    return lost


def _lost_about(
    centre: float, linear: Linear, values: Complex, wanted: float, behind: bool, least: float
) -> int:
    """Return how many are missing in a disk about a shift, of `least` size, with none but those wanted.

    It may end `behind` the last that is wanted, too, in front of the next.
    """
    values = values[np.argsort(np.abs(values - centre), kind="stable")]
    sizes = np.abs(values - centre)
    others = np.flatnonzero(np.abs(values) > wanted)
    last = int(others[0]) - 1 if others.size else len(values) - 2
    ratios = sizes[1:] / np.maximum(sizes[:-1], least + 1e-300)
    gaps = np.flatnonzero(ratios > _GAP)
    next_ones = gaps[(gaps >= max(last, 0)) & (gaps <= last + _BEHIND)]
    places = [*next_ones[: int(behind)], *gaps[gaps < last][::-1]]
    radii = [np.sqrt(sizes[i] * sizes[i + 1]) for i in places]
    for radius in (*radii[:3], 0.5 * sizes[0]):
        if radius <= least:
            return 0
        lost = missing(linear, values, radius, centre)
        if lost is not None:
            return lost
    return 0
