"""Whether a model fits at all: the residuals against the error that was stated, and their signs."""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence

import numpy as np

from ropewalk.core.arrays import Floats
from ropewalk.sweeps.measurements import Measurement

#: Odds below which chance is no explanation.
_RARE = 1e-3
_SIGNIFICANT = 0.01  # of rows of signs, which are a weaker sign of a misfit
_FEWEST = 8  # numbers in a row that are worth looking at
ROUNDING = 1e-7  # residuals below this share of what is measured are no errors of a measurement


def misfit(
    measurements: Sequence[Measurement], predicted: Sequence[Floats], fitted: int
) -> tuple[str, ...]:
    """Say in words how well a fit of `fitted` values predicts what was measured.

    With stated errors by chi-square: the sum of (residual / error)^2 has m - D degrees of freedom. Without
    them the residuals set the error, so only their order can tell: rows of one sign.
    """
    left = [p - m.values for m, p in zip(measurements, predicted, strict=True)]
    free = sum(part.size for part in left) - fitted
    if measurements[0].error is None:
        return _unstated(measurements, left, free)
    parts = [r / (m.error or 1.0) for m, r in zip(measurements, left, strict=True)]
    return (*_against_errors(measurements, parts, free), *_rows(measurements, left))


def _against_errors(
    measurements: Sequence[Measurement], parts: Sequence[Floats], free: int
) -> tuple[str, ...]:
    from scipy.stats import chi2

    total = sum(float(part @ part) for part in parts)
    count = sum(part.size for part in parts)
    if free <= 0:  # as many values as numbers: they should be met
        size = math.sqrt(total / count)
        told = f"The model does not fit: residuals are {size:.2g} times the stated uncertainty."
        return (told,) if size > 3.0 else ()
    size = math.sqrt(total / free)
    facts = f"(reduced chi-square {total / free:.3g}, {free} degree{'s' * (free > 1)} of freedom)"
    if chi2.sf(total, free) < _RARE:
        worst = ""
        if len(parts) > 1:
            each = [math.sqrt(float(part @ part) / part.size) for part in parts]
            place = int(np.argmax(each))
            worst = f" Worst is {measurements[place].name}, {each[place]:.2g} times."
        return (
            f"The model does not fit: residuals are {size:.2g} times the stated uncertainty {facts}.{worst} "
            "The intervals take the model for right, so they are too narrow.",
        )
    if chi2.cdf(total, free) < _RARE:
        return (
            f"Residuals are only {size:.2g} times the stated uncertainty {facts}: it is stated too large, or "
            "the numbers are not independent.",
        )
    return (f"The model fits: residuals are {size:.2g} times the stated uncertainty {facts}.",)


def _unstated(
    measurements: Sequence[Measurement], left: Sequence[Floats], free: int
) -> tuple[str, ...]:
    """Say what is assumed where no error was stated, and what the signs of the residuals tell."""
    if free <= 0:
        return ()
    size = math.sqrt(sum(float(part @ part) for part in left) / free)
    told = (
        f"No uncertainty was stated: it is taken from the residuals, {size:.3g} {measurements[0].unit}, as "
        "if the model were right and the errors independent; whether it fits cannot be told by their size."
    )
    return (told, *_rows(measurements, left))


def _rows(measurements: Sequence[Measurement], left: Sequence[Floats]) -> tuple[str, ...]:
    """Say of residuals that keep their sign for long: what is left then has a pattern."""
    told = []
    for measured, part in zip(measurements, left, strict=True):
        if float(np.abs(part).max()) <= ROUNDING * size_of(measured):
            continue
        sections = list(_sections(measured, part))
        odds = [runs_of_signs(section) for section in sections]
        if not odds:
            continue
        rows, chance = min(odds, key=lambda one: one[1])
        if chance * len(odds) < _SIGNIFICANT:
            told.append(
                f"Residuals of {measured.name} keep their sign in rows ({rows} of them, odds of chance "
                f"{chance * len(odds):.1g}): the model does not follow what was measured, or the errors are "
                "not independent. The intervals are too narrow then."
            )
    return tuple(told)


def size_of(measured: Measurement) -> float:
    """Size of what is measured, for rounding; an offset is small beside the places it comes from."""
    return max(float(np.abs(measured.values).max()), 1e-3)


def _sections(measured: Measurement, left: Floats) -> Iterator[Floats]:
    """Yield the residuals that follow one another: axis by axis, each in the order of its places."""
    if measured.at is None:
        cuts: list[int] = []
    else:
        cuts = (np.flatnonzero(np.diff(measured.at) < 0.0) + 1).tolist()
    for section in np.split(left, cuts):
        if section.size >= _FEWEST:
            yield section


def runs_of_signs(left: Floats) -> tuple[int, float]:
    """Return how many rows of one sign there are, and the chance of no more if signs are drawn.

    Source: Wald and Wolfowitz, Ann. Math. Stat. 11 (1940) 147; exact, given the numbers of both signs.
    """
    positive = left[left != 0.0] > 0.0
    if positive.size == 0:
        return 0, 1.0
    up = int(positive.sum())
    down = positive.size - up
    rows = 1 + int((positive[1:] != positive[:-1]).sum())
    if min(up, down) == 0:
        return 1, 2.0 ** (1 - positive.size)
    ways = 0
    for count in range(2, rows + 1):
        half = count // 2
        if count % 2 == 0:
            ways += 2 * math.comb(up - 1, half - 1) * math.comb(down - 1, half - 1)
        else:
            ways += math.comb(up - 1, half - 1) * math.comb(down - 1, half)
            ways += math.comb(up - 1, half) * math.comb(down - 1, half - 1)
    return rows, ways / math.comb(up + down, up)
