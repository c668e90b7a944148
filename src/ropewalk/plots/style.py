"""How figures look: colours, type, titles, notes. Nothing here touches pyplot."""

from __future__ import annotations

import io
from collections.abc import Callable
from functools import cache, wraps
from typing import TYPE_CHECKING, Any, ParamSpec, TypeVar

import matplotlib
from matplotlib.axes import Axes
from matplotlib.colors import LinearSegmentedColormap
from matplotlib.figure import Figure
from matplotlib.layout_engine import ConstrainedLayoutEngine
from matplotlib.ticker import FuncFormatter, MaxNLocator

from ropewalk.record.facts import AT_REST
from ropewalk.words.prefixes import prefix_of

if TYPE_CHECKING:
    from ropewalk.record.result import Result

_P = ParamSpec("_P")
_R = TypeVar("_R")

# Okabe and Ito, "Color Universal Design" (2008): told apart by colour-blind readers; no yellow,
# which is lost on white paper.
COLOURS = ("#0072B2", "#D55E00", "#009E73", "#CC79A7", "#E69F00", "#56B4E9", "#000000")
BAND = {"color": "0.86", "linewidth": 0.0, "zorder": 0.5}  # between least and greatest of all steps
ALL_STEPS = "least to greatest of all steps"
DASHES = ("-", "--", "-.", ":")
GREY, FAINT, EARTH = "#5A5A5A", "#D9D9D9", "#8C7B68"

STYLE: dict[str, Any] = {
    "font.family": "sans-serif",
    "font.sans-serif": ["DejaVu Sans"],
    "font.size": 9.0,
    "axes.titlesize": 9.0,
    "axes.labelsize": 9.0,
    "axes.spines.top": False,
    "axes.spines.right": False,
    "axes.edgecolor": "#404040",
    "axes.linewidth": 0.8,
    "axes.grid": True,
    "axes.axisbelow": True,
    "axes.formatter.useoffset": False,
    "axes.formatter.limits": (-4, 5),
    "axes.unicode_minus": True,
    "grid.color": "#E6E6E6",
    "grid.linewidth": 0.6,
    "legend.frameon": False,
    "legend.fontsize": 8.5,
    "lines.linewidth": 1.4,
    "lines.markersize": 5.0,
    "path.simplify": True,
    "xtick.labelsize": 8.5,
    "ytick.labelsize": 8.5,
    "figure.dpi": 110.0,
    "savefig.dpi": 160.0,
    "figure.facecolor": "white",
    "text.usetex": False,
}

_TITLE, _SUBTITLE, _EDGE = 11.0, 8.5, 5.0  # points


class Drawing(Figure):
    """A figure that shows itself in a notebook, whether or not pyplot is in use."""

    def _repr_png_(self) -> bytes:
        buffer = io.BytesIO()
        self.savefig(buffer, format="png", dpi=110)
        return buffer.getvalue()


def styled(function: Callable[_P, _R]) -> Callable[_P, _R]:
    """Run a drawing function with this package's style, leaving the caller's settings alone."""

    @wraps(function)
    def wrapper(*args: _P.args, **kwargs: _P.kwargs) -> _R:
        with matplotlib.rc_context(_defaults() | STYLE):  # type: ignore[arg-type]
            return function(*args, **kwargs)

    return wrapper


# Settings of the session rather than of how figures look.
_NOT_LOOKS = (
    "backend",
    "interactive",
    "toolbar",
    "timezone",
    "date.",
    "webagg",
    "tk.",
    "docstring",
    "savefig.directory",
    "animation.",
    "figure.hooks",
    "figure.max_open_warning",
)


@cache
def _defaults() -> dict[str, Any]:
    """Matplotlib's own defaults of how figures look, whatever the caller has set."""
    defaults = matplotlib.rcParamsDefault
    return {key: defaults[key] for key in defaults if not key.startswith(_NOT_LOOKS)}


def new_figure(width: float, height: float) -> Drawing:
    """Return an empty figure of this size [inch] that lays itself out."""
    figure = Drawing(figsize=(width, height), layout="constrained")
    set_margins(figure)
    return figure


def set_margins(figure: Figure) -> None:
    """Keep the same margin on all sides."""
    engine = figure.get_layout_engine()
    assert isinstance(engine, ConstrainedLayoutEngine)
    engine.set(w_pad=_EDGE / 72.0, h_pad=_EDGE / 72.0)


