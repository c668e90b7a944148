"""Modes of equal frequency are told apart the same way whatever mixture of them a solver finds."""

from __future__ import annotations

import numpy as np
import pytest

import ropewalk as rw
from ropewalk.vibration.solve import untangle


def test_two_spans_that_are_alike_swing_each_by_itself() -> None:
    """Mixed by rounding, a mode of one half wave a span had two on one machine and one on another."""
    found = rw.modes(rw.preset("r4"), count=8)
    nodes = found.shapes.shape[1]
    energy = (np.abs(found.shapes) ** 2).sum(axis=2)
    left = energy[:, : nodes // 2].sum(axis=1) / energy.sum(axis=1)
    assert np.minimum(left, 1.0 - left).max() < 1e-6
    assert sorted(np.round(left).astype(int)) == [0] * 4 + [1] * 4
    waves = [motion.half_waves for motion in found.motions]
    assert waves[::2] == waves[1::2]


@pytest.mark.parametrize("seed", range(4))
def test_any_mixture_is_turned_to_the_same_shapes(seed: int) -> None:
    aside = np.tile([0.0, 1.0, 0.0], 4)
    own = np.zeros((4, 12))
    own[[0, 1, 2, 3], [1, 10, 3, 8]] = 1.0  # two out of the plane, two in it, at either end
    mixed = np.linalg.qr(np.random.default_rng(seed).normal(size=(4, 4)))[0] @ own
    found = untangle(np.full(4, 2j), mixed, np.ones(12), aside)
    where = [int(np.argmax(np.abs(shape))) for shape in found]
    assert where == [3, 8, 1, 10]
    assert np.abs(found).max(axis=1) == pytest.approx(1.0)
