"""The tables of a sweep say over what a number is the largest, and of which runs it is."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pandas as pd
import pytest
from click.testing import CliRunner

import ropewalk as rw
from ropewalk.cli.app import main
from ropewalk.plots.sweeps import sweep as draw
from ropewalk.scene import apply_overrides
from ropewalk.sweeps.summary import summary
from ropewalk.sweeps.sweep_folder import SweepFolder
from ropewalk.sweeps.uncertainty import text_rows
from sweeps.scenes import EA, swing


def info(folder: Path) -> str:
    """What `ropewalk info` prints."""
    return CliRunner().invoke(main, ["info", str(folder)]).output


@pytest.mark.parametrize(
    ("more", "seen"), [([], "all steps"), (["run.extremes=false"], "recorded frames")]
)
def test_tables_say_whether_maxima_are_of_all_steps(
    tmp_path: Path, more: list[str], seen: str
) -> None:
    scene, keep = apply_overrides(swing(), more), ["tension.max", "sag.max"]
    rw.sweep(scene, {EA: [1e3, 2e3]}, keep=keep, store=tmp_path / "s", on="here", progress=False)
    rows = info(tmp_path / "s").splitlines()
    (tension,) = (row for row in rows if "tension_max" in row)
    (sag,) = (row for row in rows if "sag_max" in row)
    assert seen in tension
    assert "recorded frames" in sag
    assert "all steps" not in sag


def test_bands_say_whether_maxima_are_of_all_steps() -> None:
    spread = {EA: (1e3, 2e3)}
    found = rw.uncertain(swing(), spread, samples=4, seed=1, on="here", progress=False)
    seen = {row[0].partition("[")[0]: row[1] for row in text_rows(found)}
    assert seen["tension_max"] == "all steps"
    assert seen["sag_max"] == "recorded frames"


def test_an_unfinished_grid_has_no_quantiles(tmp_path: Path) -> None:
    """Its first runs are its first rows; those of a sample are one."""
    grid = {EA: np.linspace(1e3, 2e3, 4), "rope.length": np.linspace(1.9, 2.1, 4)}
    ask = {"keep": "tension.max", "on": "here", "batch": 2, "progress": False}
    rw.sweep(swing(), grid, store=tmp_path / "s", **ask)
    whole = summary(SweepFolder.open(tmp_path / "s"))["kept"][0]["quantiles"]
    assert np.isfinite(whole).all()
    SweepFolder.open(tmp_path / "s").unmark(range(4, 8))
    part = summary(SweepFolder.open(tmp_path / "s"))["kept"][0]["quantiles"]
    assert np.isfinite(part).tolist() == [True, False, False, False, True]
    assert "the first ones are no sample of them" in info(tmp_path / "s")
    ranges = {EA: (1e3, 2e3)}
    rw.sweep(swing(), ranges, samples=16, seed=1, store=tmp_path / "drawn", **ask)
    SweepFolder.open(tmp_path / "drawn").unmark(range(4, 8))
    drawn = summary(SweepFolder.open(tmp_path / "drawn"))["kept"][0]["quantiles"]
    assert np.isfinite(drawn).all()


def test_runs_with_frames_at_other_times_have_no_band() -> None:
    rates = {"run.frame_rate": [50.0, 100.0], EA: [1e3, 2e3]}
    ds = rw.sweep(swing(), rates, keep="tension.max[time]", on="here", progress=False)
    assert "frame" in ds.tension_max_time.dims
    figure = draw(ds)
    assert not figure.axes[0].collections  # no band
    assert sum(len(line.get_xdata()) > 0 for line in figure.axes[0].lines) == 4
    assert any("at different times" in text.get_text() for text in figure.texts)
    one = rw.sweep(swing(), {EA: [1e3, 2e3]}, keep="tension.max[time]", on="here")
    assert draw(one).axes[0].collections


def test_bands_in_time_need_frames_at_the_same_times() -> None:
    spread = {"run.frame_rate": (40.0, 100.0), EA: (1e3, 2e3)}
    found = rw.uncertain(swing(), spread, samples=4, seed=1, on="here", progress=False)
    assert "tension_max_time" not in found.bands
    assert "No bands in time" in found.note
    found.plot()


@pytest.mark.parametrize("given", [list, np.array, pd.Series])
def test_units_in_a_table_are_those_of_a_list(given: object) -> None:
    texts = ["5 kN", "7 kN", "700"]
    made = given(texts)  # type: ignore[operator]
    vary = {EA: made} if given is not pd.Series else pd.DataFrame({EA: made})
    ds = rw.sweep(swing(0.02), vary, keep="tension.max", on="here", progress=False)
    assert ds.EA.values.tolist() == [5000.0, 7000.0, 700.0]
    assert ds.EA.attrs["units"] == "N"
