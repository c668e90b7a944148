"""What goes to workers and comes back, and what their errors become."""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path
from typing import Any

import numpy as np
import pytest

import ropewalk as rw
from ropewalk.record.errors import RunError
from ropewalk.sweeps import worker
from ropewalk.sweeps.worker import packed_rows, unpacked_rows
from sweeps.scenes import EA, STIFF, same, swing

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
    for mark in (tmp_path / "s" / "data.zarr" / "done").glob("c*"):
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
