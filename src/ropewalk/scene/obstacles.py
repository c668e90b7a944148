"""Obstacles: bodies that a rope touches, with Coulomb friction."""

from __future__ import annotations

import math
from typing import Annotated, Any, Literal

from pydantic import AliasChoices, Field, field_validator, model_validator

from ropewalk.scene.base import (
    Flag,
    Number,
    Vector,
    positive,
    refuse,
    vector,
)
from ropewalk.scene.faults import Fault
from ropewalk.scene.mesh import Mesh, Sdf
from ropewalk.scene.motions import (
    axis_faults,
)
from ropewalk.scene.solid import Body
from ropewalk.scene.spin import Tumbling, Turning


def _between(description: str, toml: str, python: str) -> Any:
    """A point, `toml` in a file and `python` in Python, where the other is a keyword."""
    return Field(
        description=description,
        validation_alias=AliasChoices(toml, python),
        serialization_alias=toml,
        json_schema_extra={"unit": "m"},
    )


class Plane(Turning):
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


class Sphere(Turning):
    """A ball. It spins about ``axis`` through its centre."""

    kind: Literal["sphere"] = "sphere"
    center: Vector = vector("Its centre", "m")
    radius: Number = positive("Its radius", "m")
    axis: Vector = vector("Axis of its spin (any length but zero)", "1", default=(0, 0, 1))

    @model_validator(mode="after")
    def _check(self) -> Sphere:
        refuse(axis_faults(self.axis))
        return self


class _Between(Body):
    """What lies along a line from one point to another."""

    start: Vector = _between("A point of its axis, one end", "from", "start")
    end: Vector = _between("The other end of its axis", "to", "end")
    radius: Number = positive("Its radius", "m")

    @model_validator(mode="after")
    def _check_ends(self) -> _Between:
        if self.start == self.end:
            rule = "must not be the point from which it goes: give its other end"
            refuse([Fault("to", self.end, rule)])
        return self


class Cylinder(_Between, Turning):
    """A round bar with flat ends, or ``endless``. It spins about its axis, from ``from`` to ``to``."""

    kind: Literal["cylinder"] = "cylinder"
    endless: Flag = Field(default=False, description="Whether it goes on beyond both ends")


class Capsule(_Between, Turning):
    """A round bar with round ends. It spins about its axis, from ``from`` to ``to``."""

    kind: Literal["capsule"] = "capsule"


class HalfPipe(_Between, Turning):
    """A trough to lie in: half a pipe with upright walls above it, endless, and all else solid.

    It turns about its axis, from ``from`` to ``to``.
    """

    kind: Literal["half-pipe"] = "half-pipe"
    open_to: Vector = vector(
        "Direction to which it is open (any length but zero)", "1", default=(0, 0, 1)
    )

    @model_validator(mode="after")
    def _check(self) -> HalfPipe:
        refuse(Fault("open_to", f.value, f.rule) for f in axis_faults(self.open_to))
        along = [b - a for a, b in zip(self.start, self.end, strict=True)]
        scale = math.hypot(*along) * math.hypot(*self.open_to)
        inner = sum(a * b for a, b in zip(along, self.open_to, strict=True))
        if not abs(inner) < 0.999 * scale:
            rule = "must not lie along its axis: give a direction across it"
            refuse([Fault("open_to", self.open_to, rule)])
        return self


class Box(Tumbling):
    """A box with rounded edges, along the axes of the scene or turned about its centre.

    It turns about ``axis`` through its centre.
    """

    kind: Literal["box"] = "box"
    center: Vector = vector("Its centre", "m")
    half_sizes: Vector = vector("From its centre to its faces", "m")
    edge_radius: Number = positive("Radius of its edges", "m")
    rotation: Vector = vector(
        "How it is turned: along the axis, as long as the angle", "rad", default=(0, 0, 0)
    )

    @field_validator("half_sizes")
    @classmethod
    def _check_sizes(cls, value: tuple[float, ...]) -> tuple[float, ...]:
        if not min(value) > 0.0:
            refuse([Fault("", value, "must all three be greater than 0")])
        return value

    @model_validator(mode="after")
    def _check(self) -> Box:
        if self.edge_radius > (least := min(self.half_sizes)):
            rule = f"must be at most the least of half_sizes ({least:g} m)"
            refuse([Fault("edge_radius", self.edge_radius, rule)])
        return self


class Torus(Turning):
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


Obstacle = Annotated[
    Plane | Sphere | Cylinder | Capsule | Box | Torus | HalfPipe | Mesh | Sdf,
    Field(discriminator="kind"),
]


def is_free(body: Obstacle) -> bool:
    """Tell whether a body turns freely, as a pulley."""
    return body.spin is not None and body.spin.free


def has_mass(body: Obstacle) -> bool:
    """Tell whether a body turns freely with a mass, which swings about its pivot."""
    return body.spin is not None and body.spin.mass is not None


def name_of(body: Obstacle, row: int) -> str:
    """Return the name of an obstacle, or what stands for it where it has none."""
    return body.name or f"obstacle{row}"


def what_is_thin(body: Obstacle) -> str:
    """Return what `thinnest` measures of a body."""
    match body.kind:
        case "cylinder" if thinnest(body) < body.radius:
            return "half length"
        case "box" | "mesh" | "sdf":
            return "edges' radius"
        case "torus":
            return "bar's radius"
    return "radius"


def thinnest(body: Obstacle) -> float:
    """Return the least radius, or half length, of a body [m]: inf for a plane, 0 for sharp edges."""
    match body.kind:
        case "cylinder" if not body.endless:
            return min(body.radius, 0.5 * math.dist(body.start, body.end))
        case "plane":
            return math.inf
        case "box":
            return body.edge_radius
        case "torus":
            return body.bar_radius
        case "mesh" | "sdf":
            return body.rounding
    return body.radius
