"""Run folders that older versions wrote, each by its own code, open and say what they hold.

`data/old_runs.tar.xz` has one of every format: five segments, three frames. That of format 2 with esdirk3 and
those after it have bending and a clamp; from format 4 on the rope falls onto a ball.
"""

from __future__ import annotations

import json
import tarfile
from pathlib import Path

import numpy as np
import pytest
import xarray as xr
from click.testing import CliRunner

import ropewalk as rw
from ropewalk import plots
from ropewalk.cli.app import main
from ropewalk.record.errors import RunError
from ropewalk.record.folder import verify

RUNS = Path(__file__).parent / "data" / "old_runs.tar.xz"
NAMES = ("format2-verlet", *(f"format{number}-esdirk3" for number in range(2, 10)))


@pytest.fixture(scope="module")
def folders(tmp_path_factory: pytest.TempPathFactory) -> Path:
    folder = tmp_path_factory.mktemp("old")
    with tarfile.open(RUNS) as packed:
        packed.extractall(folder, filter="data")
    return folder


@pytest.mark.parametrize("name", NAMES)
def test_an_old_run_holds_what_it_did(name: str, folders: Path) -> None:
    """The numbers are those that xarray reads from the same store."""
    result = rw.Result.open(folders / name)
    assert result.status == "finished"
    data = xr.open_zarr(folders / name / "data.zarr", chunks=None)
    for quantity in result.source.names:
        np.testing.assert_array_equal(result.read(quantity), data[quantity].values)
    assert {"positions", "velocities", "tension", "energy", "work"} <= set(result.source.names)
    for held, shown in (("form", result.energy), ("law", result.work)):
        kind = "energy" if held == "form" else "work"
        for label in data[held].values:
            np.testing.assert_array_equal(shown[label], data[kind].sel({held: label}).values)
    assert list(result.time) == [0.0, 0.05, 0.1]
    if name.startswith("format2"):
        with pytest.raises(RunError, match="before runs had checksums"):
            verify(folders / name)
    else:
        assert verify(folders / name).faults == ()


@pytest.mark.parametrize("name", NAMES)
def test_an_old_run_is_as_its_physics(name: str, folders: Path) -> None:
    """Straight at first; tension as the stretch says; energy as the works say, to what the steps leave."""
    result = rw.Result.open(folders / name)
    np.testing.assert_allclose(result.positions[0, :, 0], np.linspace(0.0, 1.0, 6), atol=1e-12)
    lengths = np.linalg.norm(np.diff(result.positions, axis=1), axis=2)
    np.testing.assert_allclose(result.elastic_tension, 1e4 * (lengths / 0.2 - 1.0), atol=1e-9)
    mass = result.scene.ropes[0].made_of.mass_per_length * 1.0
    speeds = np.linalg.norm(result.velocities, axis=2)
    weights = np.array([0.5, 1.0, 1.0, 1.0, 1.0, 0.5]) * mass / 5
    kinetic = 0.5 * (weights * speeds**2).sum(axis=1)
    np.testing.assert_allclose(result.energy["kinetic"], kinetic, rtol=1e-12)
    heights = 9.81 * (weights * result.positions[:, :, 2]).sum(axis=1)
    np.testing.assert_allclose(result.energy["gravity"], heights, atol=1e-12)


@pytest.mark.parametrize("name", NAMES)
def test_an_old_run_is_told_exported_and_drawn(name: str, folders: Path, tmp_path: Path) -> None:
    folder = folders / name
    told = CliRunner().invoke(main, ["info", "--json", str(folder)])
    assert told.exit_code == 0, told.output
    about = json.loads(told.output)
    assert about["status"] == "finished"
    assert about["arrays"]["positions"]["shape"] == [3, 6, 3]
    assert about["provenance"]["format"] == int(name[6])
    result = rw.Result.open(folder)
    result.export("npz", tmp_path / "run.npz")
    exported = np.load(tmp_path / "run.npz")
    np.testing.assert_array_equal(exported["positions"], result.positions)
    result.export("csv", tmp_path / "run.csv", quantities=("energy",))
    assert len((tmp_path / "run.csv").read_text().splitlines()) == 4
    drawn = [plot.draw(result) for plot in plots.PLOTS.values() if plot.there(result)]
    assert len(drawn) >= 8
    assert all(figure.axes for figure in drawn)


def test_numbers_of_another_form_are_still_refused(folders: Path) -> None:
    """The twin: words may be others, kind and shape of the numbers may not."""
    folder = folders / "format2-verlet"
    root = folder / "data.zarr" / "zarr.json"
    before = root.read_text()
    found = json.loads(before)
    try:
        for key, wrong in (("data_type", "float32"), ("shape", [3, 6]), ("dimension_names", ["a"])):
            arrays = json.loads(before)["consolidated_metadata"]["metadata"]
            arrays["energy"][key] = wrong
            found["consolidated_metadata"]["metadata"] = arrays
            root.write_text(json.dumps(found))
            with pytest.raises(RunError, match="'energy' does not fit the scene"):
                rw.Result.open(folder)
    finally:
        root.write_text(before)
