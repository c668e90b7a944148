"""One bit or one file of a sweep's folder is damaged: it is named, and `resume` brings it back."""

from __future__ import annotations

import json
import shutil
import uuid
import warnings
from collections.abc import Callable
from pathlib import Path

import pandas as pd
import pytest
import xarray as xr

import ropewalk as rw
from ropewalk.record.errors import RunError
from ropewalk.sweeps.repair import faults
from ropewalk.sweeps.sweep_folder import SweepFolder
from sweeps.scenes import EA, RUNS, flip, make, of_format, store_bytes, swing


def test_a_damaged_batch_is_seen_and_made_again(tmp_path: Path, whole: dict[str, bytes]) -> None:
    folder = tmp_path / "s"
    make(folder)
    flip(folder / "data.zarr" / "tension_max" / "c.3")
    (folder / "data.zarr" / "status" / "c.5").unlink()
    (folder / "data.zarr" / "reason" / "c.11").unlink()  # one of its runs broke
    assert SweepFolder.open(folder).standing()[1] == [3, 5, 11]
    assert rw.sweep.open(folder).status.values[9:13].tolist() == ["finished", "", "", "finished"]
    assert rw.sweep.open(folder).status.values[-3:].tolist() == ["finished", "", ""]
    with pytest.raises(
        RunError, match=r"tension_max/c\.3: is damaged \(runs 6 to 7\).*makes these"
    ):
        rw.sweep.open(folder).tension_max.load()
    told = "\n".join(faults(SweepFolder.open(folder)))
    for file, runs in (("tension_max/c.3", "6 to 7"), ("status/c.5", "10 to 11")):
        assert f"{file}: is damaged (runs {runs})" in told
    with pytest.warns(
        UserWarning, match="3 stored batches are damaged and are made again: 3, 5, 11"
    ):
        make(folder)
    assert store_bytes(folder) == whole
    assert faults(SweepFolder.open(folder)) == []


@pytest.mark.parametrize(
    "name", ["length/c.0", "run/c.0", "anchor/c.0", "EA/zarr.json", "zarr.json"]
)
def test_values_and_labels_are_checked_and_mended(
    tmp_path: Path, whole: dict[str, bytes], name: str
) -> None:
    """Of a finished sweep, and of one that has still runs to make from these values."""
    folder = tmp_path / "s"
    make(folder)
    for marks in ([], [4, 7]):
        SweepFolder.open(folder).unmark(marks)
        path = folder / "data.zarr" / name
        flip(path)
        (told,) = faults(SweepFolder.open(folder))
        assert told.startswith(f"{path}: is damaged")
        if name == "length/c.0":
            with pytest.raises(RunError, match=r"length/c\.0: is damaged \(runs 0 to 23\)"):
                rw.sweep.open(folder).length.load()
            with pytest.raises(RunError, match=r"length/c\.0: is damaged \(runs 0 to 23\)"):
                rw.sweep.replay(folder, 3)
        with pytest.warns(UserWarning, match=f"put right: data.zarr/{name}"):
            make(folder)
        assert store_bytes(folder) == whole


def test_values_that_are_lost_are_told(tmp_path: Path, whole: dict[str, bytes]) -> None:
    folder = tmp_path / "s"
    make(folder)
    copy = folder / "values" / "length.c.0"
    flip(copy)
    assert faults(SweepFolder.open(folder))[0].startswith(f"{copy}: a copy of values is damaged")
    with pytest.warns(UserWarning, match=r"put right: values/length\.c\.0"):
        make(folder)
    flip(copy)
    flip(folder / "data.zarr" / "length" / "c.0")
    with pytest.raises(
        RunError, match=r"what was asked of runs 0 to 23 is lost; make the sweep anew"
    ):
        make(folder)


def turn(path: Path, old: bytes, new: bytes) -> None:
    """Change some bytes of a file."""
    data = path.read_bytes()
    assert data.count(old) >= 1
    path.write_bytes(data.replace(old, new, 1))


#: One bit that makes another rope, one that breaks the JSON, one that makes a format without checksum.
ONE_BIT: dict[str, Callable[[Path], None]] = {
    "rope": lambda path: turn(path, b"mass_per_length = 0.1", b"mass_per_length = 0.3"),
    "json": lambda path: turn(path, b'"recipe"', b'#recipe"'),
    "format": lambda path: turn(path, b'"format": 4', b'"format": 2'),
    "checksum": lambda path: turn(path, b'"checksum"', b'"chfcksum"'),
    "end": lambda path: path.write_bytes(path.read_bytes()[:-100]),
    "middle": flip,
    "gone": Path.unlink,
}


