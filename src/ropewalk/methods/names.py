"""The names of all methods, a line each: what the scene knows of them before any kernel is loaded.

A method that neither `explicit_methods` nor `implicit_methods` makes is the `METHOD` of a file of its own in
this folder, called as the method, with underscores.
"""

from __future__ import annotations

from collections.abc import Iterable
from importlib import import_module
from typing import Literal, Protocol, TypeVar

Explicit = Literal[
    "euler",
    "semi-implicit-euler",
    "verlet",
    "heun",
    "rk4",
]
Implicit = Literal[
    "implicit-euler",
    "implicit-midpoint",
    "bdf2",
    "sdirk2",
    "esdirk3",
    "generalized-alpha",
    "adaptive",
]
Method = Literal[Explicit, Implicit, "auto"]


class _Named(Protocol):
    @property
    def name(self) -> str: ...


M = TypeVar("M", bound=_Named)


def of_name(name: str, made: Iterable[M]) -> M:
    """Return the method of a name, from a file of its own where it is not among those `made`."""
    for method in made:
        if method.name == name:
            return method
    found: M = import_module(f"ropewalk.methods.{name.replace('-', '_')}").METHOD
    return found
