"""What a sweep varies: samples of every design, lists, texts, vectors, and tables of runs."""

from __future__ import annotations

import math
import warnings
from pathlib import Path
from typing import Any

import numpy as np
import pandas as pd
import pytest
import scipy.stats
import xarray as xr

import ropewalk as rw
from ropewalk.record.errors import InputError, RunError
from ropewalk.scene import SceneError, apply_overrides
from ropewalk.sweeps.parameters import make_parameters
from ropewalk.sweeps.spread_text import parse_vary
from sweeps.scenes import EA, alone, rigid, same, swing


def test_a_table_is_tried_at_its_own_rows() -> None:
    """Neither end of the first rope reaches the end of the second; a table that says so is right."""
    end = "rope.shape.end"
    hanging = rigid()
    near, far = [2.0, 0.0, 0.0], [11.0, 0.0, 0.0]
    right = {"rope.length": [3.0, 12.0], end: [near, far], "run.duration": [0.02, 0.04]}
    table = pd.DataFrame(right)
    ds = rw.sweep(hanging, table, on="here", keep="sag[-1]")
    assert list(ds.status.values) == ["finished", "finished"]
    wrong = pd.DataFrame(right | {"rope.length": [12.0, 3.0]})
    with pytest.raises(rw.SceneError, match=r"shorter than the .*\(with rope.length=3.0"):
        rw.sweep(hanging, wrong, on="here", keep="sag[-1]")


def test_runs_beyond_the_tails_are_good_ones() -> None:
    """The largest of a sample is larger than 99.9 % of the distribution."""
    spread = scipy.stats.geom(0.4)
    soft = apply_overrides(swing(0.02), [f"{EA}=200.0", "rope.made_of.axial_damping=0.1"])
    ds = rw.sweep(
        soft, {"rope.segments": spread}, samples=64, design="random", seed=34,
        keep="positions[-1]", on="here",
    )  # fmt: skip
    assert ds.segments.max() > spread.ppf(0.999)
    assert set(ds.status.values.tolist()) == {"finished"}
    assert ds.sizes["node"] == ds.segments.max() + 1


def test_numbers_as_texts_are_numbers() -> None:
    """As a column of a text file has them."""
    ask = {"keep": ["tension.max", "tension.max"], "on": "here"}  # kept once
    as_texts = rw.sweep(swing(0.02), {EA: ["1e3", "2000"], "rope.segments": ["2"]}, **ask)
    as_numbers = rw.sweep(swing(0.02), {EA: [1e3, 2e3], "rope.segments": [2]}, **ask)
    assert as_texts.identical(as_numbers)
    assert as_texts.EA.dtype == np.float64
    assert list(as_texts.data_vars) == ["status", "notes", "reason", "broke_at", "tension_max"]


def test_samples_are_those_of_scipy_and_the_same_for_a_seed() -> None:
    from scipy.stats import qmc

    spread = scipy.stats.norm(2000.0, 50.0)
    vary = {EA: spread, "rope.length": (1.9, 2.1), "rope.segments": (3, 5)}
    ds = rw.sweep(swing(0.02), vary, samples=16, seed=11, keep="tension.max", on="here")
    points = qmc.Sobol(3, rng=np.random.default_rng(11)).random(16)
    np.testing.assert_array_equal(ds.EA, spread.ppf(points[:, 0]))
    np.testing.assert_array_equal(ds.length, 1.9 + points[:, 1] * (2.1 - 1.9))
    np.testing.assert_array_equal(ds.segments, 3 + np.floor(3 * points[:, 2]))
    assert ds.attrs["seed"] == 11
    again = rw.sweep(swing(0.02), vary, samples=16, seed=11, keep="tension.max", on="here")
    assert ds.identical(again)
    with warnings.catch_warnings(record=True) as told:
        warnings.simplefilter("always")
        rw.sweep(swing(0.02), vary, samples=12, seed=1, keep="tension.max", on="here")
    assert "no power of two" in str(told[0].message)


