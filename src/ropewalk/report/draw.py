"""Figures of the claims: one look, units on every axis, no state kept in pyplot."""

from __future__ import annotations

import base64
import io
from typing import Any

import matplotlib as mpl
from matplotlib.axes import Axes
from matplotlib.figure import Figure

# Colours that can be told apart with colour-blind eyes and in print (Okabe and Ito, 2008).
BLUE, ORANGE, GREEN, RED, PURPLE, SKY, GREY = (
    "#0072b2",
    "#d55e00",
    "#009e73",
    "#b2182b",
    "#9a4f96",
    "#56b4e9",
    "#6b7280",
)
SERIES = (BLUE, ORANGE, GREEN, PURPLE, SKY, RED)
_STYLE: Any = {
    "font.size": 9.5,
    "axes.titlesize": 10.5,
    "axes.spines.top": False,
    "axes.spines.right": False,
    "axes.grid": True,
    "axes.axisbelow": True,
    "grid.color": "#e3e6ea",
    "legend.frameon": False,
    "lines.linewidth": 1.6,
    "svg.hashsalt": "ropewalk",
    "svg.fonttype": "path",
    "path.simplify_threshold": 0.3,
}


def axes(
    columns: int = 1, rows: int = 1, height: float = 3.0, **options: Any
) -> tuple[Figure, Any]:
    """Return a figure and its axes (one, or an array of them)."""
    with mpl.rc_context(_STYLE):
        figure = Figure(figsize=(7.4, height), layout="constrained")
        return figure, figure.subplots(rows, columns, **options)


def label(ax: Axes, x: str, y: str, title: str = "") -> None:
    """Write axis labels (with units) and a title."""
    ax.set_xlabel(x)
    ax.set_ylabel(y)
    if title:
        ax.set_title(title, loc="left")


def legend(ax: Axes, **options: Any) -> None:
    """Put a plain legend into the axes."""
    ax.legend(frameon=False, **({"fontsize": 8.5} | options))


def below(ax: Axes, columns: int = 3) -> None:
    """Put the legend under the figure, clear of curves and labels."""
    handles, names = ax.get_legend_handles_labels()
    figure = ax.get_figure(root=True)
    assert isinstance(figure, Figure)
    figure.legend(handles, names, loc="outside lower center", ncols=columns, frameon=False)


def svg(figure: Figure) -> bytes:
    """Return a figure as SVG, the same bytes every time."""
    out = io.BytesIO()
    with mpl.rc_context(_STYLE):
        figure.savefig(out, format="svg", metadata={"Date": None}, facecolor="white")
    return out.getvalue()


def data_uri(picture: bytes) -> str:
    """Return an SVG as an address that a page can carry in itself."""
    return "data:image/svg+xml;base64," + base64.b64encode(picture).decode("ascii")
