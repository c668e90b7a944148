"""A run that dies at any operation that writes, or finds the disk full there, keeps what it has shown.

So does a resumed run, and one that resumes a resumed run.
"""

from __future__ import annotations

import shutil
from collections.abc import Callable
from pathlib import Path

import numpy as np
import pytest

import runs
from deaths import Disk, Killed, shown_frames
from ropewalk.record.errors import RunError
from ropewalk.record.folder import verify
from ropewalk.record.reader import Stored
from ropewalk.record.result import Result
from ropewalk.record.resume import resume_run
from ropewalk.record.run import record_run
from ropewalk.record.store import Writer

CHUNK = 6
SCENE = runs.hanging(segments=2, duration=0.25)  # 16 frames: three chunks
ALL = pytest.mark.parametrize(
    ("full", "every"),
    [
        (False, 37),
        (True, 61),
        pytest.param(False, 1, marks=pytest.mark.slow),
        pytest.param(True, 5, marks=pytest.mark.slow),
    ],
)


@pytest.fixture(autouse=True)
def _small_chunks(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr("ropewalk.record.run.chunk_frames", lambda simulation: CHUNK)


@pytest.fixture(scope="module")
def whole(tmp_path_factory: pytest.TempPathFactory) -> Path:
    path = tmp_path_factory.mktemp("whole") / "run"
    with pytest.MonkeyPatch.context() as patch:
        patch.setattr("ropewalk.record.run.chunk_frames", lambda simulation: CHUNK)
        record_run(SCENE, path, commit_seconds=0.0)
    return path


def begin(folder: Path) -> None:
    """Run the scene."""
    record_run(SCENE, folder, commit_seconds=0.0)


def go_on(folder: Path) -> None:
    """Resume the run."""
    resume_run(folder, commit_seconds=0.0)


def meet(do: Callable[[Path], None], folder: Path, last: int, *, full: bool = False) -> Disk:
    """Do something with a folder, to whose disk something happens at operation `last`."""
    disk = Disk(folder.parent, last, full=full)
    disk.shown = shown_frames(folder / "data.zarr" / "zarr.json")
    with pytest.MonkeyPatch.context() as patch:
        disk.install(patch)
        try:
            do(folder)
        except (Killed, RunError):
            assert last
            assert disk.done >= last
    return disk


def check_kept(folder: Path, shown: int, whole: Path) -> None:
    """Check that a folder still shows every frame that it has shown, as it was."""
    if not folder.exists():
        assert shown == 0
        return
    result, truth = Result.open(folder), Result.open(whole)
    assert shown <= result.frames <= truth.frames
    assert not verify(folder).faults
    for name in ("time", *truth.source.names):
        np.testing.assert_array_equal(result.read(name), truth.read(name, 0, result.frames))


def check_goes_on(folder: Path, whole: Path) -> None:
    """Check that a run goes on, without trouble, to the bits of one that met with none."""
    if not folder.exists():
        return
    if Result.open(folder).status == "interrupted":
        go_on(folder)
    assert Result.open(folder).status == "finished"
    assert runs.data_bytes(folder) == runs.data_bytes(whole)


def deaths(
    do: Callable[[Path], None],
    base: Path | None,
    room: Path,
    whole: Path,
    every: int,
    *,
    full: bool,
) -> None:
    """Have something meet its end at every operation (or every so many), from the state `base` on."""
    trial = room / "trial" / "run"

    def lay() -> None:
        shutil.rmtree(trial.parent, ignore_errors=True)
        trial.parent.mkdir(parents=True)
        if base is not None:
            shutil.copytree(base, trial)

    lay()
    operations = meet(do, trial, 0).done
    assert runs.data_bytes(trial) == runs.data_bytes(whole)
    assert operations > 100
    for last in range(1, operations + 1, every):
        lay()
        disk = meet(do, trial, last, full=full)
        check_kept(trial, disk.shown, whole)
        if full:  # a second time, before the room that there was then
            for second in (last // 2 + 1, 40 + last % 17):
                if trial.exists() and Result.open(trial).status == "interrupted":
                    disk = meet(go_on, trial, second, full=True)
                    check_kept(trial, disk.shown, whole)
        if last % 3 == 1 or full:
            check_goes_on(trial, whole)


def interrupted(room: Path, do: Callable[[Path], None], base: Path | None, share: float) -> Path:
    """Return a folder in which something died after a share of its operations."""
    trial, found = room / "begun" / "run", room / f"after {share}"
    operations = 0
    for part in (0.0, share):  # the first time it is only counted
        shutil.rmtree(trial.parent, ignore_errors=True)
        trial.parent.mkdir(parents=True)
        if base is not None:
            shutil.copytree(base, trial)
        operations = meet(do, trial, int(part * operations)).done
    assert Result.open(trial).status == "interrupted"
    shutil.copytree(trial, found)
    return found


@ALL
def test_a_run(tmp_path: Path, whole: Path, full: bool, every: int) -> None:
    deaths(begin, None, tmp_path, whole, every, full=full)


@pytest.mark.slow
@ALL
@pytest.mark.parametrize("share", [0.35, 0.6])
def test_a_resumed_run(tmp_path: Path, whole: Path, share: float, full: bool, every: int) -> None:
    base = interrupted(tmp_path, begin, None, share)
    deaths(go_on, base, tmp_path, whole, every, full=full)


@pytest.mark.parametrize("every", [37, pytest.param(1, marks=pytest.mark.slow)])
def test_a_run_that_resumes_a_resumed_run(tmp_path: Path, whole: Path, every: int) -> None:
    first = interrupted(tmp_path, begin, None, 0.4)
    second = interrupted(tmp_path / "again", go_on, first, 0.5)
    deaths(go_on, second, tmp_path, whole, every, full=False)


def ahead(room: Path) -> tuple[Path, int]:
    """Return a run whose checkpoint is that of an earlier commit, and the frames of that.

    As a power failure can leave it.
    """
    early, late = (interrupted(room / str(share), begin, None, share) for share in (0.35, 0.8))
    shutil.copy(early / "checkpoint.npz", late / "checkpoint.npz")
    least = Result.open(early).frames
    assert least < Result.open(late).frames
    return late, least


def meet_ahead(room: Path, whole: Path) -> None:
    """Have a run that is ahead of its checkpoint resumed, and killed at some of its operations."""
    late, least = ahead(room)
    trial = room / "trial" / "run"
    for last in range(1, 150, 9):
        shutil.rmtree(trial.parent, ignore_errors=True)
        shutil.copytree(late, trial)
        meet(go_on, trial, last)
        check_kept(trial, least, whole)
        check_goes_on(trial, whole)


def test_a_store_ahead_of_its_checkpoint_shows_only_what_is_there(
    tmp_path: Path, whole: Path
) -> None:
    meet_ahead(tmp_path, whole)


def test_frames_that_are_written_over_while_they_are_shown_are_found(
    tmp_path: Path, whole: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """The twin: a writer that writes over frames that readers see must not pass."""
    real = Writer.go_on

    def careless(self: Writer, stored: Stored, frames: int) -> None:
        stored.shown = frames
        real(self, stored, frames)

    monkeypatch.setattr(Writer, "go_on", careless)
    with pytest.raises(AssertionError, match="Arrays are not equal"):
        meet_ahead(tmp_path, whole)
