"""What a fit is worth: covariance, correlation, and which values a measurement cannot tell apart."""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence
from dataclasses import dataclass, replace

import numpy as np

from ropewalk.core.arrays import Floats

#: A value whose interval is wider than this share of its range is not determined.
_WIDE = 0.7
#: A direction in which the values are looser than this share of the ranges is not determined.
_LOOSE = 0.3
_PART = 0.25  # a value takes part in a direction with at least this share of it
_TIED = 0.98  # correlation of values that the measurement hardly tells apart
_TINY = 1e-12
_AT = 1e-3  # of the range: nearer to an end of it is at it
_UNSEEN = "{} does not show in this measurement."
_APART = (
    "Near this fit the measurement tells all of them apart. In {} no other fit was found, which is no proof "
    "that there is none."
)
_TURNS = (
    "{0} fits where the measurement turns: it hardly changes with {0} just there, so the interval from the "
    "covariance is too wide; that of the profile holds."
)


@dataclass(frozen=True)
class Findings:
    """The worth of a fit, in shares of the parameters' ranges."""

    deviation: Floats  # (D,) standard deviations; NaN where they cannot be told
    correlation: Floats  # (D, D)
    spread: float  # of the residuals [1]
    quantile: float  # of the interval, in standard deviations
    variance: float  # of the residuals: 1 for known errors, else estimated
    words: tuple[str, ...]


def identify(
    jacobian: Floats, residuals: Floats, known: bool, level: float, names: Sequence[str]
) -> Findings:
    """Return what the Jacobian (m, D) at the fit says.

    Covariance = variance times (J^T J)^-1; the variance is 1 for `known` errors, else what the residuals
    leave over m - D. Intervals are Student's then, else normal.
    """
    from scipy.stats import norm, t

    m, d = jacobian.shape
    free = m - d
    left = math.sqrt(float(residuals @ residuals) / free) if free > 0 else math.nan
    sigma = 1.0 if known else left
    share = 0.5 + 0.5 * level
    quantile = float(norm.ppf(share)) if known or free <= 0 else float(t.ppf(share, free))
    _, sizes, directions = np.linalg.svd(jacobian, full_matrices=True)
    sizes = np.concatenate([sizes, np.zeros(d - len(sizes))])
    floor = np.maximum(sizes, _TINY * max(float(sizes.max()), 1e-300))
    inverse = (directions.T / floor**2) @ directions
    deviation = sigma * np.sqrt(np.diag(inverse))
    outer = np.sqrt(np.outer(np.diag(inverse), np.diag(inverse)))
    correlation = inverse / outer
    words: list[str] = []
    variance = sigma**2
    if math.isnan(sigma):
        words.append(
            f"{m} number{'s' * (m != 1)} for {d} value{'s' * (d != 1)}: nothing is left to judge the fit by; "
            "give the error of the measurement for intervals."
        )
        sigma = 0.0
    words += _words(jacobian, sizes, directions, sigma * quantile, correlation, names)
    return Findings(deviation, correlation, left, quantile, variance, tuple(words))


def _words(
    jacobian: Floats,
    sizes: Floats,
    directions: Floats,
    scale: float,
    correlation: Floats,
    names: Sequence[str],
) -> list[str]:
    """Say which values do not show, or cannot be told apart."""
    told: list[str] = []
    strength = np.linalg.norm(jacobian, axis=0)
    least = max(scale / _WIDE, 1e-9 * float(strength.max()))
    unseen = {i for i in range(len(names)) if strength[i] <= least}
    told += [_UNSEEN.format(names[i]) for i in sorted(unseen)]
    tied: set[frozenset[int]] = set()
    for size, direction in zip(sizes, directions, strict=True):
        loose = size <= max(scale / _LOOSE, 1e-9 * float(sizes.max()))
        group = frozenset(i for i, v in enumerate(direction) if abs(v) >= _PART) - unseen
        if loose and len(group) > 1:
            tied.add(frozenset(group))
            told.append(f"{_listed(names, group)} cannot be told apart by this measurement.")
    for i in range(len(names)):
        for j in range(i):
            close = abs(correlation[i, j]) > _TIED and not {i, j} & unseen
            if close and not any({i, j} <= group for group in tied):
                told.append(
                    f"{_listed(names, {i, j})} are tied (correlation {correlation[i, j]:.3f}): what one "
                    "loses the other makes up."
                )
    return told


def with_turns(
    findings: Findings, names: Sequence[str], moves: Callable[[int], float]
) -> tuple[Findings, list[bool]]:
    """Return the findings, and which values do show, though not by their slopes at the fit.

    `moves` gives how much the residuals change at most, as a sum of squares, along the range of a value.
    """
    # What is unseen moves them at most by the threshold over `_WIDE` if its slope is the same all along.
    rise = 4.0 * findings.quantile**2 * findings.variance
    turns = [
        _UNSEEN.format(name) in findings.words and moves(i) > rise for i, name in enumerate(names)
    ]
    instead = {
        _UNSEEN.format(n): _TURNS.format(n) for n, turn in zip(names, turns, strict=True) if turn
    }
    words = tuple(instead.get(text, text) for text in findings.words)
    return replace(findings, words=words), turns


def verdict(
    words: Sequence[str],
    ends: Sequence[tuple[float, float]],
    names: Sequence[str],
    searches: int = 1,
    beyond: bool = False,
) -> tuple[str, ...]:
    """Return the words of a fit with what its intervals say of every value.

    Args:
        words: those of `identify`.
        ends: of the interval of every value, as shares of its range; NaN where it cannot be told.
        names: of the values.
        searches: that were made for other fits.
        beyond: the cutting into segments may put a value out of its interval: then none is determined.

    A value whose interval is cut by an end of its range, or takes up most of it, is not determined:
    there the range speaks, not the measurement.
    """
    told = list(words)
    for name, (low, high) in zip(names, ends, strict=True):
        at = [word for word, hit in (("lower", low < _AT), ("upper", high > 1.0 - _AT)) if hit]
        if _UNSEEN.format(name) in words:
            continue
        if len(at) == 2:
            told.append(f"{name} is not determined: its interval spans its range.")
        elif at:
            told.append(
                f"{name} is not determined: its interval ends at the {at[0]} end of its range."
            )
        elif high - low > _WIDE:
            told.append(f"{name} is not determined: its interval spans most of its range.")
    if not told and np.isfinite(ends).all() and not beyond:
        alone = f"The measurement determines {names[0]}."
        made = f"{searches} search{'es' * (searches != 1)}"
        told.append(_APART.format(made) if len(names) > 1 else alone)
    return tuple(told)


def _listed(names: Sequence[str], group: set[int] | frozenset[int]) -> str:
    words = [names[i] for i in sorted(group)]
    return f"{', '.join(words[:-1])} and {words[-1]}"
