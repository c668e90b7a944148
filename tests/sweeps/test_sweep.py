"""A sweep answers with units, refuses before it runs, and tells of runs that break."""

from __future__ import annotations

import json
import warnings
from pathlib import Path

import numpy as np
import pandas as pd
import pytest
import scipy.stats
import xarray as xr

import ropewalk as rw
from ropewalk.record.errors import InputError, RunError
from ropewalk.sweeps.derived import DERIVED
from sweeps.scenes import DOWN, EA, STIFF, alone, rigid, same, store_bytes, swing


def test_a_grid_has_a_dimension_with_units_for_every_parameter() -> None:
    grid = {EA: [1000.0, 2000.0], DOWN: np.linspace(-9.9, -9.7, 3)}
    ds = rw.sweep(swing(), grid, keep=["tension.max", "positions[-1]"], on="here")
    assert ds.tension_max.dims == ("EA", "gravity_2")
    assert ds.EA.attrs["units"] == "N"
    assert ds.gravity_2.attrs == {
        "path": DOWN,
        "units": "m/s^2",
        "long_name": ds.gravity_2.attrs["long_name"],
    }
    assert ds.tension_max.attrs["units"] == "N"
    for stiffness in ds.EA.values:
        for down in ds.gravity_2.values:
            own = alone(swing(), **{EA: float(stiffness), DOWN: float(down)})
            at = ds.sel(EA=stiffness, gravity_2=down)
            assert at.tension_max == own.tension.max()
            np.testing.assert_array_equal(at.positions_last, own.positions[-1])


def test_store_and_memory_hold_the_same(tmp_path: Path) -> None:
    ask = {"keep": ["tension.max", "sag.max[time]"], "samples": 8, "seed": 3, "on": "here"}
    vary = {EA: scipy.stats.norm(2000.0, 100.0), "rope.length": (1.9, 2.1)}
    here = rw.sweep(swing(), vary, **ask)
    there = rw.sweep(swing(), vary, store=tmp_path / "s", **ask)
    assert set(here.variables) == set(there.variables)
    for name in here.variables:
        assert same(np.asarray(here[name].values), np.asarray(there[name].values)), name
        assert here[name].attrs == there[name].attrs
    plain = xr.open_zarr(tmp_path / "s" / "data.zarr")
    assert {"EA", "length"} <= set(plain.coords)
    frame = plain[["tension_max", "status"]].to_dataframe()
    assert list(frame.status) == ["finished"] * 8
    assert frame.EA.between(1500, 2500).all()


def test_a_broken_run_is_a_result(tmp_path: Path) -> None:
    ds = rw.sweep(swing(), {EA: STIFF}, store=tmp_path / "s", on="here")
    assert list(ds.status.values) == ["finished", "finished", "broke"]
    assert "largest stable" in str(ds.reason.values[2])
    assert ds.broke_at.values[2] < 0.1
    assert np.isnan(ds.tension_max.values[2])
    assert np.isfinite(ds.tension_max.values[:2]).all()
    assert rw.sweep.replay(tmp_path / "s", 2).status == "broke"


def test_a_refused_run_is_a_result_and_corners_are_told_before(tmp_path: Path) -> None:
    hanging = rigid()
    with pytest.raises(rw.SceneError, match="shorter than the") as caught:
        rw.sweep(hanging, {"rope.length": [7.0, 12.0]}, on="here", store=tmp_path / "s")
    assert "rope[0].shape.end" in str(caught.value)
    assert not (tmp_path / "s").exists()
    table = pd.DataFrame({"rope.length": [12.0, 13.0, 12.5]})
    ds = rw.sweep(hanging, table, on="here", keep="sag[-1]")
    assert ds.sag_last.dims == ("run", "rope")
    assert list(ds.length.values) == [12.0, 13.0, 12.5]


def test_a_map_of_an_unsorted_grid_is_that_of_the_sorted_one() -> None:
    from ropewalk.plots.sweeps import _map

    def cells(stiffness: list[float]) -> np.ndarray:
        names = {EA: stiffness, "rope.length": [1.9, 2.1]}
        data = xr.Dataset(
            {
                "tension_max": (("EA", "length"), [[e * n for n in (1.9, 2.1)] for e in stiffness]),
                "status": (("EA", "length"), [["finished"] * 2] * len(stiffness)),
            },
            {path.split(".")[-1]: values for path, values in names.items()},
            {"design": "grid"},
        )
        data.tension_max.attrs |= {"units": "N", "long_name": "largest tension"}
        mesh = _map(data, "tension_max", ["EA", "length"]).axes[0].collections[0]
        return np.stack([mesh.get_array().ravel(), mesh.get_coordinates()[:-1, :-1, 0].ravel()])

    np.testing.assert_array_equal(cells([2e3, 1e3, 3e3]), cells([1e3, 2e3, 3e3]))


