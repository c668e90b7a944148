"""Where ropes at rest lie on obstacles, what friction carries there, and what it could."""

from __future__ import annotations

import itertools
import math
from dataclasses import dataclass
from typing import Any

import numpy as np

from ropewalk.core.arrays import Floats, Ints
from ropewalk.laws.obstacle import Obstacles
from ropewalk.laws.obstacle_shapes import CYLINDER
from ropewalk.lowering import Model, Span
from ropewalk.lowering.coarse_turns import FINE, CoarseTurn, coarse_turn
from ropewalk.lowering.touching import PRESSED, SLIPS, Contacts, contacts_at, stretches
from ropewalk.statics.grooves import as_of_one, beside
from ropewalk.statics.held_pulls import allowed, share_of
from ropewalk.statics.sideways_turn import turn_about
from ropewalk.statics.standing import standing_obstacles
from ropewalk.words.prefixes import prefixed

MANY = (
    "with friction there are many shapes of rest; this is the one to which the drawn shape creeps, without "
    "speed. How a rope comes there decides what it carries, within what friction holds"
)
_ROUNDING = 1e-6  # of a tension [1]
_NOTHING = 0.05  # [%] of what friction can carry that is not told
_WIDER = 1.02  # [1] a factor that is told
_LEVEL = 1e-3  # [rad] a rope that turns by less lies straight


