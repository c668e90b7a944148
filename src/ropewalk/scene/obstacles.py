"""Obstacles: bodies that a rope touches, with Coulomb friction."""

from __future__ import annotations

import math
from typing import Annotated, Any, Literal

from pydantic import AliasChoices, Field, model_validator

from ropewalk.scene.base import (
    Flag,
    Many,
    Model,
    Number,
    Vector,
    not_negative,
    positive,
    quantity,
    refuse,
    stop_time,
    vector,
)
from ropewalk.scene.faults import MISSING, NO_VALUE, Fault
from ropewalk.scene.limits import HUGE
from ropewalk.scene.mesh import Mesh, Sdf
from ropewalk.scene.motions import (
    Table,
    axis_faults,
    interval_faults,
    time_faults,
)
from ropewalk.scene.solid import Body


def _between(description: str, toml: str, python: str) -> Any:
    """A point, `toml` in a file and `python` in Python, where the other is a keyword."""
    return Field(
        description=description,
        validation_alias=AliasChoices(toml, python),
        serialization_alias=toml,
        json_schema_extra={"unit": "m"},
    )


class Spin(Model):
    """Turns an obstacle about its own axis, right-handed: at one ``rate``, by a table of ``angles``, or
    ``free``, as the friction of ropes turns it.

    At a rate it turns from ``start`` to ``stop``; by a table it stands before the first time and after the
    last one. One that is free has an ``inertia`` and begins at ``rate``, at rest without it.
    """

    rate: Number | None = quantity("Angle per time", "rad/s", default=None)
    free: Flag = Field(default=False, description="Whether it turns freely, as a pulley")
    inertia: Number | None = positive(
        "Moment of inertia about its axis, of one that is free", "kg m^2", default=None
    )
    bearing: Number = not_negative(
        "Torque of the bearing's dry friction, of one that is free", "N m", default=0.0
    )
    viscous: Number = not_negative(
        "Torque of the bearing per rate, of one that is free", "N m s", default=0.0
    )
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
        if self.free:
            refuse(_wheel_faults(self))
            return self
        if over := given & {"inertia", "bearing", "viscous"}:
            rule = "is for an obstacle that turns freely: give free = true, too, or leave it out"
            refuse([Fault(min(over), getattr(self, min(over)), rule)])
        by_table = given & {"times", "angles", "interpolation"}
        if self.rate is None and not by_table:
            refuse([Fault("rate", MISSING, "give rate, or times and angles, or free = true")])
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


def _wheel_faults(spin: Spin) -> list[Fault]:
    """Return what is wrong with one that is free."""
    faults = []
    if spin.inertia is None:
        rule = (
            "an obstacle that turns freely needs its moment of inertia [kg m^2]: that of a round disc of "
            "mass m and radius R is m R^2 / 2; of one so light that it does not matter, give a tenth of the "
            "rope's mass on it times R^2"
        )
        faults.append(Fault("inertia", MISSING, rule))
    if over := spin.model_fields_set & {"start", "stop", "times", "angles", "interpolation"}:
        rule = "is for an obstacle that is turned: one that is free turns as ropes turn it"
        faults.append(Fault(min(over), NO_VALUE, rule))
    return faults


class _Turning(Body):
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


class _Between(Body):
    """What lies along a line from one point to another."""

    start: Vector = _between("A point of its axis, one end", "from", "start")
    end: Vector = _between("The other end of its axis", "to", "end")
    radius: Number = positive("Its radius", "m")

    @model_validator(mode="after")
    def _check_ends(self) -> _Between:
        if self.start == self.end:
            refuse([Fault("to", self.end, "must not be the point from which it goes")])
        return self


class Cylinder(_Between, _Turning):
    """A round bar with flat ends, or ``endless``. It spins about its axis, from ``from`` to ``to``."""

    kind: Literal["cylinder"] = "cylinder"
    endless: Flag = Field(default=False, description="Whether it goes on beyond both ends")


class Capsule(_Between, _Turning):
    """A round bar with round ends. It spins about its axis, from ``from`` to ``to``."""

    kind: Literal["capsule"] = "capsule"


class HalfPipe(_Between):
    """A trough to lie in: half a pipe with upright walls above it, endless, and all else solid."""

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
            refuse([Fault("open_to", self.open_to, "must not lie along its axis")])
        return self


class Box(Body):
    """A box with rounded edges, along the axes of the scene or turned about its centre."""

    kind: Literal["box"] = "box"
    center: Vector = vector("Its centre", "m")
    half_sizes: Vector = vector("From its centre to its faces", "m")
    edge_radius: Number = positive("Radius of its edges", "m")
    rotation: Vector = vector(
        "How it is turned: along the axis, as long as the angle", "rad", default=(0, 0, 0)
    )

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


Obstacle = Annotated[
    Plane | Sphere | Cylinder | Capsule | Box | Torus | HalfPipe | Mesh | Sdf,
    Field(discriminator="kind"),
]


def is_free(body: Obstacle) -> bool:
    """Tell whether a body turns freely, as a pulley."""
    spin: Spin | None = getattr(body, "spin", None)
    return spin is not None and spin.free


def name_of(body: Obstacle, row: int) -> str:
    """Return the name of an obstacle, or what stands for it where it has none."""
    return body.name or f"obstacle{row}"


def thinnest(body: Obstacle) -> float:
    """Return the least radius of a body [m]: inf for a plane, 0 for sharp edges."""
    match body.kind:
        case "plane":
            return math.inf
        case "box":
            return body.edge_radius
        case "torus":
            return body.bar_radius
        case "mesh" | "sdf":
            return body.rounding
    return body.radius
