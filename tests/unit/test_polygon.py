"""Friction of the first and the last node on a round is more than none, however much there is."""

from __future__ import annotations

import math

import pytest

from ropewalk.laws.polygon import FINE, counting, on_polygon, tilted


@pytest.mark.parametrize("friction", [0.01, 0.3, 1.0, 5.7, 20.0, 100.0])
@pytest.mark.parametrize("side", [-1.0, 1.0])
@pytest.mark.parametrize("ahead", [-1.0, 1.0])
def test_friction_never_turns_round(friction: float, side: float, ahead: float) -> None:
    """Beyond a right angle it were less than none in every other step: the node would let go."""
    for step in (0.01, 0.13, 0.98 * FINE):
        middle = on_polygon(friction, 0.5 * step)  # the first turns by less than a segment
        most = counting(step, middle)
        assert 0.0 < most <= 0.5 * step
        found = tilted(middle, side * most, ahead)
        assert 0.0 < found < math.inf
        assert (found > middle) == (side * ahead > 0.0)


def test_nothing_counts_on_the_inside_of_a_ring_nor_with_long_segments() -> None:
    for step in (-0.1, 0.0, 1.05 * FINE):
        assert counting(step, 0.3) == 0.0
    assert counting(0.1, 0.3) > 0.0
