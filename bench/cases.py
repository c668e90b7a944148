"""The benchmarks: each returns rows of name, value, unit, target."""

from __future__ import annotations

import shutil
import subprocess
import sys
import tempfile
import time
from collections.abc import Callable
from itertools import count
from pathlib import Path

from bench.apart import nothing_near
from bench.clock import Timing, take_turns
from bench.compile import compile  # noqa: A004 - the name of the case
from bench.heaps import here_and_there, ropes_on_ropes
from bench.implicit import newton
from bench.islands import many_islands
from bench.live import live_server
from bench.many import many
from bench.near import finding_pairs
from bench.page import page, page_memory
from bench.peaks import extremes
from bench.row import Row
from bench.touch import on_obstacles, sticking, without_contacts
from bench.yardsticks import bare_loop, numpy_loop
from ropewalk import Anchor, Rope, RunSettings, Scene, Simulation, Springs
from ropewalk.lowering import build
from ropewalk.methods.recording import make_recording
from ropewalk.methods.registry import METHODS
from ropewalk.record.run import record_run

DT = 0.002  # [s] the report's


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
    step = 1e-6 if method == "euler" else DT
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
    n, steps = 1000, 300
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
    """100 segments, and a bare loop of the same arithmetic, against whole-array numpy."""
    n, steps = 100, 900
    numpy_version, bare = numpy_loop(n + 1, DT), bare_loop(n + 1, DT)
    timing = take_turns(
        {
            "numpy": lambda: numpy_version(steps),
            "bare": lambda: bare(steps),
            "plain": stepper(report_rope(n), steps, ledger=False),
            "ledger": stepper(report_rope(n), steps, ledger=True),
        }
    )
    return [
        Row("numpy / ropewalk, 100 segments", timing.ratio("numpy", "plain"), "1", ">= 80"),
        Row("numpy / ropewalk with the ledger", timing.ratio("numpy", "ledger"), "1", ""),
        Row("numpy / bare loop, 100 segments", timing.ratio("numpy", "bare"), "1", ""),
    ]


def many_ropes() -> list[Row]:
    """100 ropes of 100 segments against one of 10000, per segment."""
    timing = take_turns(
        {
            "many": stepper(report_rope(100, ropes=100), 36, ledger=False),
            "one": stepper(report_rope(10_000), 36, ledger=False),
        }
    )
    return [Row("100 ropes of 100 / 1 of 10000", timing.ratio("many", "one"), "1", "0.8 to 1.2")]


def flatness() -> list[Row]:
    """Cost per segment from 100 to a million segments, in frames of 9 steps (60 Hz and 2 ms)."""
    sizes = (100, 1000, 10_000, 100_000, 1_000_000)
    counts = {n: max(9, 900_000 // n) for n in sizes}
    rows = []
    for ledger, name in ((False, ""), (True, ", with the work ledger")):
        runs = {str(n): stepper(report_rope(n), counts[n], ledger=ledger) for n in sizes}
        timing = take_turns(runs, rounds=12)
        costs = {n: timing.best(str(n)) / (counts[n] * n) * 1e9 for n in sizes}
        rows += [Row(f"cost at {n} segments{name}", costs[n], "ns/segment/step", "") for n in sizes]
        spread = max(costs.values()) / min(costs.values())
        rows.append(Row(f"largest / smallest cost{name}", spread, "1", "" if ledger else "<= 1.5"))
    return rows


def recording() -> list[Row]:
    """Every frame at 60 Hz of 1000 segments, in memory and into a folder, against no recording."""
    rows = []
    for dt, steps in ((DT, 9), (1.8e-4, 93)):
        for ledger in (False, True):
            name = f"{steps} steps a frame" + (", with the work ledger" if ledger else "")
            timing = _recorded(dt, ledger)
            for how in ("memory", "folder"):
                overhead = 100.0 * (timing.ratio(how, "plain") - 1.0)
                rows.append(Row(f"recording every frame in {how}, {name}", overhead, "%", "< 10"))
    return rows


def _recorded(dt: float, ledger: bool, steps: int = 100_000) -> Timing:
    scene = report_rope(1000)
    per_frame = Simulation(scene.replace(run=RunSettings(time_step=dt))).plan.steps_per_frame
    duration = steps // per_frame / 60.0
    model = build(scene.replace(run=RunSettings(time_step=dt, duration=duration)))

    def plain() -> None:
        simulation = Simulation(model, ledger=ledger)
        nothing = make_recording(simulation.arrays, 0, False)
        simulation._advance(simulation.plan.steps_per_frame, simulation.plan.frames, nothing)

    def memory() -> None:
        for _ in Simulation(model, ledger=ledger).frames():
            pass

    with tempfile.TemporaryDirectory() as place:  # removing files takes longer than writing them
        names = (Path(place) / str(number) for number in count())

        def folder() -> None:
            record_run(model, next(names), ledger=ledger)

        return take_turns({"plain": plain, "memory": memory, "folder": folder}, rounds=4)


def methods() -> list[Row]:
    """Every method's cost for one step of 1000 segments."""
    fixed = [name for name, method in METHODS.items() if method.fixed]
    runs = {name: stepper(report_rope(1000, method=name), 100, ledger=False) for name in fixed}
    timing = take_turns(runs, rounds=7)
    return [
        Row(f"method {name}", timing.best(name) / 1e5 * 1e9, "ns/segment/step", "")
        for name in fixed
    ]


def segment_step() -> float:
    """Return the cost of an explicit step of semi-implicit Euler [s], per segment of 1000."""
    timing = take_turns({"plain": stepper(report_rope(1000), 100, ledger=False)}, rounds=7)
    return timing.best("plain") / 1e5


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


CASES = (
    one_rope,
    against_numpy,
    many_ropes,
    flatness,
    recording,
    methods,
    extremes,
    newton,
    many_islands,
    sticking,
    on_obstacles,
    without_contacts,
    nothing_near,
    finding_pairs,
    here_and_there,
    ropes_on_ropes,
    many,
    start_up,
    compile,
    live_server,
    page,
    page_memory,
)
