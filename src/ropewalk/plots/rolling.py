"""A load that rolls along a line: its path, the tensions, the anchors' forces, against its place."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np
from matplotlib.figure import Figure

from ropewalk.plots.style import COLOURS, GREY, line_style, new_figure, set_note, set_title, styled
from ropewalk.rigging.words import margins
from ropewalk.scene.guess import guesses_of

if TYPE_CHECKING:
    from ropewalk.rigging import Rolling


@styled
def rolling(found: Rolling) -> Figure:
    """Draw the load's path, the largest tension and the anchors' forces against its place."""
    line, x = found.line, found.place
    figure = new_figure(7.2, 6.6)
    path, pull, anchors = figure.subplots(3, 1, sharex=True)
    shape = line.cable.position(np.linspace(0.0, line.length, 200))
    path.plot(*shape.T, color=GREY, linewidth=1.0, label="the line without the load")
    path.plot(x, found.height, color=COLOURS[0], label="where the load is")
    path.set_ylabel("height [m]")
    path.legend()
    pull.plot(x, 1e-3 * found.largest_tension, color=COLOURS[1], label="largest in the line")
    load = line.material.breaking_load
    if load is not None:
        share = pull.secondary_yaxis(
            "right", functions=(lambda kN: 1e5 * kN / load, lambda percent: 1e-5 * percent * load)
        )
        mark = guesses_of(line.material).get("breaking_load")
        share.set_ylabel("of the breaking load [%]" if mark is None else "of a guessed load [%]")
    pull.set_ylabel("tension [kN]")
    pull.set_ylim(bottom=0.0)
    pull.legend()
    number = 0
    for name, forces in (("first", found.anchor_start), ("second", found.anchor_end)):
        for k, way in enumerate(("across", "up")):
            label = f"{name} anchor, {way}"
            anchors.plot(x, 1e-3 * forces[:, k], label=label, **line_style(number))
            number += 1
    anchors.set_ylabel("force on the rope [kN]")
    anchors.set_xlabel("place of the load [m]")
    anchors.legend(ncols=4, fontsize=8.0, loc="lower left", bbox_to_anchor=(0.0, 1.0))
    made_of = line.material.library or f"EA {line.material.EA:.4g} N"
    how = "held by the rope" if found.held else "rolling free, held in its place"
    set_title(figure, f"{found.mass:.4g} kg along a line of {line.span:.4g} m", f"{made_of}; {how}")
    notes = ["At rest at each place: a load that runs, bounces or is braked pulls harder."]
    if load is not None:
        (text,) = margins(float(found.largest_tension.max()), line.material)
        notes.append(f"{text[0].upper()}{text[1:]}.")
    set_note(figure, notes)
    return figure
