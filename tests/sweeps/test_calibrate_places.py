"""Fits at several places, at a turn of what is measured, and of ropes that are cut too coarsely."""

from __future__ import annotations

import math
from typing import Any

import numpy as np
import pytest

import ropewalk as rw
from ropewalk.sweeps.basins import Found, _across, _hollows, _passed, _several
from ropewalk.sweeps.cutting import _bound, _cuts

LENGTH = "rope.length"
DETERMINED = "The measurement determines length."
PLACE = "Another place fits as well: length = "


def pulled(tension: float, high: float, seed: int, segments: int = 48, **options: Any) -> Any:
    """The length of a rope between two points, from the tension at rest, which has its least at 10.16 m."""
    measured = rw.calibrate.kept("tension.max", [tension], 0.02, rest=True)
    scene = rw.preset("hanging-rope").replace(**{"rope.segments": segments})
    return rw.calibrate(scene, [measured], {LENGTH: (8.1, high)}, seed=seed, **options)


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


@pytest.mark.parametrize("high", [40.0, 100.0])
def test_a_fit_between_an_end_of_the_range_and_all_starts_is_found(high: float) -> None:
    """No start lay below the turn, at 7 % of the range and at 2 %: 13.08 m was determined, and alone."""
    for seed in range(5):
        fit = pulled(4.5, high, seed, profile=False)
        places = [fit.values[LENGTH], *(one[LENGTH] for one in fit.others)]
        assert places == pytest.approx([13.0805, 8.8707], abs=1e-3)


def two_ropes(measured: dict[int, float], high: float, seed: int) -> Any:
    """The lengths of two ropes from tensions of their first segments, which fall with it and rise again."""
    scene = rw.preset("hanging-rope")
    one = scene.ropes[0].replace(segments=24)
    ropes = [one.replace(name=name) for name in "pq"]
    anchors = [rw.Anchor(name=f"{r}{n}", rope=r, node=n) for r in "pq" for n in (0, -1)]
    found = [
        rw.calibrate.kept(f"tension[-1, {at}]", [value], 0.02, rest=True)
        for at, value in measured.items()
    ]
    ranges = {"rope[0].length": (8.1, high), "rope[1].length": (8.1, high)}
    return rw.calibrate(
        rw.Scene(ropes=ropes, anchors=anchors, run=scene.run),
        found,
        ranges,
        seed=seed,
        profile=False,
    )


def test_fits_along_each_of_two_values_are_found() -> None:
    """Each rope has two lengths: of four pairs one was told with two seeds of three, as the only one."""
    for seed in range(3):
        fit = two_ropes({0: 3.9, 25: 3.9}, 40.0, seed)
        places = [[*one.values()] for one in (fit.values, *fit.others)]
        assert len(places) > 2
        for length in np.ravel(places):
            assert min(abs(length - 13.472), abs(length - 8.839)) < 2e-3
        assert not any("tells all of them apart" in text for text in fit.words)


def test_another_place_is_one_whatever_a_value_has_there_that_does_not_show() -> None:
    fit = two_ropes({25: 4.5}, 20.0, 0)
    assert len(fit.others) == 1
    assert "rope_0_length does not show in this measurement." in fit.words


def test_a_segment_between_ropes_is_refused() -> None:
    """It was predicted as 0 N, whatever the lengths."""
    rule = "ropes p and q, where there is none: p ends with segment 23, q begins with 25"
    for at in (24, -25):
        with pytest.raises(
            rw.SceneError, match=rf'keep: "tension\[-1, {at}\]" - segment {at} lies between {rule}'
        ):
            two_ropes({at: 4.5}, 20.0, 0)


def test_one_length_within_a_narrower_range_is_determined() -> None:
    fit = pulled(4.5, 10.0, 3, segments=400)
    assert fit.values[LENGTH] == pytest.approx(8.8999, abs=1e-3)
    assert not fit.others
    assert DETERMINED in fit.words
    coarse = pulled(4.5, 10.0, 3)
    assert coarse.values[LENGTH] == pytest.approx(8.8707, abs=1e-3)
    assert DETERMINED not in coarse.words  # the cutting makes more of a difference than the errors


@pytest.mark.parametrize("profile", [True, False])
def test_where_only_the_slope_vanishes_a_value_does_show(profile: bool) -> None:
    """The interval of the profile leaves out most of the range, and it was told not to show."""
    fit = pulled(4.0, 13.0, 0, profile=profile)
    assert fit.values[LENGTH] == pytest.approx(10.158, abs=0.01)
    assert not any("does not show" in text for text in fit.words)
    assert any(text.startswith("length fits where the measurement turns") for text in fit.words)
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
    assert told.startswith("The cutting into segments makes length too small, by up to about ")
    assert "as half and twice as many segments show" in told
    off = 10.0 - fit.values[LENGTH]
    assert off < bound_of(told) < 1.6 * off
    assert DETERMINED not in fit.words
    assert fit.evaluations < 50  # 55 and more were three searches to the same place


def bound_of(told: str) -> float:
    """How far a sentence says that the cutting may put a value off [m]."""
    return float(told.split("by up to about ")[1].split()[0])


