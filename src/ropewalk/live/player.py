"""The player: a thread that keeps a broadcast going, in step with the clock on the wall."""

from __future__ import annotations

import sys
import threading
import time
import traceback
from typing import Protocol

from ropewalk.live.pace import TICK

EARLIEST = 0.4 * TICK  # [s] after a tick that a command brings the next one forward to
IDLE = 0.25  # [s] between two ticks when nothing moves


class Playable(Protocol):
    """What a player keeps going."""

    playing: bool

    def tick(self) -> None:
        """Go on by the time that has passed."""


class Player:
    """Ticks a broadcast 60 times a second while it plays, and at once when a command comes in."""

    def __init__(self, broadcast: Playable) -> None:
        self.broadcast = broadcast
        self.error: BaseException | None = None
        self._wake = threading.Event()
        self._ended = threading.Event()
        self._thread = threading.Thread(target=self._run, name="ropewalk-player", daemon=True)

    def start(self) -> None:
        """Begin."""
        self._thread.start()

    def wake(self) -> None:
        """Have a command looked at now (from any thread)."""
        self._wake.set()

    def end(self) -> None:
        """End, and wait for the present tick."""
        self._ended.set()
        self._wake.set()
        if self._thread.is_alive():
            self._thread.join(10.0)

    @property
    def alive(self) -> bool:
        """Whether it still plays."""
        return self._thread.is_alive()

    def _run(self) -> None:
        try:
            self._play()
        except BaseException as error:  # a thread's error would go unseen
            self.error = error
            traceback.print_exception(error, file=sys.stderr)

    def _play(self) -> None:
        last = 0.0
        while not self._ended.is_set():
            now = time.perf_counter()
            wait = last + (TICK if self.broadcast.playing else IDLE) - now
            if wait > 0.0 and self._wake.wait(wait):
                early = last + EARLIEST - time.perf_counter()
                if early > 0.0:
                    time.sleep(early)
            self._wake.clear()
            if self._ended.is_set():
                return
            due, now = last + TICK, time.perf_counter()
            last = now if now < due else max(due, now - 0.5 * TICK)
            self.broadcast.tick()
