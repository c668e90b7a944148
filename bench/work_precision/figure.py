"""Error against time: a figure per case."""

from __future__ import annotations

from pathlib import Path

import matplotlib as mpl
from matplotlib.ticker import LogLocator, NullFormatter

from bench.work_precision.curves import contestants, points_of
from bench.work_precision.measure import Point
from bench.work_precision.scenes import Case
from ropewalk.methods.registry import METHODS
from ropewalk.plots.style import COLOURS, GREY, new_figure, styled

MARKERS = "osD^vP*Xhd"
SCIPY_MARKERS = {"LSODA": "o", "Radau": "s", "BDF": "^"}
LOWEST, HIGHEST = 1e-10, 1.0  # [m]


def looks(family: str, name: str) -> dict[str, object]:
    """Return colour, line and marker: colour by method of ours, grey for all others."""
    if family == "scipy":
        marker = {"marker": SCIPY_MARKERS.get(name, "D"), "mfc": "white", "ms": 5.0}
        return {"color": GREY, "ls": ":", "lw": 1.1, **marker}
    if family == "numpy":
        return {"color": "black", "ls": "--", "lw": 1.1, "marker": "x", "ms": 4.5}
    place = list(METHODS).index(name)
    implicit = METHODS[name].implicit
    return {
        "color": COLOURS[place % len(COLOURS)],
        "ls": "-" if implicit else "--",
        "marker": MARKERS[place % len(MARKERS)],
        "ms": 4.5,
        "lw": 1.8 if implicit else 1.1,
    }


@styled
def draw(case: Case, points: list[Point], path: Path) -> None:
    """Write the figure of a case as SVG."""
    figure = new_figure(7.6, 4.3)
    axes = figure.subplots()
    for family, name in contestants(points, case.name):
        own = [p for p in points_of(points, case.name, family, name) if p.error <= HIGHEST]
        if not own:
            continue
        times, errors = [1e3 * p.seconds for p in own], [p.error for p in own]
        label = name if family == "ropewalk" else f"{family}: {name}"
        axes.plot(times, errors, label=label, **looks(family, name))
    axes.set_xscale("log")
    axes.set_yscale("log")
    axes.set_ylim(LOWEST, HIGHEST)
    axes.yaxis.set_major_locator(LogLocator(numticks=12))
    axes.yaxis.set_minor_formatter(NullFormatter())
    axes.set_xlabel(f"computing time for {case.duration:g} s [ms]")
    axes.set_ylabel("error at the end [m]")
    axes.set_title(case.title, loc="left")
    figure.legend(loc="outside right upper", handlelength=3.2)
    with mpl.rc_context({"svg.hashsalt": "ropewalk", "svg.fonttype": "path"}):
        figure.savefig(path, metadata={"Date": None})
