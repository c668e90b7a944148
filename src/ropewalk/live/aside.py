"""Work beside the player: what may take longer than a tick is done in a thread of its own."""

from __future__ import annotations

import threading
from collections.abc import Callable
from concurrent.futures import Future
from typing import TypeVar

T = TypeVar("T")


def aside(what: Callable[[], T], name: str, wake: Callable[[], None]) -> Future[T]:
    """Begin something in a new thread; return its future. `wake` is called when it is there.

    The thread does not keep the program from ending.
    """
    made: Future[T] = Future()

    def run() -> None:
        try:
            made.set_result(what())
        except BaseException as error:
            made.set_exception(error)
        wake()

    threading.Thread(target=run, name=f"ropewalk-{name}", daemon=True).start()
    return made
