"""How a scene is run: duration, frames, steps, method."""

from __future__ import annotations

from typing import Annotated, Any, Literal

from pydantic import BeforeValidator, Field, model_validator

from ropewalk.methods.names import Method
from ropewalk.scene.base import Flag, Model, Number, in_python, not_negative, positive, refuse
from ropewalk.scene.faults import NO_VALUE, Fault
from ropewalk.scene.limits import HUGE, TINY
from ropewalk.scene.ring import Ring
from ropewalk.scene.units import WrongUnit

#: Most frames one run may record.
MOST_FRAMES = 1e9


def _time_step(value: Any) -> Any:
    """Refuse what is neither a positive number nor "auto", before the union is tried."""
    if value == "auto" and isinstance(value, str):
        return value
    if isinstance(value, WrongUnit):
        refuse([Fault("", value.given, value.rule)])
    value = in_python(value)
    number = isinstance(value, (int, float)) and not isinstance(value, bool)
    if not number or not TINY <= value <= HUGE:
        refuse([Fault("", value, f'must be a number of seconds from {TINY} on, or "auto"')])
    return float(value)


TimeStep = Annotated[float | Literal["auto"], BeforeValidator(_time_step)]


class RunSettings(Model):
    """Duration, recording rate, time step and method of a run."""

    duration: Number = positive("Simulated time", "s", default=10.0)
    frame_rate: Number = positive("Recorded frames per simulated second", "1/s", default=60.0)
    time_step: TimeStep = Field(
        default="auto",
        description='Largest time step, or "auto": a fraction of the predicted stability bound; with '
        "adaptive 0.1 s",
        json_schema_extra={"unit": "s"},
    )
    auto_fraction: Number = positive(
        'Fraction of the bound with time_step = "auto"', "1", default=0.8
    )
    steps: Literal["divide", "exact", "nehe"] = Field(
        default="divide",
        description="divide: ceil(frame / time_step) equal steps a frame; exact: the time step "
        "as given, a frame every round(frame / time_step) steps; "
        "nehe: int(frame / time_step) + 1 equal steps a frame",
    )
    method: Method = Field(
        default="auto",
        description='Time integration method; "auto" takes the cheapest that is stable and accurate '
        'enough, and says why. Default: "auto" for materials, "semi-implicit-euler" for springs alone',
    )
    tolerance: Annotated[Number, Field(ge=1e-9)] = positive(
        "Largest estimated error of any node's place in a step of adaptive; auto aims at 100 times it",
        "m",
        default=1e-5,
    )
    spectral_radius: Annotated[Number, Field(le=1.0)] = not_negative(
        "What generalized-alpha leaves of the fastest modes in a step, 0 to 1", "1", default=0.8
    )
    start: Literal["shape", "at-rest"] = Field(
        default="shape",
        description="shape: as the ropes' shapes say; at-rest: from the equilibrium, with no velocity "
        "but kicks and ring (anchors move from there)",
    )
    extremes: Flag = Field(
        default=True,
        description="Whether every step is looked at for greatest and least values; without it tables "
        "know those of the recorded frames alone",
    )
    ring: Ring | None = Field(default=None, description='Mode to ring in; needs start = "at-rest"')

    @property
    def frame_interval(self) -> float:
        """Wanted time between two frames [s]."""
        return 1.0 / self.frame_rate

    @model_validator(mode="after")
    def _check(self) -> RunSettings:
        frames = self.duration * self.frame_rate
        if frames > MOST_FRAMES:
            rule = f"makes {frames:.3g} frames at {self.frame_rate:g} 1/s; at most 1e9 are possible"
            refuse([Fault("duration", self.duration, rule)])
        if self.ring is not None and self.start != "at-rest":
            refuse(
                [Fault("ring", NO_VALUE, 'needs start = "at-rest": modes are about the rest shape')]
            )
        return self