W = 0.063 * 9.81  # N/m


def catenary(length: float) -> tuple[float, float]:
    """A rope of this length, 8 m across and 1 m up: its parameter, and where it is lowest [m]."""
    from scipy.optimize import brentq

    level = math.sqrt(length**2 - 1.0)
    a = brentq(lambda a: 2.0 * a * math.sinh(4.0 / a) - level, 0.3, 500.0)
    return a, 4.0 - a * math.asinh(1.0 / (2.0 * a * math.sinh(4.0 / a)))


def hung(segments: int, what: str, value: float, error: float, ends: tuple[float, float]) -> Any:
    scene = rw.preset("hanging-rope").replace(**{"rope.segments": segments, "rope.made_of.EA": 1e7})
    measured = rw.calibrate.kept(what, [value], error, rest=True)
    fit = rw.calibrate(scene, measured, {LENGTH: ends})
    return fit, [text for text in fit.words if text.startswith("The cutting into segments ")]


@pytest.mark.parametrize("segments", [12, 24, 48])
def test_the_cutting_of_a_tension_is_told_to_first_order(segments: int) -> None:
    """A third of it was, as of second order: with 48 segments 14 mm of 43 mm."""
    a, lowest = catenary(9.0)
    largest = W * a * math.cosh((8.0 - lowest) / a)
    fit, (told,) = hung(segments, "tension.max", largest, 0.02, (8.2, 9.9))
    off = 9.0 - fit.values[LENGTH]
    assert "makes length too small" in told
    assert off < bound_of(told) < 1.6 * off
    assert DETERMINED not in fit.words


@pytest.mark.parametrize("segments", [12, 24])
def test_the_cutting_has_no_direction_where_no_order_is_seen(segments: int) -> None:
    """The lowest node lies at the lowest point or beside it: 11.9935 m was told too large for 12 m."""
    a, lowest = catenary(12.0)
    fit, (told,) = hung(segments, "height.min", a - a * math.cosh(lowest / a), 0.005, (10.0, 14.0))
    assert "may put length off" in told
    assert "either way" in told
    assert abs(fit.values[LENGTH] - 12.0) < bound_of(told)


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
    assert len(_several(table, costs)) == 4


def test_places_that_fit_as_well_lie_outside_of_the_intervals() -> None:
    at = [(np.array([0.2]), 1.0), (np.array([0.5]), 2.0), (np.array([0.9]), 9.0)]
    found = Found(at[0][0], 1.0, tuple(at), 0, 3)
    assert [float(one[0]) for one in found.others([(0.1, 0.3)], 2.7)] == [0.5]
    assert found.others([(0.1, 0.6)], 2.7) == []
    assert [float(one[0]) for one in found.others([(math.nan, math.nan)], 2.7)] == [0.5]
    unseen = [(np.array([x, y]), 1.0) for x, y in ((0.2, 0.5), (0.8, 0.3), (0.8, 0.6), (0.2, 0.9))]
    found = Found(unseen[0][0], 1.0, tuple(unseen), 0, 4)
    assert [one.tolist() for one in found.others([(0.1, 0.3), (0.0, 1.0)], 1.0)] == [[0.8, 0.3]]
    assert found.others([(0.0, 1.0), (0.0, 1.0)], 1.0) == []


def test_an_order_is_seen_where_errors_fall_by_it() -> None:
    first, second = _bound(0.2, -0.1), _bound(0.4, -0.1)
    assert first == (pytest.approx(0.3), True)  # an error of 0.2, and half as much again
    assert second == (pytest.approx(0.2), True)
    assert _bound(0.2, 0.1) == (pytest.approx(0.3), False)
    assert _bound(0.6, 0.1) == (pytest.approx(0.45), False)
    assert _bound(0.1, None) == (pytest.approx(0.15), False)
    assert _bound(None, -0.1) == (pytest.approx(0.3), False)
    assert _bound(0.0, 0.0) == (0.0, False)


def test_a_step_that_is_given_is_halved_with_the_segments() -> None:
    """Cut to 0.1 m, waves of 316 m/s bound it at 0.32 ms; a run that broke counted."""
    rope = rw.Rope(segments=20, length=2.0, made_of=rw.Material(EA=1e4, mass_per_length=0.1))
    run = rw.RunSettings(duration=0.1, method="verlet", time_step=2.5e-4)
    scene = rw.Scene(ropes=[rope], anchors=[rw.Anchor(node=0)], run=run)
    made = _cuts(scene, [rw.calibrate.kept("tension.max", [1.0], 0.1)])
    assert made[2.0] == pytest.approx(0.6957, rel=1e-3)
    broken = _cuts(
        scene.replace(**{"run.time_step": 4e-4}), [rw.calibrate.kept("tension.max", [1.0], 0.1)]
    )
    assert [*broken] == [0.5]  # the fit itself would break then


def test_residuals_that_pass_zero_between_two_starts() -> None:
    assert _passed(np.array([[3.0], [-1.0], [-2.0], [math.nan], [1.0]])) == [0]
    assert _passed(np.array([[3.0, 1.0], [2.0, 1.0], [-1.0, 1.0], [-2.0, 2.0]])) == [1]