@pytest.fixture(scope="module")
def half(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """A sweep with runs left to make."""
    folder = tmp_path_factory.mktemp("half") / "s"
    make(folder)
    SweepFolder.open(folder).unmark([4, 11])
    return folder


@pytest.mark.parametrize("damage", ONE_BIT)
@pytest.mark.parametrize("name", ["sweep.json", "values/sweep.json"])
def test_what_was_asked_is_checked_and_brought_back(
    tmp_path: Path, half: Path, whole: dict[str, bytes], name: str, damage: str
) -> None:
    """Half of a sweep of one rope and half of another one would be the worst that could happen."""
    folder = Path(shutil.copytree(half, tmp_path / "s"))
    path = folder / name
    right = path.read_bytes()
    ONE_BIT[damage](path)
    assert "".join(faults(SweepFolder.open(folder))).startswith(f"{path}: is damaged: it")
    assert rw.sweep.open(folder).status.values[7:9].tolist() == ["finished", ""]
    with pytest.warns(UserWarning, match=f"put right: {name}$"):
        rw.sweep.resume(folder, on="here", progress=False)
    assert store_bytes(folder) == whole
    assert path.read_bytes() == right
    assert faults(SweepFolder.open(folder)) == []


def test_what_was_asked_is_lost_where_both_are_damaged(tmp_path: Path, half: Path) -> None:
    folder = Path(shutil.copytree(half, tmp_path / "s"))
    flip(folder / "sweep.json")
    flip(folder / "values" / "sweep.json")
    for read in (rw.sweep.open, rw.sweep.resume):
        with pytest.raises(RunError, match=r"sweep\.json: is damaged .*copy .* too .*is lost; put"):
            read(folder)


def test_a_scene_that_was_changed_is_told(tmp_path: Path, half: Path) -> None:
    """It is there to be read; the runs are of the one in sweep.json."""
    folder = Path(shutil.copytree(half, tmp_path / "s"))
    right = (folder / "scene.toml").read_bytes()
    turn(folder / "scene.toml", b"length = 2.0", b"length = 3.0")
    (told,) = faults(SweepFolder.open(folder))
    assert told.startswith(f"{folder / 'scene.toml'}: is damaged: it is not as it was written")
    with pytest.warns(UserWarning, match=r"put right: scene\.toml$"):
        rw.sweep.resume(folder, on="here", progress=False)
    assert (folder / "scene.toml").read_bytes() == right


def test_facts_of_another_sweep_are_not_taken(tmp_path: Path, half: Path) -> None:
    from ropewalk.record.seal import sealed

    folder = Path(shutil.copytree(half, tmp_path / "s"))
    facts = json.loads((folder / "sweep.json").read_text())
    del facts["checksum"]
    assert sealed(json.dumps(facts, indent=1)) == (folder / "sweep.json").read_bytes()
    (folder / "sweep.json").write_bytes(sealed(json.dumps(facts | {"id": "1" * 32}, indent=1)))
    with pytest.raises(RunError, match="of two sweeps; remove the one"):
        rw.sweep.open(folder)


@pytest.mark.parametrize("consolidated", [True, False])
def test_plain_xarray_gives_a_row_per_run(half: Path, consolidated: bool) -> None:
    """The marks of the batches have a dimension of their own: pandas would make runs x batches rows."""
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        plain = xr.open_zarr(half / "data.zarr", consolidated=consolidated)
    assert set(plain.dims) == {"run", "node", "axis", "anchor"}
    assert len(plain.drop_dims(["node", "anchor", "axis"]).to_dataframe()) == RUNS
    assert len(plain.drop_dims("anchor").to_dataframe()) == RUNS * 5 * 3


def old_store(folder: Path) -> None:
    """Make a folder what it was in format 2: facts without a checksum and a copy, `done` an array."""
    facts = json.loads((folder / "sweep.json").read_text())
    del facts["checksum"]
    (folder / "sweep.json").write_text(json.dumps(facts | {"format": 2}, indent=1))
    (folder / "values" / "sweep.json").unlink()
    group = folder / "data.zarr" / "done"
    for file in (group / "marks").iterdir():
        file.rename(group / file.name)
    (group / "marks").rmdir()
    root = folder / "data.zarr" / "zarr.json"
    about = json.loads(root.read_text())
    known = about["consolidated_metadata"]["metadata"]
    known["done"] = known.pop("done/marks")
    root.write_text(json.dumps(about))


def test_a_sweep_whose_facts_have_no_checksum_still_opens(
    tmp_path: Path,
) -> None:
    """As format 2 was."""
    folder = tmp_path / "s"
    with of_format(3):
        make(folder)
    whole = store_bytes(folder)
    SweepFolder.open(folder).unmark([4, 11])
    old_store(folder)
    assert faults(SweepFolder.open(folder)) == []
    rw.sweep.resume(folder, on="here", progress=False)
    made = store_bytes(folder)
    marks = {name.replace("done/marks", "done"): data for name, data in whole.items()}
    assert {n: d for n, d in made.items() if "json" not in n} == {
        n: d for n, d in marks.items() if "json" not in n
    }
    assert rw.sweep.open(folder).sizes["run"] == RUNS
    (folder / "sweep.json").write_bytes((folder / "sweep.json").read_bytes()[:-9])
    with pytest.raises(RunError, match=r"holds no JSON.*it is missing.*make the sweep anew"):
        rw.sweep.open(folder)


def test_numbers_of_a_sweep_that_has_replaced_the_one_that_was_opened_are_refused(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr("ropewalk.sweeps.sweep_plan.uuid", uuid)  # not the one id of these tests
    points = pd.DataFrame({EA: [1e3, 2e3]})
    old = rw.sweep(swing(0.02), points, store=tmp_path / "s", on="here")
    other = points.assign(**{EA: [4e3, 5e3]})
    new = rw.sweep(swing(0.02), other, store=tmp_path / "s", on="here", overwrite=True)
    with pytest.raises(RunError, match="s: holds another sweep by now; open it again"):
        old.tension_max.load()
    with pytest.raises(RunError, match="s: holds another sweep by now; open it again"):
        old.tension_max.load()  # nor later on
    assert (rw.sweep.open(tmp_path / "s").tension_max.values == new.tension_max.values).all()
