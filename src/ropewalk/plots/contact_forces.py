"""What obstacles do to ropes: forces along the rope, and the tension along a wrap against Euler's formula."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure

from ropewalk.lowering.touching import stretches
from ropewalk.plots.arcs import arc_label, node_arcs, segment_arcs
from ropewalk.plots.sight import Floats, frame_at, good_frames
from ropewalk.plots.style import (
    GREY,
    describe,
    escape,
    line_style,
    new_figure,
    scaled_axis,
    set_note,
    set_title,
    styled,
)
from ropewalk.plots.torn import broken_note
from ropewalk.record.contacts import each_frame
from ropewalk.record.quantities import ROPE_CONTACTS

if TYPE_CHECKING:
    from ropewalk.record.result import Result

_BARS = ("cylinder", "capsule")  # round which a rope is wound
_FEWEST = 3  # nodes of a wrap
_TOLD = 6  # wraps that the note tells of
_TALL = 2.0  # [1] times the largest tension: how high the axes go
_MOST_ROPES = 8  # that a legend names
_SHOWN = (
    0.01  # of the largest force: so much must cancel on a node for the sums to be drawn, too [1]
)
CANCELS = (
    "The sizes of all forces on a node, added up; dotted: added as vectors. What lies between two others "
    "is pressed by both."
)


@dataclass(frozen=True)
class Coil:
    """Nodes of a rope, one after another, that lie on one round bar at a frame."""

    rope: str
    obstacle: str
    friction: float  # [1]
    first: int  # node of the rope
    turned: Floats  # (k + 1,) angle round the bar up to each segment from the one before the wrap on [rad]
    tension: Floats  # (k + 1,) of these segments [N]
    at_slip: float  # ratio of tensions at which it slips as it lies, see `Contacts.at_slip` [1]

    @property
    def angle(self) -> float:
        """How far the rope turns [rad]."""
        return float(self.turned[-1])

    @property
    def held(self) -> Floats:
        """The tension up to which friction holds a rope without weight, from its slack side on [N]."""
        slack_first = self.tension[0] <= self.tension[-1]
        way = self.turned if slack_first else self.angle - self.turned
        found: Floats = min(self.tension[0], self.tension[-1]) * np.exp(self.friction * way)
        return found


def coils(result: Result, frame: int) -> list[Coil]:
    """Return all wraps round bars at a frame, of at least three nodes; one between two may be off."""
    found = []
    for _, contacts in each_frame(result, [frame]):
        for span in result.layout.ropes:
            own = (contacts.node >= span.first) & (contacts.node <= span.last)
            pull = result.tension[frame][span.first : span.last]
            there = np.flatnonzero(result.rope(span.name).live[frame])  # on no drum
            if not there.size:
                continue
            for o, body in enumerate(result.scene.obstacles):
                if body.kind not in _BARS:
                    continue
                for rows in stretches(contacts, np.flatnonzero(own & (contacts.obstacle == o))):
                    nodes = contacts.node[rows] - span.first
                    first, last = max(int(nodes[0]), there[0] + 1), min(int(nodes[-1]), there[-1])
                    if last - first + 1 < _FEWEST:
                        continue
                    bend = np.zeros(len(pull) + 1)
                    bend[nodes] = contacts.turn[rows]
                    turned = np.concatenate([[0.0], np.cumsum(bend[first : last + 1])])
                    along = pull[first - 1 : last + 1]
                    mu = body.friction_with(result.scene.rope_named(span.name))
                    number = int(first) - span.spare_start
                    slip = contacts.at_slip(mu, rows[(nodes >= first) & (nodes <= last)])
                    found.append(Coil(span.name, body.name, mu, number, turned, along, slip))
    ropes = [span.name for span in result.layout.ropes]
    return sorted(found, key=lambda coil: (ropes.index(coil.rope), coil.first))


@styled
def contact(result: Result, time: float | None = None) -> Figure:
    """Draw the forces of contacts on the nodes, and the tension, along the ropes at a `time` [s].

    The sizes of all forces on a node are added up, and where some cancel their sum is dotted, see `pressing`.
    By default the last frame, or the last good one. Along a wrap round a bar the dashed line is
    T0 exp(mu s / R) from the slack side on (Euler, Eytelwein), with how far the recorded rope has turned
    as s / R: a rope that sticks lies below, one that slips on it, but for its weight, which the formula
    leaves out. It leaves the axes at twice the largest tension.

    Raises ValueError for a run without recorded contact forces, and for a time outside it.
    """
    if "contact_force" not in result.source.names:
        raise ValueError("result: has no contact_force - it needs obstacles, or a [contact] table")
    frame = good_frames(result) - 1 if time is None else frame_at(result, [time])[0]
    found = coils(result, frame)
    figure = new_figure(7.2, 5.4)
    above, below = figure.subplots(2, 1, sharex=True)
    cancels = _draw_forces(above, result, frame)
    _draw_tension(below, result, frame, found)
    set_title(
        figure, f"{result.scene.name}: contact at t = {result.time[frame]:.4g} s", describe(result)
    )
    notes = broken_note(result, good_frames(result))
    on_ropes = result.scene.contact is not None
    notes += [CANCELS] if cancels else []
    set_note(figure, notes + [_told(coil, on_ropes) for coil in found[:_TOLD]])
    return figure


def pressing(result: Result, frame: int) -> Floats:
    """Return the sizes of all contact forces on each node at a frame, added up, (nodes,) [N].

    What lies between two others is pressed by both, though their forces cancel in `contact_force`. That of
    ropes on a segment goes to its two nodes by the lever. What was recorded without the contacts of ropes
    has the size of the sum on each node.
    """
    if ROPE_CONTACTS not in result.source.names:
        together: Floats = np.linalg.norm(result.contact_force[frame], axis=1)
        return together
    found = np.zeros(result.layout.nodes)
    for _, contacts in each_frame(result, [frame]):
        force = contacts.push[:, None] * contacts.normal + contacts.rub
        np.add.at(found, contacts.node, np.linalg.norm(force, axis=1))
    kept = result.read(ROPE_CONTACTS, frame, frame + 1)[0]
    kept = kept[np.isfinite(kept[:, 0])]
    force = np.linalg.norm(kept[:, 5:8], axis=1)
    for segments, at in ((kept[:, 0], kept[:, 2]), (kept[:, 1], kept[:, 3])):
        np.add.at(found, segments.astype(np.int64), (1.0 - at) * force)
        np.add.at(found, segments.astype(np.int64) + 1, at * force)
    return found


def _draw_forces(axes: Axes, result: Result, frame: int) -> bool:
    """Draw what presses on nodes; return whether some of it cancels."""
    sizes = pressing(result, frame)
    together = np.linalg.norm(result.contact_force[frame], axis=1)
    cancels = bool((sizes - together).max(initial=0.0) > _SHOWN * sizes.max(initial=0.0))
    for number, span in enumerate(result.layout.ropes):
        arc, own = node_arcs(result, frame, span.name), slice(span.first, span.last + 1)
        (line,) = axes.plot(
            arc, sizes[own], marker=".", label=escape(span.name), **line_style(number)
        )
        if cancels:
            axes.plot(arc, together[own], color=line.get_color(), linestyle=":", label="_sum")
    axes.set_ylim(bottom=0.0)
    scaled_axis(axes, "contact forces", "N", max(map(abs, axes.get_ylim())))
    if 1 < len(result.layout.ropes) <= _MOST_ROPES:
        axes.legend(ncols=4, loc="lower left", bbox_to_anchor=(0.0, 1.0))
    return cancels


def _draw_tension(axes: Axes, result: Result, frame: int, found: list[Coil]) -> None:
    for number, span in enumerate(result.layout.ropes):
        middles = segment_arcs(result, frame, span.name)
        rope = result.rope(span.name)
        values = np.where(rope.live[frame], rope.tension[frame], np.nan)  # no line over what parted
        axes.plot(middles, values, marker=".", **line_style(number))
        offset = span.start - span.first
        for coil in (one for one in found if one.rope == span.name):
            first = offset + coil.first - 1
            at = middles[first : first + len(coil.turned)]
            axes.plot(at, coil.held, color=GREY, linestyle="--", zorder=4, label="_held")
    if found:
        axes.plot(
            [],
            [],
            color=GREY,
            linestyle="--",
            label=r"$T_0\, e^{\mu s / R}$, a rope without weight",
        )
        axes.legend(loc="best")
    largest = float(np.nanmax(result.tension[frame], initial=0.0))
    low, high = axes.get_ylim()  # the dashed line may leave them: tension would be flat beside it
    axes.set_ylim(min(0.0, low), min(high, _TALL * largest) if largest > 0.0 else high)
    scaled_axis(axes, result.tension_name, "N", max(map(abs, axes.get_ylim())))
    axes.set_xlabel(arc_label(result, [span.name for span in result.layout.ropes]))


def _told(coil: Coil, on_ropes: bool) -> str:
    """Say how far a wrap is from slipping, `on_ropes` of a scene whose ropes touch each other."""
    low, high = sorted((float(coil.tension[0]), float(coil.tension[-1])))
    about = f"{coil.rope} turns {np.degrees(coil.angle):.4g} degrees round {coil.obstacle}"
    if low <= 0.0:
        return f"{about}; its slack end carries nothing."
    most = coil.at_slip
    told = f"{about}: tension ratio {high / low:.4g}"
    told += f"; without weight it slips at {most:.4g} as it lies (friction {coil.friction:g})"
    return (
        f"{told}; ropes that lie on it hold the rest."
        if on_ropes and high > most * low
        else f"{told}."
    )
