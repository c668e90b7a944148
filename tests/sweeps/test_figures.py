"""What the figures of sweeps show: the numbers they are made of, where those belong, with their units."""

from __future__ import annotations

import itertools
from typing import Any

import numpy as np
import pytest
import xarray as xr
from matplotlib.axes import Axes
from matplotlib.collections import PathCollection, QuadMesh
from matplotlib.figure import Figure

import ropewalk as rw
from ropewalk.plots.residuals import residuals
from ropewalk.plots.sweeps import sweep
from sweeps.scenes import DOWN, EA, swing

Bounds = tuple[np.ndarray, np.ndarray, np.ndarray]


def fake(sizes: dict[str, np.ndarray], values: np.ndarray, kept: dict[str, Any]) -> xr.Dataset:
    """A sweep's dataset with values of one's own; `kept` gives name, dims and labels of what is kept."""
    name, own = kept["name"], kept.get("own", {})
    data = xr.Dataset(
        {
            name: ((*sizes, *own), values),
            "status": (
                tuple(sizes),
                np.full([len(v) for v in sizes.values()], "finished", dtype=object),
            ),
        },
        sizes | own,
        {"design": "grid", "title": "made up"},
    )
    data[name].attrs |= {"units": "N", "long_name": "largest tension", "keep": "tension.max"}
    for path, unit in (("EA", "N"), ("gravity_2", "m/s2"), ("length", "m")):
        if path in sizes:
            data[path].attrs |= {"path": f"x.{path}", "units": unit, "long_name": path}
    return data


def band_of(axes: Axes, number: int = 0) -> Bounds:
    """Places, lower and upper edge of a filled band."""
    corners = axes.collections[number].get_paths()[0].vertices
    x = np.unique(corners[:, 0])
    low, high = (
        np.array([end(corners[corners[:, 0] == at, 1]) for at in x]) for end in (np.min, np.max)
    )
    return x, low, high


def scatter_of(axes: Axes) -> PathCollection:
    """The points of a panel."""
    (found,) = [c for c in axes.collections if isinstance(c, PathCollection)]
    return found


def cell_of(axes: Axes, x: float, y: float) -> float:
    """The value of the cell of a heat map that holds a point."""
    (mesh,) = [c for c in axes.collections if isinstance(c, QuadMesh)]
    corners = np.asarray(mesh.get_coordinates())
    (row,) = np.flatnonzero((corners[:-1, 0, 1] < y) & (y < corners[1:, 0, 1]))
    (column,) = np.flatnonzero((corners[0, :-1, 0] < x) & (x < corners[0, 1:, 0]))
    shape = corners.shape[0] - 1, corners.shape[1] - 1
    return float(np.asarray(mesh.get_array()).reshape(shape)[row, column])


def labels_of(figure: Figure) -> set[str]:
    """All labels of axes, colour bars as well."""
    return {text for axes in figure.axes for text in (axes.get_xlabel(), axes.get_ylabel()) if text}


def words_of(figure: Figure) -> str:
    """All that is written on a figure, its lines joined."""
    return " ".join(text.get_text().replace("\n", " ") for text in figure.texts)


def test_a_line_goes_through_what_was_kept() -> None:
    """A real sweep, so that names, units and words are those that users see."""
    data = rw.sweep(
        swing(0.02), {EA: [3e3, 1e3]}, keep="tension.max", what="rest", on="here", progress=False
    )
    figure = sweep(data)
    (line,) = figure.axes[0].get_lines()
    np.testing.assert_array_equal(line.get_xdata(), [1e3, 3e3])
    np.testing.assert_array_equal(line.get_ydata(), data.tension_max.sel(EA=[1e3, 3e3]))
    assert figure.axes[0].get_xlabel() == "Axial stiffness (rope.made_of.EA) [N]"
    assert figure.axes[0].get_ylabel() == "largest tension [N]"
    # The title said "over all steps" of equilibria, which have none; the twin is that of runs.
    assert data.tension_max.attrs["long_name"] == "largest tension, at rest"
    ran = rw.sweep(swing(0.02), {EA: [3e3]}, keep="tension.max", on="here", progress=False)
    assert ran.tension_max.attrs["long_name"] == "largest tension, over all steps"


