"""Runs from the command line: folders, summaries, breaks, interruption, resumption."""

from __future__ import annotations

import errno
import json
import os
import resource
import signal
import subprocess
import sys
import time
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from cli.conftest import SCENE
from cli.test_bad_input import refused, tree
from patience import PATIENCE
from ropewalk import Result
from ropewalk.record.seal import write_sealed

HEAVY = ("matplotlib", "xarray", "pandas", "scipy", "zarr", "PIL", "pyarrow")
# Takes some seconds, most of them in steps between frames.
LONG = SCENE.replace("duration = 0.5", "duration = 200.0").replace("0.002", "0.00001")


def folders(path: Path) -> list[str]:
    """The names of the folders below a path."""
    return sorted(entry.name for entry in path.iterdir() if entry.is_dir())


def test_a_run_is_a_folder_with_a_number(ropewalk: Any, scene: Path, tmp_path: Path) -> None:
    for number in (1, 2, 3):
        done = ropewalk("run", scene)
        assert done.exit_code == 0, done.output
        assert done.stdout.splitlines()[-1] == f"run folder: runs/scene-{number}"
        assert "largest tension" in done.stdout
        assert done.stderr == ""
    assert folders(tmp_path / "runs") == ["scene-1", "scene-2", "scene-3"]
    assert Result.open(tmp_path / "runs/scene-2").frames == 31


def test_a_preset_runs_by_its_name(ropewalk: Any, tmp_path: Path) -> None:
    (tmp_path / "r2").mkdir()  # a folder of that name is not in the way
    done = ropewalk("run", "r2", "--duration", "0.2", "-q")
    assert done.exit_code == 0
    assert done.stdout == "runs/r2-1\n"


NEAR = """
[[rope]]
segments = 2
length = 0.2
diameter = 0.01
made_of = { kind = "material", EA = 1e4, mass_per_length = 0.1 }
shape = { kind = "straight", start = [0, 0, 0.0052], direction = [1, 0, 0], velocity = [0, 0, -1] }

[[obstacle]]
kind = "plane"

[run]
method = "implicit-euler"
time_step = 0.0002
duration = 0.01
"""


def test_a_process_of_its_own_finds_what_of_scipy_a_check_needs(process: Any, scene: Path) -> None:
    """Which it keeps from numba: how fast what starts near an obstacle is thrown back is integrated."""
    scene.write_text(NEAR)
    done = done_like(process("run", scene, "-o", "a"))
    assert done.exit_code == 0, done.output
    assert "thrown back" in done.stderr


def test_json_is_all_that_is_on_stdout(ropewalk: Any, scene: Path) -> None:
    done = ropewalk("run", scene, "--json", "-o", "here", "--set", "rope.segments=8")
    found = json.loads(done.stdout)
    assert found["folder"] == "here"
    assert found["status"] == "finished"
    assert found["diagnosis"] is None
    opened = Result.open(Path("here"))
    assert found["results"]["largest tension [N]"] == opened.greatest_tension.max()
    assert opened.nodes == 9


def test_flags_are_in_the_scene_that_is_kept(ropewalk: Any, scene: Path) -> None:
    ropewalk("run", scene, "-o", "a", "--method", "rk4", "--time-step", "0.004", "--duration", "1")
    run = Result.open(Path("a")).scene.run
    assert (run.method, run.time_step, run.duration) == ("rk4", 0.004, 1.0)


def test_a_run_never_overwrites_another(ropewalk: Any, scene: Path, tmp_path: Path) -> None:
    assert ropewalk("run", scene, "-o", "a").exit_code == 0
    before = (tmp_path / "a/provenance.json").read_bytes()
    refused(ropewalk("run", scene, "-o", "a"), "a: holds a run already", "--overwrite")
    assert (tmp_path / "a/provenance.json").read_bytes() == before
    assert ropewalk("run", scene, "-o", "a", "--duration", "1", "--overwrite").exit_code == 0
    assert Result.open(tmp_path / "a").time[-1] == pytest.approx(1.0)


