"""Energies, works and the energy error."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure
from matplotlib.ticker import SymmetricalLogLocator

from ropewalk.lowering.layout import ROPES
from ropewalk.plots.curves import drawable, lone, mark_break, set_limits, time_limits
from ropewalk.plots.sight import Floats, good_frames
from ropewalk.plots.style import (
    COLOURS,
    GREY,
    describe,
    escape,
    new_figure,
    scaled_axis,
    set_note,
    set_title,
    styled,
)
from ropewalk.plots.torn import broken_note
from ropewalk.record.turnover import share_turned
from ropewalk.words.percents import percent
from ropewalk.words.prefixes import prefixed

if TYPE_CHECKING:
    from ropewalk.record.result import Result

_MOST_ANCHORS = 4
_SUM = "work of anchors together"
_COLOURS = {"kinetic": "#0072B2", "gravity": "#009E73", "elastic": "#E69F00"}
_COLOURS |= {"bending": "#CC79A7", "total": "#000000"}
_INNER = (
    "elastic",
    "weight",
    "bending",
)  # their works are the changes of the energies drawn anyway
_NAMES = {"applied": "applied forces"}  # of laws
#: What `laws.contact_books.ENTRIES` are, of a kind of surface.
_OF_SURFACES = {
    "motor": "work of what moves {}",
    "lift": "work of pressing up, {}",  # the motor of ropes on ropes
    "normal": "work of impacts, {}",
    "friction": "work of friction, {}",
    "stored": "given back by contacts, {}",
    "method": "error of the method, {}",
}


@styled
def energy(result: Result) -> Figure:
    """Draw the energies and works of a run, and below the energy error [J]; gravity as in `Result.energy`."""
    good = good_frames(result)
    figure = new_figure(7.2, 5.4)
    upper, lower = figure.subplots(2, 1, sharex=True, height_ratios=(2.2, 1.0))
    curves = energy_curves(result)
    works = work_curves(result, good)
    every = [*curves.values(), *works.values()]
    for name, values in curves.items():
        width = 1.9 if name == "total" else 1.3
        upper.plot(
            result.time,
            drawable(values, good, every),
            label=name,
            color=_COLOURS[name],
            linewidth=width,
            **lone(result),
        )
    dashes = ((0, (4, 2)), (0, (1, 1.5)), (0, (6, 2, 1, 2)))
    for number, (name, values) in enumerate(works.items()):
        style = {"color": (*COLOURS[1:6:2], GREY)[number % 4], "linestyle": dashes[number % 3]}
        upper.plot(result.time, drawable(values, good, every), label=name, **style, **lone(result))
    scaled_axis(upper, "energy", "J", set_limits(upper, every, good))
    if good < len(result.time):
        _break_scale(upper, every, good, 5)
    upper.axhline(0.0, color="#808080", linewidth=0.6, zorder=0.5)
    upper.legend(loc="upper left", bbox_to_anchor=(1.01, 1.02), borderaxespad=0.0)
    notes = broken_note(result, good) + _draw_error(lower, result, curves, good)
    for axes in (upper, lower):
        mark_break(axes, result, good)
    lower.set_xlim(*time_limits(result, good))
    lower.set_xlabel("time [s]")
    figure.align_ylabels()
    set_title(figure, f"{result.scene.name}: energy", describe(result))
    set_note(figure, notes)
    return figure


def _draw_error(axes: Axes, result: Result, curves: dict[str, Floats], good: int) -> list[str]:
    """Draw the energy error; return what to say of it."""
    with np.errstate(all="ignore"):
        error = np.asarray(result.energy_error)
    least, most = (np.asarray(bound) for bound in result.energy_errors.T)
    resting = result.status == "at rest"
    if resting or not np.isfinite(error[:good]).any():
        why = "an equilibrium has no energy error" if resting else "this run kept no energy ledger"
        axes.text(0.5, 0.5, why, transform=axes.transAxes, ha="center", color=GREY)
        axes.set_ylabel("energy error [J]")
        return []
    axes.fill_between(
        result.time,
        drawable(least, good),
        drawable(most, good),
        color=COLOURS[1],
        alpha=0.3,
        linewidth=0.0,
    )
    axes.plot(
        result.time, drawable(error, good), color=COLOURS[1], label="energy error", **lone(result)
    )
    axes.axhline(0.0, color="#808080", linewidth=0.6, zorder=0.5)
    scaled_axis(axes, "energy error", "J", set_limits(axes, [error, least, most], good, 0.1))
    if good < len(result.time):
        _break_scale(axes, [error, least, most], good, 3)
    worst, part = float(np.nanmax(np.abs(result.energy_errors[:good]))), share_turned(result)
    share = "" if np.isnan(part) else f" ({_share(part)} of the energy turned over)"
    most_told = prefixed(worst, "J", 3)
    said = f"Energy error: total energy less its start and all works; at most {most_told}{share}."
    if result.has_extremes:
        said += " The band has every step."
    return (
        [said, "Gravity's energy is 0 in the scene's own shape."] if "gravity" in curves else [said]
    )


def _share(part: float) -> str:
    """Return a share in words, from per cent."""
    return percent(part, 3) if part < 1000.0 else "many times"


def _break_scale(axes: Axes, curves: list[Floats], good: int, ticks: int) -> None:
    """Draw what grows to a break on a logarithmic scale, linear below what is usual before."""
    sizes = np.abs(np.array([curve[:good] for curve in curves])).max(axis=0)
    usual, most = float(np.median(sizes)), float(sizes.max())
    if most > 50.0 * usual > 0.0:
        low = min(float(curve[:good].min()) for curve in curves)
        least = 10.0 ** np.floor(np.log10(usual))
        axes.set_yscale("symlog", linthresh=least, linscale=1.5)
        places = SymmetricalLogLocator(base=10.0, linthresh=least)
        places.set_params(numticks=ticks)
        axes.yaxis.set_major_locator(places)
        axes.set_ylim(-10.0 * usual if low < 0.0 else -usual, 10.0 * most)
        axes.set_ylabel(axes.get_ylabel().split(" [")[0] + " [J]")


def energy_curves(result: Result) -> dict[str, Floats]:
    """Return kinetic, gravity (0 in the scene's own shape), elastic, bending and total energy [J], (f,) each.

    Gravity without gravity and bending without stiffness are left out.
    """
    energies = result.energy
    with np.errstate(all="ignore"):
        gravity = np.asarray(energies["gravity"])
        kinetic, elastic = np.asarray(energies["kinetic"]), np.asarray(energies["elastic"])
        parts = {"kinetic": kinetic, "gravity": gravity, "elastic": elastic}
        if "bending" in energies:
            parts["bending"] = np.asarray(energies["bending"])
        parts["total"] = np.sum(list(parts.values()), axis=0)
    if not any(result.scene.gravity):
        del parts["gravity"]
    return parts


def surface_curves(result: Result, law: str, good: int) -> dict[str, Floats]:
    """Return what motors, pressing and friction of the surfaces of a law have done, with what is stored [J].

    Empty where this is not known, of other laws and of runs of before.
    """
    if law not in ("obstacle", "contact"):
        return {}
    found: dict[str, Floats] = {}
    for surface, entries in result.contact_work.items():
        if (surface == ROPES) != (law == "contact"):
            continue
        for entry, values in entries.items():
            ropes = surface == ROPES
            label = _OF_SURFACES["lift" if ropes and entry == "motor" else entry].format(
                "ropes on ropes" if ropes else "obstacles"
            )
            found[label] = found.get(label, 0.0) + values
    return {label: values for label, values in found.items() if np.nan_to_num(values[:good]).any()}


def work_curves(result: Result, good: int) -> dict[str, Floats]:
    """Return the works [J] of what acts, by label: friction, air, ground, anchors that move and so on."""
    found: dict[str, Floats] = {}
    anchors: dict[str, Floats] = {}
    for name, values in result.work.items():
        part = np.asarray(values)
        if name in _INNER or not np.nan_to_num(part[:good]).any():  # NaN: no ledger
            continue
        if name.startswith("anchor:"):
            anchors[f"work of anchor {escape(name.removeprefix('anchor:'))}"] = part
        else:
            found |= surface_curves(result, name, good) or {
                f"work of {_NAMES.get(name, name)}": part
            }
    if len(anchors) > _MOST_ANCHORS:
        with np.errstate(all="ignore"):
            anchors = {_SUM: np.sum(list(anchors.values()), axis=0)}
    return found | anchors
