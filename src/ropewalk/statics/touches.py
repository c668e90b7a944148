"""Where ropes at rest lie on each other, what slides on them, and what friction carries there."""

from __future__ import annotations

import math
from collections.abc import Iterator
from dataclasses import dataclass
from typing import Any, NamedTuple

import numpy as np

from ropewalk.core.arrays import Floats, Ints
from ropewalk.laws.pairs.table import CONTACTS, NORMAL, OTHER, OWN, PUSH, SPRING
from ropewalk.laws.polygon import turn_towards
from ropewalk.laws.slides.rail import look
from ropewalk.laws.slides.table import APART, AT
from ropewalk.laws.slides.table import SPRING as HELD
from ropewalk.lowering import Model, Span
from ropewalk.statics.coupled import bound_there
from ropewalk.words.prefixes import prefixed

_ROUNDING = 1e-6  # of a tension [1]
_NOTHING = 0.05  # [%] of what friction can carry that is not told
_CENT = 100.0
OFF = 0.01  # of a segment: what hangs farther off its rope is told [1]


@dataclass(frozen=True)
class Strand:
    """What one of two ropes does where they touch."""

    rope: str
    first: int  # segment of the rope
    last: int
    angle: float  # by which it turns there towards the other [rad]
    before: float  # tension of the segment before the first [N]; 0 at the rope's end
    after: float  # ... after the last
    # Least and largest tension after it that friction holds with the one before as it is, by exp(mu angle)
    # where it carries nothing across and only what presses turns it [N]; NaN where the rope ends there,
    # nothing pulls, or something else holds it.
    least: float
    most: float

    @property
    def words(self) -> str:
        """Which segments they are."""
        if self.first == self.last:
            return f"segment {self.first} of rope {self.rope!r}"
        return f"segments {self.first} to {self.last} of rope {self.rope!r}"


@dataclass(frozen=True)
class Touch:
    """A place where a rope lies on another, or on itself."""

    strand: Strand
    other: Strand
    force: float  # sum of the normal forces [N]: round a bend more than what one rope bears of the other
    contacts: int  # of which it is the sum
    use: float  # largest |R_t| / (mu R_n) of its contacts [1]; 1: at the limit; 0 without friction
    friction: float  # coefficient [1]

    def __str__(self) -> str:
        verb = "touches" if self.strand.first == self.strand.last else "touch"
        said = f"{self.strand.words} {verb} {self.other.words} with {prefixed(self.force, 'N', 4)}"
        if self.contacts > 1:
            said += f", the sum of {self.contacts} contacts"
        if self.friction == 0.0:
            return said
        if _CENT * self.use >= _NOTHING:
            said += f"; contacts take up to {_CENT * self.use:.3g} % of what friction can carry"
        for side in (self.strand, self.other):
            if not math.isnan(side.most):
                pulls = " and ".join(prefixed(pull, "N", 4) for pull in (side.before, side.after))
                holds = " to ".join(prefixed(pull, "N", 4) for pull in (side.least, side.most))
                said += f"; {side.rope!r} has {pulls} beside it"
                said += f" and turns by {math.degrees(side.angle):.3g} degrees, where friction holds {holds}"
        return said

    def as_dict(self) -> dict[str, Any]:
        """Plain values."""
        return vars(self) | {"strand": vars(self.strand), "other": vars(self.other)}


@dataclass(frozen=True)
class Seat:
    """Where something that slides along a rope is at rest."""

    slide: str
    on: str  # the rope that it slides along
    at: float  # [m] along it, unstretched
    force: float  # across the rope [N]
    along: float  # what friction and brake carry [N], positive away from the rope's start
    most: float  # ... and could carry [N]
    off: float  # from the rope's curve to the node, as its spring yields [m]
    segment: float  # unstretched length of the rope's segments [m]
    # What segments take of the bend there [m]: the rope's tension is that of one so much longer. A corner of
    # the angle b that two segments share leaves h b^2 / 8 of the rope over.
    rounded: float
    spare: float  # by how much the rope is longer than its ends are apart [m]
    before: float  # tension of the rope on the side of its start, beyond the nodes that bear the slide [N]
    after: float  # ... and of its end; NaN where there is none, or something else holds the rope between
    weighs: float  # weight of the nodes between these two, and given forces on them [N]

    @property
    def uneven(self) -> float:
        """By how much the tensions beside it differ more than friction, weight and forces make them [N].

        On a line without segments it is 0: what rests in a bump between two nodes makes it.
        """
        apart = abs(self.after - self.before) - abs(self.along) - self.weighs
        return apart if apart > OFF * max(self.before, self.after) else 0.0

    @property
    def is_rounded(self) -> bool:
        """Whether segments are so long that the rope's tension is noticeably lower: by half of that share."""
        return self.rounded > OFF * self.spare

    @property
    def hangs_off(self) -> bool:
        """Whether it is noticeably off its rope."""
        return self.off > OFF * self.segment

    @property
    def use(self) -> float:
        """Share of what friction and brake can carry [1]; 0 without any."""
        return abs(self.along) / self.most if self.most > 0.0 else 0.0

    def __str__(self) -> str:
        said = f"slide {self.slide!r} rests at {self.at:.5g} m of rope {self.on!r}"
        said += f", {prefixed(self.force, 'N', 4)} across it"
        if self.hangs_off:
            said += f", {prefixed(self.off, 'm', 3)} off it"
        if self.is_rounded:
            longer = prefixed(self.rounded, "m", 2)
            said += f"; its bend there is spread over segments, so that it is pulled as if {longer} longer"
        if self.uneven:
            said += "; " + self._bump
        if self.most == 0.0:
            return said
        carried, most = prefixed(abs(self.along), "N", 4), prefixed(self.most, "N", 4)
        return f"{said}; friction and brake carry {carried} of at most {most}"

    @property
    def _bump(self) -> str:
        before, after, apart = (
            prefixed(pull, "N", 4) for pull in (self.before, self.after, self.uneven)
        )
        return (
            f"the rope has {before} and {after} beside it, {apart} more apart than on a line without "
            "segments: they make bumps there, and it rests in one, so that forces on anchors may be as much "
            "off and its place by some segments, on finer lines as well"
        )

    def as_dict(self) -> dict[str, Any]:
        """Plain values, with the share."""
        return vars(self) | {"use": self.use, "uneven": self.uneven}


