"""The store's own parts: chunks, texts, reading by pieces, checkpoints, files."""

from __future__ import annotations

import errno
import json
import warnings
from pathlib import Path

import numpy as np
import pytest

import ropewalk as rw
import runs
from ropewalk.record import checkpoint, files
from ropewalk.record.checkpoint import Checkpoint
from ropewalk.record.errors import RunError
from ropewalk.record.result import Result
from ropewalk.record.run import record_run
from ropewalk.record.zarr_format import decode, encode, encode_stored, opened


@pytest.fixture
def small_chunks(monkeypatch: pytest.MonkeyPatch) -> int:
    monkeypatch.setattr("ropewalk.record.run.chunk_frames", lambda simulation: 16)
    return 16


def test_a_chunk_comes_back_to_the_bit_and_is_the_same_every_time() -> None:
    values = np.random.default_rng(1).normal(size=(64, 3, 500))
    values[3, 1, 7] = np.nan
    data = encode(values)
    assert encode(values) == data
    np.testing.assert_array_equal(decode(opened(data), "float64", values.shape), values)


def test_a_chunk_that_is_not_compressed_is_read_like_any_other() -> None:
    values = np.random.default_rng(2).normal(size=(16, 3, 500))
    data = encode_stored(values)
    assert len(data) == 16 + values.nbytes + 4
    np.testing.assert_array_equal(decode(opened(data), "float64", values.shape), values)
    with pytest.raises(ValueError, match="bytes"):
        decode(opened(data[:-1]), "float64", values.shape)


@pytest.mark.usefixtures("small_chunks")
@pytest.mark.parametrize(("time_step", "packed"), [(0.002, False), (1e-4, True)])
def test_frames_are_compressed_where_they_cost_much(
    tmp_path: Path, time_step: float, packed: bool
) -> None:
    scene = runs.hanging(time_step=time_step)
    record_run(scene, tmp_path / "run")
    size = 16 + 8 * 16 * 3 * 11 + 4  # header, frames x axes x nodes, checksum
    chunks = [tmp_path / "run" / "data.zarr" / "positions" / f"c.{i}.0.0" for i in range(7)]
    assert {path.stat().st_size < size for path in chunks} == {packed}
    assert {path.stat().st_size > size for path in chunks} == {False}


