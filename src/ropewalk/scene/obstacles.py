"""Obstacles: bodies that a rope touches, with Coulomb friction."""

from __future__ import annotations

import math
from typing import Annotated, Any, Literal

from pydantic import AliasChoices, Field, model_validator

from ropewalk.scene.base import (
    HUGE,
    NAME,
    Flag,
    Many,
    Model,
    Number,
    Text,
    Vector,
    not_negative,
    positive,
    quantity,
    refuse,
    stop_time,
    vector,
)
from ropewalk.scene.faults import MISSING, NO_VALUE, Fault
from ropewalk.scene.motions import (
    Fixed,
    Table,
    Told,
    axis_faults,
    interval_faults,
    time_faults,
)

#: A coefficient of friction beyond this is a slip of the pen.
MOST_FRICTION = 100.0


def _between(description: str, toml: str, python: str) -> Any:
    """A point, `toml` in a file and `python` in Python, where the other is a keyword."""
    return Field(
        description=description,
        validation_alias=AliasChoices(toml, python),
        serialization_alias=toml,
        json_schema_extra={"unit": "m"},
    )


class Spin(Model):
    """Turns an obstacle about its own axis, right-handed: at one ``rate``, or by a table of ``angles``.

    At a rate it turns from ``start`` to ``stop``; by a table it stands before the first time and after the
    last one.
    """

    rate: Number | None = quantity("Angle per time", "rad/s", default=None)
    start: Number = not_negative("Time at which it begins to turn", "s", default=0.0)
    stop: Number = stop_time()
    times: Many[Annotated[Number, Field(ge=-HUGE, le=HUGE, allow_inf_nan=False)]] = Field(
        default=(), description="Rising times, two or more", json_schema_extra={"unit": "s"}
    )
    angles: Many[Annotated[Number, Field(ge=-HUGE, le=HUGE, allow_inf_nan=False)]] = Field(
        default=(), description="Angle at each time", json_schema_extra={"unit": "rad"}
    )
    interpolation: Literal["linear", "cubic"] = Field(
        default="linear", description="Between the times: straight lines or a cubic spline"
    )

    @model_validator(mode="after")
    def _check(self) -> Spin:
        given = self.model_fields_set
        by_table = given & {"times", "angles", "interpolation"}
        if self.rate is None and not by_table:
            refuse([Fault("rate", MISSING, "give rate, or times and angles")])
        if self.rate is not None and by_table:
            rule = "give either rate or times and angles"
            refuse([Fault(min(by_table), NO_VALUE, rule)])
        if by_table and (over := given & {"start", "stop"}):
            refuse([Fault(min(over), NO_VALUE, "a table of angles has times of its own")])
        if not by_table:
            refuse(interval_faults(self.start, self.stop))
            return self
        if not self.times or not self.angles:
            absent = "angles" if self.times else "times"
            refuse([Fault(absent, MISSING, "give times and angles")])
        faults = time_faults(self.times)
        if len(self.times) != len(self.angles):
            rule = f"must be {len(self.times)}, one for each time"
            faults.append(Fault("angles", f"{len(self.angles)} angles", rule))
        refuse(faults)
        return self

    def as_motion(self) -> Table:
        """The table of angles as a motion along x."""
        places = [(angle, 0.0, 0.0) for angle in self.angles]
        return Table(times=self.times, positions=places, interpolation=self.interpolation)


BodyMotion = Annotated[Told, Field(discriminator="kind")]


class _Body(Model):
    """What all obstacles have."""

    name: Text = Field(
        default="",
        pattern=NAME,
        max_length=60,
        description='Name; default "obstacle0", "obstacle1" ..',
    )
    friction: Number = quantity(
        "Coefficient of friction, Coulomb's", "1", default=0.3, ge=0, le=MOST_FRICTION
    )
    compliance: Number | None = positive(
        "How far a node is pressed in per force, across and along; by default as little as the rope's "
        "own inertia and stiffness allow",
        "m/N",
        default=None,
    )

    motion: BodyMotion = Field(
        default=Fixed(),
        description="How it moves, its middle (of a plane its point) as the node of an anchor; it keeps its "
        "direction",
    )


