"""Modes of uniform chains against the tabulated frequencies and against the matrices."""

from __future__ import annotations

import numpy as np
import pytest

from ropewalk.analysis.modes import ENDS, decay_times, frequencies, mode_factors, shape


@pytest.mark.parametrize(
    ("ends", "table"),
    [
        ("fixed-fixed", {1: 47.2634611, 2: 94.26260575, 3: 140.7345957, 20: 630.6870581}),
        ("fixed-free", {1: 24.22477581, 2: 72.53216683, 3: 120.4139102, 20: 630.5997818}),
        ("fixed-half", {1: 24.83008766, 2: 74.33717724, 3: 123.3859534, 20: 631.9679317}),
        ("free-free", {1: 0.0, 2: 49.62188913, 3: 98.93784282, 20: 630.5058827}),
    ],
)
def test_frequencies_of_twenty_masses(ends: str, table: dict[int, float]) -> None:
    # Closed forms 1.1: N 20, m 0.01, k 1000.
    found = frequencies(20, 1000.0, 0.01, ends)
    for j, expected in table.items():
        assert found[j - 1] == pytest.approx(expected, rel=1e-9)


def stiffness(n: int, ends: str) -> tuple[np.ndarray, np.ndarray]:
    K = 2.0 * np.eye(n) - np.eye(n, k=1) - np.eye(n, k=-1)
    M = np.eye(n)
    if ends != "fixed-fixed":
        K[-1, -1] = 1.0
    if ends == "free-free":
        K[0, 0] = 1.0
    if ends == "fixed-half":
        M[-1, -1] = 0.5
    return K, M


@pytest.mark.parametrize("ends", ENDS)
def test_shapes_are_eigenvectors(ends: str) -> None:
    K, M = stiffness(9, ends)
    for mode, mu in enumerate(mode_factors(9, ends), start=1):
        x = shape(9, mode, ends)
        np.testing.assert_allclose(K @ x, mu * M @ x, atol=1e-13)
        assert np.abs(K @ x - 1.01 * (mu + 0.01) * M @ x).max() > 1e-3


def test_decay_times_of_the_report() -> None:
    # Seed systems 3.4: n 19, c 0.05: 81, 20, 9 s; n 39: 324, 81, 36 s.
    np.testing.assert_allclose(decay_times(19, 0.05, 0.05)[:3], [81, 20, 9], rtol=0.03)
    np.testing.assert_allclose(decay_times(39, 0.05, 0.05)[:3], [324, 81, 36], rtol=0.01)
    assert np.isinf(decay_times(19, 0.0, 0.05)).all()


def test_other_ends_are_refused() -> None:
    with pytest.raises(ValueError, match="fixed-half"):
        mode_factors(3, "loose")
