"""The figure of an uncertainty: bands in time of tension, sag and anchor forces, and what they follow."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure

from ropewalk.plots.style import line_style, new_figure, scaled_axis, set_note, set_title, styled

if TYPE_CHECKING:
    from ropewalk.sweeps.uncertainty import Uncertainty

_TITLES = {"tension": "largest tension", "sag": "sag", "reactions": "anchor forces"}


@styled
def uncertainty(found: Uncertainty) -> Figure:
    """Draw the bands and, where there are any, the Sobol indices."""
    names = [n for n in _TITLES if f"{n}_max" in found.bands]
    in_time = [n for n in names if f"{n}_max_time" in found.bands]
    shown = in_time or names
    rows = len(shown)
    columns = 2 if found.sobol is not None and len(found.sobol.data_vars) else 1
    figure = new_figure(5.2 * columns + 0.6, 2.5 * rows + 0.9)
    panels = figure.subplots(rows, columns, squeeze=False)
    for row, name in enumerate(shown):
        if in_time:
            _band(panels[row, 0], found, name)
        else:
            _bars(panels[row, 0], found, name)
        if columns == 2:
            _indices(panels[row, 1], found, name)
    made = len(found.runs.run)
    title = str(found.runs.attrs.get("title", ""))
    set_title(figure, f"{title}: what is not known exactly", f"{made} runs, {found.broken} broken")
    of = "the" if found.sample == made else f"{found.sample} of the"
    notes = [f"Lines: median; bands: 5 % to 95 % of {of} runs."]
    if columns == 2:
        notes.append(
            "First Sobol index: share of the variance that would vanish if this value were known; total: "
            "share that would be left if all others were. Lines: 95 % intervals."
        )
    set_note(figure, [*notes, found.note] if found.note else notes)
    return figure


def _band(axes: Axes, found: Uncertainty, name: str) -> None:
    array = found.bands[f"{name}_max_time"]
    time = "time" if "time" in array.dims else "frame"
    x = array[time].values if time in array.coords else np.arange(array.sizes[time])
    split = [str(dim) for dim in array.dims if dim not in ("quantile", time)]
    parts = [("", array)]
    if split:
        parts = [(str(v), array.sel({split[0]: v})) for v in array[split[0]].values]
    for number, (label, part) in enumerate(parts):
        low, middle, high = part.transpose("quantile", time).values
        style = line_style(number)
        axes.fill_between(x, low, high, color=style["color"], alpha=0.25, linewidth=0.0)
        axes.plot(x, middle, label=label, **style)
    scaled_axis(axes, _TITLES[name], array.attrs["units"], float(np.nanmax(np.abs(array.values))))
    axes.set_xlabel("time [s]" if time == "time" else "frame")
    if len(parts) > 1:
        axes.legend()


def _bars(axes: Axes, found: Uncertainty, name: str) -> None:
    """Bands of an equilibrium: a line from 5 to 95 % with the median on it."""
    array = found.bands[f"{name}_max"]
    split = [str(dim) for dim in array.dims if dim != "quantile"]
    labels = [str(v) for v in array[split[0]].values] if split else [""]
    values = array.transpose("quantile", ...).values.reshape(3, -1)
    for place, (low, middle, high) in enumerate(values.T):
        style: dict[str, Any] = line_style(place)
        axes.plot([place, place], [low, high], linewidth=6, alpha=0.35, color=style["color"])
        axes.plot(place, middle, marker="o", color=style["color"])
    axes.set_xticks(range(len(labels)), labels)
    axes.set_xlim(-0.6, len(labels) - 0.4)
    scaled_axis(axes, _TITLES[name], array.attrs["units"], float(np.nanmax(np.abs(values))))


def _indices(axes: Axes, found: Uncertainty, name: str) -> None:
    assert found.sobol is not None
    mine = [str(n) for n in found.sobol.data_vars if str(n).startswith(f"{name}_max")]
    mine = [n for n in mine if not n.endswith("_ci")]
    if not mine:
        axes.set_visible(False)
        return
    largest = max(mine, key=lambda n: _median(found, n))
    array, half = found.sobol[largest], found.sobol[f"{largest}_ci"]
    names = [str(v) for v in array.parameter.values]
    places = np.arange(len(names))
    for number, order in enumerate(("total", "first")):
        values, error = array.sel(order=order).values, half.sel(order=order).values
        at = places + (0.19 if number == 0 else -0.19)
        style = line_style(number)
        axes.barh(at, values, height=0.36, color=style["color"], label=order)
        axes.errorbar(values, at, xerr=error, fmt="none", ecolor="#404040", elinewidth=1.0)
    axes.set_yticks(places, names)
    low = float(np.nanmin(array.values - half.values, initial=0.0))
    high = float(np.nanmax(array.values + half.values, initial=1.1))
    axes.set_xlim(1.05 * low, 1.05 * high)  # the whole intervals, wide as they may be
    axes.set_xlabel(f"Sobol index of {largest} [1]")
    axes.legend(loc="lower right", bbox_to_anchor=(1.0, 1.0), ncols=2, borderpad=0.0)


def _median(found: Uncertainty, name: str) -> float:
    for title, _, _, middle, _ in found.table():
        if title == name:
            return middle
    return 0.0
