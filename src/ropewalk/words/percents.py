"""Per cents in sentences."""

from __future__ import annotations

_MOST = 1e6  # [%] beyond it a power of ten reads better than its digits


def percent(value: float, digits: int = 2, sign: str = "") -> str:
    """Return a number of per cent with so many digits: "0.23 %", and "104 %" where "g" has "1e+02 %".

    Args:
        value: in per cent [1].
        digits: how many count; those before the point stand all.
        sign: "+" also writes the sign of what is positive.
    """
    text = f"{value:{sign}.{digits}g}"
    return f"{value:{sign}.0f} %" if "e+" in text and abs(value) < _MOST else f"{text} %"
