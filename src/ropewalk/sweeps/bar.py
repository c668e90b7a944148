"""How far a sweep is: a bar on a terminal, or calls of a function."""

from __future__ import annotations

import sys
import time
from collections.abc import Callable
from types import TracebackType
from typing import Any

_EVERY = 0.1  # [s] at most so often


class Bar:
    """Counts runs and shows them: how many a second, how long still, how many broke.

    `progress`: True for a bar on a terminal, False for nothing, or a function.
    """

    def __init__(self, title: str, runs: int, progress: Any, standing: Callable[..., Any]) -> None:
        self._title, self._runs, self._standing = title, runs, standing
        self._call = progress if callable(progress) else None
        self._shown = progress is True and bool(getattr(sys.stderr, "isatty", lambda: False)())
        self._bar: Any = None
        self._task: Any = None
        self._note = ""
        self._done = self._before = self._broken = 0
        self._begun = self._last = time.perf_counter()

    def __enter__(self) -> Bar:
        if self._shown:
            from rich.console import Console
            from rich.progress import BarColumn, Progress, TextColumn, TimeRemainingColumn

            self._bar = Progress(
                TextColumn("{task.description}", markup=False),
                BarColumn(bar_width=None),
                TextColumn("{task.fields[facts]}", markup=False),
                TimeRemainingColumn(compact=True),
                console=Console(stderr=True, highlight=False),
            )
            self._task = self._bar.add_task(self._title, total=self._runs, facts="")
            self._bar.start()
        return self

    def start(self, done: int, broken: int) -> None:
        """Begin with what is done already."""
        self._done = self._before = done
        self._broken = broken
        self._begun = time.perf_counter()

    def note(self, text: str) -> None:
        """Say where it runs."""
        self._note = text
        if self._bar is not None:
            self._bar.console.print(text, markup=False)

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
        if self._bar is not None:
            facts = f"{self._done} of {self._runs} runs  {rate:.3g}/s  {self._broken} broken"
            self._bar.update(self._task, completed=self._done, facts=facts)

    def __exit__(
        self,
        kind: type[BaseException] | None,
        value: BaseException | None,
        trace: TracebackType | None,
    ) -> None:
        if self._bar is not None:
            self._bar.stop()
