"""Whatever stops a sweep: what is marked is there, whole and right, and `resume` does the rest."""

from __future__ import annotations

import os
import random
import signal
import subprocess
import sys
import time
from contextlib import suppress
from pathlib import Path
from types import SimpleNamespace
from typing import Any

import numpy as np
import pytest

import ropewalk as rw
from deaths import Disk, Killed
from ropewalk.record.errors import RunError
from ropewalk.sweeps import many, worker
from ropewalk.sweeps.batch import Batcher
from ropewalk.sweeps.checked import CheckedStore
from ropewalk.sweeps.summary import summary
from ropewalk.sweeps.sweep_folder import SweepFolder
from sweeps.scenes import EA, RUNS, TABLE, alone, flip, make, store_bytes, swing


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
            assert found.get(key) == whole.get(key)  # `reason`, `broke_at`: only where one broke
    if not opened:
        return len(marked)
    ds = rw.sweep.open(folder)
    done = np.isin(np.arange(RUNS) // 2, marked)
    assert ((ds.status.values != "") == done).all()
    kept = np.isfinite(ds.tension_max.values)
    assert not (kept & ~done).any()  # data without their mark
    assert kept.sum() == done[:-1].sum()  # the last run breaks
    return len(marked)


def operations(folder: Path) -> int:
    """Number of operations that write files in an undisturbed sweep."""
    disk = Disk(folder)
    with pytest.MonkeyPatch.context() as patch:
        disk.install(patch)
        make(folder)
    return disk.done


def dying(folder: Path, last: int, whole: dict[str, bytes], *, full: bool = False) -> int:
    """Make a sweep that dies at operation `last`, then go on with it; return the batches that it left."""
    told = RunError if full else Killed
    with pytest.MonkeyPatch.context() as patch:
        Disk(folder, last, full=full).install(patch)
        with pytest.raises(told, match="no space left on the disk" if full else None):
            make(folder)
    left = check(folder, whole)
    make(folder)
    assert store_bytes(folder) == whole
    assert not list((folder / ".partial").iterdir())
    return left


def test_killed_at_any_operation(tmp_path: Path, whole: dict[str, bytes]) -> None:
    """Half a write, no fsync, no new name: every 17th operation, so that all kinds are among them."""
    count = operations(tmp_path / "all")
    left = [dying(tmp_path / f"s{n}", n, whole) for n in range(3, count + 1, 17)]
    assert set(left) >= set(range(1, RUNS // 2))  # the death of every batch was tried


@pytest.mark.slow
def test_killed_at_every_operation(tmp_path: Path, whole: dict[str, bytes]) -> None:
    for last in range(1, operations(tmp_path / "all") + 1):
        dying(tmp_path / f"s{last}", last, whole)


def test_a_full_disk(tmp_path: Path, whole: dict[str, bytes]) -> None:
    count = operations(tmp_path / "all")
    left = [dying(tmp_path / f"s{n}", n, whole, full=True) for n in range(count // 2, count, 47)]
    assert 0 < min(left) < max(left) < RUNS // 2


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
    monkeypatch.setattr("ropewalk.sweeps.sweep_plan.uuid", other)
    rw.sweep(swing(0.04), TABLE, store=folder, batch=2, on="here", overwrite=True)
    late.write(1, batch)
    assert late.is_done(1)
    assert SweepFolder.open(folder).standing()[1] == [1]


def test_a_late_worker_of_a_sweep_that_was_overwritten_writes_nothing(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """It has opened the folder before, and its numbers are of another rope."""
    folder = tmp_path / "s"
    make(folder)
    late = SweepFolder.open(folder)
    job, rows = worker.job_of(late.plan, folder), worker.packed_rows(late.rows(1))
    assert worker.make_batch(job, 1, rows) == {"number": 1, "what": worker.STORED, "broken": None}
    other = SimpleNamespace(uuid4=lambda: SimpleNamespace(hex="1" * 32))
    monkeypatch.setattr("ropewalk.sweeps.sweep_plan.uuid", other)
    softer = TABLE.assign(**{EA: TABLE[EA] / 2})
    new = rw.sweep(swing(0.04), softer, store=folder, batch=2, on="here", overwrite=True)
    refused = worker.make_batch(job, 1, rows)
    assert refused["what"] == worker.REFUSED
    assert "holds another sweep by now" in refused["why"]
    assert SweepFolder.open(folder).standing()[1] == []
    np.testing.assert_array_equal(rw.sweep.open(folder).tension_max, new.tension_max)


def test_killed_while_a_sweep_with_figures_is_overwritten(
    tmp_path: Path, whole: dict[str, bytes]
) -> None:
    """What is left can be overwritten again, or gone on with."""

    def overwrite(folder: Path) -> None:
        rw.sweep(swing(0.04), TABLE, store=folder, batch=2, on="here", overwrite=True)

    for last in (1, 2, 3, 5, 8, 20, 60, 110):
        folder = tmp_path / f"s{last}"
        make(folder)
        (folder / "figures").mkdir()
        (folder / "figures" / "tension_max.png").write_bytes(b"drawn")
        with pytest.MonkeyPatch.context() as patch:
            Disk(folder, last).install(patch)
            with pytest.raises(Killed):
                overwrite(folder)
        if last > 60:
            check(folder, whole)
        overwrite(folder)
        assert store_bytes(folder) == whole
    alone_there = tmp_path / "t"
    (alone_there / "figures").mkdir(parents=True)
    with pytest.raises(RunError, match="holds something else than a sweep"):
        overwrite(alone_there)


def test_a_batch_without_its_mark_is_not_there(tmp_path: Path) -> None:
    """Killed between the data and the mark, or while what is damaged is made again."""
    folder = tmp_path / "s"
    make(folder)
    data = rw.sweep.open(folder).load()
    SweepFolder.open(folder).unmark([0, 11])
    flip(folder / "data.zarr" / "positions_last" / "c.0.0.0")
    found = rw.sweep.open(folder).load()
    made = np.arange(2, RUNS - 2)
    assert np.flatnonzero(found.status != "").tolist() == made.tolist()
    assert np.flatnonzero(np.isfinite(found.tension_max)).tolist() == made.tolist()
    assert not found.reason.values[[0, 1, -2, -1]].any()
    np.testing.assert_array_equal(found.tension_max[made], data.tension_max[made])
    np.testing.assert_array_equal(found.length, data.length)
    told = summary(SweepFolder.open(folder))
    assert (told["done"], told["damaged"]) == (RUNS - 4, [])
    kept = next(one for one in told["kept"] if one["name"] == "tension_max")
    assert kept["quantiles"][0] == data.tension_max[made].min()
    assert kept["quantiles"][-1] == data.tension_max[made].max()
    plain = CheckedStore.of(SweepFolder.open(folder)).with_read_only(True)
    assert plain.unmarked == [slice(0, 2), slice(22, 24)]


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
    monkeypatch.setattr("ropewalk.sweeps.rerun.sweep_hash", lambda: "other")
    with pytest.warns(UserWarning, match="may not have the bits of the sweep"):
        rw.sweep.replay(tmp_path / "s", 1)


@pytest.mark.slow
@pytest.mark.skipif(not hasattr(os, "fork"), reason="needs fork, so that 200 deaths are cheap")
def test_200_random_kills(tmp_path: Path, whole: dict[str, bytes]) -> None:
    """Processes that begin or resume a sweep are killed at random moments, 200 times."""
    dice = random.Random(14)
    begun = time.perf_counter()
    make(tmp_path / "timed")
    length = time.perf_counter() - begun
    kills = finished = number = before = 0
    while kills < 200 or finished < 6:
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
        there = check(folder, whole, opened=kills % 10 == 0)
        if os.WIFSIGNALED(status):
            kills += 1
            length *= 1.05 if there == before else 1.0  # this computer has slowed down
        else:
            assert os.WEXITSTATUS(status) == 0
            length *= 0.95
        before = there
        if there == RUNS // 2:
            make(folder)  # tidies what the dead left
            assert store_bytes(folder) == whole
            finished, number, before = finished + 1, number + 1, 0


SCRIPT = """
import sys
import ropewalk as rw
from deaths import Disk, Killed
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


CLIENT = """
import sys
import ropewalk as rw
from distributed import LocalCluster
from sweeps.scenes import TABLE, swing
from ropewalk.sweeps import sweep_plan
from types import SimpleNamespace

sweep_plan.uuid = SimpleNamespace(uuid4=lambda: SimpleNamespace(hex="0" * 32))

def told(standing):
    print(standing.done, flush=True)
    if standing.done >= 6:
        sys.stdin.read()  # waits here for its death, with batches in the hands of its workers

if __name__ == "__main__":
    rw.sweep(swing(0.04), TABLE, store=sys.argv[1], batch=2, on="local", workers=2, progress=told)
"""


def offspring(parent: int) -> set[int]:
    """The processes that a process has started, and theirs."""
    of: dict[int, int] = {}
    for stat in Path("/proc").glob("[0-9]*/stat"):
        with suppress(OSError):
            of[int(stat.parent.name)] = int(stat.read_text().rpartition(")")[2].split()[1])
    found, more = set(), {parent}
    while more:
        found |= more
        more = {child for child, one in of.items() if one in more} - found
    return found - {parent}


def alive(number: int) -> bool:
    """Whether a process is there and is no mere entry that nobody has asked for."""
    try:
        state = Path(f"/proc/{number}/stat").read_text().rpartition(")")[2].split()[0]
    except OSError:
        return False
    return state != "Z"


@pytest.mark.slow
@pytest.mark.skipif(not Path("/proc/self/stat").exists(), reason="looks at processes by /proc")
def test_the_client_of_workers_is_killed(tmp_path: Path, whole: dict[str, bytes]) -> None:
    """Its workers end by themselves; what is marked is right, and the rest is made to the same bits."""
    folder, script = tmp_path / "s", tmp_path / "script.py"
    script.write_text(CLIENT)
    root = Path(__file__).resolve().parents[2]
    path = os.pathsep.join([str(root / "src"), str(root / "tests")])
    client = subprocess.Popen(
        [sys.executable, script, folder],
        env=os.environ | {"PYTHONPATH": path},
        stdin=subprocess.PIPE,
        stdout=subprocess.PIPE,
        text=True,
    )
    try:
        assert client.stdout is not None
        while int(client.stdout.readline()) < 6:
            pass
        workers = offspring(client.pid)
        assert len([number for number in workers if alive(number)]) >= 2
    finally:
        client.kill()
        client.wait()
    while any(map(alive, workers)):  # one that stayed would keep this test waiting
        time.sleep(0.05)
    assert check(folder, whole) >= 3
    make(folder)
    assert store_bytes(folder) == whole
