"""What is no number, or none that a knot can have, is refused by name."""

from __future__ import annotations

import math
from typing import Any

import numpy as np
import pytest

from ropewalk import knots
from ropewalk.scene import Knot, SceneError

D = 0.01
SIZES = {name: {"post_radius": 2.0 * D} for name in ("bollard", "munter", "prusik")}


@pytest.mark.parametrize(
    ("name", "more", "said"),
    [
        ("reef", {"slack": "2"}, "slack: '2' - must be a number"),
        ("reef", {"slack": math.nan}, "slack: nan - must be a number"),
        ("bollard", {"turns": True}, "turns: True - must be a number"),
        (
            "bollard",
            {"post_radius": "2 cm"},
            "post_radius: '2 cm' - must be a number of m, without",
        ),
        (
            "munter",
            {"ring_radius": math.inf},
            "ring_radius: inf - must be at most 1000 m; leave it",
        ),
        ("munter", {"ring_radius": math.nan}, "ring_radius: nan - must be a number of m"),
        ("prusik", {"turns": 0}, "turns: 0.0 - must be a whole number from 1 to 50 for a prusik"),
        ("prusik", {"turns": 0.5}, "turns: 0.5 - must be a whole number from 1 to 50"),
        ("prusik", {"turns": 51}, "turns: 51.0 - must be a whole number from 1 to 50"),
    ],
)
@pytest.mark.filterwarnings("error")
def test_sizes_that_are_no_numbers_are_refused_in_words(name: str, more: Any, said: str) -> None:
    with pytest.raises(ValueError, match=said):
        knots.knot(name, D, **(SIZES.get(name, {}) | more))


@pytest.mark.parametrize("diameter", ["10 mm", None, math.nan, True])
def test_a_diameter_that_is_no_number_is_refused_in_words(diameter: Any) -> None:
    with pytest.raises(ValueError, match=rf"diameter: '?{diameter}'? - must be a number of m"):
        knots.knot("reef", diameter)


@pytest.mark.parametrize("diameter", [1e-320, 1e-13, 2e6, 1e300, math.inf])
@pytest.mark.filterwarnings("error")
def test_a_diameter_of_no_rope_is_refused_in_words(diameter: float) -> None:
    """Scipy's words for a curve that is a point, or without end, came out; of inf that it is not above 0."""
    with pytest.raises(ValueError, match=r"diameter: .* - must be from 1e-12 to 1e\+06 m"):
        knots.knot("reef", diameter)
    for fault in Knot(knot="reef").faults(diameter, 100, 1.0):
        assert fault.path == "diameter"


@pytest.mark.parametrize("name", knots.names())
@pytest.mark.parametrize("diameter", [1e-12, 1e6])
@pytest.mark.filterwarnings("error")
def test_the_thinnest_and_the_thickest_rope_are_tied_as_any(name: str, diameter: float) -> None:
    """In their diameters they are the same knot."""
    sizes = [{} if name in knots.KNOTS else {"post_radius": 2.0 * d} for d in (diameter, 1.0)]
    found, plain = (
        knots.knot(name, d, **more).points(150, 150.0 * d) / d
        for d, more in zip((diameter, 1.0), sizes, strict=True)
    )
    assert np.allclose(found, plain, rtol=0.0, atol=1e-9)


@pytest.mark.parametrize(
    ("more", "said"),
    [
        ({"segments": 0}, "segments: 0 - must be a whole number, 1 or more"),
        ({"segments": -60}, "segments: -60 - must be a whole number, 1 or more"),
        ({"segments": 60.5}, "segments: 60.5 - must be a whole number, 1 or more"),
        ({"rope": 1.5}, "rope: 1.5 - must be a whole number, 1 or more"),
        ({"length": math.inf}, "length: inf - must be a finite number of m"),
        ({"length": math.nan}, "length: nan - must be a number of m"),
        ({"length": "72 cm"}, "length: '72 cm' - must be a number of m, without a unit"),
        ({"first_end": -0.12}, "first_end: -0.12 - must be a finite number of m, not negative"),
        ({"first_end": math.nan}, "first_end: nan - must be a number of m"),
        ({"first_end": math.inf}, "first_end: inf - must be a finite number of m"),
    ],
)
def test_a_rope_that_is_no_rope_is_refused_in_words(more: Any, said: str) -> None:
    """A first end of less than nothing began within the knot, and what came out was none."""
    reef = knots.knot("reef", D)
    given = {"segments": 60, "length": 0.72, **more}
    with pytest.raises(ValueError, match=said):
        reef.points(**given)
    numbers = reef.points(np.int64(60), np.float64(0.72), np.int32(1), np.float32(0.0))
    assert np.array_equal(numbers, reef.points(60, 0.72, 1, 0.0))


@pytest.mark.parametrize("length", [-1, 0.0, math.nan, "30 s", None])
def test_a_post_of_no_length_is_refused_in_words(length: Any) -> None:
    shape = Knot(knot="bollard", post_radius=0.02)
    with pytest.raises(SceneError, match="length"):
        shape.post(length)
    assert shape.post("30 cm") == shape.post(0.3)


@pytest.mark.parametrize(
    ("ring", "field"),
    [
        *((None, field) for field in ("radius", "start", "end")),
        *((0.1, field) for field in ("radius", "bar_radius", "center", "axis")),
    ],
)
def test_what_a_shape_gives_its_post_is_refused_by_name(ring: float | None, field: str) -> None:
    """That a keyword came twice was Python's word for it."""
    shape = Knot(knot="munter", post_radius=0.02, ring_radius=ring)
    assert shape.post(name="peg").name == "peg"
    with pytest.raises(ValueError, match=f"{field}: 0.03 - leave it out: the shape gives it"):
        shape.post(0.3, **{field: 0.03})


def test_a_first_end_of_no_length_is_one() -> None:
    """A scene's shape refused what the knot took."""
    shape = Knot(knot="reef", first_end=0)
    found = shape.places(60, 0.72, 0.012, (0, 0, 1), D)
    assert np.array_equal(found, knots.knot("reef", D).points(60, 0.72, first_end=0.0))
    with pytest.raises(SceneError, match="first_end: -1 - must be at least 0"):
        Knot(knot="reef", first_end=-1)


def test_hitches_that_are_two_have_no_article() -> None:
    tied = knots.knot("two-half-hitches", D, post_radius=2.0 * D)
    with pytest.raises(ValueError, match="m for two-half-hitches of a rope 0.01 m thick"):
        tied.points(100, 0.1)
