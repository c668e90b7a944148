"""Winches: they pay out or reel in rope at one end."""

from __future__ import annotations

from typing import Literal

from pydantic import Field, model_validator

from ropewalk.scene.base import (
    NAME,
    Model,
    Number,
    Text,
    not_negative,
    positive,
    quantity,
    refuse,
    stop_time,
)
from ropewalk.scene.faults import Fault
from ropewalk.scene.motions import interval_faults


class Winch(Model):
    """Changes the unstretched length of a rope at one anchored end, at a given speed.

    In a Scene every winch has its name and its rope's name filled in.
    """

    name: Text = Field(
        default="", pattern=NAME, max_length=60, description='Name; default "winch0", "winch1" ..'
    )
    rope: Text = Field(
        default="", min_length=1, description="Name of the rope; may be left out with one rope"
    )
    end: Literal["start", "end"] = Field(description="The end at which the winch stands")
    speed: Number = quantity("Rope per second: positive pays out, negative reels in", "m/s")
    start: Number = not_negative("Time at which it begins to turn", "s", default=0.0)
    stop: Number = stop_time()
    min_length: Number | None = positive(
        "Unstretched length at which reeling in ends", "m", default=None
    )
    max_length: Number | None = positive(
        "Unstretched length at which paying out ends", "m", default=None
    )

    on_drum: Number | None = quantity(
        "Rope that waits on the drum; default: what speed pays out during the run",
        "m",
        default=None,
        ge=0,
    )

    @model_validator(mode="after")
    def _check(self) -> Winch:
        faults = interval_faults(self.start, self.stop)
        low, high = self.min_length, self.max_length
        if low is not None and high is not None and low >= high:
            faults.append(Fault("min_length", low, f"must be less than max_length ({high:g})"))
        refuse(faults)
        return self

    def __str__(self) -> str:
        way = "pays out" if self.speed >= 0 else "reels in"
        rope = f" of {self.rope!r}" if self.rope else ""
        name = f" {self.name!r}" if self.name else ""
        return f"Winch{name} at the {self.end}{rope} {way} {abs(self.speed):g} m/s."

    __repr__ = __str__
