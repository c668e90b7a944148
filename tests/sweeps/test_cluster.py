"""A real scheduler and two workers, each a process of its own, on this machine; one is killed."""

from __future__ import annotations

import json
import os
import shutil
import subprocess
import sys
import time
from collections import Counter
from collections.abc import Iterator
from contextlib import suppress
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from distributed import Client

import ropewalk as rw
from ropewalk.record.errors import RunError
from ropewalk.sweeps.sweep_folder import SweepFolder
from sweeps.scenes import EA, STIFF, same, store_bytes, swing

ROOT = Path(__file__).resolve().parents[2]
#: Notes every batch that a worker makes, and makes it last long enough to be killed in. No worker
#: goes on before each has made one, or a quick one could make all while the other still starts.
PRELOAD = """
import os, time
from ropewalk.sweeps.batch import Batcher
Batcher.real = getattr(Batcher, "real", Batcher.make)  # Dask may load this twice
def make(self, rows):
    made = self.real(rows)
    time.sleep(0.05)
    if len(rows) > 1:
        with open(os.environ["MADE"], "a") as file:
            file.write(f"{os.getpid()} {rows[0]}\\n")
        for _ in range(6000):
            if len({line.split()[0] for line in open(os.environ["MADE"])}) == 2:
                break
            time.sleep(0.01)
    return made
Batcher.make = make
"""
VARY = {EA: STIFF, "rope.length": np.linspace(1.9, 2.1, 24).tolist()}


class Cluster:
    """A scheduler and workers as processes."""

    def __init__(self, folder: Path, *more: object) -> None:
        self.made = folder / "made.txt"
        self.made.touch()
        (folder / "preload.py").write_text(PRELOAD)
        self._folder = folder
        self._environ = os.environ | {
            "PYTHONPATH": str(ROOT / "src"),
            "MADE": str(self.made),
            "DASK_DISTRIBUTED__SCHEDULER__ALLOWED_FAILURES": "5",
        }
        file = folder / "scheduler.json"
        self.scheduler = self._start(
            "scheduler", "--host", "127.0.0.1", "--port", "0", "--no-dashboard",
            "--scheduler-file", file, *more,
        )  # fmt: skip
        self.address = ""
        while not self.address:
            assert self.scheduler.poll() is None
            time.sleep(0.05)
            with suppress(FileNotFoundError, json.JSONDecodeError):  # not there yet, or half of it
                self.address = json.loads(file.read_text())["address"]
        self.workers = [
            self._start(
                "worker", self.address, "--nthreads", "1", "--no-nanny", "--no-dashboard",
                "--host", "127.0.0.1", "--preload", folder / "preload.py",
                "--local-directory", folder / f"scratch{i}", *more,
            )
            for i in range(2)
        ]  # fmt: skip

    def _start(self, *words: object) -> subprocess.Popen[bytes]:
        command = [sys.executable, "-m", "dask", *map(str, words)]
        with (self._folder / f"{words[0]}.log").open("ab") as log:
            return subprocess.Popen(command, env=self._environ, stdout=log, stderr=log)

    def end(self) -> None:
        """Kill what is left."""
        for process in (*self.workers, self.scheduler):
            process.kill()
            process.wait()


@pytest.fixture
def cluster(tmp_path: Path) -> Iterator[Cluster]:
    """A scheduler and two workers."""
    made = Cluster(tmp_path)
    try:
        yield made
    finally:
        made.end()


@pytest.fixture(scope="module")
def here(tmp_path_factory: pytest.TempPathFactory) -> dict[str, bytes]:
    """The store of the same sweep made in this process."""
    folder = tmp_path_factory.mktemp("here") / "s"
    rw.sweep(swing(0.04), VARY, store=folder, batch=2, on="here")
    return store_bytes(folder)


def once(process: subprocess.Popen[bytes], after: int) -> Any:
    """A progress function that kills a process as soon as so many runs are done."""

    def told(standing: Any) -> None:
        if standing.done >= after and process.poll() is None:
            process.kill()

    return told


@pytest.mark.slow
def test_a_worker_is_killed(tmp_path: Path, cluster: Cluster, here: dict[str, bytes]) -> None:
    folder = tmp_path / "s"
    finished: set[int] = set()
    kill = once(cluster.workers[0], 20)
    with Client(
        cluster.address
    ) as client:  # else one may have done it all before the other is there
        client.wait_for_workers(2)

    def told(standing: Any) -> None:
        if standing.done >= 20 and not finished:
            finished.update(SweepFolder.open(folder).standing()[0])
        kill(standing)

    ds = rw.sweep(swing(0.04), VARY, store=folder, batch=2, on=cluster.address, progress=told)
    assert store_bytes(folder) == here
    assert (ds.status != "").all()
    made = Counter(line.partition(" ")[2] for line in cluster.made.read_text().splitlines())
    assert len(made) == 35  # and the first one, here
    # A batch may be made again that its worker had not yet marked; a finished one never.
    assert sum(made.values()) <= len(made) + 1
    rows = [str(SweepFolder.open(folder).row(2 * number)) for number in finished - {0}]
    assert len(rows) >= 8
    assert [made[row] for row in rows] == [1] * len(rows)
    assert len({line.split()[0] for line in cluster.made.read_text().splitlines()}) == 2