class _Turning(_Body):
    """What may turn: a body of revolution."""

    spin: Spin | None = Field(
        default=None, description="How it turns about its axis; at rest without it"
    )


class Plane(_Turning):
    """A half space: everything below the plane is solid. It spins about its normal, as a turntable."""

    kind: Literal["plane"] = "plane"
    point: Vector = vector("A point of the plane; it spins about this one", "m", default=(0, 0, 0))
    normal: Vector = vector(
        "Direction out of the solid (any length but zero)", "1", default=(0, 0, 1)
    )

    @model_validator(mode="after")
    def _check(self) -> Plane:
        refuse(Fault("normal", f.value, f.rule) for f in axis_faults(self.normal))
        return self


class Sphere(_Turning):
    """A ball. It spins about ``axis`` through its centre."""

    kind: Literal["sphere"] = "sphere"
    center: Vector = vector("Its centre", "m")
    radius: Number = positive("Its radius", "m")
    axis: Vector = vector("Axis of its spin (any length but zero)", "1", default=(0, 0, 1))

    @model_validator(mode="after")
    def _check(self) -> Sphere:
        refuse(axis_faults(self.axis))
        return self


class _Along(_Turning):
    """What lies along a line from one point to another."""

    start: Vector = _between("A point of its axis, one end", "from", "start")
    end: Vector = _between("The other end of its axis", "to", "end")
    radius: Number = positive("Its radius", "m")

    @model_validator(mode="after")
    def _check(self) -> _Along:
        if self.start == self.end:
            refuse([Fault("to", self.end, "must not be the point from which it goes")])
        return self


class Cylinder(_Along):
    """A round bar with flat ends, or ``endless``. It spins about its axis, from ``from`` to ``to``."""

    kind: Literal["cylinder"] = "cylinder"
    endless: Flag = Field(default=False, description="Whether it goes on beyond both ends")


class Capsule(_Along):
    """A round bar with round ends. It spins about its axis, from ``from`` to ``to``."""

    kind: Literal["capsule"] = "capsule"


class Box(_Body):
    """A box along the axes of the scene, with rounded edges."""

    kind: Literal["box"] = "box"
    center: Vector = vector("Its centre", "m")
    half_sizes: Vector = vector("From its centre to its faces", "m")
    edge_radius: Number = positive("Radius of its edges", "m")

    @model_validator(mode="after")
    def _check(self) -> Box:
        if not min(self.half_sizes) > 0.0:
            refuse([Fault("half_sizes", self.half_sizes, "must be greater than zero")])
        if self.edge_radius > (least := min(self.half_sizes)):
            rule = f"must be at most the least of half_sizes ({least:g} m)"
            refuse([Fault("edge_radius", self.edge_radius, rule)])
        return self


class Torus(_Turning):
    """A ring of round bar. It spins about its axis."""

    kind: Literal["torus"] = "torus"
    center: Vector = vector("Its centre", "m")
    axis: Vector = vector("Its axis (any length but zero)", "1", default=(0, 0, 1))
    radius: Number = positive("From its centre to the middle of the bar", "m")
    bar_radius: Number = positive("Radius of the bar", "m")

    @model_validator(mode="after")
    def _check(self) -> Torus:
        faults = axis_faults(self.axis)
        if self.bar_radius >= self.radius:
            rule = f"must be less than radius ({self.radius:g} m): there is no hole otherwise"
            faults.append(Fault("bar_radius", self.bar_radius, rule))
        refuse(faults)
        return self


Obstacle = Annotated[Plane | Sphere | Cylinder | Capsule | Box | Torus, Field(discriminator="kind")]


def thinnest(body: Obstacle) -> float:
    """Return the least radius of a body [m]; inf for a plane."""
    match body.kind:
        case "plane":
            return math.inf
        case "box":
            return body.edge_radius
        case "torus":
            return body.bar_radius
    return body.radius
