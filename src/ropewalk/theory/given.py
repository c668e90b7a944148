"""What a closed form may be given."""

from __future__ import annotations

import math


def need(name: str, value: float, unit: str) -> None:
    """Raise ValueError unless a value is positive and finite."""
    if not (math.isfinite(value) and value > 0.0):
        of = "" if unit == "1" else f" of {unit}"
        raise ValueError(f"{name}: {value!r} - must be a positive number{of}")


def need_stiff(EA: float) -> None:
    """Raise ValueError unless EA is positive; inf stands for an inextensible cable."""
    if not EA > 0.0:
        raise ValueError(f"EA: {EA!r} - must be a positive number of N, or inf")


def need_ends(across: float, rise: float) -> None:
    """Raise ValueError unless the ends are at finite places, the second one not behind the first."""
    if not (math.isfinite(across) and across >= 0.0):
        raise ValueError(f"across: {across!r} - must be a number of m, not negative")
    if not math.isfinite(rise):
        raise ValueError(f"rise: {rise!r} - must be a finite number of m")