def set_title(figure: Figure, title: str, subtitle: str) -> None:
    """Write the title in bold and below it the subtitle in grey, both cut to the figure's width."""
    width, height = figure.get_size_inches() * 72.0
    x, top = _EDGE / width, 1.0 - _EDGE / height
    letters = {size: int((width - 2 * _EDGE) / (0.56 * size)) for size in (_TITLE, _SUBTITLE)}
    text = _cut_name(title, int(0.88 * letters[_TITLE])) + "\n"  # a line kept for the subtitle
    figure.suptitle(text, x=x, ha="left", va="top", fontsize=_TITLE, fontweight="bold")
    figure.text(
        x,
        top - 1.35 * _TITLE / height,
        shorten(subtitle, letters[_SUBTITLE]),
        ha="left",
        va="top",
        fontsize=_SUBTITLE,
        color=GREY,
    )


def _cut_name(title: str, letters: int) -> str:
    """Cut a title to so many letters: of "name: what is shown" the name."""
    title = " ".join(title.split())
    name, colon, what = title.rpartition(": ")
    room = letters - len(escape(colon + what))
    return shorten(name, room) + escape(colon + what) if room > 1 else shorten(title, letters)


def set_note(figure: Figure, notes: list[str]) -> None:
    """Write remarks at the foot of the figure, wrapped to its width."""
    if not notes:
        return
    width = figure.get_size_inches()[0] * 72.0
    per_line = int((width - 2 * _EDGE) / (0.53 * 8.0))
    lines = [line for note in notes for line in wrap(note, per_line)]
    figure.supxlabel(
        "\n".join(lines), x=_EDGE / width, ha="left", fontsize=8.0, color=GREY, linespacing=1.3
    )


def shorten(text: str, letters: int) -> str:
    """Cut a text to at most so many letters, with an ellipsis."""
    text = escape(" ".join(text.split()))
    return text if len(text) <= letters else text[: max(letters - 1, 1)].rstrip() + "…"


def escape(text: str) -> str:
    """Keep dollar signs in names from starting a formula."""
    return text.replace("$", r"\$")


def wrap(text: str, letters: int) -> list[str]:
    """Break a text into lines of at most so many letters."""
    lines = [""]
    for word in text.split():
        if lines[-1] and len(lines[-1]) + 1 + len(word) > letters:
            lines.append("")
        lines[-1] += (" " if lines[-1] else "") + word
    return lines


def describe(result: Result) -> str:
    """Method, step and time of a run, for a subtitle: `verlet, 0.8 ms steps, 0 to 20 s`."""
    time = result.time
    if result.status == AT_REST:
        return method_and_step(result)
    return f"{method_and_step(result)}, {time[0]:g} to {time[-1]:.4g} s"


def method_and_step(result: Result) -> str:
    """`semi-implicit-euler, 1.852 ms steps`; or `equilibrium`, which no method has made."""
    if result.status == AT_REST:
        return "equilibrium"
    if result.plan.tolerance is not None:
        return f"{result.plan.method}, {result.plan.pace}"
    return f"{result.plan.method}, {result.plan.dt * 1e3:.4g} ms steps"


def line_style(number: int) -> dict[str, Any]:
    """Colour and dashes of the line of this number; both change, for black-and-white print."""
    return {
        "color": COLOURS[number % len(COLOURS)],
        "linestyle": DASHES[(number // len(COLOURS)) % len(DASHES)],
    }


def times_map() -> LinearSegmentedColormap:
    """Colours from early (dark) to late (light), without the end that is lost on white."""
    viridis = matplotlib.colormaps["viridis"]
    return LinearSegmentedColormap.from_list("times", [viridis(0.9 * i / 63) for i in range(64)])


def scaled_axis(axes: Axes, what: str, unit: str, largest: float) -> None:
    """Label the y axis `what [unit]` with the SI prefix that suits; the data stay in `unit`."""
    if largest < 1e-12:
        axes.set_ylabel(f"{what} [{unit}]")
        if largest > 0.0:  # round-off: powers of ten say it best
            axes.yaxis.set_major_formatter(FuncFormatter(lambda value, _: f"{value:.1e}"))
        return
    bare = unit == "1" or unit.startswith("kg")  # take no prefix
    factor, prefix = (1.0, "") if bare else prefix_of(largest)
    axes.set_ylabel(f"{what} [{prefix}{unit}]")
    axes.yaxis.set_major_locator(MaxNLocator(6, steps=[1, 2, 2.5, 5, 10]))
    axes.yaxis.set_major_formatter(FuncFormatter(lambda value, _: _plain(value / factor)))


def _plain(value: float) -> str:
    return f"{value:.6g}".replace("-", "−")
