"""The stability meter beside the player: measured in a thread of its own, the newest question only."""

from __future__ import annotations

import threading
import time
from typing import Any

from ropewalk.live.meter import measure
from ropewalk.lowering import Model

_REST = 1.0  # times the time that a measurement took, before the next


class MeterThread:
    """Answers the newest question about stability; older ones are forgotten.

    It begins when there is somebody to tell, behind the first picture.
    """

    def __init__(self) -> None:
        self._wake = threading.Condition()
        self._question: list[Model] | None = None
        self._answer: dict[str, Any] | None = None
        self._ended = False
        self.latest: dict[str, Any] | None = None
        self._thread: threading.Thread | None = None

    def ask(self, models: list[Model]) -> None:
        """Ask about models, in place of what was asked before and is not yet answered."""
        with self._wake:
            self._question = models
            self._wake.notify()

    def begin(self) -> None:
        """Begin to answer, unless it was done before."""
        if self._thread is None:
            self._thread = threading.Thread(target=self._run, name="ropewalk-meter", daemon=True)
            self._thread.start()

    def take(self) -> dict[str, Any] | None:
        """Return the newest answer once, when there is one."""
        with self._wake:
            found, self._answer = self._answer, None
        return found

    def end(self) -> None:
        """End the thread."""
        with self._wake:
            self._ended = True
            self._wake.notify()

    def _run(self) -> None:
        while True:
            with self._wake:
                while self._question is None and not self._ended:
                    self._wake.wait()
                if self._ended:
                    return
                models, self._question = self._question or [], None
            begun = time.monotonic()
            found = {"type": "stability", "variants": [measure(model) for model in models]}
            with self._wake:
                self.latest = self._answer = found
            spent = time.monotonic() - begun
            time.sleep(min(_REST * spent, 0.5))
