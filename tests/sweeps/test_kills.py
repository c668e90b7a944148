"""Whatever stops a sweep: what is marked is there, whole and right, and `resume` does the rest."""

from __future__ import annotations

import errno
import os
import random
import signal
import subprocess
import sys
import time
from collections.abc import Callable
from pathlib import Path
from types import SimpleNamespace
from typing import Any

import numpy as np
import pandas as pd
import pytest

import ropewalk as rw
from ropewalk.record.errors import RunError
from ropewalk.sweeps import identity, many
from ropewalk.sweeps.batch import Batcher
from ropewalk.sweeps.store import SweepFolder
from sweeps.scenes import EA, alone, store_bytes, swing

RUNS = 24
TABLE = pd.DataFrame(
    {EA: [2000.0] * (RUNS - 1) + [4.0e6], "rope.length": np.linspace(1.9, 2.1, RUNS)}
)


def make(folder: Path, **options: Any) -> None:
    """Begin the sweep, or go on with it."""
    if (folder / "sweep.json").exists():
        rw.sweep.resume(folder, **({"on": "here"} | options))
        return
    rw.sweep(swing(0.04), TABLE, store=folder, batch=2, **({"on": "here"} | options))


@pytest.fixture(scope="module")
def whole(tmp_path_factory: pytest.TempPathFactory) -> dict[str, bytes]:
    """The store of a sweep that nothing stopped."""
    folder = tmp_path_factory.mktemp("whole") / "s"
    make(folder)
    return store_bytes(folder)


