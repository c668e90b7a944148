"""Timing that survives a noisy machine: contestants take turns, ratios are taken turn by turn."""

from __future__ import annotations

import statistics
import time
from collections.abc import Callable
from dataclasses import dataclass

ROUNDS = 15


@dataclass
class Timing:
    """Seconds per call of each contestant, turn by turn."""

    seconds: dict[str, list[float]]

    def best(self, name: str) -> float:
        """Return the shortest time [s]."""
        return min(self.seconds[name])

    def ratio(self, name: str, other: str) -> float:
        """Return the median over the turns of one's time over the other's [1]."""
        pairs = zip(self.seconds[name], self.seconds[other], strict=True)
        return statistics.median(a / b for a, b in pairs)


def take_turns(contestants: dict[str, Callable[[], object]], rounds: int = ROUNDS) -> Timing:
    """Time all contestants in turn, after one untimed call of each."""
    for run in contestants.values():
        run()
    seconds: dict[str, list[float]] = {name: [] for name in contestants}
    for _ in range(rounds):
        for name, run in contestants.items():
            start = time.perf_counter()
            run()
            seconds[name].append(time.perf_counter() - start)
    return Timing(seconds)
