"""What faulty folders, full disks and foreign files get: one sentence, and nothing lost."""

from __future__ import annotations

import json
import os
import shutil
import subprocess
import sys
from collections.abc import Callable
from pathlib import Path

import numpy as np
import pytest

import ropewalk as rw
import runs
from integration.faulty_runs import edit, fill_disk, flip
from ropewalk.record.errors import RunError
from ropewalk.record.folder import verify
from ropewalk.record.result import Result
from ropewalk.record.seal import write_sealed

AS_ROOT = hasattr(os, "geteuid") and os.geteuid() == 0


@pytest.fixture(autouse=True)
def _small_chunks(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr("ropewalk.record.run.chunk_frames", lambda simulation: 16)


def damage_root(folder: Path, change: Callable[[dict[str, object]], None]) -> None:
    """Change the root metadata of a run."""
    path = folder / "data.zarr" / "zarr.json"
    root = json.loads(path.read_text())
    change(root)
    path.write_text(json.dumps(root))


FAULTS: dict[str, tuple[Callable[[Path], object], str]] = {
    "no scene": (lambda f: (f / "scene.toml").unlink(), "scene.toml: is missing"),
    "faulty scene": (
        lambda f: (f / "scene.toml").write_text("[[rope]]\nsegments = 0\n"),
        "scene.toml: is damaged or was changed: rope[0]",
    ),
    "another scene": (
        lambda f: rw.scene.save(runs.hanging(segments=12), f / "scene.toml"),
        "does not fit the scene",
    ),
    "no provenance": (lambda f: (f / "provenance.json").unlink(), "provenance.json: is missing"),
    "torn provenance": (
        lambda f: (f / "provenance.json").write_text('{"format": 3, '),
        "provenance.json: is damaged: it holds no JSON",
    ),
    "empty provenance": (
        lambda f: write_sealed(f / "provenance.json", {"format": 6}),
        "does not describe a run",
    ),
    "another version": (
        lambda f: edit(f / "provenance.json", "format", 99),
        "has the format 99; this version of ropewalk reads 2, 3, 4, 5, 6, 7, 8, 9 and 10",
    ),
    "another store": (
        lambda f: damage_root(f, lambda root: root["attributes"].update(ropewalk_format=98)),  # type: ignore[attr-defined]
        "has the format 98",
    ),
    "no store": (lambda f: shutil.rmtree(f / "data.zarr"), "zarr.json: is missing"),
    "no root": (lambda f: (f / "data.zarr" / "zarr.json").unlink(), "zarr.json: is missing"),
    "binary root": (
        lambda f: (f / "data.zarr" / "zarr.json").write_bytes(b"\xff\x00\x80"),
        "holds no JSON",
    ),
    "list for root": (lambda f: (f / "data.zarr" / "zarr.json").write_text("[]"), "no JSON object"),
    "no arrays": (
        lambda f: damage_root(f, lambda root: root.pop("consolidated_metadata")),
        "does not describe a run",
    ),
    "torn status": (lambda f: (f / "status.json").write_text("{"), "status.json: is damaged"),
}


@pytest.mark.parametrize("name", FAULTS)
def test_a_damaged_folder_says_what_is_wrong(folder: Path, name: str) -> None:
    damage, said = FAULTS[name]
    damage(folder)
    with pytest.raises(RunError) as raised:
        Result.open(folder)
    assert said in str(raised.value)
    assert str(folder) in str(raised.value)
    assert "\n" not in str(raised.value)
    with pytest.raises(RunError):
        rw.resume(folder)


@pytest.mark.parametrize("cut", [0, 10, 200])
def test_a_cut_or_missing_chunk_is_named(folder: Path, cut: int) -> None:
    chunk = folder / "data.zarr" / "positions" / "c.2.0.0"
    chunk.write_bytes(chunk.read_bytes()[:cut])
    result = Result.open(folder)
    assert np.isfinite(result.velocities).all()
    with pytest.raises(RunError, match=r"positions/c\.2\.0\.0: is damaged"):
        _ = result.positions
    chunk.unlink()
    with pytest.raises(RunError, match=r"positions/c\.2\.0\.0: is missing"):
        _ = result.positions


def test_no_folder_at_all(tmp_path: Path) -> None:
    (tmp_path / "file").write_text("text")
    (tmp_path / "empty").mkdir()
    for name, said in (
        ("nothing", "no such run folder"),
        ("file", "is a file, not a run folder"),
        ("empty", "is no run folder"),
    ):
        for use in (Result.open, rw.resume):
            with pytest.raises(RunError, match=said):
                use(tmp_path / name)


def test_a_run_never_replaces_what_is_there(folder: Path, tmp_path: Path) -> None:
    scene = runs.hanging(duration=0.1)
    (tmp_path / "file").write_text("text")
    (tmp_path / "mine").mkdir()
    (tmp_path / "mine" / "thesis.tex").write_text("text")
    before = sorted(path for path in tmp_path.rglob("*"))
    for name, overwrite, said in (
        ("file", False, "is a file"),
        ("file", True, "is a file"),
        ("file/run", True, "a part of the path is a file"),
        ("mine", False, "is no run folder"),
        ("mine", True, "is no run folder"),
        ("run", False, "holds a run already"),
    ):
        with pytest.raises(RunError, match=said):
            rw.run(scene, tmp_path / name, overwrite=overwrite)
    assert sorted(path for path in tmp_path.rglob("*")) == before
    assert Result.open(folder).frames == 121


def test_overwriting_keeps_foreign_files(folder: Path) -> None:
    (folder / "notes.txt").write_text("mine")
    result = rw.run(runs.hanging(duration=0.1), folder, overwrite=True)
    assert result.frames == Result.open(folder).frames == 7
    assert (folder / "notes.txt").read_text() == "mine"
    assert [path.name for path in folder.parent.iterdir()] == ["run"]


def test_an_empty_folder_is_used(tmp_path: Path) -> None:
    (tmp_path / "run").mkdir()
    assert rw.run(runs.hanging(duration=0.1), tmp_path / "run").frames == 7


def test_a_faulty_scene_writes_nothing(tmp_path: Path) -> None:
    with pytest.raises(rw.SceneError):
        rw.run("no-such-preset", tmp_path / "run")
    assert list(tmp_path.iterdir()) == []


@pytest.mark.skipif(AS_ROOT, reason="root may write everywhere")
def test_a_folder_without_permission(tmp_path: Path) -> None:
    tmp_path.chmod(0o500)
    with pytest.raises(RunError, match="there is no permission"):
        rw.run(runs.hanging(), tmp_path / "run")
    tmp_path.chmod(0o700)


def test_a_refused_folder_says_so(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    def refuse(*_: object, **__: object) -> None:
        raise PermissionError(13, "Permission denied")

    monkeypatch.setattr(Path, "mkdir", refuse)
    with pytest.raises(RunError, match="cannot be written: there is no permission"):
        rw.run(runs.hanging(), tmp_path / "run")


def test_a_full_disk_keeps_what_was_committed(stopped: Path, whole: Path) -> None:
    result = Result.open(stopped)
    assert result.status == "interrupted"
    assert 1 <= result.frames < 121
    np.testing.assert_array_equal(result.positions, Result.open(whole).positions[: result.frames])
    assert not list(stopped.rglob("*.partial"))
    last = json.loads((stopped / "events.jsonl").read_text().splitlines()[-1])
    assert last["event"] == "failed"
    rw.resume(stopped)
    assert runs.data_bytes(stopped) == runs.data_bytes(whole)


def test_a_disk_full_from_the_start_leaves_nothing(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    fill_disk(monkeypatch, 3)
    with pytest.raises(RunError, match="no space left on the disk"):
        rw.run(runs.hanging(), tmp_path / "run")
    assert list(tmp_path.iterdir()) == []


@pytest.mark.skipif(sys.platform == "win32", reason="needs limits of the system")
def test_a_real_limit_on_file_size(tmp_path: Path) -> None:
    code = (
        "import resource, sys, runs, ropewalk as rw\n"
        "rw.simulate(runs.hanging(duration=0.1))\n"
        "resource.setrlimit(resource.RLIMIT_FSIZE, (200_000, 200_000))\n"
        "try:\n    rw.run(runs.hanging(segments=200), sys.argv[1])\n"
        "except rw.RunError as error:\n    print(error)"
    )
    env = {**os.environ, "PYTHONPATH": os.pathsep.join(path for path in sys.path if path)}
    env["PYTHONDONTWRITEBYTECODE"] = "1"  # the limit would cut it short for good
    done = subprocess.run(
        [sys.executable, "-c", code, str(tmp_path / "run")],
        capture_output=True,
        text=True,
        check=True,
        env=env,
    )
    assert "the file would be larger than is allowed here" in done.stdout
    assert done.stdout.count("\n") == 1
    assert Result.open(tmp_path / "run").frames == 1
    rw.resume(tmp_path / "run")
    np.testing.assert_array_equal(
        Result.open(tmp_path / "run").positions, rw.simulate(runs.hanging(segments=200)).positions
    )


def test_one_bit_in_any_chunk_is_found(folder: Path) -> None:
    chunks = [path for path in (folder / "data.zarr").glob("*/c.*") if path.is_file()]
    assert len(chunks) > 20
    assert verify(folder) == (len(chunks), (), True)
    before = Result.open(folder)
    kept = {name: before.read(name) for name in before.source.names}
    for number, path in enumerate(chunks):
        sound = path.read_bytes()
        flip(path, 7919 * (number + 1))
        (fault,) = verify(folder).faults
        assert fault.path == str(path)
        assert "do not fit their checksum" in fault.rule
        if (name := path.parent.name) in kept:
            with pytest.raises(RunError, match="is damaged"):
                Result.open(folder).read(name)
        path.write_bytes(sound)
    assert verify(folder).faults == ()
