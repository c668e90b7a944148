"""A new law of nodes is one file and its entry: a sample, put into a copy of the package, acts everywhere.

In explicit and implicit methods, in statics, modes, books, columns and the bound of
the step. The copy differs from the package by that file and an import and a name in `laws/registry.py`, all
else is asked of its scene section, which stands outside of the package. Run as plain Python; compiled kernels
give the same bits (slow).
"""

from __future__ import annotations

import math
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from ropewalk.methods.registry import METHODS
from verification import added
from verification.added import Sample

ENTRY = "(AIR, GROUND, OBSTACLE, CONTACT, PARTING, SLIDE, *SEGMENT_LAWS)"
SAMPLE = Sample(
    "well",
    "sample_law.py",
    "sample_runs.py",
    (ENTRY, ENTRY.replace("*SEGMENT_LAWS", "*SEGMENT_LAWS, WELL")),
)


def places(found: dict[str, Any], name: str) -> np.ndarray:
    return np.array(found[name]["x"])


def potential(x: np.ndarray, k: float = 40.0, s: float = 2.0) -> float:
    """U of all nodes [J], (3, n)."""
    square = ((x - np.array([0.3, 0.1, 0.2])[:, None]) ** 2).sum(axis=0)
    return float((k * (square / 2 + s * square**2 / 4)).sum())


def test_what_was_touched(package: Path) -> None:
    """One new file, and two lines of one other."""
    new, lines = added.touched(package)
    assert new == [str(Path("laws/well.py"))]
    assert lines == {str(Path(added.LIST)): 2}


def test_tables_channels_and_columns_have_its_name(found: dict[str, Any]) -> None:
    """Its work is recorded between those of the other laws of nodes and the applied forces'."""
    assert found["names"] == ["air", "ground", "obstacle", "contact", "parting", "slide", "well"]
    assert found["laws"].index("well") == found["laws"].index("ground") + 1
    assert found["table"][:2] == ["active", "point"]


@pytest.mark.parametrize("method", METHODS)
def test_it_acts_in_every_method(method: str, found: dict[str, Any]) -> None:
    """All come to the same places, and the books close: its work is what its potential lost, and nothing
    of the kinetic energy is unbooked. The twin: the rope without it is elsewhere.

    Euler's methods, which damp or drive, are extrapolated from two steps (Richardson).
    """
    exact, own, drawn = places(found, "verlet"), places(found, method), found[method]["drawn"]
    if method in (coarse := found["coarse"]):
        own, drawn = 2.0 * own - places(coarse, method), 2.0 * drawn - coarse[method]["drawn"]
    assert np.abs(own - exact).max() < 1e-3
    assert np.abs(own - places(found, "without")).max() > 0.3
    assert drawn == pytest.approx(found["start"] - potential(own), abs=5e-2)
    assert abs(found[method]["unbooked"]) < 1e-12 * found["start"]
    assert found["without"]["drawn"] == 0.0


def test_a_rope_beside_another_and_one_that_is_held(found: dict[str, Any]) -> None:
    """In an island of its own a rope moves as alone; an anchor's reaction knows of the law."""
    assert np.array_equal(places(found, "two")[:, :5], places(found, "esdirk3"))
    assert abs(found["anchored"]["unbooked"]) < 1e-12 * found["start"]
    assert abs(found["two"]["unbooked"]) < 1e-12 * found["start"]


def test_it_holds_at_rest(found: dict[str, Any]) -> None:
    """sum k (x - p) = sum m g: a rope that nothing else holds hangs below the point by m g / k."""
    assert found["held"]["middle"] == pytest.approx([0.3, 0.1, 0.2 - 0.05 * 9.81 / 40.0], abs=1e-9)


def test_it_rings(found: dict[str, Any]) -> None:
    """As one, in all three directions, the rope swings at sqrt(k / m)."""
    own = math.sqrt(40.0 / 0.05) / (2.0 * math.pi)
    assert int((np.abs(np.array(found["held"]["frequencies"]) - own) < 1e-9 * own).sum()) == 3


def test_the_bound_of_the_step_knows_it(found: dict[str, Any]) -> None:
    """A heavy well decides, 2 / sqrt(k / m): below the bound nodes stay near, above it they are lost."""
    near, far = found["bound"]["far"]
    assert near < 1.5
    assert far > 1e3
    assert found["bound"]["most"] < 2.0 / math.sqrt(5e4 / 0.05) * 1.01


def test_newton_converges_quadratically_with_its_tangent(
    found: dict[str, Any], tmp_path: Path
) -> None:
    """The order of convergence, see `test_implicit`. The twin: a tangent of 0.8 of its stiffness."""
    right = found["newton"]
    wrong = SAMPLE.run(SAMPLE.wrong(tmp_path), "newton")
    assert len(right) > 5
    assert len(wrong) > 2 * len(right)
    assert np.median(right) > 1.6
    assert np.median(wrong) < 1.1


@pytest.mark.slow
def test_compiled_it_has_the_same_bits(package: Path) -> None:
    assert SAMPLE.run(package, "small", compiled=True) == SAMPLE.run(package, "small")
