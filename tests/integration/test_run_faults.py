"""What faulty folders, full disks and foreign files get: one sentence, and nothing lost."""

from __future__ import annotations

import json
import os
import shutil
import subprocess
import sys
from collections.abc import Callable
from pathlib import Path
from zipfile import ZipFile

import numpy as np
import pytest

import ropewalk as rw
import runs
from ropewalk.record import checkpoint, lock
from ropewalk.record.errors import RunError
from ropewalk.record.folder import verify
from ropewalk.record.result import Result
from ropewalk.record.run import record_run
from ropewalk.record.seal import write_sealed

AS_ROOT = hasattr(os, "geteuid") and os.geteuid() == 0


@pytest.fixture(autouse=True)
def _small_chunks(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr("ropewalk.record.run.chunk_frames", lambda simulation: 16)


@pytest.fixture(scope="module")
def whole(tmp_path_factory: pytest.TempPathFactory) -> Path:
    path = tmp_path_factory.mktemp("whole") / "run"
    with pytest.MonkeyPatch.context() as patch:
        patch.setattr("ropewalk.record.run.chunk_frames", lambda simulation: 16)
        rw.run(runs.hanging(), path)
    return path


@pytest.fixture
def folder(whole: Path, tmp_path: Path) -> Path:
    shutil.copytree(whole, tmp_path / "run")
    return tmp_path / "run"


@pytest.fixture
def stopped(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    """A run that a full disk stopped in its fourth chunk."""
    fill_disk(monkeypatch, 4 * 11 + 5)
    with pytest.raises(RunError, match="no space left on the disk; everything up to"):
        record_run(runs.hanging(), tmp_path / "run", commit_seconds=0.0)
    monkeypatch.undo()
    return tmp_path / "run"


def fill_disk(monkeypatch: pytest.MonkeyPatch, after: int) -> None:
    """Let the disk be full after so many written chunk files."""
    from ropewalk.record import store

    seen = 0

    def filling(real: Callable[..., None]) -> Callable[..., None]:
        def write(path: Path, *data: object, **more: object) -> None:
            nonlocal seen
            seen += 1
            if seen > after:
                raise OSError(28, "No space left on device", str(path))
            real(path, *data, **more)

        return write

    monkeypatch.setattr(store, "write", filling(store.write))
    monkeypatch.setattr(store, "write_pages", filling(store.write_pages))


def edit(path: Path, key: str, value: object) -> None:
    """Change one value of a JSON file, and its checksum with it."""
    found = json.loads(path.read_text()) | {key: value}
    found.pop("checksum")
    write_sealed(path, found)


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
        "has the format 99; this version of ropewalk reads 2, 3, 4, 5, 6, 7, 8 and 9",
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


def flip(path: Path, place: int) -> None:
    """Change one bit of a file."""
    data = bytearray(path.read_bytes())
    data[place % len(data)] ^= 1 << (place % 8)
    path.write_bytes(data)


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