def check(folder: Path, whole: dict[str, bytes], opened: bool = True) -> int:
    """Check that all marked batches are right; return how many there are."""
    if not (folder / "sweep.json").exists():
        return 0
    found, sweep = store_bytes(folder), SweepFolder.open(folder)
    marked = [n for n in range(sweep.plan.batches) if sweep.marked(n) is not None]
    assert sweep.standing() == (marked, [])
    for number in marked:
        for name in ("done", "status", "reason", "broke_at", "tension_max", "positions_last"):
            key = sweep.specs[name].key(number)
            assert found[key] == whole[key]
    if not opened:
        return len(marked)
    ds = rw.sweep.open(folder)
    done = np.isin(np.arange(RUNS) // 2, marked)
    assert ((ds.status.values != "") == done).all()
    return len(marked)


class Killed(BaseException):
    """Stands for the end of the process."""


def dying_at(count: int, error: BaseException) -> Callable[..., None]:
    """`os.replace` that gives up at its call number `count`."""
    real, seen = os.replace, 0

    def replace(source: Any, target: Any) -> None:
        nonlocal seen
        seen += 1
        if seen == count:
            raise error
        real(source, target)

    return replace


@pytest.mark.parametrize("count", [2, 9, 30, 40, 47, 48, 53, 54, 55, 70, 101])
def test_killed_between_any_two_files(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, whole: dict[str, bytes], count: int
) -> None:
    folder = tmp_path / "s"
    with monkeypatch.context() as patch:
        patch.setattr(os, "replace", dying_at(count, Killed()))
        with pytest.raises(Killed):
            make(folder)
    check(folder, whole)
    make(folder)
    assert store_bytes(folder) == whole
    assert not list((folder / ".partial").iterdir())


def test_a_full_disk(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, whole: dict[str, bytes]
) -> None:
    folder = tmp_path / "s"
    make_until = dying_at(70, OSError(errno.ENOSPC, "No space left on device"))
    with monkeypatch.context() as patch:
        patch.setattr(os, "replace", make_until)
        with pytest.raises(RunError, match=r"no space left on the disk; what was marked before is"):
            make(folder)
    assert 0 < check(folder, whole) < 12
    make(folder)
    assert store_bytes(folder) == whole


def test_ctrl_c(tmp_path: Path, whole: dict[str, bytes]) -> None:
    folder = tmp_path / "s"

    def press(standing: Any) -> None:
        if standing.done >= 10:
            raise KeyboardInterrupt

    with pytest.raises(KeyboardInterrupt):
        make(folder, progress=press)
    assert check(folder, whole) >= 5
    make(folder)
    assert store_bytes(folder) == whole


def test_a_damaged_batch_is_seen_and_made_again(tmp_path: Path, whole: dict[str, bytes]) -> None:
    folder = tmp_path / "s"
    make(folder)
    path = folder / "data.zarr" / "tension_max" / "c.3"
    data = bytearray(path.read_bytes())
    data[len(data) // 2] ^= 1
    path.write_bytes(data)
    (folder / "data.zarr" / "status" / "c.5").unlink()
    assert SweepFolder.open(folder).standing()[1] == [3, 5]
    assert rw.sweep.open(folder).status.values[9:13].tolist() == ["finished", "", "", "finished"]
    with pytest.raises(Exception, match=r"(?i)checksum|crc"):
        rw.sweep.open(folder).tension_max.load()
    with pytest.warns(UserWarning, match="2 stored batches are damaged"):
        make(folder)
    assert store_bytes(folder) == whole


def test_two_cannot_write_one_sweep(tmp_path: Path) -> None:
    from ropewalk.record.lock import locked

    make(tmp_path / "s")
    with locked(tmp_path / "s"), pytest.raises(RunError, match="by another process"):
        make(tmp_path / "s")


def test_the_mark_of_another_sweep_is_not_taken(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """A late worker of a sweep that was overwritten writes a whole batch, and its mark."""
    folder = tmp_path / "s"
    make(folder)
    late = SweepFolder.open(folder)
    batch = Batcher(late.plan.recipe).make(late.rows(1))
    other = SimpleNamespace(uuid4=lambda: SimpleNamespace(hex="1" * 32))
    monkeypatch.setattr("ropewalk.sweeps.plan.uuid", other)
    rw.sweep(swing(0.04), TABLE, store=folder, batch=2, on="here", overwrite=True)
    late.write(1, batch)
    assert late.is_done(1)
    assert SweepFolder.open(folder).standing()[1] == [1]


def test_what_is_refused_leaves_the_sweep_that_it_would_overwrite(
    tmp_path: Path, whole: dict[str, bytes]
) -> None:
    folder = tmp_path / "s"
    make(folder)
    with pytest.raises(rw.SceneError, match="greater than 0"):
        rw.sweep(swing(0.04), {EA: [1.0, -1.0]}, store=folder, on="here", overwrite=True)
    assert SweepFolder.open(folder).standing() == (list(range(RUNS // 2)), [])
    assert store_bytes(folder) == whole


def test_a_sweep_that_came_between_is_left_alone(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, whole: dict[str, bytes]
) -> None:
    """Two begin a sweep in one new folder; the second has seen it empty."""
    folder, real = tmp_path / "s", many._first_runs

    def first_runs(*args: Any) -> Any:
        monkeypatch.setattr(many, "_first_runs", real)
        make(folder)
        return real(*args)

    monkeypatch.setattr(many, "_first_runs", first_runs)
    with pytest.raises(RunError, match="was made by another process meanwhile"):
        make(folder)
    assert store_bytes(folder) == whole


def test_other_sources_are_refused(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    make(tmp_path / "s")
    monkeypatch.setattr("ropewalk.sweeps.many.sweep_hash", lambda: "other")
    with pytest.raises(RunError, match="other sources"):
        make(tmp_path / "s")
    monkeypatch.setattr("ropewalk.sweeps.replay.sweep_hash", lambda: "other")
    with pytest.warns(UserWarning, match="may not have the bits of the sweep"):
        rw.sweep.replay(tmp_path / "s", 1)


def test_what_reduces_the_numbers_is_in_the_identity(monkeypatch: pytest.MonkeyPatch) -> None:
    made = identity.sweep_hash.__wrapped__
    assert made() == identity.sweep_hash()
    shorter = [name for name in identity.KEPT_BY if name != "sweeps/keep.py"]
    monkeypatch.setattr(identity, "KEPT_BY", shorter)
    assert made() != identity.sweep_hash()


@pytest.mark.slow
@pytest.mark.skipif(not hasattr(os, "fork"), reason="needs fork, so that 200 deaths are cheap")
def test_200_random_kills(tmp_path: Path, whole: dict[str, bytes]) -> None:
    """Processes that begin or resume a sweep are killed at random moments, 200 times."""
    dice = random.Random(14)
    begun = time.perf_counter()
    make(tmp_path / "timed")
    length = time.perf_counter() - begun
    kills = finished = number = 0
    while kills < 200:
        folder = tmp_path / f"s{number}"
        child = os.fork()
        if child == 0:
            try:
                make(folder)
                os._exit(0)
            finally:
                os._exit(1)
        time.sleep(dice.uniform(0.0, 0.7 * length))
        os.kill(child, signal.SIGKILL)
        _, status = os.waitpid(child, 0)
        if os.WIFSIGNALED(status):
            kills += 1
        else:
            assert os.WEXITSTATUS(status) == 0
        if check(folder, whole, opened=kills % 10 == 0) == RUNS // 2:
            make(folder)  # tidies what the dead left
            assert store_bytes(folder) == whole
            finished, number = finished + 1, number + 1
    assert finished > 5


SCRIPT = """
import sys
import ropewalk as rw
from sweeps.scenes import EA, swing
vary = {EA: [2000.0, 3000.0], "rope.length": [1.9 + 0.2 * i / 7 for i in range(8)]}
ds = rw.sweep(swing(0.04), vary, store=sys.argv[1], batch=2, on="local", workers=2)
print((ds.status == "finished").sum().item())
"""


@pytest.mark.slow
def test_a_script_without_a_guard_gets_a_cluster_of_its_own(tmp_path: Path) -> None:
    script = tmp_path / "script.py"
    script.write_text(SCRIPT)
    root = Path(__file__).resolve().parents[2]
    path = os.pathsep.join([str(root / "src"), str(root / "tests")])
    done = subprocess.run(
        [sys.executable, script, tmp_path / "s"],
        env=os.environ | {"PYTHONPATH": path},
        capture_output=True,
        text=True,
        check=False,
    )
    assert done.stdout == "16\n", done.stderr
    ds = rw.sweep.open(tmp_path / "s")
    own = alone(swing(0.04), **{EA: 3000.0, "rope.length": float(ds.length[3])})
    assert ds.tension_max.values[1, 3] == own.greatest_tension.max()
