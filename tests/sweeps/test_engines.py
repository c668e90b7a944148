"""What goes to workers and comes back, and what their errors become."""

from __future__ import annotations

import json
import os
import subprocess
import sys
import warnings
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import numpy as np
import pytest

import ropewalk as rw
from ropewalk.engine import islands
from ropewalk.record.errors import InputError, RunError
from ropewalk.sweeps import engines, worker
from ropewalk.sweeps.sweep_folder import SweepFolder
from ropewalk.sweeps.worker import packed_rows, unpacked_rows
from sweeps.scenes import EA, SCENE, STIFF, make, same, swing

VARY = {EA: STIFF, "rope.length": [1.9, 2.0, 2.1]}


@pytest.fixture(scope="module")
def client() -> Iterator[Any]:
    """A client of a worker in this process, so that what it gets can be looked at."""
    from distributed import Client, LocalCluster

    with (
        LocalCluster(n_workers=1, threads_per_worker=1, processes=False, dashboard_address=None,
                     silence_logs=50) as cluster,
        Client(cluster, set_as_default=False) as made,
    ):  # fmt: skip
        yield made


def plain(value: Any) -> bool:
    """Whether a value is made of numbers, texts, bytes, lists and mappings of texts only."""
    if isinstance(value, dict):
        return all(type(key) is str for key in value) and all(map(plain, value.values()))
    if type(value) in (list, tuple):
        return all(map(plain, value))
    return value is None or type(value) in (str, bytes, int, float, bool)


@pytest.mark.parametrize("stored", [True, False])
def test_nothing_but_plain_data_goes_to_workers_and_back(
    client: Any, tmp_path: Path, monkeypatch: pytest.MonkeyPatch, stored: bool
) -> None:
    sent: list[Any] = []
    back: list[Any] = []
    submit = client.submit

    def noted(function: Any, *args: Any, **options: Any) -> Any:
        assert function in (worker.make_batch, worker.warm_up)  # by name, from the package
        sent.append(args)
        future = submit(function, *args, **options)
        future.add_done_callback(lambda done: back.append(done.result()))
        return future

    monkeypatch.setattr(client, "submit", noted)
    store = {"store": tmp_path / "s"} if stored else {}
    ds = rw.sweep(swing(0.02), VARY, batch=2, on=client, progress=False, **store)
    rw.sweep(swing(0.02), {"method": ["verlet", "rk4"], **VARY}, batch=2, on=client, progress=False)
    with rw.sweep.function(swing(0.02), [EA], "tension.max", on=client) as function:
        function([[1000.0], [2000.0]])
    assert len(sent) > 10
    assert all(plain(args) for args in sent)
    assert back
    assert all(plain(outcome) for outcome in back)
    assert not plain({"a": np.zeros(2)})
    assert not plain([Path()])
    mine = rw.sweep(swing(0.02), VARY, on="here")
    assert same(mine.tension_max.values, ds.tension_max.values)


def test_values_come_as_they_were_sent() -> None:
    rows = [[1.0, 3, "verlet", -0.0], [float("inf"), -(2**60), "[0, 0, 1]", 1e-300]]
    assert repr(unpacked_rows(packed_rows(rows))) == repr(rows)


class OddError(Exception):
    """An error that nobody can read back from its pickle."""

    def __init__(self, one: int, two: int) -> None:
        super().__init__(f"odd {one} {two}")

    def __reduce__(self) -> Any:
        raise TypeError("cannot be pickled")


@pytest.mark.parametrize("error", [OddError(1, 2), MemoryError("too much")])
def test_any_error_of_a_worker_is_told_in_words(
    client: Any, tmp_path: Path, monkeypatch: pytest.MonkeyPatch, error: Exception
) -> None:
    def broken(*_: Any) -> Any:
        raise error

    rw.sweep(swing(0.02), VARY, batch=2, on="here", store=tmp_path / "s")
    for mark in (tmp_path / "s" / "data.zarr" / "done" / "marks").glob("c*"):
        mark.unlink()
    monkeypatch.setattr(worker.Batcher, "make", broken)
    with pytest.raises(RunError, match=f"worker: cannot make batch .*{type(error).__name__}"):
        rw.sweep.resume(tmp_path / "s", on=client, progress=False)


def test_a_cluster_of_its_own_listens_to_this_machine_only() -> None:
    from ropewalk.sweeps.engines import client_of

    told: list[str] = []
    with client_of("local", 1, told.append) as own:
        about = own.scheduler_info(n_workers=-1)
        addresses = [about["address"], *about["workers"]]
        assert all("//127.0.0.1:" in address for address in addresses)
        assert "127.0.0.1" in own.dashboard_link
    assert "dashboard: http://127.0.0.1" in told[0]
    assert rw.sweep.dashboard is not None
    assert told[0].endswith(rw.sweep.dashboard)


