"""Figures of sweeps: lines for one parameter, a map for two, pairs for more, a band in time."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure
from numpy.typing import NDArray

from ropewalk.plots.pairs import Column, draw_pairs
from ropewalk.plots.ranks import by_factors, rank_correlation
from ropewalk.plots.style import (
    COLOURS,
    FAINT,
    line_style,
    new_figure,
    scaled_axis,
    set_note,
    set_title,
    styled,
    wrap,
)
from ropewalk.plots.sweep_notes import notes_of_runs
from ropewalk.sweeps.derived import BY_LABEL
from ropewalk.sweeps.designs import plain_rows

if TYPE_CHECKING:
    import xarray as xr

Floats = NDArray[np.float64]
BAND = (0.05, 0.5, 0.95)
_MOST_PANELS = 12
_LETTERS = 42  # in a line of the label of an axis
_FEW = 5  # values, each with a tick of its own
#: Room that a tick's text takes up, as shares of a map's sides: a letter and a gap across, a line down.
_LETTER, _GAP, _LINE = 0.024, 0.03, 0.06
_MOST_POINTS = 5000
_MOST_LINES = 100  # runs drawn one by one
_MOST_PAIRED = 5  # parameters drawn against each other: those that the result follows most


@styled
def sweep(data: xr.Dataset, variable: str | None = None) -> Figure:
    """Draw one thing that a sweep kept, in the way that suits its parameters.

    Along time: the band that holds 90 % of the runs. Else lines against one parameter, a map over a grid
    of two, and for more one panel per parameter and a pair plot. Broken runs are marked.

    Args:
        data: what `rw.sweep` returned.
        variable: name of what was kept; default: the first that can be drawn.

    Raises ValueError for a name that is not there, or something that cannot be drawn.
    """
    names = drawable(data)
    if not names:
        raise ValueError(
            "nothing that this sweep kept can be drawn; keep maxima, or [time] of them"
        )
    name = variable or names[0]
    if name not in names:
        raise ValueError(f"cannot draw {name!r}; there is {', '.join(names)}")
    along = _own_dims(data, name)
    if {"time", "frame"} & set(along):
        return _band(data, name)
    parameters = _parameters(data)
    if "run" not in data[name].dims and len(parameters) == 2:
        return _map(data, name, parameters)
    if len(parameters) == 1:
        return _lines(data, name, parameters[0])
    return _panels(data, name, parameters)


def drawable(data: xr.Dataset) -> list[str]:
    """Return the names of what can be drawn: numbers per run, per anchor or rope, and along time."""
    found = []
    for name in map(str, data.data_vars):
        along = set(_own_dims(data, name))
        kept = "keep" in data[name].attrs
        if kept and along <= {"time", "frame", "form", *BY_LABEL}:
            found.append(name)
    return found


def _parameters(data: xr.Dataset) -> list[str]:
    return [str(name) for name in data.coords if "path" in data[name].attrs]


def _own_dims(data: xr.Dataset, name: str) -> list[str]:
    """Return the dimensions of a variable that are not the sweep's."""
    swept = {"run", *_parameters(data)}
    return [str(dim) for dim in data[name].dims if dim not in swept]


def _parts(data: xr.Dataset, name: str) -> list[tuple[str, xr.DataArray]]:
    """Return a variable anchor by anchor (or rope by rope), each with its label."""
    array = data[name]
    split = [dim for dim in _own_dims(data, name) if dim in ("form", *BY_LABEL)]
    if not split:
        return [("", array)]
    (dim,) = split
    return [(str(label), array.sel({dim: label})) for label in data[dim].values]


def _title(figure: Figure, data: xr.Dataset, name: str) -> None:
    status = _texts(data.status)
    broken = int((~np.isin(status, ["finished", "at rest", ""])).sum())
    made = int((status != "").sum())
    of = f"{made} runs" if made == status.size else f"{made} of {status.size} runs so far"
    seed = f", seed {data.attrs['seed']}" if "seed" in data.attrs else ""
    told = f"{data.attrs.get('title', '')}: {data.attrs['design']}{seed}, {of}"
    set_title(
        figure, data[name].attrs["long_name"], told + (f", {broken} broken" if broken else "")
    )


def _short(words: str) -> str:
    """Return a long name without its end, as in ", over all steps"; commas of places in it stay."""
    for end in (", over", ", at rest"):
        words = words.rpartition(end)[0] or words
    return words


