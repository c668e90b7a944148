"""Types as `help` shows them: without the quotes that it puts around every annotation kept as text."""

from __future__ import annotations

import inspect
from collections.abc import Iterator
from types import FunctionType
from typing import Any, TypeVar

_T = TypeVar("_T")


class Bare(str):
    """A text that shows without quotes."""

    __slots__ = ()

    def __repr__(self) -> str:
        return str(self)


def unquoted(thing: _T) -> _T:
    """Have `help` show the types of a function, or of all of a class, without quotes; return it."""
    for function in _functions(thing):
        found = function.__annotations__
        found.update({key: Bare(text) for key, text in found.items() if isinstance(text, str)})
    return thing


def _functions(thing: Any) -> Iterator[FunctionType]:
    """Yield the functions of the package behind a public name."""
    if inspect.isfunction(thing):
        yield thing
    if not inspect.isclass(thing):
        return
    for owner in thing.__mro__:
        if owner.__module__.startswith(__name__.partition(".")[0]):
            for value in vars(owner).values():
                function = getattr(value, "fget", None) or getattr(value, "func", None)
                function = function or getattr(value, "__func__", value)
                if inspect.isfunction(function):
                    yield function
