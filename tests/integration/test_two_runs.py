"""Several processes that write to one folder: one wins, the others say so, and nothing is lost."""

from __future__ import annotations

import os
import subprocess
import sys
from collections.abc import Callable
from pathlib import Path
from typing import Any

import numpy as np
import pytest

import ropewalk as rw
import runs
from ropewalk.record import place
from ropewalk.record.errors import RunError
from ropewalk.record.lock import is_locked, locked
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


def test_the_place_is_taken_while_an_old_run_is_moved_away(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    folder = tmp_path / "run"
    record_run(OTHER, folder)
    (folder / "notes.txt").write_text("mine")
    real, others = os.rename, []

    def rename(source: Any, target: Any) -> None:
        real(source, target)
        if str(target).endswith(".old") and not others:
            others.append(source)
            record_run(OTHER, folder)

    monkeypatch.setattr(os, "rename", rename)
    with pytest.raises(RunError, match="holds a run already"):
        record_run(SCENE, folder, overwrite=True)
    assert Result.open(folder).nodes == 5
    assert (folder / "notes.txt").read_text() == "mine"
    assert [path.name for path in tmp_path.iterdir()] == ["run"]


def test_a_disk_that_is_full_while_an_old_run_is_replaced(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    folder = tmp_path / "run"
    record_run(OTHER, folder)
    real = os.rename

    def rename(source: Any, target: Any) -> None:
        if str(source).endswith(".new"):
            raise OSError(28, "No space left on device", str(source))
        real(source, target)

    monkeypatch.setattr(os, "rename", rename)
    with pytest.raises(RunError, match="no space left on the disk; nothing was kept"):
        record_run(SCENE, folder, overwrite=True)
    only(folder, 5)


def test_what_a_dead_process_left_is_in_nobodys_way(tmp_path: Path) -> None:
    (tmp_path / f".run.{os.getpid()}.new").mkdir()
    record_run(SCENE, tmp_path / "run")
    assert Result.open(tmp_path / "run").status == "finished"


def test_a_reader_is_in_no_writers_way(tmp_path: Path) -> None:
    """One who asks whether a folder is written holds its lock for a moment."""
    import fcntl
    import threading

    record_run(SCENE, tmp_path / "run")
    handle = os.open(tmp_path / "run" / ".lock", os.O_RDONLY)
    fcntl.flock(handle, fcntl.LOCK_SH)
    timer = threading.Timer(0.05, lambda: os.close(handle))
    timer.start()
    record_run(SCENE, tmp_path / "run", overwrite=True)
    timer.join()


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
    said = [child.communicate("x")[1] for child in children]
    assert sorted(child.returncode for child in children) == [0, 1, 1], said
    (winner,) = [i for i, child in enumerate(children) if child.returncode == 0]
    only(tmp_path / "run", winner + 4)
    truth = rw.simulate(runs.hanging(duration=0.3, segments=winner + 3))
    np.testing.assert_array_equal(Result.open(tmp_path / "run").positions, truth.positions)
