"""Many ropes at once: a sweep, a plain process pool of `simulate`, whole-array numpy, and MuJoCo's rollout.

All run the same springs from the same places with the same steps, each rope with another spring constant, and
are compared in what they give. MuJoCo is the extra `ropewalk[bench]`; without it its rows are left out.
"""

from __future__ import annotations

import os
import subprocess
import sys
import time
from collections.abc import Callable
from concurrent.futures import ProcessPoolExecutor
from importlib.util import find_spec
from itertools import pairwise
from pathlib import Path
from statistics import median
from tempfile import TemporaryDirectory
from typing import Any

import numpy as np

import ropewalk as rw
from bench.row import Row
from ropewalk import Anchor, Rope, RunSettings, Scene, Springs
from ropewalk.lowering import build
from ropewalk.record.simulate import simulate_in_memory

RUNS, SEGMENTS, DT, STEPS = 1024, 20, 1e-3, 1000
MASS, FRICTION, LENGTH, GRAVITY = 0.05, 0.05, 0.1, 9.81
PATH = "rope.made_of.spring_constant"
ROUNDS = 5

FEW_AND_MANY = (2000, 20_000)
#: Runs of which only the simulation is left out: their values, batches, tasks, files and answer are real.
WITHOUT_SIMULATION = (10_000, 1_000_000)
BATCH = 1000
#: A client of its own, which says the most memory it had [MB].
CLIENT = """
import sys, tempfile
from pathlib import Path
import ropewalk as rw
import dask
import distributed  # brings its settings
from bench.many import BATCH, PATH, STUB, scene

if __name__ == "__main__":
    runs, bare = int(sys.argv[1]), sys.argv[2] == "without simulation"
    if bare:
        exec(STUB)
    short = scene().replace(**{"run.duration": 0.02, "run.frame_rate": 50.0})
    ask = {"samples": runs, "design": "random", "seed": 1, "batch": BATCH if bare else None}
    ask |= {"on": "local", "workers": 2, "progress": False}
    dask.config.set({"distributed.worker.preload": [STUB] if bare else []})
    with tempfile.TemporaryDirectory() as folder:
        ds = rw.sweep(short, {PATH: (800.0, 1200.0)}, store=folder + "/s", **ask)
        assert ds.sizes["run"] == runs
        assert ds.status[[0, -1]].values.tolist() == ["finished"] * 2
    told = Path("/proc/self/status").read_text()  # not `getrusage`: it has the parent's peak
    print(int(told.partition("VmHWM:")[2].split()[0]) * 1.024e-3)
"""
#: Puts numbers in place of simulations.
STUB = """
import numpy as np
from ropewalk.sweeps.batch import Batch, Batcher

def make(self, rows):
    kept = {k.name: np.ones((len(rows), *s)) for k, s in zip(self.keep, self.recipe.sizes)}
    return Batch(["finished"] * len(rows), [""] * len(rows), [np.nan] * len(rows), kept)

Batcher.make = make
"""


def scene() -> Scene:
    """A rope of springs, level at first and held at one end; 1 s, two frames of results."""
    springs = Springs(
        spring_constant=1000.0, node_mass=MASS, spring_friction=FRICTION, segment_length=LENGTH,
        friction="axial",
    )  # fmt: skip
    settings = RunSettings(time_step=DT, frame_rate=1.0 / (DT * STEPS), duration=DT * STEPS)
    rope = Rope(segments=SEGMENTS, made_of=springs)
    return Scene(ropes=[rope], anchors=[Anchor(node=0)], run=settings)


def stiffness() -> np.ndarray:
    """The spring constants [N/m], (runs,)."""
    return np.linspace(800.0, 1200.0, RUNS)


def numpy_ropes(k: np.ndarray) -> np.ndarray:
    """Where the last nodes end (runs, 3) [m]: semi-implicit Euler on arrays of all ropes."""
    x = np.zeros((len(k), SEGMENTS + 1, 3))
    x[:, :, 0] = LENGTH * np.arange(SEGMENTS + 1)
    v, k = np.zeros_like(x), k[:, None, None]
    for _ in range(STEPS):
        d = x[:, 1:] - x[:, :-1]
        r = np.sqrt((d * d).sum(axis=2, keepdims=True))
        along = ((v[:, 1:] - v[:, :-1]) * d).sum(axis=2, keepdims=True) / r
        f = (k * (r - LENGTH) + FRICTION * along) * d / r
        total = np.zeros_like(x)
        total[:, :-1] += f
        total[:, 1:] -= f
        v[:, 1:] += DT / MASS * total[:, 1:]
        v[:, 1:, 2] -= DT * GRAVITY
        x[:, 1:] += DT * v[:, 1:]
    return np.asarray(x[:, -1])


