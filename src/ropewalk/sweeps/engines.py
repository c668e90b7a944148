"""Who makes the batches of a sweep: this process, or workers through Dask."""

from __future__ import annotations

import os
import sys
import uuid
import warnings
from collections.abc import Callable, Iterator
from contextlib import contextmanager, suppress
from importlib.util import find_spec
from pathlib import Path
from typing import Any, Protocol

from ropewalk.record.errors import InputError, RunError
from ropewalk.sweeps.batch import Batch
from ropewalk.sweeps.parameters import TEXT
from ropewalk.sweeps.sweep_plan import SweepPlan
from ropewalk.sweeps.worker import (
    CARRIED,
    REFUSED,
    batcher_of,
    job_of,
    make_batch,
    packed_rows,
    unpacked,
    warm_up,
)

#: Less work than this is done here: a cluster of this machine's cores takes seconds to start [s].
WORTH_A_CLUSTER = 10.0
#: Times a batch is given to another worker after one died with it.
_TRIES = 4
_CLOSING = 30.0  # time that workers have to end [s]
_MOST_TRIED = 64  # batches that are looked through, and runs whose kernels are compiled beforehand
_AHEAD = 3  # batches in hand per worker's thread
#: Messages that Dask keeps for its own diagnosis, with the values of a batch each; by default 1000.
_LOGGED = {"distributed.admin.low-level-log-length": 50}

#: Address of the dashboard of the cluster that was used last; None: there is none.
dashboard: str | None = None

Told = Callable[[int, int], None]  # number of a batch that is done, broken runs in it


class Sink(Protocol):
    """Where batches go: a folder, or memory."""

    plan: SweepPlan

    def write(self, number: int, batch: Any) -> None:
        """Take a batch."""

    def rows(self, number: int) -> list[list[Any]]:
        """Return the values of a batch's runs."""
        ...


def has_dask() -> bool:
    """Tell whether the packages of `ropewalk[sweep]` are there."""
    return find_spec("distributed") is not None


def make_here(sink: Sink, numbers: Iterator[int], told: Told) -> None:
    """Make the batches in this process, one after another."""
    batcher = batcher_of(job_of(sink.plan, None)["recipe"])
    for number in numbers:
        batch = batcher.make(sink.rows(number))
        sink.write(number, batch)
        told(number, batch.broken)


def check_answers(on: Any) -> None:
    """See that a client is one, and that a scheduler answers at an address. Raises InputError, RunError."""
    from distributed import Client

    if isinstance(on, str) and on != "local":
        with client_of(on, None, lambda _: None):
            return
    if not isinstance(on, Client) and on != "local":
        rule = 'must be a Dask client, the address of a scheduler, "local" or "here"'
        raise InputError("on", on, rule)


@contextmanager
def client_of(on: Any, workers: int | None, say: Callable[[str], None]) -> Iterator[Any]:
    """Give a Dask client: the one given, one of an address, or one of a cluster of this machine.

    What was started here is shut down. Raises InputError, RunError.
    """
    import dask
    from distributed import Client

    if isinstance(on, Client):
        say(_dashboard(on))
        yield on
        return
    if isinstance(on, str) and on != "local":
        try:
            with dask.config.set(_LOGGED):
                client = Client(on, timeout="10s", set_as_default=False)
        except (OSError, ValueError, TypeError) as error:
            raise RunError(on, f"no Dask scheduler answers there: {error}") from None
        with client:
            say(_dashboard(client))
            yield client
        return
    if on not in (None, "local"):
        rule = 'must be a Dask client, the address of a scheduler, "local" or "here"'
        raise InputError("on", on, rule)
    with (
        _local_cluster(workers) as cluster,
        dask.config.set(_LOGGED),
        Client(cluster, set_as_default=False) as client,
    ):
        say(f"{len(cluster.workers)} workers; {_dashboard(client)}")
        yield client


