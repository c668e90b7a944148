"""Bands and Sobol indices of a scene whose answer is known in closed form.

A rope that hangs at rest from one anchor pulls its uppermost segment with m L g (1 - 1/(2 n)): all of its
mass but the half segment at the anchor. With mass per length and gravity independent, that is a product.
"""

from __future__ import annotations

from importlib.util import find_spec
from pathlib import Path
from typing import Any

import numpy as np
import pytest
import scipy.stats

import ropewalk as rw
from ropewalk.sweeps.summary import summary
from ropewalk.sweeps.sweep_folder import SweepFolder
from ropewalk.sweeps.uncertainty import _indices, _sizes
from sweeps.scenes import DOWN, EA, swing

MASS = "rope.made_of.mass_per_length"
WEIGHT = 2.0 * (1.0 - 1.0 / 8.0)  # length [m] of rope that the uppermost of four segments carries
NORMAL = scipy.stats.norm(0.1, 0.01)
GRAVITY = (-12.0, -8.0)


def hanging(spreads: dict[str, Any], samples: int, seed: int = 5) -> rw.Uncertainty:
    """The rope at rest with values that are not known."""
    return rw.uncertain(
        swing(0.02), spreads, samples=samples, seed=seed, what="rest", on="here", progress=False
    )


def off(found: rw.Uncertainty, spread: Any) -> float:
    """Largest error of the bands against the quantiles of a distribution of mass, in its deviations."""
    exact = spread.ppf([0.05, 0.5, 0.95]) * WEIGHT * 9.81
    return float(np.abs(found.bands.tension_max.values - exact).max() / (0.01 * WEIGHT * 9.81))


def test_bands_are_the_quantiles_of_the_distribution() -> None:
    found = hanging({MASS: NORMAL}, 128)
    assert off(found, NORMAL) < 0.05
    assert off(found, scipy.stats.norm(0.1, 0.0105)) > 0.05  # the same, five percent wider
    (row,) = [row for row in found.table() if row[0] == "tension_max"]
    assert row[1:3] == ("N", pytest.approx(NORMAL.ppf(0.05) * WEIGHT * 9.81, rel=5e-3))


def test_bands_read_from_the_folder_are_those_that_were_told(tmp_path: Path) -> None:
    """`info` took its quantiles of all runs: half of Saltelli's repeat values of the sample."""
    from ropewalk.plots.sweeps import sweep as drawn

    ask: dict[str, Any] = {"samples": 16, "on": "here", "progress": False, "store": tmp_path / "s"}
    found = rw.uncertain(swing(0.02), {MASS: NORMAL, DOWN: GRAVITY}, seed=5, **ask)
    facts = summary(SweepFolder.open(tmp_path / "s"))
    (told,) = [kept["quantiles"] for kept in facts["kept"] if kept["name"] == "tension_max"]
    assert told[1:4] == found.bands.tension_max.values.tolist()
    every = found.runs.tension_max.values
    assert [told[0], told[4]] == [every.min(), every.max()]
    groups = 4 if find_spec("SALib") else 1
    assert facts["runs"] == groups * facts["plain"] == groups * 16 == groups * found.sample
    assert facts["sample"] == found.sample
    if groups > 1:
        assert told[1:4] != np.quantile(every, [0.05, 0.5, 0.95]).tolist()
    line = drawn(rw.sweep.open(tmp_path / "s"), "tension_max_time").axes[0].lines[0]
    middle = found.bands.tension_max_time.sel(quantile=0.5)
    np.testing.assert_array_equal(line.get_ydata(), middle)
    assert f" of {found.sample} of them" in repr(found)


def test_bands_of_few_runs_are_said_to_be_narrow() -> None:
    """Of four even samples the quantiles 5 and 95 % are some 16 and 84 % of the spread."""
    few, more = hanging({MASS: NORMAL}, 4), hanging({MASS: NORMAL}, 32)
    assert "Bands of 4 runs are too narrow" in few.note
    assert few.note.count("take 64 samples or more") == 1
    assert "too narrow" not in more.note
    wide = scipy.stats.norm(0.1, 0.01).ppf(0.95) * WEIGHT * 9.81
    assert float(few.bands.tension_max[2]) < 0.96 * wide < float(more.bands.tension_max[2])


