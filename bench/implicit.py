"""What a Newton iteration of an implicit method costs, in explicit steps of the same rope."""

from __future__ import annotations

from bench.clock import take_turns
from bench.row import Row
from ropewalk import Anchor, Material, Rope, RunSettings, Scene, Simulation
from ropewalk.methods.recording import make_recording
from ropewalk.methods.stage_report import SOLVES
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


class Swing:
    """Steps of a scene from its start, in one call of the compiled loop: what it takes without Python."""

    def __init__(self, scene: Scene, steps: int) -> None:
        self.simulation, self.steps = Simulation(scene, ledger=False), steps
        self.start = self.simulation.state
        self.nothing = make_recording(self.simulation.arrays, 0, False)

    def restore(self) -> None:
        """Go back to the start."""
        self.simulation.restore(self.start)

    def go_on(self, steps: int) -> None:
        """Take so many steps from the start, and start from there."""
        if steps:
            self.simulation._advance(steps, 1, self.nothing)
            self.start = self.simulation.state

    def run(self) -> None:
        """Take the steps."""
        self.simulation._advance(self.steps, 1, self.nothing)

    @property
    def iterations(self) -> int:
        """Newton iterations of one run."""
        report = self.simulation._engine._scratch.stage.report
        self.restore()
        before = report[SOLVES]
        self.run()
        return int(report[SOLVES] - before)


def newton() -> list[Row]:
    """Newton iterations of sdirk2 on the dropped rope against explicit steps; cost from 100 nodes on."""
    rows = []
    for name, more, target in (
        ("stretch only", {}, "<= 25"),
        ("axial friction", {"axial_damping": 1.0}, ""),
        ("bending", {"EI": 0.01}, "<= 70"),
    ):
        implicit = Swing(dropped(1000, **more), 6)
        explicit = Swing(dropped(1000, method="semi-implicit-euler"), 100)
        iterations = implicit.iterations
        contestants = {"implicit": implicit.run, "explicit": explicit.run}
        timing = take_turns(contestants, before={"implicit": implicit.restore})
        per = timing.ratio("implicit", "explicit") * 100.0 / iterations
        rows.append(Row(f"Newton iteration / explicit step, {name}", per, "1", target))
    return rows + flat_iterations()


def flat_iterations() -> list[Row]:
    """Cost of an iteration from 100 to a million nodes."""
    sizes = (100, 1000, 10_000, 100_000, 1_000_000)
    swings = {str(n): Swing(dropped(n, 0.1 * n), max(1, 6000 // n)) for n in sizes}
    runs, before = (
        {name: getattr(one, do) for name, one in swings.items()} for do in ("run", "restore")
    )
    timing = take_turns(runs, rounds=6, before=before)
    costs = {n: timing.best(str(n)) / (swings[str(n)].iterations * n) for n in sizes}
    rows = [Row(f"iteration at {n} nodes", 1e9 * costs[n], "ns/node", "") for n in sizes]
    spread = max(costs.values()) / min(costs.values())
    return [*rows, Row("largest / smallest cost of an iteration", spread, "1", "<= 1.5")]
