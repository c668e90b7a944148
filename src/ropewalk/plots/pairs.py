"""Parameters of a sweep against each other, coloured by the result; runs that broke are crosses."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from matplotlib.figure import SubFigure
from numpy.typing import NDArray

from ropewalk.plots.style import COLOURS

Floats = NDArray[np.float64]


@dataclass(frozen=True)
class Column:
    """A parameter's values, one per run; for texts their numbers, and the texts."""

    label: str
    values: Floats
    texts: list[str] | None


def draw_pairs(
    figure: SubFigure,
    columns: list[Column],
    result: tuple[Floats, str],
    shown: NDArray[np.intp],
    broken: NDArray[np.bool_],
) -> None:
    """Draw the triangle of all pairs of parameters.

    Args:
        figure: to draw into.
        columns: the parameters, two at least.
        result: values, one per run, and their label.
        shown: runs that are drawn as points.
        broken: whether a run broke.
    """
    size = len(columns) - 1
    panels = figure.subplots(size, size, squeeze=False, sharex="col", sharey="row")
    values, label = result
    drawn = None
    for row in range(size):
        for place in range(size):
            axes = panels[row, place]
            if place > row:
                axes.set_visible(False)
                continue
            x, y = columns[place], columns[row + 1]
            drawn = axes.scatter(
                x.values[shown], y.values[shown], c=values[shown], s=9, cmap="viridis"
            )
            axes.plot(
                x.values[broken], y.values[broken], marker="x", linestyle="none", color=COLOURS[1]
            )
            if row == size - 1:
                axes.set_xlabel(x.label)
                if x.texts:
                    axes.set_xticks(range(len(x.texts)), x.texts)
            if place == 0:
                axes.set_ylabel(y.label)
                if y.texts:
                    axes.set_yticks(range(len(y.texts)), y.texts)
    assert drawn is not None
    figure.colorbar(drawn, ax=panels, label=label)
