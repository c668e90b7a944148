"""Numbers with SI prefixes, in labels and tables."""

from __future__ import annotations

import math

import pytest

import ropewalk as rw
from ropewalk.cli.results_table import results_rows
from ropewalk.words.prefixes import prefix_of, prefixed


@pytest.mark.parametrize(
    ("value", "text"),
    [
        (26774.0, "26.77 kN"),
        (-26774.0, "-26.77 kN"),
        (9999.0, "9999 N"),
        (0.02, "0.02 N"),
        (0.0, "0 N"),
        (2.5e7, "25 MN"),
        (9999.7, "10 kN"),  # it was 1e+04 N
        (999960.0, "1000 kN"),
        (1e13, "1e+04 GN"),
        (math.inf, "inf N"),
        (math.nan, "nan N"),
    ],
)
def test_a_number_with_its_prefix(value: float, text: str) -> None:
    assert prefixed(value, "N") == text


@pytest.mark.parametrize(
    ("value", "figures", "text"),
    [(1234.0, 3, "1.23 kJ"), (-1234.0, 2, "-1.2 kJ"), (999.6, 3, "1 kJ"), (123.0, 3, "123 J")],
)
def test_few_figures_need_no_exponent(value: float, figures: int, text: str) -> None:
    assert prefixed(value, "J", figures) == text


@pytest.mark.parametrize("largest", [1e-30, 3e-7, 0.5, 1.0, 9e3, 1e4, 7e11, 1e30])
def test_the_factor_is_that_of_the_letter(largest: float) -> None:
    factor, letter = prefix_of(largest)
    assert (
        factor == {"G": 1e9, "M": 1e6, "k": 1e3, "": 1.0, "m": 1e-3, "µ": 1e-6, "n": 1e-9}[letter]
    )


def test_the_table_of_results_has_forces_in_kilonewtons_and_keeps_small_ones() -> None:
    rows = results_rows({"largest tension [N]": 26774.0, "largest anchor force [N]": 104.59})
    assert [row[1] for row in rows] == ["26.774 kN", "104.59 N"]


def test_check_tells_a_heavy_ropes_tension_in_kilonewtons() -> None:
    material = rw.Material(EA=5e7, mass_per_length=20.0)
    scene = rw.Scene(
        ropes=[rw.Rope(segments=20, length=100.0, made_of=material)], anchors=[rw.Anchor(node=0)]
    )
    assert "largest tension 19.1" in str(rw.check(scene))
    assert " kN" in str(rw.check(scene))