@pytest.mark.parametrize("design", ["sobol", "lhs", "halton", "random"])
def test_every_design_fills_the_range(design: str) -> None:
    ds = rw.sweep(swing(0.02), {EA: (1000.0, 3000.0)}, samples=32, design=design, seed=5, on="here")
    values = np.sort(ds.EA.values)
    assert values[0] < 1200.0
    assert values[-1] > 2800.0
    assert len(set(values)) == 32


def test_a_list_with_samples_is_drawn_from() -> None:
    ds = rw.sweep(
        swing(0.02), {EA: [1e3, 2e3, 3e3], "rope.length": (1.9, 2.1)}, samples=64, seed=1, on="here"
    )
    found, counts = np.unique(ds.EA, return_counts=True)
    assert list(found) == [1e3, 2e3, 3e3]
    assert counts.min() >= 20


def test_texts_switches_and_vectors_can_vary() -> None:
    ds = rw.sweep(
        swing(0.02),
        {"method": ["verlet", "rk4"], "gravity": [[0, 0, -9.81], [0, 0, -1.62]]},
        keep="tension.max",
        on="here",
    )
    assert ds.tension_max.dims == ("run_method", "gravity")
    moon = alone(swing(0.02), method="rk4", gravity=[0, 0, -1.62])
    assert ds.tension_max.sel(run_method="rk4", gravity="[0, 0, -1.62]") == moon.tension.max()


def test_runs_of_different_shapes_are_filled_up() -> None:
    ds = rw.sweep(swing(), {"rope.segments": [2, 5]}, keep="positions[-1]", on="here")
    assert ds.positions_last.shape == (2, 6, 3)
    assert np.isnan(ds.positions_last.values[0, 3:]).all()
    assert np.isfinite(ds.positions_last.values[0, :3]).all()


def test_the_answer_of_one_sweep_gives_the_runs_of_the_next() -> None:
    first = rw.sweep(
        swing(0.02), {EA: (1e3, 3e3)}, samples=4, seed=2, keep="tension.max", on="here"
    )
    second = rw.sweep(swing(0.02), first, keep="tension.max", on="here")
    np.testing.assert_array_equal(first.tension_max, second.tension_max)


def test_a_grid_given_as_runs_is_refused_and_not_paired() -> None:
    grid = xr.Dataset({EA: ("a", [1e3, 2e3]), "gravity[2]": ("b", [-9.0, -10.0])})
    with pytest.raises(rw.SceneError, match="parameters along a, b; the runs need one dimension"):
        rw.sweep(swing(0.02), grid, on="here")
    runs = xr.Dataset({EA: ("a", [1e3, 2e3]), "gravity[2]": ("a", [-9.0, -10.0])})
    assert rw.sweep(swing(0.02), runs, keep="tension.max", on="here").sizes["run"] == 2


@pytest.mark.parametrize("stored", [True, False])
def test_what_a_table_says_of_its_runs_is_kept(tmp_path: Path, stored: bool) -> None:
    ask = {"keep": "tension.max", "on": "here", "batch": 2}
    ask |= {"store": tmp_path / "s"} if stored else {}
    frame = pd.DataFrame(
        {EA: [1e3, 2e3, 3e3]}, index=pd.Index(["soft", "mid", "hard"], name="rope")
    )
    ds = rw.sweep(swing(0.02), frame, **ask)
    assert ds.given_rope.values.tolist() == ["soft", "mid", "hard"]  # `rope` is a dimension
    assert ds.given_rope.dims == ("run",)
    table = xr.Dataset(
        {EA: ("test", [1e3, 2e3])},
        {"test": [7, 9], "batch_no": ("test", [0.5, 1.5], {"units": "1"}), "site": "north"},
    )
    ds = rw.sweep(swing(0.02), table, **(ask | {"overwrite": True})).load()
    assert ds.test.values.tolist() == [7, 9]
    assert ds.batch_no.values.tolist() == [0.5, 1.5]
    assert ds.batch_no.attrs == {"units": "1"}
    assert ds.site.values.tolist() == ["north", "north"]
    plain = rw.sweep(swing(0.02), pd.DataFrame({EA: [1e3, 2e3]}), **(ask | {"overwrite": True}))
    assert "index" not in plain.coords
    some = rw.sweep(swing(0.02), ds.isel(run=[1, 0]), **(ask | {"overwrite": True}))
    assert some.given_run.values.tolist() == [1, 0]
    assert same(some.tension_max.values, ds.tension_max.values[::-1])