def _label(array: xr.DataArray) -> str:
    unit = array.attrs.get("units", "")
    words = array.attrs.get("long_name", array.name)
    return _wrapped(f"{words} [{unit}]" if unit and unit != "1" else str(words))


def _wrapped(label: str) -> str:
    """Return the label of an axis in lines that it has room for."""
    return "\n".join(wrap(label, _LETTERS))


def _axis(axes: Axes, array: xr.DataArray, values: Floats, which: str = "x") -> None:
    """Label an axis by a parameter; logarithmic where its values rise by factors."""
    getattr(axes, f"set_{which}label")(_label(array))
    if by_factors(values):
        getattr(axes, f"set_{which}scale")("log")


def _numbers(array: xr.DataArray) -> tuple[Floats, list[str] | None]:
    """Return a parameter's values as numbers; texts are counted, and are the labels."""
    values = array.values
    if values.dtype.kind in "fiu":
        return values.astype(np.float64), None
    texts = _texts(array).tolist()
    labels = list(dict.fromkeys(texts))
    return np.array([labels.index(text) for text in texts], dtype=np.float64), labels


def _texts(array: xr.DataArray) -> NDArray[np.str_]:
    return np.array(array.values.ravel().tolist(), dtype=str).reshape(array.shape)


def _lines(data: xr.Dataset, name: str, parameter: str) -> Figure:
    figure = new_figure(6.4, 4.2)
    axes = figure.subplots()
    x, labels = _numbers(data[parameter])
    order = np.argsort(x, kind="stable")
    largest = 0.0
    parts = _parts(data, name)
    for number, (label, part) in enumerate(parts):
        y = part.values.astype(np.float64)
        largest = max(largest, float(np.nanmax(np.abs(y), initial=0.0)))
        style = line_style(number) | (
            {"linestyle": "none"} if labels else {}
        )  # nothing lies between
        few = len(np.unique(x)) <= 60 or labels
        axes.plot(x[order], y[order], marker="o" if few else "", label=label, **style)
    _mark_broken(axes, x[_is_broken(data)])
    scaled_axis(
        axes, _wrapped(_short(data[name].attrs["long_name"])), data[name].attrs["units"], largest
    )
    _axis(axes, data[parameter], x)
    if labels:
        axes.set_xticks(range(len(labels)), labels)
    if len(parts) > 1:
        axes.legend()
    set_note(figure, notes_of_runs(data))
    _title(figure, data, name)
    return figure


def _is_broken(data: xr.Dataset) -> NDArray[np.bool_]:
    status = _texts(data.status)
    return np.asarray(~np.isin(status, ["finished", "at rest", ""]))


def _mark_broken(axes: Axes, x: Floats) -> None:
    """Mark runs without a value on the axis itself: above it a mark would have one."""
    if len(x):
        foot = axes.get_xaxis_transform()
        style: dict[str, Any] = {"color": COLOURS[1], "linestyle": "none", "clip_on": False}
        axes.plot(
            x, np.zeros(len(x)), marker="x", transform=foot, label="broken, no value", **style
        )
        axes.legend()


