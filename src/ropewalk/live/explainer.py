"""What the pages are told of a break: at once that there is one, and why as soon as that is found out."""

from __future__ import annotations

import time
from collections.abc import Callable
from concurrent.futures import Future
from typing import Any

from ropewalk.live.aside import aside
from ropewalk.live.breaks import Question
from ropewalk.live.session import Break, Session

PATIENCE = 0.3  # [s] that pages wait for the reason before they are told without


class Explainer:
    """Looks into one break at a time, beside the broadcast; ways out are told anew when constants change."""

    def __init__(self, wake: Callable[[], None]) -> None:
        self._wake = wake
        self.message: dict[str, Any] | None = None  # the newest about the present break
        self._question: Question | None = None
        self._answer: Future[dict[str, Any]] | None = None
        self._asked: tuple[Break, int] | None = None
        self._begun = 0.0
        self._full = False  # whether the reason is known

    def look(self, session: Session) -> dict[str, Any] | None:
        """Return what there is to tell of a session's break that was not told yet; once a tick."""
        if session.broken is None:
            self.message, self._asked, self._full = None, None, False
            return None
        if self._asked is not None and self._asked[0] is not session.broken:
            self.message, self._asked, self._full = None, None, False
        if self._answer is not None and self._answer.done():
            return self._take(session)
        if self._answer is None and self._asked != (session.broken, session.revision):
            self._ask(session)
        question, late = self._question, time.perf_counter() - self._begun > PATIENCE
        if self.message is None and late and question and question.broken is session.broken:
            self.message = question.at_once()
            return self.message
        return None

    def _ask(self, session: Session) -> None:
        assert session.broken is not None
        question = Question.of(session)
        known = self.message if self._full else None
        if self._asked is None:
            self._begun = time.perf_counter()
        self._question, self._asked = question, (session.broken, session.revision)

        def answer() -> dict[str, Any]:
            if known is None:
                return question.answer()
            return known | {"remedies": question.remedies()}

        self._answer = aside(answer, "explainer", self._wake)

    def _take(self, session: Session) -> dict[str, Any] | None:
        assert self._answer is not None
        assert self._question is not None
        answer, self._answer = self._answer, None
        if self._question.broken is not session.broken:
            return None  # of a break that is over
        error = answer.exception()
        if error is None:
            self.message, self._full = answer.result(), True
        else:
            text = f"Broke after t = {self._question.time:.6g} s; why cannot be told: {error}"
            self.message = self._question.at_once() | {"text": text}
        return self.message