def test_arrays_and_distributions_of_all_kinds() -> None:
    array = xr.DataArray([1e3, 2e3], dims="a", name=EA)
    ask = {"keep": "tension.max", "on": "here"}
    as_runs = rw.sweep(swing(0.02), array, **ask)
    as_list = rw.sweep(swing(0.02), {EA: array}, **ask)
    as_series = rw.sweep(swing(0.02), {EA: pd.Series([1e3, 2e3])}, **ask)
    assert as_runs.tension_max.dims == ("run",)
    assert as_list.tension_max.dims == as_series.tension_max.dims == ("EA",)
    assert same(as_runs.tension_max.values, as_list.tension_max.values)
    with pytest.raises(rw.SceneError, match="a column without a path"):
        rw.sweep(swing(0.02), xr.DataArray([1e3, 2e3]), **ask)
    drawn = {"samples": 8, "seed": 2, **ask}
    old = rw.sweep(swing(0.02), {EA: scipy.stats.norm(2e3, 50.0)}, **drawn)
    new = rw.sweep(swing(0.02), {EA: scipy.stats.Normal(mu=2e3, sigma=50.0)}, **drawn)
    np.testing.assert_allclose(new.EA, old.EA, rtol=1e-12)
    for given in (scipy.stats.norm, scipy.stats.Normal):
        with pytest.raises(rw.SceneError, match="without its parameters; give them"):
            rw.sweep(swing(0.02), {EA: given}, **drawn)
    for given in (scipy.stats.norm([1e3, 2e3], 1.0), scipy.stats.norm(1e3, -1.0)):
        with pytest.raises(rw.SceneError, match="is no distribution of one number"):
            rw.sweep(swing(0.02), {EA: given}, **drawn)


NAMED = {
    "tension_max": "has the name of tension.max, which is kept",
    "a/b": "is no name for a coordinate",
    "../../esc": "is no name for a coordinate",
    "zarr.json": "is an index or a coordinate, which is not varied",
    "": "is no name for a coordinate",
    "rope.length": "is an index or a coordinate, which is not varied",
}


@pytest.mark.parametrize("name", NAMED)
@pytest.mark.parametrize("stored", [True, False])
def test_a_name_that_an_index_cannot_have_is_refused(
    tmp_path: Path, name: str, stored: bool
) -> None:
    """It took the place of the results, or was a file somewhere, or looked as if it were varied."""
    store = tmp_path / "in" / "s" if stored else None
    index = pd.Index([1.5, 2.5], name=name)
    frame = pd.DataFrame({EA: [1000.0, 2000.0]}, index=index)
    table = xr.Dataset({EA: ("run", [1000.0, 2000.0])}, {name: ("run", [1.5, 2.5])})
    for given in (frame, table):
        with pytest.raises(rw.SceneError, match=NAMED[name]):
            rw.sweep(swing(), given, keep="tension.max", store=store, on="here")
    assert not any(path.is_file() for path in tmp_path.rglob("*"))


def test_a_parameter_is_not_named_like_what_is_kept() -> None:
    """Two things had one name, and the results were lost."""
    ring = ["run.start=at-rest", "run.ring={mode = 1, speed = 0.2}"]
    ringing = apply_overrides(swing(), ring)
    ds = rw.sweep(ringing, {"run.ring.speed": [0.1, 0.2]}, keep=["speed"], on="here")
    assert list(ds.ring_speed.values) == [0.1, 0.2]
    assert "speed" in ds.data_vars


