"""How obstacles turn: at a rate, by a table of angles, or freely, as a pulley."""

from __future__ import annotations

from typing import Annotated, Literal

from pydantic import Field, model_validator

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
from ropewalk.scene.faults import MISSING, Fault
from ropewalk.scene.limits import HUGE
from ropewalk.scene.motions import Table, axis_faults, interval_faults, time_faults
from ropewalk.scene.solid import Body


class Spin(Model):
    """Turns an obstacle about its axis, right-handed: at one ``rate``, by a table of ``angles``, or
    ``free``, as ropes turn it.

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
    mass: Number | None = positive(
        "Mass of one that is free, whose weight turns it, too", "kg", default=None
    )
    center_of_mass: Vector | None = vector(
        "Its centre of mass where it starts; default its middle, of a mesh its position",
        "m",
        default=None,
    )
    pivot: Vector | None = vector(
        "A point of the axis about which it turns, where it starts; default its middle",
        "m",
        default=None,
    )
    axis: Vector | None = vector(
        "Direction of that axis (any length but zero); default the body's own", "1", default=None
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
        if self.axis is not None:
            refuse(axis_faults(self.axis))
        if self.free:
            refuse(_wheel_faults(self))
            return self
        if over := given & {"inertia", "bearing", "viscous", "mass", "center_of_mass"}:
            rule = "is for an obstacle that turns freely: give free = true, too, or leave it out"
            refuse([Fault(min(over), getattr(self, min(over)), rule)])
        by_table = given & {"times", "angles", "interpolation"}
        if self.rate is None and not by_table:
            refuse([Fault("rate", MISSING, "give rate, or times and angles, or free = true")])
        if self.rate is not None and by_table:
            rule = "give either rate or times and angles, not both"
            refuse([Fault(min(by_table), getattr(self, min(by_table)), rule)])
        if by_table and (over := given & {"start", "stop"}):
            rule = "a table of angles has times of its own: leave it out"
            refuse([Fault(min(over), getattr(self, min(over)), rule)])
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
            "an obstacle that turns freely needs its moment of inertia about its axis [kg m^2]: that of a "
            "round disc of mass m and radius R is m R^2 / 2, of a box of sides a and b m (a^2 + b^2) / 12, "
            "and m d^2 more where the axis is d from the middle; of one so light that it does not matter, "
            "give a tenth of the rope's mass on it times R^2"
        )
        faults.append(Fault("inertia", MISSING, rule))
    if over := spin.model_fields_set & {"start", "stop", "times", "angles", "interpolation"}:
        rule = (
            "is for an obstacle that is turned, and one that is free is not: leave it out, or free"
        )
        faults.append(Fault(min(over), getattr(spin, min(over)), rule))
    if spin.center_of_mass is not None and spin.mass is None:
        faults.append(Fault("mass", MISSING, "give the mass whose centre center_of_mass is"))
    return faults


class Turning(Body):
    """What may turn about its own axis, or about the pivot and axis of its spin."""

    spin: Spin | None = Field(
        default=None, description="How it turns about its axis; at rest without it"
    )

    @model_validator(mode="after")
    def _check_spin(self) -> Turning:
        from ropewalk.scene.pivots import pivot_faults

        if self.spin is not None:
            refuse(pivot_faults(self, self.spin))
        return self


class Tumbling(Turning):
    """What may turn about an axis that is given."""

    axis: Vector = vector(
        "Axis of its spin, through its centre or position (any length but zero)",
        "1",
        default=(0, 0, 1),
    )

    @model_validator(mode="after")
    def _check_axis(self) -> Tumbling:
        refuse(axis_faults(self.axis))
        return self
