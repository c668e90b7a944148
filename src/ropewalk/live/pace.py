"""The pace of play: how many steps are due, what the computer manages, and how near that is to real time."""

from __future__ import annotations

import time
from collections import deque

TICK = 1.0 / 60.0  # [s]
BUDGET = 0.85 * TICK  # [s] of a tick that simulating may take
LONGEST = 0.1  # [s] of wall time that one tick makes up for; a pause of the computer is no jump
WINDOW = 0.5  # [s] over which the real-time factor is taken
FEW = 6  # ticks that are enough to judge by, however long they took
_SMOOTH = 0.1


class Pace:
    """Turns wall time into steps; when the computer is too slow, time is left out, never made up."""

    def __init__(self) -> None:
        self._cost = 0.0  # [s] per step
        self._begun = self._wall = 0.0
        self.load = 0.0  # share of the time spent simulating
        self.realtime = 0.0  # simulated over wall time
        self.slow = False
        self.restart()

    def restart(self) -> None:
        """Begin to count anew: after a pause, a reset or a change."""
        self._last = time.perf_counter()
        self._debt = 0.0  # [s] simulated time that is due
        self._dropped: deque[tuple[float, bool]] = deque()
        self._marks: deque[tuple[float, float]] = deque()

    def steps(self, dt: float, speed: float) -> int:
        """Return how many steps of `dt` [s] are due at a speed, as far as the computer manages."""
        now = time.perf_counter()
        elapsed, self._last = min(now - self._last, LONGEST), now
        self._debt += elapsed * speed
        due = int(self._debt / dt)
        allowed = max(1, int(BUDGET / self._cost)) if self._cost > 0.0 else max(1, int(TICK / dt))
        late = due > allowed
        if late:
            due = allowed
            self._debt = due * dt  # the rest is left out
        self._debt -= due * dt
        self._dropped.append((now, late))
        while len(self._dropped) > FEW and self._dropped[0][0] < now - WINDOW:
            self._dropped.popleft()
        wanted = speed * elapsed
        self.slow = (
            sum(flag for _, flag in self._dropped) > 0.5 * len(self._dropped)
            and len(self._dropped) >= FEW
            and wanted > 0.0
        )
        self._load_decays(elapsed)
        return due

    def _load_decays(self, elapsed: float) -> None:
        self._wall = elapsed

    def words(self, nodes: int, dt: float) -> str:
        """Say how slow it is, with so many nodes and steps of `dt` [s]."""
        return (
            f"{self.realtime:.2g} of real time: this computer is too slow for {nodes} nodes in steps "
            f"of {1e3 * dt:.3g} ms"
        )

    def begin(self) -> None:
        """Begin to measure what steps cost."""
        self._begun = time.perf_counter()

    def end(self, steps: int, due: int) -> None:
        """Note that so many steps were taken since, where so many were due."""
        if steps < due and self._dropped:
            self._dropped[-1] = (self._dropped[-1][0], True)
        if steps == 0:
            return
        spent = time.perf_counter() - self._begun
        cost = spent / steps
        self._cost = cost if self._cost == 0.0 else self._cost + 0.2 * (cost - self._cost)
        share = min(1.0, spent / max(self._wall, 1e-4))
        self.load += _SMOOTH * (share - self.load)

    def note(self, simulated: float) -> None:
        """Note the simulated time [s] for the real-time factor."""
        now = time.perf_counter()
        if self._marks and simulated < self._marks[-1][1]:
            self._marks.clear()
        self._marks.append((now, simulated))
        while len(self._marks) > 2 and self._marks[0][0] < now - WINDOW:
            self._marks.popleft()
        (start, first), (end, last) = self._marks[0], self._marks[-1]
        if end - start > 0.2:
            self.realtime = (last - first) / (end - start)