def test_a_column_with_a_path_beside_the_answer_of_a_sweep_is_varied() -> None:
    """It was dropped, as the others say their path in an attribute."""
    first = rw.sweep(swing(), {EA: (1e3, 2e3)}, samples=2, seed=1, keep="tension.max", on="here")
    more = first.assign({"rope.length": ("run", [1.9, 2.0])})
    ds = rw.sweep(swing(), more, keep="tension.max", on="here")
    assert list(ds.length.values) == [1.9, 2.0]
    own = alone(swing(), **{EA: float(first.EA[0]), "rope.length": 1.9})
    assert ds.tension_max.values[0] == own.table["largest tension [N]"]
    assert ds.tension_max.values[0] != pytest.approx(first.tension_max.values[0], rel=1e-3)


def test_dates_are_kept_as_they_are_written() -> None:
    days = np.array(["2026-11-22", "2026-11-23"], "datetime64[ns]")
    table = xr.Dataset({EA: ("run", [1e3, 2e3])}, {"day": ("run", days)})
    ds = rw.sweep(swing(), table, keep="tension.max", on="here")
    assert [text[:10] for text in ds.day.values] == ["2026-11-22", "2026-11-23"]


@pytest.mark.parametrize(
    ("options", "text"),
    [
        ({"keep": 3}, "must be a text"),
        ({"batch": "2"}, "must be a whole number of runs"),
        ({"batch": 1.5}, "must be a whole number of runs"),
        ({"workers": 1.5}, "must be a whole number of processes"),
        ({"on": 3.5}, "must be a Dask client"),
        ({"on": "tcp://127.0.0.1:9"}, "no Dask scheduler answers there"),
    ],
)
def test_options_that_cannot_be_are_told_before_a_folder_is_made(
    tmp_path: Path, options: dict[str, Any], text: str
) -> None:
    store = tmp_path / "s"
    asked = {"keep": "tension.max", "on": "here"} | options
    with pytest.raises((InputError, RunError, rw.SceneError), match=text):
        rw.sweep(swing(), {EA: [1e3, 2e3]}, store=store, **asked)
    assert not store.exists()
    right = asked | {"keep": "tension.max", "on": "here", "batch": None, "workers": None}
    rw.sweep(swing(), {EA: [1e3, 2e3]}, store=store, **right)


def test_a_function_rounds_whole_numbers_and_a_sweep_refuses_fractions() -> None:
    """Samplers draw fractions; one that is no number at all is a run that is refused."""
    f = rw.sweep.function(swing(0.02), ["rope.segments"], "tension.max", what="rest")
    found = f([[3.6], [4.0], [4.5], [5.0], [math.nan], [math.inf]])[:, 0]
    assert found[0] == found[1] == found[2] != found[3]
    assert np.isnan(found[4:]).all()
    assert f.last.status[4:] == ["refused", "refused"]
    with pytest.raises(rw.SceneError, match="whole number"):
        rw.sweep(swing(0.02), {"rope.segments": [4.5]}, on="here")


def test_ranges_and_lists_may_have_units() -> None:
    """On the command line and in Python; stored in the field's unit, a wrong kind refused as it was given."""
    assert parse_vary("rope.length=11.9 m..12.1 m") == ("rope.length", ("11.9 m", "12.1 m"))
    assert parse_vary("rope.length=-1e1..2e1 cm") == ("rope.length", ("-1e1 cm", "2e1 cm"))
    assert parse_vary("rope.length=9.5..10.5") == ("rope.length", (9.5, 10.5))
    for what in ("1..x", "x..2 m", "1 m..2"):
        with pytest.raises(InputError, match=r"LOW\.\.HIGH UNIT"):
            parse_vary(f"rope.length={what}")
    scene = rw.preset("hanging-rope")
    (drawn,) = make_parameters(scene, {"rope.length": ("1190 cm", "12.1 m")})
    assert drawn.spread == pytest.approx((11.9, 12.1))
    (listed,) = make_parameters(scene, {"rope.length": ["12 m", "40 ft", 13.0]})
    assert listed.values == pytest.approx((12.0, 12.192, 13.0))
    assert listed.kind == "float"
    (steps,) = make_parameters(scene, {"run.time_step": ["auto", "0.05 ms"]})
    assert steps.values == ("auto", "0.05 ms")
    with pytest.raises(SceneError, match='rope.length: "12 kg" - is of another kind'):
        make_parameters(scene, {"rope.length": ("11 m", "12 kg")})


