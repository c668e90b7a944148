"""How an anchor moves the node it holds."""

from __future__ import annotations

from collections.abc import Sequence
from itertools import pairwise
from typing import Annotated, Any, Literal

from pydantic import Field, ValidationInfo, model_validator

from ropewalk.scene.base import (
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
from ropewalk.scene.faults import MISSING, NO_DIRECTION, NO_VALUE, Fault
from ropewalk.scene.limits import HUGE


class Fixed(Model):
    """The node stays where it is at time zero."""

    kind: Literal["fixed"] = "fixed"


class Velocity(Model):
    """The node moves at a constant velocity from ``start`` to ``stop`` and rests otherwise."""

    kind: Literal["velocity"] = "velocity"
    velocity: Vector = vector("Velocity while it moves", "m/s")
    start: Number = not_negative("Time at which it begins to move", "s", default=0.0)
    stop: Number = stop_time()

    @model_validator(mode="after")
    def _check(self) -> Velocity:
        refuse(interval_faults(self.start, self.stop))
        return self


class Table(Model):
    """The node follows a table of times and places (scene coordinates), held at both ends.

    A CSV file with columns time, x, y, z is read at once; the scene no longer needs it.
    """

    kind: Literal["table"] = "table"
    file: Text | None = Field(
        default=None, description="CSV file with columns time, x, y, z (read at load)"
    )
    times: Many[Annotated[Number, Field(ge=-HUGE, le=HUGE, allow_inf_nan=False)]] = Field(
        default=(), description="Rising times, two or more", json_schema_extra={"unit": "s"}
    )
    positions: Many[Vector] = Field(
        default=(), description="The node's place at each time", json_schema_extra={"unit": "m"}
    )
    interpolation: Literal["linear", "cubic"] = Field(
        default="linear", description="Between the times: straight lines or a cubic spline"
    )

    @model_validator(mode="before")
    @classmethod
    def _read(cls, data: Any, info: ValidationInfo) -> Any:
        from ropewalk.scene.csv_columns import folder_of, read_columns

        if not isinstance(data, dict) or not isinstance(data.get("file"), str):
            return data
        if "times" in data or "positions" in data:
            refuse([Fault("file", NO_VALUE, "give either file or times and positions")])
        columns = read_columns(
            folder_of(info), data["file"], {"time": "s"} | dict.fromkeys("xyz", "m"), rising=True
        )
        rest = {key: value for key, value in data.items() if key != "file"}
        places = list(zip(*columns[1:], strict=True))
        return rest | {"times": columns[0], "positions": places}

    @model_validator(mode="after")
    def _check(self) -> Table:
        if not self.times or not self.positions:
            absent = "positions" if self.times else "times"
            if absent in self.model_fields_set:
                refuse([Fault(absent, [], "is empty: give times and positions, or file")])
            refuse([Fault(absent, MISSING, "give times and positions, or file")])
        faults = time_faults(self.times)
        if len(self.times) != len(self.positions):
            rule = f"must have {_places(len(self.times))}, one for each time"
            faults.append(Fault("positions", _places(len(self.positions)), rule))
        refuse(faults)
        return self


class Shake(Model):
    """The node swings along an axis as a sine of time, from its initial place x0 on: it is at x0 +
    amplitude (sin(2 pi frequency t + phase) - sin(phase)) along the axis.
    """

    kind: Literal["shake"] = "shake"
    axis: Vector = vector("Direction of the swing (any length but zero)", "1")
    amplitude: Number = positive("Half the width of the swing", "m")
    frequency: Number = positive("Swings per second", "Hz")
    phase: Number = quantity("Phase of the sine at time zero", "rad", default=0.0)

    @model_validator(mode="after")
    def _check(self) -> Shake:
        refuse(axis_faults(self.axis))
        return self


class Orbit(Model):
    """The node goes round an axis on the circle through its initial place.

    The axis is the line through ``center`` (scene coordinates) along ``axis``; the turn is
    right-handed about it, left-handed with a negative frequency.
    """

    kind: Literal["orbit"] = "orbit"
    center: Vector = vector("A point on the axis of the circle", "m")
    axis: Vector = vector("Direction of the axis (any length but zero)", "1")
    frequency: Number = quantity("Turns per second", "Hz")

    @model_validator(mode="after")
    def _check(self) -> Orbit:
        faults = axis_faults(self.axis)
        if abs(self.frequency) < 1e-12:
            rule = "must not be zero: leave out the motion of what rests"
            faults.append(Fault("frequency", self.frequency, rule))
        refuse(faults)
        return self


class Hand(Model):
    """The node is moved live, by setting the anchor's velocity; it rests until then."""

    kind: Literal["hand"] = "hand"


def _places(number: int) -> str:
    return f"{number} place" + ("" if number == 1 else "s")


def time_faults(times: Sequence[float]) -> list[Fault]:
    """Faults of times that are fewer than two, or do not rise."""
    short = [] if len(times) > 1 else [Fault("times", times, "must have at least 2 times")]
    return short + [
        Fault(f"times[{i + 1}]", b, f"must be later than the time before it ({a})")
        for i, (a, b) in enumerate(pairwise(times))
        if not b > a
    ]


def interval_faults(start: float, stop: float) -> list[Fault]:
    """A fault when an interval of time does not end after it begins."""
    if stop > start:
        return []
    return [Fault("stop", stop, f"must be later than start ({start})")]


def axis_faults(axis: Vector) -> list[Fault]:
    """A fault when a direction has no length."""
    return [] if any(axis) else [Fault("axis", axis, NO_DIRECTION)]


Told = Fixed | Velocity | Table | Shake | Orbit  # obstacles have these, too
Motion = Annotated[Told | Hand, Field(discriminator="kind")]
