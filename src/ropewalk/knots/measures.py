"""Numbers that a knot is given: what is none, or cannot be, is refused by name."""

from __future__ import annotations

import math
import numbers
from typing import Any


def number(name: str, value: Any, unit: str = "m") -> float:
    """Return a number of `unit`, also one of numpy, as it was given.

    Raises ValueError for anything else: a text, a truth value, nothing, nan.
    """
    plain = isinstance(value, numbers.Real) and not isinstance(value, bool)
    if not plain or math.isnan(value):
        of = "" if unit == "1" else f" of {unit}, without a unit, such as 0.01"
        raise ValueError(f"{name}: {value!r} - must be a number{of}")
    return float(value)


def number_or_none(name: str, value: Any, unit: str = "m") -> float | None:
    """Return a number as `number` does, or None."""
    return None if value is None else number(name, value, unit)


def whole(name: str, value: Any) -> int:
    """Return a whole number from 1 on, also one of numpy. Raises ValueError for anything else."""
    plain = isinstance(value, numbers.Integral) and not isinstance(value, bool)
    if not plain or value < 1:
        raise ValueError(f"{name}: {value!r} - must be a whole number, 1 or more")
    return int(value)
