"""A rest shape in words: what hangs between two held nodes, and what hangs or lies beyond them."""

from __future__ import annotations

import itertools
from dataclasses import dataclass

import numpy as np

from ropewalk.core.arrays import Floats
from ropewalk.laws.obstacle import touched
from ropewalk.lowering import Model, Span
from ropewalk.statics.hung import held_nodes, upward
from ropewalk.statics.tied import tied_nodes


@dataclass(frozen=True)
class RestSpan:
    """One stretch of a rope at rest: between two held or tied nodes, or a tail beyond the last one."""

    rope: str
    kind: str  # "span" or "tail"
    first: int  # node of the rope at which it begins
    last: int
    distance: float  # between its ends at rest [m]
    length: float  # unstretched [m]
    sag: float  # largest drop below the straight line between its ends, along gravity [m]
    rise: float  # largest height above that line [m]: of a rope that floats up
    lowest: float  # height of its lowest node above its first one [m], 0 or negative
    horizontal: float  # part of the tension across gravity at its lowest node [N]; all along it without wind
    largest_tension: float  # [N]

    @property
    def words(self) -> str:
        """What hangs how, without the rope's name."""
        where = f"nodes {self.first} to {self.last}"
        if self.kind == "tail":
            return f"{where} hang free, {self.distance:.4g} m long"
        return f"{self.hangs} over {self.distance:.4g} m, {where}"

    def __str__(self) -> str:
        where = f"nodes {self.first} to {self.last} of rope {self.rope!r}"
        if self.kind == "tail":
            return f"{where} hang free, {self.distance:.4g} m long"
        return f"{where} {self.hangs} over {self.distance:.4g} m"

    @property
    def hangs(self) -> str:
        """How far it sags below the line between its ends or, if that is more, rises above it."""
        floats = self.rise > self.sag
        return f"rise {self.rise:.4g} m" if floats else f"sag {self.sag:.4g} m"

    def sag_words(self, digits: int) -> str:
        """The sag as an entry of a table's column; of a rope that floats up it says so."""
        if self.kind == "tail":
            return ""
        return (
            f"rises {self.rise:.{digits}g} m"
            if self.rise > self.sag
            else f"{self.sag:.{digits}g} m"
        )


def rest_spans(model: Model, positions: Floats, tension: Floats) -> tuple[RestSpan, ...]:
    """Return the spans of a rest shape; `positions` (n, 3) [m], `tension` (s,) [N].

    Of ropes that lie on obstacles there are none: see `wraps`.
    """
    found = []
    lies = touched(model.system.node.obstacle, positions.T)
    for rope in model.layout.ropes:
        nodes = sorted({*held_nodes(model, rope), *tied_nodes(model, rope)})
        if not nodes or lies[rope.start : rope.end + 1].any():
            continue
        if nodes[0] > rope.start:
            found.append(_measure(model, positions, tension, rope, nodes[0], rope.start))
        for first, last in itertools.pairwise(nodes):
            found.append(_measure(model, positions, tension, rope, first, last, "span"))
        if nodes[-1] < rope.end:
            found.append(_measure(model, positions, tension, rope, nodes[-1], rope.end))
    return tuple(found)


def _measure(
    model: Model,
    positions: Floats,
    tension: Floats,
    rope: Span,
    first: int,
    last: int,
    kind: str = "tail",
) -> RestSpan:
    up, gravity = upward(model)
    low, high = min(first, last), max(first, last)
    step = 1 if last > first else -1
    points = positions[low : high + 1][::step]
    pull = tension[low:high][::step]
    from_first = points - points[0]
    heights = from_first @ up
    level = from_first - np.outer(heights, up)
    ends = from_first[-1]
    rise = float(heights[-1])
    across = float(np.linalg.norm(level[-1]))
    if across <= 1e-9 * float(np.linalg.norm(ends)):
        chord = np.full(heights.size, min(rise, 0.0))
    else:
        chord = np.clip(level @ level[-1] / across**2, 0.0, 1.0) * rise  # beyond an end: that end
    steps = np.diff(points, axis=0)
    sizes = np.linalg.norm(steps, axis=1)
    flat = steps - np.outer(steps @ up, up)
    sideways = pull * np.linalg.norm(flat, axis=1) / np.maximum(sizes, 1e-300)
    lowest = int(np.argmin(heights))
    free = kind == "tail"
    return RestSpan(
        rope=rope.name,
        kind=kind,
        first=first - rope.start,
        last=last - rope.start,
        distance=float(np.linalg.norm(ends)),
        length=float(model.state.rest_length[low:high].sum()),
        sag=0.0 if free else max(0.0, float((chord - heights).max())),
        rise=0.0 if free else max(0.0, float((heights - chord).max())),
        lowest=float(heights.min()) if gravity > 0.0 else 0.0,
        horizontal=0.0 if free else float(sideways[max(lowest - 1, 0)]),
        largest_tension=float(pull.max(initial=0.0)),
    )
