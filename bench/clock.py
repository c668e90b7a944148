"""Timing that survives a noisy machine: contestants take turns, and the least of many turns counts.

The clock is the processor time of this process, its threads together: other programs on the same core
do not count, and what a second thread does counts as on one core. What others take of caches and memory still
counts; only the least time is free of that.
"""

from __future__ import annotations

import time
from collections.abc import Callable, Mapping
from dataclasses import dataclass

ROUNDS = 60


@dataclass
class Timing:
    """Seconds per call of each contestant, turn by turn."""

    seconds: dict[str, list[float]]

    def best(self, name: str) -> float:
        """Return the shortest time [s]."""
        return min(self.seconds[name])

    def ratio(self, name: str, other: str) -> float:
        """Return one's shortest time over the other's [1]."""
        return self.best(name) / self.best(other)


def take_turns(
    contestants: Mapping[str, Callable[[], object]],
    rounds: int = ROUNDS,
    before: Mapping[str, Callable[[], object]] | None = None,
) -> Timing:
    """Time all contestants in turn, after one untimed call of each.

    What is in `before` under a contestant's name is done before each of its turns, untimed.
    """
    prepare = before or {}
    for name, run in contestants.items():
        prepare.get(name, _nothing)()
        run()
    seconds: dict[str, list[float]] = {name: [] for name in contestants}
    for _ in range(rounds):
        for name, run in contestants.items():
            prepare.get(name, _nothing)()
            start = time.process_time()
            run()
            seconds[name].append(time.process_time() - start)
    return Timing(seconds)


def _nothing() -> None:
    return None
