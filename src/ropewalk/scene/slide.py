"""Slides: nodes that run along other ropes."""

from __future__ import annotations

from collections.abc import Iterator, Sequence

from pydantic import Field

from ropewalk.scene.base import NAME, Model, Number, Text, Whole, not_negative, positive
from ropewalk.scene.faults import MISSING, Fault
from ropewalk.scene.rope import Rope, node_range
from ropewalk.scene.rubbing import coefficient
from ropewalk.scene.winch import Winch
from ropewalk.words.nearest import nearest

_FEWEST = 2  # segments of a rope that something slides along


class Slide(Model):
    """Lets a node of a rope run along another rope, as a trolley or a ring does; it stops at the rope's ends.

    In a Scene every slide has its name and the rope it runs on filled in.
    """

    name: Text = Field(
        default="", pattern=NAME, max_length=60, description='Name; default "slide0", "slide1" ..'
    )
    rope: Text = Field(min_length=1, description="Name of the rope whose node slides")
    node: Whole = Field(
        default=0,
        description="That node, counted from 0 at the rope's start; negative counts back from its end",
        json_schema_extra={"unit": "1"},
    )
    on: Text = Field(
        default="",
        min_length=1,
        description="Name of the rope that it runs along; default the first one",
    )
    at: Number | None = not_negative(
        "Where it starts, unstretched rope from that rope's start; the node's rope is moved there as a "
        "whole; by default the place nearest to where the node is drawn",
        "m",
        default=None,
    )
    friction: Number = coefficient(
        "Force along the rope over that across it, Coulomb's: what resists the rolling", default=0.0
    )
    brake: Number = not_negative("Constant force that brakes it, and holds it", "N", default=0.0)
    brake_from: Number = not_negative(
        "Place from which it brakes, unstretched rope from that rope's start; in full after one segment",
        "m",
        default=0.0,
    )
    compliance: Number | None = positive(
        "How far it comes off the rope's middle per force; by default 0.5 % of a segment under the weight "
        "that hangs on it, more where that is more than about a percent of the line's EA, "
        "less where contacts of both ropes are stiffer",
        "m/N",
        default=None,
    )

    def __str__(self) -> str:
        name = f" {self.name!r}" if self.name else ""
        on = f" {self.on!r}" if self.on else " the first rope"
        return f"Slide{name}: node {self.node} of {self.rope!r} runs along{on}."

    __repr__ = __str__


def slide_faults(
    slides: Sequence[Slide | None],
    every: Sequence[Rope | None],
    winches: Sequence[Winch | None],
) -> list[Fault]:
    """The faults of a scene in which nodes slide along ropes; of none while a rope is faulty in itself."""
    ropes = [rope for rope in every if rope is not None]
    if not ropes or len(ropes) < len(every):
        return []
    found = list[Fault]()
    names, seen = [rope.name for rope in ropes], dict[tuple[str, int], int]()
    titles = dict[str, int]()
    for i, slide in enumerate(slides):
        if slide is None:
            continue
        name = slide.name or f"slide{i}"
        if titles.setdefault(name, i) != i:
            rule = f"is the name of slide[{titles[name]}] already: give it another"
            found.append(Fault(f"slide[{i}].name", name, rule))
        on = slide.on or names[0]
        unknown = [
            Fault(f"slide[{i}].{key}", value, _no_rope(value, names))
            for key, value in (("rope", slide.rope), ("on", on))
            if value not in names
        ]
        if unknown:
            found += unknown
            continue
        rope, line = ropes[names.index(slide.rope)], ropes[names.index(on)]
        found += [*_one(i, slide, rope, line), *_wound(i, slide, rope, winches)]
        point = slide.rope, slide.node % rope.nodes
        if seen.setdefault(point, i) != i:
            rule = f"slides already, by slide[{seen[point]}]: leave out one of the two"
            found.append(Fault(f"slide[{i}].node", slide.node, rule))
    return found


def _no_rope(name: str, names: Sequence[str]) -> str:
    return f"is no rope; {nearest(name, names)}"


def _one(i: int, slide: Slide, rope: Rope, line: Rope) -> Iterator[Fault]:
    """The faults of one slide, of a node of `rope` along `line`."""
    path = f"slide[{i}]"
    if not -rope.nodes <= slide.node < rope.nodes:
        yield Fault(f"{path}.node", slide.node, node_range(rope))
    if rope.name == line.name:
        rule = "is the rope of the node itself: give the name of another rope"
        yield Fault(f"{path}.on", line.name, rule)
    if line.segments < _FEWEST:
        rule = f"has one segment; give the rope that something slides along {_FEWEST} or more"
        yield Fault(f"{path}.on", line.name, rule)
    for key, value in (("at", slide.at), ("brake_from", slide.brake_from)):
        if value is not None and value > line.length_unstretched:
            rule = f"must be on rope {line.name!r}, which is {line.length_unstretched:g} m long"
            yield Fault(f"{path}.{key}", value, rule)
    if slide.brake_from > 0.0 and slide.brake == 0.0:
        rule = "is needed with brake_from: give the brake's force, or leave out brake_from"
        yield Fault(f"{path}.brake", MISSING, rule)


def _wound(i: int, slide: Slide, rope: Rope, winches: Sequence[Winch | None]) -> Iterator[Fault]:
    """The fault of a slide whose node could come on to a drum."""
    ends = {winch.end for winch in winches if winch is not None and winch.rope == rope.name}
    node = slide.node % rope.nodes
    if ends and (len(ends) == 2 or node != (rope.nodes - 1 if "start" in ends else 0)):
        rule = "could come on to the drum of its rope: let the end slide that has no winch"
        yield Fault(f"slide[{i}].node", slide.node, rule)
