"""A run killed at any moment opens, and goes on to the same bits as one never killed."""

from __future__ import annotations

import os
import random
import shutil
import signal
import subprocess
import sys
import time
from collections.abc import Callable
from pathlib import Path
from typing import Any

import numpy as np
import pytest

import ropewalk as rw
import runs
from patience import PATIENCE
from ropewalk.engine.slices import Slices
from ropewalk.record.errors import RunError
from ropewalk.record.event_log import read_events
from ropewalk.record.result import Result
from ropewalk.record.resume import resume_run
from ropewalk.record.run import record_run

CHUNK = 16
CHILD = """
import sys
from pathlib import Path
import ropewalk.record.run as run
from ropewalk.record.resume import resume_run
from ropewalk.scene import load
run.chunk_frames = lambda simulation: 25
folder = Path(sys.argv[2])
if (folder / "provenance.json").exists():
    resume_run(folder, commit_seconds=0.0)
else:
    run.record_run(load(sys.argv[1]), folder, commit_seconds=0.0)
"""


class Killed(BaseException):
    """Stands for the end of the process."""


@pytest.fixture(autouse=True)
def _small_chunks(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr("ropewalk.record.run.chunk_frames", lambda simulation: CHUNK)


def check_opens(folder: Path, whole: Result) -> int:
    """Check that xarray and Result open a folder and see the first frames of the whole run."""
    import xarray as xr

    result = Result.open(folder)
    frames = result.frames
    assert frames >= 1
    with xr.open_zarr(folder / "data.zarr", chunks=None) as data:
        assert dict(data.sizes)["time"] == frames
        for name in whole.source.names:
            np.testing.assert_array_equal(data[name].values, whole.read(name, 0, frames))
    return frames


def equal_runs(one: Path, other: Path) -> None:
    """Check that two runs hold the same arrays, and the same bytes in the same files."""
    left, right = Result.open(one), Result.open(other)
    assert (left.status, left.diagnosis) == (right.status, right.diagnosis)
    for name in ("time", *left.source.names):
        np.testing.assert_array_equal(left.read(name), right.read(name))
    assert runs.data_bytes(one) == runs.data_bytes(other)


def killed_at(count: int, monkeypatch: pytest.MonkeyPatch, after: bool) -> None:
    """Have the process "die" before or after the file that gets its name as number `count`."""
    real: Callable[..., None] = os.replace
    seen = 0

    def replace(source: Any, target: Any) -> None:
        nonlocal seen
        seen += 1
        if seen == count and not after:
            raise Killed
        real(source, target)
        if seen == count:
            raise Killed

    monkeypatch.setattr(os, "replace", replace)


@pytest.mark.parametrize("after", [False, pytest.param(True, marks=pytest.mark.slow)])
@pytest.mark.parametrize(
    "scene",
    [runs.hanging(duration=0.9), runs.winched(2.0, duration=0.9)],
    ids=["hanging", "winch"],
)
def test_killed_between_any_two_files(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, scene: rw.Scene, after: bool
) -> None:
    whole = record_run(scene, tmp_path / "whole", commit_seconds=0.0)
    deaths = 0
    for count in range(3, 500, 8 if after else 13):
        folder = tmp_path / f"run{count}"
        with monkeypatch.context() as patch:
            killed_at(count, patch, after)
            try:
                record_run(scene, folder, commit_seconds=0.0)
                break
            except Killed:
                deaths += 1
        if not folder.exists():  # died before there was a run: nothing is left
            continue
        assert Result.open(folder).status in ("interrupted", "finished")
        check_opens(folder, whole)
        if Result.open(folder).status == "interrupted":
            resume_run(folder, commit_seconds=0.0)
        equal_runs(folder, tmp_path / "whole")
    else:
        pytest.fail("the run never came to its end")
    assert deaths > 10
    assert not list(tmp_path.rglob("*.new"))


def test_killed_again_while_resuming(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    scene, folder = runs.winched(-0.6), tmp_path / "run"
    whole = record_run(scene, tmp_path / "whole", commit_seconds=0.0)
    deaths, chance = 0, random.Random(5)
    while deaths < 12:
        with monkeypatch.context() as patch:
            most = chance.randint(1, 45) if folder.exists() else chance.randint(80, 120)
            killed_at(most, patch, chance.random() < 0.5)
            try:
                if folder.exists():
                    resume_run(folder, commit_seconds=0.0)
                else:
                    record_run(scene, folder, commit_seconds=0.0)
                break
            except Killed:
                deaths += 1
    if Result.open(folder).status == "interrupted":
        check_opens(folder, whole)
        resume_run(folder)
    assert deaths >= 3
    equal_runs(folder, tmp_path / "whole")


def test_commits_do_not_change_the_run(tmp_path: Path) -> None:
    record_run(runs.winched(), tmp_path / "often", commit_seconds=0.0)
    record_run(runs.winched(), tmp_path / "never", commit_seconds=1e9)
    equal_runs(tmp_path / "often", tmp_path / "never")


def environment() -> dict[str, str]:
    """The environment in which a child finds the package."""
    return {**os.environ, "PYTHONPATH": os.pathsep.join(path for path in sys.path if path)}


@pytest.mark.slow
def test_sigkill_at_random_moments(tmp_path: Path) -> None:
    scene = runs.hanging(duration=15.0, time_step=1e-4, segments=60)
    rw.scene.save(scene, tmp_path / "scene.toml")
    folder, reference = tmp_path / "run", tmp_path / "whole"
    command = [sys.executable, "-c", CHILD, str(tmp_path / "scene.toml")]
    subprocess.run([*command, str(reference)], check=True, env=environment())
    whole = Result.open(reference)
    chance, kills = random.Random(20), 0
    while kills < 3:
        if folder.exists() and Result.open(folder).status == "finished":
            shutil.rmtree(folder)  # it came to its end before it was killed: once more
        with subprocess.Popen([*command, str(folder)], env=environment()) as child:
            before = 0 if not folder.exists() else Result.open(folder).frames
            deadline = time.monotonic() + PATIENCE
            while child.poll() is None and time.monotonic() < deadline:
                if folder.exists() and Result.open(folder).frames > before:
                    break
                time.sleep(0.01)
            time.sleep(chance.random() * 0.15)
            child.send_signal(signal.SIGKILL)
        if child.returncode == -signal.SIGKILL:
            kills += 1
            assert Result.open(folder).status in ("interrupted", "finished")
            check_opens(folder, whole)
    if Result.open(folder).status == "interrupted":
        subprocess.run([*command, str(folder)], check=True, env=environment())
    equal_runs(folder, reference)


def test_ctrl_c_finishes_the_block_and_saves(tmp_path: Path) -> None:
    def press(done: int, planned: int, _: object) -> None:
        if done == 2 * CHUNK - 1:
            os.kill(os.getpid(), signal.SIGINT)

    scene = runs.hanging()
    rw.run(scene, tmp_path / "whole")
    with pytest.raises(KeyboardInterrupt):
        rw.run(scene, tmp_path / "run", progress=press)
    result = Result.open(tmp_path / "run")
    assert result.status == "interrupted"
    assert result.frames == 2 * CHUNK
    assert signal.getsignal(signal.SIGINT) is signal.default_int_handler
    rw.resume(tmp_path / "run")
    assert len(result.tension) == 2 * CHUNK  # it goes on as the run that was opened
    equal_runs(tmp_path / "run", tmp_path / "whole")


@pytest.mark.parametrize(("strike", "frames"), [(3, 1), (8, 2)])
def test_ctrl_c_is_heard_inside_a_frame(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, strike: int, frames: int
) -> None:
    """The kernel returns within a frame; its frame is dropped, what was good before is kept."""
    scene = runs.hanging(duration=0.2, frame_rate=20.0, segments=5)  # 25 steps a frame: 4 calls
    rw.run(scene, tmp_path / "whole")
    calls = []

    def note(self: Slices, steps: int, seconds: float) -> None:
        self.most = 8
        calls.append(steps)
        if len(calls) == strike:
            os.kill(os.getpid(), signal.SIGINT)

    monkeypatch.setattr(Slices, "note", note)
    with pytest.raises(KeyboardInterrupt):
        rw.run(scene, tmp_path / "run")
    result = Result.open(tmp_path / "run")
    assert result.status == "interrupted"
    assert len(calls) == strike
    assert result.frames == frames  # the first one is drawn before anything moves
    monkeypatch.undo()
    rw.resume(tmp_path / "run")
    equal_runs(tmp_path / "run", tmp_path / "whole")


def test_a_broken_run_keeps_what_was_good(tmp_path: Path) -> None:
    memory = rw.simulate(runs.breaking(), on_failure="return")
    with pytest.raises(rw.BrokenRun) as raised:
        rw.run(runs.breaking(), tmp_path / "run")
    assert raised.value.result.folder == tmp_path / "run"
    result = Result.open(tmp_path / "run")
    assert result.status == "broke"
    assert result.diagnosis == memory.diagnosis
    assert str(raised.value).startswith(result.diagnosis)  # and how to see more
    np.testing.assert_array_equal(result.positions, memory.positions)
    with pytest.raises(RunError, match="a broken run cannot be resumed"):
        rw.resume(tmp_path / "run")


def test_a_run_into_the_break_is_killed_and_resumed(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    scene = runs.breaking(duration=4.0)
    whole = record_run(scene, tmp_path / "whole", keep_going=True, commit_seconds=0.0)
    assert (whole.status, whole.frames) == ("broke", 241)
    with monkeypatch.context() as patch:
        killed_at(260, patch, after=True)
        with pytest.raises(Killed):
            record_run(scene, tmp_path / "run", keep_going=True, commit_seconds=0.0)
    assert Result.open(tmp_path / "run").status == "interrupted"
    resume_run(tmp_path / "run")
    equal_runs(tmp_path / "run", tmp_path / "whole")


def test_the_break_of_a_run_that_is_killed_behind_it_is_told_once(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """Killed once it was logged, before its frames were committed; the twin is the log, with both."""
    folder = tmp_path / "run"

    def replace(source: Any, target: Any) -> None:
        log = folder / "events.jsonl"
        if log.exists() and b'"broke"' in log.read_bytes():
            raise Killed
        real(source, target)

    real = os.replace
    with monkeypatch.context() as patch:
        patch.setattr(os, "replace", replace)
        with pytest.raises(Killed):
            record_run(runs.breaking(), folder, keep_going=True, commit_seconds=0.0)
    killed = Result.open(folder)
    breaks = [event for event in read_events(folder) if event["event"] == "broke"]
    assert len(breaks) == 1
    assert breaks[0]["time"] > killed.time[-1]
    assert "broke" not in [event["event"] for event in killed.events]
    resumed = resume_run(folder)
    assert [event["event"] for event in resumed.events].count("broke") == 1
    lines = (folder / "events.jsonl").read_bytes().splitlines()
    assert sum(b'"broke"' in line for line in lines) == 2


def test_a_saved_copy_of_an_interrupted_run_is_not_resumed(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    with monkeypatch.context() as patch:
        killed_at(80, patch, after=True)
        with pytest.raises(Killed):
            record_run(runs.hanging(), tmp_path / "run", commit_seconds=0.0)
    Result.open(tmp_path / "run").save(tmp_path / "copy")
    with pytest.raises(RunError, match="no checkpoint, as a saved result has none: resume the"):
        rw.resume(tmp_path / "copy")


def test_a_finished_run_is_not_resumed(tmp_path: Path) -> None:
    rw.run(runs.hanging(duration=0.1), tmp_path / "run")
    with pytest.raises(RunError, match="is finished"):
        rw.resume(tmp_path / "run")
