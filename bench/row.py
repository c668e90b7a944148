"""One measured number."""

from __future__ import annotations

from typing import NamedTuple


class Row(NamedTuple):
    """One measured number."""

    case: str
    value: float
    unit: str
    target: str
