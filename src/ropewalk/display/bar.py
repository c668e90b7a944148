"""One line on a terminal that says how far some long work is; nothing where nobody looks."""

from __future__ import annotations

import sys
from collections.abc import Iterable
from types import TracebackType
from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from rich.console import Console

_NAME, _SHARE = 14, 0.225  # letters of a name at most, or this share of a wide terminal's columns
_LEAST = 14  # columns that facts leave the bar
_FIXED = 16  # columns of per cent, time left and the spaces between all parts


def terminal() -> bool:
    """Whether somebody looks at stderr."""
    return bool(getattr(sys.stderr, "isatty", lambda: False)())


def stderr_console() -> Console:
    """Return the terminal behind stderr."""
    from rich.console import Console

    return Console(stderr=True, highlight=False)


def shortened(text: str, most: int) -> str:
    """Return a text of at most so many letters."""
    return text if len(text) <= most else text[: most - 1] + "…"


class Bar:
    """What is done, a bar, per cent, facts and time left, in one line.

    Of the facts those are shown that leave the bar some room, the first ones first. Use as a context
    manager. Silent unless `shown`, and where stderr is no terminal.
    """

    def __init__(self, title: str, *, shown: bool = True) -> None:
        self._title = title
        self._shown = shown and terminal()
        self._bar: Any = None
        self._task: Any = None
        self._room = 0  # columns for facts

    def __enter__(self) -> Bar:
        if not self._shown:
            return self
        from rich.progress import BarColumn, Progress, TextColumn, TimeRemainingColumn

        made = stderr_console()
        title = shortened(self._title, max(_NAME, int(_SHARE * made.width)))
        self._room = made.width - len(title) - _LEAST - _FIXED
        self._bar = Progress(
            TextColumn("{task.description}", markup=False),
            BarColumn(bar_width=None),
            TextColumn("{task.percentage:>3.0f} %", markup=False),
            TextColumn("{task.fields[facts]}", markup=False),
            TimeRemainingColumn(compact=True),
            console=made,
            expand=True,
        )
        self._task = self._bar.add_task(title, total=None, facts="")
        self._bar.start()
        return self

    def begin(self, done: int, planned: int) -> None:
        """Begin to count the time that is left, with what is done already."""
        if self._bar is not None:
            self._bar.reset(self._task, completed=done, total=planned)

    def show(self, done: int, planned: int, facts: Iterable[str] = ()) -> None:
        """Show that `done` of `planned` things are done."""
        if self._bar is not None:
            text = self._fitting(facts)
            self._bar.update(self._task, completed=done, total=planned, facts=text)

    def say(self, text: str) -> None:
        """Show a text in place of the facts, until the next ones."""
        if self._bar is not None:
            self._bar.update(self._task, facts=self._fitting([text]))

    def tell(self, text: str) -> None:
        """Print a line above the bar."""
        if self._bar is not None:
            self._bar.console.print(text, markup=False)

    def _fitting(self, facts: Iterable[str]) -> str:
        """Return the facts that there is room for; the first one always, if need be cut."""
        shown = ""
        for fact in facts:
            longer = f"{shown}  {fact}" if shown else fact
            if len(longer) > self._room:
                return shown or shortened(fact, max(self._room, 1))
            shown = longer
        return shown

    def __exit__(
        self,
        kind: type[BaseException] | None,
        value: BaseException | None,
        trace: TracebackType | None,
    ) -> None:
        if self._bar is not None:
            self._bar.stop()
