"""The gate that work for threads passes: closed, nothing begins any more, and all that has begun is over."""

from __future__ import annotations

from collections.abc import Callable
from threading import Condition
from typing import ParamSpec, TypeVar

T = TypeVar("T")
P = ParamSpec("P")


class Gate:
    """Counts the work that runs, whoever has handed it out.

    A list of what was handed out does not do: Ctrl-C can come between a piece of work and its place in it.
    """

    def __init__(self) -> None:
        self._changed = Condition()
        self._running = 0
        self._closed = False

    def run(self, go: Callable[P, T], *args: P.args, **named: P.kwargs) -> T | None:
        """Return what `go` returns; None, without a call of it, where the gate is closed."""
        with self._changed:
            if self._closed:
                return None
            self._running += 1
        try:
            return go(*args, **named)
        finally:
            with self._changed:
                self._running -= 1
                self._changed.notify_all()

    def close(self) -> None:
        """Let nothing begin any more, and wait for what runs; raise what came meanwhile afterwards."""
        came: BaseException | None = None
        while not (self._closed and self._running == 0):
            try:
                with self._changed:
                    self._closed = True
                    self._changed.wait_for(lambda: self._running == 0)
            except BaseException as error:
                came = error
        if came is not None:
            raise came
