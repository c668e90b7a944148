"""What a Newton iteration of an implicit method costs, in explicit steps of the same rope."""

from __future__ import annotations

from collections.abc import Callable
from functools import partial

from bench.clock import take_turns
from bench.row import Row
from ropewalk import Anchor, Material, Rope, RunSettings, Scene, Simulation
from ropewalk.methods.stage import SOLVES
from ropewalk.scene import Straight

STEP = 1.0 / 60.0


def dropped(segments: int, length: float = 10.0, method: str = "sdirk2", **more: float) -> Scene:
    """Return the dropped rope: EA 1e5 N, 0.5 kg/m, held at one end, let go from the horizontal."""
    material = Material(EA=1e5, mass_per_length=0.5, **more)
    rope = Rope(
        segments=segments,
        length=length,
        made_of=material,
        shape=Straight(direction=(1.0, 0.0, 0.0)),
    )
    step = STEP if method == "sdirk2" else 1e-6
    run = RunSettings(duration=1.0, time_step=step, method=method)
    return Scene(ropes=rope, anchors=[Anchor(node=0)], run=run)


def swing(scene: Scene, steps: int) -> tuple[Callable[[], None], int]:
    """Return a function that takes `steps` steps from the start, and its Newton iterations."""
    simulation = Simulation(scene, ledger=False)
    start = simulation.state

    def run() -> None:
        simulation.restore(start)
        for _ in range(steps):
            simulation.step()

    report = simulation._scratch.stage.report
    run()
    before = report[SOLVES]
    run()
    return run, int(report[SOLVES] - before)


def newton() -> list[Row]:
    """Newton iterations of sdirk2 on the dropped rope against explicit steps; cost from 100 nodes on."""
    rows = []
    for name, more, target in (
        ("stretch only", {}, "<= 25"),
        ("axial friction", {"axial_damping": 1.0}, ""),
        ("bending", {"EI": 0.01}, "<= 70"),
    ):
        run, iterations = swing(dropped(1000, **more), 6)
        simple = Simulation(dropped(1000, method="semi-implicit-euler"), ledger=False)
        explicit = partial(simple.step, 100e-6)
        ratio = take_turns({"implicit": run, "explicit": explicit}).ratio("implicit", "explicit")
        per = ratio * 100.0 / iterations
        rows.append(Row(f"Newton iteration / explicit step, {name}", per, "1", target))
    sizes = (100, 1000, 10_000, 100_000, 1_000_000)
    runs = {n: swing(dropped(n, 0.1 * n), max(1, 6000 // n)) for n in sizes}
    timing = take_turns({str(n): run for n, (run, _) in runs.items()}, rounds=3)
    costs = {n: 1e9 * timing.best(str(n)) / (runs[n][1] * n) for n in sizes}
    rows += [Row(f"iteration at {n} nodes", costs[n], "ns/node", "") for n in sizes]
    spread = max(costs.values()) / min(costs.values())
    return [*rows, Row("largest / smallest cost of an iteration", spread, "1", "<= 1.5")]