@dataclass(frozen=True)
class Wrap:
    """One stretch of a rope on one obstacle."""

    rope: str
    obstacle: str
    first: int  # node of the rope
    last: int
    force: float  # sum of the normal forces [N]
    angle: float  # by which the rope turns there towards the obstacle [rad]
    before: float  # tension of the segment before the first node [N]; 0 at the rope's end
    after: float  # ... after the last node
    # Least and largest tension that friction holds after it with the one before as it is [N], or before it
    # where the rope ends there; inf where it jams, NaN where nothing pulls or something else holds it.
    least: float
    most: float
    backward: bool  # whether they are of the tension before
    # Largest |R_t| / (mu R_n) of its contacts [1]; 1: at the limit; 0 without friction. Nodes on several
    # bodies count as on one, see `grooves`, here and in all that is told of friction.
    use: float
    friction: float  # coefficient of both [1]
    taken: float = (
        0.0  # sum of |R_t| over that of mu R_n [1]: the ends of what lies may slip by themselves
    )
    # How much of what friction has along the rope it takes [1], NaN where the interval is: without weight
    # ln(ratio) / ln(ratio at slip), as pages tell of runs; of a tail that lies, its pull over the most.
    share: float = math.nan
    coarse: CoarseTurn = FINE  # how far the ratio of tensions errs
    beside: tuple[str, ...] = ()  # other obstacles on which some of its nodes lie
    # By what the interval may widen at both ends as the rope slips sideways, to where friction is not needed
    # across it any more: exp(mu angle) over the ratio at slip of this shape [1], the angle that to which it
    # may grow; without its own weight. 1 in a groove, where a rope does not slip sideways.
    wider: float = 1.0
    beyond: bool = False  # whether that angle is not known, so that it may be wider yet
    # Sum of the normal forces of ropes on its nodes [N]. Where they press noticeably it depends on their
    # friction, too, what is held: neither the interval nor the share is known.
    ropes: float = 0.0
    slope: float = math.nan  # of the obstacle under its steepest node, 0 on top of it [rad]

    @property
    def nodes(self) -> int:
        """How many nodes it has."""
        return self.last - self.first + 1

    @property
    def is_level(self) -> bool:
        """Whether it lies straight on what is level there."""
        return self.slope < _LEVEL and self.angle < _LEVEL

    @property
    def where(self) -> str:
        """Which nodes lie, in words."""
        if self.nodes == 1:
            return f"node {self.first} lies"
        return f"nodes {self.first} to {self.last} lie"

    @property
    def words(self) -> str:
        """Where it lies, without the rope's name."""
        one = self.nodes == 1
        said = f"{self.where} on {self.obstacle!r}"
        if self.angle > _LEVEL:
            said += f" and turn{'s' if one else ''} by {math.degrees(self.angle):.4g} degrees"
        if self.is_pressed or not math.isnan(self.most):
            said += (
                f", {prefixed(self.before, 'N', 4)} before and {prefixed(self.after, 'N', 4)} after"
            )
        if self.friction == 0.0:
            return said
        if math.isnan(self.most):
            return said + self._pressed + self._taken
        end = "before" if self.backward else "after"
        most = "any tension" if math.isinf(self.most) else prefixed(self.most, "N", 4)
        also = f" with that of {self._others}" if self.beside else ""
        said += f"; friction{also} holds {prefixed(self.least, 'N', 4)} to {most} {end}"
        return said + (self._sideways if self.wider > _WIDER else "")

    @property
    def _sideways(self) -> str:
        """How the interval changes where the rope slips across itself, in words."""
        most = self.wider * self.most
        to = "any tension" if math.isinf(most) else prefixed(most, "N", 3)
        return (
            " in this shape, in which it is held across, too; where it slips sideways before it slips along, "
            f"that may widen towards {prefixed(self.least / self.wider, 'N', 3)} to {to}"
            + (" or beyond" if self.beyond else "")
        )

    @property
    def is_pressed(self) -> bool:
        """Whether ropes press on it noticeably, beside what it presses itself."""
        return self.ropes > PRESSED * self.force

    @property
    def _pressed(self) -> str:
        """What ropes press on it, in words; "" where they do not."""
        if not self.is_pressed:
            return ""
        return f"; ropes press on it there with {prefixed(self.ropes, 'N', 4)}, and their friction holds, too"

    @property
    def _others(self) -> str:
        """The other obstacles on which it lies, in words."""
        return " and ".join(map(repr, self.beside))

    @property
    def _taken(self) -> str:
        """How much of what friction can carry it carries, in words; "" where that is nothing."""
        if 100.0 * self.use < _NOTHING:
            return ""
        one, said = f"{100.0 * self.use:.3g} %", "; "
        if self.beside:  # not what wedges it across, which does not hold it along
            said += f"along {self.obstacle!r} and {self._others} "
        if self.nodes == 1:
            return f"{said}its contact takes {one} of what friction can carry"
        said += f"its contacts take {100.0 * self.taken:.3g} % of what friction can carry together"
        return f"{said}, single ones up to {one}"

    def __str__(self) -> str:
        return f"rope {self.rope!r}: {self.words}"

    def as_dict(self) -> dict[str, Any]:
        """Plain values."""
        return vars(self) | {"coarse": self.coarse._asdict()}


def coarse_words(lie: tuple[Wrap, ...]) -> list[str]:
    """Return a sentence for every stretch that turns with friction on so few nodes that tensions err."""
    return [
        f"rope {wrap.rope!r}: {wrap.where} on {wrap.obstacle!r} and turn{'s' if wrap.nodes == 1 else ''} by "
        f"{math.degrees(wrap.angle):.3g} degrees on so few nodes that the ratio of tensions which friction "
        f"holds there may err {wrap.coarse.most}, as nodes happen to lie; {wrap.coarse.remedy}"
        for wrap in lie
        if wrap.coarse.is_told
    ]


def going_on_words(lie: tuple[Wrap, ...]) -> str:
    """Return why ropes that touch this at last did not come to rest."""
    if not lie:
        return (
            "there is no rest: the ropes fall past all obstacles. Hold a node with an anchor or, where they "
            "slid off one, give it more friction"
        )
    said = ("there is no rest: the ropes slide or fall on and on", sliding_words(lie))
    return ". ".join(filter(None, said))