def test_an_axis_has_the_whole_of_what_was_picked() -> None:
    """It was cut at the comma between two places: "position (positions[-1"."""
    for what in ("run", "rest"):
        data = rw.sweep(
            swing(0.02),
            {EA: [3e3, 1e3]},
            keep="positions[-1, -1, z]",
            what=what,
            on="here",
            progress=False,
        )
        label = sweep(data).axes[0].get_ylabel()
        assert "position (positions[-1, -1, z]) [" in label


def test_every_cell_of_a_map_has_the_value_of_its_place() -> None:
    ea, down = np.array([2e3, 1e3, 4e3]), np.array([-9.81, -3.0])
    data = fake({"EA": ea, "gravity_2": down}, ea[:, None] - 7.0 * down, {"name": "tension_max"})
    figure = sweep(data)
    for x in ea:
        for y in down:
            assert cell_of(figure.axes[0], x, y) == x - 7.0 * y
    assert labels_of(figure) == {"EA [N]", "gravity_2 [m/s2]", "largest tension [N]"}


@pytest.mark.parametrize(
    "ea", [[1e3, 2e3, 5e3, 1e4, 4e6], [1e3, 1.01e3, 1.02e3, 9e3, 9.01e3], [1.0, 2.0, 3.0]]
)
def test_ticks_of_a_map_do_not_overprint(ea: list[float]) -> None:
    down = np.array([-9.81, -9.7, -3.0])
    sizes = {"EA": np.array(ea), "gravity_2": down}
    data = fake(sizes, np.ones((len(ea), 3)), {"name": "tension_max"})
    figure = sweep(data)
    figure.draw_without_rendering()
    for axis in (figure.axes[0].xaxis, figure.axes[0].yaxis):
        shown = [label for label in axis.get_ticklabels() if label.get_text()]
        boxes = [label.get_window_extent() for label in shown]
        assert len(boxes) >= 2
        pairs = itertools.combinations(boxes, 2)
        assert not any(one.overlaps(other) for one, other in pairs)
    ticks = {float(t.get_text()) for t in figure.axes[0].get_xticklabels() if t.get_text()}
    assert {ea[0], ea[-1]} <= ticks  # the ends are told


def test_labels_of_a_map_stay_beside_it_and_its_numbers_are_of_one_kind() -> None:
    """A long name ran over the title; 100000 was written "1e+05" beside 10000."""
    sizes = {"EA": np.array([1e3, 1e4, 1e5]), "length": np.array([1.0, 2.0, 5.0])}
    data = fake(sizes, np.ones((3, 3)), {"name": "tension_max"})
    long = "position of the second obstacle along the way from the first one to the anchor"
    data.length.attrs["long_name"] = data.tension_max.attrs["long_name"] = long
    figure = sweep(data)
    figure.draw_without_rendering()
    title = figure.texts[1].get_window_extent()  # the line below it
    for axes, unit in zip(figure.axes, ("m", "N"), strict=True):
        assert axes.get_ylabel().replace("\n", " ") == f"{long} [{unit}]"
        box = axes.yaxis.label.get_window_extent()
        assert 0.0 <= box.y0 < box.y1 < title.y0
    ticks = [t.get_text() for t in figure.axes[0].get_xticklabels()]
    assert ticks == ["1000", "10000", "100000"]


def test_panels_show_every_run_at_its_values() -> None:
    dice = np.random.default_rng(1)
    columns = {name: dice.uniform(1.0, 2.0, 20) for name in ("EA", "gravity_2", "length")}
    y = 3.0 * columns["EA"] + columns["gravity_2"] + 0.1 * columns["length"]
    data = xr.Dataset(
        {"tension_max": ("run", y), "status": ("run", ["finished"] * 20)},
        {name: ("run", values) for name, values in columns.items()},
        {"design": "sobol", "title": "made up"},
    )
    data.tension_max.attrs |= {"units": "N", "long_name": "largest tension", "keep": "tension.max"}
    for name, unit in (("EA", "N"), ("gravity_2", "m/s2"), ("length", "m")):
        data[name].attrs |= {"path": f"x.{name}", "units": unit, "long_name": name}
    figure = sweep(data)
    for axes, name in zip(figure.axes, columns, strict=False):
        points = scatter_of(axes)
        np.testing.assert_array_equal(points.get_offsets(), np.column_stack([columns[name], y]))
        by = "gravity_2" if name == "EA" else "EA"
        np.testing.assert_array_equal(points.get_array(), columns[by])
    pairs = {("EA", "gravity_2"), ("EA", "length"), ("gravity_2", "length")}
    for one, other in pairs:
        expected = np.column_stack([columns[one], columns[other]])
        (points,) = [
            c
            for axes in figure.axes
            for c in axes.collections
            if isinstance(c, PathCollection) and np.array_equal(c.get_offsets(), expected)
        ]
        np.testing.assert_array_equal(points.get_array(), y)
    assert {"EA [N]", "gravity_2 [m/s2]", "length [m]", "largest tension [N]"} == labels_of(figure)