def rollout() -> Callable[[np.ndarray], np.ndarray]:
    """The same by MuJoCo: point masses on three slides, tendons as springs, a thread per core."""
    import mujoco
    from mujoco import rollout as mj

    slides = "".join(f'<joint type="slide" axis="{axis}"/>' for axis in ("1 0 0", "0 1 0", "0 0 1"))
    bodies = "".join(
        f'<body pos="{LENGTH * i} 0 0">{slides}<inertial pos="0 0 0" mass="{MASS}" '
        f'diaginertia="1e-6 1e-6 1e-6"/><site name="s{i}"/></body>'
        for i in range(1, SEGMENTS + 1)
    )
    tendons = "".join(
        f'<spatial springlength="{LENGTH}" stiffness="1000" damping="{FRICTION}">'
        f'<site site="s{i}"/><site site="s{j}"/></spatial>'
        for i, j in pairwise(range(SEGMENTS + 1))
    )
    text = (
        f'<mujoco><option timestep="{DT}" gravity="0 0 {-GRAVITY}" integrator="Euler">'
        '<flag contact="disable" eulerdamp="disable"/></option>'
        f'<worldbody><site name="s0"/>{bodies}</worldbody><tendon>{tendons}</tendon></mujoco>'
    )
    threads = os.cpu_count() or 1

    def run(k: np.ndarray) -> np.ndarray:
        models = []
        for value in k:
            models.append(
                mujoco.MjModel.from_xml_string(text) if not models else models[0].__copy__()
            )
            models[-1].tendon_stiffness[:] = value
        data = [mujoco.MjData(models[0]) for _ in range(threads)]
        state = np.zeros(mujoco.mj_stateSize(models[0], mujoco.mjtState.mjSTATE_FULLPHYSICS))
        states, _ = mj.rollout(models, data, np.tile(state, (len(k), 1)), nstep=STEPS)
        last = states[:, -1, 1 + 3 * (SEGMENTS - 1) : 1 + 3 * SEGMENTS]
        return np.asarray(last + np.array([LENGTH * SEGMENTS, 0.0, 0.0]))

    return run


def _alone(k: float) -> np.ndarray:
    """What a user's own loop does for each run."""
    return np.array(rw.simulate(scene().replace(**{PATH: k})).positions[-1, -1])


BARE, BUILT, OWN, DISK, ALL = (
    *("loop of simulate", "loop over built models", "rw.sweep in this process"),
    *("rw.sweep in this process, on disk", "rw.sweep on all cores"),
)


def contestants(
    pool: ProcessPoolExecutor, client: object, folder: Path
) -> dict[str, Callable[[], np.ndarray]]:
    """The ways to run them all, each giving where the last nodes end (runs, 3) [m].

    The bare runs are a plain loop of `simulate` over scenes that are there already, all else left out: no
    values are put in, nothing is stored, nothing is said. The loop over built models leaves out the building,
    too, which no sweep can.
    """
    k, base = stiffness(), scene()

    def sweep(on: object, store: Path | None = None) -> np.ndarray:
        ask = {"keep": "positions[-1, -1]", "progress": False, "on": on, "store": store}
        return np.asarray(rw.sweep(base, {PATH: k}, **ask, overwrite=True).positions_last_last)

    scenes = [base.replace(**{PATH: value}) for value in k]
    models = [build(one) for one in scenes]
    found = {
        BARE: lambda: np.array([rw.simulate(one).positions[-1, -1] for one in scenes]),
        BUILT: lambda: np.array([simulate_in_memory(one).positions[-1, -1] for one in models]),
        OWN: lambda: sweep("here"),
        DISK: lambda: sweep("here", folder),
        ALL: lambda: sweep(client),
        "process pool of simulate": lambda: np.array(list(pool.map(_alone, k, chunksize=16))),
        "numpy, all ropes at once": lambda: numpy_ropes(k),
    }
    if find_spec("mujoco") is not None:
        mujoco = rollout()
        found["MuJoCo rollout"] = lambda: mujoco(k)
    return found


