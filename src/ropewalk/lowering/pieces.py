"""What a model is made of, kept from one build to the next until what it is made from changes."""

from __future__ import annotations

from collections.abc import Callable, Hashable
from typing import Any, TypeVar

import numpy as np

from ropewalk.lowering.layout import Layout

T = TypeVar("T")


class Pieces:
    """Makes arrays and tables; one whose inputs are as they were last time is not made again.

    A piece is made by a function of its inputs alone, and nobody writes to it: so a model has the same bits
    whether its pieces were kept or made. Only the last one of each is kept.
    """

    def __init__(self) -> None:
        self._kept: dict[Hashable, tuple[tuple[Any, ...], Any]] = {}
        self.made: list[str] = []  # names of what the last build made

    def __call__(self, name: str, make: Callable[..., T], *inputs: Any) -> T:
        """Return what `make(*inputs)` gives, or gave; `name` tells its pieces apart."""
        kept = self._kept.get(name)
        if kept is not None and same(kept[0], inputs):
            found: T = kept[1]
            return found
        self.made.append(name)
        value = make(*inputs)
        self._kept[name] = inputs, value
        return value


def same(one: Any, other: Any) -> bool:
    """Tell whether two inputs are alike to the bit; models of a scene only when they are one object."""
    if one is other:
        return True
    kind = type(one)
    if kind is not type(other):
        return False
    if kind is float:  # 0.0 is not -0.0
        return bool(one == other and (one != 0.0 or repr(one) == repr(other)))
    if isinstance(one, tuple):
        return len(one) == len(other) and all(map(same, one, other))
    if kind is np.ndarray:
        return bool(one.shape == other.shape and one.tobytes() == other.tobytes())
    return isinstance(one, (int, str, Layout)) and bool(one == other)
