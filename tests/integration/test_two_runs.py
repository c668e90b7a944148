"""Several processes that write to one folder: one wins, the others say so, and nothing is lost."""

from __future__ import annotations

import os
import subprocess
import sys
import time
from collections.abc import Callable
from contextlib import suppress
from pathlib import Path
from typing import Any

import numpy as np
import pytest

import ropewalk as rw
import runs
from deaths import Disk, Killed
from ropewalk.record import place
from ropewalk.record.errors import RunError
from ropewalk.record.lock import is_locked, locked
from ropewalk.record.place import is_run
from ropewalk.record.result import Result
from ropewalk.record.resume import resume_run
from ropewalk.record.run import record_run

SCENE = runs.hanging(duration=0.3)
OTHER = runs.hanging(duration=0.3, segments=4)


@pytest.fixture(autouse=True)
def _small_chunks(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr("ropewalk.record.run.chunk_frames", lambda simulation: 4)


def in_between(monkeypatch: pytest.MonkeyPatch, name: str, do: Callable[[], None]) -> None:
    """Have something done, once, before a function of `place` is called."""
    real, todo = getattr(place, name), [do]

    def wrapped(*args: Any, **more: Any) -> Any:
        if todo:
            todo.pop()()
        return real(*args, **more)

    monkeypatch.setattr(place, name, wrapped)


def only(folder: Path, nodes: int) -> None:
    """Check that a folder holds one whole run, and that nothing lies beside it."""
    result = Result.open(folder)
    assert (result.status, result.nodes, result.frames) == ("finished", nodes, 19)
    assert [path.name for path in folder.parent.iterdir()] == [folder.name]


@pytest.mark.parametrize("overwrite", [False, True])
def test_a_run_that_begins_while_another_one_is_written(tmp_path: Path, overwrite: bool) -> None:
    folder, refused = tmp_path / "run", []

    def begin(done: int, *_: object) -> None:
        assert is_locked(folder)
        with pytest.raises(RunError, match="is being written by another process") as raised:
            record_run(OTHER, folder, overwrite=overwrite)
        refused.append(raised.value)
        with pytest.raises(RunError, match="is being written by another process"):
            resume_run(folder)

    record_run(SCENE, folder, progress=begin, commit_seconds=0.0)
    assert len(refused) > 2
    only(folder, 11)


@pytest.mark.parametrize("overwrite", [False, True])
def test_a_run_that_appears_while_another_one_is_prepared(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, overwrite: bool
) -> None:
    folder = tmp_path / "run"
    in_between(monkeypatch, "_put_in_place", lambda: record_run(OTHER, folder) and None)
    if overwrite:
        record_run(SCENE, folder, overwrite=True)
        only(folder, 11)
    else:
        with pytest.raises(RunError, match="holds a run already"):
            record_run(SCENE, folder)
        only(folder, 5)


def test_one_that_begins_while_another_one_is_prepared_and_goes_on(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    folder = tmp_path / "run"
    with locked_run(folder) as hold:
        in_between(monkeypatch, "_put_in_place", hold)
        with pytest.raises(RunError, match="is being written by another process"):
            record_run(SCENE, folder, overwrite=True)
    assert Result.open(folder).nodes == 5


class locked_run:  # noqa: N801 - used like a function
    """A run that another process is writing, once it is called."""

    def __init__(self, folder: Path) -> None:
        self.folder = folder

    def __enter__(self) -> Callable[[], None]:
        self._lock = locked(self.folder)
        return self._begin

    def _begin(self) -> None:
        record_run(OTHER, self.folder)
        self._lock.__enter__()

    def __exit__(self, *_: object) -> None:
        self._lock.__exit__(None, None, None)


def test_nobody_takes_the_place_while_an_old_run_is_replaced(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    folder = tmp_path / "run"
    record_run(OTHER, folder)
    (folder / "notes.txt").write_text("mine")
    real, refused = os.rename, []

    def rename(source: Any, target: Any) -> None:
        real(source, target)
        if Path(source).parent == folder and not refused:
            with pytest.raises(RunError, match="is being written by another process") as raised:
                record_run(OTHER, folder, overwrite=True)
            refused.append(raised.value)
        assert (folder / "notes.txt").read_text() == "mine"  # never moved, at no time

    monkeypatch.setattr(os, "rename", rename)
    record_run(SCENE, folder, overwrite=True)
    assert refused
    assert Result.open(folder).nodes == 11
    assert (folder / "notes.txt").read_text() == "mine"
    assert [path.name for path in tmp_path.iterdir()] == ["run"]
    assert not [path.name for path in folder.iterdir() if path.name.startswith(".replaced")]


def test_a_system_that_renames_no_folder_with_a_lock_in_it(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """Windows: a new run, one in an empty folder, one over another, and one that is refused."""
    monkeypatch.setattr(place, "_RENAMES_LOCKED", False)
    real = os.rename

    def rename(source: Any, target: Any) -> None:
        assert not Path(source, ".lock").exists(), "this system would refuse"
        real(source, target)

    monkeypatch.setattr(os, "rename", rename)
    folder, empty = tmp_path / "run", tmp_path / "empty"
    empty.mkdir()
    record_run(OTHER, folder)
    record_run(OTHER, empty)
    with pytest.raises(RunError, match="holds a run already"):
        record_run(SCENE, folder)
    assert Result.open(folder).nodes == Result.open(empty).nodes == 5
    record_run(SCENE, folder, overwrite=True)
    assert Result.open(folder).nodes == 11
    assert sorted(path.name for path in tmp_path.iterdir()) == ["empty", "run"]


def lay(folder: Path, name: str, *, overwrite: bool = True) -> None:
    """Put what looks like a run in place, as a run does."""
    with place.new_folder(folder, overwrite) as made:
        (made / "data.zarr").mkdir()
        for part in ("scene.toml", "status.json", "data.zarr/zarr.json", "provenance.json"):
            (made / part).write_text(name)


def test_a_death_while_an_old_run_is_replaced_leaves_what_others_put_there(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """At every operation: the notes lie where they were, and the folder can be overwritten again."""
    monkeypatch.setattr(place, "_LEFT_ALONE", -1.0)
    died, last, whole = 0, 1, False
    while not whole:
        room = tmp_path / f"room{last}"
        folder = room / "run"
        lay(folder, "old")
        (folder / "figures").mkdir()
        (folder / "figures" / "mine.txt").write_text("mine")
        with monkeypatch.context() as patch, suppress(Killed):
            Disk(room, last).install(patch)
            lay(folder, "new")
            whole = True
        assert (folder / "figures" / "mine.txt").read_text() == "mine", last
        if is_run(folder):
            assert len({(folder / part).read_text() for part in ("scene.toml", "status.json")}) == 1
        else:
            died += 1
            with pytest.raises(RunError, match="holds a run already"):
                lay(folder, "new", overwrite=False)
        lay(folder, "newest")
        parts = ("scene.toml", "status.json", "data.zarr/zarr.json", "provenance.json")
        assert {(folder / part).read_text() for part in parts} == {"newest"}
        assert (folder / "figures" / "mine.txt").read_text() == "mine"
        assert [path.name for path in room.iterdir()] == ["run"], "leftovers are swept up"
        assert not [path.name for path in folder.iterdir() if path.name.startswith(".replaced")]
        last += 1
    assert died > 3


def test_foreign_folders_of_a_like_name_are_not_swept_up(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(place, "_LEFT_ALONE", -1.0)
    kept = [".run.0123456789ab.new", ".run.0123456789ab.old", ".other.0123456789ab.new"]
    for name in kept:
        (tmp_path / name).mkdir()
        (tmp_path / name / "notes.txt").write_text("mine")
    left = tmp_path / ".run.ba9876543210.new"
    left.mkdir()
    (left / "scene.toml").write_text("")
    record_run(SCENE, tmp_path / "run")
    assert sorted(path.name for path in tmp_path.iterdir()) == sorted([*kept, "run"])


def test_a_disk_that_is_full_while_an_old_run_is_replaced(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    folder = tmp_path / "run"
    record_run(OTHER, folder)
    real = os.rename

    def rename(source: Any, target: Any) -> None:
        if ".new" in str(source) and str(source).endswith("data.zarr"):
            raise OSError(28, "No space left on device", str(source))
        real(source, target)

    monkeypatch.setattr(os, "rename", rename)
    with pytest.raises(RunError, match="no space left on the disk; nothing was kept"):
        record_run(SCENE, folder, overwrite=True)
    only(folder, 5)


def test_what_a_dead_process_left_is_in_nobodys_way(tmp_path: Path) -> None:
    """What is old is swept up; a moment old it may be another process' that is about to lock it."""
    left, fresh = tmp_path / ".run.0123456789ab.new", tmp_path / ".run.ba9876543210.new"
    for folder in (left, fresh):
        folder.mkdir()
    os.utime(left, (0, 0))
    record_run(SCENE, tmp_path / "run")
    assert sorted(path.name for path in tmp_path.iterdir()) == [fresh.name, "run"]
    assert Result.open(tmp_path / "run").status == "finished"


def test_a_reader_is_in_no_writers_way(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """One who asks whether a folder is written holds its lock for a moment. The twin: who keeps it is."""
    import fcntl

    record_run(OTHER, tmp_path / "run")
    for goes in (False, True):
        handle = os.open(tmp_path / "run" / ".lock", os.O_RDONLY)
        fcntl.flock(handle, fcntl.LOCK_SH)
        if goes:
            with monkeypatch.context() as patch:  # it goes as soon as the writer waits
                patch.setattr(time, "sleep", lambda _, held=handle: os.close(held))
                record_run(SCENE, tmp_path / "run", overwrite=True)
        else:
            with pytest.raises(RunError, match="is being written by another process"):
                record_run(SCENE, tmp_path / "run", overwrite=True)
            os.close(handle)
        assert Result.open(tmp_path / "run").nodes == (11 if goes else 5)


def test_processes_that_begin_at_once(tmp_path: Path) -> None:
    code = (
        "import sys, runs\nfrom pathlib import Path\nfrom ropewalk.record.run import record_run\n"
        "print('ready', flush=True); sys.stdin.read(1)\n"
        "record_run(runs.hanging(duration=0.3, segments=int(sys.argv[2])), Path(sys.argv[1]))"
    )
    environment = {**os.environ, "PYTHONPATH": os.pathsep.join(path for path in sys.path if path)}
    rw.simulate(SCENE)  # compiled
    children = [
        subprocess.Popen(
            [sys.executable, "-c", code, str(tmp_path / "run"), str(segments)],
            stdin=subprocess.PIPE,
            stdout=subprocess.PIPE,
            stderr=subprocess.PIPE,
            text=True,
            env=environment,
        )
        for segments in (3, 4, 5)
    ]
    for child in children:
        assert child.stdout is not None
        assert child.stdout.readline() == "ready\n"
    for child in children:
        assert child.stdin is not None
        child.stdin.write("x")
        child.stdin.flush()
    said = [child.communicate()[1] for child in children]
    assert sorted(child.returncode for child in children) == [0, 1, 1], said
    (winner,) = [i for i, child in enumerate(children) if child.returncode == 0]
    only(tmp_path / "run", winner + 4)
    truth = rw.simulate(runs.hanging(duration=0.3, segments=winner + 3))
    np.testing.assert_array_equal(Result.open(tmp_path / "run").positions, truth.positions)
