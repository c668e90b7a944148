"""A result's way to the figures, which are imported when one is drawn."""

from __future__ import annotations

from functools import partial
from importlib import import_module
from io import BytesIO
from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from ropewalk.record.result import Result

_HOME = "ropewalk.plots"  # a layer above this one, so it is looked up by name when it is needed


class Plots:
    """The figures of one result, as methods."""

    def __init__(self, result: Result) -> None:
        self._result = result

    def __getattr__(self, name: str) -> Any:
        if name.startswith("_"):
            raise AttributeError(name)
        plots = import_module(_HOME)
        if name not in self.__dir__():
            known = ", ".join(self.__dir__())
            raise AttributeError(f"no figure {name!r}; there is {known}")
        return partial(getattr(plots, name), self._result)

    def __dir__(self) -> list[str]:
        plots = import_module(_HOME)
        return sorted(getattr(plots, "FIGURES", None) or plots.__all__)

    def __repr__(self) -> str:
        return f"Figures of {self._result.scene.name!r}: {', '.join(self.__dir__())}."


def png(result: Result) -> bytes | None:
    """Draw the result's shape as PNG; None where figures cannot be drawn."""
    try:
        figure = Plots(result).shape()
        buffer = BytesIO()
        figure.savefig(buffer, format="png", dpi=100)
    except ImportError:
        return None
    return buffer.getvalue()
