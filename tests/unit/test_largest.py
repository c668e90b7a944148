"""The largest residuals of a stage, found in integers, against numpy's."""

from __future__ import annotations

import numpy as np
import pytest

from ropewalk.core.saddle import Saddle, make_saddle
from ropewalk.methods.rounding import EPSILON
from ropewalk.methods.stage import find_worst, largest_force, largest_misfit
from ropewalk.methods.stage_report import HISTORY, MISFIT, NODE, RESIDUAL, SCALE, TIGHT

NODES, C2 = 37, 0.005


def looked(saddle: Saddle, tension: float = 0.0) -> tuple[np.ndarray, tuple[float, float, float]]:
    """Return the report on random numbers, and largest force, scale and misfit as numpy has them."""
    rng = np.random.default_rng(3)
    v, known, x, friction = (rng.normal(size=(3, NODES)) for _ in range(4))
    friction = np.column_stack((friction, np.zeros(3)))
    mass, free, rest = rng.uniform(0.1, 2.0, NODES), np.ones(NODES), rng.uniform(size=NODES - 1)
    pull, gravity, report = (
        rng.normal(size=NODES - 1),
        np.array([0.0, 0.0, -9.81]),
        np.zeros(HISTORY),
    )
    free[0], pull[4] = 0.0, tension
    largest_force(v, known, mass, free, gravity, C2, saddle.force, report)
    rate = np.maximum(np.abs(v - known).sum(axis=0) / C2, 9.81)
    assert report[SCALE] == pytest.approx((mass * free * rate).max(), rel=1e-15)
    largest_misfit(x, pull, rest, friction, saddle, report)
    scale = max((mass * free * rate).max(), np.abs(pull).max(), np.abs(friction[:, 1:-1]).max())
    size = np.maximum(np.abs(x[:, :-1]).max(axis=0), rest)
    allowed = TIGHT * scale * saddle.compliance + 1e-13 * rest + 8.0 * EPSILON * size
    return report, (np.abs(saddle.force).max(), scale, (np.abs(saddle.misfit) / allowed).max())


def residuals() -> Saddle:
    """Return equations with random residuals and compliances."""
    rng, saddle = np.random.default_rng(4), make_saddle(NODES)
    saddle.force[:], saddle.misfit[:] = rng.normal(size=(3, NODES)), rng.normal(size=NODES - 1)
    saddle.compliance[:] = rng.uniform(size=NODES - 1)
    return saddle


@pytest.mark.parametrize("tension", [0.0, -1e9])
def test_the_largest_are_those_that_numpy_finds(tension: float) -> None:
    saddle = residuals()
    report, expected = looked(saddle, tension)
    assert report[[RESIDUAL, SCALE, MISFIT]] == pytest.approx(expected, rel=1e-14)
    find_worst(saddle.force, report)
    assert report[NODE] == np.abs(saddle.force).max(axis=0).argmax()


def test_what_is_no_number_is_larger_than_all() -> None:
    """Wherever it stands: else a stage with one could count as solved."""
    for node in (0, 5, NODES - 2):
        saddle = residuals()
        saddle.force[1, node] = saddle.misfit[node] = np.nan
        report, _ = looked(saddle)
        assert np.isnan(report[RESIDUAL])
        assert np.isnan(report[MISFIT])
        find_worst(saddle.force, report)
        assert report[NODE] == node
