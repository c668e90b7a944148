"""Per cents of what a scene has: the range that they are, and what they cannot be of."""

from __future__ import annotations

import re
from typing import Any

import numpy as np
import pytest

import ropewalk as rw
from ropewalk.plots.ranks import rank_correlation
from ropewalk.record.errors import InputError
from ropewalk.scene import SceneError
from ropewalk.scene.presets import preset
from ropewalk.sweeps.designs import spread_over
from ropewalk.sweeps.parameters import make_parameters
from ropewalk.sweeps.per_cents import with_ranges
from ropewalk.sweeps.spread_text import parse_uncertain, parse_vary
from sweeps.scenes import swing

EA = "rope.made_of.EA"


@pytest.mark.parametrize("text", ["10%", "10 %", "±10%", " ± 10 % "])
def test_per_cents_are_of_what_the_library_rope_has(text: str) -> None:
    found = with_ranges(preset("zip-line"), {EA: text, "rope.length": (150.0, 150.5)})
    assert found == {
        EA: pytest.approx((0.9 * 7.085e6, 1.1 * 7.085e6)),
        "rope.length": (150.0, 150.5),
    }


def test_per_cents_of_a_negative_number_are_in_order() -> None:
    found = with_ranges(preset("zip-line"), {"rope.shape.end[2]": "10%"})
    assert found["rope.shape.end[2]"] == pytest.approx((-8.25, -6.75))


@pytest.mark.parametrize(
    ("path", "text", "rule"),
    [
        *((EA, text, "above 0 and up to 100") for text in ("0%", "-10%", "120%", "x%", "10 kN")),
        (EA, "10 % kN", "above 0 and up to 100"),
        ("rope.shape.start", "10%", "no single number stands there"),
        ("rope.shape.end[1]", "10%", "the scene has 0 there"),
        ("rope.made_of.relaxing_EA", "10%", "nothing stands there"),
        ("time_step", "10%", "no single number stands there"),
        ("rope.made_of.EAA", "10%", "unknown key"),
    ],
)
def test_what_per_cents_cannot_be(path: str, text: str, rule: str) -> None:
    with pytest.raises(SceneError, match=rule):
        with_ranges(preset("zip-line"), {path: text})


def test_a_range_may_be_written_as_on_the_command_line() -> None:
    """It was refused with the advice to give a range LOW..HIGH, which it was."""
    given = {"rope.length": "150.0..150.5 m", EA: " 7e6..8e6 ", "duration": (1.0, 2.0)}
    found = with_ranges(preset("zip-line"), given)
    assert found == {"rope.length": ("150.0 m", "150.5 m"), EA: (7e6, 8e6), "duration": (1.0, 2.0)}
    with pytest.raises(SceneError, match=r"length: \"150..x\" - a range is written LOW..HIGH"):
        with_ranges(preset("zip-line"), {"rope.length": "150..x"})


def test_per_cents_of_unlike_ropes_are_refused() -> None:
    with pytest.raises(SceneError, match="name one of them"):
        with_ranges(preset("three-leg-sling"), {"rope.length": "10%"})


def test_the_band_of_per_cents_is_that_of_their_range() -> None:
    """At rest the tension goes with the mass: nine tenths of 10 % below and above it are in the band."""
    mass = "rope.made_of.mass_per_length"
    ask: dict[str, Any] = {
        "samples": 32,
        "seed": 3,
        "what": "rest",
        "on": "here",
        "progress": False,
    }
    found = rw.uncertain(swing(0.02), {mass: "10 %"}, **ask)
    low, middle, high = found.bands.tension_max.values / found.bands.tension_max.values[1]
    assert (low, middle, high) == pytest.approx((0.91, 1.0, 1.09), abs=4e-3)


@pytest.mark.parametrize("text", ["rope.length=10%", "rope.length = ±10 %"])
def test_per_cents_on_the_command_line(text: str) -> None:
    path, what = parse_uncertain(text)
    assert path == "rope.length"
    assert re.fullmatch("±?10 ?%", what)


@pytest.mark.parametrize(
    "text", ["rope.length", "rope.length=", "=10%", "rope.length=3..x", "a=norm(5%)"]
)
def test_refusals_name_their_own_option(text: str) -> None:
    with pytest.raises(InputError, match="^--uncertain: "):
        parse_uncertain(text)


def test_ranges_of_whole_numbers_have_their_whole_numbers_alone() -> None:
    """Ten per cent of four segments is 3.6 to 4.4, which is four; it was three and four."""
    scene = swing()
    spreads = with_ranges(scene, {"rope.segments": "10%"})
    (found,) = make_parameters(scene, spreads)
    assert found.spread == (4, 4)
    (found,) = make_parameters(scene, {"rope.segments": (6.3, 9.0)})
    assert found.spread == (7, 9)
    drawn = spread_over(found, np.linspace(0.0, 1.0, 3001))
    assert [np.mean(drawn == count) for count in (7, 8, 9)] == pytest.approx([1 / 3] * 3, abs=1e-3)


def test_a_range_without_a_whole_number_is_refused() -> None:
    with pytest.raises(SceneError, match="has no whole number, which is needed there; 7 and 8 are"):
        make_parameters(swing(), {"rope.segments": (7.2, 7.8)})


@pytest.mark.parametrize(
    ("text", "rule"),
    [
        ("0...5", "two dots"),  # was 0 to 0.5
        ("geomspace(0, 1, 3)", "zero"),
        ("linspace(0, 1, 1e9)", "at most 1000000"),
        ("linspace(0, 1, 1e300)", "at most 1000000"),
        ("logspace(0, 999, 3)", "not finite"),
    ],
)
def test_what_is_no_range_or_grid_is_refused(text: str, rule: str) -> None:
    with pytest.raises(InputError, match=rule):
        parse_vary(f"rope.length={text}")


def test_more_samples_than_there_can_be_are_refused() -> None:
    with pytest.raises(InputError, match="samples.*at most"):
        rw.uncertain(preset("zip-line"), {EA: "10%"}, samples=10**9)


def test_what_a_result_follows_is_by_ranks_of_which_equal_ones_share_theirs() -> None:
    """By their order in the grid a parameter without effect got 0.34, more than one with."""
    values = np.meshgrid(np.arange(2.0), np.arange(2.0), np.arange(25.0), indexing="ij")
    none, some, most = (one.ravel() for one in values)
    y = most + 3.0 * some
    assert rank_correlation(none, y) == pytest.approx(0.0, abs=1e-12)
    assert 0.15 < rank_correlation(some, y) < 0.25 < rank_correlation(most, y)