class _Presses(NamedTuple):
    """What c contacts do to one of both strands."""

    segments: Ints  # (c,) of the arrays
    at: Floats  # (c,) where on them, from their first node [1]
    push: Floats  # (c, 3) [N]
    rub: Floats  # (c, 3) [N]
    friction: float  # coefficient [1]

    def share_of(self, node: int) -> Floats:
        """Return what a node bears of each, (c,) [1]."""
        at_end = (self.segments == node - 1) * self.at
        found: Floats = at_end + (self.segments == node) * (1.0 - self.at)
        return found


def touches(model: Model, memory: Any, x: Floats, tension: Floats) -> tuple[Touch, ...]:
    """Return where ropes touch each other at places (3, n) [m], with what `State.memory` carries there."""
    if model.scene.contact is None:
        return ()
    contact = memory.contact
    count = int(contact.tally[CONTACTS])
    rows = np.flatnonzero(contact.grip[:count, PUSH] > 0.0)
    pair, grip = contact.pair[rows], contact.grip[rows]
    table, found = model.system.node.contact, []
    friction = table.friction[table.rope[pair[:, 0]], table.rope[pair[:, 1]]]
    push, normal = grip[:, PUSH], grip[:, NORMAL : NORMAL + 3]
    rub = grip[:, SPRING : SPRING + 3]
    size = np.linalg.norm(rub, axis=1)
    for here in _clusters(pair, table.rope[pair]):
        mu = float(friction[here[0]])
        use = float((size[here] / (mu * push[here])).max()) if mu > 0.0 else 0.0
        pressed = push[here, None] * normal[here]
        one = _Presses(pair[here, 0], grip[here, OWN], pressed, rub[here], mu)
        other = _Presses(pair[here, 1], grip[here, OTHER], -pressed, rub[here], mu)
        strand, beside = (_strand(model, x, tension, side) for side in (one, other))
        found.append(Touch(strand, beside, float(push[here].sum()), len(here), use, mu))
    return tuple(found)


def _clusters(pair: Ints, rope: Ints) -> Iterator[Ints]:
    """Yield the rows of pairs of segments, (c, 2), that are beside each other on both ropes, (c, 2)."""
    left = list(range(len(pair)))
    while left:
        found, fresh = [], [left.pop(0)]
        while fresh:
            row = fresh.pop()
            found.append(row)
            beside = [
                k
                for k in left
                if np.abs(pair[k] - pair[row]).max() <= 2 and (rope[k] == rope[row]).all()
            ]
            left = [k for k in left if k not in beside]
            fresh += beside
        yield np.array(sorted(found))


def _strand(model: Model, x: Floats, tension: Floats, presses: _Presses) -> Strand:
    """Describe a strand that is pressed so."""
    first, last, mu = int(presses.segments.min()), int(presses.segments.max()), presses.friction
    rope: Span = model.layout.span(model.layout.rope_of(first)[0])
    inner = rope.first < first and last < rope.last - 1
    before = float(tension[first - 1]) if first > rope.first else 0.0
    after = float(tension[last + 1]) if last < rope.last - 1 else 0.0
    angle, holds = _turn(model, x, tension, presses)
    least, most = before * math.exp(-holds), before * math.exp(holds)
    held = np.isin(model.state.anchor_node[model.state.held == 1], np.arange(first, last + 2)).any()
    fits = (1.0 - _ROUNDING) * least <= after <= (1.0 + _ROUNDING) * most
    if mu == 0.0 or not inner or before == 0.0 or held or not fits:
        least = most = math.nan
    start = rope.first
    return Strand(rope.name, first - start, last - start, angle, before, after, least, most)


