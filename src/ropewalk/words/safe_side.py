"""Numbers for people that are bounds: rounded to the safe side, never to the nearest."""

from __future__ import annotations

import math

from ropewalk.words.percents import percent

_EXACT = 1e-12  # [1] what a product of such numbers may be off by rounding, and a bound with it
_SOLVED = 1e-9  # [1] what a number that was solved for may be off


def rounded_down(value: float, figures: int = 3) -> str:
    """Return a positive number with so many figures, never above it."""
    if not math.isfinite(value) or value <= 0.0:
        return f"{value:g}"
    unit = 10.0 ** (math.floor(math.log10(value)) - figures + 1)
    whole = math.floor(value / unit * (1.0 + _EXACT))
    return f"{float(f'{whole * unit:.{figures}g}'):.10g}"


def rounded_up(value: float, figures: int = 3) -> str:
    """Return a positive number with so many figures, never below it."""
    if not math.isfinite(value) or value <= 0.0:
        return f"{value:g}"
    unit = 10.0 ** (math.floor(math.log10(value)) - figures + 1)
    whole = math.ceil(value / unit * (1.0 - _EXACT))
    return f"{float(f'{whole * unit:.{figures}g}'):.10g}"


def percent_up(value: float, figures: int = 2) -> str:
    """Return a number of per cent that is not negative as `percent` does, never below it."""
    bound = value * (1.0 - _SOLVED)
    whole = len(f"{bound:.0f}")  # digits before the point stand all
    return percent(float(rounded_up(bound, max(figures, whole))), figures)


def times_up(utilisation: float) -> str:
    """Return a utilisation [1] as so many times the breaking load, never below it."""
    return rounded_up(utilisation * (1.0 - _SOLVED))


def safety_factor(utilisation: float) -> str:
    """Return the inverse of a utilisation greater than 0 [1], never above it."""
    return rounded_down((1.0 + _SOLVED) / utilisation)


def outwards(least: float, most: float, figures: int = 4) -> tuple[float, float]:
    """Return the bounds of a range with so many figures, neither inside it; both the upper where they agree.

    They agree where they are the same when rounded to the nearest.
    """
    high = float(rounded_up(most * (1.0 - _SOLVED), figures))
    if f"{least:.{figures}g}" == f"{most:.{figures}g}":
        return high, high
    return float(rounded_down(least * (1.0 + _SOLVED), figures)), high


def inwards(least: float, most: float, figures: int = 4) -> tuple[str, str]:
    """Return the bounds of a range, neither outside it: with more figures where so many would cross."""
    for more in (figures, 6, 9):
        low, high = rounded_up(least, more), rounded_down(most, more)
        if float(low) <= float(high):
            break
    return low, high


def within(least: float, value: float, most: float) -> bool:
    """Tell whether a number is in a range, none negative: bounds as told may be off by rounding."""
    return least * (1.0 - _EXACT) <= value <= most * (1.0 + _EXACT)


def longest_step(seconds: float) -> str:
    """Return the largest step that is stable, or allowed, in milliseconds: never above it."""
    if math.isinf(seconds):
        return "unlimited"
    return "0" if seconds == 0.0 else f"{rounded_down(1e3 * seconds, 4)} ms"
