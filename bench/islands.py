"""Ropes that nothing ties together: what one costs beside others, and what threads gain."""

from __future__ import annotations

import math
import time
from collections.abc import Callable
from concurrent.futures import ThreadPoolExecutor
from functools import partial

from bench.clock import take_turns
from bench.row import Row
from ropewalk import Anchor, Material, Rope, RunSettings, Scene, Simulation
from ropewalk.core.jit import kernel
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


@kernel
def _iterate(x, rounds):
    """Go round a loop that needs nothing but a processor."""
    for _ in range(rounds):
        x = 3.9 * x * (1.0 - x)
    return x


ROUNDS = 10_000_000  # some 60 ms


def _by_one() -> None:
    _iterate(0.4, ROUNDS)
    _iterate(0.4, ROUNDS)


def _by_two() -> None:
    with ThreadPoolExecutor(2) as pool:
        list(pool.map(_iterate, (0.4, 0.4), (ROUNDS, ROUNDS)))


def _gains(second: Second, rounds: int = 20) -> tuple[float, float]:
    """Return what two threads gain over one, on the wall: ropes, and a kernel that only computes.

    All take turns, and the shortest time of each counts: shared machines seldom have two whole processors,
    and what the second gives is the measure of what the first can gain by it.
    """

    def move(threads: int) -> None:
        islands.threads = threads
        second.run()

    turns = [partial(move, 1), partial(move, 2), _by_one, _by_two]
    found = [math.inf] * len(turns)
    for _ in range(rounds):
        for k, turn in enumerate(turns):
            second.restore()
            begun = time.perf_counter()
            turn()
            found[k] = min(found[k], time.perf_counter() - begun)
    return found[0] / found[1], found[2] / found[3]


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
        islands.threads = 2
        gain, most = _gains(Second(64))
        rows.append(Row("64 ropes: one thread / two, on the wall", gain, "1", ">= 1.7"))
        rows.append(Row("a kernel without Python: one thread / two, on the wall", most, "1", ""))
    finally:
        islands.threads = before
    return rows
