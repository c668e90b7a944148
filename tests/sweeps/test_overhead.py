"""What a sweep costs besides its runs, counted: calls of Python functions, and memory by the run.

Both are the same at every turn and on any machine. Times are those of `python -m bench many`.
"""

from __future__ import annotations

import gc
import os
import sys
import tracemalloc
from collections.abc import Callable
from pathlib import Path
from typing import Any

import numpy as np
import pytest

import ropewalk as rw
from ropewalk.sweeps.batch import Batch, Batcher
from sweeps.scenes import EA, swing

KEEP = "positions[-1]"


def calls(work: Callable[[], Any]) -> int:
    """Number of functions that are called, those written in C among them."""
    found = 0

    def count(_frame: Any, event: str, _arg: Any) -> None:
        nonlocal found
        found += event in ("call", "c_call")

    sys.setprofile(count)
    try:
        work()
    finally:
        sys.setprofile(None)
    return found


def of_a_run(make: Callable[[int], Any]) -> float:
    """Calls that one more run takes."""
    make(20), make(20)
    return (calls(lambda: make(120)) - calls(lambda: make(20))) / 100


@pytest.mark.skipif(sys.gettrace() is not None, reason="a tracer calls, too")
def test_a_run_of_a_sweep_takes_no_more_than_a_run_of_its_own() -> None:
    """Building included, which a loop of `simulate` does as well; the scenes of the loop are there."""
    scene = swing(0.04)
    values = np.linspace(1000.0, 2000.0, 120)
    scenes = [scene.replace(**{EA: value}) for value in values.tolist()]

    def sweep(count: int, **ask: Any) -> None:
        rw.sweep(scene, keep=KEEP, progress=False, on="here", batch=20, **ask)

    alone = of_a_run(lambda n: [rw.simulate(one).positions[-1] for one in scenes[:n]])
    drawn = of_a_run(lambda n: sweep(n, vary={EA: (1e3, 2e3)}, samples=n, design="random", seed=1))
    listed = of_a_run(lambda n: sweep(n, vary={EA: values[:n]}))
    assert drawn <= 1.05 * alone
    assert listed <= 1.15 * alone  # every value of a list is checked before anything runs


def peak(work: Callable[[], Any]) -> int:
    """The most memory that Python takes meanwhile, beyond what it has [bytes]."""
    gc.collect()
    tracemalloc.start()
    try:
        work()
        return tracemalloc.get_traced_memory()[1]
    finally:
        tracemalloc.stop()


def test_more_runs_take_no_more_of_the_client(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """The runs themselves are left out: what is looked at is what is kept of each here."""

    def make(self: Batcher, rows: list[list[Any]]) -> Batch:
        count = len(rows)
        kept = {"tension_max": np.ones(count)}
        return Batch(["finished"] * count, [""] * count, [np.nan] * count, kept)

    monkeypatch.setattr(Batcher, "make", make)

    def sweep(runs: int) -> None:
        ask = {
            "samples": runs,
            "design": "random",
            "seed": 1,
            "keep": "tension.max",
            "batch": 16384,
        }
        store = tmp_path / f"s{runs}"
        ds = rw.sweep(swing(0.02), {EA: (1e3, 2e3)}, store=store, on="here", progress=False, **ask)
        assert ds.sizes["run"] == runs
        assert ds.run[-1] == runs - 1

    few, many = 2 * 65536, 600_000
    sweep(few)
    first, second = peak(lambda: sweep(few + 1)), peak(lambda: sweep(many))
    assert second - first < 1.0 * (many - few)  # less than a byte a run; a number has eight


@pytest.mark.slow
@pytest.mark.skipif(not Path("/proc/self/status").exists(), reason="reads its memory from /proc")
def test_a_client_of_workers_takes_for_a_million_runs_what_it_takes_for_ten_thousand(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    """All is real but the simulations: values, batches, tasks, workers, files and the answer."""
    from bench.many import WITHOUT_SIMULATION, peak_of_client

    root = Path(__file__).resolve().parents[2]
    monkeypatch.setenv("PYTHONPATH", f"{root / 'src'}{os.pathsep}{root}")
    few, many = (peak_of_client(runs, "without simulation") for runs in WITHOUT_SIMULATION)
    assert WITHOUT_SIMULATION == (10_000, 1_000_000)
    assert many < 1.1 * few  # 8 bytes a run would be 2 percent, a text of each 15
