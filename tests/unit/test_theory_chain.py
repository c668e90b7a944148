"""The exact lumped chain: tables, limits, rigid links, and what is refused."""

from __future__ import annotations

import math

import numpy as np
import pytest

from ropewalk.theory import catenary, hanging_chain, lumped_chain

G = 9.81

# Closed forms 2.2: (across, rise, segments, k, m, L) -> lowest node, H.
CASES = {
    "A": (0.8, 0.0, 20, 1000.0, 0.01, 0.05, -0.2783790277, 0.6296854707),
    "B": (0.6, 0.5, 20, 1000.0, 0.01, 0.05, -0.1129124727, 0.3675850581),
    "C": (1.0, 0.0, 20, 1000.0, 0.01, 0.05, -0.1246830154, 1.930593694),
    "D": (1.02, 0.0, 20, 1000.0, 0.01, 0.05, -0.1051722351, 2.348075301),
    "E": (0.8, 0.0, 20, math.inf, 0.01, 0.05, -0.2657915666, 0.663109127),
    "F": (3.95, 0.0, 79, 1e4, 0.05, 0.05, -0.6235371441, 29.8135164),
}


@pytest.mark.parametrize("name", CASES)
def test_pinned_chains_of_the_table(name: str) -> None:
    across, rise, segments, k, m, length, lowest, pull = CASES[name]
    weights = np.full(segments - 1, m * G)
    found = lumped_chain(weights, k, length, across, rise)
    assert found.positions[:, 1].min() == pytest.approx(lowest, abs=1e-10)
    assert found.horizontal == pytest.approx(pull, rel=1e-9)
    np.testing.assert_allclose(found.positions[-1], [across, rise], atol=1e-14)
    wrong = lumped_chain(1.001 * weights, 1.001 * k, length, across, rise)
    assert wrong.horizontal == pytest.approx(1.001 * pull, rel=1e-9)


def test_hanging_chain_of_the_table() -> None:
    # Closed forms 2.1: N 20, m 0.01, k 1000, l 0.05: tip 1.020601, with half a mass there 1.01962.
    weights = np.full(20, 0.01 * G)
    found = hanging_chain(weights, 1000.0, 0.05)
    assert found.positions[-1, 1] == pytest.approx(-1.020601, rel=1e-12)
    assert found.tension[0] == pytest.approx(1.962, rel=1e-12)
    weights[-1] *= 0.5
    assert hanging_chain(weights, 1000.0, 0.05).positions[-1, 1] == pytest.approx(-1.01962)
    assert hanging_chain(weights, math.inf, 0.05).positions[-1, 1] == pytest.approx(-1.0)


def test_rigid_links_converge_to_the_catenary() -> None:
    # Closed forms 2.3: order 2 in the number of links.
    target = catenary(1.0, 0.8).horizontal
    errors = []
    for n in (20, 40, 80):
        found = lumped_chain(np.full(n - 1, 1.0 / n), math.inf, 1.0 / n, 0.8)
        np.testing.assert_allclose(np.hypot(found.along, found.upward), 1.0 / n, rtol=1e-14)
        errors.append(abs(found.horizontal - target))
    assert math.log2(errors[0] / errors[1]) == pytest.approx(2.0, abs=0.02)
    assert math.log2(errors[1] / errors[2]) == pytest.approx(2.0, abs=0.02)


def test_random_chains_close() -> None:
    rng = np.random.default_rng(11)
    for trial in range(400):
        n = int(rng.integers(2, 60))
        k = 10 ** rng.uniform(0, 8, n)
        length = 10 ** rng.uniform(-2, 1, n)
        weights = 10 ** rng.uniform(-4, 2, n - 1)
        if trial % 2:
            k[:], length[:] = k[0], length[0]
        across = 10 ** rng.uniform(-6, 2.5) * length.sum() / 10
        rise = float(rng.normal()) * length.sum()
        found = lumped_chain(weights, k, length, across, rise)
        assert found.along.sum() == pytest.approx(across, abs=1e-10 * (length.sum() + across))
        assert found.upward.sum() == pytest.approx(rise, abs=1e-10 * (length.sum() + across))
        assert np.all(found.tension >= 0.0)
        np.testing.assert_allclose(
            np.diff(found.vertical), weights, atol=1e-14 * np.abs(found.vertical).max()
        )


