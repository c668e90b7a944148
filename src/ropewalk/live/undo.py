"""What can be undone: cuts, pins, loads, kicks and resets, each with the moment just before it."""

from __future__ import annotations

from ropewalk.live.history import History, Moment

LONGEST = 20  # steps back
WORDS = {
    "cut": "the cut",
    "untie": "the cut of a joint",
    "tie": "the tie",
    "pin": "the pin",
    "unpin": "letting go",
    "load": "the load",
    "kick": "the kick",
    "obstacle": "moving the obstacle",
    "reset": "the reset",
}


class Undo:
    """The moments before what was done last, as many as fit."""

    def __init__(self) -> None:
        self._moments = History(LONGEST)
        self._kinds: list[str] = []

    @property
    def word(self) -> str:
        """What would be undone next, "" for nothing."""
        return WORDS[self._kinds[-1]] if self._kinds else ""

    def note(self, kind: str, before: Moment) -> None:
        """Keep the moment before a command of this kind was carried out."""
        self._moments.add(before)
        self._kinds = [*self._kinds, kind][-len(self._moments) :]

    def take(self) -> Moment | None:
        """Return the moment before what was done last, and forget it; None for nothing."""
        if not self._kinds:
            return None
        self._kinds.pop()
        return self._moments.pop()

    def forget_after(self, moment: Moment) -> None:
        """Forget what was done after a moment, which has been gone back to."""
        while self._kinds and self._moments.newest_first()[0].number > moment.number:
            self.take()

    def clear(self) -> None:
        """Forget everything."""
        self._moments.clear()
        self._kinds.clear()