def test_pairs_show_where_runs_broke() -> None:
    """Crosses at their values; also where no run has a value at all."""
    axis = np.array([1.0, 2.0])
    sizes = {"EA": axis, "gravity_2": -axis, "length": 3.0 * axis}
    values = np.arange(8.0).reshape(2, 2, 2)
    for lost in (values > 6.0, values > -1.0):
        number = (tuple(sizes), np.arange(8).reshape(2, 2, 2))
        data = fake(sizes, np.where(lost, np.nan, values), {"name": "tension_max"})
        data = data.assign_coords(run=number)
        data["status"].values[:] = np.where(lost, "broke", "finished")
        pairs = [axes for axes in sweep(data).axes if axes.get_ylabel() == "gravity_2 [m/s2]"]
        (crosses,) = pairs[-1].get_lines()  # before it are colour bars
        at = np.argwhere(lost)
        np.testing.assert_array_equal(crosses.get_xdata(), axis[at[:, 0]])
        np.testing.assert_array_equal(crosses.get_ydata(), -axis[at[:, 1]])


def test_a_band_in_time_holds_90_percent_of_the_runs() -> None:
    time, ea = np.linspace(0.0, 1.0, 5), np.arange(1.0, 102.0)
    values = ea[:, None] ** 2 * (1.0 + time)
    kept = {"name": "tension_max_time", "own": {"time": time}}
    figure = sweep(fake({"EA": ea}, values, kept))
    low, middle, high = np.quantile(values, (0.05, 0.5, 0.95), axis=0)
    for drawn, expected in zip(band_of(figure.axes[0]), (time, low, high), strict=True):
        np.testing.assert_allclose(drawn, expected)
    (line,) = figure.axes[0].get_lines()
    np.testing.assert_allclose(line.get_ydata(), middle)
    assert labels_of(figure) >= {"time [s]", "largest tension [kN]"}
    tick = figure.axes[0].yaxis.get_major_formatter()
    assert tick(5000.0, 0) == "5"  # the label's prefix is that of the ticks
    assert "Line: median of 101 runs; band: " in words_of(figure)


def test_a_band_says_of_how_many_runs_it_is(unknown: rw.Uncertainty) -> None:
    """For Sobol indices other runs repeat the values of the sample; then one of the sample breaks."""
    runs = len(unknown.runs.run)
    told = words_of(sweep(unknown.runs, "tension_max_time"))
    assert f", {runs} runs" in told
    assert "Line: median of 8 runs; band: " in told
    lost = unknown.runs.copy(deep=True)
    lost.tension_max_time.values[0] = np.nan
    lost["status"] = ("run", ["broke", *lost.status.values.tolist()[1:]])
    told = words_of(sweep(lost, "tension_max_time"))
    assert f", {runs} runs, 1 broken" in told
    assert "Line: median of 7 runs; band: " in told


def test_points_of_a_fit_are_its_residuals() -> None:
    forces = np.linspace(50.0, 500.0, 6)
    elongation = forces * 2.0 / 2e3 + 1e-3 * np.array([1.0, -1.0, 2.0, 0.0, -2.0, 1.0])
    fit = rw.calibrate(
        swing(0.02),
        [
            rw.calibrate.pull_test(forces, elongation, error=1e-3),
            rw.calibrate.droop([0.01, 0.02], 0.05),
        ],
        {EA: (5e2, 8e3)}, starts=2, profile=False,
    )  # fmt: skip
    figure = residuals(fit)
    pairs = zip(figure.axes, fit.measurements, strict=True)
    for axes, measured in pairs:
        left = fit.residuals[measured.name]
        assert np.ptp(left) > 0.0
        (points,) = [line for line in axes.get_lines() if line.get_marker() == "o"]
        np.testing.assert_array_equal(points.get_ydata(), left)
        x = measured.at if measured.at is not None else np.arange(left.size)
        np.testing.assert_array_equal(points.get_xdata(), x)
        (band,) = axes.patches
        assert band.get_y() == -measured.error
        assert band.get_height() == pytest.approx(2.0 * measured.error)
        assert axes.get_ylabel().startswith(f"{measured.name}: residual [")
        assert axes.get_ylabel().endswith("m]")
    assert figure.axes[0].get_xlabel() == "force [N]"