def _dashboard(client: Any) -> str:
    """Say where a cluster can be looked at, and keep it."""
    global dashboard
    has = "dashboard" in client.scheduler_info(n_workers=0).get("services", {})
    link = str(client.dashboard_link) if has else None
    dashboard = link if link and _may_be_there(link) else None
    return f"dashboard: {dashboard or 'none'}"


def _may_be_there(link: str) -> bool:
    """Whether a page is there, or may be: a scheduler without one answers, too, that there is none.

    What cannot be reached from here may be by other ways, such as a tunnel.
    """
    from urllib.error import HTTPError
    from urllib.request import ProxyHandler, Request, build_opener

    try:
        build_opener(ProxyHandler({})).open(Request(link, method="HEAD"), timeout=1.0).close()
    except HTTPError as error:
        return error.code != 404
    except (OSError, ValueError):
        pass
    return True


@contextmanager
def _local_cluster(workers: int | None) -> Iterator[Any]:
    """A cluster of this machine's cores that nobody else can reach; ends with the block."""
    import dask
    from distributed import LocalCluster

    settings = {
        "distributed.scheduler.allowed-failures": _TRIES,
        "distributed.worker.daemon": True,
        **_LOGGED,
    }
    with dask.config.set(settings), _without_main(), warnings.catch_warnings():
        warnings.simplefilter("ignore")  # of a port that is taken
        cluster = LocalCluster(
            n_workers=workers or os.cpu_count() or 1,
            threads_per_worker=1,
            host="127.0.0.1",
            dashboard_address="127.0.0.1:0",
            silence_logs=50,
        )
        try:
            yield cluster
        finally:
            with suppress(TimeoutError):  # the runs are made; late workers end with this process
                cluster.close(timeout=_CLOSING)


@contextmanager
def _without_main() -> Iterator[None]:
    """Keep workers from importing the program that called: they need nothing of it.

    A script without `if __name__ == "__main__"` would else begin again in each of them.
    """
    main = sys.modules["__main__"]
    kept = {name: getattr(main, name) for name in ("__file__", "__spec__") if hasattr(main, name)}
    with suppress(AttributeError):
        del main.__file__
    main.__spec__ = None
    try:
        yield
    finally:
        for name, value in kept.items():
            setattr(main, name, value)


def make_with(
    client: Any, sink: Sink, folder: Path | None, numbers: Iterator[int], told: Told
) -> None:
    """Have a cluster make the batches; what is done is let go of at once.

    Raises RunError when the scheduler is lost, a worker cannot do what it should, or batch after batch
    takes its worker with it.
    """
    job = job_of(sink.plan, folder)
    _warm_up(client, sink, job)
    hand = _Hand(client, sink, job, numbers)
    try:
        hand.fill()
        for future in hand.coming:
            number, outcome = hand.take(future)
            if outcome is not None:
                _keep(sink, outcome)
                told(number, outcome["broken"] or 0)
            hand.fill()
    finally:
        hand.drop()


def _keep(sink: Sink, outcome: dict[str, Any]) -> None:
    """Store what a worker carried here. Raises RunError for one that refused."""
    if outcome["what"] == REFUSED:
        raise RunError(_who(outcome), f"cannot make batch {outcome['number']}: {outcome['why']}")
    if outcome["what"] == CARRIED:
        sink.write(outcome["number"], unpacked(outcome["batch"]))


def _who(outcome: dict[str, Any]) -> str:
    """Return the worker that an outcome is of, with its address where it is known."""
    return f"worker {outcome.get('who', '')}".rstrip()


def _warm_up(client: Any, sink: Sink, job: dict[str, Any]) -> None:
    """Have the kernels compiled once per machine before all its workers need them."""
    workers = client.scheduler_info(n_workers=-1)["workers"]
    first = {about["host"]: address for address, about in workers.items()}
    if not workers:
        client.wait_for_workers(1, timeout=120)
        return
    rows = packed_rows(_of_every_text(sink))
    calls = [
        client.submit(warm_up, job["recipe"], rows, workers=[address], pure=False)
        for address in first.values()
    ]
    for call in calls:
        with suppress(Exception):  # what is wrong shows with the first batch
            call.result()
        call.release()


