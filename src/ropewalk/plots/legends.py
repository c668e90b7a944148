"""Legends above axes, as wide as the figure has room for."""

from __future__ import annotations

import numpy as np
from matplotlib.axes import Axes

from ropewalk.plots.style import shorten

_SIZE = 8.0  # [pt] of the letters
_LETTER = 0.56 * _SIZE  # [pt] what one takes, on average
_HANDLE = 5.0 * _SIZE  # [pt] the line before the words, and the gaps beside them
_MARGIN = 72.0  # [pt] of the figure, beside the axes
_LINE = 1.5 * _SIZE  # [pt] from one line to the next


def legend_above(axes: Axes) -> None:
    """Draw a legend above the axes in as many columns as fit; the figure grows by its further lines."""
    handles, labels = axes.get_legend_handles_labels()
    if not labels:
        return
    figure = axes.figure.get_figure(root=True)
    width, height = figure.get_size_inches()
    room = 72.0 * width - _MARGIN
    labels = [
        shorten(label.replace(r"\$", "$"), int((room - _HANDLE) / _LETTER)) for label in labels
    ]
    columns = next(n for n in range(len(labels), 0, -1) if n == 1 or _width(labels, n) <= room)
    axes.legend(
        handles, labels, ncols=columns, fontsize=_SIZE, loc="lower left", bbox_to_anchor=(0.0, 1.0)
    )
    lines = -(-len(labels) // columns)
    figure.set_size_inches(width, height + (lines - 1) * _LINE / 72.0)


def _width(labels: list[str], columns: int) -> float:
    """Return how wide so many columns are [pt]: labels go down the first, then down the next."""
    sizes = np.array([len(label) * _LETTER + _HANDLE for label in labels])
    return float(sum(part.max() for part in np.array_split(sizes, columns)))
