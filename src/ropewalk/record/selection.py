"""Which frames, ropes, nodes and quantities of a result an export takes."""

from __future__ import annotations

import math
from collections.abc import Iterable, Iterator, Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray

from ropewalk.record.books import told
from ropewalk.record.errors import InputError
from ropewalk.record.quantities import QUANTITIES
from ropewalk.record.skipped import is_of_steps, of_rows
from ropewalk.words.nearest import nearest

if TYPE_CHECKING:
    from ropewalk.record.result import Result

Indices = NDArray[np.int64]

EXPORTED = tuple(quantity.name for quantity in QUANTITIES if quantity.name != "jump")
DEFAULT = (
    *("positions", "velocities", "tension", "elastic_tension"),
    *("least_tension", "greatest_tension", "greatest_stretch"),
    *("greatest_speed", "least_height", "greatest_height"),
    *(
        "energy",
        "work",
        "reactions",
        "moments",
        "joint_forces",
        "contact_force",
        "obstacle_force",
        "rope_contacts",
        "pulleys",
        "contact_work",
        "greatest_reactions",
        "greatest_moments",
        "greatest_surface_forces",
        "extremes",
        "energy_errors",
    ),
)
_VALUES = 500_000  # numbers handled together


@dataclass(frozen=True)
class Selection:
    """What to export, as places in the arrays."""

    quantities: tuple[str, ...]
    frames: Indices
    nodes: Indices
    segments: Indices
    anchors: Indices
    ties: Indices  # of joints

    @property
    def places(self) -> dict[str, Indices]:
        """The places along the dimensions of which some are chosen."""
        anchors, ties = self.anchors, self.ties
        return {"node": self.nodes, "segment": self.segments, "anchor": anchors, "tie": ties}

    def pieces(self, result: Result) -> Iterator[Indices]:
        """Yield the frames in pieces of bounded size that lie in one chunk of the source."""
        most = max(1, _VALUES // (3 * result.nodes))
        chunks = self.frames // max(1, result.source.chunk)
        for piece in np.split(self.frames, np.flatnonzero(np.diff(chunks)) + 1):
            for start in range(0, len(piece), most):
                yield piece[start : start + most]

    def take(self, result: Result, name: str, piece: Indices) -> NDArray[np.float64]:
        """Return a quantity of a piece of the frames; greatest and least are since the row before."""
        row = int(np.searchsorted(self.frames, piece[0]))
        first = int(self.frames[row - 1]) + 1 if row else 0
        if is_of_steps(name) and int(piece[-1]) - first >= len(piece):  # frames are left out
            return of_rows(result, name, piece, first)
        return take(result, name, piece)


def take(result: Result, name: str, frames: Indices) -> NDArray[np.float64]:
    """Return a quantity of some frames (rising numbers) as they have it, works as they are told."""
    start = int(frames[0])
    return told(result, name, result.read(name, start, int(frames[-1]) + 1)[frames - start])


def select(
    result: Result,
    quantities: Iterable[str],
    nodes: Sequence[int] | None,
    times: Sequence[float] | None,
    every: int | None,
    rope: str | None,
) -> Selection:
    """Turn a request into places in the arrays.

    Raises InputError for names, nodes or times that are not there.
    """
    chosen = tuple(dict.fromkeys([quantities] if isinstance(quantities, str) else quantities))
    for name in chosen:
        if name not in EXPORTED:
            raise InputError("quantities", name, f"no such quantity; {nearest(name, EXPORTED)}")
    if not chosen:
        raise InputError("quantities", (), f"name one or more of {', '.join(EXPORTED)}")
    found_nodes, found_segments = _places(result, nodes, rope)
    frames = _frames(result, times, every)
    return Selection(chosen, frames, found_nodes, found_segments, *_held(result, rope))


def _held(result: Result, rope: str | None) -> tuple[Indices, Indices]:
    """Return the anchors and the ties of joints on a rope, or on all of them."""
    anchors = [result.layout.rope_of(node)[0] for node in result.layout.anchor_nodes]
    ties = [tie.rope for joint in result.scene.joints for tie in joint.points]
    held = ([i for i, one in enumerate(names) if rope in (None, one)] for names in (anchors, ties))
    found, tied = (np.array(places, dtype=np.int64) for places in held)
    return found, tied


def _frames(result: Result, times: Sequence[float] | None, every: int | None) -> Indices:
    if times is None:
        if every is not None and every < 1:
            raise InputError("every", every, "must be at least 1")
        return np.arange(0, result.frames, every or 1)
    if every is not None:
        raise InputError("every", every, "cannot be combined with times")
    clock = result.time
    slack = 0.5 * result.plan.frame_interval
    for time in times:
        if not math.isfinite(time) or not clock[0] - slack <= time <= clock[-1] + slack:
            raise InputError("times", time, f"must be from {clock[0]:g} to {clock[-1]:.6g} s")
    if len(times) == 0:
        raise InputError("times", (), "name one or more times [s]")
    return np.unique([result.frame_at(time) for time in times])


def _places(
    result: Result, nodes: Sequence[int] | None, rope: str | None
) -> tuple[Indices, Indices]:
    layout = result.layout
    names = [span.name for span in layout.ropes]
    if rope is not None and rope not in names:
        raise InputError("rope", rope, f"no such rope; {nearest(rope, names)}")
    spans = [span for span in layout.ropes if rope in (None, span.name)]
    if nodes is not None and len(nodes) == 0:
        raise InputError("nodes", (), "name one or more nodes")
    of_nodes: list[int] = []
    of_segments: list[int] = []
    for span in spans:
        own = range(span.first, span.last + 1)
        try:
            chosen = own if nodes is None else {layout.node(node, span.name) for node in nodes}
        except IndexError as error:
            raise InputError("nodes", list(nodes or ()), str(error)) from None
        of_nodes += sorted(chosen)
        of_segments += [j for j in own[:-1] if j in chosen or j + 1 in chosen]
    return np.array(of_nodes), np.array(of_segments, dtype=np.int64)