def _map(data: xr.Dataset, name: str, parameters: list[str]) -> Figure:
    parts = _parts(data, name)
    figure = new_figure(5.4 * len(parts) if len(parts) > 1 else 6.4, 4.6)
    panels = np.atleast_1d(figure.subplots(1, len(parts)))
    (x, x_labels), (y, y_labels) = (_numbers(data[p]) for p in parameters)
    order = np.ix_(np.argsort(x, kind="stable"), np.argsort(y, kind="stable"))
    x, y = np.sort(x), np.sort(y)
    broken = _is_broken(data)[order]
    for axes, (label, part) in zip(panels, parts, strict=True):
        values = part.values.astype(np.float64)[order]
        axes.grid(False)
        axes.set_facecolor(FAINT)
        _axis(axes, data[parameters[0]], x)
        _axis(axes, data[parameters[1]], y, "y")
        edges = _edges(x, axes.get_xscale()), _edges(y, axes.get_yscale())
        drawn = axes.pcolormesh(*edges, values.T, cmap="viridis")
        words = _short(data[name].attrs["long_name"])
        figure.colorbar(drawn, ax=axes, label=_wrapped(f"{words} [{data[name].attrs['units']}]"))
        for i, j in np.argwhere(broken):
            axes.plot(x[i], y[j], marker="x", color=COLOURS[1])
        for labels, set_ticks in ((x_labels, axes.set_xticks), (y_labels, axes.set_yticks)):
            if labels:
                set_ticks(range(len(labels)), labels)
        sides = ((x, x_labels, axes.xaxis, edges[0]), (y, y_labels, axes.yaxis, edges[1]))
        for values_there, labels, axis, ends in sides:
            if not labels and len(values_there) <= _FEW:  # at the cells, not somewhere in them
                texts = [_told(value) for value in values_there]
                room = max(map(len, texts)) * _LETTER + _GAP if axis is axes.xaxis else _LINE
                told = _apart(values_there, ends, axis.get_scale(), room)
                axis.set_ticks(values_there, [t if i in told else "" for i, t in enumerate(texts)])
                axis.set_ticks([], minor=True)
        if label:
            axes.set_title(label)
    crosses = ["Crosses on grey: runs that broke."] if broken.any() else []
    set_note(figure, crosses + notes_of_runs(data))
    _title(figure, data, name)
    return figure


def _told(value: float) -> str:
    """Return a number to five digits, without a power of ten where it is not long."""
    text = f"{value:.5g}"
    if not 1e-4 <= abs(value) < 1e7:
        return text
    return np.format_float_positional(float(text), trim="-")


def _edges(centres: Floats, scale: str) -> Floats:
    """Return the edges of cells about centres."""
    at = np.log(centres) if scale == "log" else centres
    if len(at) == 1:
        edges = np.array([at[0] - 0.5, at[0] + 0.5])
    else:
        middle = 0.5 * (at[1:] + at[:-1])
        edges = np.concatenate([[2 * at[0] - middle[0]], middle, [2 * at[-1] - middle[-1]]])
    return np.asarray(np.exp(edges) if scale == "log" else edges)


def _apart(values: Floats, edges: Floats, scale: str, room: float) -> set[int]:
    """Return which sorted values can be told beside an axis: both ends, and what stands clear of the rest.

    A text takes up `room` as a share of the axis, which goes from the first edge to the last.
    """
    at, ends = (np.log(a) if scale == "log" else a for a in (values, edges))
    places = (at - ends[0]) / (ends[-1] - ends[0])
    told = {0, len(values) - 1}
    for number, place in enumerate(places):
        if all(abs(place - places[other]) >= room for other in told):
            told.add(number)
    return told


