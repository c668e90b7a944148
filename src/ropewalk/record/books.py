"""Works as they are told: none without a ledger, those of contacts since the start."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from ropewalk.core.arrays import Floats
from ropewalk.record.quantities import CONTACT_WORK, WORKS

if TYPE_CHECKING:
    from ropewalk.record.result import Result


def told(result: Result, name: str, array: Floats) -> Floats:
    """Return frames of a quantity as they are told, from the `array` that was recorded of them.

    Works [J] are NaN of a run without a ledger, where zeros stand. What contacts have stored at the start,
    which their books have, is no work; nor is what they have of earlier parts of a live session.
    """
    if name not in WORKS:
        return array
    if not result.facts.ledger:
        return np.full(array.shape, np.nan)
    return array - result.read(name, 0, 1) if name == CONTACT_WORK else array