@pytest.mark.parametrize(("samples", "few"), [(20, True), (21, False)])
def test_few_are_those_whose_quantile_is_between_the_two_least(samples: int, few: bool) -> None:
    """Of twenty, too: from least to largest there are nineteen steps, and 5 % of those is less than one."""
    found = hanging({MASS: NORMAL}, samples)
    values = np.sort(found.runs.tension_max.values[:: len(found.runs.run) // samples])
    assert len(values) == found.sample == samples
    low = float(found.bands.tension_max[0])
    assert bool(low < values[1] * (1.0 - 1e-9)) is few
    assert found.few is few is ("too narrow" in found.note)


def test_where_runs_broke_it_is_said_that_bands_are_of_few_for_that(tmp_path: Path) -> None:
    """Where 64 had been taken, the advice was to take 64; `info` counted the broken ones in."""
    ask: dict[str, Any] = {"samples": 32, "on": "here", "progress": False, "store": tmp_path / "s"}
    found = rw.uncertain(swing(0.04), {EA: (1e3, 5e4)}, seed=5, **ask)
    assert 0 < found.sample < 21  # above some 2.5e4 N they break
    assert f"{32 - found.sample} of the 32 samples broke" in found.note
    assert "take 64" not in found.note
    facts = summary(SweepFolder.open(tmp_path / "s"))
    assert (facts["sample"], facts["plain"]) == (found.sample, 32)
    told = facts["kept"][0]["quantiles"][1:4]
    assert told == found.bands.tension_max.values.tolist()


def test_where_all_runs_broke_it_is_said_that_there_are_no_bands() -> None:
    """It ended in an error of numpy's."""
    with pytest.raises(rw.SceneError, match="none of the samples ended well"):
        rw.uncertain(swing(0.04), {EA: (1e5, 2e5)}, samples=4, seed=5, on="here", progress=False)


def exact_indices(one: tuple[float, float], other: tuple[float, float]) -> tuple[float, float]:
    """First and total index of one factor of a product, from mean and deviation of both factors."""
    (a, s), (b, t) = one, other
    whole = (b * s) ** 2 + (a * t) ** 2 + (s * t) ** 2
    return (b * s) ** 2 / whole, ((b * s) ** 2 + (s * t) ** 2) / whole


def test_sobol_indices_are_those_of_a_product() -> None:
    """A wide mass, so that the two factors act together as well."""
    pytest.importorskip("SALib")
    wide = scipy.stats.uniform(0.02, 0.18)
    mass, gravity = (wide.mean(), wide.std()), (10.0, 4.0 / np.sqrt(12.0))
    found = hanging({MASS: wide, DOWN: GRAVITY}, 512)
    assert found.sobol is not None
    exact = np.array([exact_indices(mass, gravity), exact_indices(gravity, mass)]).T
    made = found.sobol.tension_max
    assert made.dims == ("order", "parameter")
    assert made.parameter.values.tolist() == ["mass_per_length", "gravity_2"]
    half = found.sobol.tension_max_ci.values
    assert np.abs(made.values - exact).max() < 0.01
    assert (np.abs(made.values - exact) <= half).all()
    assert (half < 0.2).all()
    without = np.array([[exact[0, 0], exact[0, 1]]] * 2)  # of a sum: no share of both together
    assert np.abs(made.values - without).max() > 0.01
    assert np.abs(made.values - exact[:, ::-1]).max() > 0.5


def test_intervals_of_the_indices_are_told() -> None:
    pytest.importorskip("SALib")
    found = hanging({MASS: NORMAL, DOWN: (-9.9, -9.7)}, 64)
    total = found.sobol.tension_max.sel(order="total").values
    half = found.sobol.tension_max_ci.sel(order="total").values
    told = f"mass_per_length {total[0]:.2f} ± {half[0]:.2f}"
    assert told in repr(found)
    few = hanging({MASS: NORMAL, DOWN: (-9.9, -9.7)}, 8)
    wide = few.sobol.tension_max_ci + few.sobol.tension_max
    assert wide.max() > 1.1
    axes = few.plot().axes[1]
    assert axes.get_xlim()[1] > wide.max()


@pytest.mark.parametrize(("noise", "shared"), [(1e-10, False), (1e-7, True)])
def test_what_solvers_leave_is_not_shared_out(noise: float, shared: bool) -> None:
    """A result that nothing changes had an index of 1.15; one that changes a little has its own."""
    pytest.importorskip("SALib")
    found = hanging({MASS: NORMAL}, 8)
    size = 1.0 + noise * np.random.default_rng(1).normal(size=len(found.runs.run))
    runs = found.runs.assign(tension_max=found.runs.tension_max.copy(data=800.0 * size))
    made, _ = _indices(runs, ["mass_per_length"], 5, {})
    assert made is not None
    assert ("tension_max" in made) is shared


@pytest.mark.parametrize("none", [False, True])
@pytest.mark.parametrize(("moves", "shared"), [(1e-13, False), (1e-6, True)])
def test_what_is_zero_to_rounding_is_not_shared_out(moves: float, shared: bool, none: bool) -> None:
    """Zero differs by as much as it is: a sag of 1e-13 m had indices; so had all forces where none is."""
    pytest.importorskip("SALib")
    scene, spreads = swing(0.02), {MASS: NORMAL}
    found = hanging(spreads, 8)
    noise = moves * np.random.default_rng(1).normal(size=len(found.runs.run))
    runs = found.runs.assign(
        sag_max=found.runs.sag_max.copy(data=noise[:, None]),
        reactions_max=found.runs.reactions_max.copy(data=noise[:, None]),
        tension_max=found.runs.tension_max.copy(
            data=noise if none else found.runs.tension_max.values
        ),
    )
    made, _ = _indices(runs, ["mass_per_length"], 5, _sizes(scene))
    assert made is not None
    assert ("sag_max[rope]" in made) is shared
    assert ("reactions_max[top]" in made) is shared
    assert ("tension_max" in made) is (shared or not none)


def test_seed_and_spreads_are_kept_and_give_the_same_runs(tmp_path: Path) -> None:
    spreads = {MASS: NORMAL, DOWN: (-9.9, -9.7)}
    ask: dict[str, Any] = {"samples": 8, "on": "here", "progress": False, "what": "rest"}
    found = rw.uncertain(swing(0.02), spreads, store=tmp_path / "s", **ask)
    facts = summary(SweepFolder.open(tmp_path / "s"))
    assert [about["spread"] for about in facts["parameters"]] == ["norm(0.1, 0.01)", "-9.9 to -9.7"]
    assert facts["design"] == ("saltelli" if find_spec("SALib") else "sobol")
    seed = facts["seed"]
    assert found.runs.attrs["seed"] == seed
    again = rw.uncertain(swing(0.02), spreads, seed=seed, **ask)
    np.testing.assert_array_equal(again.runs.mass_per_length, found.runs.mass_per_length)
    other = rw.uncertain(swing(0.02), spreads, seed=seed + 1, **ask)
    assert (other.runs.mass_per_length.values != found.runs.mass_per_length.values).any()
