"""Numbers for people, with the SI prefix that suits: 26.77 kN."""

from __future__ import annotations

import math

_PREFIXES = (
    (1e9, "G"),
    (1e6, "M"),
    (1e3, "k"),
    (1.0, ""),
    (1e-3, "m"),
    (1e-6, "µ"),
    (1e-9, "n"),
    (1e-12, "p"),
)
_THOUSANDS = 1e4  # from here on k; four figures are read as easily without


def prefix_of(largest: float) -> tuple[float, str]:
    """Return the factor and the letter of the prefix for numbers up to this size; 1 and "" for 0 and inf."""
    if not 1e-12 <= largest < math.inf or 1.0 <= largest < _THOUSANDS:
        return 1.0, ""
    return next(p for p in _PREFIXES if largest >= p[0])


def prefixed(value: float, unit: str, figures: int = 4) -> str:
    """Return a number of so many figures with its unit: `26.77 kN`; numbers below 1 stay in the unit.

    Where it would need an exponent it has the next prefix: 1.23 kJ for 1234 J of three figures.
    """
    factor, prefix = prefix_of(abs(value)) if abs(value) >= 1.0 else (1.0, "")
    text = f"{value / factor:.{figures}g}"
    larger = [p for p in _PREFIXES if p[0] > factor]
    if "e+" in text and larger:
        factor, prefix = larger[-1]
        text = f"{value / factor:.{figures}g}"
    return f"{text} {prefix}{unit}"
