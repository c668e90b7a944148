"""Ropes that nothing ties together: what one costs beside others, and what threads gain."""

from __future__ import annotations

import time
from collections.abc import Callable

from bench.clock import take_turns
from bench.row import Row
from ropewalk import Anchor, Material, Rope, RunSettings, Scene, Simulation
from ropewalk.engine import islands
from ropewalk.lowering import build
from ropewalk.scene import Slack

STEP = 1.0 / 60.0


def beside(ropes: int, segments: int = 50, method: str = "sdirk2") -> Scene:
    """Return equal ropes side by side, each let go from a shallow bow and held at one end."""
    names = [f"rope{i}" for i in range(ropes)]
    return Scene(
        ropes=[
            Rope(
                name=name,
                segments=segments,
                length=1.0,
                made_of=Material(EA=1e4, mass_per_length=0.1),
                shape=Slack(start=(0, 0.1 * i, 0), end=(0.9, 0.1 * i, 0.2)),
            )
            for i, name in enumerate(names)
        ],
        anchors=[Anchor(rope=name, node=0) for name in names],
        run=RunSettings(duration=1.0, frame_rate=60, time_step=STEP, method=method),
    )


class Second:
    """One simulated second from the start, recorded."""

    def __init__(self, ropes: int, method: str = "sdirk2") -> None:
        self.simulation = Simulation(beside(ropes, method=method))
        self.start = self.simulation.state

    def restore(self) -> None:
        """Go back to the start."""
        self.simulation.restore(self.start)

    def run(self) -> None:
        """Take the second."""
        self.simulation.advance_frames(60)


def _wall(second: Second, threads: int, rounds: int = 20) -> float:
    """Return the shortest time on the wall of one second by so many threads [s]."""
    islands.threads, found = threads, []
    for _ in range(rounds):
        second.restore()
        begun = time.perf_counter()
        second.run()
        found.append(time.perf_counter() - begun)
    return min(found)


def _build(ropes: int) -> Callable[[], object]:
    scene = beside(ropes)
    return lambda: Simulation(build(scene))


def many_islands() -> list[Row]:
    """Ropes side by side with sdirk2 at 1/60 s: 20 over one, threads on 64, 1024, and building 2000."""
    before = islands.threads
    try:
        islands.threads = 1
        rows = []
        for method in ("sdirk2", "adaptive"):
            one, twenty = Second(1, method), Second(20, method)
            turns = {"one": one.run, "twenty": twenty.run}
            timing = take_turns(turns, 20, {"one": one.restore, "twenty": twenty.restore})
            ratio = timing.ratio("twenty", "one") / 20.0
            rows.append(Row(f"20 ropes / 20 times one, {method}", ratio, "1", "<= 1.1"))
        many = Second(1024)
        timing = take_turns({"many": many.run}, 3, {"many": many.restore})
        rows.append(Row("1024 ropes of 50 segments, 1 s", timing.best("many"), "s", "<= 1"))
        timing = take_turns({"2000": _build(2000), "500": _build(500)}, 3)
        rows.append(Row("building 2000 ropes / 500", timing.ratio("2000", "500"), "1", "<= 4.4"))
        sixty_four = Second(64)
        gain = _wall(sixty_four, 1) / _wall(sixty_four, 2)
        rows.append(Row("64 ropes: one thread / two, on the wall", gain, "1", ">= 1.7"))
    finally:
        islands.threads = before
    return rows
