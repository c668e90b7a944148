"""The way from modes to their figures, which are imported when one is drawn."""

from __future__ import annotations

from functools import partial
from importlib import import_module
from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from ropewalk.vibration.modes import Modes

_HOME = "ropewalk.plots"  # a layer above this one, so it is looked up by name when it is needed


class ModePlots:
    """The figures of modes, as methods."""

    def __init__(self, modes: Modes) -> None:
        self._modes = modes

    def __getattr__(self, name: str) -> Any:
        if name != "mode_shapes":
            raise AttributeError(f"no figure {name!r}; there is mode_shapes")
        return partial(import_module(_HOME).mode_shapes, self._modes)

    def __dir__(self) -> list[str]:
        return ["mode_shapes"]
