"""The way from modes to their figures, which are imported when one is drawn."""

from __future__ import annotations

from importlib import import_module
from typing import TYPE_CHECKING

from ropewalk.words.annotations import unquoted

if TYPE_CHECKING:
    from matplotlib.figure import Figure

    from ropewalk.vibration.modes import Modes

_HOME = "ropewalk.plots"  # a layer above this one, so it is looked up by name when it is needed


@unquoted
class ModePlots:
    """The figures of modes, as methods. Each returns a matplotlib Figure."""

    def __init__(self, modes: Modes) -> None:
        self._modes = modes

    def mode_shapes(self, *, most: int = 12) -> Figure:
        """Draw the shapes of the slowest modes, at most so many.

        Motion out of the plane of the ropes is drawn as height over the rope's own length.

        Raises ValueError for no modes.
        """
        figure: Figure = import_module(_HOME).mode_shapes(self._modes, most=most)
        return figure

    def __dir__(self) -> list[str]:
        return ["mode_shapes"]

    if not TYPE_CHECKING:

        def __getattr__(self, name: str) -> object:
            raise AttributeError(f"no figure {name!r}; there is mode_shapes")
