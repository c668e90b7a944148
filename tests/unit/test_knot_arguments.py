"""What is no number, or none that a knot can have, is refused by name."""

from __future__ import annotations

import math
from typing import Any

import numpy as np
import pytest

from ropewalk import knots
from ropewalk.scene import Knot, SceneError

D = 0.01
SIZES = {"bollard": {"post_radius": 2.0 * D}, "munter": {"post_radius": 2.0 * D}}


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