@pytest.fixture(scope="module")
def unknown() -> rw.Uncertainty:
    """A short run with two values that are not known."""
    spread = {EA: (1e3, 2e3), DOWN: (-12.0, -8.0)}
    return rw.uncertain(swing(0.04), spread, samples=8, seed=3, on="here", progress=False)


def test_the_band_of_what_is_not_known_is_that_of_its_quantiles(unknown: rw.Uncertainty) -> None:
    figure = unknown.plot()
    panels = [axes for axes in figure.axes if axes.get_xlabel() == "time [s]"]
    names = ["tension_max_time", "sag_max_time", "reactions_max_time"]
    assert len(panels) == len(names)
    for axes, name in zip(panels, names, strict=True):
        quantiles = unknown.bands[name].transpose("quantile", "time", ...).values
        low, middle, high = quantiles.reshape(3, -1)  # one rope, one anchor
        x, *edges = band_of(axes)
        np.testing.assert_array_equal(x, unknown.bands.time)
        np.testing.assert_allclose(edges, [low, high])
        assert np.ptp(edges, axis=0).max() > 0.0
        np.testing.assert_allclose(axes.get_lines()[0].get_ydata(), middle)
    labels = [axes.get_ylabel().rpartition(" ")[0] for axes in panels]
    assert labels == ["largest tension", "sag", "anchor forces"]
    for axes, unit in zip(panels, ("N]", "m]", "N]"), strict=True):
        assert axes.get_ylabel().endswith(unit)


def test_bars_of_sobol_indices_have_their_lengths(unknown: rw.Uncertainty) -> None:
    pytest.importorskip("SALib")
    assert unknown.sobol is not None
    figure = unknown.plot()
    (axes,) = [a for a in figure.axes if a.get_xlabel() == "Sobol index of tension_max [1]"]
    made = unknown.sobol.tension_max
    for bars, order in zip(axes.containers[::2], ("total", "first"), strict=True):
        expected = made.sel(order=order).values
        np.testing.assert_allclose([bar.get_width() for bar in bars], expected)
        assert bars.get_label() == order
    names = [label.get_text() for label in axes.get_yticklabels()]
    assert names == made.parameter.values.tolist()


@pytest.mark.parametrize("parameters", [1, 2, 3])
def test_a_figure_says_what_its_runs_are_noted_for(parameters: int) -> None:
    """A table counted runs that parted, and the figure of the same sweep said nothing."""
    sizes = {name: np.array([1.0, 2.0]) for name in ("EA", "gravity_2", "length")[:parameters]}
    values = np.arange(2.0**parameters).reshape([2] * parameters) + 1.0
    data = fake(sizes, values, {"name": "tension_max"})
    numbers = np.arange(values.size).reshape(values.shape)
    data = data.assign_coords(run=(tuple(sizes), numbers))
    for notes, told in ((["parted; guess", ""], True), (["", ""], False)):
        texts = np.array(notes * 2 ** (parameters - 1), dtype=object).reshape([2] * parameters)
        figure = sweep(data.assign(notes=(tuple(sizes), texts)))
        said = " ".join(" ".join(text.get_text() for text in figure.texts).split())
        half = f"{2 ** (parameters - 1)} of {2**parameters} runs parted: their largest tension is"
        assert (half in said) is told
    assert isinstance(sweep(data), Figure)  # of a sweep made before there were notes


def test_a_band_says_what_its_runs_are_noted_for() -> None:
    time = np.array([0.0, 1.0])
    kept = {"name": "tension_max_time", "own": {"time": time}}
    data = fake({"EA": np.array([1.0, 2.0])}, np.ones((2, 2)), kept)
    data = data.assign(notes=("EA", np.array(["parted", "parted"], dtype=object)))
    said = " ".join(text.get_text() for text in sweep(data).texts)
    assert "2 of 2 runs parted" in " ".join(said.split())
