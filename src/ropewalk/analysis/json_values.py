"""Values as JSON can carry them."""

from __future__ import annotations

import math
from typing import Any


def plain(value: Any) -> Any:
    """Return a value that JSON can carry: numbers that are not finite become None."""
    if isinstance(value, dict):
        return {key: plain(item) for key, item in value.items()}
    if isinstance(value, (list, tuple)):
        return [plain(item) for item in value]
    if hasattr(value, "dtype"):  # numpy's numbers, without waiting for numpy
        value = value.item()
    return None if isinstance(value, float) and not math.isfinite(value) else value
