"""A new law of segments is one file and its entry: a sample, put into a copy of the package, acts everywhere.

In every method, at rest, in modes, books, columns, recorded tensions and the bound of the step. The copy
differs from the package by that file and an import and a name in `laws/registry.py`; all else is asked of a
field of the rope, which stands outside of the package. Run as plain Python; compiled kernels give the same
bits (slow).
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

EMPTY = "SEGMENT_LAWS: tuple[NodeLaw, ...] = ()"
K, L, CUBIC, ARM, TIME, MASS = 30.0, 0.25, 900.0, 20.0, 0.03, 0.05
RUBS = 0.02  # [N s/m]
SAMPLE = Sample(
    "fibre",
    "sample_segment_law.py",
    "sample_segment_runs.py",
    (EMPTY, EMPTY.replace("()", "(FIBRE,)")),
)


def stored(x: np.ndarray) -> float:
    """U of the fibres without arms at places (3, n) [J]."""
    e = np.sqrt((np.diff(x, axis=1) ** 2).sum(axis=0)) - L
    return float((0.25 * CUBIC * e**4).sum())


def test_what_was_touched(package: Path) -> None:
    """One new file, and two lines of one other."""
    new, lines = added.touched(package)
    assert new == [str(Path("laws/fibre.py"))]
    assert lines == {str(Path(added.LIST)): 2}


@pytest.mark.parametrize("method", METHODS)
def test_it_acts_in_every_method(method: str, found: dict[str, Any]) -> None:
    """All come to the same places, and the books close. The twin: the rope without it is elsewhere."""
    exact, own = np.array(found["methods"]["rk4"]["x"]), found["methods"][method]
    assert np.abs(np.array(own["x"]) - exact).max() < 1.5e-3
    assert np.abs(np.array(found["without"]["x"]) - exact).max() > 8e-3
    assert abs(own["unbooked"]) < 1e-12
    assert own["drawn"] < 0.0
    assert own["names"][-1] == "fibre"
    assert own["touched"] == 0  # it is no contact


def test_its_work_is_what_it_stores(found: dict[str, Any]) -> None:
    """Without an arm it is that of the fibres. The twin: with one it is far more."""
    own, twin = found["elastic"], found["methods"]["rk4"]
    assert own["drawn"] == pytest.approx(-stored(np.array(own["x"])), rel=1e-3)
    assert twin["drawn"] < -3.0 * stored(np.array(twin["x"]))
    assert stored(np.array(own["x"])) > 1e-3


def test_beside_another_rope(found: dict[str, Any]) -> None:
    """In an island of its own a rope moves as alone, and one without the law as without it."""
    two = np.array(found["two"]["x"])
    assert np.array_equal(two[:, :5], np.array(found["alone"]["x"]))
    assert np.abs(two[0, 5:] - np.array(found["without"]["x"])[0]).max() < 1e-5
    assert abs(found["two"]["unbooked"]) < 1e-12


@pytest.mark.parametrize("method", ["verlet", "rk4", "implicit-euler", "adaptive"])
def test_it_relaxes_as_in_closed_form(method: str, found: dict[str, Any]) -> None:
    """Drawn at w from its length, T = k w t + a (w t)^3 + b w tau (1 - exp(-t / tau)) + c w.

    To rounding, for the length is linear in time. It is what is recorded as tension, and as its greatest; the
    spring's share is told apart.
    """
    own, w, t = found["pulled"][method], 0.5, 0.1
    pull = CUBIC * (w * t) ** 3 + ARM * w * TIME * (1.0 - math.exp(-t / TIME))
    assert own["elastic"] == pytest.approx([K * w * t], rel=1e-12)
    assert own["tension"] == pytest.approx([K * w * t + pull + RUBS * w], rel=1e-12)
    assert own["highest"] == pytest.approx(own["tension"], rel=1e-12)


def test_it_carries_at_rest_and_stiffens_modes(found: dict[str, Any]) -> None:
    """k e + a e^3 = m g: the arm has relaxed. The mass swings and bounces about there, and stays."""
    own, load = found["hanging"], MASS * 9.81
    e = own["length"] - L
    assert e == pytest.approx(min(np.roots([CUBIC, 0.0, K, -load]), key=lambda z: abs(z.imag)).real)
    assert own["tension"] == pytest.approx(load, rel=1e-9)
    assert own["elastic"] == pytest.approx(K * e, rel=1e-9)
    squares = np.array([9.81 / own["length"]] * 2 + [(K + 3.0 * CUBIC * e**2) / MASS])
    damped = np.sqrt(squares - (0.5 * RUBS / MASS) ** 2) / (2.0 * math.pi)
    assert own["frequencies"] == pytest.approx(damped, rel=1e-9)
    assert own["stays"] < 1e-9


def test_the_bound_of_the_step_knows_it(found: dict[str, Any]) -> None:
    """A stiff arm decides: below the bound nodes stay slow, above it they are lost."""
    near, far = found["bound"]["speeds"]
    assert near < 0.1
    assert far > 100.0 or not math.isfinite(far)
    largest = math.sqrt(2.0 - 2.0 * math.cos(0.8 * math.pi)) * math.sqrt((K + 5e3) / MASS)
    assert found["bound"]["most"] == pytest.approx(2.0 / largest, rel=0.01)


def test_a_winch_is_refused(found: dict[str, Any]) -> None:
    assert "has fibre, with which a winch cannot wind it" in found["refused"]


def test_newton_converges_quadratically_with_its_tangent(
    found: dict[str, Any], tmp_path: Path
) -> None:
    """The order of convergence, see `test_implicit`. The twin: a tangent of 0.8 of its slope."""
    right = found["newton"]
    wrong = SAMPLE.run(SAMPLE.wrong(tmp_path), "newton")
    assert len(right) > 5
    assert len(wrong) > 2 * len(right)
    assert np.median(right) > 1.6
    assert np.median(wrong) < 1.1


@pytest.mark.slow
def test_compiled_it_has_the_same_bits(package: Path) -> None:
    assert SAMPLE.run(package, "small", compiled=True) == SAMPLE.run(package, "small")
