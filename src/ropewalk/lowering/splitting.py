"""What each of several surfaces does to a node by friction, from what all do to it together.

Their sum is known, each lies in its own surface and is no more than mu R_n. What is left open, springs that
stick alone know. It is closed by the least of
    sum |R_t - g|^2 / (2 w),    |R_t| <= mu R_n,    sum R_t = rest
with g = 0 and w = mu R_n: of a groove, along which each side then has what its own could carry. But where
surfaces move against each other, one of them slips at least: that over which the node moves faster. Of it
g = mu R_n against its slip, and w is so small that it gives way only where the sum asks for it: a belt that
drags a rope over a table pulls with all its friction, and the table holds against it.

With l the multipliers of the sum and C the cut to mu R_n it is R_t = C(g + w P l), P = I - n n^T: l (3,) is
found by Newton's method on the dual, which is convex. Source: Rockafellar, Convex Analysis, 1970, section 31.
"""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from ropewalk.core.arrays import Floats

PARALLEL = 1e-9  # [1] least of A's eigenvalues over the largest, below which surfaces are parallel
_ROUNDING = 1e-9  # [1] of mu R_n, to which the sum is met and by which friction may be over it
_FIRM = 1e-6  # [1] w over mu R_n of what slips
_EASE = 1e-14  # [1] of all mu R_n, what of the sum may be left per unit of l: else l is endless at the limit
_MOST = 80  # iterations
_STALLS = 8  # iterations in which the sum comes no nearer by a tenth: friction cannot be all of it
_HALVES = 20  # of a step


def split(
    normal: Floats, most: Floats, rest: Floats, slip: Floats, slides: NDArray[np.bool_]
) -> Floats:
    """Return the friction of c contacts at one node, (c, 3) [N], each along its surface, `rest` (3,) in all.

    Args:
        normal: (c, 3) of the surfaces [1].
        most: (c,) mu R_n [N].
        rest: (3,) the friction of all; what no surface can carry of it is left out [N].
        slip: (c, 3) velocity over each surface [m/s].
        slides: (c,) which slip for certain, see `that_slide`.

    None is more than mu R_n where that can be.
    """
    P = np.eye(3) - normal[:, :, None] * normal[:, None, :]
    found = _spread(P, most, rest)
    bound = most * (1.0 + _ROUNDING)
    if not slides.any() and (np.linalg.norm(found, axis=1) <= bound).all():
        return found
    speed = np.linalg.norm(slip, axis=1)[:, None]
    against = -most[:, None] * np.divide(slip, speed, out=np.zeros_like(slip), where=speed > 0.0)
    goal = np.where(slides[:, None], against, 0.0)
    found = _within(P, most, found.sum(axis=0), goal, most * np.where(slides, _FIRM, 1.0))
    return found + _spread(P, most, rest - found.sum(axis=0))


def that_slide(slip: Floats, over: Floats, still: float) -> NDArray[np.bool_]:
    """Return which of c contacts at one node slip, as their surfaces move against each other, (c,).

    `slip` (c, 3) is the velocity along each surface, `over` (c, 3) all of it [m/s]. One slips where it has at
    least half of what another surface moves against its own by more than `still` [m/s]: of two that slide
    along each other that is so for one at least, and the sum leaves the other what it has.
    """
    apart = np.linalg.norm(over[:, None] - over[None, :], axis=2).max(axis=1)
    found: NDArray[np.bool_] = (apart > still) & (np.linalg.norm(slip, axis=1) >= 0.5 * apart)
    return found


def _spread(P: Floats, weight: Floats, rest: Floats) -> Floats:
    """Return (c, 3) [N] that are `rest` (3,) in all, with the least sum of |R_t|^2 over `weight` (c,)."""
    along = weight[:, None, None] * P
    found: Floats = along @ (np.linalg.pinv(along.sum(axis=0), PARALLEL, hermitian=True) @ rest)
    return found


def _within(P: Floats, most: Floats, rest: Floats, goal: Floats, weight: Floats) -> Floats:
    """Return (c, 3) [N], none more than `most` (c,), that are as near to `rest` (3,) in all as they can."""
    ease, eye, whole = _EASE * most.sum(), np.eye(3), most.sum()
    dual = np.zeros(3)

    def at(dual: Floats) -> tuple[float, Floats, Floats, Floats, Floats]:
        """Return the dual's value, its gradient, (c, 3) [N], what is cut and by what."""
        wanted = goal + weight[:, None] * (P @ dual)
        size = np.linalg.norm(wanted, axis=1)
        part = np.divide(most, size, out=np.ones_like(size), where=size > most)
        found = part[:, None] * wanted
        off = ((found - goal) ** 2).sum(axis=1)
        cost = np.divide(off, 2.0 * weight, out=np.zeros_like(off), where=weight > 0.0).sum()
        value = found.sum(axis=0) @ dual - cost - rest @ dual + 0.5 * ease * (dual @ dual)
        return float(value), found.sum(axis=0) - rest + ease * dual, found, wanted, part

    value, slope, found, wanted, part = at(dual)
    nearest, stalls = np.inf, 0
    for _ in range(_MOST):
        left = float(np.linalg.norm(found.sum(axis=0) - rest))
        stalls = 0 if left < 0.9 * nearest else stalls + 1
        nearest = min(left, nearest)
        if left <= 0.01 * _ROUNDING * whole or stalls > _STALLS:
            break
        size = np.linalg.norm(wanted, axis=1)[:, None]
        way = np.divide(wanted, size, out=np.zeros_like(wanted), where=(part < 1.0)[:, None])
        turning = P - way[:, :, None] * way[:, None, :]
        bend = ((weight * part)[:, None, None] * turning).sum(axis=0) + ease * eye
        step = -np.linalg.solve(bend, slope)
        fall, share = float(slope @ step), 1.0
        for _ in range(_HALVES):
            tried = at(dual + share * step)
            if tried[0] <= value + 1e-4 * share * fall:
                break
            share *= 0.5
        else:
            break
        dual = dual + share * step
        value, slope, found, wanted, part = tried
    return found