def many() -> list[Row]:
    """1024 ropes of 20 springs, 1000 steps each: ropes per second, and the overhead of a sweep."""
    from distributed import Client, LocalCluster

    cores = os.cpu_count() or 1
    with (
        ProcessPoolExecutor(cores) as pool,
        LocalCluster(n_workers=cores, threads_per_worker=1, dashboard_address=None) as cluster,
        Client(cluster, set_as_default=False) as client,
        TemporaryDirectory() as folder,
    ):
        ways = contestants(pool, client, Path(folder) / "sweep")
        ends = {name: way() for name, way in ways.items()}  # and compiles
        spent: dict[str, list[tuple[float, float]]] = {name: [] for name in ways}
        for _ in range(ROUNDS):
            for name, way in ways.items():
                begun, worked = time.perf_counter(), processor_time(client)
                way()
                spent[name].append((time.perf_counter() - begun, processor_time(client) - worked))
    best = {name: min(seconds for seconds, _ in turns) for name, turns in spent.items()}
    rows = [Row(f"many: {name}", RUNS / seconds, "ropes/s", "") for name, seconds in best.items()]
    bare = [work for _, work in spent[BARE]]
    rows.append(Row("many: one bare run, processor time", 1e3 * min(bare) / RUNS, "ms", ""))
    for name, target in ((OWN, "<= 1.05"), (DISK, "<= 1.05"), (ALL, "<= 1.05"), (BUILT, "")):
        ratio = median(work / alone for (_, work), alone in zip(spent[name], bare, strict=True))
        rows.append(Row(f"many: {name} / {BARE}, processor time", ratio, "1", target))
    exact = ends[BARE]
    for name, end in ends.items():
        if name not in (BARE, BUILT):
            off = float(np.abs(end - exact).max())
            rows.append(Row(f"many: end of {name} off by", off, "m", ""))
    rows += client_memory()
    _store(rows, best)
    return rows


def peak_of_client(runs: int, how: str) -> float:
    """The most memory that the client of two workers takes [MB]; `how`: "real" or "without simulation"."""
    words = [sys.executable, "-c", CLIENT, str(runs), how]
    told = subprocess.run(words, check=True, capture_output=True, text=True).stdout
    return float(told.split()[-1])


def client_memory() -> list[Row]:
    """The most memory that the client of two workers takes, for few runs and for many."""
    rows: list[Row] = []
    if not Path("/proc/self/status").exists():
        return rows
    for how, counts in (("real", FEW_AND_MANY), ("without simulation", WITHOUT_SIMULATION)):
        few, many = (peak_of_client(runs, how) for runs in counts)
        for runs, peak in zip(counts, (few, many), strict=True):
            rows.append(Row(f"many: client's peak memory, {runs} runs, {how}", peak, "MB", ""))
        more = 1e6 * (many - few) / (counts[1] - counts[0])
        rows.append(Row(f"many: client's memory for one more run, {how}", more, "B", "0"))
    return rows


def processor_time(client: Any) -> float:
    """Processor time of this process and of all workers so far [s]."""
    return time.process_time() + sum(client.run(time.process_time).values())


def _store(rows: list[Row], best: dict[str, float]) -> None:
    """Write table and figure into the folder of results."""
    import csv
    import datetime

    from matplotlib.figure import Figure

    from bench.__main__ import RESULTS, processor

    with (RESULTS / f"many-{datetime.date.today().isoformat()}.csv").open("w", newline="") as file:
        lines = [[row.case, f"{row.value:.4g}", row.unit, row.target, processor()] for row in rows]
        csv.writer(file).writerows([["case", "value", "unit", "target", "processor"], *lines])
    figure = Figure(figsize=(7.0, 3.4), layout="constrained")
    axes = figure.subplots()
    names = sorted(best, key=lambda name: -best[name])
    bars = axes.barh(names, [RUNS / best[name] for name in names], color="#1f6f8b")
    axes.bar_label(bars, fmt="%.0f", padding=3)
    axes.margins(x=0.12)
    axes.set_xlabel(f"ropes per second ({SEGMENTS} segments, {STEPS} steps each)")
    axes.spines[["top", "right"]].set_visible(False)
    figure.savefig(RESULTS / f"many-{datetime.date.today().isoformat()}.png", dpi=150)
