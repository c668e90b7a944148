"""Anchors: what holds or moves a node, and the rope's direction there."""

from __future__ import annotations

from pydantic import Field, model_validator

from ropewalk.scene.base import (
    NAME,
    Flag,
    Model,
    Number,
    Text,
    Vector,
    Whole,
    node_number,
    not_negative,
    quantity,
    refuse,
    stop_time,
    vector,
)
from ropewalk.scene.faults import NO_DIRECTION, Fault
from ropewalk.scene.motions import (
    Fixed,
    Hand,
    Motion,
    Orbit,
    Shake,
    Table,
    Velocity,
    axis_faults,
    interval_faults,
)


class Clamp(Model):
    """Holds the rope's direction at an anchored node, fixed or turned; needs bending stiffness.

    It turns about an axis at ``turn_rate`` from ``start`` to ``stop``, right-handed.
    """

    direction: Vector = vector(
        "Direction of the rope at time zero, from its start towards its end (any length but zero)",
        "1",
    )
    turn_axis: Vector = vector(
        "Axis about which it turns (any length but zero)", "1", default=(0, 0, 1)
    )
    turn_rate: Number = quantity("Angle per time", "rad/s", default=0.0)
    start: Number = not_negative("Time at which it begins to turn", "s", default=0.0)
    stop: Number = stop_time()

    @model_validator(mode="after")
    def _check(self) -> Clamp:
        faults = interval_faults(self.start, self.stop)
        if not any(self.direction):
            faults.append(Fault("direction", self.direction, NO_DIRECTION))
        faults += [Fault("turn_axis", f.value, f.rule) for f in axis_faults(self.turn_axis)]
        refuse(faults)
        return self


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
    node: Whole = node_number()
    motion: Motion = Field(default=Fixed(), description="How the node is moved")
    clamp: Clamp | None = Field(
        default=None, description="Holds the rope's direction, too; free to turn without it"
    )
    release_time: Number | None = quantity(
        "Time at which it lets go of the node", "s", default=None, ge=0
    )
    above_ground: Flag = Field(
        default=False, description="Whether the ground stops the anchor's way down"
    )

    def __str__(self) -> str:
        name = f" {self.name!r}" if self.name else ""
        rope = f" of {self.rope!r}" if self.rope else ""
        end = "" if self.release_time is None else f" until {self.release_time:g} s"
        clamped = ", clamped" if self.clamp is not None else ""
        return f"Anchor{name} holds node {self.node}{rope}{end}, {_way(self.motion)}{clamped}."

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
