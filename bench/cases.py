"""The benchmarks: each returns rows of name, value, unit, target."""

from __future__ import annotations

import shutil
import subprocess
import sys
import tempfile
import time
from collections.abc import Callable
from pathlib import Path
from typing import NamedTuple

from bench.clock import Timing, take_turns
from bench.yardsticks import bare_loop, numpy_loop
from ropewalk import Anchor, Rope, RunSettings, Scene, Simulation, Springs
from ropewalk.methods.recording import make_recording
from ropewalk.methods.registry import METHODS

DT = 0.002  # [s] the report's


class Row(NamedTuple):
    """One measured number."""

    case: str
    value: float
    unit: str
    target: str


def report_rope(
    segments: int,
    ropes: int = 1,
    frame_rate: float = 60.0,
    duration: float = 10.0,
    method: str = "semi-implicit-euler",
) -> Scene:
    """Return ropes of the report's springs, both ends held."""
    springs = Springs(spring_constant=1e4, node_mass=0.05, spring_friction=0.05, segment_length=1.0)
    names = [f"rope{i}" for i in range(ropes)]
    step = DT if METHODS[method].order != 1 or method != "euler" else 1e-6
    return Scene(
        gravity=(0.0, -9.81, 0.0),
        ropes=[Rope(name=name, segments=segments, made_of=springs) for name in names],
        anchors=[Anchor(rope=name, node=node) for name in names for node in (0, -1)],
        run=RunSettings(time_step=step, frame_rate=frame_rate, duration=duration, method=method),
    )


def stepper(scene: Scene, steps: int, *, ledger: bool) -> Callable[[], None]:
    """Return a function that runs `steps` steps without recording."""
    simulation = Simulation(scene, ledger=ledger)
    nothing = make_recording(simulation.arrays, 0, False)
    return lambda: simulation._advance(steps, 1, nothing)  # type: ignore[func-returns-value]


def one_rope() -> list[Row]:
    """1000 segments against a bare loop of the same arithmetic."""
    n, steps = 1000, 1000
    bare = bare_loop(n + 1, DT)
    timing = take_turns(
        {
            "bare": lambda: bare(steps),
            "plain": stepper(report_rope(n), steps, ledger=False),
            "ledger": stepper(report_rope(n), steps, ledger=True),
        }
    )
    per = 1e9 / (n * steps)
    return [
        Row("bare loop, 1000 segments", timing.best("bare") * per, "ns/segment/step", ""),
        Row("ropewalk, 1000 segments", timing.best("plain") * per, "ns/segment/step", ""),
        Row("ropewalk / bare loop", timing.ratio("plain", "bare"), "1", "<= 1.5"),
        Row("with the work ledger / bare loop", timing.ratio("ledger", "bare"), "1", ""),
    ]


def against_numpy() -> list[Row]:
    """100 segments against whole-array numpy."""
    n, steps = 100, 300
    numpy_version = numpy_loop(n + 1, DT)
    timing = take_turns(
        {
            "numpy": lambda: numpy_version(steps),
            "plain": stepper(report_rope(n), steps, ledger=False),
            "ledger": stepper(report_rope(n), steps, ledger=True),
        }
    )
    return [
        Row("numpy / ropewalk, 100 segments", timing.ratio("numpy", "plain"), "1", ">= 80"),
        Row("numpy / ropewalk with the ledger", timing.ratio("numpy", "ledger"), "1", ""),
    ]


def many_ropes() -> list[Row]:
    """100 ropes of 100 segments against one of 10000, per segment."""
    timing = take_turns(
        {
            "many": stepper(report_rope(100, ropes=100), 100, ledger=False),
            "one": stepper(report_rope(10_000), 100, ledger=False),
        }
    )
    return [Row("100 ropes of 100 / 1 of 10000", timing.ratio("many", "one"), "1", "0.8 to 1.2")]


def flatness() -> list[Row]:
    """Cost per segment from 100 to a million segments."""
    sizes = (100, 1000, 10_000, 100_000, 1_000_000)
    runs = {}
    for n in sizes:
        runs[str(n)] = stepper(report_rope(n), max(1, 1_000_000 // n), ledger=False)
    timing = take_turns(runs, rounds=7)
    costs = {n: timing.best(str(n)) / (max(1, 1_000_000 // n) * n) * 1e9 for n in sizes}
    rows = [Row(f"cost at {n} segments", costs[n], "ns/segment/step", "") for n in sizes]
    spread = max(costs.values()) / min(costs.values())
    return [*rows, Row("largest / smallest cost", spread, "1", "<= 1.5")]


def recording() -> list[Row]:
    """100000 steps of 1000 segments, every frame at 60 Hz recorded in memory, against no recording."""
    rows = []
    for dt, name in ((DT, "9 steps a frame"), (1.8e-4, "93 steps a frame")):
        scene = report_rope(1000).replace(run=RunSettings(time_step=dt, duration=100.0))
        timing = _recorded(scene, 100_000)
        overhead = timing.ratio("recorded", "plain") - 1.0
        rows.append(Row(f"recording every frame, {name}", 100 * overhead, "%", "< 10"))
    return rows


def _recorded(scene: Scene, steps: int) -> Timing:
    per_frame = Simulation(scene).plan.steps_per_frame

    def run(*, record: bool) -> None:
        simulation = Simulation(scene, ledger=False)
        frames, size = steps // per_frame, simulation.block_frames
        out = make_recording(simulation.arrays, size if record else 0, False)
        while frames > 0:
            simulation._advance(per_frame, min(size, frames), out)
            frames -= size

    return take_turns(
        {"plain": lambda: run(record=False), "recorded": lambda: run(record=True)}, rounds=5
    )


def methods() -> list[Row]:
    """Every method's cost for one step of 1000 segments."""
    runs = {name: stepper(report_rope(1000, method=name), 100, ledger=False) for name in METHODS}
    timing = take_turns(runs, rounds=7)
    return [
        Row(f"method {name}", timing.best(name) / 1e5 * 1e9, "ns/segment/step", "")
        for name in METHODS
    ]


def start_up() -> list[Row]:
    """A warm `ropewalk run` of the demo's scene for one frame: command to exit."""
    command = [sys.executable, "-m", "ropewalk", "run", "r4", "--duration", "0.02", "--quiet"]
    times = []
    for i in range(4):
        folder = Path(tempfile.mkdtemp())
        start = time.perf_counter()
        subprocess.run([*command, "-o", str(folder / "run")], check=True, capture_output=True)
        times.append(time.perf_counter() - start)
        shutil.rmtree(folder)
        if i == 0:
            times.clear()
    return [Row("warm `ropewalk run`, whole command", min(times), "s", "< 1.5 to the first step")]


CASES = (one_rope, against_numpy, many_ropes, flatness, recording, methods, start_up)
