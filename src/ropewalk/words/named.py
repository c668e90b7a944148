"""Things by name, whose table says which name may be meant where one is not known."""

from __future__ import annotations

from typing import TypeVar

from ropewalk.words.nearest import nearest

_Thing = TypeVar("_Thing")


class Named(dict[str, _Thing]):
    """A dict by name; a name that it has not raises KeyError with those that it has."""

    def __init__(self, noun: str, things: dict[str, _Thing]) -> None:
        """Take the `noun` that says what the things are, such as "anchor"."""
        super().__init__(things)
        self._noun = noun

    def __missing__(self, name: object) -> _Thing:
        """Raise KeyError, in words."""
        raise KeyError(f'no {self._noun} "{name}"; {nearest(str(name), self)}')