def test_an_energy_error_is_kept_by_its_size_over_all_steps() -> None:
    """That of implicit Euler is a loss: the largest of the signed frames was 0, of the first one."""
    scene = swing(0.1).replace(**{"run.method": "implicit-euler", "run.time_step": 0.005})
    keep = ["energy_error.max", "energy_error", "energy_error[-1]"]
    ds = rw.sweep(scene, {EA: [1500.0, 2000.0]}, keep=keep, on="here")
    for stiffness in ds.EA.values:
        own, at = alone(scene, **{EA: float(stiffness)}), ds.sel(EA=stiffness)
        assert at.energy_error_max == own.table["largest energy error [J]"] > 1e-4
        assert own.energy_error[-1] < 0.0
        np.testing.assert_array_equal(at.energy_error, np.abs(own.energy_error))
        assert at.energy_error_last == -own.energy_error[-1]
    assert ds.energy_error_max.attrs["long_name"] == (
        "largest size of the energy that no law accounts for, over all steps"
    )


def test_what_no_step_was_looked_at_for_is_said_to_be_of_the_frames() -> None:
    keep = ["tension.max", "energy_error.max", "sag.max", "tension[-1].max"]

    def said(scene: rw.Scene, **more: Any) -> list[str]:
        ds = rw.sweep(scene, {EA: [2e3]}, keep=keep, on="here", **more)
        names = [name for name in ds.data_vars if "keep" in ds[name].attrs]
        return [str(ds[name].attrs["long_name"]).partition(", ")[2] for name in names]

    frames, steps = "over the recorded frames", "over all steps"
    assert said(swing(0.02)) == [steps, steps, frames, ""]
    quick = swing(0.02).replace(**{"run.extremes": False})
    assert said(quick) == [frames, frames, frames, ""]


def test_exact_steps_between_the_corners_have_frames_of_their_own() -> None:
    """At 50 frames a second 1 ms and 2 ms fit into a frame of 20 ms; 1.1 ms make one of 19.8 ms."""
    exact = swing(0.2).replace(**{"run.steps": "exact"})
    keep = "tension.max[time]"

    def dims(scene: rw.Scene, vary: dict[str, Any], **more: Any) -> tuple[Any, ...]:
        return rw.sweep(scene, vary, keep=keep, on="here", **more).tension_max_time.dims[1:]

    for path in ("run.time_step", "time_step"):
        assert dims(exact, {path: [0.001, 0.0011, 0.0013, 0.002]}) == ("frame",)
    assert dims(exact, {"time_step": [0.001, 0.002]}) == ("time",)
    assert dims(swing(0.2), {"time_step": [0.001, 0.0011, 0.002]}) == ("time",)
    assert dims(exact, {EA: [1e3, 1.5e3, 2e3]}) == ("time",)
    times = {alone(exact, time_step=step).time[-1] for step in (0.001, 0.0011, 0.002)}
    assert len(times) == 2  # it is so


def test_the_ends_of_a_distribution_are_told() -> None:
    """The second number of scipy's uniform is a width."""
    for text, told in (
        ("uniform(3, 3.5)", "uniform(3.0, 3.5): 3 to 6.5"),
        ("truncnorm(-2, 2, 100, 5)", "truncnorm(-2.0, 2.0, 100.0, 5.0): 90 to 110"),
        ("norm(3, 0.1)", "norm(3.0, 0.1)"),
        ("gamma(2, 3, 1)", "gamma(2.0, 3.0, 1.0)"),
    ):
        (made,) = make_parameters(swing(), dict([parse_vary(f"rope.length={text}")]))
        assert made.described()["spread"] == told


def test_of_values_that_must_be_whole_only_those_that_are_not_are_refused() -> None:
    with pytest.raises(SceneError) as caught:
        make_parameters(swing(), {"rope.segments": [3, 4.5, 5.0, 6.25]})
    assert [(fault.path, fault.value) for fault in caught.value.faults] == [
        ("rope.segments", 4.5), ("rope.segments", 6.25)
    ]  # fmt: skip
