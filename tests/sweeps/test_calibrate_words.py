"""What a fit says of itself: which values it determines, and why it cannot be made."""

from __future__ import annotations

import math
from typing import Any

import numpy as np
import pytest

import ropewalk as rw
from ropewalk.record.errors import InputError
from ropewalk.sweeps.calibration import NotFitted
from ropewalk.sweeps.fit_ranges import make_scales
from ropewalk.sweeps.identify import verdict
from sweeps.scenes import EA, rigid, swing

LENGTH = "rope.length"
DETERMINED = "The measurement determines EA."


def fitted(error: float, ranges: tuple[float, float], profile: bool = True) -> Any:
    """EA from a pull test of 2 m, made with 2000 N."""
    forces = np.array([50.0, 100.0, 200.0])
    pull = rw.calibrate.pull_test(forces, forces * 2.0 / 2e3, error=error)
    return rw.calibrate(swing(0.02), pull, {EA: ranges}, starts=2, profile=profile)


@pytest.mark.parametrize("profile", [True, False])
def test_a_value_whose_interval_a_bound_cuts_is_not_determined(profile: bool) -> None:
    sharp = fitted(1e-4, (1e3, 1e4), profile)
    assert DETERMINED in sharp.words
    assert not any("not determined" in text for text in sharp.words)
    low = "EA is not determined: its interval ends at the lower end of its range."
    at_end = fitted(0.03, (1.9e3, 8e3), profile)
    assert low in at_end.words
    high = "EA is not determined: its interval ends at the upper end of its range."
    assert high in fitted(0.03, (1e3, 2.1e3), profile).words
    both = fitted(0.05, (1.9e3, 2.1e3), profile)
    assert any(
        text.startswith("EA is not determined") or "does not show" in text for text in both.words
    )
    for fit in (at_end, both):
        assert DETERMINED not in fit.words


def test_a_verdict_is_that_of_the_interval() -> None:
    def of(low: float, high: float, *words: str) -> tuple[str, ...]:
        return verdict(words, [(low, high)], ["EA"])

    assert of(0.2, 0.6) == (DETERMINED,)
    assert of(0.0, 1.0) == ("EA is not determined: its interval spans its range.",)
    assert of(0.1, 0.9) == ("EA is not determined: its interval spans most of its range.",)
    assert of(math.nan, math.nan) == ()  # nothing is known of it
    assert of(math.nan, math.nan, "told") == ("told",)
    assert of(0.0, 1.0, "EA does not show in this measurement.") == (
        "EA does not show in this measurement.",
    )
    two = verdict([], [(0.2, 0.3), (0.4, 1.0)], ["a", "b"])
    assert two == ("b is not determined: its interval ends at the upper end of its range.",)
    assert verdict([], [(0.2, 0.3)] * 2, ["a", "b"]) == (
        "The measurement tells all of them apart.",
    )


def test_bounds_that_no_scene_can_have_are_told_before_any_run(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    def none(*given: Any) -> None:
        raise AssertionError("a run was made")

    monkeypatch.setattr("ropewalk.sweeps.calibration.Residuals", none)
    sag = rw.calibrate.sag(1.0, 0.1)
    with pytest.raises(rw.SceneError, match=r"rope\[0\]\.length.*-1\.5"):
        rw.calibrate(swing(0.02), sag, {LENGTH: (-2.0, -1.0)})
    with pytest.raises(rw.SceneError, match=r"rope\.segments.*is a whole number"):
        rw.calibrate(swing(0.02), sag, {"rope.segments": (4, 20)})
    with pytest.raises(AssertionError, match="a run was made"):  # one end alone may be refused
        rw.calibrate(swing(0.02), sag, {EA: (0.0, 1e3)})


def test_a_fit_whose_starts_all_break_tells_the_first_reason() -> None:
    kept = rw.calibrate.kept("tension.max", 1.0, 0.1)
    with pytest.raises(NotFitted, match="every start broke: .* the first: Broke after t = 0 s"):
        rw.calibrate(swing(0.02), kept, {EA: (4e6, 9e6)}, starts=2)


def test_a_length_that_only_another_end_allows_is_no_fault() -> None:
    """Rigid ropes too short for the span as it is; nearer together they hang."""
    hanging, lengths = rigid(), {LENGTH: (6.0, 7.0)}
    rule = "the first: rope.*shorter than the"
    sag = rw.calibrate.pull_test([1.0, 2.0], [0.1, 0.2], error=0.1)
    with pytest.raises(NotFitted, match=rule):
        rw.calibrate(hanging, sag, lengths, starts=2)
    make_scales(hanging, {"rope.shape.end[0]": (3.0, 4.0), **lengths})


def test_a_fit_without_an_interval_says_so() -> None:
    pull = rw.calibrate.pull_test([100.0], [0.1])
    fit = rw.calibrate(swing(0.02), pull, {EA: (1e3, 1e4)}, starts=2)
    assert "(interval not known)" in repr(fit)
    assert any(text.startswith("1 number for 1 value: nothing is left") for text in fit.words)
    assert DETERMINED not in fit.words


@pytest.mark.parametrize(
    ("options", "told"),
    [
        ({"starts": "a"}, "starts: 'a' - must be a whole number from 0 on"),
        ({"starts": 2.5}, "starts: 2.5 - must be a whole number from 0 on"),
        ({"seed": -1}, "seed: -1 - must be a whole number from 0 on"),
        ({"level": "a"}, "level: 'a' - must be between 0 and 1"),
    ],
)
def test_options_that_cannot_be_have_a_sentence(options: dict[str, Any], told: str) -> None:
    with pytest.raises(InputError, match=told):
        rw.calibrate(swing(0.02), rw.calibrate.sag(1.0, 0.1), {EA: (1e3, 2e3)}, **options)


@pytest.mark.parametrize(
    ("options", "told"),
    [
        ({"samples": 3.5}, "samples: 3.5 - must be a whole number from 2 on"),
        ({"samples": 1}, "samples: 1 - must be a whole number from 2 on"),
        ({"samples": True}, "samples: True - must be a whole number from 2 on"),
        ({"seed": -1}, "seed: -1 - must be a whole number from 0 on"),
        ({"seed": "a"}, "seed: 'a' - must be a whole number from 0 on"),
    ],
)
def test_samples_and_seeds_that_cannot_be_have_a_sentence(
    options: dict[str, Any], told: str
) -> None:
    with pytest.raises(InputError, match=told):
        rw.uncertain(swing(0.02), {EA: (1e3, 2e3)}, **options)
