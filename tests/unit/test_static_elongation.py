"""EA at rest from a data sheet's static elongation, which is counted from a preload."""

from __future__ import annotations

import numpy as np
import pytest

import ropewalk as rw
from ropewalk.scene import Straight
from ropewalk.theory import rope_at_rest

G = 9.81


def hung(made_of: rw.Material, masses: tuple[float, float]) -> float:
    """Elongation [1] of a rope at rest that is marked under one mass [kg] and hangs under another."""
    lengths = []
    for mass in masses:
        rope = rw.Rope(
            segments=1, length=1.5, made_of=made_of, loads=[rw.Load(node=-1, mass=mass)],
            shape=Straight(start=(0.0, 0.0, 0.0), end=(0.0, 0.0, -1.5)),
        )  # fmt: skip
        scene = rw.Scene(ropes=[rope], anchors=[rw.Anchor(node=0)])
        ends = rw.equilibrium(scene).positions[0, [0, -1]]
        lengths.append(float(np.linalg.norm(ends[1] - ends[0])))
    return lengths[1] / lengths[0] - 1.0


@pytest.mark.parametrize("stiffening", [0.0, 6.0])
def test_the_test_of_a_label_run_at_rest_gives_its_elongation(stiffening: float) -> None:
    """Marked under 5 kg, loaded with 80 kg, by the solver of equilibria; the rope's own mass left out."""
    made_of = rw.Material.from_fall(
        "8.464 kN", "33.15 %", 1e-3, static_elongation="7.85 %", stiffening=stiffening
    )
    assert hung(made_of, (5.0, 80.0)) == pytest.approx(0.0785, rel=1e-4)
    # Counted from the unloaded rope, as it was before, it would be 7 % more.
    assert hung(made_of, (1e-3, 80.0)) > 1.06 * 0.0785


def test_the_straight_line_has_a_closed_form() -> None:
    assert rope_at_rest(0.08, 80.0 * G) == pytest.approx((75.0 / 0.08 - 5.0) * G, rel=1e-12)
    assert rope_at_rest(0.08, 80.0 * G, preload=0.0) == pytest.approx(80.0 * G / 0.08, rel=1e-12)
    small = rope_at_rest(0.08, 80.0 * G, stiffening=1e-6)
    assert small == pytest.approx(rope_at_rest(0.08, 80.0 * G), rel=1e-6)


def test_one_strand_of_a_twin_rope_bears_half() -> None:
    """The same elongation under 40 kg is a rope half as stiff."""
    pair = rw.Material.from_fall("9 kN", "31 %", 0.076, static_elongation="6 %")
    strand = rw.Material.from_fall(
        "4.5 kN", "31 %", 0.038, falling_mass=40.0, static_elongation="6 %", static_load=40.0
    )
    assert pytest.approx(0.5 * pair.EA, rel=1e-12) == strand.EA
    assert strand.relaxing_EA == pytest.approx(0.5 * (pair.relaxing_EA or 0.0), rel=1e-6)


@pytest.mark.parametrize(
    ("given", "words"),
    [
        ({"elongation": 20.0}, "elongation: 20 - must be below 15"),
        ({"elongation": 0.0}, "must be a positive number"),
        ({"preload": 900.0}, "preload: 900 - must be from 0 to below the load"),
        ({"stiffening": -1.0}, "stiffening: -1 - must be 0 or greater"),
        ({"elongation": 3.0, "stiffening": 1e4}, "no rope that stiffens so has it"),
    ],
)
def test_what_cannot_be_is_refused(given: dict[str, float], words: str) -> None:
    numbers = {"elongation": 0.08, "load": 784.8} | given
    with pytest.raises(ValueError, match=words):
        rope_at_rest(numbers.pop("elongation"), numbers.pop("load"), **numbers)