def test_a_run_replaces_nothing_but_runs(ropewalk: Any, scene: Path, tmp_path: Path) -> None:
    (tmp_path / "mine").mkdir()
    (tmp_path / "mine/thesis.txt").write_text("mine")
    for folder, said in [("mine", "is no run folder"), ("mine/thesis.txt", "is a file")]:
        done = ropewalk("run", scene, "-o", folder, "--overwrite")
        refused(done, f"{folder}: ", said)
    refused(ropewalk("run", scene, "-o", "scene.toml/run"), "scene.toml is a file, not a folder")
    assert tree(tmp_path) == ["mine", "mine/thesis.txt", "scene.toml"]


def test_runs_is_a_file(ropewalk: Any, scene: Path, tmp_path: Path) -> None:
    (tmp_path / "runs").write_text("mine")
    refused(ropewalk("run", scene), "runs: ")
    assert tree(tmp_path) == ["runs", "scene.toml"]


def test_a_folder_without_permission(
    ropewalk: Any, scene: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    def refuse(path: Any, *_: Any, **__: Any) -> None:
        raise PermissionError(errno.EACCES, "Permission denied", str(path))

    monkeypatch.setattr(os, "mkdir", refuse)
    refused(ropewalk("run", scene, "-o", "a"), "a: ", "there is no permission")
    refused(ropewalk("run", scene), "runs: there is no permission")
    refused(ropewalk("new", "x", "-o", "deep/x.toml"), "deep: there is no permission")
    assert tree(tmp_path) == ["scene.toml"]


def limited(size: int) -> dict[str, Any]:
    """Options of a process that cannot write files larger than `size` bytes."""
    limits = (size, resource.getrlimit(resource.RLIMIT_FSIZE)[1])
    return {"preexec_fn": lambda: resource.setrlimit(resource.RLIMIT_FSIZE, limits)}


def test_a_disk_that_is_full_at_once(process: Any, scene: Path, tmp_path: Path) -> None:
    done = process("run", scene, **limited(100))
    refused(done_like(done), "runs/scene-1: cannot be written", "larger than is allowed")
    assert tree(tmp_path) == ["scene.toml"]


def test_a_disk_that_fills_up_during_the_run(process: Any, scene: Path, tmp_path: Path) -> None:
    scene.write_text(LONG)
    done = done_like(process("run", scene, "-o", "a", **limited(60_000)))
    refused(done, "a: cannot be written", "ropewalk resume")
    assert Result.open(tmp_path / "a").status == "interrupted"


class done_like:  # noqa: N801 - it is used as a function
    """A finished process with the names of click's test results."""

    def __init__(self, done: subprocess.CompletedProcess[str]) -> None:
        self.exit_code, self.stdout, self.stderr = done.returncode, done.stdout, done.stderr
        self.output = done.stdout + done.stderr


def test_a_run_that_breaks_says_why_and_keeps_what_was_good(ropewalk: Any) -> None:
    done = ropewalk("run", "r7", "-o", "a")
    assert done.exit_code == 3
    assert done.stderr.index("warning: the run will break") < done.stderr.index("Broke after")
    assert "is kept in a" in done.stderr
    assert "Traceback" not in done.stderr
    kept = Result.open(Path("a"))
    assert kept.status == "broke"
    assert np.isfinite(kept.positions).all()
    assert 0 < kept.frames < kept.plan.frames
    refused(ropewalk("resume", "a"), "a: broke; a broken run cannot be resumed")


def test_keep_going_records_the_break_too(ropewalk: Any) -> None:
    done = ropewalk("run", "r7", "-o", "a", "--keep-going", "--json")
    assert done.exit_code == 3
    found = json.loads(done.stdout)
    assert found["status"] == "broke"
    assert "Broke after" in found["diagnosis"]
    kept = Result.open(Path("a"))
    assert kept.frames == kept.plan.frames + 1


def test_quiet_prints_the_folder_only(ropewalk: Any) -> None:
    done = ropewalk("run", "r6", "-q")
    assert done.stdout == "runs/r6-1\n"
    assert done.exit_code == 3
    assert "warning" not in done.stderr


def test_info_says_what_is_in_a_folder(ropewalk: Any, scene: Path) -> None:
    ropewalk("run", scene, "-o", "a")
    done = ropewalk("info", "a")
    for text in ("small", "finished", "31 x 7 x 3", "m/s", "numba", "largest tension"):
        assert text in done.stdout
    found = json.loads(ropewalk("info", "a", "--json").stdout)
    assert found["arrays"]["positions"] == {"shape": [31, 7, 3], "unit": "m"}
    assert found["provenance"]["ropewalk"]


@pytest.mark.parametrize("command", ["info", "plot", "movie", "resume", "export"])
def test_folders_that_are_no_runs(ropewalk: Any, scene: Path, command: str) -> None:
    more = ("--to", "csv") if command == "export" else ()
    refused(ropewalk(command, "nowhere", *more), "nowhere: no such run folder")
    refused(ropewalk(command, scene, *more), "is a file, not a run folder")
    refused(ropewalk(command, ".", *more), "is no run folder")
    assert ropewalk("run", scene, "-o", "a").exit_code == 0
    path = Path("a/provenance.json")
    path.write_text(json.dumps(json.loads(path.read_text()) | {"format": 99}))
    refused(
        ropewalk(command, "a", *more),
        "a: has the format 99; this version of ropewalk reads 2, 3, 4, 5, 6, 7, 8, 9 and 10",
    )
    path.write_text("{")
    refused(ropewalk(command, "a", *more), "provenance.json: is damaged")
    assert not list(Path("a").glob("*.gif"))


def test_nothing_to_resume(ropewalk: Any, scene: Path) -> None:
    ropewalk("run", scene, "-o", "a")
    refused(ropewalk("resume", "a"), "a: is finished: there is nothing to resume")


def start(tmp_path: Path, *arguments: str) -> subprocess.Popen[str]:
    """Start the command line as a process of its own."""
    return subprocess.Popen(
        [sys.executable, "-m", "ropewalk", *arguments],
        cwd=tmp_path,
        stdout=subprocess.PIPE,
        stderr=subprocess.PIPE,
        text=True,
    )


def wait_for_frames(folder: Path, frames: int) -> None:
    """Wait until a run that goes on has committed some frames."""
    for _ in range(int(20 * PATIENCE)):
        try:
            if json.loads((folder / "status.json").read_text())["frames"] >= frames:
                return
        except (OSError, ValueError):
            pass
        time.sleep(0.05)
    raise AssertionError("the run does not get on")


def same(a: Path, b: Path) -> bool:
    """Whether two runs hold the same bits."""
    one, two = Result.open(a), Result.open(b)
    return one.frames == two.frames and all(
        np.array_equal(one.read(name), two.read(name), equal_nan=True)
        for name in ("time", *one.source.names)
    )


@pytest.fixture(scope="module")
def uninterrupted(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """A run of the long scene from beginning to end."""
    folder = tmp_path_factory.mktemp("whole")
    (folder / "scene.toml").write_text(LONG)
    assert start(folder, "run", "scene.toml", "-o", "a", "-q").wait(timeout=PATIENCE) == 0
    return folder / "a"


@pytest.mark.slow
@pytest.mark.parametrize(("sent", "status"), [(signal.SIGKILL, -9), (signal.SIGINT, 130)])
def test_a_run_that_is_stopped_is_resumed_to_the_same_bits(
    process: Any,
    scene: Path,
    tmp_path: Path,
    uninterrupted: Path,
    sent: signal.Signals,
    status: int,
) -> None:
    scene.write_text(LONG)
    running = start(tmp_path, "run", "scene.toml", "-o", "a")
    wait_for_frames(tmp_path / "a", 100)
    running.send_signal(sent)
    _, said = running.communicate(timeout=PATIENCE)
    assert running.returncode == status
    if sent == signal.SIGINT:
        assert "go on with: ropewalk resume a" in said
    stopped = Result.open(tmp_path / "a")
    assert stopped.status == "interrupted"
    assert 100 <= stopped.frames < stopped.plan.frames
    assert not same(tmp_path / "a", uninterrupted)
    done = process("resume", "a", "--json")
    assert done.returncode == 0, done.stderr
    assert json.loads(done.stdout)["status"] == "finished"
    assert same(tmp_path / "a", uninterrupted)


def test_a_run_by_other_sources_is_resumed_only_by_force(
    ropewalk: Any, scene: Path, tmp_path: Path
) -> None:
    ropewalk("run", scene, "-o", "a")
    for name, change in [("provenance", {"source_hash": "0"}), ("status", {"status": "running"})]:
        path = tmp_path / f"a/{name}.json"
        found = json.loads(path.read_text()) | change
        found.pop("checksum")
        write_sealed(path, found)
    refused(ropewalk("resume", "a"), "other sources of ropewalk", "give --force")
    done = ropewalk("resume", "a", "--force")
    assert done.exit_code == 0, done.output
    assert "warning: a: begun with other sources" in done.stderr


def test_the_first_run_says_that_it_compiles(
    ropewalk: Any, scene: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    from ropewalk.cli import progress

    monkeypatch.setattr(progress, "is_compiled", lambda *_: False)
    done = ropewalk("run", scene)
    assert done.stderr.startswith("compiling semi-implicit-euler: the first run")


@pytest.mark.parametrize("arguments", [("run", "scene.toml"), ("run", "r6"), ("check", "r4")])
def test_running_loads_nothing_heavy(
    tmp_path: Path, scene: Path, arguments: tuple[str, str]
) -> None:
    code_of_end = 3 if arguments[1] == "r6" else 0  # it breaks
    code = (
        "import sys\nfrom ropewalk.cli import main\n"
        "try:\n    main(sys.argv[1:])\n"
        f"except SystemExit as end:\n    assert (end.code or 0) == {code_of_end}, end.code\n"
        f"print([name for name in {HEAVY!r} if sys.modules.get(name)])"
    )
    done = subprocess.run(
        [sys.executable, "-c", code, *arguments],
        capture_output=True,
        text=True,
        cwd=tmp_path,
        check=True,
    )
    expected = "['scipy']" if arguments[0] == "check" and "scipy" in done.stdout else "[]"
    assert done.stdout.splitlines()[-1] == expected


def test_an_error_in_ropewalk_itself(
    ropewalk: Any, scene: Path, monkeypatch: pytest.MonkeyPatch, tmp_path: Path
) -> None:
    def fail(*_: Any, **__: Any) -> None:
        raise ZeroDivisionError("by nought")

    monkeypatch.setattr("ropewalk.lowering.build", fail)
    monkeypatch.setattr("tempfile.tempdir", str(tmp_path))
    done = ropewalk("run", scene)
    assert done.exit_code == 1
    assert done.stdout == ""
    first, second = done.stderr.splitlines()
    assert first == "error in Ropewalk itself: ZeroDivisionError: by nought"
    kept = Path(second.split(";")[0].removeprefix("the traceback is in "))
    assert "Traceback" in kept.read_text()
    done = ropewalk("run", scene, "--debug")
    assert done.exit_code == 1
    assert "Traceback" in done.stderr


def test_a_reader_that_goes_away(tmp_path: Path) -> None:
    done = subprocess.run(
        f"{sys.executable} -m ropewalk presets | head -1",
        shell=True,
        capture_output=True,
        text=True,
        check=False,
    )
    assert done.stderr == ""


def test_info_verifies_every_chunk(ropewalk: Any, scene: Path, tmp_path: Path) -> None:
    assert ropewalk("run", scene, "-o", "a").exit_code == 0
    done = ropewalk("info", "a", "--verify")
    assert done.exit_code == 0, done.output
    assert "chunks of numbers and all beside them, as they were written" in done.stderr
    chunks = sorted((tmp_path / "a/data.zarr").glob("*/c.*"))
    for path in chunks[:2]:
        data = bytearray(path.read_bytes())
        data[len(data) // 2] ^= 16
        path.write_bytes(data)
    named = [f"a/data.zarr/{path.parent.name}/{path.name}: is damaged" for path in chunks[:2]]
    refused(ropewalk("info", "a", "--verify"), "2 things are wrong", *named)
    refused(ropewalk("info", "a", "--verify", "--json"), *named)
