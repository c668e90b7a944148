"""Where a scene fits: the search for least squares in every basin that a scan of starts shows."""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence
from dataclasses import dataclass

import numpy as np

from ropewalk.core.arrays import Floats
from ropewalk.sweeps.fit_residuals import LOST, NotFitted, Residuals

_FEWEST, _MOST = 4, 6  # starts that are followed where several values are fitted
_ONE = 1e-4  # of the ranges: nearer to a fit that is known, a search leads to it
_APART = 1e-3  # of the ranges: two fits are at two places
_EQUAL = 1e-6  # of a sum of squares: two that differ by less are equally good


@dataclass(frozen=True)
class Found:
    """The fits that were found, as shares of the ranges, with their sums of squares."""

    share: Floats  # (D,) the best
    square: float
    places: tuple[tuple[Floats, float], ...]  # of all searches that ended anew, the best too
    worse: int  # searches that ended in a worse place
    tried: int

    def others(self, ends: Sequence[tuple[float, float]], rise: float) -> list[Floats]:
        """Return places that fit as well, a sum of squares up to `rise` more, outside the intervals.

        Two that differ only in values whose interval is their whole range are one place.
        """
        shown = np.array([not (low < _APART and high > 1.0 - _APART) for low, high in ends])
        told: list[Floats] = []
        for place, square in self.places:
            if not square <= self.square + rise or not shown.any():
                continue
            gaps = (np.abs(place - one)[shown].max() for one in (self.share, *told))
            if all(gap > _APART for gap in gaps) and _outside(place, ends):
                told.append(place)
        return told


def _to_the_ends(shares: Floats) -> Floats:
    """Return shares (k,) of a range with its ends and half way to them: a fit may lie beyond all others."""
    ends = np.array([0.0, 0.5 * shares.min(), 0.5 * (1.0 + shares.max()), 1.0])
    return np.asarray(np.unique(np.concatenate([shares, ends])))


def _outside(place: Floats, ends: Sequence[tuple[float, float]]) -> bool:
    for value, (low, high) in zip(place, ends, strict=True):
        room = _APART + 0.1 * (high - low)
        if not low - room <= value <= high + room:  # NaN: no interval holds it
            return True
    return False


class _Arrived(Exception):  # noqa: N818 - no error, the way out of a search
    """A search has come to a fit that is known."""


def find(residuals: Residuals, own: Floats, starts: int, seed: int) -> Found:
    """Return the fits that are found from `own` (1, D) and other starts. Raises NotFitted.

    Of those that are equally good the nearest to `own` is the best, so that no seed decides.
    """
    from scipy.stats import qmc

    count = max(1, math.ceil(math.log2(max(starts, 2))))
    points = qmc.Sobol(own.shape[1], rng=np.random.default_rng(seed)).random_base2(count)
    table = np.concatenate([own, points])
    if own.shape[1] == 1:
        table = _to_the_ends(table[:, 0])[:, None]
    found, costs = _scan(residuals, table)
    if not np.isfinite(costs).any():
        raise NotFitted(_none_words(residuals))
    # A run that breaks must never look better than one that only lies far off.
    residuals.lost = max(LOST, 10.0 * float(np.abs(found[np.isfinite(found)]).max()))
    search = _Search(residuals)
    if own.shape[1] == 1:
        search.along(table, found, costs)
    else:
        for start in _several(table, costs):
            search.follow(table[start], float(costs[start]))
        middle, _ = min(search.places, key=lambda one: one[1])
        for axis in range(len(middle)):
            shares = _to_the_ends(np.append(table[:, axis], middle[axis]))
            line = np.tile(middle, (len(shares), 1))
            line[:, axis] = shares
            search.along(line, *_scan(residuals, line))
    least = min(square for _, square in search.places)
    equal = least + _EQUAL * least + 2.0 * residuals.nothing
    best = min(
        (one for one in search.places if one[1] <= equal),
        key=lambda one: (round(float(np.abs(one[0] - own[0]).max()) / _APART), one[1]),
    )
    near = 1.01 * least + 2.0 * residuals.nothing
    worse = sum(square > near for square in search.ends)
    return Found(best[0], best[1], tuple(search.places), worse, len(search.ends))


def _none_words(residuals: Residuals) -> str:
    """Return why no start gave a number."""
    if residuals.without:
        names, one = " and ".join(residuals.without), len(residuals.without) == 1
        return (
            f"{names} {'has' if one else 'have'} no value in runs that ended well, so that nothing can be "
            "fitted: a rope that has left an obstacle, or pulls nothing on one side of it, has no ratio "
            "there. Measure at a time at which there is a value, or something else"
        )
    return (
        "every start broke: no run ended well anywhere in the ranges that were tried; "
        f"the first: {residuals.reason or 'no number came of it'}"
    )


