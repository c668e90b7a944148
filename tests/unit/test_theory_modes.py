"""Closed-form frequencies against tabulated numbers, against matrices and against limits."""

from __future__ import annotations

import numpy as np
import pytest

from ropewalk.theory import (
    cable_frequencies,
    cable_parameter,
    chain_decay_times,
    chain_factors,
    chain_frequencies,
    chain_shape,
    hanging_frequencies,
    rigid_chain_frequencies,
    string_frequencies,
)
from ropewalk.theory.chain_modes import ENDS


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
    found = chain_frequencies(20, 1000.0, 0.01, ends)
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
    for mode, mu in enumerate(chain_factors(9, ends), start=1):
        x = chain_shape(9, mode, ends)
        np.testing.assert_allclose(K @ x, mu * M @ x, atol=1e-13)
        assert np.abs(K @ x - 1.01 * (mu + 0.01) * M @ x).max() > 1e-3


def test_decay_times_of_the_report() -> None:
    # Seed systems 3.4: n 19, c 0.05: 81, 20, 9 s; n 39: 324, 81, 36 s.
    np.testing.assert_allclose(chain_decay_times(19, 0.05, 0.05)[:3], [81, 20, 9], rtol=0.03)
    np.testing.assert_allclose(chain_decay_times(39, 0.05, 0.05)[:3], [324, 81, 36], rtol=0.01)
    assert np.isinf(chain_decay_times(19, 0.0, 0.05)).all()


def test_other_ends_are_refused() -> None:
    with pytest.raises(ValueError, match="fixed-half"):
        chain_factors(3, "loose")


def test_taut_string_and_its_chain() -> None:
    # Closed forms 3.1: L 1, mu 0.02, T 50: 157.08, 314.16, 785.4 rad/s; the chain's limit, 1/N^2.
    found = string_frequencies(1.0, 50.0, 0.02, 5)
    np.testing.assert_allclose(found[[0, 1, 4]], [157.0796327, 314.1592654, 785.3981634], rtol=1e-9)
    errors = []
    for n in (50, 100):
        chain = chain_frequencies(n - 1, 50.0 * n, 0.02 / n)
        errors.append(1.0 - chain[0] / found[0])
    # sin(x)/x = 1 - x^2/6 at x = pi/2n
    assert errors[0] == pytest.approx((np.pi / 100) ** 2 / 6.0, rel=1e-3)
    assert errors[0] / errors[1] == pytest.approx(4.0, rel=1e-3)


def test_hanging_rope() -> None:
    # Closed forms 3.3 and 3.4.
    found = hanging_frequencies(1.0, 9.81, 3)
    np.testing.assert_allclose(found, [3.766067388, 8.644696114, 13.55213578], rtol=1e-9)
    for mass, low, high in (
        (0.1, 3.625063669, 8.820116509),
        (0.5, 3.403524092, 10.71142596),
        (2.0, 3.236944663, 16.14668971),
        (10.0, 3.156941066, 32.18671212),
    ):
        ends = hanging_frequencies(1.0, 9.81, 2, end_mass=mass)
        np.testing.assert_allclose(ends, [low, high], rtol=1e-8)
    # So heavy that neighbours are pi / (2 sqrt(1 + M) - 2 sqrt(M)) apart: it took minutes.
    heavy = hanging_frequencies(1.0, 9.81, 3, 1e8)
    np.testing.assert_allclose(np.diff(heavy), np.pi * np.sqrt(9.81) * 1e4, rtol=1e-3)
    assert hanging_frequencies(1.0, 9.81, 0, 1.0).size == 0
    # A heavy load makes it a pendulum, a light one leaves the bare rope.
    assert hanging_frequencies(2.0, 9.81, 1, 1e5)[0] == pytest.approx(np.sqrt(9.81 / 2), rel=1e-5)
    bare, light = hanging_frequencies(2.0, 9.81, 4), hanging_frequencies(2.0, 9.81, 4, 1e-9)
    np.testing.assert_allclose(light, bare, rtol=1e-6)


@pytest.mark.parametrize(
    ("masses", "lowest"),
    [(1, 3.132091953), (2, 3.3901519), (5, 3.595501868), (20, 3.72020515), (100, 3.756702038)],
)
def test_rigid_links_are_laguerre(masses: int, lowest: float) -> None:
    # Closed forms 3.3. The matrix of the chain, T_i = (masses below) m g, as the independent way.
    found = rigid_chain_frequencies(masses, 1.0 / masses)
    assert found[0] == pytest.approx(lowest, rel=1e-9)
    pull = np.arange(masses, 0, -1) * 9.81 * masses
    K = np.diag(pull + np.append(pull[1:], 0.0))
    K -= np.diag(pull[1:], 1) + np.diag(pull[1:], -1)
    np.testing.assert_allclose(found**2, np.linalg.eigvalsh(K), rtol=1e-10)


def test_sagging_cable() -> None:
    # Irvine and Caughey: without stretch stiffness a string; an inextensible cable has the roots of
    # tan(q/2) = q/2, q/2 = 4.493409458 (table of tan x = x); at lambda^2 = 4 pi^2 the first symmetric
    # mode crosses the first antisymmetric one, q = 2 pi.
    unit = np.sqrt(40.0 / 0.05) / 20.0
    soft = cable_frequencies(20.0, 40.0, 0.05, 1e-9, 3)
    np.testing.assert_allclose(soft["symmetric"], np.array([1, 3, 5]) * np.pi * unit, rtol=1e-9)
    np.testing.assert_allclose(soft["across"], np.array([1, 2, 3]) * np.pi * unit, rtol=1e-12)
    stiff = cable_frequencies(20.0, 40.0, 0.05, 1e12, 1)
    assert stiff["symmetric"][0] == pytest.approx(2 * 4.493409458 * unit, rel=1e-8)
    crossing = cable_frequencies(20.0, 40.0, 0.05, 4 * np.pi**2, 1)
    assert crossing["symmetric"][0] == pytest.approx(2 * np.pi * unit, rel=1e-9)
    assert crossing["symmetric"][0] == pytest.approx(crossing["antisymmetric"][0], rel=1e-9)
    # lambda^2 by hand: w 0.5, X 20, H 40: (10/40)^2 * EA / (40 * (1 + 8 (0.625/20)^2))
    expected = 0.0625 * 1e4 / (40.0 * (1.0 + 8.0 * 0.03125**2))
    assert cable_parameter(20.0, 20.0, 40.0, 0.5, 1e4) == pytest.approx(expected, rel=1e-12)


def test_impossible_numbers_are_refused() -> None:
    with pytest.raises(ValueError, match="tension: 0"):
        string_frequencies(1.0, 0.0, 1.0)
    with pytest.raises(ValueError, match="end_mass: -1"):
        hanging_frequencies(1.0, end_mass=-1.0)
    with pytest.raises(ValueError, match="horizontal: 0"):
        cable_parameter(20.0, 20.0, 0.0, 0.5, 1e4)
    with pytest.raises(ValueError, match="masses: 0"):
        rigid_chain_frequencies(0, 1.0)