def on_the_way_words(lie: tuple[Wrap, ...], way: float, *, patient: bool) -> str:
    """Return what is known of ropes that went so far [m], and were on their way yet when time was up.

    A look that was not `patient` took a seventh of the steps that settling takes.
    """
    found = f"no shape of rest was found: after {way:.3g} m the ropes still slide or fall"
    longer = "" if patient else "`ropewalk settle` looks longer"
    return ". ".join(filter(None, (found, longer, sliding_words(lie))))


def sliding_words(lie: tuple[Wrap, ...]) -> str:
    """Return where friction carries all it can, and what to change; "" where it nowhere does."""
    full = [wrap for wrap in lie if wrap.use >= SLIPS and wrap.friction > 0.0]
    smooth = sorted({repr(wrap.obstacle) for wrap in lie if wrap.friction == 0.0})
    said = []
    if full:
        said.append(f"On {_named(full)} friction carries all it can{_what_holds(full)}")
    if smooth:
        has = "has" if len(smooth) == 1 else "have"
        said.append(
            f"{', '.join(smooth)} {has} no friction, which could hold ropes along the surface"
        )
    if said:
        turns = ", more turns" if any(wrap.angle > _LEVEL for wrap in full) else ""
        said.append(f"Give {'more ' if full else ''}friction{turns}, or an anchor")
    return ". ".join(said)


def _named(full: list[Wrap]) -> str:
    """Return on what stretches lie, with the coefficients of friction."""
    own = {(wrap.obstacle, wrap.friction) for wrap in full}
    several = {name for name, _ in own if sum(other == name for other, _ in own) > 1}
    rubs = {
        f"{wrap.obstacle!r} ("
        + (f"rope {wrap.rope!r}, " if wrap.obstacle in several else "")
        + f"friction {wrap.friction:g})"
        for wrap in full
    }
    return ", ".join(sorted(rubs))


def _what_holds(full: list[Wrap]) -> str:
    """Return what friction holds there; "" in a groove, whose sides hold on steeper slopes than one plane."""
    if _shared(full):
        return ""
    steep = [wrap for wrap in full if not wrap.is_level]
    if not steep:
        return ": it is level there, and holds against up to friction times what presses on it"
    slope = min(math.degrees(math.atan(wrap.friction)) for wrap in steep)
    which = " with the least of them" if len({wrap.friction for wrap in steep}) > 1 else ""
    said = f": it holds on slopes of up to atan(friction) = {slope:.4g} degrees{which}"
    if all(wrap.angle < _LEVEL for wrap in steep):  # as on a ramp
        return said
    return f"{said}, and round a drum by a factor of up to exp(friction angle) of the tensions"


def _shared(lie: list[Wrap]) -> bool:
    """Tell whether some nodes lie on several bodies."""
    return any(
        one.rope == other.rope
        and one.obstacle != other.obstacle
        and max(one.first, other.first) <= min(one.last, other.last)
        for one, other in itertools.combinations(lie, 2)
    )


def wraps(
    model: Model,
    positions: Floats,
    tension: Floats,
    force: Floats,
    others: Floats,
    ropes: Floats,
) -> tuple[tuple[Wrap, ...], Contacts]:
    """Return where ropes lie on obstacles, rope by rope, and the contacts.

    Args:
        model: the scene.
        positions: (n, 3) [m].
        tension: (s,) [N].
        force: of all obstacles on the nodes [N], (3, n).
        others: of all else but the segments' tension [N], (3, n).
        ropes: normal forces of ropes on every node [N], (n,).
    """
    x, state = np.ascontiguousarray(positions.T), model.state
    table = model.system.node.obstacle
    if not len(table.kind):
        return (), contacts_at(table, x, np.zeros_like(x), np.zeros_like(x), state.stiffness)
    table = standing_obstacles(table, state.memory.obstacle)
    contacts = contacts_at(table, x, np.zeros_like(x), force, state.stiffness)
    of_one, found = as_of_one(contacts, force), []
    for rope in model.layout.ropes:
        for o in range(len(table.kind)):
            own = (contacts.node >= rope.start) & (contacts.node <= rope.end)
            runs = stretches(contacts, np.flatnonzero(own & (contacts.obstacle == o)))
            found += [
                _wrap(model, table, x, tension, others, ropes, contacts, of_one, rope, rows)
                for rows in runs
            ]
    return tuple(sorted(found, key=lambda wrap: (wrap.rope, wrap.first))), contacts


