"""One task at a time beside the simulation, whose kernels leave the interpreter free."""

from __future__ import annotations

from collections.abc import Callable
from concurrent.futures import Future, ThreadPoolExecutor
from types import TracebackType


class Background:
    """Runs tasks in a thread, one after another; what a task raises comes out of the next `wait`.

    Use as a context manager: at its end the task in flight, if any, is waited for.
    """

    def __init__(self) -> None:
        self._pool = ThreadPoolExecutor(1, "ropewalk-writer")
        self._running: Future[None] | None = None

    def start(self, task: Callable[[], None]) -> None:
        """Start a task when the one before is done. Raises what that one raised."""
        self.wait()
        self._running = self._pool.submit(task)

    def wait(self) -> None:
        """Wait until nothing is in flight. Raises what the task raised."""
        running, self._running = self._running, None
        if running is not None:
            running.result()

    def __enter__(self) -> Background:
        return self

    def __exit__(
        self,
        kind: type[BaseException] | None,
        error: BaseException | None,
        trace: TracebackType | None,
    ) -> None:
        self._pool.shutdown()
        if kind is None:
            self.wait()
