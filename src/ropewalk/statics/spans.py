"""A rest shape in words: what hangs between two held nodes, and what hangs or lies beyond them."""

from __future__ import annotations

import itertools
import math
from dataclasses import dataclass
from functools import partial

import numpy as np

from ropewalk.core.arrays import BENDING, Floats
from ropewalk.laws.acting import at_rest, borne
from ropewalk.laws.node_law import Rest
from ropewalk.laws.obstacle import touched
from ropewalk.lowering import Model, Span
from ropewalk.statics.balance import Balance
from ropewalk.statics.hung import held_nodes, upward
from ropewalk.statics.refusal import is_loose, unloaded
from ropewalk.statics.tied import tied_nodes
from ropewalk.words.prefixes import prefixed
from ropewalk.words.pushes import largest_push, pull_told

_STRAIGHT = 1e-6  # share of a tail's length that it may lack and hang straight [1]
_ROUNDING = 1e-12  # of the ends' distance: what is no height [1]
_PLUMB = 1e-6  # slope from the upright up to which ends stand above each other [1]


@dataclass(frozen=True)
class RestSpan:
    """One stretch of a rope at rest: between two held or tied nodes, or a tail beyond the last one."""

    rope: str
    kind: str  # "span" or "tail"
    first: int  # node of the rope at which it begins
    last: int
    distance: float  # between its ends at rest [m]
    length: float  # unstretched [m]
    # largest drop below the straight line between its ends, along gravity [m]; below the lower end where one
    # stands above the other
    sag: float
    rise: float  # largest height above that line, or the higher end [m]: of a rope that floats up
    lowest: float  # height of its lowest node above its first one [m], 0 or negative
    horizontal: (
        float  # part across gravity of what it carries at its lowest node [N]: see `_horizontal`
    )
    largest_tension: float  # [N]; 0 where all of it is pressed
    largest_push: float = 0.0  # of a segment that is pressed [N]
    windy: bool = False  # whether a flow pushes, too, so that it hangs in no upright plane
    stands: bool = (
        False  # whether bending stiffness alone bears a tail that does not hang straight down
    )
    lies: bool = False  # whether some of a tail lies on the ground

    @property
    def words(self) -> str:
        """What hangs how, without the rope's name."""
        where = f"nodes {self.first} to {self.last}"
        if self.kind == "tail":
            return f"{where} {self._tail}"
        return f"{self.hangs} over {self.distance:.4g} m, {where}"

    def __str__(self) -> str:
        where = f"nodes {self.first} to {self.last} of rope {self.rope!r}"
        if self.kind == "tail":
            return f"{where} {self._tail}"
        return f"{where} {self.hangs} over {self.distance:.4g} m"

    @property
    def straight(self) -> bool:
        """Whether its ends are as far apart as it is long: a tail that hangs, and lies nowhere."""
        straight = self.distance >= self.length * (1.0 - _STRAIGHT)
        return straight and not self.stands and not self.lies

    @property
    def single(self) -> bool:
        """Whether it is a span of one segment, straight however it hangs: its sag is not computed."""
        return self.kind == "span" and abs(self.last - self.first) == 1

    def as_dict(self) -> dict[str, object]:
        """Plain values; None for the sag and the rise of a single segment."""
        return vars(self) | (dict.fromkeys(("sag", "rise")) if self.single else {})

    @property
    def _tail(self) -> str:
        if self.straight:
            return f"hang free, {self.distance:.4g} m long"
        if self.stands:
            return f"stand or hang, {self.length:.4g} m of rope, the tip {self.distance:.4g} m away"
        return f"hang or lie, {self.length:.4g} m of rope, its tip {self.distance:.4g} m away"

    @property
    def hangs(self) -> str:
        """How far it sags below the line between its ends or, if that is more, rises above it."""
        if self.single:
            return "one segment, whose sag is not computed,"
        floats = self.rise > self.sag
        along = " along gravity" if self.windy else ""
        return (f"rise {self.rise:.4g} m" if floats else f"sag {self.sag:.4g} m") + along

    def pull_words(self, digits: int) -> str:
        """The largest tension as an entry of a table's column; of a rope that is pressed its push."""
        pushes = f"pushes {prefixed(self.largest_push, 'N', digits)}" if self.largest_push else ""
        pulls = prefixed(self.largest_tension, "N", digits)
        return f"{pulls}, {pushes}" if pushes and self.largest_tension > 0.0 else pushes or pulls

    def sag_words(self, digits: int) -> str:
        """The sag as an entry of a table's column; of a rope that floats up it says so."""
        if self.kind == "tail":
            return ""
        if self.single:
            return "one segment"
        return (
            f"rises {self.rise:.{digits}g} m"
            if self.rise > self.sag
            else f"{self.sag:.{digits}g} m"
        )


