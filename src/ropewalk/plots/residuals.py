"""The figure of a fit: what is left between prediction and measurement."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np
from matplotlib.figure import Figure

from ropewalk.plots.style import COLOURS, GREY, new_figure, scaled_axis, set_note, set_title, styled

if TYPE_CHECKING:
    from ropewalk.sweeps.calibration import Calibration

_FEW = 20  # numbers, each with a tick of its own


@styled
def residuals(fit: Calibration) -> Figure:
    """Draw predicted less measured, one panel per measurement; a good fit leaves no pattern."""
    count = len(fit.measurements)
    figure = new_figure(6.8, 2.4 * count + 1.4)
    panels = figure.subplots(count, 1, squeeze=False)[:, 0]
    for axes, measured, predicted in zip(panels, fit.measurements, fit.predicted, strict=True):
        left = predicted - measured.values
        number = np.arange(left.size)
        x = measured.at if measured.at is not None else number
        if measured.error is not None:
            axes.axhspan(-measured.error, measured.error, color=COLOURS[0], alpha=0.15, linewidth=0)
        axes.axhline(0.0, color=GREY, linewidth=0.8)
        axes.plot(x, left, marker="o", linestyle="none", color=COLOURS[0])
        largest = max(float(np.abs(left).max()), measured.error or 0.0)
        scaled_axis(axes, f"{measured.name}: residual", measured.unit, largest)
        if largest > 0.0:
            axes.set_ylim(-1.15 * largest, 1.15 * largest)  # zero in the middle
        if measured.at is None:
            axes.set_xlim(-0.6, left.size - 0.4)
            if left.size <= _FEW:
                axes.set_xticks(number)
        axes.set_xlabel(
            measured.at_name if measured.at is not None else "number of the measurement"
        )
    values = [
        f"{path} = {value:.5g} {fit.units.get(path, '')}".rstrip()
        for path, value in fit.values.items()
    ]
    set_title(figure, f"{fit.scene.name}: predicted less measured", ", ".join(values))
    band = "Band: the error of the measurement, one standard deviation. "
    known = any(m.error is not None for m in fit.measurements)
    set_note(figure, [(band if known else "") + " ".join(fit.words)])
    return figure
