"""Golden states: a change of code that changes no physics changes no bits.

Other tests compare a program with itself or with formulas to a tolerance; these find what both let pass.
"""

from __future__ import annotations

import json

import numpy as np
import pytest

from golden.states import ROUNDING, final, laws, machine, path
from ropewalk.methods.registry import METHODS


def misfit(found: dict, kept: dict) -> float:
    """Return the largest difference of places and speeds, over the largest of each [1]."""
    errors = [0.0]
    for name in ("x", "v"):
        a, b = np.array(found[name]), np.array(kept[name])
        errors.append(float(np.abs(a - b).max() / np.abs(b).max()))
    return max(errors)


@pytest.mark.parametrize("method", METHODS)
@pytest.mark.parametrize("law", laws())
def test_golden_state(law: str, method: str) -> None:
    """The bits of the machine that wrote them; on another one the numbers to rounding.

    The twin: one step later they differ by far more.
    """
    kept = json.loads(path(method).read_text(encoding="utf-8"))
    found = final(law, method)
    assert found.keys() == kept[law].keys(), f"{law} with {method}: refused before or now"
    if "refused" in found:
        assert found == kept[law]
        return
    assert misfit(found, kept[law]) <= ROUNDING
    if kept["machine"] == machine():
        assert found["bits"] == kept[law]["bits"]
    assert misfit(final(law, method, frames=7), kept[law]) > 1e3 * ROUNDING
