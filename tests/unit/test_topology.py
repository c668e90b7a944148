"""The yardstick of the tests of contact, held against knots that are known."""

from __future__ import annotations

import numpy as np
import pytest

from verification.topology import determinant, linking_number


def _torus_knot(p: int, q: int, points: int = 120):
    t = np.linspace(0.0, 2.0 * np.pi, points, endpoint=False)
    r = 2.0 + np.cos(q * t)
    return np.stack((r * np.cos(p * t), r * np.sin(p * t), np.sin(q * t)), axis=1)


@pytest.mark.parametrize(("p", "q", "known"), [(2, 1, 1), (2, 3, 3), (2, 5, 5), (3, 4, 3)])
def test_determinants_of_torus_knots(p, q, known):
    for turn in (0.3, 1.1):
        assert determinant(_torus_knot(p, q), turn) == known


def test_linking_numbers():
    t = np.linspace(0.0, 2.0 * np.pi, 40, endpoint=False)
    ring = np.stack((np.cos(t), np.sin(t), 0.1 * np.cos(3.0 * t)), axis=1)
    through = np.stack((1.0 + np.cos(t), 0.0 * t + 0.05, np.sin(t)), axis=1)
    assert abs(linking_number(ring, through)) == pytest.approx(1.0, abs=1e-9)
    assert linking_number(ring, through + 3.0 * np.eye(3)[0]) == pytest.approx(0.0, abs=1e-9)
