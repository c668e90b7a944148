"""Figures of runs. Each function draws one result and returns a matplotlib Figure.

    from ropewalk import plots

    plots.save(plots.shape(result, times=[0, 1, 2]), "shape.svg")

Nothing here uses pyplot, so figures neither pile up nor need a display.
"""

from __future__ import annotations

from collections.abc import Callable
from typing import TYPE_CHECKING, NamedTuple

from matplotlib.figure import Figure

from ropewalk.plots.comparison import compare
from ropewalk.plots.contact_forces import contact
from ropewalk.plots.energies import energy
from ropewalk.plots.figure_files import FORMATS, save
from ropewalk.plots.films import film
from ropewalk.plots.forces import forces
from ropewalk.plots.heights import height
from ropewalk.plots.mode_shapes import mode_shapes
from ropewalk.plots.movies import MovieError, movie
from ropewalk.plots.phases import phase
from ropewalk.plots.reaction_forces import reactions
from ropewalk.plots.rolling import rolling
from ropewalk.plots.shape_figure import shape
from ropewalk.plots.stick_slip import sticking
from ropewalk.plots.sweeps import sweep
from ropewalk.plots.tensions import tension

if TYPE_CHECKING:
    from ropewalk.record.result import Result


def always(result: Result) -> bool:
    """Every run has it."""
    return True


def is_held(result: Result) -> bool:
    """Tell whether an anchor holds a rope."""
    return bool(result.layout.anchor_names)


def touches(result: Result) -> bool:
    """Tell whether forces of contacts were recorded."""
    return "contact_force" in result.source.names


class Plot(NamedTuple):
    """A figure that `ropewalk plot` can draw."""

    draw: Callable[..., Figure]  # takes a Result, and keywords
    description: str
    there: Callable[[Result], bool] = always  # whether there is something to draw


PLOTS: dict[str, Plot] = {
    "shape": Plot(shape, "the ropes at some times in the plane that shows most"),
    "film": Plot(film, "the ropes over time as a strip of pictures"),
    "height": Plot(height, "height of some nodes against time"),
    "tension": Plot(tension, "tension along the rope and in time, as a heat map"),
    "energy": Plot(energy, "energies, works and the energy error against time"),
    "phase": Plot(phase, "velocity against position of one node"),
    "reactions": Plot(reactions, "force of each anchor on its rope against time", is_held),
    "forces": Plot(forces, "the last frame, or the equilibrium: tension and anchors' forces"),
    "contact": Plot(contact, "forces of contacts and tension along the ropes at one time", touches),
    "sticking": Plot(sticking, "which nodes stick and which slip, against time", touches),
}
FIGURES = tuple(PLOTS)

__all__ = [
    "FIGURES",
    "FORMATS",
    "PLOTS",
    "MovieError",
    "Plot",
    "compare",
    "contact",
    "energy",
    "film",
    "forces",
    "height",
    "mode_shapes",
    "movie",
    "phase",
    "reactions",
    "rolling",
    "save",
    "shape",
    "sticking",
    "sweep",
    "tension",
]
