"""A result's way to the figures, which are imported when one is drawn."""

from __future__ import annotations

from collections.abc import Sequence
from functools import partial
from importlib import import_module
from typing import TYPE_CHECKING, Any

from ropewalk.words.annotations import unquoted

if TYPE_CHECKING:
    from matplotlib.figure import Figure

    from ropewalk.record.result import Result

_HOME = "ropewalk.plots"  # a layer above this one, so it is looked up by name when it is needed


@unquoted
class Plots:
    """The figures of one result, as methods. Each returns a matplotlib Figure.

    A figure is shown by a notebook, and `figure.savefig("name.svg")` keeps it.
    """

    def __init__(self, result: Result) -> None:
        self._result = result

    def shape(self, times: Sequence[float] | None = None, *, plane: str | None = None) -> Figure:
        """Draw the ropes at some `times` [s] (default: six, and where a run breaks two beyond).

        `plane` names the two axes to look at, as "xz"; by default those that show most.

        Raises ValueError for times outside the run and for a plane that is none.
        """
        return self._draw("shape", times, plane=plane)

    def film(self, frames: int | Sequence[int] = 12, *, plane: str | None = None) -> Figure:
        """Draw the ropes over time as a strip of pictures.

        `frames` is how many pictures, spread over the run, or which frames; `plane` names the two axes
        to look at, as "xz".

        Raises ValueError for frames that are not there and for a plane that is none.
        """
        return self._draw("film", frames, plane=plane)

    def height(self, nodes: Sequence[int | str | tuple[str, int]] | None = None) -> Figure:
        """Draw the height [m] of some nodes against time (default: free ends and middles).

        One of `nodes` is a number (negative: from the end) of the first rope, ("rope", 5) or "rope:5".

        Raises ValueError for a node that is not there.
        """
        return self._draw("height", nodes)

    def tension(
        self, times: Sequence[float] | None = None, *, ropes: Sequence[str] | None = None
    ) -> Figure:
        """Draw the tension [N] along the ropes and in time as a heat map, and at some `times` [s].

        `ropes` names those to draw.

        Raises ValueError for times outside the run and ropes that are not there.
        """
        return self._draw("tension", times, ropes=ropes)

    def energy(self) -> Figure:
        """Draw energies, works and the energy error [J] against time."""
        return self._draw("energy")

    def phase(
        self, node: int | str | tuple[str, int] | None = None, axis: str | None = None
    ) -> Figure:
        """Draw velocity [m/s] against position [m] of one node (default: a free end, or a middle).

        `axis` is "x", "y", "z" or "up" (default: the one along which the node moves most).

        Raises ValueError for a node or an axis that is not there.
        """
        return self._draw("phase", node, axis)

    def reactions(self, *, on_anchors: bool = False) -> Figure:
        """Draw the force of each anchor on its rope [N] against time: components and size.

        With `on_anchors` that of the rope on the anchor, the opposite one, as sheets have it.
        """
        return self._draw("reactions", on_anchors=on_anchors)

    def forces(self, *, plane: str | None = None) -> Figure:
        """Draw the last frame: shape, anchors' forces [N], and the tension [N] along the ropes.

        Of an equilibrium it is the only one, of a broken run the last good one. `plane` names the two
        axes to look at, as "xz".

        Raises ValueError for a plane that is none.
        """
        return self._draw("forces", plane=plane)

    def contact(self, time: float | None = None) -> Figure:
        """Draw the forces of contacts on the nodes, and the tension, along the ropes at a `time` [s].

        By default the last frame, or the last good one. Along a wrap round a bar the dashed line is
        T0 exp(mu s / R) from the slack side on (Euler, Eytelwein), with how far the recorded rope has turned
        as s / R: a rope that sticks lies below, one that slips on it, but for its weight, which the formula
        leaves out.

        Raises ValueError for a run without recorded contact forces, and for a time outside it.
        """
        return self._draw("contact", time)

    def sticking(self) -> Figure:
        """Draw which nodes stick and which slip, on obstacles and on ropes, against time.

        Of a segment that lies on another rope both nodes are coloured. Raises ValueError for a run in which
        nothing can touch anything, or whose contact forces were not recorded.
        """
        return self._draw("sticking")

    def _draw(self, name: str, *args: Any, **options: Any) -> Figure:
        figure: Figure = getattr(import_module(_HOME), name)(self._result, *args, **options)
        return figure

    def __dir__(self) -> list[str]:
        return [name for name in vars(Plots) if not name.startswith("_")]

    def __repr__(self) -> str:
        return f"Figures of {self._result.scene.name!r}: {', '.join(self.__dir__())}."

    if not TYPE_CHECKING:

        def __getattr__(self, name: str) -> object:
            if name.startswith("_"):
                raise AttributeError(name)
            if drawn := import_module(_HOME).PLOTS.get(name):  # a figure without a method here
                return partial(drawn.draw, self._result)
            raise AttributeError(f"no figure {name!r}; there is {', '.join(self.__dir__())}")