def test_few_samples_have_no_indices() -> None:
    spread = {EA: (1e3, 2e3)}
    found = rw.uncertain(swing(0.02), spread, samples=4, seed=1, on="here", progress=False)
    assert "No Sobol indices: they need at least 8 samples." in found.note


def test_every_text_of_a_list_is_tried() -> None:
    from ropewalk.sweeps.parameters import make_parameters
    from ropewalk.sweeps.trial import _ends, corners

    vectors = [[0.0, 0.0, -float(i)] for i in range(1, 12)]
    vary = {"gravity": vectors, "rope.segments": list(range(2, 9))}
    ends = [_ends(parameter, None) for parameter in make_parameters(swing(), vary)]
    tried = list(corners(ends))
    assert len({row[0] for row in tried}) == 11
    assert {row[1] for row in tried} == {2, 8}


def test_of_very_many_values_some_are_tried(monkeypatch: pytest.MonkeyPatch) -> None:
    """The least and the largest always; all of 200 are."""
    from ropewalk.sweeps.parameters import make_parameters
    from ropewalk.sweeps.trial import _ends, value_faults
    from ropewalk.sweeps.workshop import Workshop

    tried: list[float] = []
    scene = Workshop.scene

    def note(self: Workshop, row: list[float]) -> rw.Scene:
        tried.append(row[0])
        return scene(self, row)

    monkeypatch.setattr(Workshop, "scene", note)
    for count, most in ((200, 200), (5000, 260)):
        tried.clear()
        values = [1000.0 + i for i in range(count)]
        values[3] = -1.0  # the only wrong one
        values[7] = 1e9
        (parameter,) = made = make_parameters(swing(), {EA: values})
        faults = value_faults(Workshop(swing(), [EA], ["float"]), made, [_ends(parameter, None)])
        assert len(faults) == 1
        assert {-1.0, 1e9} <= set(tried)
        assert len(tried) <= most


@pytest.mark.parametrize(
    ("values", "log"),
    [
        ([500.0, 1000.0, 1e8], True),
        ([500.0, 1e8], True),
        (np.geomspace(1.0, 1e3, 9), True),
        (np.linspace(1.0, 1e3, 9), False),
        (np.random.default_rng(1).uniform(1.0, 1e3, 200), False),
        ([1.0, 40.0], False),
        ([-1.0, 1e3, 1e5], False),
    ],
)
def test_an_axis_of_factors_is_logarithmic(values: list[float], log: bool) -> None:
    from ropewalk.plots.sweeps import _lines

    x = np.asarray(values)
    data = xr.Dataset(
        {"tension_max": ("EA", x), "status": ("EA", ["finished"] * len(x))},
        {"EA": ("EA", x, {"path": EA})}, {"design": "grid"},
    )  # fmt: skip
    data.tension_max.attrs |= {"units": "N", "long_name": "largest tension"}
    scale = _lines(data, "tension_max", "EA").axes[0].get_xscale()
    assert scale == ("log" if log else "linear")


def test_rest_shapes_can_be_swept() -> None:
    hanging = rw.preset("hanging-rope")
    ds = rw.sweep(hanging, {"rope.length": [12.0, 14.0]}, keep="sag[-1]", what="rest", on="here")
    sag = [
        rw.equilibrium(hanging.replace(ropes=[hanging.ropes[0].replace(length=x)]))
        for x in (12.0, 14.0)
    ]
    assert list(ds.status.values) == ["at rest"] * 2
    framed = rw.sweep(hanging, {"rope.length": [12.0]}, keep="sag", what="rest", on="here")
    assert framed.sag.dims == ("length", "time", "rope")
    assert framed.time.values.tolist() == [0.0]
    assert ds.sag_last.values[1, 0] > ds.sag_last.values[0, 0] > 0.0
    lowest = -(sag[0].positions[0] @ np.array(hanging.up)).min()
    assert 0.0 < ds.sag_last.values[0, 0] - lowest < 1.0  # the line lies above the lower end


def test_what_was_asked_is_kept(tmp_path: Path) -> None:
    vary = {EA: scipy.stats.norm(2e3, 10.0)}
    rw.sweep(swing(0.02), vary, samples=4, seed=9, store=tmp_path / "s", on="here")
    facts = json.loads((tmp_path / "s" / "sweep.json").read_text())
    assert facts["parameters"][0]["spread"] == "norm(2000.0, 10.0)"
    assert facts["seed"] == 9
    assert facts["provenance"]["source_hash"]
    assert rw.load(tmp_path / "s" / "scene.toml") == swing(0.02)