@pytest.mark.slow
def test_the_scheduler_is_killed(tmp_path: Path, cluster: Cluster, here: dict[str, bytes]) -> None:
    folder = tmp_path / "s"
    kill = once(cluster.scheduler, 20)
    with pytest.raises(RunError, match="scheduler: lost"):
        rw.sweep(swing(0.04), VARY, store=folder, batch=2, on=cluster.address, progress=kill)
    begun = rw.sweep.open(folder)
    assert 0 < (begun.status == "finished").sum() < 48
    rw.sweep.resume(folder, on="here")
    assert store_bytes(folder) == here


@pytest.mark.slow
def test_what_a_dead_worker_carried_here_is_not_made_again(cluster: Cluster) -> None:
    kill = once(cluster.workers[0], 20)
    ds = rw.sweep(swing(0.04), VARY, batch=2, on=cluster.address, progress=kill)
    assert (ds.status != "").all()
    made = Counter(line.partition(" ")[2] for line in cluster.made.read_text().splitlines())
    assert len(made) == 35
    # The batch in its hands, and one whose result may have been on its way.
    assert sum(made.values()) <= len(made) + 2


@pytest.mark.slow
@pytest.mark.skipif(not shutil.which("openssl"), reason="needs openssl to make a certificate")
def test_a_cluster_over_tls(tmp_path: Path, here: dict[str, bytes]) -> None:
    import dask
    import distributed  # brings its settings

    assert distributed

    key, certificate = tmp_path / "key.pem", tmp_path / "certificate.pem"
    subprocess.run(
        ["openssl", "req", "-x509", "-newkey", "rsa:2048", "-nodes", "-days", "2", "-subj", "/CN=x",
         "-keyout", key, "-out", certificate],
        check=True, capture_output=True,
    )  # fmt: skip
    words = ("--tls-ca-file", certificate, "--tls-cert", certificate, "--tls-key", key)
    made = Cluster(tmp_path, *words, "--protocol", "tls")
    settings = {
        "distributed.comm.tls.ca-file": str(certificate),
        "distributed.comm.tls.client.cert": str(certificate),
        "distributed.comm.tls.client.key": str(key),
        "distributed.comm.require-encryption": True,
    }
    try:
        assert made.address.startswith("tls://127.0.0.1")
        with dask.config.set(settings):
            rw.sweep(swing(0.04), VARY, store=tmp_path / "s", batch=2, on=made.address)
        assert store_bytes(tmp_path / "s") == here
        with pytest.raises(RunError, match="no Dask scheduler answers there"):
            rw.sweep(swing(0.04), VARY, batch=2, on=made.address)  # without the certificate
        plain = made.address.replace("tls://", "tcp://")
        with pytest.raises(RunError, match="no Dask scheduler answers there"):
            rw.sweep(swing(0.04), VARY, batch=2, on=plain)
    finally:
        made.end()


@pytest.mark.slow
def test_workers_carry_what_they_cannot_store(cluster: Cluster, here: dict[str, bytes]) -> None:
    there = rw.sweep(swing(0.04), VARY, batch=2, on=cluster.address)
    mine = rw.sweep(swing(0.04), VARY, batch=5, on="here")
    for name in mine.variables:
        assert same(np.asarray(mine[name].values), np.asarray(there[name].values))
    with rw.sweep.function(swing(0.04), [EA], "tension.max", on=cluster.address) as f:
        found = f(np.array(STIFF)[:, None])
    own = rw.sweep.function(swing(0.04), [EA], "tension.max")(np.array(STIFF)[:, None])
    np.testing.assert_array_equal(found, own)


def test_nobody_at_an_address_is_told(tmp_path: Path) -> None:
    with pytest.raises(RunError, match="no Dask scheduler answers there"):
        rw.sweep(swing(0.04), VARY, batch=2, on="tcp://127.0.0.1:9", store=tmp_path / "s")
    with pytest.raises(ValueError, match='"local" or "here"'):
        rw.sweep(swing(0.04), VARY, batch=2, on=3.5)
