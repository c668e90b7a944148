"""Friction of the first and the last node on a round is more than none, however much there is."""

from __future__ import annotations

import math

import numpy as np
import pytest

from ropewalk.laws.polygon import FINE, counting, off_middle, on_polygon

AXIS = (0.0, 1.0, 0.0)


def on_a_round(step: float) -> np.ndarray:
    """Return three nodes, (3, 3), on a circle of radius 1 about the axis."""
    angles = np.array([-step, 0.0, step])
    return np.stack([np.sin(angles), np.zeros(3), np.cos(angles)])


@pytest.mark.parametrize("friction", [0.01, 0.3, 1.0, 5.7, 20.0, 100.0])
@pytest.mark.parametrize("off", [-0.5, -0.05, 0.05, 0.5])
@pytest.mark.parametrize("ahead", [-1.0, 1.0])
def test_friction_never_turns_round(friction: float, off: float, ahead: float) -> None:
    """Beyond a right angle it was less than none in every other step: the node let go."""
    for step in (0.01, 0.13, 0.98 * FINE):
        middle = on_polygon(friction, 0.5 * step)  # the first turns by less than a segment
        counts = counting(on_a_round(step), 1, AXIS, 1.0, 0.0, middle)
        found = off_middle(middle, 0.25 * step + off, 0.25 * step - off, ahead, counts)
        assert 0.0 < found < math.inf
        # the twin: it does count, on its own side
        assert (found > middle) == (off * ahead > 0.0)


def test_nothing_counts_on_the_inside_of_a_ring_nor_with_long_segments() -> None:
    for step, curvature in ((0.1, -1.0), (1.05 * FINE, 1.0)):
        assert counting(on_a_round(step), 1, AXIS, curvature, 0.0, 0.3) == 0.0
    assert counting(on_a_round(0.1), 1, AXIS, 1.0, 0.0, 0.3) > 0.0
