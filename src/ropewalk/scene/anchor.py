"""Anchors: what holds or moves a node."""

from __future__ import annotations

from pydantic import Field

from ropewalk.scene.base import Flag, Model, Number, Text, Whole, quantity
from ropewalk.scene.motions import Fixed, Hand, Motion, Orbit, Shake, Table, Velocity
from ropewalk.scene.rope import NAME, NODE


class Anchor(Model):
    """Holds one node of a rope, fixed or moved, for ever or until it lets go.

    In a Scene every anchor has its name and its rope's name filled in.
    """

    name: Text = Field(
        default="", pattern=NAME, max_length=60, description='Name; default "anchor0", "anchor1" ..'
    )
    rope: Text = Field(
        default="", min_length=1, description="Name of the rope; may be left out with one rope"
    )
    node: Whole = NODE
    motion: Motion = Field(default=Fixed(), description="How the node is moved")
    release_time: Number | None = quantity("Time at which it lets go of the node", "s", None, ge=0)
    above_ground: Flag = Field(
        default=False, description="Whether the ground stops the anchor's way down"
    )

    def __str__(self) -> str:
        name = f" {self.name!r}" if self.name else ""
        rope = f" of {self.rope!r}" if self.rope else ""
        end = "" if self.release_time is None else f" until {self.release_time:g} s"
        return f"Anchor{name} holds node {self.node}{rope}{end}, {_way(self.motion)}."

    __repr__ = __str__


def _way(motion: Motion) -> str:
    """How a motion goes on in a sentence."""
    match motion:
        case Velocity():
            x, y, z = motion.velocity
            until = f"from {motion.start:g} to {motion.stop:g} s"
            return f"moved at ({x:g}, {y:g}, {z:g}) m/s {until}"
        case Table():
            last = f"{motion.times[0]:g} to {motion.times[-1]:g} s"
            return f"moved along a table of {len(motion.times)} places from {last}"
        case Shake():
            return f"shaken by {motion.amplitude:g} m at {motion.frequency:g} Hz"
        case Orbit():
            return f"circling at {motion.frequency:g} Hz"
        case Hand():
            return "moved by hand"
    return "fixed"