def _panels(data: xr.Dataset, name: str, parameters: list[str]) -> Figure:
    """One panel per parameter, coloured by another one: what moves the result, and with what; then pairs."""
    table = data if "run" in data[name].dims else _table(data, parameters)
    shown = parameters[:_MOST_PANELS]
    columns = 2 if len(shown) in (2, 4) else min(3, len(shown))
    rows = -(-len(shown) // columns)
    paired = min(len(parameters), _MOST_PAIRED)
    heights = 3.0 * rows, 2.2 * (paired - 1) + 0.4
    figure = new_figure(3.3 * columns + 0.6, sum(heights) + 0.7)
    top, foot = figure.subfigures(2, 1, squeeze=False, height_ratios=heights)[:, 0]
    panels = top.subplots(rows, columns, squeeze=False, sharey=True)
    parts = _parts(table, name)
    y = np.max([part.values for _, part in parts], axis=0).astype(np.float64)
    good = np.isfinite(y)
    step = max(1, int(good.sum()) // _MOST_POINTS)
    xs = {p: _numbers(table[p]) for p in parameters}
    words = _short(data[name].attrs["long_name"])
    strongest = max(parameters, key=lambda p: rank_correlation(xs[p][0][good], y[good]))
    for place, (axes, parameter) in enumerate(zip(panels.flat, shown, strict=False)):
        x, labels = xs[parameter]
        by = strongest if parameter != strongest else _next(parameters, strongest, xs, y, good)
        colour = xs[by][0]
        drawn = axes.scatter(
            x[good][::step], y[good][::step], c=colour[good][::step], s=9, cmap="viridis"
        )
        top.colorbar(drawn, ax=axes, label=f"{by} [{table[by].attrs.get('units', '1')}]")
        _mark_broken(axes, x[_is_broken(table)])
        axes.set_xlabel(f"{parameter} [{table[parameter].attrs.get('units', '1')}]")
        if labels:
            axes.set_xticks(range(len(labels)), labels)
        if place % columns == 0:
            axes.set_ylabel(f"{words} [{data[name].attrs['units']}]")
    for axes in list(panels.flat)[len(shown) :]:
        axes.set_visible(False)
    strong = sorted(parameters, key=lambda p: -rank_correlation(xs[p][0][good], y[good]))[:paired]
    pairs = [
        Column(f"{p} [{table[p].attrs.get('units', '1')}]", *xs[p])
        for p in parameters
        if p in strong
    ]
    told = f"{words} [{data[name].attrs['units']}]"
    draw_pairs(foot, pairs, (y, told), np.flatnonzero(good)[::step], _is_broken(table))
    notes = [
        "Above, colours: another parameter, the one that the result follows most. "
        "Below: parameters against each other, coloured by the result; crosses: runs that broke."
    ]
    if len(parameters) > paired:
        notes.append(f"Pairs of the {paired} parameters that the result follows most.")
    if len(parts) > 1:
        notes.append(f"The largest of {', '.join(label for label, _ in parts)}.")
    set_note(figure, notes + notes_of_runs(data))
    _title(figure, data, name)
    return figure


def _next(
    parameters: list[str], but: str, xs: dict[str, Any], y: Floats, good: NDArray[np.bool_]
) -> str:
    others = [p for p in parameters if p != but]
    return max(others, key=lambda p: rank_correlation(xs[p][0][good], y[good]))


def _table(data: xr.Dataset, parameters: list[str]) -> xr.Dataset:
    """Return a grid as a table of runs."""
    about = {name: data[name].attrs for name in parameters}
    flat = data.drop_vars("run").stack(run=parameters).reset_index("run")
    for name, told in about.items():
        flat[name].attrs.update(told)
    return flat


def _band(data: xr.Dataset, name: str) -> Figure:
    """The median and the band that holds 90 % of the runs, against time; single runs against frames.

    Where runs have frames at different times their numbers are nothing to compare runs by.
    """
    whole = data
    if "run" in data[name].dims:
        data = data.isel(run=plain_rows(data.attrs["design"], len(_parameters(data))))
    parts = _parts(data, name)
    figure = new_figure(7.0, 4.2)
    axes = figure.subplots()
    time = "time" if "time" in data[name].dims else "frame"
    x = data[time].values if time in data.coords else np.arange(data.sizes[time])
    largest, of, together = 0.0, 0, time == "time"
    for number, (label, part) in enumerate(parts):
        swept = [dim for dim in part.dims if dim != time]
        values = part.transpose(*swept, time).values.reshape(-1, part.sizes[time])
        values = values[np.isfinite(values).any(axis=1)]
        if not len(values):
            raise ValueError(f"cannot draw {name!r}: no run ended well")
        of = max(of, len(values))
        style = line_style(number)
        if together:
            _draw_band(axes, x, values, label, style)
        else:
            step = -(-len(values) // _MOST_LINES)
            axes.plot(x, values[::step].T, **style | {"linewidth": 0.6, "alpha": 0.5})
            axes.plot([], [], label=label, **style)
        largest = max(largest, float(np.nanmax(np.abs(values))))
    scaled_axis(
        axes, _wrapped(_short(data[name].attrs["long_name"])), data[name].attrs["units"], largest
    )
    axes.set_xlabel("time [s]" if time == "time" else "frame")
    if len(parts) > 1:
        axes.legend()
    runs, shown = f"{of} run{'s' * (of > 1)}", min(of, _MOST_LINES)
    note = f"Line: median of {runs}; band: 5 % to 95 % of them at each time."
    if not together:
        note = f"Lines: {shown} of {runs}, whose frames are at different times: no median, no band."
    set_note(figure, [note, *notes_of_runs(data)])
    _title(figure, whole, name)
    return figure


def _draw_band(
    axes: Axes, x: NDArray[Any], values: Floats, label: str, style: dict[str, Any]
) -> None:
    """Draw median and band of (runs, times) values."""
    low, middle, high = np.nanquantile(values, BAND, axis=0)
    axes.fill_between(x, low, high, color=style["color"], alpha=0.25, linewidth=0.0)
    axes.plot(x, middle, label=label, **style)