def test_the_dashboard_is_told_once_where_no_terminal_is(
    client: Any, capsys: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch
) -> None:
    about = client.scheduler_info(n_workers=0) | {"services": {"dashboard": 8787}}
    real = client.scheduler_info
    monkeypatch.setattr(
        client, "scheduler_info", lambda n_workers: about if not n_workers else real()
    )
    monkeypatch.setattr("ropewalk.sweeps.engines._may_be_there", lambda link: True)
    rw.sweep(swing(0.02), VARY, batch=2, on=client)
    told = capsys.readouterr().err
    assert told.count("dashboard: http://") == 1
    assert str(rw.sweep.dashboard) in told
    rw.sweep(swing(0.02), VARY, batch=2, on=client, progress=False)
    assert capsys.readouterr().err == ""


APART = """
[[rope]]
name = "{name}"
segments = 4
length = 2.0
[rope.made_of]
kind = "material"
EA = 2000.0
mass_per_length = 0.1
[rope.shape]
kind = "straight"
start = [0.0, {y}, 0.0]
end = [2.0, {y}, 0.0]
"""


def test_workers_take_no_threads_beside_their_own(
    client: Any, monkeypatch: pytest.MonkeyPatch
) -> None:
    """There is a worker for every processor already; alone, islands are moved side by side."""
    settings = '[run]\nduration = 0.04\nmethod = "sdirk2"\ntime_step = 0.01\n'
    ropes = "".join(APART.format(name=name, y=float(y)) for y, name in enumerate("ab"))
    scene = rw.loads(settings + ropes)
    used: list[str] = []
    beside = islands.Islands._go_beside

    def noted(*args: Any) -> Any:
        used.append("threads")
        return beside(*args)

    monkeypatch.setattr(islands, "threads", 2)
    monkeypatch.setattr(islands, "LONG", -1.0)
    monkeypatch.setattr(islands.Islands, "_go_beside", noted)
    ask = {"samples": 4, "design": "random", "seed": 1, "keep": "positions[-1]", "progress": False}
    here = rw.sweep(scene, {"gravity[2]": (-9.9, -9.7)}, on="here", **ask)
    assert used
    rows = packed_rows([[float(value)] for value in here.gravity_2.values])
    function = rw.sweep.function(scene, ["gravity[2]"], "positions[-1]")
    job = {"recipe": json.dumps(function.recipe.plain()), "source": function.recipe.source}
    used.clear()
    made = client.submit(worker.make_batch, job | {"folder": "", "id": ""}, 0, rows).result()
    assert used == []
    there = worker.unpacked(made["batch"]).kept["positions_last"]
    assert same(there, here.positions_last.values)


def test_kernels_are_compiled_before_any_worker_makes_a_batch(
    client: Any, monkeypatch: pytest.MonkeyPatch
) -> None:
    """Once in this process, which then starts the workers, and once on every other machine."""
    done: list[str] = []
    make, client_of, submit = worker.Batcher.make, engines.client_of, client.submit

    def making(self: Any, rows: Any) -> Any:
        done.append("run")
        return make(self, rows)

    def starting(*args: Any) -> Any:
        done.append("workers")
        return client_of(*args)

    def giving(function: Any, *args: Any, **options: Any) -> Any:
        place = f" at {options['workers'][0]}" if "workers" in options else ""
        done.append(function.__name__ + place)
        future = submit(function, *args, **{k: v for k, v in options.items() if k != "workers"})
        result = future.result
        future.result = lambda *a: (done.append(f"{function.__name__} done"), result(*a))[1]
        return future

    hosts = {"tcp://a:1": "a", "tcp://a:2": "a", "tcp://b:1": "b", "tcp://b:2": "b"}
    about = {"workers": {address: {"host": host} for address, host in hosts.items()}}
    monkeypatch.setattr(worker.Batcher, "make", making)
    monkeypatch.setattr(engines, "client_of", starting)
    monkeypatch.setattr(client, "submit", giving)
    monkeypatch.setattr(client, "scheduler_info", lambda **_: about)
    rw.sweep(swing(0.02), VARY, batch=2, on=client, progress=False)
    told = [what for what in done if what != "run"]
    assert done[0] == "run"  # compiles here, before there are workers
    assert told[0] == "workers"
    assert told[1:5] == [
        *("warm_up at tcp://a:2", "warm_up at tcp://b:2"), *["warm_up done"] * 2
    ]  # fmt: skip
    assert told[5] == "make_batch"
    assert not any(what.startswith("warm_up") for what in told[5:])
    seen: list[Any] = []
    monkeypatch.setattr(worker.Batcher, "compile", lambda self, row: seen.append(row[0]))
    methods = {"method": ["verlet", "rk4"], **VARY}
    rw.sweep(swing(0.02), methods, batch=2, on=client, progress=False)
    assert set(seen) == {"verlet", "rk4"}