def _turn(model: Model, x: Floats, tension: Floats, presses: _Presses) -> tuple[float, float]:
    """Return by how much a strand turns towards what presses on it [rad], and ln(T2/T1) that holds.

    Where friction carries S across the rope of the mu N that it can, sqrt((mu N)^2 - S^2) is left along it:
    the sum of sqrt(mu^2 - (S/N)^2) times the angle, as of a wrap (`statics.wraps`); what presses, N, and S
    grow with the tension alike. Of the angle at a node that counts which N makes, N = 2 T sin(angle / 2): not
    what the rope's own weight, or another one on it, turns it by.
    """
    square = np.cross(presses.push, np.diff(x)[:, presses.segments].T)
    across = (presses.rub * square).sum(axis=1) / np.linalg.norm(square, axis=1)
    push = np.linalg.norm(presses.push, axis=1)
    angle = holds = 0.0
    for node in range(int(presses.segments.min()), int(presses.segments.max()) + 2):
        share = presses.share_of(node)
        force = share @ presses.push
        size = float(np.linalg.norm(force))
        if size > 0.0:
            turn = float(turn_towards(x, node, *(force / size), model.state.stiffness))
            pull = float(tension[max(node - 1, 0) : node + 1].mean())
            made = 2.0 * math.asin(min(0.5 * size / pull, 1.0)) if pull > 0.0 else 0.0
            used = float(share @ across / (share @ push))
            angle += turn
            holds += min(turn, made) * math.sqrt(max(presses.friction**2 - used**2, 0.0))
    return angle, holds


def seats(model: Model, memory: Any, x: Floats, tension: Floats) -> tuple[Seat, ...]:
    """Return where what slides is at places (3, n) [m], with what `State.memory` carries there."""
    table, found = model.system.node.slide, []
    for row in range(len(model.scene.slides)):
        look(x, table, memory.slide, row)
    for row, slide in enumerate(model.scene.slides):
        sight = memory.slide.sight[row]
        before, after, weighs = _beside(model, tension, row, memory.slide.sight[:, AT])
        found.append(
            Seat(
                slide=slide.name,
                on=slide.on,
                at=float(sight[AT] * table.length[row]),
                force=float(table.stiffness[row] * sight[APART]),
                along=float(memory.slide.grip[row, HELD]),
                most=float(bound_there(table, memory.slide.sight, row)),
                off=float(sight[APART]),
                segment=float(table.length[row]),
                rounded=_rounded(table, x, row),
                spare=_spare(x[:, int(table.first[row]) : int(table.last[row]) + 1]),
                before=before,
                after=after,
                weighs=weighs,
            )
        )
    return tuple(found)


def _beside(model: Model, tension: Floats, row: int, at: Floats) -> tuple[float, float, float]:
    """Return tensions beside the three nodes that bear a slide, and their weight and forces on them [N].

    NaN beside what has a tension of its own. `at`: where slides are on their ropes (slides,) [segments].
    """
    table = model.system.node.slide
    first, last = int(table.first[row]), int(table.last[row])
    middle = first + math.floor(float(at[row]) + 0.5)
    a, b = middle - 2, middle + 1  # segments
    others = {*model.layout.tied_nodes, *model.layout.anchor_nodes} & set(range(a + 1, b + 1))
    riders = [k for k in np.flatnonzero(table.first == first) if k != row]
    crowded = any(a - 0.5 <= first + float(at[k]) <= b + 1.5 for k in riders)
    if a < first or b >= last or others or crowded:
        return math.nan, math.nan, math.nan
    pull, own = float(np.linalg.norm(model.scene.gravity)), slice(a + 1, b + 1)
    given = float(np.linalg.norm(model.state.forces.applied[:, own], axis=0).sum())
    return float(tension[a]), float(tension[b]), pull * float(model.state.mass[own].sum()) + given


def _rounded(table: Any, x: Floats, row: int) -> float:
    """Return what segments take of the bend at a slide, nodes at `x` (3, n) [m], see `Seat`."""
    first, last = int(table.first[row]), int(table.last[row])
    line = x[:, first : last + 1]
    ways, middles = np.diff(line, axis=1), 0.5 * (line[:, 1:] + line[:, :-1])
    here = int(np.argmin(np.linalg.norm(middles - x[:, table.node[row], None], axis=0)))
    a, b = ways[:, max(here - 2, 0)], ways[:, min(here + 2, last - first - 1)]
    turn = math.atan2(float(np.linalg.norm(np.cross(a, b))), float(a @ b))
    return 0.125 * float(table.length[row]) * turn**2


def _spare(line: Floats) -> float:
    """Return by how much a rope of nodes at (3, n) [m] is longer than its ends are apart [m]."""
    length = np.linalg.norm(np.diff(line, axis=1), axis=0).sum()
    return float(length - np.linalg.norm(line[:, -1] - line[:, 0]))