def rest_spans(
    model: Model, positions: Floats, tension: Floats, left: Floats | None = None
) -> tuple[RestSpan, ...]:
    """Return the spans of a rest shape; of ropes that lie on obstacles there are none: see `wraps`.

    Nor of what may have any shape.

    Args:
        model: what is at rest.
        positions: places of the nodes (n, 3) [m].
        tension: of the segments (s,) [N].
        left: largest force that is left on a node of each segment's rope (s,) [N]; None: nothing is.
    """
    found, left = [], np.zeros(tension.size) if left is None else left
    measure = partial(_measure, model, positions, tension, _shear(model, positions), left)
    lies = touched(model.system.node.obstacle, positions.T)
    lies &= model.state.inverse_mass > 0.0  # what is held touches nothing
    nothing = unloaded(tension, left)
    for rope in model.layout.ropes:
        nodes = sorted({*held_nodes(model, rope), *tied_nodes(model, rope)})
        if not nodes or lies[rope.start : rope.end + 1].any():
            continue
        parts = [(nodes[0], rope.start), *itertools.pairwise(nodes), (nodes[-1], rope.end)]
        for number, (first, last) in enumerate(parts):
            kind = "span" if 0 < number < len(parts) - 1 else "tail"
            if first != last and not is_loose(model, rope, (first, last), positions, nothing):
                found.append(measure(rope, first, last, kind))
    return tuple(found)


def _measure(
    model: Model,
    positions: Floats,
    tension: Floats,
    shear: Floats | None,
    left: Floats,
    rope: Span,
    first: int,
    last: int,
    kind: str,
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
    if across <= _PLUMB * float(np.linalg.norm(ends)):
        across = 0.0
        chord, over = (np.full(heights.size, end(rise, 0.0)) for end in (min, max))
    else:  # beyond an end: that end
        chord = over = np.clip(level @ level[-1] / across**2, 0.0, 1.0) * rise
    steps = np.diff(points, axis=0)
    sizes = np.linalg.norm(steps, axis=1)
    flat = steps - np.outer(steps @ up, up)
    pulls = pull[:, None] * flat / np.maximum(sizes, 1e-300)[:, None]
    lowest = max(int(np.argmin(heights)) - 1, 0)
    turned = None if shear is None else shear[low:high][::step][lowest]
    free, distance = kind == "tail", float(np.linalg.norm(ends))
    drop, over_it = (_seen(float(one.max()), distance) for one in (chord - heights, heights - over))
    bends = model.scene.rope_named(rope.name).bending_stiffness > 0.0
    free_nodes = model.state.inverse_mass > 0.0
    lies = bool((borne(model.system, positions.T) & free_nodes)[low : high + 1].any())
    return RestSpan(
        rope=rope.name,
        kind=kind,
        first=first - rope.start,
        last=last - rope.start,
        distance=distance,
        length=float(model.state.rest_length[low:high].sum()),
        sag=0.0 if free else drop,
        rise=0.0 if free else over_it,
        lowest=float(heights.min()) if gravity > 0.0 else 0.0,
        horizontal=0.0
        if free
        else _horizontal(
            pulls[lowest], float(pull[lowest]), turned, level[-1] * (across > 0.0), up
        ),
        largest_tension=pull_told(float(pull.max(initial=0.0)), float(left[low])),
        largest_push=largest_push(pull, float(left[low])),
        windy=Rest.CARRIES in at_rest(model.system),
        stands=free and bends and not lies and -rise < distance * (1.0 - _STRAIGHT),
        lies=free and lies,
    )


def _seen(height: float, distance: float) -> float:
    """Return a height [m] over ends so far apart [m]: 0 below, or where it is rounding."""
    return height if height > _ROUNDING * distance else 0.0


def _shear(model: Model, positions: Floats) -> Floats | None:
    """Return what bending carries across each segment at places (n, 3) [m], (s, 3) [N]; None without any."""
    if not model.system.flags[BENDING]:
        return None
    balance = Balance(model)
    balance.others(np.ascontiguousarray(positions.T))
    return np.ascontiguousarray(balance.state.forces.bending[:, 1:-1].T)


def _horizontal(
    pull: Floats, tension: float, shear: Floats | None, level: Floats, up: Floats
) -> float:
    """Return the part across gravity of what a segment carries [N], the same all along without wind.

    Negative where it pushes: where the ends of a rope with bending stiffness are pushed apart, or where a
    segment is pressed.

    Args:
        pull: the part of its tension (3,) [N].
        tension: its tension [N].
        shear: what bending carries across it (3,) [N]; None where nothing bends.
        level: from one end of the span to the other, across gravity (3,) [m].
        up: against gravity (3,) [1].
    """
    if shear is None:
        return math.copysign(float(np.linalg.norm(pull)), tension)
    force = pull + shear - (shear @ up) * up
    return math.copysign(float(np.linalg.norm(force)), float(force @ level) or tension)