COUNTED = """
import os, sys, threading
import ropewalk as rw
from distributed import Client, LocalCluster

def compiled():
    import gc
    from numba.core.dispatcher import Dispatcher
    found = [one for one in gc.get_objects() if isinstance(one, Dispatcher)]
    mine = [one for one in found if one.py_func.__module__.startswith("ropewalk")]
    return [sum(sum(getattr(one.stats, kind).values()) for one in mine)
            for kind in ("cache_misses", "cache_hits")]

if __name__ == "__main__":
    scene = rw.load(sys.argv[1])
    with LocalCluster(n_workers=2, threads_per_worker=1, dashboard_address=None) as cluster:
        with Client(cluster) as client:
            rw.sweep(scene, {"rope.made_of.EA": [1e3, 2e3, 3e3, 4e3, 5e3, 6e3]}, batch=1, on=client)
            print(compiled(), *client.run(compiled).values(), sep="\\n")
"""


@pytest.mark.slow
def test_no_worker_compiles_what_this_process_has_compiled(tmp_path: Path) -> None:
    """With an empty cache: the kernels are compiled once, and every worker finds them."""
    (tmp_path / "scene.toml").write_text(SCENE.format(duration=0.02))
    (tmp_path / "script.py").write_text(COUNTED.replace("\\\\", "\\"))
    environ = os.environ | {"ROPEWALK_CACHE_DIR": str(tmp_path / "cache")}
    environ["PYTHONPATH"] = str(Path(rw.__file__).parents[1])
    words = [sys.executable, str(tmp_path / "script.py"), str(tmp_path / "scene.toml")]
    told = subprocess.run(words, env=environ, check=True, capture_output=True, text=True).stdout
    mine, *others = [json.loads(line) for line in told.splitlines() if line.startswith("[")]
    assert mine[0] > 0
    assert len(others) == 2
    assert all(misses == 0 and hits > 0 for misses, hits in others), told


def test_without_dask_runs_are_made_here_and_it_is_told_once(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    vary = {EA: [1000.0, 1500.0, 2000.0, 2500.0]}
    here = rw.sweep(swing(0.02), vary, batch=1, keep="tension.max", on="here")
    monkeypatch.setattr(engines, "has_dask", lambda: False)
    monkeypatch.setattr(engines, "WORTH_A_CLUSTER", 0.0)
    monkeypatch.setattr("ropewalk.sweeps.many._told_of_extra", False)
    with warnings.catch_warnings(record=True) as told:
        warnings.simplefilter("always")
        for name in ("a", "b"):
            made = rw.sweep(swing(0.02), vary, batch=1, keep="tension.max", store=tmp_path / name)
            assert same(made.tension_max.values, here.tension_max.values)
    words = [str(one.message) for one in told if issubclass(one.category, UserWarning)]
    assert [word[:34] for word in words] == ["this sweep runs in one process; wi"]


def test_runs_that_are_made_outlive_a_cluster_that_is_slow_to_close(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    from distributed import LocalCluster

    close = LocalCluster.close
    late: list[bool] = []

    def closing(cluster: Any, timeout: float | None = None) -> None:
        close(cluster, timeout=timeout)
        if not late:
            late.append(True)
            raise TimeoutError(f"timed out after {timeout} s.")

    monkeypatch.setattr(LocalCluster, "close", closing)
    made = rw.sweep(swing(0.02), {EA: STIFF[:2]}, keep="tension.max", on="local", batch=1)
    assert late
    assert np.isfinite(made.tension_max.values).all()


def test_without_dask_nothing_runs_elsewhere_unsaid(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """`resume` ran here all the same; a function and a fit ended in the import of a missing module."""
    make(tmp_path / "s")
    SweepFolder.open(tmp_path / "s").unmark([3])
    monkeypatch.setattr(engines, "has_dask", lambda: False)
    told = "needs Dask, which is not installed"
    with pytest.raises(InputError, match=told):
        rw.sweep.resume(tmp_path / "s", on="tcp://127.0.0.1:1")
    for on in ("local", None):
        with pytest.raises(InputError, match=told):
            rw.sweep.function(swing(0.02), [EA], "tension.max", on=on)
    measured = rw.calibrate.kept("tension.max", 1.0, 0.1)
    with pytest.raises(InputError, match=told):
        rw.calibrate(swing(0.02), measured, {EA: (1e3, 2e3)}, on="local")
    assert SweepFolder.open(tmp_path / "s").marked(3) is None
    with pytest.raises(InputError, match="workers: 0 - must be a whole number of processes"):
        rw.sweep.resume(tmp_path / "s", workers=0, on="here")
    with pytest.raises(InputError, match='what: .rset. - must be "run" or "rest"'):
        rw.sweep.function(swing(0.02), [EA], "tension.max", what="rset")