def test_any_size_of_batches_gives_the_same(tmp_path: Path) -> None:
    vary = {EA: STIFF, "rope.length": [1.9, 2.0, 2.1]}
    found = [
        rw.sweep(swing(), vary, store=tmp_path / f"s{size}", batch=size, on="here")
        for size in (1, 4, 9)
    ]
    for ds in found[1:]:
        for name in ds.variables:
            assert same(np.asarray(found[0][name].values), np.asarray(ds[name].values))
    assert len(store_bytes(tmp_path / "s1")) > len(store_bytes(tmp_path / "s9"))


def test_a_replayed_run_has_the_bits_of_the_sweep(tmp_path: Path) -> None:
    ds = rw.sweep(
        swing(), {EA: (1e3, 3e3)}, samples=8, seed=1, store=tmp_path / "s", on="here", batch=3
    )
    run = rw.sweep.replay(tmp_path / "s", 5)
    np.testing.assert_array_equal(run.positions[-1], ds.positions_last.values[5])
    own = alone(swing(), **{EA: float(ds.EA[5])})
    np.testing.assert_array_equal(run.positions, own.positions)
    with pytest.raises(RunError, match="0 to 7"):
        rw.sweep.replay(tmp_path / "s", 8)


def test_progress_is_told() -> None:
    told = []
    rw.sweep(swing(), {EA: STIFF}, on="here", batch=1, progress=told.append)
    assert told[-1].done == told[-1].runs == 3
    assert told[-1].broken == 1


def test_a_function_of_a_matrix(tmp_path: Path) -> None:
    f = rw.sweep.function(swing(), [EA, "rope.length"], ["tension.max", "positions[-1, -1]"])
    assert f.columns == ("tension_max", *(f"positions_last_last[{i}]" for i in range(3)))
    made = f([[2000.0, 2.0], [4.0e6, 2.0], [1500.0, 2.1]])
    assert made.shape == (3, 4)
    assert np.isnan(made[1]).all()
    assert f.last.status == ["finished", "broke", "finished"]
    assert f([2000.0, 2.0]).shape == (4,)
    np.testing.assert_array_equal(made[0], f([2000.0, 2.0]))
    own = alone(swing(), **{EA: 1500.0, "rope.length": 2.1})
    assert made[2, 0] == own.table["largest tension [N]"] >= own.tension.max()
    with pytest.raises(InputError, match="N x 2"):
        f([1.0, 2.0, 3.0])


