"""What obstacles do to ropes: forces along the rope, and the tension along a wrap against Euler's formula."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure

from ropewalk.lowering.touching import PRESSED, stretches
from ropewalk.plots.arcs import arc_label, node_arcs, segment_arcs
from ropewalk.plots.sight import Floats, chunks, frame_at, good_frames
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
from ropewalk.record.rope_contact_table import pressed_by_ropes

if TYPE_CHECKING:
    from ropewalk.record.result import Result

_BARS = ("cylinder", "capsule")  # round which a rope is wound
_FEWEST = 3  # nodes of a wrap
_TOLD = 6  # wraps that the note tells of
_TALL = 2.0  # [1] times the largest tension: how high the axes go
_MOST_ROPES = 8  # that a legend names
_WIDER = 3.2  # points by which the first of many ropes has a wider line
_UNSEEN = 1e-3  # of the largest tension: a smaller push shows in no axes [1]
_SHOWN = (
    0.01  # of the largest force: so much must cancel on a node for the sums to be drawn, too [1]
)
CANCELS = (
    "The sizes of all forces on a node, added up; dotted: as vectors. What lies between two others "
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
    grip: Floats  # (k + 1,) by how much ln T may rise up to each segment, see `at_slip` [1]
    pressed: tuple[str, ...]  # what else presses on it there, so that where it slips is not known

    @property
    def angle(self) -> float:
        """How far the rope turns [rad]."""
        return float(self.turned[-1])

    @property
    def slack(self) -> float:
        """The tension at its slack end [N]; not positive where that carries none."""
        return float(min(self.tension[0], self.tension[-1]))

    @property
    def at_slip(self) -> float:
        """The ratio of tensions at which it slips as it lies, a rope without weight [1]."""
        return float(np.exp(self.grip[-1]))

    @property
    def held(self) -> Floats | None:
        """The tension up to which friction holds a rope without weight, from its slack side on [N].

        None where that is not known: ropes or other obstacles press on it, or its slack side carries none.
        """
        if self.pressed or self.slack <= 0.0:
            return None
        slack_first = self.tension[0] <= self.tension[-1]
        found: Floats = self.slack * np.exp(self.grip if slack_first else self.grip[-1] - self.grip)
        return found


def coils(result: Result, frame: int) -> list[Coil]:
    """Return all wraps round bars at a frame, of at least three nodes; one between two may be off."""
    found = []
    for _, contacts in each_frame(result, [frame]):
        by_ropes = pressed_by_ropes(result, frame)
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
                    rows = rows[(nodes >= first) & (nodes <= last)]
                    along = pull[first - 1 : last + 1]
                    mu = body.friction_with(result.scene.rope_named(span.name))
                    number, at = int(first) - span.spare_start, contacts.node[rows]
                    bend, grip = np.zeros((2, last - first + 2))
                    bend[at - span.first - first + 1] = contacts.turn[rows]
                    grip[at - span.first - first + 1] = contacts.held_by(mu, rows)
                    roped = by_ropes[at].sum() > PRESSED * contacts.push[rows].sum()
                    beside = (result.scene.obstacles[k].name for k in contacts.pressed_by(rows))
                    pressed = (*(("ropes",) if roped else ()), *beside)
                    sums = np.cumsum(bend), np.cumsum(grip)
                    found.append(
                        Coil(span.name, body.name, mu, number, sums[0], along, sums[1], pressed)
                    )
    ropes = [span.name for span in result.layout.ropes]
    return sorted(found, key=lambda coil: (ropes.index(coil.rope), coil.first))


@styled
def contact(result: Result, time: float | None = None) -> Figure:
    """Draw the forces of contacts on the nodes, and the tension, along the ropes at a `time` [s].

    The sizes of all forces on a node are added up, and where some cancel their sum is dotted, see `pressing`.
    By default the last good frame in which something touches. Along a wrap round a bar the dashed line is
    T0 exp(mu s / R) from the slack side on (Euler, Eytelwein), with how far the recorded rope has turned
    as s / R, less what it needs across (`Contacts.at_slip`): a rope that sticks lies below, one that slips on
    it, but for its weight, which the formula leaves out. There is none where ropes or other obstacles press
    on the wrap, or its slack side carries nothing. It leaves the axes at twice the largest tension.

    Raises ValueError for a run without recorded contact forces, and for a time outside it.
    """
    if "contact_force" not in result.source.names:
        raise ValueError("result: has no contact_force - it needs obstacles, or a [contact] table")
    frame, idle = _frame(result, time)
    found = coils(result, frame)
    figure = new_figure(7.2, 5.4)
    above, below = figure.subplots(2, 1, sharex=True)
    cancels = _draw_forces(above, result, frame)
    _draw_tension(below, result, frame, found)
    set_title(
        figure, f"{result.scene.name}: contact at t = {result.time[frame]:.4g} s", describe(result)
    )
    notes = broken_note(result, good_frames(result))
    notes += [idle] if idle else []
    notes += [CANCELS] if cancels else []
    set_note(figure, notes + [_told(coil) for coil in found[:_TOLD]])
    return figure


def _frame(result: Result, time: float | None) -> tuple[int, str]:
    """Return the frame at a time [s], or the last good one that touches; and what to say where none does."""
    good = good_frames(result)
    touching = np.array([], np.int64)
    for part in chunks(result):
        force = result.read("contact_force", part.start, max(part.start, min(part.stop, good)))
        touching = np.append(touching, part.start + np.flatnonzero(force.any(axis=(1, 2))))
    if time is None:
        frame = int(touching[-1]) if touching.size else good - 1
        if touching.size and frame < good - 1:
            at, last = (f"{result.time[one]:.4g} s" for one in (frame, good - 1))
            return frame, f"After t = {at} nothing touches, up to the last frame at {last}."
    else:
        frame = frame_at(result, [time])[0]
    if frame >= good or frame in touching:
        return frame, ""
    if not touching.size:
        return frame, "Nothing touches in any frame of the run."
    near = touching[np.argmin(np.abs(touching - frame))]
    return frame, f"Nothing touches at this time; at {result.time[near]:.4g} s something does."


def pressing(result: Result, frame: int) -> Floats:
    """Return the sizes of all contact forces on each node at a frame, added up, (nodes,) [N].

    What lies between two others is pressed by both, though their forces cancel in `contact_force`. That of
    ropes on a segment goes to its two nodes by the lever. Where ropes touched, but their contacts were not
    recorded, it is the size of the sum on each node.
    """
    together: Floats = np.linalg.norm(result.contact_force[frame], axis=1)
    roped = ROPE_CONTACTS in result.source.names
    if result.scene.contact is not None and not roped:
        return together
    found = np.zeros(result.layout.nodes)
    for _, contacts in each_frame(result, [frame]):
        force = contacts.push[:, None] * contacts.normal + contacts.rub
        np.add.at(found, contacts.node, np.linalg.norm(force, axis=1))
    if not roped:
        return np.maximum(found, together)
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
        (line,) = axes.plot(arc, sizes[own], label=escape(span.name), **_line(result, number))
        if cancels:
            dotted: dict[str, Any] = {
                "linestyle": ":",
                "linewidth": line.get_linewidth(),
                "alpha": line.get_alpha(),
            }
            axes.plot(arc, together[own], color=line.get_color(), label="_sum", **dotted)
    axes.set_ylim(bottom=0.0)
    largest = max(map(abs, axes.get_ylim())) if sizes.any() else 0.0
    scaled_axis(axes, "contact forces", "N", largest)
    if not largest:
        axes.set_yticks([0.0])
    if 1 < len(result.layout.ropes) <= _MOST_ROPES:
        axes.legend(ncols=4, loc="lower left", bbox_to_anchor=(0.0, 1.0))
    return cancels


def _draw_tension(axes: Axes, result: Result, frame: int, found: list[Coil]) -> None:
    curves: list[tuple[Floats, Floats]] = []
    for number, span in enumerate(result.layout.ropes):
        middles = segment_arcs(result, frame, span.name)
        rope = result.rope(span.name)
        values = np.where(rope.live[frame], rope.tension[frame], np.nan)  # no line over what parted
        axes.plot(middles, values, **_line(result, number))
        offset = span.start - span.first
        for coil in (one for one in found if one.rope == span.name):
            first = offset + coil.first - 1
            if (held := coil.held) is not None:
                curves.append((middles[first : first + len(held)], held))
    least, largest = (
        float(fold(result.tension[frame], initial=0.0)) for fold in (np.nanmin, np.nanmax)
    )
    low, high = axes.get_ylim()  # of tensions alone: they would be flat beside what may be held
    low = low if least < -_UNSEEN * largest else 0.0
    for at, held in curves:
        axes.plot(at, held, color=GREY, linestyle="--", zorder=4, label="_held")
    if curves:
        what = r"$T_0\, e^{\mu s / R}$, a rope without weight"
        axes.plot([], [], color=GREY, linestyle="--", label=what)
        axes.legend(loc="best")
    most = max((float(held.max()) for _, held in curves), default=0.0)
    axes.set_ylim(low, max(high, min(1.05 * most, _TALL * largest)))
    scaled_axis(axes, result.tension_name, "N", max(map(abs, axes.get_ylim())))
    axes.set_xlabel(arc_label(result, [span.name for span in result.layout.ropes]))


def _line(result: Result, number: int) -> dict[str, Any]:
    """Return how a rope's line looks: the later the thinner, so that equal ones show behind each other."""
    below = len(result.layout.ropes) - 1 - number
    width = 1.4 + _WIDER * min(below, _MOST_ROPES) / min(len(result.layout.ropes), _MOST_ROPES)
    return line_style(number) | {
        "marker": ".",
        "linewidth": width,
        "markersize": 5.0 + 2.0 * (width - 1.4),
        "alpha": 0.55 if below else 1.0,
    }


def _told(coil: Coil) -> str:
    """Say how far a wrap is from slipping."""
    low, high = sorted((float(coil.tension[0]), float(coil.tension[-1])))
    about = f"{coil.rope} turns {np.degrees(coil.angle):.4g} degrees round {coil.obstacle}"
    if low <= 0.0:
        return f"{about}; its slack end carries nothing."
    told = f"{about}: tension ratio {high / low:.4g}"
    if coil.pressed:
        one = len(coil.pressed) == 1 and coil.pressed != ("ropes",)
        who = f"{' and '.join(coil.pressed)} press{'es' if one else ''}"
        return f"{told}; {who} on it, too: where it slips is not known."
    return f"{told}; without weight it slips at {coil.at_slip:.4g} as it lies (friction {coil.friction:g})."
