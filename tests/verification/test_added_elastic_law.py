"""A new elastic law is one file and its entry: a sample, put into a copy of the package, acts everywhere.

In every method, at rest, in modes, books, recorded tensions and extremes, the bound of the step and what
`check` says, beside a winch, with a memory. The copy differs from the package by that file and an import and
a name in `laws/registry.py`; its section is a field of the rope, outside of the package. Run as plain Python;
compiled kernels give the same bits (slow).
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

ENTRY = "(CURVE, SOLID)"
K, L, MASS, RUBS = 30.0, 0.25, 0.05, 0.02  # N/m, m, kg, N s/m
BEND, ARM, TIME = 4.0, 0.4, 0.03  # 1, 1, s
SAMPLE = Sample(
    "soft",
    "sample_elastic_law.py",
    "sample_elastic_runs.py",
    (ENTRY, ENTRY.replace(")", ", SOFT)")),
)


def softened(strain: Any) -> Any:
    """h of the sample law [1], which is e - b h^2."""
    return np.where(
        strain > 0.0, (np.sqrt(1.0 + 4.0 * BEND * np.abs(strain)) - 1.0) / (2.0 * BEND), strain
    )


def stored(x: np.ndarray) -> float:
    """U of segments without arms at places (3, n) [J], EA L times the integral of h."""
    strain = np.sqrt((np.diff(x, axis=1) ** 2).sum(axis=0)) / L - 1.0
    h = softened(strain)
    return float((K * L * L * (0.5 * h**2 + np.where(h > 0.0, 2.0 / 3.0 * BEND * h**3, 0.0))).sum())


def test_what_was_touched(package: Path) -> None:
    """One new file, and two lines of one other."""
    new, lines = added.touched(package)
    assert new == [str(Path("laws/soft.py"))]
    assert lines == {str(Path(added.LIST)): 2}


@pytest.mark.parametrize("method", METHODS)
def test_it_acts_in_every_method(method: str, found: dict[str, Any]) -> None:
    """All come to the same places, and the books close. The twin: the rope without it is elsewhere."""
    exact, own = np.array(found["exact"]["x"]), found["methods"][method]
    assert np.abs(np.array(own["x"]) - exact).max() < 1.5e-3
    assert np.abs(np.array(found["without"]["x"]) - exact).max() > 1.5e-2
    assert abs(own["unbooked"]) < 1e-13


@pytest.mark.parametrize(
    ("method", "order"),
    [("rk4", 4), ("heun", 2), ("verlet", 2), ("sdirk2", 2), ("bdf2", 2), ("esdirk3", 3)],
)
def test_methods_keep_their_order(method: str, order: int, found: dict[str, Any]) -> None:
    """With what the law remembers."""
    assert found["orders"][method] == pytest.approx(order, abs=0.25)


def test_what_is_stored(found: dict[str, Any]) -> None:
    """Without an arm it is that of the law. The twin: Hooke's is far more."""
    own = found["elastic"]
    x = np.array(own["x"])
    assert own["stored"][1] == pytest.approx(stored(x), rel=1e-12)
    assert own["stored"][1] - own["stored"][0] == pytest.approx(-own["work"], rel=1e-5)
    r = np.sqrt((np.diff(x, axis=1) ** 2).sum(axis=0))
    assert 0.5 * K * ((r - L) ** 2).sum() > 1.1 * stored(x)


def test_beside_another_rope(found: dict[str, Any]) -> None:
    """In an island of its own a rope moves as alone, and one without the law as without it."""
    two = np.array(found["two"]["x"])
    assert np.array_equal(two[:, :5], np.array(found["methods"]["esdirk3"]["x"]))
    assert np.abs(two[0, 5:] - np.array(found["without"]["x"])[0]).max() < 1e-5


@pytest.mark.parametrize(
    ("method", "error"),
    [("verlet", 1e-5), ("rk4", 1e-7), ("implicit-euler", 1e-3), ("adaptive", 1e-6)],
)
def test_it_relaxes_as_in_closed_form(method: str, error: float, found: dict[str, Any]) -> None:
    """Drawn at w from its length, T = EA ((1 - a) h(w t) + a w tau (1 - exp(-t / tau))) + c w.

    It is what is recorded as tension, and as its greatest.
    """
    own, w, t = found["pulled"][method], 0.5 / L, 0.1
    pull = (1.0 - ARM) * softened(w * t) + ARM * w * TIME * (1.0 - math.exp(-t / TIME))
    assert own["elastic"] == pytest.approx([K * L * pull], rel=error)
    assert own["tension"] == pytest.approx([K * L * pull + RUBS * 0.5], rel=error)
    assert own["highest"] == pytest.approx(own["tension"], rel=1e-12)


def test_rest_modes_and_waves(found: dict[str, Any]) -> None:
    """EA (1 - a) h = m g: the arm has relaxed. The mass swings and bounces about there, and stays."""
    own, load = found["hanging"], MASS * 9.81
    e = own["length"] / L - 1.0
    assert K * L * (1.0 - ARM) * softened(e) == pytest.approx(load, rel=1e-9)
    assert own["tension"] == pytest.approx(load, rel=1e-9)
    slope = (1.0 - ARM) / math.sqrt(1.0 + 4.0 * BEND * e)
    squares = np.array([9.81 / own["length"]] * 2 + [K * slope / MASS])
    damped = np.sqrt(squares - (0.5 * RUBS / MASS) ** 2) / (2.0 * math.pi)
    assert own["frequencies"] == pytest.approx(damped, rel=1e-9)
    assert own["stays"] < 1e-9
    waves = [L * math.sqrt(K * part / MASS) for part in (slope, slope + ARM)]
    assert own["waves"] == pytest.approx(waves, rel=1e-9)


def test_the_bound_of_the_step_knows_it(found: dict[str, Any]) -> None:
    """Small waves have the whole stiffness: below the bound nodes stay slow, above it they do not.

    It is that of springs without friction, but for the little that friction takes.
    """
    near, far = found["bound"]["speeds"]
    assert near < 1e-6
    assert far > 1e-3
    largest = math.sqrt(2.0 - 2.0 * math.cos(0.8 * math.pi)) * math.sqrt(K / MASS)
    assert found["bound"]["most"] == pytest.approx(2.0 / largest, rel=0.04)


def test_a_winch_pays_it_out(found: dict[str, Any]) -> None:
    """The books of motion close; it is elsewhere than the rope without the law."""
    own, other = (np.array(found[name]["x"]) for name in ("wound", "wound without"))
    assert abs(found["wound"]["unbooked"]) < 1e-13
    assert np.abs(own - other).max() > 5e-3


@pytest.mark.parametrize(
    ("what", "sentence"),
    [
        ("two", "has solid and soft, and its tension can obey one only"),
    ],
)
def test_what_is_refused(what: str, sentence: str, found: dict[str, Any]) -> None:
    """Two laws at once."""
    assert sentence in found["refused"][what]


def test_newton_converges_quadratically_with_its_tangent(
    found: dict[str, Any], tmp_path: Path
) -> None:
    """The order of convergence, see `test_implicit`. The twin: a tangent of 0.8 of its slope."""
    right = found["newton"]
    wrong = SAMPLE.run(SAMPLE.wrong(tmp_path), "newton")
    assert len(right) > 5
    assert len(wrong) > 5
    assert np.median(right) > 1.6
    assert np.median(wrong) < 1.1


@pytest.mark.slow
def test_compiled_it_has_the_same_bits(package: Path) -> None:
    assert SAMPLE.run(package, "small", compiled=True) == SAMPLE.run(package, "small")