def _scan(residuals: Residuals, table: Floats) -> tuple[Floats, Floats]:
    """Return residuals (N, m) and sums of squares (N,), infinite where a run breaks."""
    found = residuals.found(table)
    costs = (found**2).sum(axis=1)
    return found, np.where(np.isfinite(costs), costs, math.inf)


class _Search:
    """Searches from starts, with what they found."""

    def __init__(self, residuals: Residuals) -> None:
        self._residuals = residuals
        self.places: list[tuple[Floats, float]] = []
        self.ends: list[float] = []  # sums of squares, one for each search

    def follow(self, start: Floats, square: float) -> Floats:
        """Return where the search from a start of this sum of squares ends."""
        from scipy.optimize import least_squares

        # In units of where it begins: gtol is absolute, and would take a small unit's start for the end.
        size, known = math.sqrt(square) or 1.0, list(self.places)
        arrived: list[tuple[Floats, float]] = []

        def jacobian(share: Floats) -> Floats:
            for place, cost in known:
                if np.abs(share - place).max() < _ONE:
                    arrived.append((place, cost))
                    raise _Arrived
            return self._residuals.jacobian(share) / size

        try:
            fit = least_squares(
                lambda share: self._residuals.one(share) / size, np.clip(start, 1e-6, 1.0 - 1e-6),
                jacobian, bounds=(0.0, 1.0), xtol=1e-10, ftol=1e-12, gtol=1e-12, max_nfev=60,
            )  # fmt: skip
        except _Arrived:
            place, cost = arrived[0]
        else:
            place, cost = np.asarray(fit.x), 2.0 * float(fit.cost) * size**2
            self.places.append((place, cost))
        self.ends.append(cost)
        return place

    def along(self, line: Floats, found: Floats, heights: Floats) -> None:
        """Search a row of starts (N, D) along one of the values: from every least cost of it.

        A fit between two starts of one value is reached from both: two that lie between them are both found.
        Residuals (N, m) that pass zero between two starts do so somewhere, however the costs lie.
        """
        for at in _hollows(heights):
            place = self.follow(line[at], float(heights[at]))
            for across in _across(line[:, 0], at, float(place[0])) if line.shape[1] == 1 else ():
                if np.isfinite(heights[across]):
                    self.follow(line[across], float(heights[across]))
        for at in _passed(found):
            for start in sorted((at, at + 1), key=lambda i: float(heights[i])):
                if not any(_between(place, line[at], line[at + 1]) for place, _ in self.places):
                    self.follow(line[start], float(heights[start]))


def _between(place: Floats, low: Floats, high: Floats) -> bool:
    """Tell whether a place lies between two starts, but for what is one place anyway."""
    return bool(((place > low - _ONE) & (place < high + _ONE)).all())


def _passed(found: Floats) -> list[int]:
    """Return after which starts residuals (N, m) pass their least, if it is straight on to the next."""
    before, after = found[:-1], found[1:]
    step = after - before
    inside = ((before * step).sum(axis=1) < 0.0) & ((after * step).sum(axis=1) > 0.0)
    lowest = np.abs(np.where(inside[:, None], before, np.inf)).sum(axis=1)
    at = np.argsort(lowest, kind="stable")
    return [int(i) for i in at if inside[i]][:_MOST]


def _hollows(heights: Floats) -> list[int]:
    """Return where a row of costs is least among its neighbours, the least first; `_MOST` at most."""
    before = np.concatenate([[math.inf], heights[:-1]])
    after = np.concatenate([heights[1:], [math.inf]])
    at = np.flatnonzero(np.isfinite(heights) & (heights < before) & (heights <= after))
    if not at.size:  # a first one that is as good as what comes before
        at = np.array([int(np.argmin(heights))])
    return [int(i) for i in at[np.argsort(heights[at], kind="stable")][:_MOST]]


def _across(line: Floats, at: int, place: float) -> Iterator[int]:
    """Yield the starts that lie across a place from the one at which its search began."""
    if place > line[at] - _ONE and at + 1 < len(line):
        yield at + 1
    if place < line[at] + _ONE and at > 0:
        yield at - 1


def _several(table: Floats, costs: Floats) -> list[int]:
    """Return the best starts (N, D), and those that are the best among their neighbours."""
    order = [int(i) for i in np.argsort(costs, kind="stable") if np.isfinite(costs[i])]
    near = 2 * table.shape[1]
    hollows = [
        i
        for i in order
        if costs[i] <= costs[np.argsort(((table - table[i]) ** 2).sum(axis=1))[: near + 1]].min()
    ]
    rest = [i for i in order if i not in hollows]
    return hollows[:_MOST] + rest[: max(0, _FEWEST - len(hollows))]
