"""What is not resumed: a run in use, of other sources or another scene, or with a damaged part."""

from __future__ import annotations

import json
import shutil
from dataclasses import replace
from pathlib import Path
from zipfile import ZipFile

import numpy as np
import pytest

import ropewalk as rw
import runs
from integration.faulty_runs import edit, flip
from ropewalk.record import checkpoint, lock
from ropewalk.record.errors import RunError
from ropewalk.record.folder import verify
from ropewalk.record.result import Result
from ropewalk.simulation import Snapshot


@pytest.fixture(autouse=True)
def _small_chunks(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr("ropewalk.record.run.chunk_frames", lambda simulation: 16)


def test_a_folder_in_use_is_left_alone(stopped: Path) -> None:
    with lock.locked(stopped):
        assert Result.open(stopped).status == "running"
        for use in (
            lambda: rw.resume(stopped),
            lambda: rw.run(runs.hanging(), stopped, overwrite=True),
        ):
            with pytest.raises(RunError, match="is being written by another process"):
                use()
    assert Result.open(stopped).status == "interrupted"


def test_other_sources_are_refused_unless_forced(stopped: Path, whole: Path) -> None:
    edit(stopped / "provenance.json", "source_hash", "other")
    with pytest.raises(RunError, match="other sources of ropewalk"):
        rw.resume(stopped)
    with pytest.warns(UserWarning, match="may not go on to the same bits"):
        rw.resume(stopped, force=True)
    assert Result.open(stopped).frames == Result.open(whole).frames


@pytest.mark.parametrize("name", ["numpy", "numba"])
def test_other_versions_are_refused_and_named(stopped: Path, name: str) -> None:
    edit(stopped / "provenance.json", name, "0.1")
    with pytest.raises(RunError, match=rf"begun with {name} 0.1 \(here: \d"):
        rw.resume(stopped)


def test_another_scene_is_refused_and_another_comment_is_not(stopped: Path) -> None:
    path = stopped / "scene.toml"
    text = path.read_text()
    changed = text.replace("spring_friction = 0.05", "spring_friction = 0.06")
    assert changed != text
    path.write_text(changed)
    for use in (Result.open, rw.resume, lambda folder: rw.resume(folder, force=True)):
        with pytest.raises(RunError, match=r"scene\.toml: is damaged or was changed"):
            use(stopped)
    path.write_text("# a rope\n" + text)
    rw.resume(stopped)


def test_a_resumed_run_reads_every_chunk_first(stopped: Path) -> None:
    chunks = sorted((stopped / "data.zarr").glob("*/c.[01]*"))
    shown = Result.open(stopped).frames
    for path in chunks[:: len(chunks) // 8]:
        flip(path, 33)
        with pytest.raises(RunError, match="do not fit their checksum"):
            rw.resume(stopped, force=True)
        flip(path, 33)
    assert Result.open(stopped).frames == shown
    rw.resume(stopped)


def test_a_damaged_checkpoint_is_found(stopped: Path) -> None:
    with ZipFile(
        stopped / "checkpoint.npz"
    ) as file:  # between its members lie dates, which nobody needs
        largest = sorted(file.infolist(), key=lambda member: member.file_size)[-3:]
    for member in largest:
        place = member.header_offset + 256 + member.compress_size // 2
        flip(stopped / "checkpoint.npz", place)
        (fault,) = verify(stopped).faults
        assert fault.path.endswith("checkpoint.npz")
        with pytest.raises(RunError, match=r"checkpoint\.npz: is damaged"):
            rw.resume(stopped)
        flip(stopped / "checkpoint.npz", place)
    assert verify(stopped).faults == ()


def test_a_checkpoint_of_another_layout_is_not_called_damaged(stopped: Path) -> None:
    """As one of before contacts remembered how stiff they are."""
    found = checkpoint.read(stopped)
    index = json.loads(str(found["index"]))
    row = [name for name, *_ in index].index("state.x")
    index[row][2].reverse()
    np.savez(stopped / "checkpoint.npz", **found | {"index": json.dumps(index)})
    with pytest.raises(RunError, match=r"of another version: state\.x does not fit the scene"):
        rw.resume(stopped)


def test_a_checkpoint_that_does_not_fit_is_refused_in_words(
    stopped: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """As one of other sources whose islands remember less, with `force`: an error in Ropewalk itself."""
    load = checkpoint.load

    def other(folder: Path, like: Snapshot) -> checkpoint.Checkpoint:
        found = load(folder, like)
        return replace(found, snapshot=found.snapshot._replace(layout="another"))

    monkeypatch.setattr(checkpoint, "load", other)
    with pytest.raises(
        RunError, match=r"checkpoint\.npz: is of another scene, or of another version"
    ):
        rw.resume(stopped)


@pytest.mark.parametrize("length", [None, 0, 100])
def test_a_missing_or_torn_checkpoint(stopped: Path, length: int | None) -> None:
    path = stopped / "checkpoint.npz"
    if length is None:
        path.unlink()
    else:
        path.write_bytes(path.read_bytes()[:length])
    said = r"has no checkpoint" if length is None else r"checkpoint\.npz: is damaged"
    with pytest.raises(RunError, match=said):
        rw.resume(stopped)
    assert Result.open(stopped).frames >= 1


def test_a_store_behind_its_checkpoint_is_refused(stopped: Path, whole: Path) -> None:
    shutil.copy(whole / "checkpoint.npz", stopped / "checkpoint.npz")
    with pytest.raises(RunError, match=r"data\.zarr: is damaged: it has \d+ frames"):
        rw.resume(stopped)
