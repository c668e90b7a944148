"""How far a sweep is: a bar on a terminal, or calls of a function."""

from __future__ import annotations

import logging
import sys
import time
from collections.abc import Callable
from typing import Any

from ropewalk.display.bar import Bar, terminal

_log = logging.getLogger("ropewalk.sweep")

_EVERY = 0.1  # [s] at most so often


class RunsBar:
    """Counts runs and shows them: how many a second, how long still, how many broke.

    `progress`: True for a bar on a terminal, False for nothing, or a function.
    """

    def __init__(self, title: str, runs: int, progress: Any, standing: Callable[..., Any]) -> None:
        self._runs, self._standing = runs, standing
        self._call = progress if callable(progress) else None
        self._shown = progress is True
        self._bar = Bar(title, shown=self._shown)
        self._note = ""
        self._done = self._before = self._broken = 0
        self._begun = self._last = time.perf_counter()

    def __enter__(self) -> RunsBar:
        self._bar.__enter__()
        return self

    def start(self, done: int, broken: int) -> None:
        """Begin with what is done already."""
        self._done = self._before = done
        self._broken = broken
        self._begun = time.perf_counter()
        self._bar.begin(done, self._runs)

    def note(self, text: str) -> None:
        """Say where it runs: above the bar, or on stderr where there is none; in the log always."""
        self._note = text
        _log.info(text)
        if self._shown and terminal():
            self._bar.tell(text)
        elif self._shown:
            print(text, file=sys.stderr, flush=True)

    def add(self, runs: int, broken: int) -> None:
        """Count some runs more."""
        self._done += runs
        self._broken += broken
        now = time.perf_counter()
        if now - self._last < _EVERY and self._done < self._runs:
            return
        self._last = now
        rate = (self._done - self._before) / max(now - self._begun, 1e-9)
        if self._call is not None:
            self._call(self._standing(self._done, self._runs, self._broken, rate, self._note))
        facts = (f"{self._done} of {self._runs} runs", f"{self._broken} broken", f"{rate:.3g}/s")
        self._bar.show(self._done, self._runs, facts)

    def __exit__(self, *error: Any) -> None:
        self._bar.__exit__(*error)