def _of_every_text(sink: Sink) -> list[list[Any]]:
    """Return a run for every text that is varied, such as the method: it may call other kernels."""
    plan = sink.plan
    texts = [place for place, kind in enumerate(plan.recipe.kinds) if kind == TEXT]
    found: dict[tuple[Any, ...], list[Any]] = {}
    step = max(1, plan.batches // _MOST_TRIED) if texts else plan.batches
    for number in range(0, plan.batches, step):
        for row in sink.rows(number)[: None if texts else 1]:
            found.setdefault(tuple(row[place] for place in texts), row)
    return list(found.values())[:_MOST_TRIED]


class _Hand:
    """The batches that a cluster has in hand: a few per worker, so that the client stays small."""

    def __init__(
        self, client: Any, sink: Sink, job: dict[str, Any], numbers: Iterator[int]
    ) -> None:
        from distributed import as_completed

        self._client, self._sink, self._job, self._numbers = client, sink, job, numbers
        self._tries: dict[int, int] = {}
        self._given: dict[str, tuple[int, Any]] = {}
        self._threads = 1
        self.coming = as_completed(loop=client.loop)

    def fill(self) -> None:
        """Give batches until every worker has a few."""
        if not self._given:
            self._threads = max(1, sum(self._client.nthreads().values()))
        while len(self._given) < _AHEAD * self._threads:
            number = next(self._numbers, None)
            if number is None:
                return
            self._give(number)

    def _give(self, number: int) -> None:
        key = f"ropewalk-{self._job['id'][:8]}-{number}-{uuid.uuid4().hex[:8]}"
        rows = packed_rows(self._sink.rows(number))
        future = self._client.submit(make_batch, self._job, number, rows, key=key, pure=False)
        self._given[future.key] = number, future
        self.coming.add(future)

    def take(self, future: Any) -> tuple[int, dict[str, Any] | None]:
        """Return a batch's number and outcome, None when its worker died; then it is given again."""
        from distributed.client import FutureCancelledError
        from distributed.scheduler import KilledWorker

        number, _ = self._given.pop(future.key)
        try:
            outcome: dict[str, Any] = future.result()
        except KilledWorker:
            self._tries[number] = self._tries.get(number, 0) + 1
            if self._tries[number] >= _TRIES:
                rule = "takes its worker with it again and again; is there enough memory for a run?"
                raise RunError(f"batch {number}", rule) from None
            self._give(number)
            return number, None
        except (FutureCancelledError, OSError) as error:
            rule = f"lost: {error or type(error).__name__}; what is stored is kept"
            raise RunError("scheduler", rule) from None
        except Exception as error:  # before `make_batch`: no ropewalk there, or another one
            rule = f"cannot make batch {number}: {type(error).__name__}: {error}"
            raise RunError("worker", rule) from None
        finally:
            future.release()  # or the death of its worker would have it made again
        return number, outcome

    def drop(self) -> None:
        """Let go of what is not done."""
        with suppress(Exception):
            self._client.cancel([future for _, future in self._given.values()], force=True)
        for _, future in self._given.values():
            with suppress(Exception):
                future.release()


def map_rows(client: Any, recipe: str, source: str, rows: list[list[Any]]) -> Batch:
    """Have a cluster make some runs, a part of them per worker, and return them in order."""
    threads = max(1, sum(client.nthreads().values()))
    job = {"recipe": recipe, "source": source, "folder": "", "id": ""}
    size = max(1, -(-len(rows) // (2 * threads)))
    parts = [rows[start : start + size] for start in range(0, len(rows), size)]
    futures = [
        client.submit(make_batch, job, i, packed_rows(part), pure=False)
        for i, part in enumerate(parts)
    ]
    made = Batch()
    for outcome in client.gather(futures):
        if outcome["what"] == REFUSED:
            raise RunError(_who(outcome), f"cannot make runs: {outcome['why']}")
        made.append(unpacked(outcome["batch"]))
    return made
