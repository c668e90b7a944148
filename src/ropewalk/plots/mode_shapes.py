"""Shapes of natural modes, one small picture each."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure

from ropewalk.plots.sight import Floats, Sight
from ropewalk.plots.style import COLOURS, EARTH, GREY, new_figure, set_note, set_title, styled

if TYPE_CHECKING:
    from ropewalk.vibration import Modes

_COLUMNS = 3
_MOST = 12
_SWING = 0.12  # largest displacement drawn, over the extent of what is drawn [1]


@styled
def mode_shapes(modes: Modes, *, most: int = _MOST) -> Figure:
    """Draw the shapes of the slowest modes, at most so many.

    Motion in the plane, and along the rope, is drawn in it, to both sides; motion out of the plane is
    drawn as height over the rope's own length, for it cannot be seen otherwise. A shape that lies in no
    plane is seen from the side on which it is widest.

    Raises ValueError for no modes.
    """
    count = min(modes.count, most)
    if count < 1:
        raise ValueError("modes: none - there is nothing to draw")
    sight = _sight(modes)
    rows = -(-count // _COLUMNS)
    figure = new_figure(7.6, 0.9 + 1.62 * rows)
    grid = figure.subplots(rows, _COLUMNS, squeeze=False)
    for number, axes in enumerate(grid.ravel()):
        if number >= count:
            axes.set_axis_off()
            continue
        _draw(axes, modes, sight, number)
    about = f"about its {modes.about}; grey: the shape itself, colours: half a period apart"
    set_title(figure, f"{modes.scene.name}: modes", about)
    notes = [
        f"Displacements of 1 are drawn as {100.0 * _SWING:g} % of what is widest in each picture; small "
        "motions are meant."
    ]
    if modes.count > count:
        notes.append(f"The first {count} of {modes.count} modes.")
    set_note(figure, notes)
    return figure


def _sight(modes: Modes) -> Sight:
    """Look across the plane of the shape, as far upright as it goes; of one in no plane, up upward."""
    if modes.normal is not None:
        return _sight_along(modes.normal, modes)
    points = modes.positions - modes.positions.mean(axis=0)
    up = np.array(modes.scene.up)
    level = points - np.outer(points @ up, up)
    _, sizes, ways = np.linalg.svd(level, full_matrices=False)
    across = ways[0] if sizes[0] > 1e-9 * np.abs(points).max() else _any_across(up)
    across = across * np.sign(across[int(np.argmax(np.abs(across)))])
    return Sight(across, up, "across", "up")


def _sight_along(normal: Floats, modes: Modes) -> Sight:
    """Look along the normal by which motions are told to be in the plane or out of it."""
    up = np.array(modes.scene.up)
    across = np.cross(normal, up)
    if np.linalg.norm(across) < 1e-6:  # a level plane, seen from above
        across = _any_across(normal)
    across = across / np.linalg.norm(across)
    across = across * np.sign(across[int(np.argmax(np.abs(across)))])
    upward = np.cross(normal, across)
    return Sight(across, upward * (1.0 if upward @ up >= 0.0 else -1.0), "across", "up")


def _any_across(up: Floats) -> Floats:
    axis = np.eye(3)[int(np.argmin(np.abs(up)))]
    across = axis - (axis @ up) * up
    return np.asarray(across / np.linalg.norm(across))


def _draw(axes: Axes, modes: Modes, sight: Sight, number: int) -> None:
    motion = modes.motions[number]
    shape = modes.shapes[number].real
    flat = sight.project(modes.positions)
    extent = float(np.ptp(flat, axis=0).max()) or 1.0
    moved = sight.project(shape)
    aside = np.cross(sight.across, sight.up)
    hidden = float(np.abs(shape @ aside).max()) > float(np.abs(moved).max())
    parts = [slice(span.start, span.end + 1) for span in modes.layout.ropes]
    if hidden:
        arcs = [_arc(modes.positions[part]) for part in parts]
        extent = max(float(arc[-1]) for arc in arcs) or 1.0
    for k, part in enumerate(parts):
        if hidden:
            arc = arcs[k]
            flat = np.stack([arc, np.zeros_like(arc)], axis=1)
            moved = np.stack([np.zeros_like(arc), (shape @ aside)[part]], axis=1)
        base, push = (flat, moved) if hidden else (flat[part], moved[part])
        size = _SWING * extent
        axes.plot(*base.T, color=GREY, linewidth=0.9, zorder=1)
        for sign, colour, style in ((1.0, COLOURS[0], "-"), (-1.0, COLOURS[1], "--")):
            points = base + sign * size * push
            marker = "." if motion.name == "along" else ""
            axes.plot(*points.T, color=colour, linestyle=style, marker=marker, linewidth=1.2)
    axes.set_aspect("equal", adjustable="datalim")
    axes.set_axis_off()
    frequency = modes.frequencies[number]
    ratio = modes.damping_ratios[number]
    damped = f", ζ {ratio:.2g}" if ratio > 0.0 else ""
    axes.set_title(f"{number + 1}: {frequency:.4g} Hz{damped}", loc="left", fontsize=8.5, pad=10.0)
    words = f"{motion.name}, {motion.half_waves} half wave" + (
        "s" if motion.half_waves != 1 else ""
    )
    if motion.name == "turns":
        words = f"{motion.rope} turns"
    axes.text(0.0, 1.0, words, transform=axes.transAxes, fontsize=7.5, color=EARTH, va="bottom")


def _arc(points: Floats) -> Floats:
    steps = np.linalg.norm(np.diff(points, axis=0), axis=1)
    return np.concatenate([[0.0], np.cumsum(steps)])