def _wrap(
    model: Model,
    table: Obstacles,
    x: Floats,
    tension: Floats,
    others: Floats,
    ropes: Floats,
    contacts: Contacts,
    of_one: Contacts,
    rope: Span,
    rows: Ints,
) -> Wrap:
    first, last = int(contacts.node[rows[0]]), int(contacts.node[rows[-1]])
    before = float(tension[first - 1]) if first > rope.start else 0.0
    after = float(tension[last]) if last < rope.end else 0.0
    held = np.isin(model.state.anchor_node[model.state.held == 1], np.arange(first, last + 1))
    least, most, back, share = math.nan, math.nan, False, math.nan
    push, pressed = float(contacts.push[rows].sum()), float(ropes[contacts.node[rows]].sum())
    if not held.any() and not pressed > PRESSED * push:
        least, most, back = allowed(x, tension, others, of_one, rows, rope)
    pull = before if back else after
    if not (1.0 - _ROUNDING) * least <= pull <= (1.0 + _ROUNDING) * most:
        least = most = math.nan  # not by this contact alone: another body, or a press
    else:
        share = share_of(pull, lambda s: allowed(x, tension, others, of_one.using(s), rows, rope))
    body, made = (
        model.scene.obstacles[int(contacts.obstacle[rows[0]])],
        model.scene.rope_named(rope.name),
    )
    friction = body.friction_with(made)
    wider, beyond = _wider(table, x, of_one, rows, friction, rope)
    return Wrap(
        rope=rope.name,
        obstacle=body.name,
        first=first - rope.start,
        last=last - rope.start,
        force=push,
        angle=float(contacts.turn[rows].sum()),
        before=before,
        after=after,
        least=least,
        most=most,
        backward=back,
        use=float(of_one.use[rows].max()),
        friction=friction,
        taken=_taken(of_one, rows),
        share=share,
        coarse=coarse_turn(table, contacts, rows, x, friction, made.segment_length),
        wider=wider,
        beyond=beyond,
        ropes=pressed,
        slope=math.acos(min(float((contacts.normal[rows] @ model.scene.up).min()), 1.0)),
        beside=tuple(model.scene.obstacles[o].name for o in beside(contacts, rows)),
    )


def _wider(
    table: Obstacles, x: Floats, contacts: Contacts, rows: Ints, friction: float, rope: Span
) -> tuple[float, bool]:
    """Return by what a stretch may hold more once it has slipped sideways, see `Wrap.wider`, and `beyond`.

    `contacts` are those of nodes in grooves as of one, see `as_of_one`: they need nothing across.
    """
    turn = float(np.maximum(contacts.turn[rows], 0.0).sum())
    first, last = int(contacts.node[rows[0]]), int(contacts.node[rows[-1]])
    grown = math.nan
    if not contacts.aside[rows].any():
        grown = turn
    elif table.kind[o := int(contacts.obstacle[rows[0]])] == CYLINDER:
        grown = turn_about(table.axis[o], x, max(first, rope.start + 1), min(last, rope.end - 1))
    most = float(np.fmax(turn, grown))
    return math.exp(friction * most) / contacts.at_slip(friction, rows), math.isnan(grown)


def _taken(contacts: Contacts, rows: Ints) -> float:
    """Return which share [1] of what friction can carry these contacts do together; 0 without any."""
    most = float((contacts.friction[rows] * contacts.push[rows]).sum())
    return float(np.linalg.norm(contacts.rub[rows], axis=1).sum()) / most if most > 0.0 else 0.0
