"""Joints: nodes of ropes that are tied to each other."""

from __future__ import annotations

from collections.abc import Sequence

from pydantic import Field

from ropewalk.scene.base import NAME, Many, Model, Text, Whole, node_number
from ropewalk.scene.rope import Rope
from ropewalk.scene.slide import Slide


class Tie(Model):
    """One of the nodes that a joint ties together."""

    rope: Text = Field(
        default="", min_length=1, description="Name of the rope; may be left out with one rope"
    )
    node: Whole = node_number()


class Joint(Model):
    """Ties nodes of ropes, or of one rope, to each other at one point; a rope turns freely there.

    The nodes lie at one place at the start. In a Scene every joint has its name and its ropes' names
    filled in.
    """

    name: Text = Field(
        default="", pattern=NAME, max_length=60, description='Name; default "joint0", "joint1" ..'
    )
    points: Many[Tie] = Field(min_length=2, description="The nodes it ties, two or more")

    def __str__(self) -> str:
        name = f" {self.name!r}" if self.name else ""
        nodes = [
            f"node {tie.node}" + (f" of {tie.rope!r}" if tie.rope else "") for tie in self.points
        ]
        return f"Joint{name} ties {', '.join(nodes[:-1])} and {nodes[-1]}."

    __repr__ = __str__


def tied_ropes(
    ropes: Sequence[Rope], joints: Sequence[Joint], slides: Sequence[Slide] = ()
) -> list[list[int]]:
    """Return the ropes that joints, and slides where given, tie to each other, by their numbers.

    A rope that none ties is alone.
    """
    number = {rope.name: i for i, rope in enumerate(ropes)}
    lead = list(range(len(number)))

    def first(i: int) -> int:
        while lead[i] != i:
            lead[i] = i = lead[lead[i]]
        return i

    tied = [{tie.rope for tie in joint.points} for joint in joints]
    for together in [*tied, *({slide.rope, slide.on} for slide in slides)]:
        ends = sorted({first(number[name]) for name in together})
        for end in ends[1:]:
            lead[end] = ends[0]
    found: dict[int, list[int]] = {}
    for i in range(len(lead)):
        found.setdefault(first(i), []).append(i)
    return list(found.values())