@pytest.mark.usefixtures("small_chunks")
def test_a_file_system_without_direct_writing_gets_the_same_files(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    refused = []

    def refuse(path: str, _: int) -> int:
        refused.append(path)
        raise OSError(errno.EINVAL, "Invalid argument", path)

    record_run(runs.hanging(), tmp_path / "direct")
    monkeypatch.setattr(files, "DIRECT", 1)
    monkeypatch.setattr(files, "_open_direct", refuse)
    record_run(runs.hanging(), tmp_path / "other")
    assert refused
    assert runs.data_bytes(tmp_path / "other") == runs.data_bytes(tmp_path / "direct")


@pytest.mark.parametrize("cut", [0, 5, 16, 100, -1])
def test_a_cut_chunk_is_refused(cut: int) -> None:
    data = encode(np.arange(1000.0))
    with pytest.raises(ValueError, match="bytes"):
        decode(opened(data[:cut]), "float64", (1000,))


def test_a_chunk_of_another_size_is_refused() -> None:
    with pytest.raises(ValueError, match="bytes"):
        decode(opened(encode(np.arange(1000.0))), "float64", (999,))


@pytest.mark.usefixtures("small_chunks")
def test_reading_pieces_equals_reading_all(tmp_path: Path) -> None:
    stored = record_run(runs.hanging(), tmp_path / "run")
    memory = rw.simulate(runs.hanging())
    for name in ("time", *memory.source.names):
        whole = memory.read(name)
        np.testing.assert_array_equal(stored.source.read(name), whole)
        for start, stop in ((0, 1), (15, 17), (16, 32), (7, 100), (120, 121), (50, 50)):
            piece = stored.source.read(name, start, stop)
            np.testing.assert_array_equal(piece, whole[start:stop])


@pytest.mark.usefixtures("small_chunks")
@pytest.mark.parametrize("scene", [runs.hanging(), runs.winched(), runs.winched(-0.5)])
def test_xarray_and_zarr_open_a_run_without_a_warning(tmp_path: Path, scene: rw.Scene) -> None:
    import xarray as xr
    import zarr

    stored = rw.run(scene, tmp_path / "run")
    memory = rw.simulate(scene)
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        data = xr.open_zarr(tmp_path / "run" / "data.zarr", chunks=None)
        assert set(data.data_vars) == set(memory.source.names)
        for name in memory.source.names:
            np.testing.assert_array_equal(data[name].values, memory.read(name))
            assert data[name].attrs["units"]
        group = zarr.open_group(tmp_path / "run" / "data.zarr", mode="r", use_consolidated=False)
        np.testing.assert_array_equal(group["positions"][:], memory.positions)  # type: ignore[index]
    assert set(data.coords) == set(memory.dataset.coords)
    for name in data.coords:
        shown = str(data[name].values.tolist())  # text: NaN is to equal NaN
        assert shown == str(memory.dataset[name].values.tolist())
    assert stored.frames == memory.frames


def test_what_a_folder_holds(tmp_path: Path) -> None:
    scene = runs.hanging()
    folder = tmp_path / "deep" / "run"
    result = rw.run(scene, folder)
    assert rw.load(folder / "scene.toml") == scene
    provenance = json.loads((folder / "provenance.json").read_text())
    assert provenance["plan"]["steps_per_frame"] == 9
    for key in ("ropewalk", "numpy", "numba", "python", "platform", "source_hash"):
        assert provenance[key]
    assert provenance["started"] <= provenance["ended"]
    events = [json.loads(line) for line in (folder / "events.jsonl").read_text().splitlines()]
    assert [event["event"] for event in events] == ["started", "released", "finished"]
    status = json.loads((folder / "status.json").read_text())
    assert status["status"] == "finished"
    assert status["frames"] == status["planned_frames"] == result.frames
    assert {path.name for path in tmp_path.iterdir()} == {"deep"}
    assert {path.name for path in (tmp_path / "deep").iterdir()} == {"run"}
    assert not list(folder.rglob("*.partial"))


def test_saving_a_result_keeps_it(tmp_path: Path) -> None:
    for number, memory in enumerate(
        (
            rw.simulate(runs.winched()),
            rw.simulate(runs.breaking(), on_failure="return", keep_going=True),
        )
    ):
        saved = memory.save(tmp_path / str(number))
        again = Result.open(tmp_path / str(number))
        assert again.status == saved.status == memory.status
        assert again.diagnosis == memory.diagnosis
        assert again.scene == memory.scene
        assert again.plan == memory.plan
        for name in ("time", *memory.source.names):
            np.testing.assert_array_equal(again.read(name), memory.read(name))
        np.testing.assert_array_equal(again.energy_error, memory.energy_error)
        assert str(again.table) == str(memory.table)


def test_a_checkpoint_comes_back_to_the_bit(tmp_path: Path) -> None:
    simulation = rw.Simulation(runs.winched())
    simulation.advance_frames(30)
    saved = Checkpoint(simulation.state, 31, "hash", 1.5, ())
    checkpoint.save(tmp_path, saved)
    other = rw.Simulation(runs.winched())
    found = checkpoint.load(tmp_path, other.state)
    assert (found.frames, found.source_hash, found.seconds) == (31, "hash", 1.5)
    other.restore(found.snapshot)
    simulation.advance_frames(30)
    other.advance_frames(30)
    assert other.time == simulation.time
    np.testing.assert_array_equal(other.positions, simulation.positions)
    np.testing.assert_array_equal(other.arrays.work.elastic, simulation.arrays.work.elastic)


def test_a_checkpoint_of_another_scene_is_refused(tmp_path: Path) -> None:
    simulation = rw.Simulation(runs.hanging())
    checkpoint.save(tmp_path, Checkpoint(simulation.state, 1, "hash", 0.0, ()))
    with pytest.raises(
        RunError, match=r"checkpoint.npz: is of another scene, .* does not fit the scene"
    ):
        checkpoint.load(tmp_path, rw.Simulation(runs.hanging(segments=11)).state)


def test_a_failed_write_leaves_the_old_file(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    path = tmp_path / "file"
    files.write(path, b"old")

    def full(*_: object) -> None:
        raise OSError(28, "No space left on device")

    monkeypatch.setattr(files.os, "fsync", full)
    with pytest.raises(OSError, match="No space"):
        files.write(path, b"new", sync=True)
    assert path.read_bytes() == b"old"
    assert [entry.name for entry in tmp_path.iterdir()] == ["file"]
