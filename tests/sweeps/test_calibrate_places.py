"""Fits at several places, at a turn of what is measured, and of ropes that are cut too coarsely."""

from __future__ import annotations

import math
from typing import Any

import numpy as np
import pytest

import ropewalk as rw
from ropewalk.sweeps.basins import Found, _across, _hollows, _several

LENGTH = "rope.length"
DETERMINED = "The measurement determines length."
PLACE = "Another place fits as well: length = "


def pulled(tension: float, high: float, seed: int, **options: Any) -> Any:
    """The length of a rope between two points, from the tension at rest, which has its least at 10.16 m."""
    measured = rw.calibrate.kept("tension.max", [tension], 0.02, rest=True)
    return rw.calibrate("hanging-rope", [measured], {LENGTH: (8.1, high)}, seed=seed, **options)


@pytest.mark.parametrize(
    ("tension", "high", "best", "other"),
    [(4.5, 16.0, 13.0805, 8.8707), (4.25, 13.0, 11.999, 9.1338)],
)
def test_two_lengths_that_fit_are_both_named_whatever_the_seed(
    tension: float, high: float, best: float, other: float
) -> None:
    """Which of them it was depended on the seed, and it was told to be determined."""
    for seed in range(4):
        fit = pulled(tension, high, seed, profile=False)
        assert fit.values[LENGTH] == pytest.approx(best, abs=1e-3)  # the nearer to the scene's own
        assert [one[LENGTH] for one in fit.others] == pytest.approx([other], abs=1e-3)
        assert any(text.startswith(f"{PLACE}{other:.3f}"[:-1]) for text in fit.words)
        assert DETERMINED not in fit.words


def test_one_length_within_a_narrower_range_is_determined() -> None:
    fit = pulled(4.5, 10.0, 3)
    assert fit.values[LENGTH] == pytest.approx(8.8707, abs=1e-3)
    assert not fit.others
    assert DETERMINED in fit.words


@pytest.mark.parametrize("profile", [True, False])
def test_where_only_the_slope_vanishes_a_value_does_show(profile: bool) -> None:
    """The interval of the profile leaves out most of the range, and it was told not to show."""
    fit = pulled(4.0, 13.0, 0, profile=profile)
    assert fit.values[LENGTH] == pytest.approx(10.158, abs=0.01)
    assert not any("does not show" in text for text in fit.words)
    assert any(text.startswith("length fits where the measurement turns") for text in fit.words)
    assert not any("cutting" in text for text in fit.words)
    assert DETERMINED not in fit.words
    if profile:
        assert fit.profile[LENGTH] == pytest.approx((9.711, 10.747), abs=0.02)


def chain(segments: int) -> Any:
    """The length of a chain that hangs, from its period: 10 m long it has one of 5.27584 s.

    By hand: the slowest swing of a heavy chain is 2 sqrt(L / g) / 2.40483 times 2 pi.
    """
    period = 4.0 * math.pi * math.sqrt(10.0 / 9.81) / 2.404825557695773
    rope = rw.Rope(segments=segments, length=9.0, made_of=rw.Material(EA=1e5, mass_per_length=0.1))
    scene = rw.Scene(ropes=[rope], anchors=[rw.Anchor(node=0)])
    return rw.calibrate(scene, rw.calibrate.swing(period, error=0.002), {LENGTH: (8.0, 12.0)})


def test_what_the_cutting_into_segments_does_is_told_beside_the_interval() -> None:
    """Ten segments: 9.94 m, at 90 % from 9.928 m to 9.953 m, which leaves out the true 10 m."""
    fit = chain(10)
    assert not fit.profile[LENGTH][0] < 10.0 < fit.profile[LENGTH][1]
    (told,) = [text for text in fit.words if text.startswith("The cutting into segments makes ")]
    size = float(told.removeprefix("The cutting into segments makes length about ").split()[0])
    assert "m too small, as half the segments show: 4." in told
    assert size == pytest.approx(10.0 - fit.values[LENGTH], rel=0.1)
    assert fit.evaluations < 50  # 55 and more were three searches to the same place


def test_fine_segments_are_no_doubt() -> None:
    fit = chain(80)
    assert not any("cutting" in text for text in fit.words)
    assert DETERMINED in fit.words


def test_what_is_measured_at_a_node_is_not_known_of_other_segments() -> None:
    scene = rw.preset("hanging-rope")
    droop = rw.calibrate.droop(2.0, 0.02, node=5)
    fit = rw.calibrate(scene, droop, {LENGTH: (9.0, 14.0)}, starts=2, profile=False)
    told = "What the cutting into segments does to the values is not known: droop is of a node"
    assert any(text.startswith(told) for text in fit.words)


def test_progress_counts_evaluations() -> None:
    seen: list[int] = []
    fit = pulled(4.5, 10.0, 0, profile=False, progress=seen.append)
    assert seen == [*range(1, fit.evaluations + 1)]


def test_hollows_of_a_row_and_what_lies_across_a_place() -> None:
    inf = math.inf
    assert _hollows(np.array([3.0, 1.0, 2.0, inf, 5.0, 0.5])) == [5, 1]
    assert _hollows(np.array([1.0, 1.0, 1.0])) == [0]
    assert _hollows(np.array([inf, 2.0, inf])) == [1]
    line = np.array([0.1, 0.4, 0.8])
    assert [*_across(line, 1, 0.5)] == [2]
    assert [*_across(line, 1, 0.2)] == [0]
    assert [*_across(line, 1, 0.4)] == [2, 0]
    assert [*_across(line, 0, 0.05)] == []


def test_starts_of_several_values_are_the_best_and_those_of_other_hollows() -> None:
    x = np.linspace(0.0, 1.0, 11)
    table = np.column_stack([x, 0.0 * x])
    costs = np.minimum((x - 0.2) ** 2, (x - 0.9) ** 2 + 0.1)
    assert _several(table, costs)[:2] == [2, 9]
    assert len(_several(table, costs)) == 3


def test_places_that_fit_as_well_lie_outside_of_the_intervals() -> None:
    at = [(np.array([0.2]), 1.0), (np.array([0.5]), 2.0), (np.array([0.9]), 9.0)]
    found = Found(at[0][0], 1.0, tuple(at), 0, 3)
    assert [float(one[0]) for one in found.others([(0.1, 0.3)], 2.7)] == [0.5]
    assert found.others([(0.1, 0.6)], 2.7) == []
    assert [float(one[0]) for one in found.others([(math.nan, math.nan)], 2.7)] == [0.5]