def test_a_large_grid_stays_a_table_on_disk(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    grid = {EA: [1e3, 2e3, 3e3], "rope.length": [1.9, 2.1]}
    rw.sweep(swing(0.02), grid, keep="tension.max", store=tmp_path / "s", on="here")
    small = rw.sweep.open(tmp_path / "s")
    monkeypatch.setattr("ropewalk.sweeps.answer.MOST_BYTES", 0)
    large = rw.sweep.open(tmp_path / "s")
    assert large.tension_max.dims == ("run",)
    made = large.set_index(run=["EA", "length"]).unstack("run")
    np.testing.assert_array_equal(made.tension_max, small.tension_max)


@pytest.mark.parametrize("design", ["grid", "sample"])
def test_damaged_data_are_told_with_the_remedy(tmp_path: Path, design: str) -> None:
    vary = {EA: [1e3, 2e3]} if design == "grid" else {EA: (1e3, 2e3)}
    asked = {} if design == "grid" else {"samples": 2, "seed": 1}
    rw.sweep(swing(0.02), vary, store=tmp_path / "s", on="here", **asked)
    chunk = tmp_path / "s" / "data.zarr" / "tension_max" / "c.0"
    chunk = chunk if chunk.exists() else next((chunk.parent).rglob("0"))
    chunk.write_bytes(chunk.read_bytes()[:-3])
    if design == "grid":
        with pytest.raises(RunError, match="damaged.*ropewalk resume"):
            rw.sweep.open(tmp_path / "s")
    with pytest.warns(UserWarning, match="1 stored batch is damaged and is made again"):
        rw.sweep.resume(tmp_path / "s", on="here")
    assert np.isfinite(rw.sweep.open(tmp_path / "s").tension_max).all()


def test_what_is_no_number_is_told_wherever_it_stands() -> None:
    for column in ([1e3, float("nan")], [float("nan"), 1e3], [1e3, float("nan"), 2e3]):
        with pytest.raises(rw.SceneError, match="nan - must be a finite number"):
            rw.sweep(swing(0.02), pd.DataFrame({EA: column}), on="here")
    for seed in (-1, 1.5, "a"):
        with pytest.raises(rw.SceneError, match="seed: .* - must be a whole number from 0 on"):
            rw.sweep(swing(0.02), {EA: (1e3, 2e3)}, samples=4, seed=seed, on="here")
    for workers in (0, -2):
        with pytest.raises(InputError, match="workers"):
            rw.sweep(swing(0.02), {EA: [1e3]}, workers=workers, on="here")


def test_a_sag_is_no_longer_than_its_rope() -> None:
    """A rope that hangs almost plumb from one end has no line far above it, which it would lie below."""
    result = rw.simulate(rw.preset("r2").replace(run={"duration": 2.0}))
    drop = DERIVED["sag"].of(result)[:, 0]
    longest = np.linalg.norm(np.diff(result.positions, axis=1), axis=2).sum(axis=1)
    assert np.all(drop <= longest)


def test_a_sweep_counts_what_parted() -> None:
    """A string that is pulled by 1 % a hundredth of a second: the weak one parts, the strong one does not."""
    weak = rw.Material(EA=1e4, mass_per_length=0.05, breaking_load=50.0, parts=True)
    string = rw.Rope(segments=4, length=1.0, made_of=weak, shape={"kind": "straight"})
    pulled = rw.Anchor(node=-1, motion={"kind": "velocity", "velocity": (1.0, 0.0, 0.0)})
    scene = rw.Scene(
        ropes=[string], anchors=[rw.Anchor(node=0), pulled],
        run={"duration": 0.01, "time_step": 1e-4, "method": "semi-implicit-euler"},
    )  # fmt: skip
    loads = {"rope.made_of.breaking_load": [50.0, 1e4]}
    ds = rw.sweep(scene, loads, keep=["segments_parted[-1]", "segments_parted"], on="here")
    assert ds.segments_parted_last.values.tolist() == [1.0, 0.0]
    assert ds.segments_parted.values[0, 0] == 0.0
    assert np.all(np.diff(ds.segments_parted.values[0]) >= 0.0)


def test_a_broken_run_is_marked_on_the_axis_where_no_value_is() -> None:
    from ropewalk.plots.sweeps import _lines

    x = np.array([1.0, 2.0])
    data = xr.Dataset(
        {"tension_max": ("EA", [5.0, np.nan]), "status": ("EA", ["finished", "broke"])},
        {"EA": ("EA", x, {"path": EA})}, {"design": "grid"},
    )  # fmt: skip
    data.tension_max.attrs |= {"units": "N", "long_name": "largest tension"}
    axes = _lines(data, "tension_max", "EA").axes[0]
    (mark,) = [line for line in axes.lines if line.get_label() == "broken, no value"]
    np.testing.assert_array_equal(np.asarray(mark.get_xydata()), [[2.0, 0.0]])
    assert mark.get_transform() == axes.get_xaxis_transform()


def test_places_that_a_winch_shifts_are_warned_of() -> None:
    """`positions[-1, 3]` was another node in every run, without a word."""
    scene = swing(0.02).replace(
        winches=[rw.Winch(name="hoist", rope="rope", end="start", speed=0.5)],
        **{"run.duration": 1.0},
    )
    speeds: dict[str, list[float]] = {"winch.speed": [0.0, 0.5]}
    keep = ["positions[-1, 3, 2]", "tension.max", "tension.max[segment]", "reactions[-1, top]"]
    with pytest.warns(UserWarning, match="not the same ones") as told:
        ds = rw.sweep(scene, speeds, keep=keep, on="here", progress=False)
    (said,) = [str(one.message) for one in told]  # nothing of numpy's
    assert "segments of positions[-1, 3, 2], tension.max[segment] are" in said
    on_drum = ds.tension_max_segment.values[1]
    assert np.isnan(on_drum).any()
    assert np.nanmax(on_drum) == ds.tension_max.values[1]
    numbers = [alone(scene, **{"winch.speed": speed}).rope().numbers[3] for speed in (0.0, 0.5)]
    assert numbers[0] != numbers[1]  # it is so
    assert ds.positions_last_3_2.values[0] != ds.positions_last_3_2.values[1]
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        rw.sweep(scene, speeds, keep=["tension.max", "sag.max[time]"], on="here", progress=False)
        same_drum = {"rope.made_of.EA": [1900.0, 2000.0]}
        rw.sweep(scene, same_drum, keep=keep, on="here", progress=False)