@pytest.mark.parametrize("k", [1e-3, 1e-6, 1e-12])
def test_a_chain_so_weak_that_its_own_length_does_not_count(k: float) -> None:
    """Springs of no length are linear: level places are even, and the middle hangs n^2 w / (8 k) below.

    A length of 0.05 m beside a sag of 10^4 m and more changes that by some 1e-5. The twin: k 1 % larger.
    """
    n, w = 20, 0.01 * G
    found, other = (lumped_chain(np.full(n - 1, w), one, 0.05, 0.8) for one in (k, 1.01 * k))
    sag = n * n * w / (8.0 * k)
    assert -found.positions[10, 1] == pytest.approx(sag, rel=1e-6 + n * 0.05 / sag)
    assert found.positions[-1] == pytest.approx([0.8, 0.0], abs=1e-11 * sag)
    assert abs(-other.positions[10, 1] - sag) > 5e-3 * sag


def test_random_rigid_chains_close() -> None:
    rng = np.random.default_rng(12)
    for _ in range(200):
        n = int(rng.integers(2, 60))
        length = 10 ** rng.uniform(-2, 1, n)
        weights = 10 ** rng.uniform(-4, 2, n - 1)
        reach = 2.0 * length.sum() - 2.0 * length.max()  # short of where one link cannot fold
        angle = rng.uniform(-1.5, 1.5)
        size = rng.uniform(0.0, 0.999) * min(length.sum(), max(reach, 0.0))
        across, rise = size * math.cos(angle), size * math.sin(angle)
        found = lumped_chain(weights, math.inf, length, across, rise)
        assert found.along.sum() == pytest.approx(across, abs=1e-10 * length.sum())
        assert found.upward.sum() == pytest.approx(rise, abs=1e-10 * length.sum())


@pytest.mark.parametrize("k", [1e3, math.inf])
@pytest.mark.parametrize(
    ("weights", "size"),
    [
        ([1.0, 0.0, 1.0], 1.5),
        ([0.0, 1.0, 0.0], 1.5),
        ([0.0, 0.0, 1.0], 2.0),
        ([1.0, 0.0, 0.0], 0.0),
    ],
)
def test_nodes_without_weight_are_carried_by_their_neighbours(
    weights: list[float], size: float, k: float
) -> None:
    """They ended in an ArithmeticError and in warnings; upright, springs were told to pull 250 N for 1."""
    found = lumped_chain(weights, k, 1.0, size)
    assert found.along.sum() == pytest.approx(size, abs=1e-10)
    assert found.upward.sum() == pytest.approx(0.0, abs=1e-10)
    np.testing.assert_allclose(np.diff(found.vertical), weights, atol=1e-8)
    sizes = 1.0 + found.tension / k
    taut = found.tension > 0.0  # what is slack may be shorter
    np.testing.assert_allclose(np.hypot(found.along, found.upward)[taut], sizes[taut])
    assert found.tension.max() < 2.0
    alone = lumped_chain([], math.inf, 1.0, 0.6, 0.8)
    assert (alone.along[0], alone.upward[0]) == (0.6, 0.8)


@pytest.mark.parametrize(
    ("arguments", "words"),
    [
        (([1.0], math.inf, 0.5, 1.0), "length: 1 m - must be more than the distance of the ends"),
        (([1.0], 10.0, [0.5, 0.5, 0.5], 1.0), "must be one number or 2"),
        (([1.0], 0.0, 0.5, 1.0), "stiffness: must be positive"),
        (([-1.0], 10.0, 0.5, 1.0), "weights: must be finite and not negative"),
        (([1.0], 10.0, math.inf, 1.0), "length: must be finite"),
        (([1.0], 10.0, 0.5, -1.0), "across: -1.0"),
        (([], math.inf, 2.0, 1.0), "length: 2 m - must be the distance of the ends, 1 m"),
    ],
)
def test_impossible_chains_are_refused(arguments, words: str) -> None:
    with pytest.raises(ValueError, match=words):
        lumped_chain(*arguments)
